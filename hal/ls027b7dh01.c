/* SPDX-License-Identifier: MIT
 *
 * Sharp LS027B7DH01: 400x240 memory LCD of 2.7 inches, supply 5 V, inputs 3 V; clock 2 MHz by the datasheet. */
#include "panels.h"

const struct sharp_chip ls027b7dh01 = {.name = "ls027b7dh01", .w_px = 400, .h_px = 240};
