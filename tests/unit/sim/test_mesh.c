/* SPDX-License-Identifier: MIT
 *
 * mesh_clean(): the grid, welding, and what becomes of each kind of face. */
#include "model/grid.h"
#include "model/loop.h"
#include "model/polygon_list.h"
#include "readers/model_import.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_checks.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <stdio.h>

/* A square of 65534 m, so that a metre is a unit. */
static struct model unit_model(void)
{
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {65534, 0, 0}, {65534, 65534, 0}, {0, 65534, 0});
    return model;
}

static void assert_refused(struct model *model, const char *line)
{
    struct mesh mesh;
    struct error err = {""};
    assert_false(mesh_clean(model, &mesh, &err));
    assert_string_equal(err.text, line);
    assert_null(mesh.points);
    assert_null(mesh.polygons);
    model_free(model);
}

/* The polygons made of a face. */
static size_t pieces_of(const struct mesh *mesh, uint32_t face)
{
    size_t count = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++)
        count += mesh->polygons[i].face == face;
    return count;
}

static void the_grid_fits_the_longest_side_exactly(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {10, -2, 5}, {14, -2, 5}, {14, 2, 5});
    struct mesh mesh = cleaned(&model);
    assert_true(mesh.grid.origin_m[0] == 12 && mesh.grid.origin_m[1] == 0 && mesh.grid.origin_m[2] == 5);
    assert_true(mesh.grid.units_per_m == 65534.0 / 4);
    assert_true(grid_weld_m(&mesh.grid) == 1 / (16 * mesh.grid.units_per_m));
    mesh_free(&mesh);
}

/* 7.31 m: at the largest scale a centimetre would be 89.65 units. */
static void corners_on_whole_centimetres_round_without_error(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0.02, 0, 0.5}, {7.33, 0, 0.5}, {7.33, 2.45, 0.5}, {0.02, 2.45, 0.51});
    struct mesh mesh = cleaned(&model);
    assert_true(fabs(mesh.grid.units_per_m - 8900) < 1e-6);
    for (size_t i = 0; i < mesh.point_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            double units = (mesh.points[i][axis] - mesh.grid.origin_m[axis]) * mesh.grid.units_per_m;
            assert_true(fabs(units - round(units)) < 1e-6);
            assert_true(fabs(units) <= 32767);
        }
    mesh_free(&mesh);
}

static void points_that_no_face_uses_do_not_count(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    TINY(&model, {1e9, 0, 0});
    model.face_count--, model.corner_count--;
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.point_count, 3);
    assert_true(mesh.grid.units_per_m == 32767);
    mesh_free(&mesh);
}

static void points_nearer_than_a_sixteenth_unit_are_welded_to_the_first(void **state)
{
    (void)state;
    struct model model = unit_model();
    TINY(&model, {0.06, 0, 0}, {100, 0, 0}, {100, 100, 0});
    TINY(&model, {0.07, 0, 0}, {100, 0, 0.06}, {100, 100, 0.1});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.point_count, 4 + 2 + 2);
    assert_int_equal(mesh.corners[mesh.polygons[1].first], 0);
    assert_int_not_equal(mesh.corners[mesh.polygons[2].first], 0);
    assert_true(mesh.points[0][0] == 0);
    mesh_free(&mesh);
}

static void welded_points_keep_their_distance(void **state)
{
    (void)state;
    struct random random = {1};
    struct model model = unit_model();
    for (int i = 0; i < 300; i++) {
        double p[3][3];
        for (int k = 0; k < 9; k++)
            p[k / 3][k % 3] = 3000 * (i % 20) + 0.3 * random_unit(&random) + (k == 3 || k == 7 ? 10 : 0);
        tiny_add(&model, 3, (const double(*)[3])p);
    }
    struct mesh mesh = cleaned(&model);
    double weld_m = grid_weld_m(&mesh.grid);
    assert_true(mesh.point_count > 300 && mesh.point_count < 900); /* many, but not all, were welded */
    for (size_t i = 0; i < mesh.point_count; i++)
        for (size_t k = 0; k < i; k++) {
            double d[3];
            for (int axis = 0; axis < 3; axis++)
                d[axis] = mesh.points[i][axis] - mesh.points[k][axis];
            assert_true(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] >= weld_m * weld_m);
        }
    mesh_free(&mesh);
}

static void faces_without_area_are_dropped_and_counted(void **state)
{
    (void)state;
    struct model model = unit_model();
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {200, 0, 0});
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {100, 0, 0.01});
    TINY(&model, {0, 0, 0}, {100, 100, 0}, {0, 0, 0}, {100, 100, 0});
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {50, 0.02, 0});
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {60, 0.04, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.counts.faces, 6);
    assert_int_equal(mesh.counts.zero_area, 2);
    assert_int_equal(mesh.counts.too_small, 2); /* they had one in the file */
    assert_int_equal(mesh.polygon_count, 2);
    assert_int_equal(mesh.polygons[1].face, 6);
    for (uint32_t face = 1; face <= 6; face++)
        assert_int_equal(mesh.merged_into[face], face == 1 || face == 6 ? face : 0);
    mesh_free(&mesh);
}

static void repeated_corners_and_spikes_are_dropped(void **state)
{
    (void)state;
    struct model model = unit_model();
    TINY(&model, {0, 0, 0}, {0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0.01, 0, 0});
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {900, 0, 0}, {100, 0, 0}, {100, 100, 0});
    TINY(&model, {0, 0, 0}, {900, 0, 0}, {100, 0, 0}, {100, 100, 0});
    struct mesh mesh = cleaned(&model);
    for (int i = 1; i <= 3; i++)
        assert_int_equal(mesh.polygons[i].count, 3);
    assert_int_equal(mesh.counts.zero_area + mesh.counts.concave + mesh.counts.non_planar, 0);
    mesh_free(&mesh);
}

static void straight_corners_are_kept(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.polygon_count, 1);
    assert_int_equal(mesh.polygons[0].count, 6);
    mesh_free(&mesh);
}

/* A straight side that leaves the plane a little is no reason to cut a face. */
static void straight_corners_may_leave_the_plane_a_little(void **state)
{
    (void)state;
    struct model model = unit_model();
    TINY(&model, {0, 0, 0}, {50, 0, 0.4}, {100, 0, 0}, {100, 100, 0}, {50, 100, 0.4}, {0, 100, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(pieces_of(&mesh, 2), 1);
    mesh_free(&mesh);
}

static void faces_off_their_plane_by_over_half_a_unit_are_triangulated(void **state)
{
    (void)state;
    struct model model = unit_model();
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {100, 100, 1.9}, {0, 100, 0}); /* 0.475 off */
    TINY(&model, {0, 0, 0}, {100, 0, 0}, {100, 100, 2.1}, {0, 100, 0}); /* 0.525 off */
    struct mesh mesh = cleaned(&model);
    assert_int_equal(pieces_of(&mesh, 2), 1);
    assert_int_equal(pieces_of(&mesh, 3), 2);
    assert_int_equal(mesh.counts.non_planar, 1);
    assert_int_equal(mesh.counts.concave, 0);
    assert_int_equal(mesh.merged_into[3], 3);
    mesh_free(&mesh);
}

static void concave_faces_are_triangulated(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.counts.concave, 1);
    assert_int_equal(mesh.polygon_count, 4);
    assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
    assert_true(fabs(mesh_area_m2(&mesh) - 3) < 1e-12);
    mesh_free(&mesh);
}

static void stars_that_go_round_twice_are_not_convex(void **state)
{
    (void)state;
    double star[5][3];
    for (int i = 0; i < 5; i++) {
        double angle = 2 * 3.14159265358979 * 2 * i / 5;
        star[i][0] = cos(angle), star[i][1] = sin(angle), star[i][2] = 0;
    }
    struct model model = {0};
    tiny_add(&model, 5, (const double(*)[3])star);
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.counts.concave, 1);
    assert_int_equal(mesh.polygon_count, 3);
    mesh_free(&mesh);
}

static void bow_ties_are_triangulated(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.counts.concave, 1);
    assert_int_equal(mesh.polygon_count, 2);
    const uint32_t corners[4] = {0, 1, 2, 3};
    const struct loop loop = {mesh.points, corners, 4};
    const struct loop_plane plane = loop_plane_of(&loop); /* although the two halves' areas cancel out */
    assert_true(plane.normal[0] == 0 && plane.normal[1] == 0 && fabs(plane.normal[2]) == 1);
    mesh_free(&mesh);
}

/* A corner every few degrees at random distances, in a tilted plane, with straight corners. */
static double add_random_star(struct model *model, struct random *random)
{
    double places[64][3], area = 0;
    size_t count = (size_t)random_in(random, 3, 32) * 2;
    for (size_t i = 0; i < count; i += 2) {
        double angle = 2 * 3.14159265358979 * (double)i / (double)count, r = 0.2 + random_unit(random);
        places[i][0] = r * cos(angle), places[i][1] = r * sin(angle);
    }
    for (size_t i = 0; i < count; i += 2)
        for (int axis = 0; axis < 2; axis++)
            places[i + 1][axis] = (places[i][axis] + places[(i + 2) % count][axis]) / 2;
    for (size_t i = 0; i < count; i++)
        area += places[i][0] * places[(i + 1) % count][1] - places[i][1] * places[(i + 1) % count][0];
    for (size_t i = 0; i < count; i++)
        places[i][2] = 0.6 * places[i][0] - 0.9 * places[i][1];
    tiny_add(model, count, (const double(*)[3])places);
    return fabs(area) / 2 * sqrt(1 + 0.6 * 0.6 + 0.9 * 0.9);
}

static void triangulation_keeps_area_and_orientation(void **state)
{
    (void)state;
    struct random random = {7};
    size_t concave = 0;
    for (int run = 0; run < 2000; run++) {
        struct model model = {0};
        double area_m2 = add_random_star(&model, &random);
        struct mesh mesh = cleaned(&model);
        assert_true(fabs(mesh_area_m2(&mesh) - area_m2) < 1e-4 * area_m2);
        assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
        for (size_t i = 0; i < mesh.polygon_count; i++) {
            const uint32_t *c = &mesh.corners[mesh.polygons[i].first];
            const double *p = mesh.points[c[0]], *q = mesh.points[c[1]], *r = mesh.points[c[2]];
            assert_true((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > -1e-9);
        }
        concave += mesh.counts.concave;
        mesh_free(&mesh);
    }
    assert_true(concave > 1500);
}

static void a_model_of_zero_area_is_refused(void **state)
{
    (void)state;
    struct model model;
    struct error err;
    assert_true(model_import("tests/models/no_area.obj", &model, &err));
    assert_refused(&model, "no face has an area: the corners of each are on one line");
    model = (struct model){0};
    TINY(&model, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    assert_refused(&model, "no face has an area: all corners are at one place");
}

static void an_outlier_that_squeezes_the_rest_is_refused(void **state)
{
    (void)state;
    struct model model;
    struct error err;
    assert_true(model_import("tests/models/outlier.obj", &model, &err));
    assert_refused(&model, "face 6 has a corner at (0, 1e+06, 1), so far out that the rest of the model would be "
                           "0.066 units wide, of 65534");
}

static void a_thousand_times_farther_out_is_an_outlier(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {900, 900, 0});
    struct mesh mesh = cleaned(&model);
    mesh_free(&mesh);
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1100, 0});
    assert_refused(&model, "face 1 has a corner at (0, 1100, 0), so far out that the rest of the model would be "
                           "60 units wide, of 65534");
}

/* However many faces share it, and however often an importer repeats it. */
static void one_outlier_of_many_faces_is_still_one(void **state)
{
    (void)state;
    struct model model = {0};
    for (int i = 0; i < 12; i++)
        TINY(&model, {0.1 * i, 0, 0}, {0.1 * (i + 1), 0, 0}, {0, 1e6, 0});
    assert_refused(&model, "face 1 has a corner at (0, 1e+06, 0), so far out that the rest of the model would be "
                           "0.066 units wide, of 65534");
}

/* A few small things in a large empty hall are a scene, not outliers. */
static void large_scenes_with_small_things_are_accepted(void **state)
{
    (void)state;
    struct model model = {0};
    TINY(&model, {-500, 0, -500}, {-500, 0, 500}, {500, 0, 500}, {500, 0, -500});
    for (int i = 0; i < 100; i++)
        TINY(&model, {0.01 * i, 0, 0}, {0.01 * i, 0, 1}, {0.01 * i, 1, 1});
    struct mesh mesh = cleaned(&model);
    assert_int_equal(mesh.polygon_count, 101);
    mesh_free(&mesh);
}

static void a_list_of_polygons_refuses_to_outgrow_its_indices(void **state)
{
    (void)state;
    const uint32_t corners[3] = {0, 1, 2};
    struct polygon_list list = {.corner_count = ((size_t)1 << 28) - 2};
    struct mesh mesh = {.polygon_count = 7};
    struct error err;
    polygon_list_add(&list, corners, 3, &(struct mesh_polygon){.face = 1});
    assert_false(polygon_list_move(&list, &mesh, &err));
    assert_string_equal(err.text, "the mesh has more than 268435456 corners");
    assert_int_equal(mesh.polygon_count, 7);
}

static void benchmark_scenes_are_clean_already(void **state)
{
    (void)state;
    const char *const paths[3] = {"sim/scenes/rooms.obj", "sim/scenes/rooms-tilted.obj", "sim/scenes/teapot.obj"};
    const size_t polygons[3] = {1392, 1392, 992}, points[3] = {2208, 2208, 529};
    for (int i = 0; i < 3; i++) {
        struct mesh mesh = cleaned_file(paths[i]);
        assert_int_equal(mesh.polygon_count, polygons[i]);
        assert_int_equal(mesh.point_count, points[i]);
        assert_int_equal(mesh.counts.zero_area + mesh.counts.non_planar + mesh.counts.concave, 0);
        assert_int_equal(mesh_bad_corners(&mesh, 0.5), 0);
        mesh_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_grid_fits_the_longest_side_exactly),
        cmocka_unit_test(corners_on_whole_centimetres_round_without_error),
        cmocka_unit_test(points_that_no_face_uses_do_not_count),
        cmocka_unit_test(points_nearer_than_a_sixteenth_unit_are_welded_to_the_first),
        cmocka_unit_test(welded_points_keep_their_distance),
        cmocka_unit_test(faces_without_area_are_dropped_and_counted),
        cmocka_unit_test(repeated_corners_and_spikes_are_dropped),
        cmocka_unit_test(straight_corners_are_kept),
        cmocka_unit_test(straight_corners_may_leave_the_plane_a_little),
        cmocka_unit_test(faces_off_their_plane_by_over_half_a_unit_are_triangulated),
        cmocka_unit_test(concave_faces_are_triangulated),
        cmocka_unit_test(stars_that_go_round_twice_are_not_convex),
        cmocka_unit_test(bow_ties_are_triangulated),
        cmocka_unit_test(triangulation_keeps_area_and_orientation),
        cmocka_unit_test(a_model_of_zero_area_is_refused),
        cmocka_unit_test(an_outlier_that_squeezes_the_rest_is_refused),
        cmocka_unit_test(a_thousand_times_farther_out_is_an_outlier),
        cmocka_unit_test(one_outlier_of_many_faces_is_still_one),
        cmocka_unit_test(large_scenes_with_small_things_are_accepted),
        cmocka_unit_test(a_list_of_polygons_refuses_to_outgrow_its_indices),
        cmocka_unit_test(benchmark_scenes_are_clean_already),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
