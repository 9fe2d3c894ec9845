/* SPDX-License-Identifier: MIT
 *
 * Sitronix ST7796S, ST7796U: 320x480 memory and glass, 16 bits a pixel on SPI as well as 18, nearly always BGR. Usual
 * glass shows memory's last column first; IPS glass wants `invert`, TN glass does not. Registers above AFh are locked
 * after a reset. FUNCTION's first byte is the chip's own default: with 20h pixels would come from the RGB interface,
 * and SPI would reach nothing (Bodmer/TFT_eSPI, issue 499). Write clock up to 15 MHz by the datasheet, 40 to 80 in use
 * (issue 1732 there). */
#include "panels.h"
#include "turn.h"

enum {
    INVERSION = 0xB4,
    FUNCTION = 0xB6,
    POWER_2 = 0xC1,
    POWER_3 = 0xC2,
    VCOM = 0xC5,
    GAMMA_POSITIVE = 0xE0,
    GAMMA_NEGATIVE = 0xE1,
    OUTPUT_TIMING = 0xE8,
    LOCK = 0xF0
};

/* clang-format off */
static const uint8_t setup[] = {
    LOCK, 1, 0xC3,
    LOCK, 1, 0x96,
    INVERSION, 1, 0x01,
    FUNCTION, 3, 0x80, 0x02, 0x3B,
    OUTPUT_TIMING, 8, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33,
    POWER_2, 1, 0x06,
    POWER_3, 1, 0xA7,
    VCOM, 1, 0x18,
    GAMMA_POSITIVE, 14, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18, 0x1B,
    GAMMA_NEGATIVE, 14, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17, 0x1B,
    LOCK, 1, 0x3C,
    LOCK, 1, 0x69,
    DCS_NORON, 0,
};
/* clang-format on */

const struct dcs_chip st7796 = {
    .name = "st7796",
    .mem_w_px = 320,
    .mem_h_px = 480,
    .formats = 1 << PANEL_RGB565 | 1 << PANEL_RGB666,
    .format = PANEL_RGB565,
    .reversed = TURN_COLUMNS,
    .setup = setup,
    .setup_b = sizeof setup,
};
