/* SPDX-License-Identifier: MIT
 *
 * A DMA stream of the STM32F4 with memory in the place of its registers: what it is told, and that a stream which has
 * stopped, or cannot read, is told and not waited for. */
#include "mcu/mcu.h"
#include "mcu/stm32_dma.h"
#include "rigs/cmocka_ready.h"

enum { STREAM = 3, CHANNEL = 3, TXE = 1 << 1, BSY = 1 << 7, TXDMAEN = 2, POLLED_MAX_B = 16 };
#define ERROR (UINT32_C(8) << 22) /* RM0090 10.5.1: stream 3 begins at bit 22 */
#define COMPLETE (UINT32_C(32) << 22)
#define CONFIGURED UINT32_C(0x06000440) /* channel 3, memory counts up, from memory to peripheral, bytes */

static uint8_t message[200000];

static struct rig {
    struct stm32_dma_registers registers;
    struct stm32_spi_registers spi_registers;
    struct stm32_spi spi;
    struct stm32_dma dma;
    struct bus bus;
} rig;

static struct stm32_dma_stream *const stream = &rig.registers.streams[STREAM];

static uint32_t low_word(const volatile void *at)
{
    return (uint32_t)(uintptr_t)at;
}

static int set_up(void **state)
{
    (void)state;
    rig = (struct rig){.registers.streams[STREAM].cr = 1, .registers.streams[STREAM].fcr = 0x21};
    assert_int_equal(stm32_spi_init(&rig.spi, &rig.spi_registers, 84000000, 42000000, 3), 0);
    assert_int_equal(stm32_dma_init(&rig.dma, &rig.registers, STREAM, CHANNEL, &rig.spi), 0);
    rig.bus = stm32_dma_bus(&rig.dma);
    rig.spi_registers.sr = TXE;
    return 0;
}

static void test_joins_the_stream_to_the_spi(void **state)
{
    (void)state;
    assert_int_equal(stream->cr, CONFIGURED);
    assert_int_equal(stream->fcr, 0);
    assert_int_equal(stream->par, low_word(&rig.spi_registers.dr));
    assert_int_equal(rig.spi_registers.cr2, 0);
}

static void assert_started(const uint8_t *data, uint32_t n_b)
{
    assert_int_equal(stream->cr, CONFIGURED | 1);
    assert_int_equal(stream->m0ar, low_word(data));
    assert_int_equal(stream->ndtr, n_b);
    assert_int_equal(rig.registers.ifcr[0], 0x3D << 22);
    assert_int_equal(rig.spi_registers.cr2, TXDMAEN);
}

static void test_a_write_returns_while_it_goes_on(void **state)
{
    (void)state;
    rig.spi_registers.dr = 0x55;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    assert_started(message, 480);
    assert_int_equal(rig.spi_registers.dr, 0x55);
}

static void test_a_flush_waits_for_stream_and_spi(void **state)
{
    (void)state;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    rig.registers.isr[0] = COMPLETE;
    rig.spi_registers.sr = TXE | BSY;
    assert_int_equal(bus_flush(&rig.bus), MCU_ERR_TIMEOUT);
    rig.spi_registers.sr = TXE;
    assert_int_equal(bus_flush(&rig.bus), 0);
    assert_int_equal(stream->cr, CONFIGURED);
    assert_int_equal(rig.spi_registers.cr2, 0);
}

static void test_the_next_write_waits_for_the_last(void **state)
{
    (void)state;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    assert_int_equal(bus_write(&rig.bus, message + 480, 480), MCU_ERR_TIMEOUT);
    assert_int_equal(stream->cr, CONFIGURED);
    rig.registers.isr[0] = COMPLETE;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    assert_int_equal(bus_write(&rig.bus, message + 480, 17), 0);
    assert_started(message + 480, 17);
}

static void test_the_stream_tells_what_is_left(void **state)
{
    (void)state;
    assert_int_equal(bus_left_b(&rig.bus), 0);
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    stream->ndtr = 33;
    assert_int_equal(bus_left_b(&rig.bus), 33);
    rig.registers.isr[0] = COMPLETE;
    assert_int_equal(bus_flush(&rig.bus), 0);
    assert_int_equal(bus_left_b(&rig.bus), 0);
}

static void test_few_bytes_need_no_stream(void **state)
{
    (void)state;
    for (uint8_t i = 0; i < POLLED_MAX_B; i++)
        message[i] = (uint8_t)(i + 1);
    assert_int_equal(bus_write(&rig.bus, message, POLLED_MAX_B), 0);
    assert_int_equal(rig.spi_registers.dr, POLLED_MAX_B);
    assert_int_equal(stream->cr, CONFIGURED);
    assert_int_equal(bus_flush(&rig.bus), 0);
    assert_int_equal(bus_write(&rig.bus, message, POLLED_MAX_B + 1), 0);
    assert_started(message, POLLED_MAX_B + 1);
}

static void test_a_long_message_goes_in_parts(void **state)
{
    (void)state;
    rig.registers.isr[0] = COMPLETE;
    assert_int_equal(bus_write(&rig.bus, message, 65535), 0);
    assert_started(message, 65535);
    assert_int_equal(bus_write(&rig.bus, message, sizeof message), 0);
    assert_started(message + 3 * 65535, sizeof message - 3 * 65535);
}

static void test_a_stream_that_cannot_read_is_told(void **state)
{
    (void)state;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    rig.registers.isr[0] = ERROR | COMPLETE;
    assert_int_equal(bus_flush(&rig.bus), MCU_ERR_BUS);
    assert_int_equal(bus_flush(&rig.bus), 0);
}

static void test_other_streams_do_not_count(void **state)
{
    (void)state;
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    rig.registers.isr[0] = ~(ERROR | COMPLETE);
    rig.registers.isr[1] = UINT32_MAX;
    assert_int_equal(bus_flush(&rig.bus), MCU_ERR_TIMEOUT);
}

static void assert_complete_at(uint8_t at, unsigned half, uint32_t flag)
{
    assert_int_equal(stm32_dma_init(&rig.dma, &rig.registers, at, CHANNEL, &rig.spi), 0);
    assert_int_equal(bus_write(&rig.bus, message, 480), 0);
    rig.registers.isr[half] = flag;
    assert_int_equal(bus_flush(&rig.bus), 0);
    rig.registers.isr[half] = 0;
}

/* RM0090 10.5.1 and 10.5.2. */
static void test_every_stream_has_its_own_flags(void **state)
{
    (void)state;
    assert_complete_at(0, 0, UINT32_C(1) << 5);
    assert_complete_at(1, 0, UINT32_C(1) << 11);
    assert_complete_at(2, 0, UINT32_C(1) << 21);
    assert_complete_at(3, 0, UINT32_C(1) << 27);
    assert_complete_at(4, 1, UINT32_C(1) << 5);
    assert_complete_at(7, 1, UINT32_C(1) << 27);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_joins_the_stream_to_the_spi, set_up),
        cmocka_unit_test_setup(test_a_write_returns_while_it_goes_on, set_up),
        cmocka_unit_test_setup(test_a_flush_waits_for_stream_and_spi, set_up),
        cmocka_unit_test_setup(test_the_next_write_waits_for_the_last, set_up),
        cmocka_unit_test_setup(test_the_stream_tells_what_is_left, set_up),
        cmocka_unit_test_setup(test_few_bytes_need_no_stream, set_up),
        cmocka_unit_test_setup(test_a_long_message_goes_in_parts, set_up),
        cmocka_unit_test_setup(test_a_stream_that_cannot_read_is_told, set_up),
        cmocka_unit_test_setup(test_other_streams_do_not_count, set_up),
        cmocka_unit_test_setup(test_every_stream_has_its_own_flags, set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
