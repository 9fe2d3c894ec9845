/* SPDX-License-Identifier: MIT
 *
 * Light of the demo scene, baked: every polygon gets one colour. */
#ifndef DEMO_LIGHT_H
#define DEMO_LIGHT_H

#include "demo_soup.h"

/* Cuts polygons along the edges of the sunlight that falls through windows. */
void sun_cut(struct soup *soup);

/* Sun, skylight through the windows, lamps, and four bounces from wall to wall; then exposure. */
void light_bake(struct soup *soup);

#endif
