/* SPDX-License-Identifier: MIT
 *
 * Ilitek ILI9488, and ILI9486 as far as this goes: 320x480 memory and glass, nearly always BGR. On SPI it takes three
 * bytes a pixel and nothing else. Usual glass shows memory's last column first. Modules for the Raspberry Pi that call
 * themselves so sit behind a shift register of 16 bits and are not driven like this. */
#include "panels.h"
#include "turn.h"

enum {
    INTERFACE = 0xB0,
    FRAME_RATE = 0xB1,
    INVERSION = 0xB4,
    FUNCTION = 0xB6,
    ENTRY = 0xB7,
    POWER_1 = 0xC0,
    POWER_2 = 0xC1,
    VCOM = 0xC5,
    GAMMA_POSITIVE = 0xE0,
    GAMMA_NEGATIVE = 0xE1,
    ADJUST_3 = 0xF7
};

/* clang-format off */
static const uint8_t setup[] = {
    GAMMA_POSITIVE, 15, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F, 0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16, 0x1A, 0x0F,
    GAMMA_NEGATIVE, 15, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32, 0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35, 0x37, 0x0F,
    POWER_1, 2, 0x17, 0x15,
    POWER_2, 1, 0x41,
    VCOM, 3, 0x00, 0x12, 0x80,
    INTERFACE, 1, 0x00,
    FRAME_RATE, 1, 0xA0,
    INVERSION, 1, 0x02,
    FUNCTION, 3, 0x02, 0x02, 0x3B,
    ENTRY, 1, 0xC6,
    ADJUST_3, 4, 0xA9, 0x51, 0x2C, 0x82,
    DCS_NORON, 0,
};
/* clang-format on */

const struct dcs_chip ili9488 = {
    .name = "ili9488",
    .mem_w_px = 320,
    .mem_h_px = 480,
    .formats = 1 << PANEL_RGB666,
    .format = PANEL_RGB666,
    .reversed = TURN_COLUMNS,
    .setup = setup,
    .setup_b = sizeof setup,
};
