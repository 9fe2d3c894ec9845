/* SPDX-License-Identifier: MIT
 *
 * Clocks and pins of the FE310 with memory in the place of the registers, where everything that shall become ready is
 * so from the start, or never; and a machine timer that stands still. */
#include "mcu/fe310_gpio.h"
#include "mcu/fe310_prci.h"
#include "mcu/mcu.h"
#include "mcu/mtime.h"
#include "rigs/cmocka_ready.h"

#define READY (UINT32_C(1) << 31)
#define ON (UINT32_C(1) << 30)
#define RING (ON | UINT32_C(0x100004)) /* trimmed to the middle, divided by 5 */
#define SEL (UINT32_C(1) << 16)
#define FLASH_SCKDIV 8 /* of SiFive's own programs at 256 MHz (freedom-e-sdk, RTEMS, RIOT, Arduino's core) */
#define ALL_READY ((struct fe310_prci){READY, READY, READY | UINT32_C(0x70DF1), 0})

#define REFSEL_HFXOSC (UINT32_C(1) << 17)
#define BYPASS (UINT32_C(1) << 18)

struct timer {
    int err;
    uint32_t waited_us;
    const struct fe310_prci *prci; /* as they are while the PLL locks */
    const struct fe310_spi_registers *flash;
};

/* Who reads flash through a divider for 256 MHz must have it before, and the processor still runs by its ring. */
static int fake_delay(void *ctx, uint32_t delay_us)
{
    struct timer *timer = ctx;
    assert_int_equal(timer->flash->sckdiv, FLASH_SCKDIV);
    assert_int_equal(timer->prci->pllcfg & (SEL | BYPASS | REFSEL_HFXOSC), REFSEL_HFXOSC);
    timer->waited_us += delay_us;
    return timer->err;
}

static uint32_t init(struct fe310_prci *prci, struct timer *timer)
{
    struct fe310_spi_registers flash = {.sckdiv = 3};
    const struct clock clock = {.ctx = timer, .delay = fake_delay};
    timer->prci = prci;
    timer->flash = &flash;
    const uint32_t cpu_hz = fe310_prci_init(prci, &flash, &clock);

    assert_int_equal(flash.sckdiv, FLASH_SCKDIV);
    assert_int_equal(prci->hfrosccfg & ~READY, RING);
    return cpu_hz;
}

static void test_runs_at_256_mhz_by_its_crystal(void **state)
{
    (void)state;
    struct fe310_prci prci = ALL_READY;
    struct timer timer = {0};

    assert_int_equal(init(&prci, &timer), 256000000);
    assert_int_equal(prci.hfxosccfg, READY | ON);
    assert_int_equal(prci.plloutdiv, 0x100);
    assert_int_equal(prci.pllcfg, READY | 0x305F1); /* selected, of the crystal, not passed by; Q 2, F 64, R 2 */
    assert_int_equal(timer.waited_us, 100);
}

static void assert_stays_on_the_ring(struct fe310_prci prci, int timer_err)
{
    struct timer timer = {.err = timer_err};

    assert_in_range(init(&prci, &timer), 14000000, 20000000);
    assert_int_equal(prci.pllcfg & SEL, 0);
}

static void test_stays_on_its_ring_oscillator_where_something_is_not_ready(void **state)
{
    (void)state;
    assert_stays_on_the_ring((struct fe310_prci){0}, 0);
    assert_stays_on_the_ring((struct fe310_prci){.pllcfg = READY | SEL}, 0);
    assert_stays_on_the_ring((struct fe310_prci){.hfxosccfg = READY, .pllcfg = SEL}, 0);
    assert_stays_on_the_ring(ALL_READY, MCU_ERR_TIMEOUT);
}

static void test_a_timer_that_stands_still_ends_a_wait(void **state)
{
    (void)state;
    const uint32_t counter = 7;
    struct mtime mtime = {.low = &counter, .rate_hz = 32768};
    const struct clock clock = mtime_clock(&mtime);

    assert_int_equal(clock_delay(&clock, 0), MCU_ERR_TIMEOUT);
    assert_int_equal(clock_delay(&clock, UINT32_MAX), MCU_ERR_TIMEOUT);
}

static void test_an_output_begins_at_its_level_and_takes_others(void **state)
{
    (void)state;
    struct fe310_gpio port = {.output_val = 0xF0, .output_en = 0xF0, .iof_en = 0xFF, .out_xor = 0xFF};
    const struct fe310_pin at = {.port = &port, .bit = 1};
    const struct pin pin = fe310_gpio_output(&at, true);

    assert_int_equal(port.output_val, 0xF2);
    assert_int_equal(port.output_en, 0xF2);
    assert_int_equal(port.iof_en, 0xFD);
    assert_int_equal(port.out_xor, 0xFD);
    assert_int_equal(pin_set(&pin, false), 0);
    assert_int_equal(port.output_val, 0xF0);
    assert_int_equal(pin_set(&pin, true), 0);
    assert_int_equal(port.output_val, 0xF2);
}

static void test_the_port_inverts_a_pin(void **state)
{
    (void)state;
    struct fe310_gpio port = {0};
    const struct fe310_pin at = {.port = &port, .bit = 22, .inverted = true};
    const struct pin pin = fe310_gpio_output(&at, false);

    assert_int_equal(port.out_xor, 1 << 22);
    assert_int_equal(port.output_val, 0);
    assert_int_equal(pin_set(&pin, true), 0);
    assert_int_equal(port.output_val, 1 << 22);
}

static void test_a_pin_is_lent_to_a_peripheral(void **state)
{
    (void)state;
    struct fe310_gpio port = {.iof_sel = 0xFF, .out_xor = 0xFF};

    fe310_gpio_lend(&(struct fe310_pin){.port = &port, .bit = 5});
    assert_int_equal(port.iof_en, 0x20);
    assert_int_equal(port.iof_sel, 0xDF);
    assert_int_equal(port.out_xor, 0xDF);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_runs_at_256_mhz_by_its_crystal),
        cmocka_unit_test(test_stays_on_its_ring_oscillator_where_something_is_not_ready),
        cmocka_unit_test(test_a_timer_that_stands_still_ends_a_wait),
        cmocka_unit_test(test_an_output_begins_at_its_level_and_takes_others),
        cmocka_unit_test(test_the_port_inverts_a_pin),
        cmocka_unit_test(test_a_pin_is_lent_to_a_peripheral),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
