/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech SSD1351: 128x128 memory behind OLED glass of 128x128 or 128x96, RGB; SPI clock up to 18 MHz in
 * wide use, a little above that it hangs. Voltages and contrast are those of the modules' makers. Three bytes a pixel
 * have each colour in their lower six bits. */
#include "panels.h"

/* clang-format off */
static const uint8_t setup[] = {
    0xFD, 1, 0x12,             /* unlock commands, and those that are locked at reset */
    0xFD, 1, 0xB1,
    0xAE, 0,                   /* asleep */
    0xB3, 1, 0xF1,             /* clock */
    0xB5, 1, 0x00,             /* outputs off */
    0xAB, 1, 0x01,             /* supply of the logic from inside */
    0xB1, 1, 0x32,             /* precharge: phases, voltage, second phase */
    0xB4, 3, 0xA0, 0xB5, 0x55, /* low level of columns from outside */
    0xBB, 1, 0x17,
    0xB6, 1, 0x01,
    0xBE, 1, 0x05,             /* level of lines that are not scanned */
    0xC1, 3, 0xC8, 0x80, 0xC8, /* contrast of the three colours */
};
/* clang-format on */

const struct solomon_chip ssd1351 = {
    .name = "ssd1351",
    .formats = 1 << PANEL_RGB565 | 1 << PANEL_RGB666_LOW,
    .format = PANEL_RGB565,
    .mem_w_px = 128,
    .mem_h_px = 128,
    .column_px = 1,
    .lines = 0xCA,
    .scans_all = true, /* as those do who are known to drive glass of 96 lines */
    .write = 0x5C,
    .as_is = 0xA6,
    .negative = 0xA7,
    .all_off = 0xA4,
    .contrast_command = 0xC7, /* of all colours, in sixteenths */
    .contrast_max = 15,
    .contrast = 15,
    .remap = 0x74, /* 65k colours, red first, odd and even lines apart, the last line on top */
    .remap_rows = 0x10,
    .remap_columns = 0x02,
    .remap_exchange = 0x01,
    .remap_bgr = 0x04,
    .remap_wide = 0xC0, /* 262k colours */
    .setup = setup,
    .setup_b = sizeof setup,
};
