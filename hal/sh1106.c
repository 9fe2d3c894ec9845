/* SPDX-License-Identifier: MIT
 *
 * Sino Wealth SH1106: like an SSD1306, but with 132 columns, of which glass of 128 usually shows those from 2 on (ox_px
 * = 2), and pages alone. SPI clock 4 MHz. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    static const uint8_t supply[] = {0xAD, 0x8B, 0x33}; /* converter on, 9 V */

    return pages_setup_oled(commands, config, contrast, supply, sizeof supply, 0x1F);
}

const struct pages_chip sh1106 = {
    .name = "sh1106",
    .mem_w_px = 132,
    .mem_h_px = 64,
    .contrast_max = 255,
    .contrast = 0x80,
    .reset_us = 100,
    .setup = setup,
    .start_line = 0x40,
    .is_oled = true,
    .look = pages_look_ae,
    .flip = pages_flip_a0,
    .address = pages_address_b0,
};
