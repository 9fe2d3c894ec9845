/* SPDX-License-Identifier: MIT
 *
 * Pictures of differences show what was counted: as many red pixels as holes and order errors, amber for the other
 * wrong ones, grey for all that is right. And a few cameras of a path are chosen evenly. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "measure/difference.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { SIDE_PX = 120, FRAMES = 3 };

/* A model whose polygons pass through each other, by farthest points: wrong. */
struct rig {
    struct measure_source source;
    struct compiled scene;
    struct camera_path path;
    struct lens lens;
    struct measure_views views;
    struct measure_candidate candidate;
    struct accuracy accuracy;
};

static int set_up(void **state)
{
    static struct rig rig;
    struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto"};
    struct camera_path all;
    struct error err;

    rig = (struct rig){.views = {&rig.path, &rig.lens, SIDE_PX, SIDE_PX}, .candidate = {&core_fast, &rig.scene}};
    if (!compile_method_parse("depth", &options, &err) ||
        !measure_source_read(&rig.source, "sim/scenes/knot.obj", &options, SIDE_PX, SIDE_PX, &err) ||
        !compile_mesh(&rig.source.mesh, &options, &rig.scene, &err) ||
        !lens_init(&rig.lens, 60, 0.1, SIDE_PX, SIDE_PX, &err) ||
        !camera_path_read("sim/scenes/knot.cam", &all, &err) || !camera_path_few(&all, FRAMES, &rig.path, &err) ||
        !measure_accuracy(&rig.source, &rig.views, &rig.candidate, 1, &rig.accuracy, &err))
        fail_msg("%s", err.text);
    camera_path_free(&all);
    *state = &rig;
    return 0;
}

static int tear_down(void **state)
{
    struct rig *rig = *state;

    measure_source_free(&rig->source);
    compiled_free(&rig->scene);
    camera_path_free(&rig->path);
    return 0;
}

static void frames_are_chosen_evenly(void **state)
{
    (void)state;
    struct viewpoint frames[10];
    struct camera_path all = {.name = (char[]){"path"}, .frames = frames, .count = 10}, few;
    struct error err;
    for (size_t i = 0; i < all.count; i++)
        frames[i] = (struct viewpoint){.line = i};
    for (size_t count = 1; count <= 12; count++) {
        const size_t expected = count < all.count ? count : all.count;
        assert_true(camera_path_few(&all, count, &few, &err));
        assert_string_equal(few.name, "path");
        assert_int_equal(few.count, expected);
        for (size_t i = 0; i < expected; i++)
            assert_int_equal(few.frames[i].line, i * all.count / expected);
        camera_path_free(&few);
    }
}

static void red_is_what_was_counted(void **state)
{
    struct rig *rig = *state;
    struct error err;
    size_t red = 0, amber = 0, grey = 0;
    for (size_t frame = 0; frame < FRAMES; frame++) {
        gdImagePtr image = difference_picture(&rig->source, &rig->candidate, &rig->views, frame, NULL, &err);
        if (!image) fail_msg("%s", err.text);
        for (int pixel = 0; pixel < SIDE_PX * SIDE_PX; pixel++) {
            const int rgb = gdImageGetTrueColorPixel(image, pixel % SIDE_PX, pixel / SIDE_PX) & 0xFFFFFF;
            const int r = rgb >> 16, g = rgb >> 8 & 255, b = rgb & 255;
            if (r == g && g == b)
                grey++;
            else if (r > 4 * g)
                red++;
            else
                amber++;
        }
        gdImageDestroy(image);
    }
    const struct compare_counts *counts = &rig->accuracy.pixels.total;
    assert_true(counts->order > 500);
    assert_int_equal(red, counts->holes);
    assert_int_equal(amber, counts->wrong - counts->holes);
    assert_int_equal(grey, counts->pixels - counts->wrong);
}

static void the_faultiest_frame_is_remembered(void **state)
{
    (void)state;
    struct comparison sum = {0};
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 9});
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 5, .beyond = 2, .holes = 1, .order = 1});
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 6, .beyond = 2, .holes = 1});
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 8});
    assert_int_equal(sum.worst_frame, 0);
    assert_int_equal(sum.faultiest_frame, 2);
    assert_int_equal(sum.total.order, 1);
}

/* Cells side by side, four in a row, below their captions; one without a picture has its caption alone. */
static void sheet_holds_every_picture(void **state)
{
    (void)state;
    enum { W_PX = 50, H_PX = 30, CELLS = 6 };
    struct difference_cell cells[CELLS] = {{NULL, ""}};
    for (int i = 0; i < CELLS; i++) {
        snprintf(cells[i].caption, sizeof cells[i].caption, "cell %d", i);
        if (i == 4) continue;
        cells[i].picture = gdImageCreateTrueColor(W_PX, H_PX);
        gdImageFilledRectangle(cells[i].picture, 0, 0, W_PX - 1, H_PX - 1, 0x100000 * (i + 1) + 7);
    }
    gdImagePtr sheet = difference_sheet(cells, CELLS, W_PX, H_PX);
    assert_non_null(sheet);
    assert_true(gdImageSX(sheet) >= 4 * W_PX && gdImageSX(sheet) < 5 * W_PX);
    for (int i = 0; i < CELLS; i++) {
        int count = 0;
        for (int y = 0; y < gdImageSY(sheet); y++)
            for (int x = 0; x < gdImageSX(sheet); x++)
                count += gdImageGetTrueColorPixel(sheet, x, y) == 0x100000 * (i + 1) + 7;
        assert_int_equal(count, i == 4 ? 0 : W_PX * H_PX);
        if (cells[i].picture) gdImageDestroy(cells[i].picture);
    }
    gdImageDestroy(sheet);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_chosen_evenly),
        cmocka_unit_test(red_is_what_was_counted),
        cmocka_unit_test(the_faultiest_frame_is_remembered),
        cmocka_unit_test(sheet_holds_every_picture),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
