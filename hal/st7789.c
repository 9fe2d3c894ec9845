/* SPDX-License-Identifier: MIT
 *
 * Sitronix ST7789, ST7789V, ST7789V2: 240x320 memory behind glass of any size up to that, write clock up to 62.5 MHz by
 * the datasheet; modules without a chip select pin need SPI mode 3. Common modules, nearly all IPS (invert) and RGB:
 *     glass     ox_px, oy_px        glass     ox_px, oy_px
 *     240x240   0, 0                135x240   52, 40
 *     240x320   0, 0                240x280   0, 20
 * Power and gamma registers keep the values that the chip loads at reset, which every module's glass was chosen for. */
#include "panels.h"

static const uint8_t setup[] = {DCS_NORON, 0};

const struct dcs_chip st7789 = {
    .name = "st7789",
    .mem_w_px = 240,
    .mem_h_px = 320,
    .formats = 1 << PANEL_RGB565 | 1 << PANEL_RGB444 | 1 << PANEL_RGB666,
    .format = PANEL_RGB565,
    .setup = setup,
    .setup_b = sizeof setup,
};
