/* SPDX-License-Identifier: MIT
 *
 * From a linker's map and the counting plugin's numbers to the cost of a frame; with a loop that counts
 * wrongly, or frames that are missing, there is no cost. */
#include "base/work_folder.h"
#include "measure/counts.h"
#include "rigs/cmocka_ready.h"
#include "targets/count_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Two stages, a helper, the scene, the target; a long name is broken; relaxation left a note. */
static const char MAP[] = "Discarded input sections\n"
                          " .text.gone     0x00000000       0x10 /tmp/a/firmware/view.o\n"
                          "Linker script and memory map\n"
                          "LOAD /tmp/a/firmware/eye.o\n"
                          ".text           0x00000000     0x400\n"
                          " *(.vectors)\n"
                          " .vectors       0x00000000       0x40 /tmp/cc1.o\n"
                          " .text.count_check_loop\n"
                          "                0x00000040        0x6 /tmp/cc2.o\n"
                          "                0x00000040                count_check_loop\n"
                          " .text.frame_begin\n"
                          "                0x00000048        0x4 /tmp/cc3.o\n"
                          " .text.frame_end\n"
                          "                0x0000004c        0x4 /tmp/cc3.o\n"
                          " .text.done     0x00000050       0x10 /tmp/cc3.o\n"
                          " .text.lim_eye_side.part.0\n"
                          "                0x00000060       0x20 /tmp/a/firmware/eye.o\n"
                          " .text.lim_eye_side\n"
                          "                0x00000080       0x20 /tmp/a/firmware/eye.o\n"
                          " .text.lim_eye_set\n"
                          "                0x000000a0       0x10 /tmp/a/firmware/eye.o\n"
                          " .text.empty    0x000000b0        0x0 /tmp/a/firmware/eye.o\n"
                          " .text.lim_view_remember\n"
                          "                0x000000b0       0x20 /tmp/a/firmware/view.o\n"
                          "                                 0x24 (size before relaxing)\n"
                          " .text.lim_walk_next\n"
                          "                0x000000d0        0x6 /tmp/a/firmware/walk.o\n"
                          " .text          0x000000e0       0x20 /usr/lib/libgcc.a(_divsi3.o)\n"
                          " .rodata.sines  0x00000100       0x40 /tmp/a/firmware/view.o\n"
                          " .rodata.vertices\n"
                          "                0x00000140      0x100 /tmp/a/model.o\n"
                          " .bss.mem       0x20000000      0x200 /tmp/cc3.o\n"
                          " .bss.lim       0x20000200       0x80 /tmp/cc3.o\n"
                          " .comment       0x00000000       0x26 /tmp/a/firmware/eye.o\n";

/* Of each range's first instruction: the second one of lim_walk_next() is an inlined plane test. */
static const char INLINED[] = "0x00000060\nundecided\n/a/eye.c:50\nlim_eye_side\n/a/eye.c:60\n"
                              "0x00000062\nundecided\n/a/eye.c:51\nlim_eye_side\n/a/eye.c:60\n"
                              "0x00000080\nlim_eye_side\n/a/eye.c:58\n"
                              "0x00000082\nlim_eye_side\n/a/eye.c:59\n"
                              "0x000000a0\nlim_eye_set\n/a/eye.c:20\n"
                              "0x000000a2\nfits\n/a/eye.c:12\nlim_eye_set\n/a/eye.c:21\n"
                              "0x000000b0\nlim_view_remember\n/a/view.c:5\n"
                              "0x000000d0\nlim_walk_next\n/a/walk.c:5\n"
                              "0x000000d2\nlim_eye_side\n/a/eye.h:9\nenter\n/a/walk.c:7\nlim_walk_next\n/a/walk.c:8\n"
                              "0x000000d4\nlim_walk_next\n/a/walk.c:9\n";

/* Ranges in the order of addresses, each with its own instructions and its helpers': vectors, loop, frame_begin,
 * frame_end, done; a part of lim_eye_side() (entry, rest), the function (entry, rest), lim_eye_set() (entry, rest);
 * lim_view_remember (entry, rest); walk (all three); libgcc; others. */
enum { RANGES = 18, PLANE_TESTS = 12 };

struct rig {
    struct work_folder folder;
    struct link_map map;
    char path[600], inlined[600];
};

static void write_text(struct rig *rig, const char *name, const char *text)
{
    snprintf(rig->path, sizeof rig->path, "%s/%s", rig->folder.path, name);
    FILE *file = fopen(rig->path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0 && fclose(file) == 0);
}

static int set_up(void **state)
{
    static struct rig rig;
    struct error err;

    rig = (struct rig){0};
    if (!work_folder_make(&rig.folder, &err)) fail_msg("%s", err.text);
    write_text(&rig, "image.map", MAP);
    if (!link_map_read(rig.path, &rig.map, &err)) fail_msg("%s", err.text);
    *state = &rig;
    return 0;
}

static int tear_down(void **state)
{
    struct rig *rig = *state;

    link_map_free(&rig->map);
    work_folder_remove(&rig->folder);
    return 0;
}

/* A file of counts: the loop's, then two frames. */
static bool read_counts(struct rig *rig, int loop, const char *end, struct cost *cost, struct error *err)
{
    char text[2048];
    snprintf(text, sizeof text,
             "frame 0 0 %d 0 1 0 0 0 0 0  0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0  0 0 0 0 0 0  0 0  9 0\n"
             "frame 0 0 0 0 1 0 0 0 70 5  2 0 8 0 4 0 36 12 1 0 9 0 3 0 27 6  1 0 2 0 3 0  0 0  99 0\n"
             "frame 0 0 0 0 1 0 0 0 70 5  0 0 0 0 6 0 54 0 1 0 9 0 1 0 9 2  1 0 2 0 3 0  0 0  99 0\n%s",
             loop, end);
    write_text(rig, "inlined", INLINED);
    memcpy(rig->inlined, rig->path, sizeof rig->inlined);
    write_text(rig, "counts", text);
    const struct counts_run run = {rig->path, rig->inlined, 2, PLANE_TESTS};
    *cost = (struct cost){0};
    return counts_read(&rig->map, &run, cost, err);
}

static void the_map_has_what_is_in_memory(void **state)
{
    const struct rig *rig = *state;

    assert_int_equal(rig->map.count, 15);
    assert_string_equal(rig->map.sections[5].name, ".text.lim_eye_side.part.0");
    assert_string_equal(rig->map.sections[5].object, "/tmp/a/firmware/eye.o");
    assert_int_equal(rig->map.sections[5].start, 0x60);
    assert_int_equal(rig->map.sections[5].size_b, 0x20);
}

static void every_stage_function_has_its_entry_counted(void **state)
{
    struct rig *rig = *state;
    struct error err;
    char line[64];
    size_t ranges = 0, helpers = 0, others = 0;

    snprintf(rig->path, sizeof rig->path, "%s/ranges", rig->folder.path);
    if (!counts_write_ranges(&rig->map, rig->path, &err)) fail_msg("%s", err.text);
    FILE *file = fopen(rig->path, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        ranges += strncmp(line, "range", 5) == 0;
        helpers += strcmp(line, "helper e0 100\n") == 0;
        others += strcmp(line, "begin 48\n") == 0 || strcmp(line, "end 4c\n") == 0 ||
                  strcmp(line, "range 80 82\n") == 0 || strcmp(line, "range 82 a0\n") == 0 ||
                  strcmp(line, "range d2 d4\n") == 0;
    }
    fclose(file);
    assert_int_equal(ranges + helpers, RANGES - 1);
    assert_int_equal(helpers, 1);
    assert_int_equal(others, 5);
}

static void frames_are_the_stages_and_their_helpers(void **state)
{
    struct cost cost;
    struct error err;

    if (!read_counts(*state, COUNT_CHECK_INSTRUCTIONS, "done\n", &cost, &err)) fail_msg("%s", err.text);
    assert_int_equal(cost.frames, 2);
    assert_int_equal(cost.worst, 114); /* 72 of eye, 36 of view, 6 of walk */
    assert_int_equal(cost.worst_frame, 0);
    assert_true(cost.mean == (114 + 88) / 2.0);
    assert_int_equal(cost.stage_count, 3);
    assert_string_equal(cost.stages[0].name, "eye");
    assert_true(cost.stages[0].mean == (72 + 70) / 2.0 && cost.stages[0].library == 6);
    assert_int_equal(cost.stages[0].worst, 72);
    assert_true(cost.stages[1].mean == (36 + 12) / 2.0 && cost.stages[1].library == 4);
}

static void a_vertex_is_all_of_what_fills_the_cache_its_helpers_with_it(void **state)
{
    struct cost cost;
    struct error err;

    if (!read_counts(*state, COUNT_CHECK_INSTRUCTIONS, "done\n", &cost, &err)) fail_msg("%s", err.text);
    assert_true(fabs(cost.vertex - (3 + 1 + 27 + 6 + 9 + 2) / (3.0 + 1.0)) < 1e-9);
}

static void a_plane_test_is_all_of_eye_but_its_setting_inlined_or_not(void **state)
{
    struct cost cost;
    struct error err;

    if (!read_counts(*state, COUNT_CHECK_INSTRUCTIONS, "done\n", &cost, &err)) fail_msg("%s", err.text);
    assert_true(fabs(cost.side - (10 + 52 + 60 + 2 + 2) / (double)PLANE_TESTS) < 1e-9);
}

static void memory_is_told_apart(void **state)
{
    const struct rig *rig = *state;
    struct cost cost = {0};

    counts_memory(&rig->map, &cost);
    assert_int_equal(cost.state_b, 0x80);
    assert_int_equal(cost.pools_b, 0x200);
    assert_int_equal(cost.static_b, 0);
    assert_int_equal(cost.code_b, 0x20 + 0x20 + 0x10 + 0x20 + 0x6 + 0x40);
    assert_int_equal(cost.library_b, 0x20);
    assert_int_equal(cost.scene_b, 0x100);
}

static void a_loop_that_counts_one_too_many_is_refused(void **state)
{
    struct cost cost;
    struct error err;

    assert_false(read_counts(*state, COUNT_CHECK_INSTRUCTIONS + 1, "done\n", &cost, &err));
    assert_non_null(strstr(err.text, "the counter is wrong"));
}

static void missing_frames_are_refused(void **state)
{
    struct rig *rig = *state;
    struct cost cost;
    struct error err;

    assert_false(read_counts(rig, COUNT_CHECK_INSTRUCTIONS, "", &cost, &err));
    assert_non_null(strstr(err.text, "does not end"));
    const struct counts_run longer = {rig->path, rig->inlined, 3, PLANE_TESTS};
    assert_false(counts_read(&rig->map, &longer, &cost, &err));
    assert_non_null(strstr(err.text, "only 2 of 3 frames"));
}

#define WITH_RIG(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)

int main(void)
{
    const struct CMUnitTest tests[] = {
        WITH_RIG(the_map_has_what_is_in_memory),
        WITH_RIG(every_stage_function_has_its_entry_counted),
        WITH_RIG(frames_are_the_stages_and_their_helpers),
        WITH_RIG(a_vertex_is_all_of_what_fills_the_cache_its_helpers_with_it),
        WITH_RIG(a_plane_test_is_all_of_eye_but_its_setting_inlined_or_not),
        WITH_RIG(memory_is_told_apart),
        WITH_RIG(a_loop_that_counts_one_too_many_is_refused),
        WITH_RIG(missing_frames_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
