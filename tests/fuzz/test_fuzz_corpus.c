/* SPDX-License-Identifier: MIT
 *
 * What fuzzing found worth keeping, replayed: a few dozen inputs of each target that reach what thousands
 * of others reach. `make fuzz` looks for more. */
#include "fuzz.h"
#include "rigs/cmocka_ready.h"
#include "scene/compiled.h"
#include "scene/scene_files.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define CORPUS "tests/fuzz/corpus"

enum { INPUT_MAX_B = 4096, INPUTS_MIN = 12 };

struct replay {
    const struct fuzz_target *target;
    size_t inputs, scenes; /* of the inputs, those that are .lim files */
};

static char replayed[512]; /* the names of targets so far, each in spaces */

static bool is_scene(const char *path)
{
    struct compiled scene;
    struct error err;
    const bool ok = lim_file_read(path, &scene, &err);

    compiled_free(&scene);
    return ok;
}

static void replay_input(struct replay *replay, const char *name)
{
    uint8_t bytes[INPUT_MAX_B];
    char path[512];

    snprintf(path, sizeof path, CORPUS "/%s/%s", replay->target->name, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size_b = fread(bytes, 1, sizeof bytes, file);
    assert_true(feof(file) && fclose(file) == 0);
    const char *broken = replay->target->run(bytes, size_b);
    if (broken) fail_msg("%s: %s", path, broken);
    replay->inputs++;
    replay->scenes += is_scene(path);
}

static struct replay replay_corpus(const char *name)
{
    struct replay replay = {.target = fuzz_find(name)};
    char folder[512];

    assert_non_null(replay.target);
    snprintf(replayed + strlen(replayed), sizeof replayed - strlen(replayed), " %s ", name);
    snprintf(folder, sizeof folder, CORPUS "/%s", name);
    DIR *inputs = opendir(folder);
    assert_non_null(inputs);
    for (struct dirent *entry; (entry = readdir(inputs));)
        if (entry->d_name[0] != '.') replay_input(&replay, entry->d_name);
    closedir(inputs);
    assert_true(replay.inputs >= INPUTS_MIN);
    return replay;
}

static void any_bytes_are_a_camera_or_refused(void **state)
{
    (void)state;
    replay_corpus("camera");
}

static void any_text_is_a_camera_file_or_refused(void **state)
{
    (void)state;
    replay_corpus("camera_file");
}

/* Files of an older format would all be refused at once, and test nothing. */
static void any_bytes_are_a_scene_or_refused(void **state)
{
    const struct replay replay = replay_corpus("lim_file");

    (void)state;
    assert_true(replay.scenes >= replay.inputs / 4);
}

static void any_valid_scene_is_drawn(void **state)
{
    (void)state;
    replay_corpus("render");
}

static void any_valid_scene_of_many_scales_is_drawn(void **state)
{
    (void)state;
    replay_corpus("long");
}

static void any_valid_scene_looks_the_same_by_any_means(void **state)
{
    (void)state;
    replay_corpus("features");
}

static void any_triangles_are_a_mesh_by_any_means(void **state)
{
    (void)state;
    replay_corpus("mesh");
}

static void any_objects_move_in_any_valid_scene(void **state)
{
    (void)state;
    replay_corpus("movers");
}

static void any_objects_move_in_any_valid_scene_of_many_scales(void **state)
{
    (void)state;
    replay_corpus("long_movers");
}

static void anything_stops_a_walker_in_any_valid_scene(void **state)
{
    (void)state;
    replay_corpus("touch");
}

static void any_bytes_are_a_model_that_compiles_or_refused(void **state)
{
    static const char *const formats[] = {"obj", "gltf", "ply", "stl", "off"};

    (void)state;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        replay_corpus(formats[i]);
}

static void models_as_they_should_be_are_read_as_they_are(void **state)
{
    (void)state;
    replay_corpus("written");
}

static void any_bytes_are_a_map_or_refused(void **state)
{
    (void)state;
    replay_corpus("wad");
}

static void any_bytes_are_a_picture_or_refused(void **state)
{
    (void)state;
    replay_corpus("picture");
}

static void any_text_is_heard_by_a_display_or_refused(void **state)
{
    (void)state;
    replay_corpus("wire_log");
    replay_corpus("qemu");
    replay_corpus("vcd");
}

static void any_words_are_a_command_or_refused(void **state)
{
    (void)state;
    replay_corpus("text");
    replay_corpus("report");
}

/* A target that is not named above would be replayed by nobody. */
static void every_target_is_replayed(void **state)
{
    (void)state;
    for (size_t i = 0; fuzz_targets[i]; i++) {
        char name[64];
        snprintf(name, sizeof name, " %s ", fuzz_targets[i]->name);
        if (!strstr(replayed, name)) fail_msg("%s is not replayed", fuzz_targets[i]->name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bytes_are_a_camera_or_refused),
        cmocka_unit_test(any_text_is_a_camera_file_or_refused),
        cmocka_unit_test(any_bytes_are_a_scene_or_refused),
        cmocka_unit_test(any_valid_scene_is_drawn),
        cmocka_unit_test(any_valid_scene_of_many_scales_is_drawn),
        cmocka_unit_test(any_valid_scene_looks_the_same_by_any_means),
        cmocka_unit_test(any_triangles_are_a_mesh_by_any_means),
        cmocka_unit_test(any_objects_move_in_any_valid_scene),
        cmocka_unit_test(any_objects_move_in_any_valid_scene_of_many_scales),
        cmocka_unit_test(anything_stops_a_walker_in_any_valid_scene),
        cmocka_unit_test(any_bytes_are_a_model_that_compiles_or_refused),
        cmocka_unit_test(models_as_they_should_be_are_read_as_they_are),
        cmocka_unit_test(any_bytes_are_a_map_or_refused),
        cmocka_unit_test(any_bytes_are_a_picture_or_refused),
        cmocka_unit_test(any_text_is_heard_by_a_display_or_refused),
        cmocka_unit_test(any_words_are_a_command_or_refused),
        cmocka_unit_test(every_target_is_replayed),
    };

    if (access("/proc/self/fd", F_OK) != 0) {
        puts("ok 1 - fuzz corpus # SKIP there is no /proc here, by which inputs in memory have names");
        puts("1..1");
        return 0;
    }
    return cmocka_run_group_tests_name("fuzz corpus", tests, NULL, NULL);
}
