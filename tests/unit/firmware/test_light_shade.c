/* SPDX-License-Identifier: MIT
 *
 * The lamp that turns with what moves: each colour at each brightness is rounded to nearest, and the brightness is the
 * angle's, in double precision, for normals of any length. */
#include "orders.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <math.h>

enum { MOST_Q8 = 255, NORMALS = 200000, ONE_Q14 = 16384 };

static const int16_t up_q14[3] = {0, ONE_Q14, 0};

/* Halves go up. */
static unsigned nearest(unsigned value, unsigned by_q8)
{
    return (unsigned)floor(value * (by_q8 / 256.0) + 0.5);
}

static void every_value_is_rounded_to_nearest_at_every_brightness(void **state)
{
    static const int32_t level[3] = {1, 0, 0}; /* neither towards the lamp nor away from it */

    (void)state;
    for (unsigned by_q8 = 0; by_q8 <= MOST_Q8; by_q8++) {
        const struct lim_light light = {.on = true, .middle_q8 = (uint8_t)by_q8, .swing_q8 = 0};
        for (unsigned value = 0; value < 64; value++) {
            const unsigned red = value & 31, green = value, blue = 31 - red;
            const uint16_t shaded = lim_light_shade(&light, up_q14, level, (uint16_t)(red << 11 | green << 5 | blue));
            assert_int_equal(shaded >> 11, nearest(red, by_q8));
            assert_int_equal(shaded >> 5 & 63, nearest(green, by_q8));
            assert_int_equal(shaded & 31, nearest(blue, by_q8));
        }
    }
}

static void brightness_is_the_angles_for_normals_of_any_length(void **state)
{
    const struct lim_light light = {.on = true, .middle_q8 = 128, .swing_q8 = 128};
    struct random random = {43};

    (void)state;
    for (int k = 0; k < NORMALS; k++) {
        const int64_t reach = INT64_C(1) << random_in(&random, 0, 30);
        double to[3], square = 0, dot = 0, length = 0;
        int32_t normal[3];
        int16_t to_q14[3];
        for (int i = 0; i < 3; i++) {
            to[i] = random_unit(&random) - 0.5;
            normal[i] = (int32_t)random_in(&random, -reach, reach);
            length += to[i] * to[i];
        }
        for (int i = 0; i < 3; i++) {
            to_q14[i] = (int16_t)lround(to[i] / sqrt(length) * ONE_Q14);
            dot += (double)normal[i] * to[i] / sqrt(length);
            square += (double)normal[i] * normal[i];
        }
        if (square == 0) continue;
        const double bright = 0.5 + 0.5 * dot / sqrt(square);
        const unsigned green = lim_light_shade(&light, to_q14, normal, 63 << 5) >> 5 & 63;
        assert_true(fabs(green - 63 * bright) <= 0.5 + 63.0 / 512 + 0.02);
    }
}

static void ends_are_reached_and_not_passed(void **state)
{
    const struct lim_light light = {.on = true, .middle_q8 = 128, .swing_q8 = 128};

    (void)state;
    for (int32_t length = 1; length < 1 << 30; length = length * 3 + 1) {
        assert_int_equal(lim_light_shade(&light, up_q14, (const int32_t[]){0, length, 0}, 0xFFFF), 0xFFFF);
        assert_int_equal(lim_light_shade(&light, up_q14, (const int32_t[]){0, -length, 0}, 0xFFFF), 0);
        assert_int_equal(lim_light_shade(&light, up_q14, (const int32_t[]){length, 0, 0}, 0xFFFF), 0x8410);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_is_rounded_to_nearest_at_every_brightness),
        cmocka_unit_test(brightness_is_the_angles_for_normals_of_any_length),
        cmocka_unit_test(ends_are_reached_and_not_passed),
    };

    return cmocka_run_group_tests_name("light_shade", tests, NULL, NULL);
}
