/* SPDX-License-Identifier: MIT
 *
 * Sino Wealth SH1106: like an SSD1306, but with 132 columns, of which glass of 128 usually shows those from 2 on (ox_px
 * = 2), and pages alone. SPI clock 4 MHz. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    const uint8_t list[] = {
        0xAE,                               /* display off */
        0xD5, 0x80,                         /* clock */
        0xA8, (uint8_t)(config->h_px - 1u), /* lines */
        0xD3, 0x00,
        0x40, /* first line */
        0xAD, 0x8B,
        0x32,                                             /* converter on, 8 V */
        0xDA, (uint8_t)(config->h_px > 32 ? 0x12 : 0x02), /* how lines are wired */
        0x81, contrast,
        0xD9, 0x1F,
        0xDB, 0x40, /* precharge, level of what is off */
        0xA4,       /* show memory */
    };

    return pages_put(commands, list, sizeof list);
}

const struct pages_chip sh1106 = {
    .name = "sh1106",
    .mem_w_px = 132,
    .mem_h_px = 64,
    .contrast_max = 255,
    .contrast = 0x80,
    .reset_us = 100,
    .setup = setup,
    .look = pages_look_ae,
    .flip = pages_flip_a0,
    .address = pages_address_b0,
};
