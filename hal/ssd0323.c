/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech SSD0323, and SSD1325: 128x80 memory behind OLED glass of 128x64 or up to that, 16 levels of grey; SPI
 * clock 4 MHz. Glass of fewer lines may want a shift of its maker's; that of 128x64 on TI's LM3S6965EVB has its upper
 * edge 4 lines below memory's last. */
#include "panels.h"

/* clang-format off */
static const uint8_t setup[] = {
    0xAE, 0,       /* asleep */
    0xB3, 1, 0x91, /* clock */
    0x85, 0,       /* half of the range of current */
    0xB8, 8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, /* levels of grey */
    0xB2, 1, 0x51, /* length of a line */
    0xB1, 1, 0x55, /* precharge: phases, voltage */
    0xBC, 1, 0x10,
    0xBE, 1, 0x1C, /* level of lines that are not scanned */
    0xBF, 1, 0x0F, /* low level of columns */
};
/* clang-format on */

const struct solomon_chip ssd0323 = {
    .name = "ssd0323",
    .formats = 1 << PANEL_GREY4,
    .format = PANEL_GREY4,
    .mem_w_px = 128,
    .mem_h_px = 80,
    .args_low = true,
    .column_px = 2,
    .lines = 0xA8,
    .counts_all = true,
    .as_is = 0xA4,
    .negative = 0xA7,
    .all_off = 0xA6,
    .contrast_command = 0x81,
    .contrast_max = 127,
    .contrast = 50, /* with 85h as the maker of the LM3S6965EVB has it, in decimal */
    .converter = 0xAD,
    .external = 0x02,
    .internal = 0x03,
    .remap = 0x52, /* odd and even lines apart, the last line on top, the upper four bits on the left */
    .remap_rows = 0x10,
    .remap_columns = 0x03, /* and the order of a byte's two pixels */
    .setup = setup,
    .setup_b = sizeof setup,
};
