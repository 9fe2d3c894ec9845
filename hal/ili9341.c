/* SPDX-License-Identifier: MIT
 *
 * Ilitek ILI9341: 240x320 memory and glass, nearly always BGR; write clock 10 MHz by the datasheet, 40 MHz in wide use.
 * Voltages and gamma are those of the modules' makers; CFh, EDh, E8h, CBh, F7h and EAh are registers of its power
 * supply. With the scan directions of B6h that all of them send usual glass shows memory's last column first. */
#include "panels.h"
#include "turn.h"

enum {
    GAMMA_SET = 0x26,
    FRAME_RATE = 0xB1,
    FUNCTION = 0xB6,
    POWER_1 = 0xC0,
    POWER_2 = 0xC1,
    VCOM_1 = 0xC5,
    VCOM_2 = 0xC7,
    POWER_A = 0xCB,
    POWER_B = 0xCF,
    GAMMA_POSITIVE = 0xE0,
    GAMMA_NEGATIVE = 0xE1,
    TIMING_A = 0xE8,
    TIMING_B = 0xEA,
    POWER_ON = 0xED,
    THREE_GAMMAS = 0xF2,
    PUMP = 0xF7
};

/* clang-format off */
static const uint8_t setup[] = {
    POWER_B, 3, 0x00, 0xC1, 0x30,
    POWER_ON, 4, 0x64, 0x03, 0x12, 0x81,
    TIMING_A, 3, 0x85, 0x00, 0x78,
    POWER_A, 5, 0x39, 0x2C, 0x00, 0x34, 0x02,
    PUMP, 1, 0x20,
    TIMING_B, 2, 0x00, 0x00,
    POWER_1, 1, 0x23,
    POWER_2, 1, 0x10,
    VCOM_1, 2, 0x3E, 0x28,
    VCOM_2, 1, 0x86,
    FRAME_RATE, 2, 0x00, 0x18,
    FUNCTION, 3, 0x08, 0x82, 0x27,
    THREE_GAMMAS, 1, 0x00,
    GAMMA_SET, 1, 0x01,
    GAMMA_POSITIVE, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
    GAMMA_NEGATIVE, 15, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,
    DCS_NORON, 0,
};
/* clang-format on */

const struct dcs_chip ili9341 = {
    .name = "ili9341",
    .mem_w_px = 240,
    .mem_h_px = 320,
    .formats = 1 << PANEL_RGB565 | 1 << PANEL_RGB666,
    .format = PANEL_RGB565,
    .reversed = TURN_COLUMNS,
    .setup = setup,
    .setup_b = sizeof setup,
};
