/* SPDX-License-Identifier: MIT
 *
 * Sitronix ST7789, ST7789V, ST7789V2: 240x320 memory behind glass of any size up to that, on SPI
 * with a D/C pin, write clock up to 62.5 MHz by the datasheet; modules without a chip select pin need
 * SPI mode 3. Pixels are RGB565. Common modules:
 *     glass     ox_px, oy_px        glass     ox_px, oy_px
 *     240x240   0, 0                135x240   52, 40
 *     240x320   0, 0                240x280   0, 20
 * nearly all of them IPS (invert = true) and RGB.
 *
 *     struct dcs display;
 *     int err = st7789_setup(&display, &(struct dcs_config){.bus = bus, .dc = dc, .clock = clock,
 *                                                           .w_px = 240, .h_px = 240, .invert = true});
 *     if (!err) err = panel_init(&display.panel); */
#ifndef HAL_ST7789_H
#define HAL_ST7789_H

#include "dcs.h"

#define ST7789_MEM_W_PX 240
#define ST7789_MEM_H_PX 320

/* As dcs_setup(). */
HAL_MUST_CHECK int st7789_setup(struct dcs *dcs, const struct dcs_config *config);

#endif
