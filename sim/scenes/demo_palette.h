/* SPDX-License-Identifier: MIT
 *
 * Few colours, all of which an RGB565 panel shows exactly. */
#ifndef DEMO_PALETTE_H
#define DEMO_PALETTE_H

#include "demo_soup.h"

void palette_reduce(struct soup *soup);

#endif
