/* SPDX-License-Identifier: MIT
 *
 * Shimmer: the count, on sequences whose counts are known by hand; and that profiles differ in it as their bits do. */
#include "core/core.h"
#include "measure/measurement.h"
#include "measure/shimmer.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { PIXELS = 6 };

/* Pixel by pixel: never changes; changes for good; is back in the next frame; in the third; in the fourth, which is too
 * late; changes again, to another colour. */
static const uint16_t FRAMES[SHIMMER_SPAN + 1][PIXELS] = {{1, 1, 1, 1, 1, 1}, {1, 2, 2, 2, 2, 2}, {1, 2, 1, 2, 2, 3},
                                                          {1, 2, 1, 2, 2, 3}, {1, 2, 1, 1, 2, 3}, {1, 2, 1, 1, 1, 3}};

static void pictures_from(size_t first, const uint16_t *pictures[SHIMMER_SPAN])
{
    for (size_t i = 0; i < SHIMMER_SPAN; i++)
        pictures[i] = FRAMES[first + i];
}

static void test_pixels_that_are_back_within_three_frames(void **state)
{
    const uint16_t *pictures[SHIMMER_SPAN];
    struct shimmer_count count = {0};
    (void)state;
    pictures_from(0, pictures);
    shimmer_add(&count, pictures, PIXELS);
    assert_int_equal(count.changed, 5);
    assert_int_equal(count.back, 2);
    assert_float_equal(shimmer_percent(&count), 40.0, 1e-9);
    pictures_from(1, pictures); /* two pixels change there, and neither comes back */
    shimmer_add(&count, pictures, PIXELS);
    assert_int_equal(count.changed, 7);
    assert_int_equal(count.back, 2);
}

static void test_nothing_changes(void **state)
{
    const uint16_t *pictures[SHIMMER_SPAN] = {FRAMES[0], FRAMES[0], FRAMES[0], FRAMES[0], FRAMES[0]};
    struct shimmer_count count = {0};
    (void)state;
    shimmer_add(&count, pictures, PIXELS);
    assert_int_equal(count.changed, 0);
    assert_float_equal(shimmer_percent(&count), 0.0, 0.0);
}

static void measure(const struct core *core, struct shimmer *out)
{
    struct compile_options options = compile_options_usual();
    struct camera_path path = {0};
    struct compiled scene = {0};
    struct lens lens;
    struct error err;
    options.core = core;
    options.portals = PORTALS_OFF;
    if (!compile_model("sim/scenes/rooms.obj", &options, &scene, &err) ||
        !camera_path_read("sim/scenes/rooms.cam", &path, &err) ||
        !lens_for_grid(&lens, 60, 0, &scene.grid, 240, 240, &err) ||
        !shimmer_measure(&(struct measure_candidate){core, &scene},
                         &(struct measure_views){&path, &lens, 240, 240, NULL}, out, &err))
        fail_msg("%s", err.text);
    assert_true(out->known);
    assert_true(out->turn.changed > 1000);
    assert_true(out->walk.changed > 100);
    camera_path_free(&path);
    compiled_free(&scene);
}

static void test_more_bits_shimmer_less(void **state)
{
    struct shimmer draft, fast, exact;
    (void)state;
    measure(&core_draft, &draft);
    measure(&core_fast, &fast);
    measure(&core_exact, &exact);
    print_message("# turn: draft %.2f, fast %.2f, exact %.2f; walk: %.2f, %.2f, %.2f\n", shimmer_percent(&draft.turn),
                  shimmer_percent(&fast.turn), shimmer_percent(&exact.turn), shimmer_percent(&draft.walk),
                  shimmer_percent(&fast.walk), shimmer_percent(&exact.walk));
    assert_true(shimmer_percent(&draft.turn) > shimmer_percent(&fast.turn));
    assert_true(shimmer_percent(&fast.turn) > shimmer_percent(&exact.turn));
    assert_true(shimmer_percent(&draft.walk) > shimmer_percent(&fast.walk));
    assert_true(shimmer_percent(&fast.walk) > shimmer_percent(&exact.walk));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels_that_are_back_within_three_frames),
        cmocka_unit_test(test_nothing_changes),
        cmocka_unit_test(test_more_bits_shimmer_less),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
