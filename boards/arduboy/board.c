/* SPDX-License-Identifier: MIT
 *
 * Arduboy: an ATmega32U4 at 16 MHz with an SSD1306 on its SPI, six buttons, a light of three colours. The bootloader
 * may have left the watchdog on, and has the USB; interrupts stay off, so that nothing answers it any more.
 * Not tried on hardware. */
#include "board.h"
#include "mcu/avr_gpio.h"
#include "mcu/avr_spi.h"
#include "mcu/avr_timer.h"

#include <avr/wdt.h>

enum { B_SS = 0, B_SCK = 1, B_MOSI = 2, B_BUTTON_B = 4, B_BLUE = 5, B_RED = 6, B_GREEN = 7 };
enum { D_DC = 4, D_SELECT = 6, D_RESET = 7 };
enum { E_BUTTON_A = 6 };
enum { F_DOWN = 4, F_LEFT = 5, F_RIGHT = 6, F_UP = 7 };

static struct avr_spi spi;
static struct avr_timer timer;
static struct avr_output dc, reset, select, led;

/* Low is down. */
static uint8_t buttons(void)
{
    const uint8_t e = (uint8_t)~AVR_GPIO_E_REGISTERS->pin, f = (uint8_t)~AVR_GPIO_F_REGISTERS->pin;

    return (uint8_t)((f & 1 << F_UP ? BOARD_UP : 0) | (f & 1 << F_DOWN ? BOARD_DOWN : 0) |
                     (f & 1 << F_LEFT ? BOARD_LEFT : 0) | (f & 1 << F_RIGHT ? BOARD_RIGHT : 0) |
                     (e & 1 << E_BUTTON_A ? BOARD_SELECT : 0));
}

static void init_lights_and_buttons(struct board *board)
{
    (void)avr_gpio_sink(&led, AVR_GPIO_B_REGISTERS, B_BLUE);
    (void)avr_gpio_sink(&led, AVR_GPIO_B_REGISTERS, B_RED);
    board->led = avr_gpio_sink(&led, AVR_GPIO_B_REGISTERS, B_GREEN);
    avr_gpio_inputs(AVR_GPIO_B_REGISTERS, 1 << B_BUTTON_B);
    avr_gpio_inputs(AVR_GPIO_E_REGISTERS, 1 << E_BUTTON_A);
    avr_gpio_inputs(AVR_GPIO_F_REGISTERS, 1 << F_UP | 1 << F_DOWN | 1 << F_LEFT | 1 << F_RIGHT);
    board->buttons = buttons;
}

/* The display is alone on the bus, and selected for good once that is idle. */
static int init_bus(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct pin selected = avr_gpio_output(&select, AVR_GPIO_D_REGISTERS, D_SELECT, true);
    (void)avr_gpio_output(&dc, AVR_GPIO_B_REGISTERS, B_SS, true);
    (void)avr_gpio_output(&dc, AVR_GPIO_B_REGISTERS, B_SCK, false);
    (void)avr_gpio_output(&dc, AVR_GPIO_B_REGISTERS, B_MOSI, false);
    board->dc = avr_gpio_output(&dc, AVR_GPIO_D_REGISTERS, D_DC, true);
    board->reset = avr_gpio_output(&reset, AVR_GPIO_D_REGISTERS, D_RESET, true);
    int err = avr_spi_init(&spi, AVR_SPI_REGISTERS, BOARD_CPU_HZ, spi_hz, spi_modes & SPI_IDLES_LOW ? 0 : 3);
    if (err) return err;
    board->bus = avr_spi_bus(&spi);
    return pin_set(&selected, false);
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    wdt_disable();
    init_lights_and_buttons(board);
    int err = avr_timer_init(&timer, AVR_TIMER_1_REGISTERS, BOARD_CPU_HZ);
    if (err) return err;
    board->clock = avr_timer_clock(&timer);
    return init_bus(board, spi_hz, spi_modes);
}
