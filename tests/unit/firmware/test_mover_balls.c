/* SPDX-License-Identifier: MIT
 *
 * The ball that holds a mover, against its corners in doubles: none is outside, and the ball is no larger than the box
 * around them asks for; whether corners are the object's or, where it deforms, anywhere. And which of two movers may be
 * drawn before the other, against ways from the eye: if one precedes, no point of the other lies on the way to any of
 * its own. Boxes and octahedra, turned anyhow, side by side and in each other. */
#include "core/core.h"
#include "golden/golden_stage.h"
#include "limner.h"
#include "movers/mover.h"
#include "rigs/cmocka_ready.h"
#include "rigs/moving_mem.h"
#include "rigs/plain_lines.h"
#include "rigs/random_camera.h"
#include "rigs/set_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOVERS_GLTF = 5, ROUNDS = 400, CORNERS_MAX = 64 };

/* A mover's corners, of whose box we know the middle and the halves, in its own units. */
struct extent {
    double corners[CORNERS_MAX][3], middle[3], half[3];
    size_t count;
};

static void measure(struct extent *extent)
{
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t k = 0; k < extent->count; k++) {
            low = fmin(low, extent->corners[k][i]);
            high = fmax(high, extent->corners[k][i]);
        }
        extent->middle[i] = (low + high) / 2;
        extent->half[i] = (high - low) / 2;
    }
}

static void set_corners(struct extent *extent, const struct lim_scene *object)
{
    extent->count = object->vertex_count < CORNERS_MAX ? object->vertex_count : CORNERS_MAX;
    for (size_t k = 0; k < extent->count; k++) {
        extent->corners[k][0] = object->vertices[k].x;
        extent->corners[k][1] = object->vertices[k].y;
        extent->corners[k][2] = object->vertices[k].z;
    }
    measure(extent);
}

/* Where a point of the object is in the static scene. */
static void place(const struct lim_instance *instance, const double v[3], double at[3])
{
    for (int i = 0; i < 3; i++) {
        at[i] = instance->at_q8[i] / 256.0;
        for (int j = 0; j < 3; j++)
            at[i] += ldexp(instance->axes_q30[3 * j + i], -30) * ldexp(v[j], -instance->finer_bits);
    }
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

static void check_ball(const struct lim_mover *mover, const struct lim_instance *instance, const struct extent *extent)
{
    const double unit = ldexp(1, -instance->finer_bits), radius = mover->radius_q12 / 4096.0;
    const double centre[3] = {mover->centre_q12[0] / 4096.0, mover->centre_q12[1] / 4096.0,
                              mover->centre_q12[2] / 4096.0};
    const double longest = fmax(extent->half[0], fmax(extent->half[1], extent->half[2]));
    const double others = extent->half[0] + extent->half[1] + extent->half[2] - longest;
    double middle[3], farthest = 0;

    place(instance, extent->middle, middle);
    assert_true(distance(centre, middle) <= 0.87 * unit + 0.001);
    for (size_t k = 0; k < extent->count; k++) {
        double at[3];
        place(instance, extent->corners[k], at);
        assert_true(distance(at, centre) <= radius);
        farthest = fmax(farthest, distance(at, centre));
    }
    /* A root is rounded up, by 2 at most, as is each way along an axis, to 14 bits. */
    assert_true(radius <= farthest * (1 + ldexp(2, -13)) + 5 * unit + 1.001);
    /* Halves are rounded up, by 3/2 at most; the ball by 1, and once more by a unit of the scene. */
    const double most = longest + 1.5 + (others + 3) * 107 / 256 + 1;
    assert_true(radius <= most * unit + 1.001);
}

/* Corners anywhere within a box that is anywhere. */
static void deform(struct lim_vertex *vertices, size_t count, struct random *random)
{
    int64_t low[3], high[3];

    for (int i = 0; i < 3; i++) {
        low[i] = random_in(random, -20000, 20000);
        high[i] = low[i] + random_in(random, 0, INT64_C(1) << random_in(random, 0, 13));
    }
    for (size_t k = 0; k < count; k++) {
        vertices[k].x = (int16_t)random_in(random, low[0], high[0]);
        vertices[k].y = (int16_t)random_in(random, low[1], high[1]);
        vertices[k].z = (int16_t)random_in(random, low[2], high[2]);
    }
}

static void turn_anyhow(struct lim_instance *instance, struct random *random)
{
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    lim_instance_turn(instance, yaw, pitch, roll);
    instance->finer_bits = (uint8_t)random_in(random, 0, 3);
    for (int i = 0; i < 3; i++)
        instance->at_q8[i] += (int32_t)random_in(random, -9000, 9000);
}

static void every_ball_holds_its_mover_closely(void **state)
{
    static struct golden_stage stage;
    static struct extent extent;
    struct lim_vertex vertices[CORNERS_MAX];
    struct random random = {401};
    struct simulator simulator;
    unsigned deformed = 0, whole = 0;
    struct error err;

    (void)state;
    assert_true(golden_open(&stage, MOVERS_GLTF));
    assert_true(golden_begin(&simulator, &stage, &core_fast, &golden_ways[0], 32, 24));
    const struct lim *lim = simulator.lim; /* as it is here: both are of profile fast */
    assert_int_equal(core_fast.lim_b, sizeof *lim);
    for (unsigned round = 0; round < ROUNDS; round++) {
        struct lim_instance *one = &stage.moving.instances[round % stage.moving.count];
        const struct lim_instance kept = *one;
        struct lim_scene copy = *one->object;
        struct lim_camera camera;
        if (copy.vertex_count > CORNERS_MAX) continue;
        if (!camera_path_to_camera(&stage.path, round % GOLDEN_FRAMES, &stage.lens, &stage.scene.grid, &camera, &err))
            fail_msg("%s", err.text);
        memcpy(vertices, copy.vertices, copy.vertex_count * sizeof *vertices);
        one->deforms = round & 1;
        if (one->deforms) deform(vertices, copy.vertex_count, &random);
        copy.vertices = vertices;
        one->object = &copy;
        turn_anyhow(one, &random);
        set_corners(&extent, &copy);
        assert_int_equal(simulator_draw(&simulator, &camera), LIM_OK);
        const struct lim_mover *mover = &lim->movers->movers[round % stage.moving.count];
        assert_true(mover->radius_q12 >= 0);
        check_ball(mover, one, &extent);
        deformed += one->deforms;
        whole += !one->deforms;
        *one = kept;
    }
    assert_true(deformed > ROUNDS / 4 && whole > ROUNDS / 4);
    simulator_free(&simulator);
    golden_close(&stage);
}

/* Pairs ----------------------------------------------------------------------------------------------------------- */

enum { PAIRS = 4000, SIDE_PX = 16, PAIR = 2, WAYS = 150, STEPS = 24 };

struct pair {
    struct set nothing, objects[PAIR];
    struct lim_box boxes[PAIR];
    bool pointed[PAIR]; /* an octahedron */
    struct lim_instance instances[PAIR];
    struct lim lim;
    struct plain_lines lines;
    uint16_t line[SIDE_PX];
    struct moving_mem mem;
};

static void pair_open(struct pair *pair)
{
    const struct lim_movers_limits limits = {PAIR, 1, 0, 0};

    memset(pair, 0, sizeof *pair);
    set_init(&pair->nothing);
    pair->lines.pixels = pair->line;
    for (int i = 0; i < PAIR; i++) {
        set_init(&pair->objects[i]);
        set_add(&pair->objects[i], 1, 3, (const int16_t[3][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        pair->objects[i].scene.boxes = &pair->boxes[i];
        pair->objects[i].scene.box_count = 1;
        pair->objects[i].leaf.box = 0;
        pair->instances[i].object = &pair->objects[i].scene;
    }
    const struct lim_target target = plain_lines_target(&pair->lines, SIDE_PX, SIDE_PX, LIM_NEAREST_FIRST);
    moving_mem_init(&pair->mem, &pair->lim, &pair->nothing.scene, &target, &limits);
}

static void pair_close(struct pair *pair)
{
    moving_mem_free(&pair->mem);
}

/* Long, flat, or as high as wide. */
static void shape(struct pair *pair, int i, struct random *random)
{
    struct set *object = &pair->objects[i];
    struct lim_box *box = &pair->boxes[i];
    const int64_t most = random_in(random, 20, 3000);

    pair->pointed[i] = random_in(random, 0, 1);
    for (int j = 0; j < 3; j++)
        box->half[j] = (uint16_t)(random_in(random, 0, 1) ? most : random_in(random, 10, most));
    for (int k = 0; k < 8; k++) {
        int32_t at[3];
        for (int j = 0; j < 3; j++) {
            const int side = k >> j & 1 ? 1 : -1;
            at[j] = pair->pointed[i] && k % 3 != j ? 0 : side * box->half[j];
        }
        object->vertices[3 + k] = (struct lim_vertex){(int16_t)at[0], (int16_t)at[1], (int16_t)at[2]};
    }
    object->scene.vertex_count = 11;
}

static void pair_place(struct pair *pair, struct lim_camera *camera, struct random *random)
{
    struct lim_movers *movers = pair->lim.movers;
    const int64_t apart_q8 = INT64_C(1) << random_in(random, 10, 21);

    for (int i = 0; i < PAIR; i++) {
        const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);
        shape(pair, i, random);
        lim_instance_turn(&pair->instances[i], yaw, pitch, roll);
        pair->instances[i].finer_bits = (uint8_t)random_in(random, 0, 2);
        for (int j = 0; j < 3; j++)
            pair->instances[i].at_q8[j] = (int32_t)random_in(random, -apart_q8, apart_q8);
    }
    for (int j = 0; j < 3; j++)
        camera->eye_q8[j] = (int32_t)random_in(random, -3 * apart_q8, 3 * apart_q8);
    movers->instances = pair->instances;
    movers->given = movers->count = PAIR;
    lim_movers_pose(movers, &pair->lim.pass, camera);
    for (int i = 0; i < PAIR; i++)
        assert_true(movers->movers[i].radius_q12 >= 0);
}

/* Of the object's own axes, from its middle, in halves of its box. */
static void own(const struct pair *pair, int i, const double at[3], double out[3])
{
    const struct lim_instance *instance = &pair->instances[i];

    for (int j = 0; j < 3; j++) {
        out[j] = 0;
        for (int k = 0; k < 3; k++)
            out[j] += (at[k] - instance->at_q8[k] / 256.0) * ldexp(instance->axes_q30[3 * j + k], -30);
        out[j] *= ldexp(1, instance->finer_bits) / pair->boxes[i].half[j];
    }
}

static double depth_in(const struct pair *pair, int i, const double at[3])
{
    double v[3];

    own(pair, i, at, v);
    return pair->pointed[i] ? fabs(v[0]) + fabs(v[1]) + fabs(v[2]) : fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* On its surface or within. */
static void any_point(const struct pair *pair, int i, struct random *random, double at[3])
{
    const struct lim_instance *instance = &pair->instances[i];
    double v[3], size = 0;

    for (int j = 0; j < 3; j++) {
        v[j] = 2 * random_unit(random) - 1;
        size = pair->pointed[i] ? size + fabs(v[j]) : fmax(size, fabs(v[j]));
    }
    for (int k = 0; k < 3; k++)
        at[k] = instance->at_q8[k] / 256.0;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            at[k] += v[j] / size * pair->boxes[i].half[j] * ldexp(instance->axes_q30[3 * j + k], -30) *
                     ldexp(1, -instance->finer_bits);
}

/* Whether the other one stands before any point of mover i that may be seen. */
static bool is_hidden(const struct pair *pair, int i, const struct lim_camera *camera, struct random *random)
{
    const double eye[3] = {camera->eye_q8[0] / 256.0, camera->eye_q8[1] / 256.0, camera->eye_q8[2] / 256.0};

    for (int way = 0; way < WAYS; way++) {
        double to[3], through[3], at[3];
        any_point(pair, i, random, to);
        any_point(pair, !i, random, through); /* where it is looked for: near the way past this point */
        double along = 0, square = 0;
        if (to[2] >= eye[2]) continue; /* out of view: the camera looks along -z */
        for (int k = 0; k < 3; k++) {
            along += (through[k] - eye[k]) * (to[k] - eye[k]);
            square += (to[k] - eye[k]) * (to[k] - eye[k]);
        }
        for (int step = 0; step < STEPS; step++) {
            const double t = step ? step / (double)STEPS : along / square;
            if (t <= 0 || t >= 1) continue;
            for (int k = 0; k < 3; k++)
                at[k] = eye[k] + t * (to[k] - eye[k]);
            if (depth_in(pair, !i, at) < 0.999) return true;
        }
    }
    return false;
}

static void whoever_precedes_is_not_hidden(void **state)
{
    static struct pair pair;
    struct lim_camera camera = set_camera(false);
    struct random random = {601};
    int found = 0, clear = 0;

    (void)state;
    pair_open(&pair);
    for (int round = 0; round < PAIRS; round++) {
        pair_place(&pair, &camera, &random);
        for (int i = 0; i < PAIR; i++) {
            const bool precedes = lim_mover_precedes(pair.lim.movers, (uint16_t)i, (uint16_t)!i);
            if (!is_hidden(&pair, i, &camera, &random)) {
                found += precedes;
                clear++;
            } else {
                assert_false(precedes);
            }
        }
    }
    pair_close(&pair);
    print_message("# %d found to be clear of %d that are\n", found, clear);
    assert_true(clear > PAIRS / 2 && found > clear / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_ball_holds_its_mover_closely),
                                       cmocka_unit_test(whoever_precedes_is_not_hidden)};

    return cmocka_run_group_tests_name("mover_balls", tests, NULL, NULL);
}
