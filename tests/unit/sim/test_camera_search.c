/* SPDX-License-Identifier: MIT
 *
 * A search finds what is known to be worst, in free space, within its tries and its time; and the same every time. What
 * is known: scores that are made up here, of a place, a direction and a moment. */
#include "base/deadline.h"
#include "cameras/camera_search.h"
#include "cameras/free_space.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TRIES = 3000, SEEN_MAX = 4000 };

/* What is asked of cameras. */
struct wish {
    double at_m[3], way[3], time_s; /* the higher the score, the nearer to these */
    struct viewpoint seen[SEEN_MAX];
    size_t count;
    size_t limit; /* fails at that camera; 0: never */
};

static double apart(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static double place_score(const struct wish *wish, const struct viewpoint *viewpoint)
{
    return 100.0 / (1.0 + apart(viewpoint->eye_m, wish->at_m));
}

static double way_score(const struct wish *wish, const struct viewpoint *viewpoint)
{
    double dot = 0.0;
    const double length = apart(viewpoint->eye_m, viewpoint->target_m);
    for (int i = 0; i < 3; i++)
        dot += (viewpoint->target_m[i] - viewpoint->eye_m[i]) / length * wish->way[i];
    return 1.0 + dot;
}

static bool measure(void *ctx, const struct viewpoint *viewpoint, double *scores, struct error *err)
{
    struct wish *wish = ctx;
    assert_true(wish->count < SEEN_MAX);
    wish->seen[wish->count++] = *viewpoint;
    scores[0] = place_score(wish, viewpoint);
    scores[1] = way_score(wish, viewpoint);
    scores[2] = viewpoint->has_time ? 10.0 - fabs(viewpoint->time_s - wish->time_s) : -1.0;
    return wish->count != wish->limit || error_set(err, "enough");
}

static struct compiled compile(const char *model)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .tree = TREE_BSP};
    struct compiled scene;
    struct error err;
    if (!compile_model(model, &options, &scene, &err)) fail_msg("%s", err.text);
    return scene;
}

/* In a room of rooms.obj; looking there; a moment. */
static struct wish a_wish(void)
{
    return (struct wish){.at_m = {3.1, 1.2, 7.7}, .way = {0.6, 0.0, 0.8}, .time_s = 2.25};
}

static struct camera_search search_of(const struct compiled *scene, struct wish *wish)
{
    struct camera_search search = {.scene = scene,
                                   .length_s = 6.0,
                                   .seed = 3,
                                   .tries = TRIES,
                                   .goals = 3,
                                   .doing = "a test",
                                   .measure = measure,
                                   .ctx = wish};
    struct error err;
    if (!lens_init(&search.lens, 60, lens_default_near_m(&scene->grid), 240, 240, &err)) fail_msg("%s", err.text);
    return search;
}

static struct search_result run(const struct camera_search *search)
{
    struct search_result result;
    struct error err;
    if (!camera_search_run(search, &result, &err)) fail_msg("%s", err.text);
    return result;
}

static void finds_a_place_a_direction_and_a_moment(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    struct wish wish = a_wish();
    const struct camera_search search = search_of(&scene, &wish);
    const struct search_result result = run(&search);
    assert_true(free_space_holds(&scene, wish.at_m));
    assert_true(apart(result.goals[0].worst.eye_m, wish.at_m) < 0.05); /* of 30 m */
    assert_true(way_score(&wish, &result.goals[1].worst) > 2.0 - 1e-3);
    assert_true(fabs(result.goals[2].worst.time_s - wish.time_s) < 0.02);
    for (size_t goal = 0; goal < 3; goal++) {
        assert_true(result.goals[goal].score >= result.goals[goal].most);
        assert_true(result.goals[goal].most >= result.goals[goal].mean);
    }
    compiled_free(&scene);
}

/* The score and figures are those of cameras that were measured. */
static void tells_what_was_measured(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    struct wish wish = a_wish();
    const struct camera_search search = search_of(&scene, &wish);
    const struct search_result result = run(&search);
    double most = 0.0, plain_most = 0.0, sum = 0.0;
    assert_int_equal(result.tried, wish.count);
    assert_true(result.tried <= TRIES && result.tried > TRIES / 2);
    assert_false(result.is_cut);
    for (size_t i = 0; i < wish.count; i++) {
        const double score = place_score(&wish, &wish.seen[i]);
        most = fmax(most, score);
        if (i < result.plain) plain_most = fmax(plain_most, score);
        if (i < result.plain) sum += score;
    }
    assert_true(result.goals[0].score == most);
    assert_true(result.goals[0].most == plain_most);
    assert_true(fabs(result.goals[0].mean - sum / (double)result.plain) < 1e-9);
    compiled_free(&scene);
}

/* No near plane's corner is in a wall: as far as 1.29 near planes in any direction there is free space. */
static void eyes_keep_off_walls(void **state)
{
    static const char *const models[] = {"sim/scenes/rooms.obj", "sim/scenes/teapot.obj"};
    (void)state;
    for (size_t m = 0; m < sizeof models / sizeof *models; m++) {
        struct compiled scene = compile(models[m]);
        struct wish wish = a_wish();
        const struct camera_search search = search_of(&scene, &wish);
        (void)run(&search);
        for (size_t i = 0; i < wish.count; i++)
            for (int axis = 0; axis < 3; axis++)
                for (int sign = -1; sign <= 1; sign++) {
                    double at_m[3];
                    memcpy(at_m, wish.seen[i].eye_m, sizeof at_m);
                    at_m[axis] += sign * 1.29 * search.lens.near_m;
                    assert_true(free_space_holds(&scene, at_m));
                }
        compiled_free(&scene);
    }
}

static void a_seed_gives_the_same_and_another_gives_others(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    struct wish wishes[3] = {a_wish(), a_wish(), a_wish()};
    struct search_result results[3];
    for (int i = 0; i < 3; i++) {
        struct camera_search search = search_of(&scene, &wishes[i]);
        search.tries = 400;
        search.seed = i < 2 ? 5 : 6;
        results[i] = run(&search);
    }
    assert_int_equal(wishes[0].count, wishes[1].count);
    for (size_t i = 0; i < wishes[0].count; i++) {
        assert_memory_equal(wishes[0].seen[i].eye_m, wishes[1].seen[i].eye_m, sizeof wishes[0].seen[i].eye_m);
        assert_memory_equal(wishes[0].seen[i].target_m, wishes[1].seen[i].target_m, sizeof wishes[0].seen[i].eye_m);
    }
    assert_true(results[0].goals[0].score == results[1].goals[0].score);
    assert_true(memcmp(wishes[0].seen[0].eye_m, wishes[2].seen[0].eye_m, sizeof wishes[0].seen[0].eye_m) != 0);
    compiled_free(&scene);
}

/* What a file has is what was measured, to the last bit. */
static void a_file_of_it_reads_back(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/teapot.obj");
    struct wish wish = a_wish();
    struct camera_search search = search_of(&scene, &wish);
    char name[] = "/tmp/test_camera_search.XXXXXX";
    struct camera_path path;
    struct error err;
    search.tries = 200;
    (void)run(&search);
    const int descriptor = mkstemp(name);
    FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "w");
    assert_non_null(file);
    for (size_t i = 0; i < wish.count; i++)
        viewpoint_write(&wish.seen[i], file);
    fclose(file);
    if (!camera_path_read(name, &path, &err)) fail_msg("%s", err.text);
    remove(name);
    assert_int_equal(path.count, wish.count);
    for (size_t i = 0; i < path.count; i++) {
        assert_memory_equal(path.frames[i].eye_m, wish.seen[i].eye_m, sizeof path.frames[i].eye_m);
        assert_memory_equal(path.frames[i].target_m, wish.seen[i].target_m, sizeof path.frames[i].eye_m);
        assert_true(path.frames[i].has_time && path.frames[i].time_s == wish.seen[i].time_s);
    }
    camera_path_free(&path);
    compiled_free(&scene);
}

static double fake_s;

static double fake_now_s(void)
{
    return fake_s += 0.001; /* a question takes a millisecond */
}

static void time_ends_it(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    struct wish wish = a_wish();
    const struct camera_search search = search_of(&scene, &wish);
    deadline_set_clock(fake_now_s);
    deadline_begin(2.0);
    const struct search_result result = run(&search);
    deadline_begin(0.0);
    deadline_set_clock(NULL);
    assert_true(result.is_cut);
    assert_true(result.plain > 0 && result.tried > result.plain); /* each part had its share */
    assert_true(result.tried < TRIES);
    assert_true(result.goals[0].score >= result.goals[0].most);
    compiled_free(&scene);
}

static void one_try_is_one(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    struct wish wish = a_wish();
    struct camera_search search = search_of(&scene, &wish);
    search.tries = 1;
    const struct search_result result = run(&search);
    assert_int_equal(result.tried, 1);
    assert_true(result.goals[0].score == place_score(&wish, &wish.seen[0]));
    compiled_free(&scene);
}

static void an_error_ends_it(void **state)
{
    (void)state;
    struct compiled scene = compile("sim/scenes/rooms.obj");
    const size_t limits[] = {1, 2, TRIES / 4 + 10, TRIES / 2};
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        struct wish wish = a_wish();
        const struct camera_search search = search_of(&scene, &wish);
        struct search_result result;
        struct error err;
        wish.limit = limits[i];
        assert_false(camera_search_run(&search, &result, &err));
        assert_string_equal(err.text, "enough");
        assert_int_equal(wish.count, limits[i]);
    }
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(finds_a_place_a_direction_and_a_moment),
                                       cmocka_unit_test(tells_what_was_measured),
                                       cmocka_unit_test(eyes_keep_off_walls),
                                       cmocka_unit_test(a_seed_gives_the_same_and_another_gives_others),
                                       cmocka_unit_test(a_file_of_it_reads_back),
                                       cmocka_unit_test(time_ends_it),
                                       cmocka_unit_test(one_try_is_one),
                                       cmocka_unit_test(an_error_ends_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
