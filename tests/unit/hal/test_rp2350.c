/* SPDX-License-Identifier: MIT
 *
 * The RP2350's clocks, pins and DMA with memory in the place of registers: what is written where, and in which the chip
 * is not as the RP2040, whose tests (test_rp2040.c) hold for the code that both share. Offsets and bits are those of
 * raspberrypi/pico-sdk, src/rp2350/hardware_regs/include/hardware/regs. */
#include "mcu/mcu.h"
#include "mcu/rp2350_clocks.h"
#include "mcu/rp2350_dma.h"
#include "mcu/rp2350_gpio.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/watched_registers.h"

#define STABLE (UINT32_C(1) << 31)
#define AT(type, member) offsetof(struct type, member)

enum { CHANNEL = 13, DREQ = 24 };

/* addressmap.h, sio.h, io_bank0.h, pads_bank0.h, clocks.h, resets.h, pll.h, xosc.h, dma.h, dreq.h. */
static void test_registers_are_where_the_makers_headers_have_them(void **state)
{
    (void)state;
    assert_int_equal((uintptr_t)RP2350_CLOCKS_REGISTERS, 0x40010000);
    assert_int_equal((uintptr_t)RP2350_RESETS_REGISTERS, 0x40020000);
    assert_int_equal((uintptr_t)RP2350_IO_BANK0_REGISTERS, 0x40028000);
    assert_int_equal((uintptr_t)RP2350_PADS_BANK0_REGISTERS, 0x40038000);
    assert_int_equal((uintptr_t)RP2350_XOSC_REGISTERS, 0x40048000);
    assert_int_equal((uintptr_t)RP2350_PLL_SYS_REGISTERS, 0x40050000);
    assert_int_equal((uintptr_t)RP2350_PLL_USB_REGISTERS, 0x40058000);
    assert_int_equal((uintptr_t)RP2350_SPI0_REGISTERS, 0x40080000);
    assert_int_equal((uintptr_t)RP2350_DMA_REGISTERS, 0x50000000);
    assert_int_equal((uintptr_t)RP2350_SIO_REGISTERS, 0xD0000000);
    assert_int_equal(AT(rp2350_sio_registers, gpio_in), 0x04);
    assert_int_equal(AT(rp2350_sio_registers, gpio_out_set), 0x18);
    assert_int_equal(AT(rp2350_sio_registers, gpio_out_clr), 0x20);
    assert_int_equal(AT(rp2350_sio_registers, gpio_oe_set), 0x38);
    assert_int_equal(AT(io_bank0_registers, gpio[1].ctrl), 0x0C);
    assert_int_equal(AT(pads_bank0_registers, gpio[0]), 0x04);
    assert_int_equal(AT(rp2040_clocks_registers, ref.ctrl), 0x30);
    assert_int_equal(AT(rp2040_clocks_registers, sys.selected), 0x44);
    assert_int_equal(AT(rp2040_clocks_registers, peri.div), 0x4C);
    assert_int_equal(AT(rp2040_resets_registers, reset_done), 0x08);
    assert_int_equal(AT(rp2040_pll_registers, prim), 0x0C);
    assert_int_equal(AT(rp2040_xosc_registers, startup), 0x0C);
    assert_int_equal(AT(rp2350_dma_registers, ch[15].trans_count), 0x3C8);
    assert_int_equal(AT(rp2350_dma_registers, chan_abort), 0x464);
    assert_int_equal(RP2350_DREQ_SPI0_TX, 24);
    assert_int_equal(RP2350_RESET_DMA, 0x4);
    assert_int_equal(RP2350_RESET_IO_BANK0, 0x40);
    assert_int_equal(RP2350_RESET_PADS_BANK0, 0x200);
    assert_int_equal(RP2350_RESET_PLL_SYS, 0x4000);
    assert_int_equal(RP2350_RESET_PLL_USB, 0x8000);
    assert_int_equal(RP2350_RESET_SPI0, 0x40000);
}

/* -- Clocks ------------------------------------------------------------------------------------ */

struct clock_tree {
    struct rp2040_resets_registers resets;
    struct rp2040_xosc_registers xosc;
    struct rp2040_pll_registers pll_sys, pll_usb;
    struct rp2040_clocks_registers clocks;
};

static int init_clocks(struct clock_tree *tree)
{
    return rp2350_clocks_init(&(struct rp2040_clocks){&tree->resets, &tree->xosc, &tree->pll_sys, &tree->clocks},
                              &tree->pll_usb);
}

static void test_a_silent_crystal_leaves_the_clocks_as_they_were(void **state)
{
    (void)state;
    struct clock_tree tree = {.clocks.sys.ctrl = 0x41};
    assert_int_equal(init_clocks(&tree), MCU_ERR_TIMEOUT);
    assert_int_equal(tree.clocks.sys.ctrl, 0x41);
    assert_int_equal(tree.clocks.peri.ctrl, 0);
}

/* A tree on which everything comes at once, but for what a PLL's own registers are. */
static void lock(struct clock_tree *tree, size_t at_b)
{
    if (at_b == AT(clock_tree, pll_sys.cs)) tree->pll_sys.cs |= UINT32_C(1) << 31;
    if (at_b == AT(clock_tree, pll_usb.cs)) tree->pll_usb.cs |= UINT32_C(1) << 31;
}

static struct clock_tree *watched_tree;
static bool is_usb_silent;

static void comes_at_once(size_t at_b)
{
    if (!is_usb_silent || at_b != AT(clock_tree, pll_usb.cs)) lock(watched_tree, at_b);
}

/* 12 MHz * 125 / 5 / 2 = 150 MHz, and / 6 / 2 = 125 MHz. */
static void test_the_processor_has_150_mhz_and_spi_125(void **state)
{
    (void)state;
    if (!watched_is_possible()) skip();
    struct clock_tree *const tree = watched_tree = watched_begin();
    tree->resets.reset_done = UINT32_MAX;
    tree->xosc.status = STABLE;
    tree->pll_sys.pwr = tree->pll_usb.pwr = 0x2D;
    tree->clocks.sys.selected = 3;
    tree->clocks.ref.selected = 4;
    tree->clocks.peri = (struct rp2040_clock_registers){.ctrl = 0x820, .div = 3};
    is_usb_silent = false;
    watched.before_read = comes_at_once;
    watched_start();
    const int err = init_clocks(tree);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(tree->pll_sys.fbdiv_int, 125);
    assert_int_equal(tree->pll_sys.prim, 0x52000);
    assert_int_equal(tree->pll_usb.fbdiv_int, 125);
    assert_int_equal(tree->pll_usb.prim, 0x62000);
    assert_int_equal(tree->pll_usb.pwr, 0x04);
    assert_int_equal(tree->clocks.sys.ctrl, 1); /* by PLL_SYS */
    assert_int_equal(tree->clocks.sys.div, 0x10000);
    assert_int_equal(tree->clocks.peri.ctrl, 0x840); /* enabled, by PLL_USB */
    assert_int_equal(tree->clocks.peri.div, 0x10000);
    assert_int_equal(RP2350_SYS_HZ, 12000000 / 10 * 125);
    assert_int_equal(RP2350_PERI_HZ, 12000000 / 12 * 125);
}

static void test_a_pll_for_spi_without_a_lock_is_told(void **state)
{
    (void)state;
    if (!watched_is_possible()) skip();
    struct clock_tree *const tree = watched_tree = watched_begin();
    tree->resets.reset_done = UINT32_MAX;
    tree->xosc.status = STABLE;
    tree->clocks.sys.selected = 3;
    tree->clocks.ref.selected = 4;
    is_usb_silent = true;
    watched.before_read = comes_at_once;
    watched_start();
    const int err = init_clocks(tree);
    watched_stop();
    assert_int_equal(err, MCU_ERR_TIMEOUT);
    assert_int_equal(tree->clocks.peri.ctrl, 0x800); /* by clk_sys, as before */
}

/* -- Pins -------------------------------------------------------------------------------------- */

struct pins {
    struct rp2350_sio_registers sio;
    struct io_bank0_registers io;
    struct pads_bank0_registers pads;
};

static void test_an_output_is_one_bit_of_the_bank(void **state)
{
    (void)state;
    struct pins pins = {.pads.gpio[25] = 0x116, .pads.gpio[24] = 0x116};
    struct rp2350_output output;
    const struct rp2350_gpio gpio = {&pins.sio, &pins.io, &pins.pads};
    const struct pin pin = rp2350_gpio_output(&output, &gpio, 25, true);

    assert_int_equal(pins.sio.gpio_out_set, UINT32_C(1) << 25);
    assert_int_equal(pins.sio.gpio_oe_set, UINT32_C(1) << 25);
    assert_int_equal(pins.io.gpio[25].ctrl, 5);
    assert_int_equal(pins.pads.gpio[25], 0x52); /* not isolated, driven with 4 mA, readable */
    assert_int_equal(pins.pads.gpio[24], 0x116);
    assert_int_equal(pin_set(&pin, false), 0);
    assert_int_equal(pins.sio.gpio_out_clr, UINT32_C(1) << 25);
    assert_int_equal(pins.sio.gpio_out, 0); /* nobody else's bits are written */
    pins.sio.gpio_in = UINT32_C(1) << 12;
    assert_true(rp2350_gpio_read(&gpio, 12));
    assert_false(rp2350_gpio_read(&gpio, 13));
}

static const struct pins *watched_pins;
static bool was_connected_too_early;

/* Isolation ends when the pin has its function, and that its level. */
static void pin_is_written(size_t at_b)
{
    const struct pins *pins = watched_pins;
    if (at_b == AT(pins, pads.gpio[22])) was_connected_too_early |= pins->io.gpio[22].ctrl != 5;
    if (at_b == AT(pins, io.gpio[22].ctrl))
        was_connected_too_early |= !(pins->sio.gpio_oe_set && pins->sio.gpio_out_set);
}

static void test_a_pad_is_isolated_until_its_pin_is_driven(void **state)
{
    (void)state;
    if (!watched_is_possible()) skip();
    struct pins *const pins = watched_begin();
    struct rp2350_output output;
    watched_pins = pins;
    pins->io.gpio[22].ctrl = 0x1F;
    pins->pads.gpio[22] = 0x116;
    was_connected_too_early = false;
    watched.after_write = pin_is_written;
    watched_start();
    (void)rp2350_gpio_output(&output, &(struct rp2350_gpio){&pins->sio, &pins->io, &pins->pads}, 22, true);
    watched_stop();
    assert_false(was_connected_too_early);
    assert_int_equal(pins->pads.gpio[22] & 0x100, 0);
}

/* -- DMA --------------------------------------------------------------------------------------- */

static void test_a_line_is_left_to_a_channel(void **state)
{
    (void)state;
    static const uint8_t data[64] = {1, 2, 3};
    struct pl022_registers spi_registers = {.sr = PL022_SR_TFE | PL022_SR_TNF};
    struct rp2350_dma_registers dma_registers = {.n_channels = 16};
    struct pl022 spi;
    struct rp2040_dma dma;
    const struct pl022_config config = {.clock_hz = RP2350_PERI_HZ, .spi_hz = 62500000, .mode = 3};
    assert_int_equal(pl022_init(&spi, &spi_registers, &config), 0);
    assert_int_equal(spi.spi_hz, 62500000);
    rp2350_dma_init(&dma, &dma_registers, CHANNEL, &spi, DREQ);
    const struct bus bus = rp2040_dma_bus(&dma);

    assert_int_equal(bus_write(&bus, data, sizeof data), 0);
    assert_int_equal(dma_registers.ch[CHANNEL].read_addr, (uint32_t)(uintptr_t)data);
    assert_int_equal(dma_registers.ch[CHANNEL].trans_count, sizeof data);
    /* Enabled, bytes, addresses rise on the reading side, chained to nobody, the FIFO's request; errors cleared. */
    assert_int_equal(dma_registers.ch[CHANNEL].ctrl_trig,
                     0xE0000000 | 1u << 23 | DREQ << 17 | CHANNEL << 13 | 1u << 4 | 1u);
    assert_int_equal(spi_registers.dmacr, PL022_DMACR_TXDMAE);
    assert_int_equal(bus_left_b(&bus), 0);
    dma_registers.ch[CHANNEL].ctrl_trig = 1u << 26 | 1u;
    assert_int_equal(bus_left_b(&bus), sizeof data);
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
    assert_int_equal(dma_registers.chan_abort, 1u << CHANNEL);
    assert_int_equal(dma_registers.ch[CHANNEL].ctrl_trig & 1u, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_registers_are_where_the_makers_headers_have_them),
        cmocka_unit_test(test_a_silent_crystal_leaves_the_clocks_as_they_were),
        cmocka_unit_test(test_the_processor_has_150_mhz_and_spi_125),
        cmocka_unit_test(test_a_pll_for_spi_without_a_lock_is_told),
        cmocka_unit_test(test_an_output_is_one_bit_of_the_bank),
        cmocka_unit_test(test_a_pad_is_isolated_until_its_pin_is_driven),
        cmocka_unit_test(test_a_line_is_left_to_a_channel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
