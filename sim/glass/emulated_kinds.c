/* SPDX-License-Identifier: MIT
 *
 * The chips as their datasheets describe them: memory, formats, and how many arguments each register takes. GC9A01's
 * are those of its maker's example, as there is no public description; ST7796S's those of others' drivers. */
#include "glass/emulated_dcs.h"

#include <string.h>

static const struct emulated_register st7735_registers[] = {
    {0xB1, 3}, {0xB2, 3}, {0xB3, 6}, {0xB4, 1}, {0xC0, 3},  {0xC1, 1},  {0xC2, 2},
    {0xC3, 2}, {0xC4, 2}, {0xC5, 1}, {0xC7, 1}, {0xE0, 16}, {0xE1, 16}, {0, 0},
};

static const struct emulated_register ili9341_registers[] = {
    {0x26, 1}, {0xB1, 2}, {0xB2, 2}, {0xB3, 2}, {0xB4, 1}, {0xB5, 4}, {0xB6, 3},  {0xB7, 1},
    {0xC0, 1}, {0xC1, 1}, {0xC5, 2}, {0xC7, 1}, {0xCB, 5}, {0xCF, 3}, {0xE0, 15}, {0xE1, 15},
    {0xE8, 3}, {0xEA, 2}, {0xED, 4}, {0xF2, 1}, {0xF6, 3}, {0xF7, 1}, {0, 0},
};

static const struct emulated_register ili9488_registers[] = {
    {0xB0, 1}, {0xB1, 1}, {0xB4, 1}, {0xB5, 4},  {0xB6, 3},  {0xB7, 1}, {0xC0, 2},
    {0xC1, 1}, {0xC2, 1}, {0xC5, 3}, {0xE0, 15}, {0xE1, 15}, {0xF7, 4}, {0, 0},
};

/* As zephyrproject-rtos/zephyr has them (drivers/display/display_st7796s.c and its binding) and Sergey1560/fb_st7796s.
 */
static const struct emulated_register st7796_registers[] = {
    {0x38, 0}, {0x53, 1}, {0xB0, 1}, {0xB1, 2}, {0xB2, 2}, {0xB3, 2},  {0xB4, 1},  {0xB5, 4}, {0xB6, 3}, {0xB7, 1},
    {0xC0, 2}, {0xC1, 1}, {0xC2, 1}, {0xC5, 1}, {0xC6, 1}, {0xE0, 14}, {0xE1, 14}, {0xE8, 8}, {0xF0, 1}, {0, 0},
};

static const struct emulated_register gc9a01_registers[] = {
    {0x62, 12}, {0x63, 12}, {0x64, 7}, {0x66, 10}, {0x67, 10}, {0x70, 9}, {0x74, 7}, {0x84, 1}, {0x85, 1},
    {0x86, 1},  {0x87, 1},  {0x88, 1}, {0x89, 1},  {0x8A, 1},  {0x8B, 1}, {0x8C, 1}, {0x8D, 1}, {0x8E, 1},
    {0x8F, 1},  {0x90, 4},  {0x98, 2}, {0xAE, 1},  {0xB6, 2},  {0xBC, 1}, {0xBD, 1}, {0xBE, 1}, {0xC3, 1},
    {0xC4, 1},  {0xC9, 1},  {0xCD, 1}, {0xDF, 3},  {0xE1, 2},  {0xE8, 1}, {0xEB, 1}, {0xED, 2}, {0xEF, 0},
    {0xF0, 6},  {0xF1, 6},  {0xF2, 6}, {0xF3, 6},  {0xFE, 0},  {0xFF, 3}, {0, 0},
};

static const struct emulated_kind st7789 = {
    .name = "st7789", .w_px = 240, .h_px = 320, .takes_12 = true, .takes_16 = true};
static const struct emulated_kind st7735 = {
    .name = "st7735", .w_px = 132, .h_px = 162, .takes_12 = true, .takes_16 = true, .registers = st7735_registers};
static const struct emulated_kind ili9341 = {.name = "ili9341",
                                             .w_px = 240,
                                             .h_px = 320,
                                             .takes_16 = true,
                                             .scan_register = 0xB6,
                                             .registers = ili9341_registers};
static const struct emulated_kind ili9488 = {
    .name = "ili9488", .w_px = 320, .h_px = 480, .scan_register = 0xB6, .registers = ili9488_registers};
static const struct emulated_kind st7796 = {.name = "st7796",
                                            .w_px = 320,
                                            .h_px = 480,
                                            .takes_16 = true,
                                            .scan_register = 0xB6,
                                            .lock_register = 0xF0,
                                            .registers = st7796_registers};
static const struct emulated_kind gc9a01 = {.name = "gc9a01",
                                            .w_px = 240,
                                            .h_px = 240,
                                            .takes_12 = true,
                                            .takes_16 = true,
                                            .is_round = true,
                                            .registers = gc9a01_registers};

const struct emulated_kind *const emulated_kinds[] = {&gc9a01, &ili9341, &ili9488, &st7735, &st7789, &st7796, NULL};

const struct emulated_kind *emulated_kind_find(const char *name)
{
    for (size_t i = 0; emulated_kinds[i]; i++)
        if (strcmp(emulated_kinds[i]->name, name) == 0) return emulated_kinds[i];
    return NULL;
}
