/* SPDX-License-Identifier: MIT
 *
 * Sitronix ST7567: 132x64 memory (a 65th line is for icons) behind LCD glass, SPI clock 4 MHz in wide use. Usual
 * modules show column 131 and line 0 first, with 4 columns before glass of 128 (ox_px = 4). Bias and contrast vary by
 * module: if the glass stays white or goes black, try others. Its voltage is 2.1 V x ratio x (1 - (63 - contrast) /
 * 162): with the ratio 4.5 that is set here, and the usual contrast, 7.9 V. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    const uint8_t list[] = {
        0xE2, 0xAE,     /* reset, display off */
        0xA2, 0x23,     /* bias 1/9, ratio of the regulator */
        0x81, contrast, /* 0..63 */
        0xA4,           /* show memory */
    };

    (void)config;
    return pages_put(commands, list, sizeof list);
}

static uint8_t flip(uint8_t commands[2], bool columns, bool rows)
{
    return pages_flip_a0(commands, columns, !rows);
}

const struct pages_chip st7567 = {
    .name = "st7567",
    .mem_w_px = 132,
    .mem_h_px = 64,
    .contrast_max = 63,
    .contrast = 0x24,
    .reset_us = 5000,
    .wake_us = 50000,
    .wake = {0x2C, 0x2E, 0x2F}, /* booster, regulator, follower, one after the other */
    .wake_b = 3,
    .setup = setup,
    .scans_all = true,
    .start_line = 0x40,
    .look = pages_look_ae,
    .flip = flip,
    .address = pages_address_b0,
};
