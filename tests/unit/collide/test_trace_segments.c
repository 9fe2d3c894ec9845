/* SPDX-License-Identifier: MIT
 *
 * Segments through scenes of every tree, against an oracle that asks all polygons in exact arithmetic: at random, along
 * walls, through edges and corners, from planes, from far outside, without length. */
#include "compiler/compile_mesh.h"
#include "eye.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/tiny_scenes.h"
#include "unit/collide/solid_stage.h"

#include <math.h>
#include <stdio.h>

struct segment {
    int32_t from_q8[3], to_q8[3];
};

struct tally {
    size_t segments, hits, wrong, ties;
};

static int32_t clamped_q8(int64_t at_q8)
{
    const int64_t most = LIM_EYE_MAX_Q8 - 1;

    return (int32_t)(at_q8 > most ? most : at_q8 < -most ? -most : at_q8);
}

static void anywhere(struct solid_stage *stage, int64_t range_q8, int32_t at_q8[3])
{
    for (int i = 0; i < 3; i++)
        at_q8[i] = clamped_q8(random_in(&stage->random, -range_q8, range_q8));
}

/* In the scene's bounds, and a little around them. */
static void near_bounds(struct solid_stage *stage, int32_t at_q8[3])
{
    solid_stage_in_bounds(stage, 260, at_q8);
}

static const struct solid_polygon *any_polygon(struct solid_stage *stage)
{
    return &stage->list.polygons[random_u64(&stage->random) % stage->list.count];
}

/* A corner, a point of an edge or of the inside, rounded, as far as a few bits off it. */
static void at_polygon(struct solid_stage *stage, const struct solid_polygon *polygon, int32_t at_q8[3])
{
    const struct lim_vertex *vertices = stage->scene.scene.vertices;
    const size_t k = random_u64(&stage->random) % polygon->count;
    const struct lim_vertex *a = &vertices[polygon->corners[k]],
                            *b = &vertices[polygon->corners[(k + 1) % polygon->count]],
                            *c = &vertices[polygon->corners[(k + 2) % polygon->count]];
    const int64_t kind = random_in(&stage->random, 0, 3), u = kind > 0 ? random_in(&stage->random, 0, 256) : 0,
                  v = kind > 1 ? random_in(&stage->random, 0, 256 - u) : 0,
                  off = kind == 3 ? random_in(&stage->random, -150, 150) : random_in(&stage->random, -1, 1);
    const int64_t xyz[3][3] = {{a->x, a->y, a->z}, {b->x, b->y, b->z}, {c->x, c->y, c->z}};

    for (int i = 0; i < 3; i++)
        at_q8[i] = (int32_t)(xyz[0][i] * (256 - u - v) + xyz[1][i] * u + xyz[2][i] * v) + (int32_t)(off * (i - 1));
}

/* Onto the polygon's plane along an axis, give or take a bit. */
static void onto_plane(struct solid_stage *stage, const struct solid_polygon *polygon, int32_t at_q8[3])
{
    const int axis = (int)(random_u64(&stage->random) % 3);

    if (!polygon->n[axis]) return;
    const __int128 beyond = solid_value(polygon, at_q8) / polygon->n[axis];
    if (beyond > -LIM_EYE_MAX_Q8 && beyond < LIM_EYE_MAX_Q8)
        at_q8[axis] = clamped_q8(at_q8[axis] - (int64_t)beyond + random_in(&stage->random, -1, 1));
}

/* To somewhere beyond a point, so that the segment goes through it exactly. */
static void through(struct solid_stage *stage, struct segment *segment, const int32_t at_q8[3])
{
    const int64_t times = random_in(&stage->random, 1, 3);

    for (int i = 0; i < 3; i++)
        segment->to_q8[i] = clamped_q8(segment->from_q8[i] + times * ((int64_t)at_q8[i] - segment->from_q8[i]));
}

enum { KINDS = 10 };

static struct segment make_segment(struct solid_stage *stage, int kind)
{
    const struct solid_polygon *polygon = any_polygon(stage);
    struct segment segment;
    int32_t at_q8[3];
    const int axis = (int)(random_u64(&stage->random) % 3);

    near_bounds(stage, segment.from_q8);
    near_bounds(stage, segment.to_q8);
    at_polygon(stage, polygon, at_q8);
    switch (kind) {
    case 1: /* through a corner, an edge, an inside */
        through(stage, &segment, at_q8);
        break;
    case 2: /* along an axis */
        for (int i = 0; i < 3; i++)
            if (i != axis) segment.to_q8[i] = segment.from_q8[i];
        break;
    case 3: /* along an axis, along a wall */
        for (int i = 0; i < 3; i++)
            segment.from_q8[i] = segment.to_q8[i] = at_q8[i];
        segment.from_q8[axis] = clamped_q8(at_q8[axis] - random_in(&stage->random, 0, 1 << 22));
        segment.to_q8[axis] = clamped_q8(at_q8[axis] + random_in(&stage->random, 0, 1 << 22));
        break;
    case 4: /* from a plane */
        onto_plane(stage, polygon, segment.from_q8);
        break;
    case 5: /* to a plane, or in one */
        onto_plane(stage, polygon, segment.to_q8);
        if (random_u64(&stage->random) % 2) onto_plane(stage, polygon, segment.from_q8);
        break;
    case 6: /* from where a polygon is, to near there */
        for (int i = 0; i < 3; i++) {
            segment.from_q8[i] = at_q8[i];
            segment.to_q8[i] = at_q8[i] + (int32_t)random_in(&stage->random, -2000, 2000);
        }
        break;
    case 7: /* of no length, or nearly */
        for (int i = 0; i < 3; i++) {
            segment.from_q8[i] = at_q8[i];
            segment.to_q8[i] = at_q8[i] + (int32_t)(random_u64(&stage->random) % 4 == 0);
        }
        break;
    case 8: /* from the ends of the range through a polygon */
        anywhere(stage, LIM_EYE_MAX_Q8 - 1, segment.from_q8);
        through(stage, &segment, at_q8);
        break;
    case 9: /* anywhere */
        anywhere(stage, random_u64(&stage->random) % 2 ? LIM_EYE_MAX_Q8 - 1 : 3 << 23, segment.from_q8);
        anywhere(stage, random_u64(&stage->random) % 2 ? LIM_EYE_MAX_Q8 - 1 : 3 << 23, segment.to_q8);
        break;
    default:
        break;
    }
    return segment;
}

/* Not behind the plane that it is in front of when it begins, and not beyond the crossing. */
static bool is_well_placed(const struct solid_stage *stage, const struct segment *segment, const struct lim_hit *hit,
                           const struct solid_ray *ray)
{
    const double part = (double)ray->num / (double)ray->den;
    double normal = 0;
    bool well = true;

    for (size_t k = 0; k < stage->list.count; k++) {
        const struct solid_polygon *polygon = &stage->list.polygons[k];
        if (polygon->record != hit->record) continue;
        const __int128 before = solid_value(polygon, segment->from_q8), there = solid_value(polygon, hit->at_q8);
        well = before == 0 ? there == 0 : before > 0 ? there >= 0 : there <= 0;
        double length = 0;
        for (int i = 0; i < 3; i++) {
            normal += (double)polygon->n[i] * hit->normal[i] *
                      (before > 0      ? 1
                       : before < 0    ? -1
                       : polygon->back ? -1
                                       : 1);
            length += fabs((double)polygon->n[i]);
        }
        /* how much nearer it may be, as slant as the way is */
        const double back = (length + 1) / fabs((double)(before - solid_value(polygon, segment->to_q8)));
        for (int i = 0; i < 3; i++) {
            const double way = (double)segment->to_q8[i] - segment->from_q8[i],
                         left = way * part - (hit->at_q8[i] - segment->from_q8[i]);
            well = well && (way < 0 ? left <= 1e-3 && left >= way * back - 4 : left >= -1e-3 && left <= way * back + 4);
        }
    }
    return well && normal > 0 && fabs(hit->part_q30 / 1073741824.0 - part) < 4e-9;
}

static void try_segment(const struct solid_stage *stage, const struct segment *segment, uint8_t flags,
                        struct tally *tally)
{
    struct lim_hit hit;
    const struct solid_ray ray = solid_trace(&stage->list, segment->from_q8, segment->to_q8, flags & LIM_STOP_BACKS);
    const int met = lim_trace(&stage->solid, segment->from_q8, segment->to_q8, flags, &hit);
    const bool right = met == ray.hit && (!met || (solid_meets_at(&stage->list, hit.record, segment->from_q8,
                                                                  segment->to_q8, flags & LIM_STOP_BACKS, &ray) &&
                                                   is_well_placed(stage, segment, &hit, &ray)));
    tally->segments++;
    tally->hits += ray.hit;
    tally->wrong += !right;
    if (!right && tally->wrong < 4)
        printf("# from %d %d %d to %d %d %d flags %d: %d record %u, oracle %d at %.9f\n", segment->from_q8[0],
               segment->from_q8[1], segment->from_q8[2], segment->to_q8[0], segment->to_q8[1], segment->to_q8[2], flags,
               met, met > 0 ? (unsigned)hit.record : 0, ray.hit, (double)ray.num / (double)ray.den);
}

static void try_stage(struct solid_stage *stage, int whole)
{
    struct tally tally = {0};

    for (int k = 0; k < effort(whole); k++) {
        const struct segment segment = make_segment(stage, k % KINDS);
        try_segment(stage, &segment, k / KINDS % 2 ? LIM_STOP_BACKS : 0, &tally);
    }
    printf("# %s: %zu polygons, %zu segments, %zu hits, %zu wrong\n", stage->name, stage->list.count, tally.segments,
           tally.hits, tally.wrong);
    assert_int_equal(tally.wrong, 0);
    assert_true(tally.hits > tally.segments / 10);
}

static void try_leaves(const char *path, enum tree_kind tree, enum mesh_leaves leaves, int whole)
{
    struct solid_stage stage = {0};

    solid_stage_model(&stage, path, tree, leaves);
    try_stage(&stage, whole);
    solid_stage_end(&stage);
}

static void try_model(const char *path, enum tree_kind tree, int whole)
{
    try_leaves(path, tree, MESH_LEAVES_NONE, whole);
}

static void rooms_stop_what_they_should(void **state)
{
    (void)state;
    try_model("sim/scenes/rooms.obj", TREE_BSP, 20000);
    try_model("sim/scenes/rooms.obj", TREE_OCTREE, 10000);
    try_model("sim/scenes/rooms.obj", TREE_NONE, 1000);
}

static void solids_and_crossing_polygons_do(void **state)
{
    (void)state;
    try_model("sim/scenes/teapot.obj", TREE_BSP, 10000);
    try_model("sim/scenes/teapot.obj", TREE_CLUSTERS, 20000);
    try_model("sim/scenes/knot.obj", TREE_BSP, 10000);
    try_leaves("sim/scenes/teapot.obj", TREE_BSP, MESH_LEAVES_ALL, 10000);
}

static void a_level_does(void **state)
{
    (void)state;
    try_model(SOLID_E1M1, TREE_BSP, 20000);
    try_model(SOLID_E1M1, TREE_AXIS, 10000);
}

static void random_buildings_do(void **state)
{
    struct random random = {99};

    (void)state;
    for (int k = 0; k < 8; k++) {
        struct solid_stage stage = {0};
        solid_stage_building(&stage, &random, (uint64_t)k);
        try_stage(&stage, 4000);
        solid_stage_end(&stage);
    }
}

/* Neighbours leave no gap, however they are turned: from inside of a closed room each way out is stopped. */
static void nothing_leaves_a_closed_room(void **state)
{
    struct random random = {3};
    size_t segments = 0, out = 0, wrong = 0;

    (void)state;
    for (int k = 0; k < effort(20); k++) {
        struct closed_scene closed;
        struct solid_stage stage = {0};
        struct tally tally = {0};
        solid_stage_closed(&stage, &closed, &random, (uint64_t)k);
        for (int i = 0; i < 5000; i++) {
            const struct viewpoint view = closed_scene_viewpoint(&closed, &random);
            struct segment segment;
            struct lim_hit hit;
            solid_place_q8(&stage.scene, view.eye_m, segment.from_q8);
            anywhere(&stage, LIM_EYE_MAX_Q8 / 4, segment.to_q8);
            segment.to_q8[i % 3] = i % 4 < 2 ? LIM_EYE_MAX_Q8 / 8 : -LIM_EYE_MAX_Q8 / 8;
            if (i % 2) { /* for a point of an edge, or a corner */
                int32_t at_q8[3];
                at_polygon(&stage, any_polygon(&stage), at_q8);
                through(&stage, &segment, at_q8);
                for (int a = 0; a < 3; a++)
                    segment.to_q8[a] =
                        clamped_q8(segment.from_q8[a] + 20 * ((int64_t)segment.to_q8[a] - segment.from_q8[a]));
            }
            out += lim_trace(&stage.solid, segment.from_q8, segment.to_q8, 0, &hit) != 1;
            segments++;
            if (i < 200) try_segment(&stage, &segment, 0, &tally);
        }
        wrong += tally.wrong;
        solid_stage_end(&stage);
        closed_scene_free(&closed);
    }
    printf("# %zu ways out of closed rooms, %zu not stopped\n", segments, out);
    assert_int_equal(out, 0);
    assert_int_equal(wrong, 0);
}

/* From inside of a box that is turned, so that the corners of no two of its sides lie on both planes. */
static void nothing_leaves_a_turned_box(void **state)
{
    struct random random = {12};
    size_t segments = 0, out = 0;

    (void)state;
    for (int k = 0; k < effort(40); k++) {
        const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .tree = TREE_BSP};
        struct model model = {.points = NULL};
        struct solid_stage stage = {0};
        struct error err;
        tiny_tiled_box(&model, &random);
        if (!compile_part(&model, NULL, &options, &stage.scene, &err)) fail_msg("%s", err.text);
        solid_stage_begin(&stage, 9000 + (uint64_t)k);
        for (int i = 0; i < 5000; i++) {
            struct segment segment;
            struct lim_hit hit;
            int32_t at_q8[3];
            for (int a = 0; a < 3; a++)
                segment.from_q8[a] = (int32_t)random_in(&stage.random, -300000, 300000);
            at_polygon(&stage, any_polygon(&stage), at_q8);
            for (int a = 0; a < 3; a++)
                segment.to_q8[a] = clamped_q8(segment.from_q8[a] + 3 * ((int64_t)at_q8[a] - segment.from_q8[a]));
            out += lim_trace(&stage.solid, segment.from_q8, segment.to_q8, LIM_STOP_BACKS, &hit) != 1;
            segments++;
        }
        solid_stage_end(&stage);
        model_free(&model);
    }
    printf("# %zu ways out of turned boxes, %zu not stopped\n", segments, out);
    assert_int_equal(out, 0);
}

static void what_is_out_of_range_is_refused(void **state)
{
    struct solid_stage stage = {0};
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .tree = TREE_BSP};
    struct compile_options mesh = options;
    struct compiled triangles;
    struct error err;
    struct lim_hit hit;
    const int32_t from_q8[3] = {0, 0, 0}, far_q8[3] = {0, LIM_EYE_MAX_Q8, 0};

    (void)state;
    if (!compile_model("sim/scenes/teapot.obj", &options, &stage.scene, &err)) fail_msg("%s", err.text);
    solid_stage_begin(&stage, 1);
    assert_int_equal(lim_trace(&stage.solid, from_q8, far_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_trace(&stage.solid, far_q8, from_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_solid_init(&stage.solid, &stage.scene.scene, stage.stack,
                                    stage.scene.scene.limits.depth * sizeof(lim_index) - 1),
                     LIM_ERR_MEMORY);
    solid_stage_end(&stage);
    mesh.tree = TREE_MESH;
    if (!compile_model("sim/scenes/teapot.obj", &mesh, &triangles, &err)) fail_msg("%s", err.text);
    assert_int_equal(lim_solid_init(&stage.solid, &triangles.scene, &hit, sizeof hit), LIM_ERR_SCENE);
    compiled_free(&triangles);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooms_stop_what_they_should),
        cmocka_unit_test(solids_and_crossing_polygons_do),
        cmocka_unit_test(a_level_does),
        cmocka_unit_test(random_buildings_do),
        cmocka_unit_test(nothing_leaves_a_closed_room),
        cmocka_unit_test(nothing_leaves_a_turned_box),
        cmocka_unit_test(what_is_out_of_range_is_refused),
    };

    return cmocka_run_group_tests_name("trace segments", tests, NULL, NULL);
}
