/* SPDX-License-Identifier: MIT */
#include "panels.h"

const struct dcs_chip *const panels_dcs[] = {&gc9a01, &ili9341, &ili9488, &st7735, &st7789, NULL};
