/* SPDX-License-Identifier: MIT
 *
 * What a grid does to faces: which harm is refused, which is none, and what --drop-small leaves out. */
#include "compiler/compile.h"
#include "core/core.h"
#include "model/original.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;
static const struct compile_options FAST = {
    .tolerance_units = 0.5, .tree = TREE_BSP, .splitter = "fewest", .coordinates = COORDINATES_16};

static struct compile_options with(const struct core *core, bool drop_small)
{
    struct compile_options options = FAST;
    options.core = core;
    options.drop_small = drop_small;
    return options;
}

/* A floor of 65.534 km: a unit of the grid is a metre. Its corners are on the grid. */
static struct model floor_model(void)
{
    struct model model = {0};
    TINY(&model, {-32767, 0, -32767}, {-32767, 0, 32767}, {32767, 0, 32767}, {32767, 0, -32767});
    return model;
}

static void add_box(struct model *model, double x_m, double edge_m)
{
    const double low_m[3] = {x_m, 0.3, 20.4}, high_m[3] = {x_m + edge_m, 0.3 + edge_m, 20.4 + edge_m};
    boxes_add_solid(model, low_m, high_m);
}

/* A strip along x, `width_m` wide, that begins at z_m. */
static void add_strip(struct model *model, double z_m, double width_m)
{
    TINY(model, {0, 9, z_m}, {0, 9, z_m + width_m}, {4000, 9, z_m + width_m}, {4000, 9, z_m});
}

/* Compiles; how many faces of the model were at fault, of those that were left out. */
static bool compiles(struct model *model, const struct compile_options *options, size_t *left_out, char text[512])
{
    struct compiled scene;
    struct error err = {""};
    const bool ok = compile_part(model, NULL, options, &scene, &err);
    *left_out = ok ? scene.report.left_out : 0;
    strcpy(text, err.text);
    if (ok) compiled_free(&scene);
    return ok;
}

static void expect_kept(struct model *model, const struct core *core)
{
    const struct compile_options options = with(core, false);
    char text[512];
    size_t left_out;
    if (!compiles(model, &options, &left_out, text)) fail_msg("%s", text);
    assert_int_equal(left_out, 0);
    model_free(model);
}

static void expect_refused(struct model *model, const struct core *core, const char *part)
{
    const struct compile_options options = with(core, false);
    char text[512];
    size_t left_out;
    assert_false(compiles(model, &options, &left_out, text));
    if (!strstr(text, part)) fail_msg("'%s' does not say '%s'", text, part);
    model_free(model);
}

static void expect_left_out(struct model *model, const struct core *core, size_t faces)
{
    const struct compile_options options = with(core, true);
    char text[512];
    size_t left_out;
    if (!compiles(model, &options, &left_out, text)) fail_msg("%s", text);
    assert_int_equal(left_out, faces);
    model_free(model);
}

static void a_box_below_a_unit_is_refused_and_named(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.2, 0.4);
    expect_refused(&model, &core_fast, "face 2 (0.4 m), 3 (0.4 m), 4 (0.4 m) ...: 6 of 7 faces would vanish");
    model = floor_model();
    add_box(&model, 10.2, 0.4);
    expect_refused(&model, &core_fast, "units of 1 m; take --coordinates 32, or leave it out by --drop-small");
}

static void a_box_that_stays_but_loses_its_shape_is_refused(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.3, 5.4); /* corners move by up to 0.7 units: an eighth of it */
    expect_refused(&model, &core_fast, "(5.4 m)");
    model = floor_model();
    add_box(&model, 10.3, 54.0); /* a 77th */
    expect_kept(&model, &core_fast);
}

static void exact_holds_what_its_fractions_hold_and_is_recommended_there(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.3, 5.4);
    expect_refused(&model, &core_fast, "; take --coordinates 32, take --precision exact, or leave");
    model = floor_model();
    add_box(&model, 10.3, 5.4);
    expect_kept(&model, &core_exact);
}

/* Fractions place its corners, but the planes' tolerance is as large as it is. */
static void exact_refuses_what_its_planes_do_not_hold(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.3, 0.4);
    expect_refused(&model, &core_exact, "(0.4 m)");
    model = floor_model();
    add_box(&model, 10.3, 0.4);
    const struct compile_options options = with(&core_fast, false);
    char text[512];
    size_t left_out;
    assert_false(compiles(&model, &options, &left_out, text));
    assert_null(strstr(text, "--precision"));
    model_free(&model);
}

static void what_is_on_the_grid_does_not_move(void **state)
{
    (void)state;
    struct model model = floor_model();
    const double low_m[3] = {10, 0, 10}, high_m[3] = {14, 4, 14};
    boxes_add_solid(&model, low_m, high_m); /* four units */
    expect_kept(&model, &core_fast);
}

/* Saddles, and an n-gon that is bent twice: as large as a tenth of the floor, and off every plane by more than a grid
 * unit, as by a tenth of their own size. Their triangles are drawn where they are. */
static void bent_faces_are_judged_by_their_own_triangles(void **state)
{
    (void)state;
    for (int up = 1; up <= 3000; up *= 10) {
        const double half = 3000, y = 5, high = y + up;
        struct model model = floor_model();
        TINY(&model, {-half, y, -half}, {-half, high, half}, {half, y, half}, {half, high, -half});
        expect_kept(&model, up % 3 ? &core_fast : &core_exact);
        model = floor_model();
        TINY(&model, {-half, y, 0}, {-half, high, half}, {0, y, 2 * half}, {half, high, half}, {half, y, 0},
             {0, high, -half});
        expect_kept(&model, &core_fast);
        model = floor_model();
        TINY(&model, {-half, y, -half}, {-half, high, half}, {half, y, half}, {half, high, -half});
        expect_left_out(&model, &core_fast, 0);
    }
}

/* The second triangle of a bent face is one with its neighbour: the face has planes in two polygons. */
static void a_bent_face_may_be_merged_in_parts(void **state)
{
    (void)state;
    struct model model = floor_model();
    TINY(&model, {0, 9, 0}, {0, 9, 2000}, {2000, 9, 2000}, {2000, 900, 0});
    TINY(&model, {0, 9, 0}, {-2000, 9, 0}, {0, 9, 2000});
    TINY(&model, {0, 9, 2000}, {0, 9, 4000}, {2000, 9, 2000});
    expect_kept(&model, &core_fast);
}

/* Where the renderer's near plane cannot be nearer than 1.75 units at 45 degrees to either side, a box of two is cut
 * away by a lens of 30 degrees to either side, from as near as it is large. */
static void what_the_near_plane_cuts_away_is_refused_unless_it_was_chosen(void **state)
{
    (void)state;
    const double low_m[3] = {10, 0, 10}, high_m[3] = {12, 2, 12};
    struct compile_options options = with(&core_fast, false);
    char text[512];
    size_t left_out;
    struct model model = floor_model();
    boxes_add_solid(&model, low_m, high_m);
    expect_refused(&model, &core_exact, "6 of 7 faces are smaller than the distance within which nothing is drawn");
    model = floor_model();
    boxes_add_solid(&model, low_m, high_m);
    options.near_m = 3.05; /* as the message says */
    assert_false(compiles(&model, &FAST, &left_out, text));
    assert_non_null(strstr(text, "--near 3.05"));
    if (!compiles(&model, &options, &left_out, text)) fail_msg("%s", text);
    options = with(&core_fast, true); /* from farther away they are right */
    if (!compiles(&model, &options, &left_out, text)) fail_msg("%s", text);
    assert_int_equal(left_out, 0);
    model_free(&model);
}

/* 0.3 m are half a pixel at 130 m, and more from the default near plane. */
static void the_near_plane_that_was_chosen_decides_what_can_be_seen(void **state)
{
    (void)state;
    struct compile_options options = with(&core_fast, false);
    char text[512];
    size_t left_out;
    struct model model = floor_model();
    add_box(&model, 10.2, 0.3);
    options.near_m = 50;
    assert_false(compiles(&model, &options, &left_out, text));
    options.near_m = 130;
    if (!compiles(&model, &options, &left_out, text)) fail_msg("%s", text);
    assert_int_equal(left_out, 0);
    model_free(&model);
}

/* A sliver between two wide strips: they take its place. Alone it is missed. */
static void a_sliver_is_no_loss_where_its_neighbours_close_up(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_strip(&model, 100.0, 50.0);
    add_strip(&model, 150.0, 0.2);
    add_strip(&model, 150.2, 50.0);
    expect_kept(&model, &core_fast);
    model = floor_model();
    add_strip(&model, 150.0, 0.2);
    expect_refused(&model, &core_fast, "face 2 (4e+03 m): 1 of 2 faces would vanish");
}

/* A rope on the ground vanishes, though the ground is near it. */
static void what_merely_lies_near_takes_no_place(void **state)
{
    (void)state;
    struct model model = floor_model();
    TINY(&model, {0, 0.1, 9}, {0, 0.1, 9.2}, {4000, 0.1, 9.2}, {4000, 0.1, 9});
    expect_refused(&model, &core_fast, "1 of 2 faces");
}

/* Facets of a unit or two, but of one smooth ball of 80 m. */
static void facets_of_a_smooth_hull_are_judged_as_one_surface(void **state)
{
    enum { RINGS = 48 };
    (void)state;
    struct model model = floor_model();
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < 2 * RINGS; k++) {
            double corners[4][3];
            for (int c = 0; c < 4; c++) {
                const double polar = PI * (i + (c == 1 || c == 2)) / RINGS, around = PI * (k + (c >= 2)) / RINGS;
                const double at[3] = {sin(polar) * cos(around), cos(polar), sin(polar) * sin(around)};
                for (int axis = 0; axis < 3; axis++)
                    corners[c][axis] = 60.123 + 40.0 * at[axis];
            }
            if (i == 0)
                tiny_add(&model, 3, (const double(*)[3])corners);
            else if (i == RINGS - 1)
                TINY(&model, {corners[0][0], corners[0][1], corners[0][2]},
                     {corners[1][0], corners[1][1], corners[1][2]}, {corners[3][0], corners[3][1], corners[3][2]});
            else
                tiny_add(&model, 4, (const double(*)[3])corners);
        }
    expect_kept(&model, &core_fast);
}

static void faces_without_area_in_the_file_are_no_loss(void **state)
{
    (void)state;
    struct model model = floor_model();
    TINY(&model, {0, 1, 0}, {50, 1, 0}, {100, 1, 0});
    TINY(&model, {7, 1, 0}, {7, 1, 0}, {7, 1, 0});
    add_box(&model, 10.3, 54.0);
    expect_kept(&model, &core_fast);
}

/* Less than a pixel, even from the near plane. */
static void what_no_camera_can_see_is_no_loss(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.2, 0.0004);
    expect_kept(&model, &core_fast);
}

static void all_of_a_small_thing_is_left_out(void **state)
{
    (void)state;
    struct model model = floor_model();
    add_box(&model, 10.3, 54.0);
    add_box(&model, 100.3, 5.4);
    add_box(&model, 110.3, 0.4);
    expect_left_out(&model, &core_fast, 12);
}

static void nothing_but_small_things_are_refused_all_the_same(void **state)
{
    (void)state;
    struct model model = {0};
    const struct compile_options options = with(&core_fast, true);
    char text[512];
    size_t left_out;
    for (int i = 0; i < 8; i++)
        add_box(&model, 65534.0 / 7 * i, 0.4);
    assert_false(compiles(&model, &options, &left_out, text));
    assert_non_null(strstr(text, "too small for the grid"));
    model_free(&model);
}

/* Smaller than what the mesh welds: a reference that saw the welded mesh would miss it as the scene does. */
static void what_is_left_out_is_predicted_to_be_wrong(void **state)
{
    (void)state;
    struct model model = floor_model();
    struct compile_options options = with(&core_fast, true);
    struct compiled scene;
    struct error err;
    options.predict = true;
    for (int i = 0; i < 3; i++) { /* high up, where nothing else is in view */
        const double low_m[3] = {10.0 * i, 300, 20.4}, high_m[3] = {10.0 * i + 0.04, 300.04, 20.44};
        boxes_add_solid(&model, low_m, high_m);
    }
    if (!compile_part(&model, NULL, &options, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(scene.report.left_out, 18);
    assert_int_equal(scene.report.wrong.near_cameras, 24);
    assert_true(scene.report.wrong.near_percent > 0.001); /* the near plane is six units away */
    assert_true(scene.report.wrong.percent < scene.report.wrong.near_percent);
    compiled_free(&scene);
    model_free(&model);
}

static void faces_know_their_patch_and_their_thing(void **state)
{
    (void)state;
    struct model model = floor_model();
    struct mesh mesh;
    struct error err;
    add_box(&model, 10.3, 54.0);
    if (!mesh_clean(&model, &mesh, &err)) fail_msg("%s", err.text);
    const struct original *original = mesh.original;
    assert_int_equal(original->seen_count, 7);
    for (uint32_t i = 0; i < 7; i++) {
        assert_int_equal(original->faces[i].patch, i); /* the sides of a box meet at right angles */
        assert_int_equal(original->faces[i].thing, i ? 1 : 0);
        assert_int_equal(original->faces[i].number, i + 1);
        assert_true(fabs(original->faces[i].size_m - (i ? 54.0 : 65534.0)) < 1e-6);
    }
    assert_int_equal(original->by_size[6], 0); /* the largest comes last */
    mesh_free(&mesh);
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_below_a_unit_is_refused_and_named),
        cmocka_unit_test(a_box_that_stays_but_loses_its_shape_is_refused),
        cmocka_unit_test(bent_faces_are_judged_by_their_own_triangles),
        cmocka_unit_test(a_bent_face_may_be_merged_in_parts),
        cmocka_unit_test(exact_holds_what_its_fractions_hold_and_is_recommended_there),
        cmocka_unit_test(exact_refuses_what_its_planes_do_not_hold),
        cmocka_unit_test(what_is_on_the_grid_does_not_move),
        cmocka_unit_test(what_the_near_plane_cuts_away_is_refused_unless_it_was_chosen),
        cmocka_unit_test(the_near_plane_that_was_chosen_decides_what_can_be_seen),
        cmocka_unit_test(a_sliver_is_no_loss_where_its_neighbours_close_up),
        cmocka_unit_test(what_merely_lies_near_takes_no_place),
        cmocka_unit_test(facets_of_a_smooth_hull_are_judged_as_one_surface),
        cmocka_unit_test(faces_without_area_in_the_file_are_no_loss),
        cmocka_unit_test(what_no_camera_can_see_is_no_loss),
        cmocka_unit_test(all_of_a_small_thing_is_left_out),
        cmocka_unit_test(nothing_but_small_things_are_refused_all_the_same),
        cmocka_unit_test(what_is_left_out_is_predicted_to_be_wrong),
        cmocka_unit_test(faces_know_their_patch_and_their_thing),
    };

    return cmocka_run_group_tests_name("faithful", tests, NULL, NULL);
}
