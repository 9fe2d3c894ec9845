/* SPDX-License-Identifier: MIT
 *
 * Movers against a plane of the static tree, at the limits: polygons whose corners are just within what counts as on
 * the plane, or just not, and balls that just reach it. What the filters say is what the corners themselves do. */
#include "limner.h"

#include "eye.h"
#include "movers/mover.h"
#include "pieces/corners.h"
#include "rigs/cmocka_ready.h"
#include "rigs/plain_lines.h"
#include "rigs/random_camera.h"
#include "rigs/set_rig.h"
#include "routes/mover_list.h"
#include "routes/mover_part.h"
#include "routes/mover_route.h"
#include "routes/mover_split.h"
#include "routes/route.h"
#include "scene/plane.h"
#include "view/pass.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 8000, SIDE_PX = 16, MOVERS = 1, ENTRIES = 16, FRONT = 1, BACK = 2 };

/* A static scene of one plane, and an object. */
struct stage {
    struct set scene, object;
    struct lim_node node;
    struct lim_instance instance;
    struct lim_box box;
    struct lim lim;
    struct plain_lines lines;
    uint16_t line[SIDE_PX];
    void *mem, *mover_mem;
    int64_t n[3], d;
};

/* The polygon of the node, on either side. Boxes tell what it is in the way of: this one's holds the scene. */
static void set_wall(struct stage *stage, const struct lim_vertex corners[3])
{
    static const lim_index record[] = {3 | LIM_POLYGON_LAST, 0, 0, 1, 2};

    memcpy(stage->scene.polygons, record, sizeof record);
    memcpy(stage->scene.vertices, corners, 3 * sizeof *corners);
}

static void stage_open(struct stage *stage)
{
    static const int16_t triangle[3][3] = {{0, 0, 0}, {90, 0, 0}, {0, 90, 0}};
    const struct lim_movers_limits limits = {MOVERS, 1, ENTRIES, 0, 0};

    memset(stage, 0, sizeof *stage);
    set_init(&stage->scene);
    set_init(&stage->object);
    set_add(&stage->object, 1, 3, triangle);
    stage->object.scene.boxes = &stage->box;
    stage->object.scene.box_count = 1;
    stage->object.leaf.box = 0;
    stage->node = (struct lim_node){{0, 0}, LIM_NO_INDEX, LIM_NO_INDEX, 0, 0, LIM_NO_INDEX};
    set_wall(stage, (const struct lim_vertex[3]){{-32768, -32768, -32768}, {32767, 32767, 32767}, {0, 0, 0}});
    stage->scene.scene.nodes = &stage->node;
    stage->scene.scene.plane_count = stage->scene.scene.exact_count = 1;
    stage->lines.pixels = stage->line;
    const struct lim_target target = plain_lines_target(&stage->lines, SIDE_PX, SIDE_PX, LIM_NEAREST_FIRST);
    const size_t mem_b = lim_mem_b(&stage->scene.scene, &target);
    const size_t mover_mem_b = lim_movers_mem_b(&stage->scene.scene, &limits);
    stage->mem = malloc(mem_b);
    stage->mover_mem = malloc(mover_mem_b);
    assert_true(stage->mem && stage->mover_mem);
    assert_int_equal(lim_init(&stage->lim, &stage->scene.scene, &target, stage->mem, mem_b), LIM_OK);
    assert_int_equal(lim_movers_init(&stage->lim, stage->mover_mem, mover_mem_b, &limits), LIM_OK);
    stage->instance.object = &stage->object.scene;
    stage->lim.movers->instances = &stage->instance;
}

static void stage_close(struct stage *stage)
{
    free(stage->mem);
    free(stage->mover_mem);
}

static double length_of(const int64_t n[3])
{
    return sqrt((double)n[0] * (double)n[0] + (double)n[1] * (double)n[1] + (double)n[2] * (double)n[2]);
}

/* n . p = d, stored as what it fits. */
static void set_plane(struct stage *stage, const int64_t n[3], int64_t d)
{
    const int64_t sum = llabs(n[0]) + llabs(n[1]) + llabs(n[2]);

    memcpy(stage->n, n, sizeof stage->n);
    stage->d = d;
    if (sum <= PLANE_SUM_MAX && llabs(d) <= LIM_PLANE_D_MAX) {
        stage->scene.planes[0] = plane_record(n, d);
        return;
    }
    stage->scene.exact[0] =
        (struct lim_plane_exact){{(int32_t)n[0], (int32_t)n[1], (int32_t)n[2]}, (int32_t)(d >> 32), (uint32_t)d};
    stage->scene.planes[0] = plane_filter(n, d, 0);
}

/* Of any length, often with components that are equal. */
static void any_plane(struct stage *stage, struct random *random)
{
    int64_t n[3];

    const int64_t reach = INT64_C(1) << random_in(random, 0, 28);
    do {
        const int64_t common = random_in(random, 1, reach);
        for (int i = 0; i < 3; i++) {
            const int64_t kind = random_in(random, 0, 4);
            n[i] = kind < 2 ? common : kind == 2 ? -common : kind == 3 ? 0 : random_in(random, -reach, reach);
        }
    } while (!n[0] && !n[1] && !n[2]);
    const double far = length_of(n) * (double)random_in(random, -3000, 3000);
    set_plane(stage, n, (int64_t)far);
}

/* Vertices at all corners of the object's box, behind those of its polygon: a ball holds no more than these. */
static void fill_box(struct stage *stage)
{
    struct set *object = &stage->object;

    for (int k = 0; k < 8; k++) {
        const int32_t x = stage->box.half[0], y = stage->box.half[1], z = stage->box.half[2];
        object->vertices[3 + k] =
            (struct lim_vertex){(int16_t)(k & 1 ? x : -x), (int16_t)(k & 2 ? y : -y), (int16_t)(k & 4 ? z : -z)};
    }
    object->scene.vertex_count = 11;
}

/* Anywhere, turned anyhow; looked at from the origin. */
static void place_anyhow(struct stage *stage, struct random *random)
{
    const struct lim_camera camera = set_camera(false);
    struct lim_movers *movers = stage->lim.movers;
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    lim_instance_turn(&stage->instance, yaw, pitch, roll);
    stage->instance.finer_bits = (uint8_t)random_in(random, 0, 3);
    for (int i = 0; i < 3; i++)
        stage->instance.at_q8[i] = (int32_t)random_in(random, -(1 << 20), 1 << 20);
    movers->instances = &stage->instance;
    movers->given = movers->count = 1;
    fill_box(stage);
    lim_movers_pose(stage->lim.movers, &stage->lim.pass, &camera);
    assert_true(movers->movers[0].radius_q12 >= 0);
}

/* Near the plane x = 0, turned anyhow; looked at from anywhere. */
static void place_at(struct stage *stage, const double eye[3], struct random *random)
{
    struct lim_camera camera = set_camera(false);
    struct lim_movers *movers = stage->lim.movers;
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)(eye[i] * 256);
    lim_eye_set(lim_eye_of(&stage->lim.pass), &stage->scene.scene, camera.eye_q8);
    lim_instance_turn(&stage->instance, yaw, pitch, roll);
    stage->instance.finer_bits = (uint8_t)random_in(random, 0, 2);
    stage->instance.at_q8[0] = (int32_t)random_in(random, -400 * 256, 400 * 256);
    for (int i = 1; i < 3; i++)
        stage->instance.at_q8[i] = (int32_t)random_in(random, -3000 * 256, 3000 * 256);
    movers->instances = &stage->instance;
    movers->given = movers->count = 1;
    fill_box(stage);
    lim_movers_pose(movers, &stage->lim.pass, &camera);
    assert_true(movers->movers[0].radius_q12 >= 0);
}

/* On which sides of the plane the object's polygon is drawn, as parts of the object that the plane has cut. */
static int sides_of_polygon(struct stage *stage, bool eye_in_front)
{
    enum { INSTANCE, PLANE, POLYGON, COUNT };
    struct lim_sorter *sorter = stage->lim.sorter;
    struct lim_newell *newell = sorter->newell;
    enum lim_part_share shares[2];

    newell->polygons[INSTANCE] = (struct lim_newell_polygon){.cuts = LIM_NONE, .owner = 0};
    newell->polygons[PLANE] =
        (struct lim_newell_polygon){.cuts = LIM_NONE, .owner = LIM_NONE, .eye_in_front = eye_in_front};
    newell->polygons[POLYGON] = (struct lim_newell_polygon){.cuts = LIM_NONE, .owner = 0};
    sorter->list[INSTANCE] = sorter->list[PLANE] = (struct lim_sorted){.record = LIM_NO_INDEX, .next = LIM_NONE};
    sorter->list[POLYGON] = (struct lim_sorted){.record = 0, .next = LIM_NONE};
    sorter->used = COUNT;
    for (int back = 0; back < 2; back++) {
        struct lim_part part;
        newell->cuts[back] = (struct lim_cut){LIM_NONE, (uint16_t)(PLANE | (back ? 0 : LIM_CUT_FRONT))};
        newell->cuts_used = (uint16_t)(back + 1);
        newell->polygons[INSTANCE].cuts = (uint16_t)back;
        lim_part_begin(&part, sorter, INSTANCE);
        shares[back] = lim_part_take(&part, sorter, POLYGON);
    }
    if (shares[0] != LIM_PART_NOTHING && shares[1] != LIM_PART_NOTHING)
        for (int back = 0; back < 2; back++)
            assert_int_equal(shares[back], LIM_PART_PIECE);
    else
        assert_true(shares[0] == LIM_PART_ALL || shares[1] == LIM_PART_ALL);
    return (shares[0] != LIM_PART_NOTHING ? FRONT : 0) | (shares[1] != LIM_PART_NOTHING ? BACK : 0);
}

/* The instance, and on which sides of the plane it goes. */
static int sides_after(struct stage *stage, bool eye_in_front)
{
    struct lim_sorter *sorter = stage->lim.sorter;
    uint16_t front, back;

    sorter->list[0] = (struct lim_sorted){.record = LIM_NO_INDEX, .next = LIM_NONE};
    sorter->newell->polygons[0] = (struct lim_newell_polygon){.cuts = LIM_NONE, .owner = 0};
    sorter->used = 1;
    sorter->newell->cuts_used = 0;
    struct lim_route route = lim_route_static(sorter, false);
    lim_route_begin(&route, 0);
    lim_movers_divide(&route, eye_in_front ? 1 : -1, 0, &front, &back);
    return (front != LIM_NONE ? FRONT : 0) | (back != LIM_NONE ? BACK : 0);
}

/* What its corners say, where they are: 0, all are on it. */
static int sides_of_corners(struct stage *stage, bool *is_clear)
{
    const int64_t *n = stage->n;
    const double slack = (double)(llabs(n[0]) + llabs(n[1]) + llabs(n[2]));
    int sides = 0;

    *is_clear = true;
    for (lim_index k = 0; k < 3; k++) {
        int32_t at_q12[3];
        memcpy(at_q12, lim_mover_corner(stage->lim.movers, 0, k), sizeof at_q12);
        const double value =
            ((double)n[0] * at_q12[0] + (double)n[1] * at_q12[1] + (double)n[2] * at_q12[2]) / 4096 - (double)stage->d;
        if (fabs(fabs(value) - slack) < slack * 1e-6) *is_clear = false;
        sides |= value > slack ? FRONT : value < -slack ? BACK : 0;
    }
    return sides;
}

/* The vertex that is nearest to a place of the scene, in the object's own units; false: it has none there. */
static bool set_vertex(struct stage *stage, int k, const double at[3])
{
    int16_t own[3];

    for (int j = 0; j < 3; j++) {
        double sum = 0;
        for (int i = 0; i < 3; i++)
            sum += ldexp(stage->instance.axes_q30[3 * j + i], -30) * (at[i] - stage->instance.at_q8[i] / 256.0);
        sum = ldexp(sum, stage->instance.finer_bits);
        if (fabs(sum) > 32766) return false;
        own[j] = (int16_t)lround(sum);
    }
    stage->object.vertices[k] = (struct lim_vertex){own[0], own[1], own[2]};
    lim_mover_forget_corners(stage->lim.movers);
    return true;
}

/* Corners that far from the plane, anywhere along it. */
static bool set_corners(struct stage *stage, const double distance[3], struct random *random)
{
    const double length = length_of(stage->n);

    for (int k = 0; k < 3; k++) {
        double at[3], value = -(double)stage->d;
        for (int i = 0; i < 3; i++) {
            at[i] = stage->instance.at_q8[i] / 256.0 + (double)random_in(random, -3000, 3000);
            value += (double)stage->n[i] * at[i];
        }
        for (int i = 0; i < 3; i++)
            at[i] += (distance[k] - value / length) * (double)stage->n[i] / length;
        if (!set_vertex(stage, k, at)) return false;
    }
    return true;
}

/* All a little within the limit of what counts as on the plane, or a little beyond it; or anywhere; and one of them
 * often on the other side. */
static void any_distances(const struct stage *stage, double distance[3], struct random *random)
{
    const double limit = (double)(llabs(stage->n[0]) + llabs(stage->n[1]) + llabs(stage->n[2])) / length_of(stage->n);
    const int side = random_in(random, 0, 1) ? 1 : -1, odd = (int)random_in(random, 0, 5),
              kind = (int)random_in(random, 0, 2);

    for (int k = 0; k < 3; k++) {
        const double part = random_unit(random);
        distance[k] = side * (kind == 0 ? limit * (0.8 + 0.4 * part) : kind == 1 ? limit * part : 30 * part);
        if (k == odd) distance[k] = -distance[k];
    }
}

static void polygons_go_where_their_corners_are(void **state)
{
    static struct stage stage;
    struct random random = {551};
    int found[4] = {0};

    (void)state;
    stage_open(&stage);
    for (int round = 0; round < ROUNDS; round++) {
        double distance[3];
        bool is_clear;
        any_plane(&stage, &random);
        place_anyhow(&stage, &random);
        const bool eye_in_front = random_in(&random, 0, 1);
        any_distances(&stage, distance, &random);
        if (!set_corners(&stage, distance, &random)) continue;
        const int sides = sides_of_corners(&stage, &is_clear);
        if (!is_clear) continue;
        found[sides]++;
        assert_int_equal(sides_of_polygon(&stage, eye_in_front), sides ? sides : eye_in_front ? FRONT : BACK);
    }
    stage_close(&stage);
    print_message("# %d on it, %d in front, %d behind, %d both\n", found[0], found[1], found[2], found[3]);
    for (int sides = 0; sides < 4; sides++)
        assert_true(found[sides] > ROUNDS / 40);
}

/* What enters by its centre goes where that is; on the plane, to where the eye is. */
static void centres_decide_for_those_that_enter_by_them(void **state)
{
    static const int64_t along_x[3] = {1, 0, 0};
    static struct stage stage;
    struct random random = {553};

    (void)state;
    stage_open(&stage);
    stage.instance.by_centre = true;
    for (int i = 0; i < 3; i++)
        stage.box.half[i] = 500;
    for (int eye_in_front = 0; eye_in_front < 2; eye_in_front++)
        for (int32_t beyond_q12 = -3; beyond_q12 <= 3; beyond_q12++) {
            place_anyhow(&stage, &random);
            set_plane(&stage, along_x, 77);
            stage.lim.movers->movers[0].centre_q12[0] = 77 * 4096 + beyond_q12;
            const bool is_front = beyond_q12 ? beyond_q12 > 0 : eye_in_front;
            assert_int_equal(sides_after(&stage, eye_in_front), is_front ? FRONT : BACK);
        }
    stage_close(&stage);
}

/* How far the box that is turned with the object reaches along the plane's normal, by its box along the scene's axes.
 */
static double box_reach(const struct stage *stage)
{
    double reach = 0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            reach += (double)llabs(stage->n[i]) * ldexp(fabs((double)stage->instance.axes_q30[3 * j + i]), -30) *
                     ldexp(stage->box.half[j], -stage->instance.finer_bits);
    return reach;
}

/* The same of the box's corners, which are vertices. */
static double corner_reach(const struct stage *stage)
{
    double reach = 0;

    for (int j = 0; j < 3; j++) {
        double along = 0;
        for (int i = 0; i < 3; i++)
            along += (double)stage->n[i] * ldexp(stage->instance.axes_q30[3 * j + i], -30);
        reach += fabs(along) * ldexp(stage->box.half[j], -stage->instance.finer_bits);
    }
    return reach;
}

/* What reaches the plane by its ball, its box and its vertices, and by more than counts as on it, is taken apart where
 * there is a wall in it; what does not, by more than what its radius and the plane's length are rounded up by, is not.
 */
static void balls_are_taken_apart_where_they_reach_the_plane(void **state)
{
    static struct stage stage;
    struct random random = {552};
    struct lim_stats *stats = stage.lim.pass.stats;
    int found[2] = {0};

    (void)state;
    stage_open(&stage);
    for (int round = 0; round < ROUNDS; round++) {
        any_plane(&stage, &random);
        for (int i = 0; i < 3; i++)
            stage.box.half[i] = (uint16_t)random_in(&random, 1, 1 << random_in(&random, 1, 14));
        place_anyhow(&stage, &random);
        const double length = length_of(stage.n), radius = stage.lim.movers->movers[0].radius_q12 / 4096.0;
        const double longest = (double)llabs(llabs(stage.n[0]) > llabs(stage.n[1]) ? stage.n[0] : stage.n[1]);
        const double most = fmax(longest, (double)llabs(stage.n[2]));
        const double sum = (double)(llabs(stage.n[0]) + llabs(stage.n[1]) + llabs(stage.n[2]));
        const double box = box_reach(&stage), rounded = radius * (most + (sum - most) * 107 / 256 + 1);
        const bool reaches = random_in(&random, 0, 1), is_front = random_in(&random, 0, 1);
        const double slack = is_front ? -sum : sum; /* what is on the plane is on the eye's side, in front */
        const double all = fmin(fmin(radius * length, box), corner_reach(&stage));
        const double surely = all + slack; /* it reaches so far, of normals */
        const double beyond = fmin(rounded, box + sum * 0.002) + slack;
        const double by = reaches ? surely - fabs(surely) * 1e-5 * (double)random_in(&random, 1, 20)
                                  : beyond + fabs(beyond) * 1e-5 * (double)random_in(&random, 1, 20);
        double value = 0;
        for (int i = 0; i < 3; i++)
            value += (double)stage.n[i] * stage.lim.movers->movers[0].centre_q12[i] / 4096;
        const int64_t d = (int64_t)(value - (is_front ? by : -by));
        if (surely <= 0 || fabs((double)d - value) / length > 1e5 || llabs(d) >= INT64_C(1) << 47) continue;
        const int64_t n[3] = {stage.n[0], stage.n[1], stage.n[2]};
        /* Where a unit of d matters, the plane cannot be put there. */
        if (length * radius < 1e6) continue;
        set_plane(&stage, n, d);
        stats->movers.divided = 0;
        const int sides = sides_after(&stage, true);
        assert_int_equal(stats->movers.divided, reaches);
        if (!reaches) assert_int_equal(sides, is_front ? FRONT : BACK);
        found[reaches]++;
    }
    stage_close(&stage);
    print_message("# %d beyond, %d reach it\n", found[0], found[1]);
    assert_true(found[0] > ROUNDS / 10 && found[1] > ROUNDS / 10);
}

/* Whether the way from `from` through `to` meets the wall, in the plane x = 0. */
static bool meets_wall(const struct stage *stage, const double from[3], const double to[3])
{
    const struct lim_vertex *corner = stage->scene.vertices;
    const double t = from[0] / (from[0] - to[0]);
    const double y = from[1] + t * (to[1] - from[1]), z = from[2] + t * (to[2] - from[2]);
    int left = 0;

    for (int k = 0; k < 3; k++) {
        const struct lim_vertex a = corner[k], b = corner[(k + 1) % 3];
        left += (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y) > 0;
    }
    return left == 0 || left == 3;
}

/* Of points anywhere in the object's box: whether the wall hides one beyond the plane, or one before it hides the
 * wall. */
static void look_through(const struct stage *stage, const double eye[3], struct random *random, bool *hidden,
                         bool *hides)
{
    *hidden = *hides = false;
    for (int point = 0; point < 200; point++) {
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = stage->instance.at_q8[i] / 256.0;
        for (int j = 0; j < 3; j++) {
            const double part =
                random_in(random, 0, 3) ? 2 * random_unit(random) - 1 : (double)random_in(random, 0, 1) * 2 - 1;
            const double own = ldexp(part * stage->box.half[j], -stage->instance.finer_bits);
            for (int i = 0; i < 3; i++)
                at[i] += own * ldexp(stage->instance.axes_q30[3 * j + i], -30);
        }
        if (fabs(at[0]) < 3 || fabs(at[0]) > fabs(eye[0])) continue; /* as good as on the plane */
        if (!meets_wall(stage, eye, at)) continue;
        *((at[0] < 0) == (eye[0] < 0) ? hides : hidden) = true;
    }
}

/* All of it on the eye's side of a plane that it reaches through: then no wall in the plane hides any of what is
 * beyond. All of it beyond: then it hides none. */
static void what_stays_uncut_has_an_order(void **state)
{
    static struct stage stage;
    struct random random = {554};
    int uncut[2] = {0}, apart = 0, needless = 0;

    (void)state;
    stage_open(&stage);
    stage.node.split = (struct lim_plane_ref){LIM_PLANE_X, 0};
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_vertex corners[3];
        const double eye[3] = {(random_in(&random, 0, 1) ? 1 : -1) * (double)random_in(&random, 10, 9000),
                               (double)random_in(&random, -9000, 9000), (double)random_in(&random, -9000, 9000)};
        bool hidden, hides;
        for (int k = 0; k < 3; k++)
            corners[k] = (struct lim_vertex){0, (int16_t)random_in(&random, -4000, 4000),
                                             (int16_t)random_in(&random, -4000, 4000)};
        set_wall(&stage, corners);
        for (int i = 0; i < 3; i++)
            stage.box.half[i] = (uint16_t)random_in(&random, 200, 2000);
        place_at(&stage, eye, &random);
        if (fabs(stage.instance.at_q8[0] / 256.0) > 300) continue;
        stage.lim.pass.stats->movers.divided = 0;
        const int sides = sides_after(&stage, eye[0] > 0);
        look_through(&stage, eye, &random, &hidden, &hides);
        const bool is_near = sides == (eye[0] > 0 ? FRONT : BACK), is_apart = stage.lim.pass.stats->movers.divided;
        if (!is_apart) assert_false(is_near ? hidden : hides);
        if (is_apart)
            apart++, needless += !hidden || !hides;
        else
            uncut[is_near]++;
    }
    stage_close(&stage);
    print_message("# %d near, %d far, %d taken apart, %d of these for nothing\n", uncut[1], uncut[0], apart, needless);
    assert_true(uncut[0] > ROUNDS / 100 && uncut[1] > ROUNDS / 20 && apart > ROUNDS / 20);
}

/* Room for so many entries is room for as many cuts: the most of either that there was. */
static void entries_are_counted_with_their_cuts(void **state)
{
    static const uint16_t used[][2] = {{3, 0}, {3, 3}, {2, 7}, {7, 6}, {6, 1}, {9, 8}, {8, 10}, {1, 1}};
    static struct stage stage;
    struct lim_sorter *sorter = stage.lim.sorter;
    uint32_t most = 0;

    (void)state;
    stage_open(&stage);
    stage.lim.pass.stats->movers.entries = 0;
    for (size_t k = 0; k < sizeof used / sizeof *used; k++) {
        sorter->used = used[k][0];
        sorter->newell->cuts_used = used[k][1];
        for (int i = 0; i < 2; i++)
            if (used[k][i] > most) most = used[k][i];
        lim_movers_note_entries(stage.lim.sorter);
        assert_int_equal(stage.lim.pass.stats->movers.entries, most);
    }
    stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(entries_are_counted_with_their_cuts),
        cmocka_unit_test(polygons_go_where_their_corners_are),
        cmocka_unit_test(centres_decide_for_those_that_enter_by_them),
        cmocka_unit_test(balls_are_taken_apart_where_they_reach_the_plane),
        cmocka_unit_test(what_stays_uncut_has_an_order),
    };

    return cmocka_run_group_tests_name("divide", tests, NULL, NULL);
}
