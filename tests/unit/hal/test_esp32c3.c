/* SPDX-License-Identifier: MIT
 *
 * Drivers of the ESP32-C3 with memory in the place of registers, in which what shall come has come, or never does.
 * Numbers are those of espressif/esp-idf components/soc/esp32c3/register/soc. Which registers are written when, the
 * rules of sim/emulators look at. */
#include "mcu/esp32c3_gpio.h"
#include "mcu/esp32c3_spi.h"
#include "mcu/esp32c3_system.h"
#include "mcu/esp32c3_systimer.h"
#include "mcu/mcu.h"
#include "rigs/cmocka_ready.h"

#include <stddef.h>
#include <string.h>

#define UPDATE (UINT32_C(1) << 23)
#define USR (UINT32_C(1) << 24)
#define UNDIVIDED (UINT32_C(1) << 31)

static struct esp32c3_spi_registers registers;
static struct esp32c3_spi spi;

static void registers_are_where_the_maker_has_them(void **state)
{
    (void)state;
    assert_int_equal(offsetof(struct esp32c3_spi_registers, clock), 0xC);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, user), 0x10);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, ms_dlen), 0x1C);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, misc), 0x20);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, dma_conf), 0x30);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, w), 0x98);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, slave), 0xE0);
    assert_int_equal(offsetof(struct esp32c3_spi_registers, clk_gate), 0xE8);
    assert_int_equal(offsetof(struct esp32c3_gpio, out_w1tc), 0xC);
    assert_int_equal(offsetof(struct esp32c3_gpio, enable_w1ts), 0x24);
    assert_int_equal(offsetof(struct esp32c3_gpio, func_out_sel), 0x554);
    assert_int_equal(offsetof(struct esp32c3_io_mux, pins), 4);
    assert_int_equal(offsetof(struct esp32c3_system, perip_clk_en0), 0x10);
    assert_int_equal(offsetof(struct esp32c3_system, perip_rst_en0), 0x18);
    assert_int_equal(offsetof(struct esp32c3_system, sysclk_conf), 0x58);
    assert_int_equal(offsetof(struct esp32c3_rtc_watchdogs, wprotect), 0xA8 - 0x90);
    assert_int_equal(offsetof(struct esp32c3_rtc_watchdogs, swd_wprotect), 0xB0 - 0x90);
    assert_int_equal(offsetof(struct esp32c3_watchdog, wprotect), 0x64 - 0x48);
    assert_int_equal(offsetof(struct esp32c3_systimer, unit0_value_lo), 0x44);
}

/* An update is over in memory that never is: so init ends with a timeout, and all is written before. */
static void init(uint32_t spi_hz, uint8_t mode, int expected)
{
    memset((void *)&registers, 0x77, sizeof registers);
    assert_int_equal(esp32c3_spi_init(&spi, &registers, 40000000, spi_hz, mode), expected);
}

static uint32_t rate_of(uint32_t clock)
{
    const uint32_t n = (clock >> 12 & 63) + 1, pre = (clock >> 18 & 15) + 1;

    if (clock == UNDIVIDED) return 40000000;
    assert_int_equal(clock & 63, n - 1);
    assert_int_equal(clock >> 6 & 63, n / 2 - 1);
    assert_int_equal(clock >> 22, 0);
    return 40000000 / (n * pre);
}

static void the_rate_is_what_is_asked_for_or_the_next_slower_one(void **state)
{
    (void)state;
    init(UINT32_MAX, 3, MCU_ERR_TIMEOUT);
    assert_int_equal(registers.clock, UNDIVIDED);
    init(40000000, 3, MCU_ERR_TIMEOUT);
    assert_int_equal(registers.clock, UNDIVIDED);
    for (uint32_t by = 2; by <= 1024; by++) {
        const uint32_t wanted_hz = (40000000 + by - 1) / by;
        init(wanted_hz, 3, MCU_ERR_TIMEOUT);
        const uint32_t hz = rate_of(registers.clock);
        assert_true(hz <= wanted_hz);
        if (by <= 64) assert_int_equal(hz, 40000000 / by);
        assert_true(hz >= 40000000 / (by + 15));
    }
    init(39999999, 3, MCU_ERR_TIMEOUT);
    assert_int_equal(rate_of(registers.clock), 20000000);
    init(39062, 3, MCU_ERR_CONFIG);
    init(0, 3, MCU_ERR_CONFIG);
}

/* spi_ll_master_set_mode(): CK_IDLE_EDGE and CK_OUT_EDGE of the four. */
static void modes_are_the_makers(void **state)
{
    static const bool idles_high[] = {false, false, true, true}, late[] = {false, true, true, false};

    (void)state;
    for (uint8_t mode = 0; mode < 4; mode++) {
        init(40000000, mode, MCU_ERR_TIMEOUT);
        assert_int_equal(registers.misc, 0x3F | (uint32_t)idles_high[mode] << 29);
        assert_int_equal(registers.user, UINT32_C(1) << 27 | (uint32_t)late[mode] << 9);
        assert_int_equal(registers.clk_gate, 3);
        assert_int_equal(registers.slave, 0);
        assert_int_equal(registers.cmd, UPDATE);
    }
}

static void nothing_is_waited_for_without_end(void **state)
{
    const uint8_t bytes[3] = {1, 2, 3};
    struct esp32c3_systimer timer = {0};

    (void)state;
    init(40000000, 3, MCU_ERR_TIMEOUT);
    const struct bus bus = esp32c3_spi_bus(&spi);
    assert_int_equal(bus.write(bus.ctx, bytes, 3), MCU_ERR_TIMEOUT); /* no update */
    registers.cmd = USR;
    assert_int_equal(bus.flush(bus.ctx), MCU_ERR_TIMEOUT);
    registers.cmd = 0;
    assert_int_equal(bus.flush(bus.ctx), 0);
    const struct clock clock = esp32c3_systimer_clock(&timer);
    assert_int_equal(timer.conf >> 30, 3);
    assert_int_equal(clock_delay(&clock, 1), MCU_ERR_TIMEOUT);
}

static void the_first_byte_is_a_words_lowest(void **state)
{
    static const uint8_t bytes[7] = {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77};

    (void)state;
    init(40000000, 3, MCU_ERR_TIMEOUT);
    const struct bus bus = esp32c3_spi_bus(&spi);
    registers.cmd = 0;
    assert_int_equal(bus.write(bus.ctx, bytes, 7), MCU_ERR_TIMEOUT);
    assert_int_equal(registers.w[0], 0x44332211);
    assert_int_equal(registers.w[1], 0x00776655);
    assert_int_equal(registers.w[2], 0x77777777); /* as it was */
    assert_int_equal(registers.ms_dlen, 55);
    assert_int_equal(registers.dma_conf, 0);
}

static void watchdogs_stop_and_are_locked_again(void **state)
{
    struct esp32c3_rtc_watchdogs rtc = {.config0 = UINT32_MAX, .swd_conf = 5};
    struct esp32c3_watchdog timer = {.config0 = UINT32_C(0xFFBFFFFF)};

    (void)state;
    esp32c3_watchdogs_stop(&rtc, &timer);
    assert_int_equal(rtc.config0, UINT32_C(0x7FFFEFFF));
    assert_int_equal(rtc.swd_conf, UINT32_C(0x80000005));
    assert_int_equal(timer.config0, UINT32_C(0x7FFFBFFF));
    assert_int_equal(rtc.wprotect | rtc.swd_wprotect | timer.wprotect, 0);
}

static void pins_and_clocks_keep_what_is_not_theirs(void **state)
{
    static struct esp32c3_gpio gpio;
    static struct esp32c3_io_mux mux;
    const struct esp32c3_pin pin = {&gpio, &mux, 8, true}, lent = {&gpio, &mux, 6, false};
    struct esp32c3_system system = {.sysclk_conf = UINT32_C(0xF0FFF), .perip_clk_en0 = 1, .perip_rst_en0 = 2};

    (void)state;
    const struct pin output = esp32c3_gpio_output(&pin, true);
    assert_int_equal(gpio.out_w1ts, 0x100);
    assert_int_equal(gpio.func_out_sel[8], 128 + 256 + 512);
    assert_int_equal(mux.pins[8], 0x1800);
    assert_int_equal(gpio.enable_w1ts, 0x100);
    assert_int_equal(pin_set(&output, false), 0);
    assert_int_equal(gpio.out_w1tc, 0x100);
    esp32c3_gpio_lend(&lent);
    assert_int_equal(mux.pins[6], 0x2800);
    esp32c3_clock_init(&system);
    assert_int_equal(system.sysclk_conf, UINT32_C(0xF0000));
    esp32c3_system_begin(&system, ESP32C3_SPI2 | ESP32C3_SYSTIMER_PART);
    assert_int_equal(system.perip_clk_en0, 0x20000041);
    assert_int_equal(system.perip_rst_en0, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(registers_are_where_the_maker_has_them),
        cmocka_unit_test(the_rate_is_what_is_asked_for_or_the_next_slower_one),
        cmocka_unit_test(modes_are_the_makers),
        cmocka_unit_test(nothing_is_waited_for_without_end),
        cmocka_unit_test(the_first_byte_is_a_words_lowest),
        cmocka_unit_test(watchdogs_stop_and_are_locked_again),
        cmocka_unit_test(pins_and_clocks_keep_what_is_not_theirs),
    };
    return cmocka_run_group_tests_name("esp32c3", tests, NULL, NULL);
}
