/* SPDX-License-Identifier: MIT
 *
 * The list of panels: one line here and one in panels.c for each, and a file of its own that says all about it.
 *
 *     struct dcs display;
 *     int err = dcs_setup(&display, &st7789, &(struct dcs_config){.bus = bus, .dc = dc, .clock = clock,
 *                                                                 .w_px = 240, .h_px = 240, .invert = true});
 *     if (!err) err = panel_init(&display.panel); */
#ifndef HAL_PANELS_H
#define HAL_PANELS_H

#include "dcs.h"
#include "pages.h"
#include "sharp.h"
#include "solomon.h"

HAL_C_BEGIN

extern const struct dcs_chip gc9a01;
extern const struct dcs_chip ili9341;
extern const struct dcs_chip ili9488;
extern const struct dcs_chip st7735;
extern const struct dcs_chip st7789;
extern const struct dcs_chip st7796;

extern const struct pages_chip pcd8544;
extern const struct pages_chip sh1106;
extern const struct pages_chip ssd1306;
extern const struct pages_chip st7567;
extern const struct pages_chip uc1701;

extern const struct solomon_chip ssd0323;
extern const struct solomon_chip ssd1327;
extern const struct solomon_chip ssd1351;

extern const struct sharp_chip ls013b7dh03;
extern const struct sharp_chip ls027b7dh01;

/* All of them, by name; each ends with NULL. A firmware that names its chip links no other. */
extern const struct dcs_chip *const panels_dcs[];
extern const struct pages_chip *const panels_pages[];
extern const struct solomon_chip *const panels_solomon[];
extern const struct sharp_chip *const panels_sharp[];

HAL_C_END

#endif
