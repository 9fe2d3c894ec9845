/* SPDX-License-Identifier: MIT
 *
 * The unary kernels over 2^24 arguments: one of each 256 neighbours, so all leading mantissas of 23 bits, all
 * exponents and all quadrants. `make exhaustive` leaves none out. */
#include "exhaustive/exhaustive.h"
#include "rigs/cmocka_ready.h"

enum { ARGUMENTS_BITS = 24 };

static void every_kernel_is_within_its_stated_bound(void **state)
{
    (void)state;
    for (size_t k = 0; k < EXHAUSTIVE_KERNELS; k++) {
        struct exhaustive_range range = {0};
        for (uint32_t i = 0; i < UINT32_C(1) << ARGUMENTS_BITS; i++)
            exhaustive_add(&range, &exhaustive_kernels[k], i << 8 | (i * 37 & 255));
        assert_true(exhaustive_report(&range, &exhaustive_kernels[k]));
    }
}

static void every_kernel_is_right_at_the_ends_of_each_power_of_two(void **state)
{
    (void)state;
    for (size_t k = 0; k < EXHAUSTIVE_KERNELS; k++) {
        struct exhaustive_range range = {0};
        for (int bit = 0; bit < 32; bit++)
            for (uint32_t off = 0; off < 2048; off++)
                exhaustive_add(&range, &exhaustive_kernels[k], (UINT32_C(1) << bit) + off - 1024);
        assert_true(exhaustive_report(&range, &exhaustive_kernels[k]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kernel_is_within_its_stated_bound),
        cmocka_unit_test(every_kernel_is_right_at_the_ends_of_each_power_of_two),
    };

    return cmocka_run_group_tests_name("exhaustive", tests, NULL, NULL);
}
