/* SPDX-License-Identifier: MIT */
#include "panels.h"

const struct dcs_chip *const panels_dcs[] = {&gc9a01, &ili9341, &ili9488, &st7735, &st7789, NULL};

const struct pages_chip *const panels_pages[] = {&pcd8544, &sh1106, &ssd1306, &st7567, NULL};
