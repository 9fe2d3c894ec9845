/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech SSD1306: 128x64 memory behind OLED glass of 128x64 or 128x32, SPI clock up to 10 MHz. The charge pump
 * makes the glass's voltage; modules that have their own do without it. Usual modules show column 127 and line 63
 * first. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    const uint8_t list[] = {
        0xAE,                               /* display off */
        0xD5, 0x80,                         /* clock */
        0xA8, (uint8_t)(config->h_px - 1u), /* lines */
        0xD3, 0x00,
        0x40,                                             /* first line */
        0x8D, 0x14,                                       /* charge pump on */
        0x20, 0x02,                                       /* page addressing */
        0xDA, (uint8_t)(config->h_px > 32 ? 0x12 : 0x02), /* how lines are wired */
        0x81, contrast,
        0xD9, 0xF1,
        0xDB, 0x40, /* precharge, level of what is off */
        0xA4,       /* show memory */
    };

    return pages_put(commands, list, sizeof list);
}

const struct pages_chip ssd1306 = {
    .name = "ssd1306",
    .mem_w_px = 128,
    .mem_h_px = 64,
    .contrast_max = 255,
    .contrast = 0xCF,
    .reset_us = 100,
    .setup = setup,
    .look = pages_look_ae,
    .flip = pages_flip_a0,
    .address = pages_address_b0,
};
