/* SPDX-License-Identifier: MIT
 *
 * SPI of the STM32 with memory in the place of its registers: how it is started, which bytes it is given, and that a
 * peripheral which is silent or stuck is told and not waited for. */
#include "mcu/mcu.h"
#include "mcu/stm32_spi.h"
#include "rigs/cmocka_ready.h"

enum { TXE = 1 << 1, BSY = 1 << 7 };

static const uint8_t bytes[] = {0x2C, 0x00, 0xFF, 0x81};

static void assert_rate(uint32_t clock_hz, uint32_t spi_hz, uint32_t br)
{
    struct stm32_spi_registers registers = {.cr1 = 0xFFFF, .cr2 = 0xFFFF};
    struct stm32_spi spi;

    assert_int_equal(stm32_spi_init(&spi, &registers, clock_hz, spi_hz, 3), 0);
    assert_int_equal(registers.cr1 >> 3 & 7, br);
    assert_int_equal(registers.cr2, 0);
}

static void test_takes_the_rate_that_is_asked_for_or_the_next_slower_one(void **state)
{
    (void)state;
    assert_rate(84000000, UINT32_MAX, 0);
    assert_rate(84000000, 42000000, 0);
    assert_rate(84000000, 41999999, 1);
    assert_rate(72000000, 18000000, 1);
    assert_rate(72000000, 15000000, 2);
    assert_rate(8000000, 31250, 7);
}

static void test_refuses_a_rate_that_is_too_slow(void **state)
{
    (void)state;
    struct stm32_spi_registers registers = {0};
    struct stm32_spi spi;

    assert_int_equal(stm32_spi_init(&spi, &registers, 8000000, 31249, 3), MCU_ERR_CONFIG);
    assert_int_equal(registers.cr1, 0);
}

/* RM0008 25.5.1: one line, an output; select by software, high; enabled; master; CPOL is bit 1, CPHA bit 0. */
static void test_is_a_master_in_any_mode_that_only_sends_bytes(void **state)
{
    static const uint32_t cr1[] = {0xC344, 0xC345, 0xC346, 0xC347};
    (void)state;

    for (uint8_t mode = 0; mode < 4; mode++) {
        struct stm32_spi_registers registers = {0};
        struct stm32_spi spi;
        assert_int_equal(stm32_spi_init(&spi, &registers, 72000000, 36000000, mode), 0);
        assert_int_equal(registers.cr1, cr1[mode]);
    }
}

static struct bus bus_of(struct stm32_spi *spi, struct stm32_spi_registers *registers, uint32_t status)
{
    assert_int_equal(stm32_spi_init(spi, registers, 72000000, 36000000, 3), 0);
    registers->sr = status;
    registers->dr = 0x55;
    return stm32_spi_bus(spi);
}

/* Memory keeps only the last byte: each beginning of the message shows one. */
static void test_sends_bytes_in_order(void **state)
{
    (void)state;
    struct stm32_spi_registers registers = {0};
    struct stm32_spi spi;
    const struct bus bus = bus_of(&spi, &registers, TXE);

    assert_int_equal(bus_write(&bus, bytes, 0), 0);
    assert_int_equal(registers.dr, 0x55);
    for (size_t n_b = 1; n_b <= sizeof bytes; n_b++) {
        assert_int_equal(bus_write(&bus, bytes, n_b), 0);
        assert_int_equal(registers.dr, bytes[n_b - 1]);
    }
    assert_int_equal(bus_flush(&bus), 0);
}

static void test_tells_that_the_data_register_stays_full(void **state)
{
    (void)state;
    struct stm32_spi_registers registers = {0};
    struct stm32_spi spi;
    const struct bus bus = bus_of(&spi, &registers, 0);

    assert_int_equal(bus_write(&bus, bytes, sizeof bytes), MCU_ERR_TIMEOUT);
    assert_int_equal(registers.dr, 0x55);
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
}

static void test_tells_that_the_last_byte_does_not_leave(void **state)
{
    (void)state;
    struct stm32_spi_registers registers = {0};
    struct stm32_spi spi;
    const struct bus bus = bus_of(&spi, &registers, TXE | BSY);

    assert_int_equal(bus_write(&bus, bytes, sizeof bytes), 0);
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_takes_the_rate_that_is_asked_for_or_the_next_slower_one),
        cmocka_unit_test(test_refuses_a_rate_that_is_too_slow),
        cmocka_unit_test(test_is_a_master_in_any_mode_that_only_sends_bytes),
        cmocka_unit_test(test_sends_bytes_in_order),
        cmocka_unit_test(test_tells_that_the_data_register_stays_full),
        cmocka_unit_test(test_tells_that_the_last_byte_does_not_leave),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
