/* SPDX-License-Identifier: MIT
 *
 * Sampled cameras stand in free space, and the pools measured with them are neither too small nor
 * much too large. */
#include "cameras/camera_path.h"
#include "cameras/sample.h"
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_image.h"
#include "scene/mcu_mem.h"

#include <math.h>
#include <string.h>

enum { SIDE_PX = 240, CAMERAS = 256, BOX_FACES = 6 };

/* Scenes ------------------------------------------------------------------------------------- */

/* A room, its walls facing inwards (a box mirrored), and boxes that stand free in it. */
struct room {
    struct mesh mesh;
    size_t furniture; /* boxes after the room's */
};

static struct room furnished_room(void)
{
    static const double pieces[][2][3] = {{{-2.5, -1, -1.5}, {0.8, 0.9, 0.6}}, {{2, 0, 1.5}, {0.5, 1.2, 0.7}},
                                          {{0.3, 1.2, -1}, {0.6, 0.2, 0.9}},   {{-1.5, 1, 1.8}, {0.4, 0.4, 0.4}},
                                          {{1.8, -1.2, -1.6}, {1, 0.3, 0.3}},  {{0, -1.4, 1.5}, {0.3, 0.3, 0.8}}};
    const double centre_m[3] = {0, 0, 0}, mirrored_m[3] = {-4, 2.2, 3};
    struct room room = {mesh_rig(3000.0), sizeof pieces / sizeof *pieces};

    mesh_rig_box(&room.mesh, centre_m, mirrored_m, 0, 0);
    for (size_t i = 0; i < room.furniture; i++)
        mesh_rig_box(&room.mesh, pieces[i][0], pieces[i][1], 0.4 * (double)i, i % 2 ? 0 : 0.3);
    return room;
}

static struct compiled compile_for(const struct mesh *mesh, unsigned w_px, unsigned h_px)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .w_px = w_px, .h_px = h_px};
    struct compiled scene;
    struct error err;

    if (!compile_mesh(mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static struct mesh solids(uint64_t seed)
{
    struct random random = {seed};
    struct mesh mesh = mesh_rig(3000.0);

    mesh_rig_solids(&mesh, &random, 16);
    return mesh;
}

/* Cameras ------------------------------------------------------------------------------------ */

/* Signed distance of a point from a polygon's plane. */
static double distance_m(const struct mesh *mesh, size_t polygon, const double at_m[3])
{
    const uint32_t *corners = &mesh->corners[mesh->polygons[polygon].first];
    const double *a = mesh->points[corners[0]], *b = mesh->points[corners[1]], *c = mesh->points[corners[2]];
    double along = 0, square = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double n = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        along += n * (at_m[i] - a[i]);
        square += n * n;
    }
    return along / sqrt(square);
}

/* How far a point is before the nearest, or the farthest, of a box's faces. */
static double least_m(const struct mesh *mesh, size_t box, const double at_m[3])
{
    double least = INFINITY;
    for (size_t i = 0; i < BOX_FACES; i++)
        least = fmin(least, distance_m(mesh, box * BOX_FACES + i, at_m));
    return least;
}

static double most_m(const struct mesh *mesh, size_t box, const double at_m[3])
{
    double most = -INFINITY;
    for (size_t i = 0; i < BOX_FACES; i++)
        most = fmax(most, distance_m(mesh, box * BOX_FACES + i, at_m));
    return most;
}

static void in_a_closed_room_eyes_are_inside_and_not_in_the_furniture(void **state)
{
    struct room room = furnished_room();
    struct compiled scene = mesh_rig_compile(&room.mesh, "auto", 0.5);
    const double unit_m = 1 / scene.grid.units_per_m;
    struct sampler sampler;

    (void)state;
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 5000; i++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        assert_true(least_m(&room.mesh, 0, viewpoint.eye_m) > -unit_m);
        for (size_t box = 1; box <= room.furniture; box++)
            assert_true(most_m(&room.mesh, box, viewpoint.eye_m) > -unit_m);
    }
    compiled_free(&scene);
    mesh_rig_free(&room.mesh);
}

/* From near and far, from all sides: no octant of space goes without. */
static void around_a_box_eyes_are_outside(void **state)
{
    const double centre_m[3] = {1, 2, 3}, half_m[3] = {1, 0.5, 2};
    struct mesh mesh = mesh_rig(3000.0);
    int in_octant[8] = {0}, within_1_m = 0, beyond_3_m = 0;
    struct sampler sampler;

    (void)state;
    mesh_rig_box(&mesh, centre_m, half_m, 0.5, 0.3);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 5000; i++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        const double *eye_m = viewpoint.eye_m, out_m = most_m(&mesh, 0, eye_m);
        assert_true(out_m > -1 / scene.grid.units_per_m);
        in_octant[(eye_m[0] > 1) + 2 * (eye_m[1] > 2) + 4 * (eye_m[2] > 3)]++;
        within_1_m += out_m < 1;
        beyond_3_m += out_m > 3;
    }
    for (int i = 0; i < 8; i++)
        assert_true(in_octant[i] > 300);
    assert_true(within_1_m > 500 && beyond_3_m > 500);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* In view as large as may be: all around the middle, no nearer than the corners are. */
static void portraits_show_what_stands_alone(void **state)
{
    const double centre_m[3] = {1, 2, 3}, half_m[3] = {1, 0.5, 2}, corner_m = sqrt(1 + 0.25 + 4);
    struct mesh mesh = mesh_rig(3000.0);
    int in_octant[8] = {0}, near = 0;
    struct sampler sampler;

    (void)state;
    mesh_rig_box(&mesh, centre_m, half_m, 0, 0);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    const double unit_m = 1 / scene.grid.units_per_m;
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 2000; i++) {
        struct viewpoint viewpoint;
        double square = 0;
        assert_true(sampler_portrait(&sampler, &viewpoint));
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(viewpoint.target_m[k] - centre_m[k]) < unit_m);
            square += pow(viewpoint.eye_m[k] - centre_m[k], 2);
        }
        assert_true(sqrt(square) > corner_m - 2 * unit_m && sqrt(square) < 2 * corner_m + 2 * unit_m);
        near += sqrt(square) < 1.5 * corner_m;
        in_octant[(viewpoint.eye_m[0] > 1) + 2 * (viewpoint.eye_m[1] > 2) + 4 * (viewpoint.eye_m[2] > 3)]++;
    }
    for (int i = 0; i < 8; i++)
        assert_true(in_octant[i] > 200);
    assert_true(near > 900 && near < 1100);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void a_closed_room_has_no_portraits(void **state)
{
    struct room room = furnished_room();
    struct compiled scene = mesh_rig_compile(&room.mesh, "auto", 0.5);
    struct viewpoint viewpoint;
    struct sampler sampler;

    (void)state;
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 2000; i++)
        assert_false(sampler_portrait(&sampler, &viewpoint));
    compiled_free(&scene);
    mesh_rig_free(&room.mesh);
}

static bool is_vertex(const struct compiled *scene, const double at_m[3])
{
    for (size_t v = 0; v < scene->scene.vertex_count; v++) {
        const struct lim_vertex *vertex = &scene->scene.vertices[v];
        const double units[3] = {vertex->x, vertex->y, vertex->z};
        double off_m = 0;
        for (int i = 0; i < 3; i++)
            off_m += fabs(scene->grid.origin_m[i] + units[i] / scene->grid.units_per_m - at_m[i]);
        if (off_m < 1e-9) return true;
    }
    return false;
}

/* Now this one, now that; a vertex too near to the eye is none to look at, which is rare. */
static void cameras_look_at_vertices(void **state)
{
    struct mesh mesh = solids(3);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    struct sampler sampler;
    int at_vertex = 0, at_the_last = 0;
    double last_m[3] = {0};

    (void)state;
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 500; i++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        at_the_last += memcmp(last_m, viewpoint.target_m, sizeof last_m) == 0;
        memcpy(last_m, viewpoint.target_m, sizeof last_m);
        at_vertex += is_vertex(&scene, viewpoint.target_m);
    }
    assert_true(at_vertex >= 495 && at_the_last < 50);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* A box of 16 units: many eyes are too near to their vertices. */
static void eye_and_target_stay_apart(void **state)
{
    const double centre_m[3] = {0, 0, 0}, half_m[3] = {1, 1, 1};
    struct mesh mesh = mesh_rig(8.0);
    struct sampler sampler;

    (void)state;
    mesh_rig_box(&mesh, centre_m, half_m, 0, 0);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    sampler_init(&sampler, &scene);
    for (int i = 0; i < 1000; i++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        double square = 0;
        for (int k = 0; k < 3; k++)
            square += pow(viewpoint.eye_m[k] - viewpoint.target_m[k], 2);
        assert_true(sqrt(square) * scene.grid.units_per_m > 15.99);
    }
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void the_same_scene_gives_the_same_cameras(void **state)
{
    struct mesh mesh = solids(4);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    struct sampler first, second;

    (void)state;
    sampler_init(&first, &scene);
    sampler_init(&second, &scene);
    struct viewpoint before = {0};
    for (int i = 0; i < 200; i++) {
        const struct viewpoint a = sampler_next(&first), b = sampler_next(&second);
        assert_memory_equal(a.eye_m, b.eye_m, sizeof a.eye_m);
        assert_memory_equal(a.target_m, b.target_m, sizeof a.target_m);
        assert_memory_not_equal(a.eye_m, before.eye_m, sizeof a.eye_m);
        before = a;
    }
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* Pools -------------------------------------------------------------------------------------- */

/* The sampled cameras whose frames need bands, if the scene's limits were these. */
static int banded(const struct compiled *scene, const struct lim_limits *limits, unsigned side_px)
{
    struct compiled copy = *scene; /* shares the arrays */
    struct simulator simulator;
    struct sampler sampler;
    struct lens lens;
    struct error err;
    int frames = 0;

    copy.scene.limits = *limits;
    assert_true(lens_init(&lens, 60, lens_default_near_m(&scene->grid), side_px, side_px, &err));
    const struct simulator_setup setup = {.w_px = side_px, .h_px = side_px, .panel = SIMULATOR_MEMORY};
    assert_true(simulator_init(&simulator, &copy.scene, &setup, &err));
    sampler_init(&sampler, &copy);
    for (int i = 0; i < CAMERAS; i++) {
        struct viewpoint viewpoint = sampler_next(&sampler);
        const struct camera_path path = {"sampled", &viewpoint, 1};
        struct lim_camera camera;
        assert_true(camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err));
        assert_true(simulator_frame(&simulator, &camera, &err));
        frames += simulator_stats(&simulator)->bands > 0;
    }
    simulator_free(&simulator);
    return frames;
}

/* The greediest camera of each pool may; the others must not. */
static void sampled_cameras_need_no_bands(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 3; seed++) {
        struct mesh mesh = solids(seed);
        struct compiled scene = compile_for(&mesh, SIDE_PX, SIDE_PX);
        assert_in_range(banded(&scene, &scene.scene.limits, SIDE_PX), 0, 3);
        compiled_free(&scene);
        mesh_rig_free(&mesh);
    }
}

/* With three quarters of the memory that they share, more do. */
static void no_memory_is_much_too_large(void **state)
{
    struct mesh mesh = solids(2);
    struct compiled scene = compile_for(&mesh, SIDE_PX, SIDE_PX);
    const struct lim_limits limits = scene.scene.limits;
    struct lim_limits less = limits;

    (void)state;
    less.retained_cells = (uint16_t)(limits.retained_cells / 4 * 3);
    less.gaps = (uint16_t)(limits.gaps / 4 * 3);
    less.active = (uint16_t)(limits.active / 4 * 3);
    const int most = banded(&scene, &limits, SIDE_PX);
    assert_true(banded(&scene, &less, SIDE_PX) > most);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* A triangle alone: two head cells, three vertices, five more where it is clipped; and gaps in cells. */
static void pools_are_never_below_the_least(void **state)
{
    const double corners_m[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    struct mesh mesh = mesh_rig(3000.0);

    (void)state;
    mesh_rig_add(&mesh, corners_m, 3);
    struct compiled scene = compile_for(&mesh, SIDE_PX, SIDE_PX);
    const struct lim_limits *limits = &scene.scene.limits;
    assert_in_range(limits->retained_cells, 2 + 3 + 5, 2 + 3 + 5 + SIDE_PX);
    assert_in_range(limits->gaps, 1, SIDE_PX + SIDE_PX / 8 + 1);
    assert_in_range(limits->active, 1, 2);
    const size_t least_b = mcu_mem_min_b(&scene);
    scene.scene.limits = (struct lim_limits){1, 3, 10, 1, 1, 0, 0, 0, 0};
    assert_int_equal(least_b, mcu_mem_b(&scene));
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void every_compilation_measures_the_same(void **state)
{
    struct mesh mesh = solids(5);
    struct compiled first = compile_for(&mesh, SIDE_PX, SIDE_PX), second = compile_for(&mesh, SIDE_PX, SIDE_PX);

    (void)state;
    assert_int_equal(first.image_b, second.image_b);
    assert_memory_equal(first.image, second.image, first.image_b);
    assert_memory_equal(&first.scene.limits, &second.scene.limits, sizeof first.scene.limits);
    compiled_free(&second);
    compiled_free(&first);
    mesh_rig_free(&mesh);
}

static void limits_go_into_the_image(void **state)
{
    struct mesh mesh = solids(6);
    struct compiled scene = compile_for(&mesh, SIDE_PX, SIDE_PX);
    const struct lim_file_header *header = scene.image;

    (void)state;
    assert_true(scene.scene.limits.gaps > 1);
    assert_memory_equal(header->limits, &scene.scene.limits, sizeof header->limits);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* Fewer lines have fewer gaps; a picture of no size stands for 240 x 240. */
static void pools_are_measured_for_the_panel(void **state)
{
    struct mesh mesh = solids(7);
    struct compiled large = compile_for(&mesh, SIDE_PX, SIDE_PX), small = compile_for(&mesh, 80, 60),
                    open = compile_for(&mesh, 0, 0);

    (void)state;
    assert_true(small.scene.limits.gaps < large.scene.limits.gaps / 2);
    assert_in_range(banded(&small, &small.scene.limits, 60), 0, 3);
    assert_int_equal(small.report.w_px, 80);
    assert_int_equal(small.report.h_px, 60);
    assert_memory_equal(&open.scene.limits, &large.scene.limits, sizeof open.scene.limits);
    compiled_free(&open);
    compiled_free(&small);
    compiled_free(&large);
    mesh_rig_free(&mesh);
}

/* 5 that cross a line, 7 being the least; 30 vertices of 4 and 2, 50 triangles and 100 lines of 2; with depths a line
 * of 100 of 4, and 16 for each that crosses one. Wide screens take 8 a point; wide scenes 4 a link, and aligned
 * ranks. */
static void bytes_of_a_mesh_on_a_microcontroller_add_up(void **state)
{
    struct compiled scene = {.scene = {.limits = {.vertices = 3, .active = 5}, .vertex_count = 30, .polygon_count = 50},
                             .report = {.w_px = 100, .h_px = 100, .draws = LIM_MESH}};

    (void)state;
    assert_int_equal(mcu_mem_b(&scene), 7 * 40 + 180 + 300);
    assert_int_equal(mcu_mem_min_b(&scene), 7 * 40 + 180 + 300);
    scene.scene.limits.active = 60;
    assert_int_equal(mcu_mem_b(&scene), 60 * 40 + 180 + 300);
    assert_int_equal(mcu_mem_min_b(&scene), 7 * 40 + 180 + 300);
    scene.report.draws = LIM_MESH_DEPTH;
    assert_int_equal(mcu_mem_b(&scene), 60 * 56 + 180 + 300 + 400);
    scene.report.core = &core_exact;
    assert_int_equal(mcu_mem_b(&scene), 60 * 88 + 300 + 300 + 400);
    scene.report.core = &core_fast;
    scene.scene.vertex_count = 70000;
    assert_int_equal(mcu_mem_b(&scene), 60 * 64 + 420000 + 600 + 400);
}

/* Vertex cache 512, 100 lines of 8, 10 pending nodes of 4, 101 cells of 4, 21 gaps of 6, 5 active of
 * 36; the sum to the next multiple of 4. At the least: 2 + 4 + 5 cells, a gap, an active polygon. Wide
 * screen coordinates double the cells and take half as much again in the cache; profile exact has longer edges;
 * antialiased, a gap has 20 and an active polygon 4 more, or 8, aligned. Scan lines take no gap but the least,
 * antialiased one more than are active. */
static void bytes_on_a_microcontroller_add_up(void **state)
{
    struct compiled scene = {.scene = {.limits = {10, 4, 101, 21, 5, 0}}, .report = {.w_px = 100, .h_px = 100}};

    (void)state;
    assert_int_equal(mcu_mem_b(&scene), 512 + 800 + 40 + 404 + 126 + 180 + 2);
    assert_int_equal(mcu_mem_min_b(&scene), 512 + 800 + 40 + 44 + 6 + 36 + 2);
    scene.report.core = &core_fine;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 126 + 180 + 2);
    scene.report.core = &core_fast;
    scene.report.w_px = 255;
    assert_int_equal(mcu_mem_b(&scene), 512 + 800 + 40 + 404 + 126 + 180 + 2);
    scene.report.w_px = 256;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 126 + 180 + 2);
    scene.report.core = &core_exact;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 126 + 5 * (36 + 28) + 2);
    scene.report.antialias = true;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 420 + 5 * (36 + 28 + 8));
    scene.report.core = &core_fine;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 420 + 5 * (36 + 4));
    scene.report.draws = LIM_SCANLINE;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 420 + 5 * (36 + 4));
    scene.report.antialias = false;
    assert_int_equal(mcu_mem_b(&scene), 768 + 800 + 40 + 808 + 6 + 180 + 2);
}

/* A convex solid: 100 heads of 2, 12 faces of 6, 5 crossings of 40 and a point of 4 for each of 4 + 5 vertices; at
 * the least no crossing. Wide coordinates double the points. */
static void so_do_those_of_a_convex_solid(void **state)
{
    struct compiled scene = {.scene = {.polygon_count = 12, .limits = {12, 4, 101, 21, 5, 0}},
                             .report = {.w_px = 100, .h_px = 100, .draws = LIM_CONVEX}};

    (void)state;
    assert_int_equal(mcu_mem_b(&scene), 512 + 200 + 72 + 5 * (40 + 9 * 4));
    assert_int_equal(mcu_mem_min_b(&scene), 512 + 200 + 72);
    scene.report.w_px = 342;
    assert_int_equal(mcu_mem_b(&scene), 768 + 200 + 72 + 5 * (40 + 9 * 8));
    scene.report.draws = LIM_PAINTER; /* the vertex cache, and 12 nodes of 4 */
    assert_int_equal(mcu_mem_b(&scene), 768 + 48);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_a_closed_room_eyes_are_inside_and_not_in_the_furniture),
        cmocka_unit_test(around_a_box_eyes_are_outside),
        cmocka_unit_test(portraits_show_what_stands_alone),
        cmocka_unit_test(a_closed_room_has_no_portraits),
        cmocka_unit_test(cameras_look_at_vertices),
        cmocka_unit_test(eye_and_target_stay_apart),
        cmocka_unit_test(the_same_scene_gives_the_same_cameras),
        cmocka_unit_test(sampled_cameras_need_no_bands),
        cmocka_unit_test(no_memory_is_much_too_large),
        cmocka_unit_test(pools_are_never_below_the_least),
        cmocka_unit_test(every_compilation_measures_the_same),
        cmocka_unit_test(limits_go_into_the_image),
        cmocka_unit_test(pools_are_measured_for_the_panel),
        cmocka_unit_test(bytes_on_a_microcontroller_add_up),
        cmocka_unit_test(bytes_of_a_mesh_on_a_microcontroller_add_up),
        cmocka_unit_test(so_do_those_of_a_convex_solid),
    };

    return cmocka_run_group_tests_name("pools", tests, NULL, NULL);
}
