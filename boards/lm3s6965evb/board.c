/* SPDX-License-Identifier: MIT
 *
 * LM3S6965 Evaluation Board: its OLED on SSI0, D/C and the glass's supply on port C, the status LED, five buttons.
 * Manual: LM3S6965 Evaluation Board User's Manual, schematic page 2. Pins of the microSD card, whose select shares the
 * bus, are left alone: it is pulled up. Not tried on hardware. */
#include "board.h"
#include "mcu/lm3s_clocks.h"
#include "mcu/lm3s_gpio.h"
#include "mcu/pl022.h"
#include "mcu/systick.h"

/* Pins of their ports. */
enum { OLED_SELECT = 3, OLED_SUPPLY = 6, OLED_DC = 7, LED = 0 };
enum { A_SSI0_CLK_TX = 1 << 2 | 1 << 5, E_UP_DOWN_LEFT_RIGHT = 0x0F, F_SELECT = 1 << 1 };

#define SSI0_REGISTERS ((volatile struct pl022_registers *)UINT32_C(0x40008000))

/* The display takes a bit with the clock's rise, and the clock is high between bytes. */
enum { OLED_MODE = 3 };

static struct pl022 ssi;
static struct systick systick;
static struct lm3s_output oled_select, oled_supply, oled_dc, led;

/* Low is down; the bits of up, down, left and right are those of enum board_button. */
static uint8_t buttons(void)
{
    const unsigned walk = lm3s_gpio_read(LM3S_GPIO_E_REGISTERS, E_UP_DOWN_LEFT_RIGHT) ^ E_UP_DOWN_LEFT_RIGHT;
    const bool select = !lm3s_gpio_read(LM3S_GPIO_F_REGISTERS, F_SELECT);

    return (uint8_t)(walk | (select ? BOARD_SELECT : 0u));
}

/* The display is not selected until the bus is idle, so it misses what an abandoned frame left there. */
static int init_bus(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    const struct pl022_config config = {
        .clock_hz = LM3S_SYSTEM_HZ, .spi_hz = spi_hz, .mode = spi_mode_of(spi_modes, OLED_MODE)};
    const struct pin select = lm3s_gpio_output(&oled_select, LM3S_GPIO_A_REGISTERS, OLED_SELECT, true);
    lm3s_gpio_alternate(LM3S_GPIO_A_REGISTERS, A_SSI0_CLK_TX);
    int err = pl022_init(&ssi, SSI0_REGISTERS, &config);
    if (err) return err;
    board->bus = pl022_bus(&ssi);
    return pin_set(&select, false);
}

static void init_buttons(struct board *board)
{
    lm3s_gpio_inputs(LM3S_GPIO_E_REGISTERS, E_UP_DOWN_LEFT_RIGHT);
    lm3s_gpio_inputs(LM3S_GPIO_F_REGISTERS, F_SELECT);
    board->buttons = buttons;
}

/* The LED first: it tells what goes wrong with the rest. */
int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    lm3s_peripherals_start(LM3S_SYSTEM_REGISTERS, 2, LM3S_2_GPIO_A | LM3S_2_GPIO_C | LM3S_2_GPIO_E | LM3S_2_GPIO_F);
    lm3s_peripherals_start(LM3S_SYSTEM_REGISTERS, 1, LM3S_1_SSI0);
    board->led = lm3s_gpio_output(&led, LM3S_GPIO_F_REGISTERS, LED, false);
    int err = systick_init(&systick, SYSTICK_REGISTERS, LM3S_SYSTEM_HZ);
    if (err) return err;
    board->clock = systick_clock(&systick);
    err = lm3s_clocks_init(LM3S_SYSTEM_REGISTERS);
    if (err) return err;

    board->dc = lm3s_gpio_output(&oled_dc, LM3S_GPIO_C_REGISTERS, OLED_DC, true);
    board->backlight = lm3s_gpio_output(&oled_supply, LM3S_GPIO_C_REGISTERS, OLED_SUPPLY, false);
    init_buttons(board);
    return init_bus(board, spi_hz, spi_modes);
}
