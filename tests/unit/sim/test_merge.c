/* SPDX-License-Identifier: MIT
 *
 * mesh_merge(): what is joined, what is not, and that nothing is lost by it. */
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_checks.h"
#include "rigs/tiny_model.h"
#include "rigs/tiny_scenes.h"

#include <math.h>
#include <stdio.h>

static void merge(struct mesh *mesh)
{
    struct error err;
    assert_true(mesh_merge(mesh, &err));
}

static void insert(struct mesh *mesh)
{
    struct error err;
    assert_true(mesh_insert_t_vertices(mesh, &err));
}

/* Two unit squares side by side, the second lifted at its far edge. */
static struct model two_squares(double lift)
{
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    TINY(&model, {1, 0, 0}, {2, 0, lift}, {2, 1, lift}, {1, 1, 0});
    return model;
}

static size_t polygons_after_merging(struct model *model)
{
    struct mesh mesh = cleaned(model);
    merge(&mesh);
    size_t count = mesh.polygon_count;
    mesh_free(&mesh);
    return count;
}

static void squares_side_by_side_become_one_rectangle(void **state)
{
    (void)state;
    struct model model = two_squares(0);
    struct mesh mesh = cleaned(&model);
    merge(&mesh);
    assert_int_equal(mesh.polygon_count, 1);
    assert_int_equal(mesh.polygons[0].count, 4);
    assert_int_equal(mesh.polygons[0].face, 1);
    assert_int_equal(mesh.counts.merged, 1);
    assert_int_equal(mesh.merged_into[1], 1);
    assert_int_equal(mesh.merged_into[2], 1);
    mesh_free(&mesh);
}

static void colours_and_sidedness_are_kept_apart(void **state)
{
    (void)state;
    struct model model = two_squares(0);
    model.faces[1].colour ^= 1;
    assert_int_equal(polygons_after_merging(&model), 2);
    model = two_squares(0);
    model.faces[1].two_sided = true;
    assert_int_equal(polygons_after_merging(&model), 2);
}

/* The plane of both has half the lift's slope and goes through their middle, 1/3 of the lift above
 * the corners that they share: half a unit where the lift is 1.5. */
static void squares_that_a_plane_misses_by_half_a_unit_are_kept_apart(void **state)
{
    (void)state;
    double unit_m = 1.0 / 32767;
    struct model model = two_squares(1.4 * unit_m);
    assert_int_equal(polygons_after_merging(&model), 1);
    model = two_squares(1.6 * unit_m);
    assert_int_equal(polygons_after_merging(&model), 2);
}

static void unions_that_are_not_convex_are_left_alone(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    TINY(&model, {1, 0, 0}, {2, 0, 0}, {2, 0.5, 0}, {1, 1, 0});
    assert_int_equal(polygons_after_merging(&model), 1);
    model = (struct model){0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    TINY(&model, {1, 0, 0}, {2, 0, 0}, {2, 1.5, 0}, {1, 1, 0});
    assert_int_equal(polygons_after_merging(&model), 2);
}

static void back_to_back_faces_are_left_alone(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    TINY(&model, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0});
    assert_int_equal(polygons_after_merging(&model), 2);
}

static void folded_faces_are_left_alone(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    TINY(&model, {1, 1, 0}, {1, 0, 0}, {0.5, 0.5, 0});
    assert_int_equal(polygons_after_merging(&model), 2);
}

/* Three tiles that meet in a T, beside a fourth: the row of two first, then the large one. */
static void neighbours_are_joined_across_t_junctions(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
    TINY(&model, {0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0});
    TINY(&model, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0});
    struct mesh mesh = cleaned(&model);
    merge(&mesh);
    assert_int_equal(mesh.polygon_count, 1);
    assert_int_equal(mesh.polygons[0].count, 4);
    assert_int_equal(mesh.merged_into[3], 1);
    mesh_free(&mesh);
}

/* The corner where two joined squares met is gone, but comes back if a third face has it. */
static void straight_corners_come_back_where_others_need_them(void **state)
{
    (void)state;
    struct model model = two_squares(0);
    TINY(&model, {1, 0, 0}, {0, 0, 0}, {1, 0, -1});
    struct mesh mesh = cleaned(&model);
    merge(&mesh);
    assert_int_equal(mesh.polygons[0].count, 4);
    insert(&mesh);
    assert_int_equal(mesh.polygons[0].count, 5);
    assert_int_equal(mesh.counts.t_vertices, 1);
    mesh_free(&mesh);
}

/* Each of its corners alone bends too little to matter; together they are a quarter of a circle. */
static void arcs_do_not_lose_their_slight_bends(void **state)
{
    (void)state;
    enum { COUNT = 4000 };
    static double disc[COUNT][3];
    for (int i = 1; i < COUNT; i++) {
        double angle = 3.14159265358979 / 2 * (i - 1) / (COUNT - 2);
        disc[i][0] = cos(angle), disc[i][1] = sin(angle);
    }
    struct model model = {0};
    tiny_add(&model, COUNT, (const double(*)[3])disc);
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.polygon_count, 1);
    merge(&mesh);
    assert_true(fabs(mesh_area_m2(&mesh) - 3.14159265358979 / 4) < 1e-6);
    mesh_free(&mesh);
}

static void cut_faces_are_found_by_their_first_piece(void **state)
{
    (void)state;
    struct model model = {0}; /* an L, and a square that completes it to a larger square */
    TINY(&model, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0});
    TINY(&model, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.polygon_count, 5);
    merge(&mesh);
    assert_int_equal(mesh.merged_into[1], 1);
    assert_true(mesh.merged_into[2] == 1 || mesh.merged_into[2] == 2);
    assert_int_equal(mesh.polygon_count, 5 - mesh.counts.merged);
    assert_true(mesh.counts.merged >= 2);
    assert_true(fabs(mesh_area_m2(&mesh) - 4) < 1e-9);
    mesh_free(&mesh);
}

static void benchmark_scenes_keep_their_area_and_stay_closed(void **state)
{
    (void)state;
    const char *const paths[3] = {"sim/scenes/rooms.obj", "sim/scenes/rooms-tilted.obj", "sim/scenes/teapot.obj"};
    const size_t polygons[3] = {1176, 1176, 650}, open[3] = {672, 672, 64};
    for (int i = 0; i < 3; i++) {
        struct mesh mesh = cleaned_file(paths[i]);
        double area_m2 = mesh_area_m2(&mesh);
        merge(&mesh);
        assert_int_equal(mesh.polygon_count, polygons[i]);
        assert_int_equal(mesh.counts.merged + mesh.polygon_count, mesh.counts.faces);
        insert(&mesh);
        assert_int_equal(mesh_open_edges(&mesh), open[i]);
        assert_int_equal(mesh_t_vertices_left(&mesh), 0);
        assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
        assert_true(fabs(mesh_area_m2(&mesh) - area_m2) < 1e-6 * area_m2);
        mesh_free(&mesh);
    }
}

static void random_solids_of_tiles_keep_their_area_and_stay_closed(void **state)
{
    (void)state;
    struct random random = {9};
    size_t before = 0, after = 0;
    for (int run = 0; run < 100; run++) {
        struct model model = {0};
        tiny_tiled_box(&model, &random);
        for (size_t i = 0; i < model.face_count; i++)
            model.faces[i].colour = (uint32_t)random_in(&random, 0, run % 3);
        struct mesh mesh = cleaned(&model);
        before += mesh.polygon_count;
        merge(&mesh);
        after += mesh.polygon_count;
        insert(&mesh);
        assert_int_equal(mesh_open_edges(&mesh), 0);
        assert_int_equal(mesh_t_vertices_left(&mesh), 0);
        assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
        assert_true(fabs(mesh_area_m2(&mesh) - 6) < 1e-6);
        mesh_free(&mesh);
    }
    assert_true(after < before * 3 / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(squares_side_by_side_become_one_rectangle),
        cmocka_unit_test(colours_and_sidedness_are_kept_apart),
        cmocka_unit_test(squares_that_a_plane_misses_by_half_a_unit_are_kept_apart),
        cmocka_unit_test(unions_that_are_not_convex_are_left_alone),
        cmocka_unit_test(back_to_back_faces_are_left_alone),
        cmocka_unit_test(folded_faces_are_left_alone),
        cmocka_unit_test(neighbours_are_joined_across_t_junctions),
        cmocka_unit_test(straight_corners_come_back_where_others_need_them),
        cmocka_unit_test(arcs_do_not_lose_their_slight_bends),
        cmocka_unit_test(cut_faces_are_found_by_their_first_piece),
        cmocka_unit_test(benchmark_scenes_keep_their_area_and_stay_closed),
        cmocka_unit_test(random_solids_of_tiles_keep_their_area_and_stay_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
