/* SPDX-License-Identifier: MIT */
#include "panels.h"

const struct dcs_chip *const panels_dcs[] = {&gc9a01, &ili9341, &ili9488, &st7735, &st7789, &st7796, NULL};

const struct pages_chip *const panels_pages[] = {&pcd8544, &sh1106, &ssd1306, &st7567, &uc1701, NULL};

const struct solomon_chip *const panels_solomon[] = {&ssd0323, &ssd1327, &ssd1351, NULL};

const struct sharp_chip *const panels_sharp[] = {&ls013b7dh03, &ls027b7dh01, NULL};
