/* SPDX-License-Identifier: MIT
 *
 * A board with an ESP32-C3: see README.md for its pins and clocks. */
#include "board.h"

#include "mcu/esp32c3_gpio.h"
#include "mcu/esp32c3_spi.h"
#include "mcu/esp32c3_system.h"
#include "mcu/esp32c3_systimer.h"

#define PIN(n) .gpio = ESP32C3_GPIO, .mux = ESP32C3_IO_MUX, .number = (n)

static const struct esp32c3_pin backlight = {PIN(3)};
static const struct esp32c3_pin reset = {PIN(4)};
static const struct esp32c3_pin dc = {PIN(5)};
static const struct esp32c3_pin sck = {PIN(6)};
static const struct esp32c3_pin mosi = {PIN(7)};
static const struct esp32c3_pin led = {PIN(8), .inverted = true};
static const struct esp32c3_pin select = {PIN(10)};

static struct esp32c3_spi spi;

/* Modules without chip select want a clock that idles high. */
enum { SPI_MODE = 3 };

/* The panel is selected when SPI has begun: what it may have taken for a bit before is forgotten then. */
static void take_pins(struct board *board)
{
    board->led = esp32c3_gpio_output(&led, false);
    board->dc = esp32c3_gpio_output(&dc, false);
    board->reset = esp32c3_gpio_output(&reset, true);
    board->backlight = esp32c3_gpio_output(&backlight, false);
    board->select = esp32c3_gpio_output(&select, true);
    esp32c3_gpio_lend(&sck);
    esp32c3_gpio_lend(&mosi);
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    esp32c3_watchdogs_stop(ESP32C3_RTC_WATCHDOGS, ESP32C3_WATCHDOG0);
    esp32c3_clock_init(ESP32C3_SYSTEM);
    esp32c3_system_begin(ESP32C3_SYSTEM, ESP32C3_SPI2 | ESP32C3_SYSTIMER_PART);
    board->clock = esp32c3_systimer_clock(ESP32C3_SYSTIMER);
    take_pins(board);
    int err =
        esp32c3_spi_init(&spi, ESP32C3_SPI2_REGISTERS, ESP32C3_CRYSTAL_HZ, spi_hz, spi_mode_of(spi_modes, SPI_MODE));
    if (err) return err;
    board->bus = esp32c3_spi_bus(&spi);
    return pin_set(&board->select, false);
}
