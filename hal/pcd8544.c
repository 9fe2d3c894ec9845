/* SPDX-License-Identifier: MIT
 *
 * Philips PCD8544: 84x48 memory and glass, SPI clock 4 MHz. It cannot turn or mirror a picture. The voltage that suits
 * the glass (contrast, 0..127) varies by module. */
#include "panels.h"

static uint8_t setup(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast)
{
    const uint8_t list[] = {
        0x21,                       /* extended commands */
        (uint8_t)(0x80 | contrast), /* voltage */
        0x04,
        0x14, /* temperature, bias 1/48 */
        0x20,
        0x08, /* plain commands, horizontal addressing; dark */
    };

    (void)config;
    return pages_put(commands, list, sizeof list);
}

static uint8_t look(uint8_t commands[2], bool on, bool inverted)
{
    commands[0] = !on ? 0x08 : inverted ? 0x0D : 0x0C;
    return 1;
}

static uint8_t address(uint8_t commands[PAGES_ADDRESS_MAX_B], uint8_t page, uint8_t column)
{
    commands[0] = (uint8_t)(0x40 | page);
    commands[1] = (uint8_t)(0x80 | column);
    return 2;
}

const struct pages_chip pcd8544 = {
    .name = "pcd8544",
    .mem_w_px = 84,
    .mem_h_px = 48,
    .contrast_max = 127,
    .contrast = 0x3F,
    .reset_us = 100,
    .setup = setup,
    .look = look,
    .address = address,
    .runs_on = true,
};
