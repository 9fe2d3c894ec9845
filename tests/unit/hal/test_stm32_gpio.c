/* SPDX-License-Identifier: MIT
 *
 * Pins of the STM32 with memory in the place of the registers: other pins stay as they are, and a level is one write.
 */
#include "mcu/stm32f1_gpio.h"
#include "mcu/stm32f4_gpio.h"
#include "rigs/cmocka_ready.h"

static void assert_level(const struct pin *pin, volatile uint32_t *bsrr, bool high, uint32_t written)
{
    *bsrr = 0;
    assert_int_equal(pin_set(pin, high), 0);
    assert_int_equal(*bsrr, written);
}

static void test_f4_output_begins_at_its_level_and_takes_others(void **state)
{
    (void)state;
    struct stm32f4_gpio port = {
        .moder = UINT32_MAX, .otyper = UINT32_MAX, .ospeedr = UINT32_MAX, .pupdr = UINT32_MAX, .afr = {7, 7}};
    const struct stm32f4_pin at = {.port = &port, .bit = 6};
    const struct pin pin = stm32f4_gpio_output(&at, true);

    assert_int_equal(port.bsrr, 1 << 6);
    assert_int_equal(port.moder, 0xFFFFDFFF);
    assert_int_equal(port.otyper, 0xFFFFFFBF);
    assert_int_equal(port.ospeedr, 0xFFFFDFFF);
    assert_int_equal(port.pupdr, 0xFFFFCFFF);
    assert_int_equal(port.afr[0], 7);
    assert_level(&pin, &port.bsrr, true, 0x40);
    assert_level(&pin, &port.bsrr, false, 0x400000);
}

static void test_f4_pin_is_lent_to_a_peripheral(void **state)
{
    (void)state;
    struct stm32f4_gpio port = {.moder = 0xA8000000, .afr = {0xFFFFFFFF, 0xFFFFFFFF}};

    stm32f4_gpio_lend(&(struct stm32f4_pin){.port = &port, .bit = 5}, 5);
    stm32f4_gpio_lend(&(struct stm32f4_pin){.port = &port, .bit = 15}, 6);
    assert_int_equal(port.moder, 0xA8000800);
    assert_int_equal(port.ospeedr, 0xC0000C00);
    assert_int_equal(port.afr[0], 0xFF5FFFFF);
    assert_int_equal(port.afr[1], 0x6FFFFFFF);
}

static void test_f1_output_begins_at_its_level_and_takes_others(void **state)
{
    (void)state;
    struct stm32f1_gpio port = {.cr = {0x44444444, 0x44444444}};
    const struct stm32f1_pin at = {.port = &port, .bit = 3};
    const struct pin pin = stm32f1_gpio_output(&at, false);

    assert_int_equal(port.bsrr, 1 << 19);
    assert_int_equal(port.cr[0], 0x44442444);
    assert_int_equal(port.cr[1], 0x44444444);
    assert_level(&pin, &port.bsrr, true, 0x8);
    assert_level(&pin, &port.bsrr, false, 0x80000);
}

static void test_f1_pin_may_be_inverted(void **state)
{
    (void)state;
    struct stm32f1_gpio port = {.cr = {0x44444444, 0x44444444}};
    const struct stm32f1_pin at = {.port = &port, .bit = 13, .inverted = true};
    const struct pin pin = stm32f1_gpio_output(&at, false);

    assert_int_equal(port.bsrr, 0x2000);
    assert_int_equal(port.cr[0], 0x44444444);
    assert_int_equal(port.cr[1], 0x44244444);
    assert_level(&pin, &port.bsrr, true, 0x20000000);
}

static void test_f4_pin_may_be_inverted(void **state)
{
    (void)state;
    struct stm32f4_gpio port = {0};
    const struct stm32f4_pin at = {.port = &port, .bit = 0, .inverted = true};
    const struct pin pin = stm32f4_gpio_output(&at, false);

    assert_int_equal(port.bsrr, 1);
    assert_level(&pin, &port.bsrr, true, 0x10000);
}

static void test_f1_pin_is_lent_to_a_peripheral(void **state)
{
    (void)state;
    struct stm32f1_gpio port = {.cr = {0x44444444, 0x44444444}};

    stm32f1_gpio_lend(&(struct stm32f1_pin){.port = &port, .bit = 7});
    assert_int_equal(port.cr[0], 0xB4444444);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_f4_output_begins_at_its_level_and_takes_others),
        cmocka_unit_test(test_f4_pin_may_be_inverted),
        cmocka_unit_test(test_f4_pin_is_lent_to_a_peripheral),
        cmocka_unit_test(test_f1_output_begins_at_its_level_and_takes_others),
        cmocka_unit_test(test_f1_pin_may_be_inverted),
        cmocka_unit_test(test_f1_pin_is_lent_to_a_peripheral),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
