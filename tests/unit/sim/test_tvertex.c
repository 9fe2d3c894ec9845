/* SPDX-License-Identifier: MIT
 *
 * mesh_insert_t_vertices(), and the search tree under it: afterwards no corner lies inside an edge,
 * and what touches along an edge shares its ends. */
#include "base/point_tree.h"
#include "base/vec3.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_checks.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"
#include "rigs/tiny_scenes.h"

#include <stdio.h>

static void insert(struct mesh *mesh)
{
    struct error err;
    assert_true(mesh_insert_t_vertices(mesh, &err));
}

static void vertices_are_inserted_in_order_in_either_direction(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {4, 0, 0}, {4, -4, 0}, {0, -4, 0}); /* its upper edge runs to +x ... */
    TINY(&model, {3, 0, 0}, {4, 0, 0}, {4, 1, 0});
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0});
    TINY(&model, {0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}); /* ... and this one to -x */
    struct mesh mesh = cleaned(&model);
    insert(&mesh);
    assert_int_equal(mesh.counts.t_vertices, 4);
    const double along[6] = {0, 1, 3, 4, 4, 0}, back[6] = {0, 0, 4, 4, 3, 1};
    for (uint32_t k = 0; k < 6; k++) {
        assert_true(mesh.points[mesh.corners[mesh.polygons[0].first + k]][0] == along[k]);
        assert_true(mesh.points[mesh.corners[mesh.polygons[3].first + k]][0] == back[k]);
    }
    mesh_free(&mesh);
}

static void only_corners_of_polygons_are_inserted(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
    TINY(&model, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}); /* no area: dropped, its corners with it */
    struct mesh mesh = cleaned(&model);
    insert(&mesh);
    assert_int_equal(mesh.counts.t_vertices, 0);
    mesh_free(&mesh);
}

static void a_vertex_a_thirty_second_unit_off_the_edge_is_not_on_it(void **state)
{
    (void)state;
    struct model model = {0}; /* a unit is nearly a metre */
    TINY(&model, {0, 0, 0}, {65534, 0, 0}, {65534, 65534, 0}, {0, 65534, 0});
    TINY(&model, {100, -0.031, 0}, {100, -50, 0}, {150, -50, 0});
    TINY(&model, {100, 65534.032, 0}, {150, 65584, 0}, {100, 65584, 0});
    struct mesh mesh = cleaned(&model);
    insert(&mesh);
    assert_int_equal(mesh.counts.t_vertices, 1);
    assert_int_equal(mesh.polygons[0].count, 5);
    mesh_free(&mesh);
}

/* Near its tip a needle is so thin that a vertex there lies on both its sides. */
static void needles_lose_their_tips(void **state)
{
    (void)state;
    struct model model = {0}; /* a unit is a metre */
    TINY(&model, {0, 0, -9}, {65534, 0, -9}, {65534, 65534, -9});
    TINY(&model, {0, 1000, 0}, {1000, 990, 0}, {1000, 1010, 0});
    TINY(&model, {3, 1000, 0}, {3, 1000, 50}, {20, 1000, 50});
    struct mesh mesh = cleaned(&model);
    insert(&mesh);
    assert_int_equal(mesh.polygons[1].count, 3);
    for (uint32_t k = 0; k < 3; k++)
        assert_true(mesh.points[mesh.corners[mesh.polygons[1].first + k]][0] >= 3);
    mesh_free(&mesh);
}

/* 792 edges of rooms have another face's vertex inside, each one. Rounding to 6 decimals, as in
 * rooms-tilted, loses none. What stays open is open in the model: boxes without a bottom, table
 * legs without a top, the teapot's rims. */
static void benchmark_scenes_close(void **state)
{
    (void)state;
    const char *const paths[3] = {"sim/scenes/rooms.obj", "sim/scenes/rooms-tilted.obj", "sim/scenes/teapot.obj"};
    const size_t before[3] = {2376, 2376, 64}, t_vertices[3] = {792, 792, 0}, after[3] = {672, 672, 64};
    for (int i = 0; i < 3; i++) {
        struct mesh mesh = cleaned_file(paths[i]);
        double area_m2 = mesh_area_m2(&mesh);
        assert_int_equal(mesh_open_edges(&mesh), before[i]);
        assert_int_equal(mesh_t_vertices_left(&mesh), t_vertices[i]);
        insert(&mesh);
        assert_int_equal(mesh.counts.t_vertices, t_vertices[i]);
        assert_int_equal(mesh_open_edges(&mesh), after[i]);
        assert_int_equal(mesh_t_vertices_left(&mesh), 0);
        assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
        assert_true(fabs(mesh_area_m2(&mesh) - area_m2) < 1e-6 * area_m2);
        mesh_free(&mesh);
    }
}

static void random_solids_of_tiles_close(void **state)
{
    (void)state;
    struct random random = {3};
    size_t t_vertices = 0;
    for (int run = 0; run < 100; run++) {
        struct model model = {0};
        tiny_tiled_box(&model, &random);
        struct mesh mesh = cleaned(&model);
        insert(&mesh);
        assert_int_equal(mesh_open_edges(&mesh), 0);
        assert_int_equal(mesh_t_vertices_left(&mesh), 0);
        t_vertices += mesh.counts.t_vertices;
        mesh_free(&mesh);
    }
    assert_true(t_vertices > 5000);
}

/* Points crowded around a few lines, at about the distance that welding leaves: however they lie,
 * it comes to an end, and leaves none inside an edge. */
static void crowds_of_points_leave_no_t_vertex(void **state)
{
    (void)state;
    struct random random = {5};
    for (int run = 0; run < 50; run++) {
        struct model model = {0};
        TINY(&model, {0, 0, 0}, {65534, 0, 0}, {65534, 65534, 0}, {0, 65534, 0});
        for (int i = 0; i < 60; i++) {
            double p[3][3];
            for (int k = 0; k < 3; k++) {
                p[k][0] = 1000 + 10 * random_unit(&random);
                p[k][1] = 0.1 * random_unit(&random) - 0.05;
                p[k][2] = 0.1 * random_unit(&random) - 0.05;
            }
            if (i % 2) p[2][1] += 500;
            for (int k = 0; k < 3; k++)
                p[k][0] += 3000 * (i % 15);
            tiny_add(&model, 3, (const double(*)[3])p);
        }
        struct mesh mesh = cleaned(&model);
        insert(&mesh);
        assert_int_equal(mesh_t_vertices_left(&mesh), 0);
        mesh_free(&mesh);
    }
}

struct found {
    bool *points;
    size_t repeated;
};

static void note(void *context, uint32_t point)
{
    struct found *found = context;
    found->repeated += found->points[point];
    found->points[point] = true;
}

static void the_tree_finds_what_a_search_through_all_points_finds(void **state)
{
    (void)state;
    enum { COUNT = 700 };
    struct random random = {11};
    double points[COUNT][3];
    uint32_t all[COUNT];
    for (uint32_t i = 0; i < COUNT; i++) {
        all[i] = i;
        for (int axis = 0; axis < 3; axis++) /* coarse, so that many are equal or on the line */
            points[i][axis] = (double)random_in(&random, 0, axis == 2 ? 1 : 12);
    }
    struct point_tree tree;
    point_tree_build(&tree, points, all, COUNT);
    for (int run = 0; run < 2000; run++) {
        bool seen[COUNT] = {false};
        struct found found = {seen, 0};
        const double *a = points[random_in(&random, 0, COUNT - 1)], *b = points[random_in(&random, 0, COUNT - 1)];
        double radius = 0.01 + 2 * random_unit(&random);
        point_tree_near(&tree, a, b, radius, note, &found);
        assert_int_equal(found.repeated, 0);
        for (uint32_t i = 0; i < COUNT; i++)
            assert_int_equal(seen[i], vec3_segment_distance2(a, b, points[i]) < radius * radius);
    }
    point_tree_free(&tree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_inserted_in_order_in_either_direction),
        cmocka_unit_test(only_corners_of_polygons_are_inserted),
        cmocka_unit_test(a_vertex_a_thirty_second_unit_off_the_edge_is_not_on_it),
        cmocka_unit_test(needles_lose_their_tips),
        cmocka_unit_test(benchmark_scenes_close),
        cmocka_unit_test(random_solids_of_tiles_close),
        cmocka_unit_test(crowds_of_points_leave_no_t_vertex),
        cmocka_unit_test(the_tree_finds_what_a_search_through_all_points_finds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
