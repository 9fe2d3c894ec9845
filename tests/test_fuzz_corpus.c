/* SPDX-License-Identifier: MIT
 *
 * What fuzzing found worth keeping, replayed: a few dozen inputs of each target that reach what thousands
 * of others reach. `make fuzz` looks for more. */
#include "cmocka_ready.h"
#include "compiled.h"
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>

#define CORPUS "tests/corpus"

enum { INPUT_MAX_B = 4096, INPUTS_MIN = 12 };

struct replay {
    const struct fuzz_target *target;
    size_t inputs, scenes; /* of the inputs, those that are .lim files */
};

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_bytes_are_a_camera_or_refused),
        cmocka_unit_test(any_text_is_a_camera_file_or_refused),
        cmocka_unit_test(any_bytes_are_a_scene_or_refused),
        cmocka_unit_test(any_valid_scene_is_drawn),
    };

    return cmocka_run_group_tests_name("fuzz corpus", tests, NULL, NULL);
}
