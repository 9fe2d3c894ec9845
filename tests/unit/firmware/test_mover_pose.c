/* SPDX-License-Identifier: MIT
 *
 * An instance in its place, function by function, against doubles: its corners and planes in the static scene, how far
 * ahead it is, the camera as it sees it; and which instances are left out, at each bound and one beyond. */
#include "limner.h"
#include "math/orientation.h"
#include "movers/mover.h"
#include "rigs/cmocka_ready.h"
#include "rigs/moving_mem.h"
#include "rigs/plain_lines.h"
#include "rigs/random_camera.h"
#include "rigs/set_rig.h"
#include "scene/plane.h"
#include "view/plane_unpacked.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3000, SIDE_PX = 64, MOVERS = 2 };

/* A static scene and an object, a few triangles each, and what draws them. */
struct stage {
    struct set scene, object;
    struct lim_instance instance;
    struct lim lim;
    struct plain_lines lines;
    uint16_t line[SIDE_PX];
    struct moving_mem mem;
};

static void add_triangles(struct set *set, const int16_t at[3])
{
    static const int16_t shapes[3][3][3] = {{{0, 0, 0}, {900, 30, 0}, {20, 800, 100}},
                                            {{5, 5, 70}, {700, 70, 0}, {0, 600, 9}},
                                            {{9, 0, 9}, {400, 0, 0}, {0, 300, 0}}};

    set_init(set);
    for (int i = 0; i < 3; i++) {
        int16_t corners[3][3];
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++)
                corners[k][j] = (int16_t)(shapes[i][k][j] + at[j]);
        set_add(set, (lim_index)(i + 1), 3, (const int16_t(*)[3])corners);
    }
}

static const struct lim_movers_limits limits = {MOVERS, 1, 0, 0};

/* Movers their memory: how many corners they may have depends on the renderer's. */
static void stage_lend(struct stage *stage)
{
    assert_int_equal(
        lim_movers_init(&stage->lim, stage->mem.movers, lim_movers_mem_b(&stage->scene.scene, &limits), &limits),
        LIM_OK);
    stage->lim.movers->instances = &stage->instance;
}

static void stage_open(struct stage *stage, const int16_t at[3])
{
    static const int16_t origin[3] = {0, 0, -2000};

    memset(stage, 0, sizeof *stage);
    add_triangles(&stage->scene, origin);
    add_triangles(&stage->object, at);
    stage->lines.pixels = stage->line;
    const struct lim_target target = plain_lines_target(&stage->lines, SIDE_PX, SIDE_PX, LIM_NEAREST_FIRST);
    moving_mem_init(&stage->mem, &stage->lim, &stage->scene.scene, &target, &limits);
    stage->instance.object = &stage->object.scene;
    lim_instance_turn(&stage->instance, 0, 0, 0);
}

static void stage_close(struct stage *stage)
{
    moving_mem_free(&stage->mem);
}

/* What a frame does before it draws. Whether the instance is in it. */
static bool pose(struct stage *stage, const struct lim_camera *camera)
{
    struct lim_movers *movers = stage->lim.movers;

    movers->instances = &stage->instance;
    movers->given = movers->count = 1;
    stage->lim.pass.stats->movers.left_out = 77;
    lim_movers_pose(stage->lim.movers, &stage->lim.pass, camera);
    const bool is_in = movers->movers[0].radius_q12 >= 0;
    assert_int_equal(stage->lim.pass.stats->movers.left_out, !is_in);
    return is_in;
}

static bool draw(struct stage *stage, const struct lim_camera *camera)
{
    assert_int_equal(lim_movers_frame(&stage->lim, camera, &stage->instance, 1), LIM_OK);
    return pose(stage, camera);
}

static struct lim_camera any_camera(struct random *random)
{
    struct lim_camera camera = set_camera(false);

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)random_in(random, -(1 << 20), 1 << 20);
    camera.yaw = random_angle(random);
    camera.pitch = random_angle(random);
    camera.roll = random_angle(random);
    return camera;
}

static void place_anyhow(struct lim_instance *instance, struct random *random)
{
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    lim_instance_turn(instance, yaw, pitch, roll);
    instance->finer_bits = (uint8_t)random_in(random, 0, 3);
    for (int i = 0; i < 3; i++)
        instance->at_q8[i] = (int32_t)random_in(random, -(1 << 22), 1 << 22);
}

/* From the object's axes to the scene's. */
static void turn(const struct lim_instance *instance, const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = 0;
        for (int j = 0; j < 3; j++)
            out[i] += ldexp(instance->axes_q30[3 * j + i], -30) * v[j];
    }
}

/* And back: the axes are at right angles. */
static void turn_back(const struct lim_instance *instance, const double v[3], double out[3])
{
    for (int j = 0; j < 3; j++) {
        out[j] = 0;
        for (int i = 0; i < 3; i++)
            out[j] += ldexp(instance->axes_q30[3 * j + i], -30) * v[i];
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Corners and planes ------------------------------------------------------------------------- */

static void corners_are_rounded_to_nearest(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    struct random random = {601};

    (void)state;
    stage_open(&stage, at);
    stage.lim.movers->instances = &stage.instance;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_vertex *vertex = &stage.object.vertices[round % 9];
        int32_t at_q12[3];
        double place[3];
        place_anyhow(&stage.instance, &random);
        vertex->x = (int16_t)random_in(&random, -32768, 32767);
        vertex->y = (int16_t)random_in(&random, -32768, 32767);
        vertex->z = (int16_t)random_in(&random, -32768, 32767);
        const double v[3] = {vertex->x, vertex->y, vertex->z};
        lim_mover_forget_corners(stage.lim.movers);
        memcpy(at_q12, lim_mover_corner(stage.lim.movers, 0, (lim_index)(round % 9)), sizeof at_q12);
        turn(&stage.instance, v, place);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(at_q12[i] - stage.instance.at_q8[i] * 16.0 -
                             ldexp(place[i], 12 - stage.instance.finer_bits)) <= 0.5 + 1e-6);
    }
    stage_close(&stage);
}

static void check_turned(const struct stage *stage, const struct lim_plane_unpacked *before)
{
    const struct lim_instance *instance = &stage->instance;
    struct lim_plane_unpacked plane = *before;
    double own[3], turned[3], most = 0, rest = 0;
    int bits = 0;

    lim_mover_turn(stage->lim.movers, 0, &plane);
    for (int i = 0; i < 3; i++) {
        own[i] = before->n[i];
        most = fmax(most, fabs(own[i]));
    }
    while (ldexp(1, bits) <= most) /* the longest has 28 bits then */
        bits++;
    turn(instance, own, turned);
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(plane.n[i] - ldexp(turned[i], 28 - bits)) <= 0.5 + 1e-6);
        rest += plane.n[i] * (instance->at_q8[i] / 256.0);
    }
    const double d = ldexp((double)before->d, 28 - bits - instance->finer_bits) + rest;
    assert_true((double)plane.d <= d + 1e-3 && (double)plane.d > d - 3);
    assert_int_equal(plane.slack, llabs(plane.n[0]) + llabs(plane.n[1]) + llabs(plane.n[2]));
    assert_false(plane.narrow);
    assert_int_equal(plane.axis, LIM_NO_AXIS);
}

static void planes_are_turned_with_their_object(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    struct random random = {602};

    (void)state;
    stage_open(&stage, at);
    stage.lim.movers->instances = &stage.instance;
    for (int round = 0; round < ROUNDS; round++) {
        const int64_t reach = INT64_C(1) << random_in(&random, 0, 30);
        struct lim_plane_unpacked plane = {.slack = 9, .narrow = true, .axis = (uint8_t)(round % 4)};
        for (int i = 0; i < 3; i++)
            plane.n[i] = (int32_t)random_in(&random, -reach, reach);
        if (!plane.n[0] && !plane.n[1]) plane.n[2] = (int32_t)reach;
        plane.d = random_in(&random, -32767 * reach, 32767 * reach);
        place_anyhow(&stage.instance, &random);
        for (int i = 0; i < 3; i++)
            stage.instance.at_q8[i] &= ~255; /* so that doubles are exact */
        check_turned(&stage, &plane);
    }
    stage_close(&stage);
}

/* The camera --------------------------------------------------------------------------------- */

/* In Q30, right, down and ahead. */
static void axes_of(const struct lim_camera *camera, double axes[3][3])
{
    int32_t axes_q30[9];

    lim_orientation_set(axes_q30, camera);
    for (int i = 0; i < 9; i++)
        axes[i / 3][i % 3] = ldexp(axes_q30[i], -30);
}

static void check_camera(struct stage *stage, const struct lim_camera *camera, const double axes[3][3])
{
    const struct lim_mover *mover = &stage->lim.movers->movers[0];
    const struct lim_instance *instance = &stage->instance;
    const double away[3] = {(camera->eye_q8[0] - instance->at_q8[0]) / 256.0,
                            (camera->eye_q8[1] - instance->at_q8[1]) / 256.0,
                            (camera->eye_q8[2] - instance->at_q8[2]) / 256.0};
    const struct lim_row *row = lim_mover_view(stage->lim.movers, 0)->rows.row;
    double eye[3], ahead[3];

    turn_back(instance, away, eye);
    for (int i = 0; i < 3; i++)
        assert_true(fabs(mover->eye.at_q8[i] - ldexp(eye[i], 8 + instance->finer_bits)) <= 0.51);
    /* z's row is the way ahead, as the object has it, and takes its eye to 0. */
    turn_back(instance, axes[2], ahead);
    const double n[3] = {(double)row[2].n_qv[0], (double)row[2].n_qv[1], (double)row[2].n_qv[2]};
    const double length = sqrt(dot(n, n)),
                 own[3] = {mover->eye.at_q8[0] / 256.0, mover->eye.at_q8[1] / 256.0, mover->eye.at_q8[2] / 256.0};
    for (int i = 0; i < 3; i++)
        assert_true(fabs(n[i] / length - ahead[i]) < 3 / length);
    assert_true(fabs(dot(n, own) + (double)row[2].shift_qv) <= 4 * (fabs(own[0]) + fabs(own[1]) + fabs(own[2])) + 4);
    /* To the right and down as far as ahead, 45 degrees aside. */
    for (int axis = 0; axis < 2; axis++) {
        double aside[3];
        turn_back(instance, axes[axis], aside);
        for (int i = 0; i < 3; i++)
            assert_true(fabs((double)row[axis].n_qv[i] / length - aside[i]) < 3 / length);
    }
    /* Where the near plane is. */
    const double near_qv = ldexp(fmin(ldexp(camera->near_q8, instance->finer_bits), LIM_NEAR_MAX_Q8), -8) * length;
    if (near_qv > 1 << 18 && near_qv < 1 << 29)
        assert_true(fabs(mover->view.rows.near_qv - near_qv) < near_qv / 1000 + 4);
}

static void cameras_are_as_objects_see_them(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    struct random random = {603};
    int in = 0;

    (void)state;
    stage_open(&stage, at);
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_camera camera = any_camera(&random);
        double axes[3][3], to[3], own_to[3];
        camera.near_q8 = (int32_t)random_in(&random, 1, INT64_C(1) << random_in(&random, 0, 24));
        place_anyhow(&stage.instance, &random);
        for (int i = 0; i < 3; i++) {
            stage.lim.movers->light->to_q14[i] = (int16_t)random_in(&random, -9459, 9459);
            to[i] = stage.lim.movers->light->to_q14[i];
        }
        if (!(round ? pose(&stage, &camera) : draw(&stage, &camera))) continue;
        axes_of(&camera, axes);
        check_camera(&stage, &camera, (const double(*)[3])axes);
        turn_back(&stage.instance, to, own_to);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(stage.lim.movers->movers[0].to_q14[i] - own_to[i]) <= 0.501);
        in++;
    }
    assert_true(in > ROUNDS * 9 / 10);
    stage_close(&stage);
}

static void depths_are_how_far_ahead(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    struct random random = {604};

    (void)state;
    stage_open(&stage, at);
    for (int round = 0; round < ROUNDS; round++) {
        const struct lim_camera camera = any_camera(&random);
        double axes[3][3], away[3];
        int32_t at_q12[3];
        if (!(round ? pose(&stage, &camera) : draw(&stage, &camera))) continue;
        axes_of(&camera, axes);
        for (int i = 0; i < 3; i++) {
            at_q12[i] = (int32_t)random_in(&random, -(1 << 27), 1 << 27);
            away[i] = at_q12[i] / 4096.0 - camera.eye_q8[i] / 256.0;
        }
        /* The axes are cut to 28 bits: a 2^28th of the distances, together. */
        const double depth = dot(axes[2], away) * 512;
        const double off = (fabs(away[0]) + fabs(away[1]) + fabs(away[2])) * 512 / (1 << 28);
        const int32_t found = lim_mover_depth(stage.lim.movers, at_q12);
        assert_true(found >= depth - off - 1.001 && found <= depth + off + 0.001);
    }
    stage_close(&stage);
}

/* Which are left out ------------------------------------------------------------------------- */

static void objects_that_cannot_be_drawn_are_left_out(void **state)
{
    static const int16_t at[3] = {0, 0, -2000};
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    stage_open(&stage, at);
    struct lim_scene *object = &stage.object.scene;
    assert_true(draw(&stage, &camera));
    stage.instance.object = NULL;
    assert_false(pose(&stage, &camera));
    stage.instance.object = object;
    object->node_count = 0;
    assert_false(pose(&stage, &camera));
    object->node_count = 1;
    object->polygon_count = 0;
    assert_false(pose(&stage, &camera));
    object->polygon_count = 1;
    stage.instance.finer_bits = 4;
    assert_false(pose(&stage, &camera));
    stage.instance.finer_bits = 3;
    assert_true(pose(&stage, &camera));
    object->limits.depth = 2;
    assert_false(pose(&stage, &camera));
    object->limits.depth = 1;
    object->limits.vertices = LIM_MAX_VERTICES;
    assert_true(pose(&stage, &camera));
    object->limits.vertices = LIM_MAX_VERTICES + 1;
    assert_false(pose(&stage, &camera));
    object->limits.vertices = 4;
    stage.lim.nearest->retained.whole = LIM_RETAINED_HEAD_CELLS + 4 + 5; /* clipping adds one a plane */
    stage_lend(&stage);
    assert_true(pose(&stage, &camera));
    stage.lim.nearest->retained.whole--;
    stage_lend(&stage);
    assert_false(pose(&stage, &camera));
    stage.lim.nearest->retained.whole++;
    stage_lend(&stage);
    assert_true(pose(&stage, &camera));
    stage_close(&stage);
}

static void places_at_the_bounds_are_in(void **state)
{
    static const int16_t at[3] = {-20000, -20000, -20000};
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    stage_open(&stage, at);
    for (int i = 0; i < 3; i++) {
        stage.instance.at_q8[i] = (1 << 24) - 1;
        assert_true(pose(&stage, &camera));
        stage.instance.at_q8[i] = 1 << 24;
        assert_false(pose(&stage, &camera));
        stage.instance.at_q8[i] = 0;
    }
    stage_close(&stage);
}

/* The middle of all corners, wherever they are, and a radius that is not much more than the way to the farthest. */
static void balls_are_about_the_corners(void **state)
{
    static const int16_t places[][3] = {{-20000, 300, 12000}, {20000, -9000, 5}, {1, 2, -3000}};
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        stage_open(&stage, places[k]);
        assert_true(pose(&stage, &camera));
        const struct lim_mover *mover = stage.lim.movers->movers;
        const int32_t half[3] = {450, 400, 50}; /* what the triangles span: add_triangles() */
        for (int i = 0; i < 3; i++)
            assert_int_equal(mover->centre_q12[i], (places[k][i] + half[i]) * 4096);
        assert_true(mover->radius_q12 >= (int32_t)(sqrt(450 * 450 + 400 * 400 + 50 * 50) * 4096));
        assert_true(mover->radius_q12 <= (450 + 450 * 107 / 256 + 5) * 4096);
        stage_close(&stage);
    }
}

/* Around the box that an object knows, whatever its shape, if there are vertices at its corners: no less than half its
 * diagonal, and no more than the longest half and 107/256 of the others, rounded up to a unit of the object; and a unit
 * of the scene for the centre. Around vertices that do not reach there, no more than the farthest. */
static void balls_hold_boxes_of_any_shape(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    static struct lim_box box;
    static struct lim_vertex corners[8];
    const struct lim_camera camera = set_camera(false);
    struct random random = {606};

    (void)state;
    stage_open(&stage, at);
    stage.object.scene.boxes = &box;
    stage.object.scene.box_count = 1;
    stage.object.leaf.box = 0;
    stage.object.scene.vertices = corners;
    stage.object.scene.vertex_count = 8;
    for (int round = 0; round < ROUNDS; round++) {
        const uint16_t most = (uint16_t)(random_in(&random, 1, 1 << random_in(&random, 3, 15)) - 1);
        double squares = 0, sum = 0;
        for (int i = 0; i < 3; i++) { /* two of them often the longest and one 0, where the bound is tight */
            const int64_t kind = random_in(&random, 0, 5);
            box.half[i] = kind < 3 ? most : kind < 5 ? 0 : (uint16_t)random_in(&random, 0, most);
            squares += (double)box.half[i] * box.half[i];
            sum += box.half[i];
        }
        const double longest = fmax(box.half[0], fmax(box.half[1], box.half[2]));
        const int16_t part = (int16_t)random_in(&random, 0, 3); /* of the way to the corners, in quarters; 0: all */
        for (int k = 0; k < 8; k++) {
            const int16_t by = part ? part : 4;
            const int32_t x = box.half[0] * by / 4, y = box.half[1] * by / 4, z = box.half[2] * by / 4;
            corners[k] =
                (struct lim_vertex){(int16_t)(k & 1 ? x : -x), (int16_t)(k & 2 ? y : -y), (int16_t)(k & 4 ? z : -z)};
        }
        const double farthest = sqrt((double)corners[0].x * corners[0].x + (double)corners[0].y * corners[0].y +
                                     (double)corners[0].z * corners[0].z);
        place_anyhow(&stage.instance, &random);
        for (int i = 0; i < 3; i++)
            stage.instance.at_q8[i] /= 16; /* all is within the world */
        assert_true(pose(&stage, &camera));
        const double radius = stage.lim.movers->movers[0].radius_q12 / 4096.0;
        const double scale = ldexp(1, -stage.instance.finer_bits);
        if (!part) assert_true(radius >= sqrt(squares) * scale + 1 - 1.0 / 4096);
        assert_true(radius >= farthest * scale + 1 - 1.0 / 4096);
        assert_true(radius <= farthest * (1 + 4.0 / 16384) * scale + 6 * scale + 1);
        assert_true(radius <= (longest + (sum - longest) * 107 / 256 + 1) * scale + 1);
    }
    stage_close(&stage);
}

/* All of the ball is within 2^16 units. */
static void balls_end_within_the_world(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    stage_open(&stage, at);
    for (int i = 0; i < 6; i++) {
        struct lim_mover *mover = stage.lim.movers->movers;
        const int sign = i & 1 ? -1 : 1;
        int32_t *along_q8 = &stage.instance.at_q8[i / 2], low = 0, high = (1 << 24) - 1;
        while (high - low > 1) { /* the last place that is in */
            const int32_t middle = (low + high) / 2;
            *along_q8 = sign * middle;
            *(pose(&stage, &camera) ? &low : &high) = middle;
        }
        *along_q8 = sign * low;
        assert_true(pose(&stage, &camera));
        const int64_t end_q12 = (int64_t)labs((long)mover->centre_q12[i / 2]) + mover->radius_q12;
        assert_true(end_q12 < 1 << 28 && end_q12 + 16 >= 1 << 28);
        *along_q8 = 0;
    }
    stage_close(&stage);
}

/* Eyes within 2^20 of the object's units of it. */
static void eyes_at_the_bounds_are_near_enough(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;

    (void)state;
    stage_open(&stage, at);
    for (int i = 0; i < 6; i++) {
        struct lim_camera camera = set_camera(false);
        const int32_t end_q8 = i & 1 ? -(1 << 25) : 1 << 25;
        stage.instance.finer_bits = 3;
        camera.eye_q8[i / 2] = end_q8;
        assert_false(pose(&stage, &camera));
        camera.eye_q8[i / 2] = end_q8 - (end_q8 > 0 ? 1 : -1);
        assert_true(pose(&stage, &camera));
        camera.near_q8 = LIM_NEAR_MAX_Q8; /* farther than the object can tell */
        assert_true(pose(&stage, &camera));
    }
    stage_close(&stage);
}

/* Memory ------------------------------------------------------------------------------------- */

static void memory_is_taken_to_its_end(void **state)
{
    static const int16_t at[3] = {0, 0, 0};
    static struct stage stage;

    (void)state;
    for (uint16_t instances = 1; instances < 20; instances++) {
        const struct lim_movers_limits more = {instances, 1, 0, 0};
        stage_open(&stage, at);
        const size_t mem_b = lim_movers_mem_b(&stage.scene.scene, &more);
        uint8_t *mem = calloc(1, mem_b);
        assert_non_null(mem);
        assert_int_equal(lim_movers_init(&stage.lim, mem, mem_b - 1, &more), LIM_ERR_MEMORY);
        assert_int_equal(lim_movers_init(&stage.lim, mem, mem_b, &more), LIM_OK);
        memset(stage.lim.movers->movers, 1, instances * sizeof *stage.lim.movers->movers);
        memset(stage.lim.movers->cache, 2, LIM_VIEW_CACHE_ENTRIES * sizeof *stage.lim.movers->cache);
        memset(stage.lim.movers->stack, 3, sizeof *stage.lim.movers->stack);
        memset(stage.lim.movers->object_stack, 4, sizeof *stage.lim.movers->object_stack);
        memset(*stage.lim.movers->copies, 5, instances * sizeof **stage.lim.movers->copies);
        size_t counts[6] = {0};
        for (size_t k = 0; k < (size_t)((uint8_t *)(stage.lim.movers->object_stack + 1) - mem); k++)
            counts[mem[k]]++;
        assert_true((uint8_t *)(stage.lim.movers->object_stack + 1) <= mem + mem_b);
        assert_int_equal(counts[1], instances * sizeof *stage.lim.movers->movers);
        assert_int_equal(counts[2], LIM_VIEW_CACHE_ENTRIES * sizeof *stage.lim.movers->cache);
        assert_int_equal(counts[3], sizeof *stage.lim.movers->stack);
        assert_int_equal(counts[4], sizeof *stage.lim.movers->object_stack);
        assert_int_equal(counts[5], instances * sizeof **stage.lim.movers->copies);
        free(mem);
        stage_close(&stage);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_are_rounded_to_nearest),
        cmocka_unit_test(planes_are_turned_with_their_object),
        cmocka_unit_test(cameras_are_as_objects_see_them),
        cmocka_unit_test(depths_are_how_far_ahead),
        cmocka_unit_test(objects_that_cannot_be_drawn_are_left_out),
        cmocka_unit_test(places_at_the_bounds_are_in),
        cmocka_unit_test(balls_are_about_the_corners),
        cmocka_unit_test(balls_hold_boxes_of_any_shape),
        cmocka_unit_test(balls_end_within_the_world),
        cmocka_unit_test(eyes_at_the_bounds_are_near_enough),
        cmocka_unit_test(memory_is_taken_to_its_end),
    };

    return cmocka_run_group_tests_name("mover_pose", tests, NULL, NULL);
}
