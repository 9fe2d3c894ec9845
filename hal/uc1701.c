/* SPDX-License-Identifier: MIT
 *
 * UltraChip UC1701: 132x64 memory (a 65th line is for icons) behind LCD glass, SPI clock 4 MHz in wide use. It speaks
 * ST7567's commands but for the supply, which it brings up by itself, and a register for temperature; usual modules
 * show column 0 and line 63 first. Glass of 102x64 wants flip_columns and flip_rows. Bias and contrast
 * vary by module: if the glass stays white or goes black, try others. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    const uint8_t list[] = {
        0xAE,           /* display off */
        0xA2, 0x23,     /* bias 1/9, ratio of the regulator */
        0x81, contrast, /* 0..63 */
        0xFA, 0x90,     /* falls by 0.11 % a degree; addresses do not wrap */
        0xA4,           /* show memory */
    };

    (void)config;
    return pages_put(commands, list, sizeof list);
}

static uint8_t flip(uint8_t commands[2], bool columns, bool rows)
{
    return pages_flip_a0(commands, !columns, rows);
}

const struct pages_chip uc1701 = {
    .name = "uc1701",
    .mem_w_px = 132,
    .mem_h_px = 64,
    .contrast_max = 63,
    .contrast = 0x27,
    .reset_us = 6000,
    .wake_us = 50000,
    .wake = {0x2F},
    .wake_b = 1,
    .setup = setup,
    .scans_all = true,
    .start_line = 0x40,
    .look = pages_look_ae,
    .flip = flip,
    .address = pages_address_b0,
};
