/* SPDX-License-Identifier: MIT
 *
 * The ST7789 as a chip of the MIPI Display Command Set: its memory, and what it must be told
 * besides what all such chips are told. Its power and gamma registers keep the values that it
 * loads at reset, which every module's glass was chosen for. */
#include "st7789.h"

#define COLMOD_RGB565 0x55

int st7789_setup(struct dcs *dcs, const struct dcs_config *config)
{
    static const uint8_t setup[] = {DCS_COLMOD, 1, COLMOD_RGB565, DCS_NORON, 0};
    static const struct dcs_chip chip = {
        .mem_w_px = ST7789_MEM_W_PX,
        .mem_h_px = ST7789_MEM_H_PX,
        .setup = setup,
        .setup_b = sizeof setup,
    };
    return dcs_setup(dcs, &chip, config);
}
