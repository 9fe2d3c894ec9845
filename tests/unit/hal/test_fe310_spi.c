/* SPDX-License-Identifier: MIT
 *
 * SPI of the FE310 with memory in the place of its registers, whose receiver holds a byte always or never: how it is
 * started, which bytes it is given, and that none is waited for without end. */
#include "mcu/fe310_spi.h"
#include "mcu/mcu.h"
#include "rigs/cmocka_ready.h"

enum { ROOM_B = 8, NOTHING = 0x55 };
#define EMPTY (UINT32_C(1) << 31)

static const uint8_t bytes[20] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20};

static struct fe310_spi_registers registers;
static struct fe310_spi spi;

static struct bus bus_of(uint32_t rxdata)
{
    registers = (struct fe310_spi_registers){.rxdata = rxdata, .txdata = NOTHING, .sckmode = 9, .csmode = 9, .fmt = 9};
    assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, 32000000, 3), 0);
    return fe310_spi_bus(&spi);
}

static void assert_rate(uint32_t spi_hz, uint32_t sckdiv)
{
    assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, spi_hz, 3), 0);
    assert_int_equal(registers.sckdiv, sckdiv);
}

static void test_takes_the_rate_that_is_asked_for_or_the_next_slower_one(void **state)
{
    (void)state;
    assert_rate(UINT32_MAX, 0);
    assert_rate(128000000, 0);
    assert_rate(127999999, 1);
    assert_rate(32000000, 3);
    assert_rate(31250, 4095);
}

static void test_refuses_a_rate_that_is_too_slow(void **state)
{
    (void)state;
    registers = (struct fe310_spi_registers){0};
    assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, 31249, 3), MCU_ERR_CONFIG);
    assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, 0, 3), MCU_ERR_CONFIG);
    assert_int_equal(registers.fmt, 0);
}

/* Chapter 19 of the manual: bit 0 of sckmode is the phase, bit 1 the polarity. */
static void test_modes_are_polarity_and_phase(void **state)
{
    static const uint32_t bits[] = {0x0, 0x1, 0x2, 0x3};
    (void)state;

    for (uint8_t mode = 0; mode < 4; mode++) {
        registers = (struct fe310_spi_registers){.sckmode = 9};
        assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, 32000000, mode), 0);
        assert_int_equal(registers.sckmode, bits[mode]);
    }
}

static void test_sends_bytes_and_leaves_chip_select_alone(void **state)
{
    (void)state;
    (void)bus_of(0);
    assert_int_equal(registers.csmode, 3);
    assert_int_equal(registers.fmt, 0x80000);
    assert_int_equal(registers.txdata, NOTHING);
}

/* Memory keeps only the last byte: each beginning of the message shows one. */
static void test_sends_bytes_in_order(void **state)
{
    (void)state;
    const struct bus bus = bus_of(0);

    for (size_t n_b = 1; n_b <= sizeof bytes; n_b++) {
        assert_int_equal(bus_write(&bus, bytes, n_b), 0);
        assert_int_equal(registers.txdata, bytes[n_b - 1]);
    }
    assert_int_equal(spi.on_their_way, ROOM_B);
    assert_int_equal(bus_flush(&bus), 0);
}

static void test_sends_no_more_than_the_receiver_has_room_for(void **state)
{
    (void)state;
    const struct bus bus = bus_of(EMPTY);

    assert_int_equal(bus_write(&bus, bytes, ROOM_B), 0);
    assert_int_equal(bus_write(&bus, bytes + ROOM_B, 1), MCU_ERR_TIMEOUT);
    assert_int_equal(registers.txdata, bytes[ROOM_B - 1]);
}

static void test_a_flush_waits_for_every_byte(void **state)
{
    (void)state;
    const struct bus bus = bus_of(EMPTY);

    assert_int_equal(bus_flush(&bus), 0);
    assert_int_equal(bus_write(&bus, bytes, 1), 0);
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
    registers.rxdata = 0;
    assert_int_equal(bus_flush(&bus), 0);
    registers.rxdata = EMPTY;
    assert_int_equal(bus_flush(&bus), 0);
}

static void test_a_new_start_expects_nothing(void **state)
{
    (void)state;
    const struct bus bus = bus_of(EMPTY);

    assert_int_equal(bus_write(&bus, bytes, ROOM_B), 0);
    assert_int_equal(fe310_spi_init(&spi, &registers, 256000000, 32000000, 3), 0);
    assert_int_equal(bus_flush(&bus), 0);
    assert_int_equal(bus_write(&bus, bytes, ROOM_B), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_takes_the_rate_that_is_asked_for_or_the_next_slower_one),
        cmocka_unit_test(test_refuses_a_rate_that_is_too_slow),
        cmocka_unit_test(test_modes_are_polarity_and_phase),
        cmocka_unit_test(test_sends_bytes_and_leaves_chip_select_alone),
        cmocka_unit_test(test_sends_bytes_in_order),
        cmocka_unit_test(test_sends_no_more_than_the_receiver_has_room_for),
        cmocka_unit_test(test_a_flush_waits_for_every_byte),
        cmocka_unit_test(test_a_new_start_expects_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
