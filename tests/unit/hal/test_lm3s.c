/* SPDX-License-Identifier: MIT
 *
 * Pins and clocks of LM3S parts on registers in memory: a pin is written where its mask alone is, others keep what they
 * have, and a PLL that never locks is an error that leaves the processor on the crystal. */
#include "mcu/lm3s_clocks.h"
#include "mcu/lm3s_gpio.h"
#include "mcu/mcu.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { BYPASS = 1 << 11, PWRDN = 1 << 13, USESYSDIV = 1 << 22, PLL_LOCKED = 1 << 6 };

static struct lm3s_gpio_registers port;
static struct lm3s_system_registers sys;

static int clear(void **state)
{
    (void)state;
    memset(&port, 0, sizeof port);
    memset(&sys, 0, sizeof sys);
    return 0;
}

static void registers_lie_where_the_manual_says(void **state)
{
    (void)state;
    assert_int_equal(offsetof(struct lm3s_gpio_registers, dir), 0x400);
    assert_int_equal(offsetof(struct lm3s_gpio_registers, afsel), 0x420);
    assert_int_equal(offsetof(struct lm3s_gpio_registers, dr2r), 0x500);
    assert_int_equal(offsetof(struct lm3s_gpio_registers, den), 0x51c);
    assert_int_equal(offsetof(struct lm3s_system_registers, ldopctl), 0x034);
    assert_int_equal(offsetof(struct lm3s_system_registers, srcr), 0x040);
    assert_int_equal(offsetof(struct lm3s_system_registers, ris), 0x050);
    assert_int_equal(offsetof(struct lm3s_system_registers, rcc), 0x060);
    assert_int_equal(offsetof(struct lm3s_system_registers, rcc2), 0x070);
    assert_int_equal(offsetof(struct lm3s_system_registers, rcgc), 0x100);
}

static void an_output_writes_its_own_pin_alone(void **state)
{
    (void)state;
    struct lm3s_output output;

    port.afsel = port.dir = port.den = 0x21;
    const struct pin pin = lm3s_gpio_output(&output, &port, 5, true);
    assert_int_equal(port.data[1 << 5], 0xFF);
    assert_int_equal(port.afsel, 0x01);
    assert_int_equal(port.dir, 0x21);
    assert_int_equal(port.den, 0x21);
    assert_int_equal(pin_set(&pin, false), 0);
    assert_int_equal(port.data[1 << 5], 0);
    assert_int_equal(pin_set(&pin, true), 0);
    for (int mask = 0; mask < 256; mask++)
        assert_int_equal(port.data[mask], mask == 1 << 5 ? 0xFF : 0);
}

static void inputs_are_pulled_up_and_read_by_their_mask(void **state)
{
    (void)state;
    port.afsel = port.dir = 0xF3;
    port.data[0x0C] = 0x08;
    lm3s_gpio_inputs(&port, 0x0F);
    assert_int_equal(port.afsel, 0xF0);
    assert_int_equal(port.dir, 0xF0);
    assert_int_equal(port.pur, 0x0F);
    assert_int_equal(port.den, 0x0F);
    assert_int_equal(lm3s_gpio_read(&port, 0x0C), 0x08);
}

static void a_peripheral_gets_its_pins(void **state)
{
    (void)state;
    port.afsel = port.den = 0x80;
    lm3s_gpio_alternate(&port, 0x24);
    assert_int_equal(port.afsel, 0xA4);
    assert_int_equal(port.den, 0xA4);
    assert_int_equal(port.dir, 0);
}

static void peripherals_are_clocked_and_leave_reset(void **state)
{
    (void)state;
    sys.rcgc[2] = 0x40;
    sys.srcr[2] = 0x80;
    lm3s_peripherals_start(&sys, 2, LM3S_2_GPIO_A | LM3S_2_GPIO_F);
    assert_int_equal(sys.rcgc[2], 0x61);
    assert_int_equal(sys.srcr[2], 0x80);
    assert_int_equal(sys.rcgc[1], 0);
}

static void the_pll_is_used_when_it_has_locked(void **state)
{
    (void)state;
    sys.ris = PLL_LOCKED;
    sys.rcc2 = UINT32_MAX;
    assert_int_equal(lm3s_clocks_init(&sys), 0);
    assert_int_equal(sys.rcc & (BYPASS | PWRDN | USESYSDIV), USESYSDIV);
    assert_int_equal(sys.rcc >> 23 & 15, 3);  /* 400 MHz / 2 / 4 */
    assert_int_equal(sys.rcc >> 6 & 15, 0xE); /* a crystal of 8 MHz */
    assert_int_equal(sys.rcc >> 4 & 3, 0);    /* the main oscillator */
    assert_int_equal(sys.rcc2, 0);            /* RCC is not overridden */
    assert_int_equal(sys.misc, PLL_LOCKED);   /* an old lock was forgotten */
}

static void a_pll_that_never_locks_is_an_error(void **state)
{
    (void)state;
    sys.ris = ~(uint32_t)PLL_LOCKED;
    assert_int_equal(lm3s_clocks_init(&sys), MCU_ERR_TIMEOUT);
    assert_int_equal(sys.rcc & BYPASS, BYPASS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(registers_lie_where_the_manual_says, clear),
        cmocka_unit_test_setup(an_output_writes_its_own_pin_alone, clear),
        cmocka_unit_test_setup(inputs_are_pulled_up_and_read_by_their_mask, clear),
        cmocka_unit_test_setup(a_peripheral_gets_its_pins, clear),
        cmocka_unit_test_setup(peripherals_are_clocked_and_leave_reset, clear),
        cmocka_unit_test_setup(the_pll_is_used_when_it_has_locked, clear),
        cmocka_unit_test_setup(a_pll_that_never_locks_is_an_error, clear),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
