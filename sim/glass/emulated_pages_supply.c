/* SPDX-License-Identifier: MIT
 *
 * What voltage a chip makes for its glass: not seen, but too much of it wears glass out or blackens it. */
#include "glass/emulated_pages.h"

#include <string.h>

/* ST7567: V0 = RR (1 - (63 - EV) / 162) 2.1 V, and RR from 3.0 to 6.5. */
static unsigned st7567_mv(const struct emulated_pages *chip)
{
    const unsigned ratio_tenths = 30 + 5u * chip->ratio;

    return ratio_tenths * 210 * (162 - 63 + (chip->level & 63u)) / 162;
}

/* PCD8544: 3.06 V and 0.06 V a step. */
static unsigned pcd8544_mv(const struct emulated_pages *chip)
{
    return 3060 + 60u * chip->level;
}

static unsigned sh1106_mv(const struct emulated_pages *chip)
{
    static const uint16_t pump_mv[] = {6400, 7400, 8000, 9000};

    return pump_mv[chip->ratio & 3];
}

unsigned emulated_pages_supply_mv(const struct emulated_pages *chip)
{
    static const struct {
        const char *chip;
        unsigned (*mv)(const struct emulated_pages *chip);
    } supplies[] = {{"pcd8544", pcd8544_mv}, {"sh1106", sh1106_mv}, {"st7567", st7567_mv}};

    for (size_t i = 0; i < sizeof supplies / sizeof supplies[0]; i++)
        if (strcmp(supplies[i].chip, chip->glass.chip) == 0) return supplies[i].mv(chip);
    return 0;
}
