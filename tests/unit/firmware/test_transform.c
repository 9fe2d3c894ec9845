/* SPDX-License-Identifier: MIT
 *
 * The two forms of profile fine's row product, 16-bit limbs and 64-bit sums, are the same to the bit: over all
 * ends of their ranges, and 10^7 random rows and vertices. */
#define LIM_PROFILE LIM_PROFILE_FINE
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "view/transform.h"

static const int16_t ENDS[] = {-32767, -32766, -1, 0, 1, 32766, 32767};
static const int16_t LOW_ENDS[] = {-16384, -16383, -1, 0, 1, 16383, 16384};
enum { END_COUNT = sizeof ENDS / sizeof *ENDS, RANDOM_CASES = 10000000 };

/* As rows.c puts an entry together. */
static void set_entry(struct lim_row *row, int i, int16_t high, int16_t low)
{
    row->n_qv[i] = high;
    row->low_qv15[i] = low;
    row->n_qv16[i] = (high * (INT32_C(1) << 15) + low) * 2;
}

static void assert_same(const struct lim_row *row, const struct lim_vertex *at)
{
    const int32_t limbs = transform_limbs(row, at), wide = transform_long(row, at);

    if (limbs != wide) fail_msg("limbs %ld, 64 bits %ld", (long)limbs, (long)wide);
}

/* Every pair of ends in each place, the other places at every end as well. */
static void both_forms_agree_at_the_ends(void **state)
{
    (void)state;
    for (int entry = 0; entry < END_COUNT * END_COUNT; entry++)
        for (int others = 0; others < END_COUNT * END_COUNT; others++)
            for (int v = 0; v < END_COUNT * END_COUNT; v++) {
                struct lim_row row = {.shift_qv = entry % 2 ? INT32_MIN : INT32_MAX};
                const struct lim_vertex at = {ENDS[v % END_COUNT], ENDS[v / END_COUNT], ENDS[(v + 3) % END_COUNT]};
                set_entry(&row, 0, ENDS[entry % END_COUNT], LOW_ENDS[entry / END_COUNT]);
                set_entry(&row, 1, ENDS[others % END_COUNT], LOW_ENDS[others / END_COUNT]);
                set_entry(&row, 2, ENDS[others / END_COUNT], LOW_ENDS[entry % END_COUNT]);
                assert_same(&row, &at);
            }
}

static void both_forms_agree_on_random_rows(void **state)
{
    struct random random = {81};

    (void)state;
    for (int k = 0; k < RANDOM_CASES; k++) {
        const uint64_t entries = random_u64(&random), lows = random_u64(&random), vertex = random_u64(&random);
        struct lim_row row = {.shift_qv = (int32_t)(uint32_t)(lows >> 32)};
        const struct lim_vertex at = {(int16_t)vertex, (int16_t)(vertex >> 16), (int16_t)(vertex >> 32)};
        for (int i = 0; i < 3; i++) {
            const int16_t high = (int16_t)(entries >> 16 * i);
            const int low = (int)(random_u64(&random) % 32769) - 16384;
            set_entry(&row, i, high == INT16_MIN ? 0 : high, (int16_t)low);
        }
        assert_same(&row, &at);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_forms_agree_at_the_ends),
        cmocka_unit_test(both_forms_agree_on_random_rows),
    };

    return cmocka_run_group_tests_name("transform", tests, NULL, NULL);
}
