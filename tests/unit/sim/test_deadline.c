/* SPDX-License-Identifier: MIT
 *
 * The time that a command may take, by a clock that the test turns; and compiling that is stopped anywhere. */
#include "base/deadline.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"
#include "scene/compiled.h"
#include "scene/lim_check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double now_s;

static double fake_now_s(void)
{
    return now_s;
}

static int begin(void **state)
{
    (void)state;
    now_s = 1000.0;
    deadline_set_clock(fake_now_s);
    return 0;
}

static int end(void **state)
{
    (void)state;
    deadline_begin(0.0);
    deadline_set_clock(NULL);
    unsetenv("LIMNER_TIME_LIMIT");
    return 0;
}

static void time_is_over_at_the_limit(void **state)
{
    struct error err;
    (void)state;
    deadline_begin(10.0);
    now_s += 9.99;
    assert_false(deadline_passed());
    assert_true(deadline_check(&err, "nothing"));
    now_s += 0.01;
    assert_true(deadline_passed());
    assert_false(deadline_check(&err, "no tree of %d polygons", 7));
    assert_string_equal(err.text, "stopped after 10 s (--time-limit 10): no tree of 7 polygons");
}

static void without_a_limit_time_is_never_over(void **state)
{
    struct error err;
    (void)state;
    deadline_begin(0.0);
    now_s = 1e12;
    assert_false(deadline_passed());
    assert_true(deadline_check(&err, "nothing"));
    deadline_restore(deadline_share(0.5));
    assert_false(deadline_passed());
}

static void a_share_is_of_what_is_left(void **state)
{
    (void)state;
    deadline_begin(100.0);
    now_s += 20.0;
    const struct deadline_end whole = deadline_share(0.5);
    now_s += 39.0;
    assert_false(deadline_passed());
    now_s += 1.0;
    assert_true(deadline_passed());
    deadline_restore(whole);
    assert_false(deadline_passed());
    now_s += 40.0;
    assert_true(deadline_passed());
}

/* A stretch of its own length ends by itself, never later than what it is in, and without a limit, too. */
static void a_stretch_of_seconds_ends_with_them(void **state)
{
    (void)state;
    deadline_begin(0.0);
    assert_false(deadline_is_set());
    const struct deadline_end none = deadline_within(0.0);
    assert_false(deadline_is_set());
    const struct deadline_end whole = deadline_within(20.0);
    assert_true(deadline_is_set());
    now_s += 19.0;
    assert_false(deadline_passed());
    const struct deadline_end inner = deadline_within(5.0);
    now_s += 1.5;
    assert_true(deadline_passed());
    deadline_restore(inner);
    assert_true(deadline_passed());
    deadline_restore(whole);
    assert_false(deadline_passed());
    deadline_restore(none);
    assert_false(deadline_is_set());
}

static void a_share_of_a_share_ends_within_it(void **state)
{
    (void)state;
    deadline_begin(100.0);
    const struct deadline_end whole = deadline_share(0.5), half = deadline_share(0.5);
    now_s += 25.0;
    assert_true(deadline_passed());
    deadline_restore(half);
    assert_false(deadline_passed());
    now_s += 25.0;
    assert_true(deadline_passed());
    deadline_share(0.9); /* of nothing */
    assert_true(deadline_passed());
    deadline_restore(whole);
    assert_false(deadline_passed());
}

static void the_limit_is_the_option_or_the_environment_or_ten_minutes(void **state)
{
    double limit_s;
    struct error err;
    (void)state;
    unsetenv("LIMNER_TIME_LIMIT");
    assert_true(deadline_parse(NULL, &limit_s, &err) && limit_s == 600.0);
    setenv("LIMNER_TIME_LIMIT", "7.5", 1);
    assert_true(deadline_parse(NULL, &limit_s, &err) && limit_s == 7.5);
    assert_true(deadline_parse("0", &limit_s, &err) && limit_s == 0.0);
    setenv("LIMNER_TIME_LIMIT", "soon", 1);
    assert_false(deadline_parse(NULL, &limit_s, &err));
    assert_non_null(strstr(err.text, "LIMNER_TIME_LIMIT"));
    static const char *const refused[] = {"-1", "nan", "inf", "x", "1s", "-0.001"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        assert_false(deadline_parse(refused[i], &limit_s, &err));
}

/* A clock that goes on by a second whenever it is asked: time is over after so many questions, wherever they are asked.
 */
static double stepping_now_s(void)
{
    return now_s += 1.0;
}

enum { SOUP = 12 };

static void soup_make(struct model *model)
{
    struct random random = {7};
    *model = (struct model){0};
    for (size_t i = 0; i < SOUP; i++) {
        double places[3][3];
        for (size_t k = 0; k < 9; k++)
            places[k / 3][k % 3] = 10.0 * random_unit(&random);
        tiny_add(model, 3, (const double(*)[3])places);
        model->faces[i].two_sided = true;
    }
}

static const struct compile_options OPTIONS = {.tolerance_units = 0.5,
                                               .splitter = "auto",
                                               .trial = TRIAL_ALWAYS,
                                               .choose_order = true,
                                               .w_px = 24,
                                               .h_px = 24,
                                               .portals = PORTALS_AUTO,
                                               .predict = true};

static bool compile_within(const struct model *model, double limit_s, struct compiled *out, struct error *err)
{
    now_s = 0.0;
    *out = (struct compiled){0};
    deadline_set_clock(stepping_now_s);
    deadline_begin(limit_s);
    return compile_part(model, NULL, &OPTIONS, out, err);
}

static void a_limit_that_is_not_reached_changes_nothing(void **state)
{
    struct model model;
    struct compiled free_of_it, within;
    struct error err;
    (void)state;
    soup_make(&model);
    assert_true(compile_within(&model, 0.0, &free_of_it, &err));
    assert_true(compile_within(&model, 1e9, &within, &err));
    assert_int_equal(free_of_it.image_b, within.image_b);
    assert_memory_equal(free_of_it.image, within.image, within.image_b);
    assert_true(free_of_it.report.wrong.percent == within.report.wrong.percent);
    compiled_free(&free_of_it);
    compiled_free(&within);
    model_free(&model);
}

/* Whatever the compiler was at, there is a scene that can be drawn, or an error that says that time was over. */
static void time_may_end_anywhere_in_compiling(void **state)
{
    enum { FEW = 100 };
    const int ends = effort(16) < 10 ? 10 : effort(16);
    struct model model;
    struct compiled scene;
    struct error err;
    size_t scenes = 0, errors = 0;
    double most_after = 0.0;
    (void)state;
    soup_make(&model);
    assert_true(compile_within(&model, 1e9, &scene, &err));
    compiled_free(&scene);
    const double questions = now_s;
    for (int i = 1; i < ends; i++) {
        /* More of them where there is no tree yet, which comes soon. */
        const double limit_s = questions * pow(i / (double)ends, 4.0);
        const bool ok = compile_within(&model, limit_s, &scene, &err);
        most_after = fmax(most_after, now_s - limit_s);
        scenes += ok;
        errors += !ok;
        if (!ok) assert_non_null(strstr(err.text, "stopped after "));
        if (ok && !lim_check(&scene.scene, &err)) fail_msg("end %d: %s", i, err.text);
        if (ok) assert_true(scene.report.polygons_out >= SOUP);
        compiled_free(&scene);
    }
    assert_true(scenes > (size_t)ends / 4 && errors > 2);
    assert_true(most_after < FEW); /* nothing goes on that only asks */
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(time_is_over_at_the_limit, begin, end),
        cmocka_unit_test_setup_teardown(without_a_limit_time_is_never_over, begin, end),
        cmocka_unit_test_setup_teardown(a_share_is_of_what_is_left, begin, end),
        cmocka_unit_test_setup_teardown(a_stretch_of_seconds_ends_with_them, begin, end),
        cmocka_unit_test_setup_teardown(a_share_of_a_share_ends_within_it, begin, end),
        cmocka_unit_test_setup_teardown(the_limit_is_the_option_or_the_environment_or_ten_minutes, begin, end),
        cmocka_unit_test_setup_teardown(a_limit_that_is_not_reached_changes_nothing, begin, end),
        cmocka_unit_test_setup_teardown(time_may_end_anywhere_in_compiling, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
