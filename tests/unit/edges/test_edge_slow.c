/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact as it is built for a processor without a division, here for 1024 pixels: 20 fraction bits; and the
 * reciprocal that it divides by errs by no more than EDGE counts with. */
#define LIM_DIVIDES 0

#include "screen/edge.c"
#include "screen/edge_bounds.c"
#include "screen/small.c"

#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"

#include <stdlib.h>

enum { BY_MAX = 65535, QUOTIENT_MAX = 2 * LIM_MAX_SIDE_PX + 2 };

static void edges_are_exact(void **state)
{
    (void)state;
    edge_rig_check_many(104);
}

static int64_t floor_divide(int64_t a, int64_t by)
{
    return a / by - (a % by < 0);
}

/* Ends of the range, and anything in it. */
static int32_t pick(struct random *random, int k, int32_t most)
{
    const int32_t ends[] = {0, 1, -1, most, -most};

    return k < 5 ? ends[k] : (int32_t)random_in(random, -most, most);
}

static void quotients_of_16_bits_are_never_too_high_and_hardly_too_low(void **state)
{
    struct random random = {105};

    (void)state;
    for (int32_t by = 1; by <= BY_MAX >> 4; by++) { /* what begin_short() takes */
        const struct divisor divisor = divisor_of(by);
        for (int k = 0; k < 24; k++) {
            const int32_t a = pick(&random, k, DIVISOR_WIDTH - 1);
            const int64_t short_of = (int64_t)a * 65536 - (int64_t)divisor_q16(&divisor, a) * by;
            assert_true(short_of >= 0 && short_of < (int64_t)DIVISOR_ERROR * by);
        }
    }
}

/* Whether a reciprocal with so many bits errs by no more than `halves` half units, and products with it fit. */
static bool is_near(int32_t recip, int32_t by, uint8_t bits, int64_t halves)
{
    const int64_t error = (int64_t)recip * by - ((int64_t)1 << bits), widest = SMALL_DX + by;

    return 2 * llabs(error) <= halves * by && widest * recip <= INT32_MAX;
}

static void small_reciprocals_err_by_half_a_unit_and_medium_ones_by_one(void **state)
{
    (void)state;
    for (int32_t by = SMALL_LEAST_DY; by < SMALL_DY; by++)
        assert_true(is_near(small_recip(by), by, SMALL_RECIP_BITS - SMALL_DROPPED_BITS, 1));
    for (int32_t by = SMALL_DY; by < MEDIUM_DY; by++)
        assert_true(is_near(medium_recip(by), by, SMALL_RECIP_BITS + 1, 2));
}

static void whole_quotients_are_exact(void **state)
{
    struct random random = {106};

    (void)state;
    for (int32_t by = 1; by <= BY_MAX; by++) {
        const struct divisor divisor = divisor_of(by);
        for (int k = 0; k < 12; k++) {
            const int32_t a = pick(&random, k, by * QUOTIENT_MAX);
            int32_t rest;
            assert_int_equal(divisor_floor(&divisor, a, &rest), floor_divide(a, by));
            assert_int_equal(rest, a - floor_divide(a, by) * by);
        }
    }
}

static void fractions_are_never_too_high_and_hardly_too_low(void **state)
{
    static const uint8_t bits[] = {20, 22};
    struct random random = {107};

    (void)state;
    for (int32_t by = 1; by <= BY_MAX; by++) {
        const struct divisor divisor = divisor_of(by);
        for (int k = 0; k < 12; k++) {
            const uint32_t rest = k == 0 ? 0 : k == 1 ? (uint32_t)by - 1 : (uint32_t)random_in(&random, 0, by - 1);
            const int64_t fraction = divisor_fraction(&divisor, rest, bits[k % 2]);
            const int64_t short_of = ((int64_t)rest << bits[k % 2]) - fraction * by;
            assert_true(short_of >= 0 && short_of < (int64_t)DIVISOR_ERROR * by);
            assert_int_equal(divided_fraction((uint32_t)by, rest, bits[k % 2]), ((int64_t)rest << bits[k % 2]) / by);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_are_exact),
        cmocka_unit_test(quotients_of_16_bits_are_never_too_high_and_hardly_too_low),
        cmocka_unit_test(small_reciprocals_err_by_half_a_unit_and_medium_ones_by_one),
        cmocka_unit_test(whole_quotients_are_exact),
        cmocka_unit_test(fractions_are_never_too_high_and_hardly_too_low),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
