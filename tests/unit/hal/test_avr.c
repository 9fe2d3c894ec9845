/* SPDX-License-Identifier: MIT
 *
 * Drivers of AVR microcontrollers, with memory in the place of their registers: what they set up, and that a peripheral
 * that says nothing ends a wait. */
#include "mcu/avr_gpio.h"
#include "mcu/avr_spi.h"
#include "mcu/avr_timer.h"
#include "rigs/cmocka_ready.h"

static void a_rate_is_the_next_slower_one(void **state)
{
    static const struct {
        uint32_t spi_hz;
        uint8_t spr, doubled;
    } rates[] = {{16000000, 0, 1}, {8000000, 0, 1}, {7999999, 0, 0}, {2000000, 1, 1}, {1000000, 1, 0},
                 {500000, 2, 1},   {250000, 2, 0},  {249999, 3, 0},  {125000, 3, 0}};
    (void)state;

    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) {
        struct avr_spi_registers registers = {0};
        struct avr_spi spi;
        assert_int_equal(avr_spi_init(&spi, &registers, 16000000, rates[i].spi_hz, 0), 0);
        assert_int_equal(registers.spcr, AVR_SPCR_SPE | AVR_SPCR_MSTR | rates[i].spr);
        assert_int_equal(registers.spsr, rates[i].doubled);
    }
}

static void a_rate_too_slow_is_refused(void **state)
{
    (void)state;
    struct avr_spi_registers registers = {0};
    struct avr_spi spi;

    assert_int_equal(avr_spi_init(&spi, &registers, 16000000, 124999, 0), MCU_ERR_CONFIG);
    assert_int_equal(avr_spi_init(&spi, &registers, 16000000, 0, 0), MCU_ERR_CONFIG);
    assert_int_equal(registers.spcr, 0);
}

/* Table 17-2 of the manual: CPOL is bit 3 of SPCR, CPHA bit 2. */
static void modes_are_polarity_and_phase(void **state)
{
    static const uint8_t bits[] = {0x00, 0x04, 0x08, 0x0C};
    (void)state;

    for (uint8_t mode = 0; mode < 4; mode++) {
        struct avr_spi_registers registers = {0};
        struct avr_spi spi;
        assert_int_equal(avr_spi_init(&spi, &registers, 16000000, 8000000, mode), 0);
        assert_int_equal(registers.spcr, 0x50 | bits[mode]);
    }
}

static void every_byte_waits_for_its_end(void **state)
{
    (void)state;
    const uint8_t data[] = {0x12, 0x34, 0x56};
    struct avr_spi_registers registers = {0};
    struct avr_spi spi;

    assert_int_equal(avr_spi_init(&spi, &registers, 16000000, 8000000, 0), 0);
    const struct bus bus = avr_spi_bus(&spi);
    registers.spsr |= AVR_SPSR_SPIF;
    assert_int_equal(bus_write(&bus, data, sizeof data), 0);
    assert_int_equal(registers.spdr, 0x56);
    assert_int_equal(bus_flush(&bus), 0);
    registers.spsr = 0;
    assert_int_equal(bus_write(&bus, data, sizeof data), MCU_ERR_TIMEOUT);
    assert_int_equal(registers.spdr, 0x12);
}

static void a_pin_leaves_its_port_alone(void **state)
{
    (void)state;
    struct avr_gpio_registers port = {.ddr = 0x01, .port = 0x81};
    struct avr_output output;
    const struct pin pin = avr_gpio_output(&output, &port, 4, true);

    assert_int_equal(port.ddr, 0x11);
    assert_int_equal(port.port, 0x91);
    assert_int_equal(pin_set(&pin, false), 0);
    assert_int_equal(port.port, 0x81);
    assert_int_equal(pin_set(&pin, true), 0);
    assert_int_equal(port.port, 0x91);
}

static void a_light_that_sinks_is_lit_by_a_low_level(void **state)
{
    (void)state;
    struct avr_gpio_registers port = {0};
    struct avr_output output;
    const struct pin led = avr_gpio_sink(&output, &port, 7);

    assert_int_equal(port.ddr, 0x80);
    assert_int_equal(port.port, 0x80); /* dark */
    assert_int_equal(pin_set(&led, true), 0);
    assert_int_equal(port.port, 0);
}

static void inputs_are_pulled_up(void **state)
{
    (void)state;
    struct avr_gpio_registers port = {.ddr = 0xFF, .port = 0x01};

    avr_gpio_inputs(&port, 0xF0);
    assert_int_equal(port.ddr, 0x0F);
    assert_int_equal(port.port, 0xF1);
}

static void the_timer_runs_at_an_eighth(void **state)
{
    (void)state;
    struct avr_timer_registers registers = {.tccra = 3, .tccrb = 5};
    struct avr_timer timer;

    assert_int_equal(avr_timer_init(&timer, &registers, 16000000), 0);
    assert_int_equal(registers.tccra, 0);
    assert_int_equal(registers.tccrb, 2);
    assert_int_equal(timer.ticks_per_us, 2);
    assert_int_equal(avr_timer_init(&timer, &registers, 12000000), 0);
    assert_int_equal(timer.ticks_per_us, 2); /* rounded up */
    assert_int_equal(avr_timer_init(&timer, &registers, 0), MCU_ERR_CONFIG);
    assert_int_equal(avr_timer_init(&timer, &registers, UINT32_MAX), MCU_ERR_CONFIG);
}

static void a_timer_that_stands_still_ends_a_wait(void **state)
{
    (void)state;
    struct avr_timer_registers registers = {0};
    struct avr_timer timer;

    assert_int_equal(avr_timer_init(&timer, &registers, 16000000), 0);
    const struct clock clock = avr_timer_clock(&timer);
    assert_int_equal(clock_delay(&clock, 0), MCU_ERR_TIMEOUT);
    assert_int_equal(clock_delay(&clock, 1000000), MCU_ERR_TIMEOUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rate_is_the_next_slower_one),
        cmocka_unit_test(a_rate_too_slow_is_refused),
        cmocka_unit_test(modes_are_polarity_and_phase),
        cmocka_unit_test(every_byte_waits_for_its_end),
        cmocka_unit_test(a_pin_leaves_its_port_alone),
        cmocka_unit_test(a_light_that_sinks_is_lit_by_a_low_level),
        cmocka_unit_test(inputs_are_pulled_up),
        cmocka_unit_test(the_timer_runs_at_an_eighth),
        cmocka_unit_test(a_timer_that_stands_still_ends_a_wait),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
