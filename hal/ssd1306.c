/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech SSD1306: 128x64 memory behind OLED glass of 128x64 or less, SPI clock up to 10 MHz. The charge pump
 * makes the glass's voltage; modules that have their own do without it. Usual modules show column 127 and line 63
 * first. Glass of 96 columns begins at column 0, narrower glass in the middle; that of 72x40 wants
 * internal_reference. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    static const uint8_t supply[] = {0x8D, 0x14, 0x20, 0x02, 0xAD, 0x30}; /* pump; page addressing; reference */
    const uint8_t supply_b = config->internal_reference ? sizeof supply : sizeof supply - 2;

    return pages_setup_oled(commands, config, contrast, supply, supply_b, 0xF1);
}

/* Horizontal addressing, told each time: two bytes of a message that is sent anyway. */
static uint8_t window(uint8_t commands[PAGES_ADDRESS_MAX_B], const uint8_t columns[2], const uint8_t pages[2])
{
    const uint8_t list[] = {0x20, 0x00, 0x21, columns[0], columns[1], 0x22, pages[0], pages[1]};

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
    .start_line = 0x40,
    .is_oled = true,
    .look = pages_look_ae,
    .flip = pages_flip_a0,
    .address = pages_address_b0,
    .window = window,
};
