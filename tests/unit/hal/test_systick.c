/* SPDX-License-Identifier: MIT
 *
 * SysTick as a clock: how it is started, and what becomes of a wait for a counter that stands still, which memory in
 * the place of its registers is. */
#include "mcu/mcu.h"
#include "mcu/systick.h"
#include "rigs/cmocka_ready.h"

static void test_counts_processor_cycles_through_all_bits(void **state)
{
    (void)state;
    struct systick_registers registers = {.csr = 7, .rvr = 3, .cvr = 2};
    struct systick systick;

    assert_int_equal(systick_init(&systick, &registers, 125000000), 0);
    assert_int_equal(registers.csr, 5); /* enabled, the processor's clock, no interrupt */
    assert_int_equal(registers.rvr, 0xFFFFFF);
    assert_int_equal(registers.cvr, 0);
    assert_int_equal(systick.cycles_per_us, 125);
}

static void test_rounds_a_rate_up_so_that_no_wait_is_too_short(void **state)
{
    (void)state;
    struct systick_registers registers = {0};
    struct systick systick;

    assert_int_equal(systick_init(&systick, &registers, 12500000), 0);
    assert_int_equal(systick.cycles_per_us, 13);
    assert_int_equal(systick_init(&systick, &registers, 32768), 0);
    assert_int_equal(systick.cycles_per_us, 1);
}

static void test_refuses_a_rate_of_nothing(void **state)
{
    (void)state;
    struct systick_registers registers = {0};
    struct systick systick;

    assert_int_equal(systick_init(&systick, &registers, 0), MCU_ERR_CONFIG);
    assert_int_equal(registers.csr, 0);
}

static void test_a_counter_that_stands_still_ends_a_wait(void **state)
{
    (void)state;
    struct systick_registers registers = {0};
    struct systick systick;

    assert_int_equal(systick_init(&systick, &registers, 125000000), 0);
    const struct clock clock = systick_clock(&systick);
    assert_int_equal(clock_delay(&clock, 0), MCU_ERR_TIMEOUT);
    assert_int_equal(clock_delay(&clock, UINT32_MAX), MCU_ERR_TIMEOUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts_processor_cycles_through_all_bits),
        cmocka_unit_test(test_rounds_a_rate_up_so_that_no_wait_is_too_short),
        cmocka_unit_test(test_refuses_a_rate_of_nothing),
        cmocka_unit_test(test_a_counter_that_stands_still_ends_a_wait),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
