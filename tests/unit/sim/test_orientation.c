/* SPDX-License-Identifier: MIT
 *
 * Which axis is up and which side of a face is outside: models written here as a maker's program would write them, in
 * every turn; and pictures that are palettes. */
#include "base/vec3.h"
#include "model/pose.h"
#include "model/winding.h"
#include "readers/flat_texture.h"
#include "readers/model_read.h"
#include "readers/source.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-orientation-XXXXXX";

static int enter_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **state)
{
    (void)state;
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

/* A pyramid whose tip is on an axis, 1 or 2, on a square base of 2 by 2 there; clockwise if so asked. */
struct pyramid {
    int up;
    double height;
    bool clockwise, open;
};

static const int FACES[6][3] = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

/* Right-handed with z up; y up is the same turned. */
static void place(const struct pyramid *pyramid, int corner, double at[3])
{
    static const double square[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, 0}};
    const double x = square[corner][0], across = square[corner][1], height = corner == 4 ? pyramid->height : 0;
    at[0] = x;
    at[1] = pyramid->up == 2 ? across : height;
    at[2] = pyramid->up == 2 ? height : -across;
}

static void write_corner(FILE *file, const struct pyramid *pyramid, int corner, bool is_stl)
{
    double at[3];
    place(pyramid, corner, at);
    fprintf(file, is_stl ? "vertex %g %g %g\n" : "v %g %g %g\n", at[0], at[1], at[2]);
}

static void write_stl(const char *path, const struct pyramid *pyramid)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs("solid made\n", file);
    for (int i = pyramid->open ? 2 : 0; i < 6; i++) {
        fputs("facet normal 0 0 0\nouter loop\n", file);
        for (int k = 0; k < 3; k++)
            write_corner(file, pyramid, FACES[i][pyramid->clockwise ? 2 - k : k], true);
        fputs("endloop\nendfacet\n", file);
    }
    fputs("endsolid made\n", file);
    fclose(file);
}

static void write_obj(const char *path, const struct pyramid *pyramid)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < 5; i++)
        write_corner(file, pyramid, i, false);
    for (int i = pyramid->open ? 2 : 0; i < 6; i++)
        fprintf(file, "f %d %d %d\n", FACES[i][pyramid->clockwise ? 2 : 0] + 1, FACES[i][1] + 1,
                FACES[i][pyramid->clockwise ? 0 : 2] + 1);
    fclose(file);
}

static struct model taken(const char *path, const struct orientation *orientation)
{
    struct model model;
    struct error err;
    if (!model_read(path, orientation, &model, &err)) fail_msg("%s", err.text);
    if (!source_take(path, &model, &err)) fail_msg("%s", err.text);
    unlink(path);
    return model;
}

/* Which axis its tip is on, with its sign. */
static int tip_of(const struct model *model, double height)
{
    for (size_t i = 0; i < model->point_count; i++)
        for (int axis = 0; axis < 3; axis++)
            if (fabs(fabs(model->points[i][axis]) - height) < 1e-9) return model->points[i][axis] > 0 ? axis : -axis;
    return -9;
}

static void assert_notice(const struct model *model, const char *words)
{
    if (!*words && *model->notice) fail_msg("notice: %s", model->notice);
    if (*words && !strstr(model->notice, words)) fail_msg("'%s' is not in notice '%s'", words, model->notice);
}

static void assert_up(const struct pyramid *pyramid, const char *path, enum model_up up, int tip, const char *notice)
{
    const struct orientation orientation = {.up = up};
    if (strcasecmp(strrchr(path, '.'), ".stl") == 0)
        write_stl(path, pyramid);
    else
        write_obj(path, pyramid);
    struct model model = taken(path, &orientation);
    assert_int_equal(tip_of(&model, pyramid->height), tip);
    assert_false(winding_is_clockwise(&model));
    assert_notice(&model, notice);
    model_free(&model);
}

/* Tests ------------------------------------------------------------------------------------------------------------ */

static void stl_files_stand_on_what_is_flat(void **state)
{
    (void)state;
    assert_up(&(struct pyramid){.up = 2, .height = 3}, "a.stl", UP_BY_EVIDENCE, 1, "z is up, it stands on its least z");
    assert_up(&(struct pyramid){.up = 1, .height = 3}, "b.STL", UP_BY_EVIDENCE, 1, "y is up, it stands on its least y");
    assert_up(&(struct pyramid){.up = 2, .height = 0.25}, "a.stl", UP_BY_EVIDENCE, 1, "z is up");
    assert_up(&(struct pyramid){.up = 2, .height = 3, .open = true}, "a.stl", UP_BY_EVIDENCE, 1,
              "as in most files of that kind");
}

static void what_is_said_counts(void **state)
{
    (void)state;
    assert_up(&(struct pyramid){.up = 2, .height = 3}, "a.stl", UP_Y, 2, "");
    assert_up(&(struct pyramid){.up = 1, .height = 3}, "a.stl", UP_Z, -2, "");
    assert_up(&(struct pyramid){.up = 2, .height = 3}, "a.obj", UP_Z, 1, "");
    assert_up(&(struct pyramid){.up = 2, .height = 3}, "a.obj", UP_Y, 2, "");
}

static void other_files_have_y_up_and_those_that_lie_are_noticed(void **state)
{
    (void)state;
    assert_up(&(struct pyramid){.up = 1, .height = 3}, "a.obj", UP_BY_EVIDENCE, 1, "");
    assert_up(&(struct pyramid){.up = 2, .height = 3}, "a.obj", UP_BY_EVIDENCE, 2, "--up z");
    assert_up(&(struct pyramid){.up = 2, .height = 3, .open = true}, "a.obj", UP_BY_EVIDENCE, 2, "");
    assert_up(&(struct pyramid){.up = 2, .height = 0.001}, "a.obj", UP_BY_EVIDENCE, 2, ""); /* a flat thing */
}

static void a_closed_model_that_runs_clockwise_is_noticed(void **state)
{
    (void)state;
    const struct pyramid inside_out = {.up = 1, .height = 3, .clockwise = true};
    write_obj("a.obj", &inside_out);
    struct model model = taken("a.obj", &(struct orientation){0});
    assert_notice(&model, "--reverse-faces");
    model_free(&model);
    write_obj("a.obj", &inside_out);
    model = taken("a.obj", &(struct orientation){.reverse_faces = true});
    assert_false(winding_is_clockwise(&model));
    assert_notice(&model, "");
    model_free(&model);
    write_obj("a.obj", &(struct pyramid){.up = 1, .height = 3});
    model = taken("a.obj", &(struct orientation){.reverse_faces = true});
    assert_notice(&model, "leave out --reverse-faces");
    model_free(&model);
}

static void what_is_open_or_two_sided_has_no_inside(void **state)
{
    (void)state;
    write_obj("a.obj", &(struct pyramid){.up = 1, .height = 3, .clockwise = true, .open = true});
    struct model model = taken("a.obj", &(struct orientation){0});
    assert_notice(&model, "");
    model_free(&model);
    write_obj("a.obj", &(struct pyramid){.up = 1, .height = 3, .clockwise = true});
    model = taken("a.obj", &(struct orientation){.two_sided = true});
    for (size_t i = 0; i < model.face_count; i++)
        assert_true(model.faces[i].two_sided);
    assert_notice(&model, "");
    model_free(&model);
}

/* Both turned, in both formats: the reference's own reader sees the same corners (taken() asks it). */
static void the_reference_follows(void **state)
{
    (void)state;
    const struct orientation both = {.up = UP_Z, .reverse_faces = true};
    write_stl("a.stl", &(struct pyramid){.up = 2, .height = 3, .clockwise = true});
    struct model model = taken("a.stl", &both);
    assert_int_equal(tip_of(&model, 3), 1);
    for (size_t i = 0; i < model.point_count; i++)
        assert_memory_equal(model.points[i], model.source_points[i], sizeof model.points[i]);
    model_free(&model);
}

static void write_off(const char *path, bool open, bool clockwise)
{
    const struct pyramid pyramid = {.up = 1, .height = 3};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "OFF\n5 %d 0\n", open ? 4 : 6);
    for (int i = 0; i < 5; i++) {
        double at[3];
        place(&pyramid, i, at);
        fprintf(file, "%g %g %g\n", at[0], at[1], at[2]);
    }
    for (int i = open ? 2 : 0; i < 6; i++)
        fprintf(file, "3 %d %d %d\n", FACES[i][clockwise ? 2 : 0], FACES[i][1], FACES[i][clockwise ? 0 : 2]);
    fclose(file);
}

/* Faces of OFF files have two sides, as they are read: nothing is hidden, but light asks which is outside. */
static void what_is_lit_from_inside_is_noticed(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        write_off("a.off", way & 1, way & 2);
        struct model model;
        struct error err;
        assert_true(model_read("a.off", &(struct orientation){0}, &model, &err));
        unlink("a.off");
        assert_notice(&model, way == 2 ? "it is lit from inside: --reverse-faces" : "");
        model_free(&model);
    }
}

/* Formats with a custom: a point one up by it, as the importer hands it over, and where it is then. */
static void customs_of_formats_and_what_is_said_decide(void **state)
{
    (void)state;
    static const struct {
        enum up_custom custom;
        enum model_up up;
        double is[3];
        const char *notice;
    } cases[] = {
        {CUSTOM_Y, UP_BY_EVIDENCE, {1, 2, 3}, ""},
        {CUSTOM_Z, UP_BY_EVIDENCE, {1, 3, -2}, "--up y, if not"},
        {CUSTOM_ALWAYS_Z, UP_BY_EVIDENCE, {1, 3, -2}, ""},
        {CUSTOM_ALWAYS_Z, UP_Y, {1, 2, 3}, ""},
        {CUSTOM_ALWAYS_Z, UP_Z, {1, 3, -2}, ""},
        {CUSTOM_TURNED, UP_BY_EVIDENCE, {1, 2, 3}, "--up y, if not"},
        {CUSTOM_TURNED, UP_Z, {1, 2, 3}, ""},
        {CUSTOM_TURNED, UP_Y, {1, -3, 2}, ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double points[4][3] = {{1, 2, 3}, {0, 0, 0}, {5, 0, 1}, {0, 5, 2}};
        uint32_t corners[3] = {1, 2, 3};
        struct model_face face = {.count = 3};
        struct model model = {
            .points = points, .point_count = 4, .corners = corners, .corner_count = 3, .faces = &face, .face_count = 1};
        orientation_apply(&(struct orientation){.up = cases[i].up}, cases[i].custom, &model);
        assert_memory_equal(points[0], cases[i].is, sizeof points[0]);
        assert_notice(&model, cases[i].notice);
    }
}

/* A mover's own coordinates stay: where it is placed turns. */
static void movers_turn_with_the_model(void **state)
{
    (void)state;
    double points[1][3] = {{0.5, -2, 7}};
    uint32_t corners[1] = {0};
    struct model_mover mover = {
        .rest = {{1, 2, 3}, {0.18257418583505536, 0.3651483716701107, 0.5477225575051661, 0.7302967433402214}}};
    struct model_key key = {0, {{-4, 5, 6}, {0.5, -0.5, 0.5, 0.5}}};
    struct model model = {.points = points,
                          .point_count = 1,
                          .corners = corners,
                          .corner_count = 1,
                          .movers = &mover,
                          .mover_count = 1,
                          .keys = &key,
                          .key_count = 1};
    const struct model_pose before[2] = {mover.rest, key.pose};
    orientation_apply(&(struct orientation){.up = UP_Z}, CUSTOM_Y, &model);
    const struct model_pose after[2] = {mover.rest, key.pose};
    for (int i = 0; i < 2; i++) {
        const double own[3] = {0.3, -1.7, 2.9};
        double was[3], is[3];
        pose_leave(&before[i], own, was);
        pose_leave(&after[i], own, is);
        orientation_point(&model, was);
        for (int axis = 0; axis < 3; axis++)
            assert_true(fabs(was[axis] - is[axis]) < 1e-12);
    }
    assert_true(points[0][1] == 7 && points[0][2] == 2);
}

/* Palettes --------------------------------------------------------------------------------------------------------- */

enum { SIDE = 4 };

/* One triangle that shows a part of a picture of 4x4 texels: its left half is red, its right one blue, but for a green
 * texel at the top right. */
struct shown {
    struct picture picture;
    uint32_t pixels[SIDE * SIDE];
    double points[3][3], uvs[3][2];
    uint32_t corners[3];
    struct model_face face;
    struct model model;
};

static void show(struct shown *shown, const double uvs[3][2])
{
    *shown = (struct shown){.corners = {0, 1, 2}};
    for (int i = 0; i < SIDE * SIDE; i++)
        shown->pixels[i] = i == SIDE - 1 ? 0x00FF00 : i % SIDE < SIDE / 2 ? 0xFF0000 : 0x0000FF;
    shown->picture = (struct picture){.w_px = SIDE, .h_px = SIDE, .pixels = shown->pixels, .faces = 1};
    shown->face = (struct model_face){.count = 3, .colour = 0x80FFFF, .picture = 1};
    memcpy(shown->uvs, uvs, sizeof shown->uvs);
    shown->model = (struct model){.points = shown->points,
                                  .uvs = shown->uvs,
                                  .point_count = 3,
                                  .corners = shown->corners,
                                  .corner_count = 3,
                                  .faces = &shown->face,
                                  .face_count = 1,
                                  .pictures = &shown->picture,
                                  .picture_count = 1};
}

static void faces_of_one_colour_lose_their_picture(void **state)
{
    (void)state;
    static const struct {
        double uvs[3][2];
        uint32_t colour; /* 0: it keeps the picture */
    } cases[] = {
        {{{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}}, 0x800000},  /* all on one point */
        {{{0.3, 0.3}, {0.4, 0.3}, {0.3, 0.4}}, 0x800000},  /* in one texel */
        {{{0, 0}, {0.5, 0}, {0, 1}}, 0x800000},            /* the left half, to its very edge */
        {{{-2, 3}, {-1.5, 3}, {-2, 3.9}}, 0x800000},       /* the same, repeated */
        {{{0.5, 0.25}, {1, 0.25}, {0.75, 1}}, 0x0000FF},   /* the right half below the green texel */
        {{{0.8, 0.1}, {0.9, 0.1}, {0.8, 0.2}}, 0x00FF00},  /* that texel */
        {{{0.5, 0}, {1, 0.25}, {0.75, 1}}, 0},             /* both */
        {{{0.4, 0.5}, {0.6, 0.5}, {0.5, 0.6}}, 0},         /* across the middle */
        {{{(double)NAN, 0.1}, {0.1, 0.1}, {0.1, 0.1}}, 0}, /* no coordinates */
        {{{1e300, 0.1}, {1e300, 0.1}, {1e300, 0.1}}, 0},   /* beyond all reason */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct shown shown;
        show(&shown, cases[i].uvs);
        const bool is_flat = cases[i].colour != 0;
        assert_int_equal(flat_texture_find(&shown.model), is_flat);
        assert_int_equal(shown.face.picture, !is_flat);
        assert_int_equal(shown.picture.faces, !is_flat);
        assert_int_equal(shown.face.colour, is_flat ? cases[i].colour : 0x80FFFF);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stl_files_stand_on_what_is_flat),
        cmocka_unit_test(what_is_said_counts),
        cmocka_unit_test(other_files_have_y_up_and_those_that_lie_are_noticed),
        cmocka_unit_test(a_closed_model_that_runs_clockwise_is_noticed),
        cmocka_unit_test(what_is_open_or_two_sided_has_no_inside),
        cmocka_unit_test(what_is_lit_from_inside_is_noticed),
        cmocka_unit_test(customs_of_formats_and_what_is_said_decide),
        cmocka_unit_test(the_reference_follows),
        cmocka_unit_test(movers_turn_with_the_model),
        cmocka_unit_test(faces_of_one_colour_lose_their_picture),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
