/* SPDX-License-Identifier: MIT
 *
 * Raspberry Pi Pico 2: an RP2350 at 150 MHz, and a display on SPI0, fed by DMA. The pins are those of a Pico with one
 * of Pimoroni's Display Packs; README.md has the table. Waits are SysTick's, which counts the processor's cycles: no
 * TIMER, whose ticks TICKS would have to make, is used. */
#include "board.h"
#include "mcu/rp2350_clocks.h"
#include "mcu/rp2350_dma.h"
#include "mcu/rp2350_gpio.h"
#include "mcu/systick.h"

/* GPIO numbers; board.mk says where the LED is: PIN_LED, or -1 for none. A Pico 2 W has its own behind the radio chip.
 */
enum {
    PIN_A = 12,
    PIN_B = 13,
    PIN_X = 14,
    PIN_Y = 15,
    PIN_DC = 16,
    PIN_SELECT = 17,
    PIN_SCK = 18,
    PIN_TX = 19,
    PIN_BACKLIGHT = 20,
    PIN_RESET = 22,
};

/* Where the display takes it: with SPH = 1 the PL022 makes no pause between bytes. */
enum { SPI_MODE = 3 };
enum { DMA_CHANNEL = 0 };

static struct {
    struct systick systick;
    struct pl022 spi;
    struct rp2040_dma dma;
    struct rp2350_output dc, select, backlight, reset, led;
} parts;

static const struct rp2040_clocks CLOCKS = {
    .resets = RP2350_RESETS_REGISTERS,
    .xosc = RP2350_XOSC_REGISTERS,
    .pll_sys = RP2350_PLL_SYS_REGISTERS,
    .clocks = RP2350_CLOCKS_REGISTERS,
};

static const struct rp2350_gpio GPIO = {
    .sio = RP2350_SIO_REGISTERS,
    .io = RP2350_IO_BANK0_REGISTERS,
    .pads = RP2350_PADS_BANK0_REGISTERS,
};

/* The packs' buttons, two on the left of the glass and two on the right, close to ground. */
static uint8_t read_buttons(void)
{
    static const struct {
        uint8_t pin, button;
    } wiring[] = {{PIN_X, BOARD_UP}, {PIN_Y, BOARD_DOWN}, {PIN_A, BOARD_LEFT}, {PIN_B, BOARD_RIGHT}};
    uint8_t down = 0;

    for (uint8_t i = 0; i < sizeof wiring / sizeof wiring[0]; i++)
        if (!rp2350_gpio_read(&GPIO, wiring[i].pin)) down |= wiring[i].button;
    return down;
}

/* Levels at which a display is left alone: not selected, not in reset, dark. */
static void take_pins(struct board *board)
{
    if (PIN_LED >= 0) board->led = rp2350_gpio_output(&parts.led, &GPIO, (uint8_t)PIN_LED, false);
    board->dc = rp2350_gpio_output(&parts.dc, &GPIO, PIN_DC, false);
    board->select = rp2350_gpio_output(&parts.select, &GPIO, PIN_SELECT, true);
    board->reset = rp2350_gpio_output(&parts.reset, &GPIO, PIN_RESET, true);
    board->backlight = rp2350_gpio_output(&parts.backlight, &GPIO, PIN_BACKLIGHT, false);
    for (uint8_t pin = PIN_A; pin <= PIN_Y; pin++)
        rp2350_gpio_select(&GPIO, pin, SIO_GPIO_SIO, SIO_GPIO_BUTTON);
    board->buttons = read_buttons;
    rp2350_gpio_select(&GPIO, PIN_SCK, SIO_GPIO_SPI, SIO_GPIO_FAST);
    rp2350_gpio_select(&GPIO, PIN_TX, SIO_GPIO_SPI, SIO_GPIO_FAST);
}

/* The display is selected once the clock is at its idle level, and stays so: it is alone on the bus. A falling edge
 * also ends what an earlier start left half sent. */
static int start_bus(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct pl022_config config = {
        .clock_hz = RP2350_PERI_HZ, .spi_hz = spi_hz, .mode = spi_mode_of(spi_modes, SPI_MODE)};
    int err = rp2040_reset(CLOCKS.resets, RP2350_RESET_SPI0 | RP2350_RESET_DMA);

    if (!err) err = pl022_init(&parts.spi, RP2350_SPI0_REGISTERS, &config);
    if (err) return err;
    rp2350_dma_init(&parts.dma, RP2350_DMA_REGISTERS, DMA_CHANNEL, &parts.spi, RP2350_DREQ_SPI0_TX);
    board->bus = rp2040_dma_bus(&parts.dma);
    return pin_set(&board->select, false);
}

/* The LED and a clock come first, to tell of what fails later; until the PLL runs the clock waits for longer. */
int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    int err = rp2040_release(CLOCKS.resets, RP2350_RESET_IO_BANK0 | RP2350_RESET_PADS_BANK0);

    if (err) return err;
    take_pins(board);
    err = systick_init(&parts.systick, SYSTICK_REGISTERS, RP2350_SYS_HZ);
    board->clock = systick_clock(&parts.systick);
    if (!err) err = rp2350_clocks_init(&CLOCKS, RP2350_PLL_USB_REGISTERS);
    return err ? err : start_bus(board, spi_hz, spi_modes);
}
