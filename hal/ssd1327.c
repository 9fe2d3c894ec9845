/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech SSD1327: 128x128 memory behind OLED glass of up to that, 16 levels of grey; SPI clock 4 MHz
 * in wide use. Glass of fewer lines may want a shift of its maker's. Of the two pixels of a byte
 * the chip can take either first: whichever way columns run, the upper four bits are the left one's. */
#include "panels.h"

/* clang-format off */
static const uint8_t setup[] = {
    0xFD, 1, 0x12, /* unlock commands */
    0xAE, 0,       /* asleep */
    0xAB, 1, 0x01, /* supply of the logic from inside */
    0xB1, 1, 0x51, /* precharge: phases, second phase and voltage */
    0xB6, 1, 0x01,
    0xD5, 1, 0x62,
    0xBC, 1, 0x08,
    0xB3, 1, 0x01, /* clock */
    0xB5, 1, 0x03, /* output high: switches the glass's supply on some modules */
    0xB9, 0,       /* levels of grey evenly spaced */
    0xBE, 1, 0x07, /* level of lines that are not scanned */
};
/* clang-format on */

const struct solomon_chip ssd1327 = {
    .name = "ssd1327",
    .formats = 1 << PANEL_GREY4,
    .format = PANEL_GREY4,
    .mem_w_px = 128,
    .mem_h_px = 128,
    .args_low = true,
    .column_px = 2,
    .lines = 0xA8,
    .as_is = 0xA4,
    .negative = 0xA7,
    .all_off = 0xA6,
    .contrast_command = 0x81,
    .contrast_max = 255,
    .contrast = 0x80,
    .remap = 0x51, /* odd and even lines apart, the last line on top, the last column on the left */
    .remap_rows = 0x10,
    .remap_columns = 0x03, /* and the order of a byte's two pixels */
    .setup = setup,
    .setup_b = sizeof setup,
};
