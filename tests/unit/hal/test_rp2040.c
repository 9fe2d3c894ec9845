/* SPDX-License-Identifier: MIT
 *
 * The RP2040's clocks, pins and DMA with memory in the place of registers: what is written where, and that whatever
 * stands still ends a wait. What moves is seen in an emulator, tests/boards/boards_pico.sh. */
#include "mcu/mcu.h"
#include "mcu/rp2040_clocks.h"
#include "mcu/rp2040_dma.h"
#include "mcu/sio_gpio.h"
#include "rigs/cmocka_ready.h"

#define BUSY (UINT32_C(1) << 24)
#define AHB_ERROR (UINT32_C(1) << 31)
#define READ_ERROR (UINT32_C(1) << 30)
#define STABLE (UINT32_C(1) << 31)
#define ALL_RESETS UINT32_C(0x01FFFFFF)

enum { CHANNEL = 3, DREQ = 16 };

/* -- Clocks ------------------------------------------------------------------------------------ */

struct clock_tree {
    struct rp2040_resets_registers resets;
    struct rp2040_xosc_registers xosc;
    struct rp2040_pll_registers pll_sys;
    struct rp2040_clocks_registers clocks;
};

static int init_clocks(struct clock_tree *tree)
{
    return rp2040_clocks_init(&(struct rp2040_clocks){&tree->resets, &tree->xosc, &tree->pll_sys, &tree->clocks});
}

static void test_a_peripheral_that_stays_in_reset_ends_the_wait(void **state)
{
    (void)state;
    struct rp2040_resets_registers resets = {.reset = ALL_RESETS};
    assert_int_equal(rp2040_release(&resets, RP2040_RESET_SPI0), MCU_ERR_TIMEOUT);
    assert_int_equal(resets.reset, ALL_RESETS & ~RP2040_RESET_SPI0);
    resets.reset_done = RP2040_RESET_SPI0;
    assert_int_equal(rp2040_reset(&resets, RP2040_RESET_SPI0), 0);
}

static void test_a_silent_crystal_leaves_the_clocks_as_they_were(void **state)
{
    (void)state;
    struct clock_tree tree = {.clocks.sys.ctrl = 0x55, .clocks.ref.ctrl = 0x55};
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.xosc.ctrl, 0x00FABAA0);
    assert_int_equal(tree.clocks.sys.ctrl, 0x55);
    assert_int_equal(tree.clocks.ref.ctrl, 0x55);
}

static void test_a_multiplexer_that_does_not_switch_ends_the_wait(void **state)
{
    (void)state;
    struct clock_tree tree = {.xosc.status = STABLE};
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    tree.clocks.sys.selected = 1;
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.clocks.ref.ctrl, 2); /* XOSC was asked for, last */
    assert_int_equal(tree.pll_sys.fbdiv_int, 0);
}

/* What another program ran clk_sys by stays its auxiliary source until it runs by clk_ref. */
static void test_an_auxiliary_source_in_use_is_not_changed(void **state)
{
    (void)state;
    struct clock_tree tree = {.xosc.status = STABLE, .clocks.sys.ctrl = 0x61, .clocks.ref.ctrl = 0x21};
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.clocks.sys.ctrl, 0x60);
    tree.clocks.sys.selected = 1;
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.clocks.ref.ctrl, 0x22);
}

static void test_a_pll_without_a_lock_is_not_switched_to(void **state)
{
    (void)state;
    struct clock_tree tree = {.resets.reset_done = ALL_RESETS,
                              .xosc.status = STABLE,
                              .pll_sys.pwr = 0x2D,
                              .clocks.sys.selected = 3,
                              .clocks.ref.selected = 4};
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.clocks.sys.ctrl, 0); /* clk_ref */
    assert_int_equal(tree.pll_sys.cs, 1);
    assert_int_equal(tree.pll_sys.fbdiv_int, 125);
    assert_int_equal(tree.pll_sys.pwr, 0x0C); /* its oscillator runs, its dividers do not yet */
}

/* -- Pins -------------------------------------------------------------------------------------- */

struct pins {
    struct sio_registers sio;
    struct io_bank0_registers io;
    struct pads_bank0_registers pads;
};

static void test_an_output_is_one_bit_of_the_bank(void **state)
{
    (void)state;
    struct pins pins = {0};
    struct sio_output output;
    const struct pin pin = sio_gpio_output(&output, &(struct sio_gpio){&pins.sio, &pins.io, &pins.pads}, 25, true);

    assert_int_equal(pins.sio.gpio_out_set, UINT32_C(1) << 25);
    assert_int_equal(pins.sio.gpio_out_clr, 0);
    assert_int_equal(pins.sio.gpio_oe_set, UINT32_C(1) << 25);
    assert_int_equal(pins.io.gpio[25].ctrl, 5);
    assert_int_equal(pins.pads.gpio[25], SIO_GPIO_SLOW);
    assert_int_equal(pin_set(&pin, false), 0);
    assert_int_equal(pins.sio.gpio_out_clr, UINT32_C(1) << 25);
    assert_int_equal(pins.sio.gpio_out, 0); /* nobody else's bits are written */
}

static void test_an_input_is_one_bit_of_the_bank(void **state)
{
    (void)state;
    struct pins pins = {.sio.gpio_in = UINT32_C(1) << 12};
    const struct sio_gpio gpio = {&pins.sio, &pins.io, &pins.pads};
    assert_true(sio_gpio_read(&gpio, 12));
    assert_false(sio_gpio_read(&gpio, 13));
}

/* -- DMA --------------------------------------------------------------------------------------- */

struct sender {
    struct pl022_registers spi_registers;
    struct rp2040_dma_registers dma_registers;
    struct pl022 spi;
    struct rp2040_dma dma;
    struct bus bus;
};

static const uint8_t data[64] = {1, 2, 3};

/* An SPI that has always sent everything. */
static struct rp2040_dma_channel_registers *set_up(struct sender *sender)
{
    const struct pl022_config config = {.clock_hz = 125000000, .spi_hz = 62500000, .mode = 3};

    *sender = (struct sender){.spi_registers.sr = PL022_SR_TFE | PL022_SR_TNF};
    assert_int_equal(pl022_init(&sender->spi, &sender->spi_registers, &config), 0);
    rp2040_dma_init(&sender->dma, &sender->dma_registers, CHANNEL, &sender->spi, DREQ);
    sender->bus = rp2040_dma_bus(&sender->dma);
    return &sender->dma_registers.ch[CHANNEL];
}

static void test_a_line_is_left_to_the_channel(void **state)
{
    (void)state;
    struct sender sender;
    const struct rp2040_dma_channel_registers *channel = set_up(&sender);

    assert_int_equal(bus_write(&sender.bus, data, sizeof data), 0);
    assert_int_equal(channel->read_addr, (uint32_t)(uintptr_t)data);
    assert_int_equal(channel->write_addr, (uint32_t)(uintptr_t)&sender.spi_registers.dr);
    assert_int_equal(channel->trans_count, sizeof data);
    /* Enabled, bytes, addresses rise on the reading side, chained to nobody, the FIFO's request; errors cleared. */
    assert_int_equal(channel->ctrl_trig, 0xE0000000 | 1u << 21 | DREQ << 15 | CHANNEL << 11 | 1u << 4 | 1u);
    assert_int_equal(sender.spi_registers.dmacr, PL022_DMACR_TXDMAE);
    assert_int_equal(sender.spi_registers.dr, 0); /* none of it is polled */
}

static void test_the_channel_tells_what_is_left(void **state)
{
    (void)state;
    struct sender sender;
    struct rp2040_dma_channel_registers *channel = set_up(&sender);

    assert_int_equal(bus_left_b(&sender.bus), 0);
    assert_int_equal(bus_write(&sender.bus, data, sizeof data), 0);
    channel->ctrl_trig |= BUSY;
    channel->trans_count = 7;
    assert_int_equal(bus_left_b(&sender.bus), 7);
    channel->ctrl_trig &= ~BUSY;
    assert_int_equal(bus_left_b(&sender.bus), 0);
}

static void test_a_few_bytes_are_polled(void **state)
{
    (void)state;
    struct sender sender;
    const struct rp2040_dma_channel_registers *channel = set_up(&sender);

    assert_int_equal(bus_write(&sender.bus, data, 3), 0);
    assert_int_equal(sender.spi_registers.dr, data[2]);
    assert_int_equal(channel->ctrl_trig, 0);
}

static void test_a_channel_that_stands_still_is_stopped(void **state)
{
    (void)state;
    struct sender sender;
    struct rp2040_dma_channel_registers *channel = set_up(&sender);

    channel->ctrl_trig = BUSY | 1u;
    channel->trans_count = 5;
    assert_int_equal(bus_write(&sender.bus, data, sizeof data), MCU_ERR_TIMEOUT);
    assert_int_equal(channel->ctrl_trig & 1u, 0);
    assert_int_equal(sender.dma_registers.chan_abort, 1u << CHANNEL);
    assert_int_equal(channel->trans_count, 5); /* the new bytes have not been begun */
    assert_int_equal(bus_flush(&sender.bus), MCU_ERR_TIMEOUT);
}

static void test_what_cannot_be_read_is_told(void **state)
{
    (void)state;
    struct sender sender;
    struct rp2040_dma_channel_registers *channel = set_up(&sender);

    channel->ctrl_trig = AHB_ERROR | READ_ERROR;
    assert_int_equal(bus_write(&sender.bus, data, sizeof data), MCU_ERR_BUS);
    assert_int_equal(channel->ctrl_trig, 0xE0000000); /* written as ones, the errors are cleared */
    assert_int_equal(channel->trans_count, 0);
    channel->ctrl_trig = 0;
    assert_int_equal(bus_flush(&sender.bus), 0);
}

static void test_an_spi_that_stays_busy_ends_the_flush(void **state)
{
    (void)state;
    struct sender sender;
    (void)set_up(&sender);

    sender.spi_registers.sr = PL022_SR_TFE | PL022_SR_TNF | PL022_SR_BSY;
    assert_int_equal(bus_write(&sender.bus, data, sizeof data), 0);
    sender.dma_registers.ch[CHANNEL].ctrl_trig = 0;
    assert_int_equal(bus_flush(&sender.bus), MCU_ERR_TIMEOUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_peripheral_that_stays_in_reset_ends_the_wait),
        cmocka_unit_test(test_a_silent_crystal_leaves_the_clocks_as_they_were),
        cmocka_unit_test(test_a_multiplexer_that_does_not_switch_ends_the_wait),
        cmocka_unit_test(test_an_auxiliary_source_in_use_is_not_changed),
        cmocka_unit_test(test_a_pll_without_a_lock_is_not_switched_to),
        cmocka_unit_test(test_an_output_is_one_bit_of_the_bank),
        cmocka_unit_test(test_an_input_is_one_bit_of_the_bank),
        cmocka_unit_test(test_a_line_is_left_to_the_channel),
        cmocka_unit_test(test_the_channel_tells_what_is_left),
        cmocka_unit_test(test_a_few_bytes_are_polled),
        cmocka_unit_test(test_a_channel_that_stands_still_is_stopped),
        cmocka_unit_test(test_what_cannot_be_read_is_told),
        cmocka_unit_test(test_an_spi_that_stays_busy_ends_the_flush),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
