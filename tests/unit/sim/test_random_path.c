/* SPDX-License-Identifier: MIT
 *
 * Random cameras lie in free space, are the same every time, and do not hang on how the compiler orders a scene. */
#include "cameras/camera_choice.h"
#include "cameras/free_space.h"
#include "cameras/random_path.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { FRAMES = 200 };

static struct compiled compile(const char *model, enum tree_kind tree)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .tree = tree};
    struct compiled scene;
    struct error err;

    if (!compile_model(model, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

static struct camera_path draw(const struct compiled *scene, uint32_t seed)
{
    struct camera_path path;
    struct error err;

    if (!random_path(scene, "random", seed, FRAMES, &path, &err)) fail_msg("%s", err.text);
    assert_int_equal(path.count, FRAMES);
    return path;
}

static bool same_eye(const struct viewpoint *a, const struct viewpoint *b)
{
    return memcmp(a->eye_m, b->eye_m, sizeof a->eye_m) == 0 && memcmp(a->target_m, b->target_m, sizeof a->eye_m) == 0;
}

static int shared_eyes(const struct camera_path *a, const struct camera_path *b)
{
    int shared = 0;

    for (int i = 0; i < FRAMES; i++)
        shared += same_eye(&a->frames[i], &b->frames[i]);
    return shared;
}

static void every_eye_is_in_free_space_and_can_be_drawn_from(void **state)
{
    static const char *const models[] = {"sim/scenes/rooms.obj", "sim/scenes/teapot.obj", "sim/scenes/icosahedron.obj"};
    struct lim_camera camera;
    struct lens lens;
    struct error err;

    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof *models; m++) {
        struct compiled scene = compile(models[m], TREE_BSP);
        struct camera_path path = draw(&scene, 7);
        assert_true(lens_init(&lens, 60, lens_default_near_m(&scene.grid), 240, 240, &err));
        for (size_t i = 0; i < path.count; i++) {
            assert_true(free_space_holds(&scene, path.frames[i].eye_m));
            assert_true(camera_path_to_camera(&path, i, &lens, &scene.grid, &camera, &err));
            assert_int_equal(path.frames[i].line, i + 1);
        }
        camera_path_free(&path);
        compiled_free(&scene);
    }
}

static void a_seed_gives_the_same_cameras_and_another_gives_others(void **state)
{
    struct compiled scene = compile("sim/scenes/rooms.obj", TREE_BSP);
    struct camera_path first = draw(&scene, 1), again = draw(&scene, 1), other = draw(&scene, 2),
                       zero = draw(&scene, 0);

    (void)state;
    assert_int_equal(shared_eyes(&first, &again), FRAMES);
    assert_int_equal(shared_eyes(&first, &other), 0);
    assert_int_equal(shared_eyes(&first, &zero), 0);
    assert_false(same_eye(&first.frames[0], &first.frames[1]));
    camera_path_free(&first);
    camera_path_free(&again);
    camera_path_free(&other);
    camera_path_free(&zero);
    compiled_free(&scene);
}

/* Trees order vertices and polygons differently. */
static void another_tree_gives_the_same_cameras(void **state)
{
    struct compiled bsp = compile("sim/scenes/rooms.obj", TREE_BSP);
    struct compiled clusters = compile("sim/scenes/rooms.obj", TREE_CLUSTERS);
    struct camera_path a = draw(&bsp, 1), b = draw(&clusters, 1);

    (void)state;
    assert_int_equal(shared_eyes(&a, &b), FRAMES);
    camera_path_free(&a);
    camera_path_free(&b);
    compiled_free(&bsp);
    compiled_free(&clusters);
}

static void the_option_is_a_file_or_a_seed_and_a_number_of_frames(void **state)
{
    struct camera_choice choice;
    struct error err;

    (void)state;
    assert_true(camera_choice_parse("random:3", &choice, &err));
    assert_int_equal(choice.seed, 3);
    assert_int_equal(choice.random_count, CAMERA_CHOICE_RANDOM);
    assert_true(camera_choice_parse("random:4294967295:10", &choice, &err));
    assert_int_equal(choice.seed, UINT32_MAX);
    assert_int_equal(choice.random_count, 10);
    assert_true(camera_choice_parse("./random:3", &choice, &err));
    assert_int_equal(choice.random_count, 0);
    assert_string_equal(choice.text, "./random:3");
}

static void what_is_no_seed_or_no_number_is_refused_by_name(void **state)
{
    static const char *const wrong[] = {"random:",        "random:x",
                                        "random:-1",      "random:1.5",
                                        "random:1:",      "random:1:0",
                                        "random:1:10001", "random:4294967296",
                                        "random:1:2:3",   "random:00000000000000000000001"};
    struct camera_choice choice;
    struct error err;

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(camera_choice_parse(wrong[i], &choice, &err));
        assert_non_null(strstr(err.text, "--camera random:SEED"));
    }
}

static void a_scene_in_which_all_moves_is_refused(void **state)
{
    struct compiled scene = {0};
    struct camera_path path;
    struct error err;

    (void)state;
    assert_false(random_path(&scene, "random:1", 1, 1, &path, &err));
    assert_non_null(strstr(err.text, "random:1: nothing stands still"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_eye_is_in_free_space_and_can_be_drawn_from),
        cmocka_unit_test(a_seed_gives_the_same_cameras_and_another_gives_others),
        cmocka_unit_test(another_tree_gives_the_same_cameras),
        cmocka_unit_test(the_option_is_a_file_or_a_seed_and_a_number_of_frames),
        cmocka_unit_test(what_is_no_seed_or_no_number_is_refused_by_name),
        cmocka_unit_test(a_scene_in_which_all_moves_is_refused),
    };

    return cmocka_run_group_tests_name("random path", tests, NULL, NULL);
}
