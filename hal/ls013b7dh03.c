/* SPDX-License-Identifier: MIT
 *
 * Sharp LS013B7DH03: 128x128 memory LCD of 1.28 inches, 3 V; clock 1.1 MHz by the datasheet. */
#include "panels.h"

const struct sharp_chip ls013b7dh03 = {.name = "ls013b7dh03", .w_px = 128, .h_px = 128};
