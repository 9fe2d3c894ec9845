/* SPDX-License-Identifier: MIT
 *
 * SLIDE: a box goes on beside what stops it. */
#ifndef LIM_SLIDE_H
#define LIM_SLIDE_H

#include "collide.h"

/* lim_slide(), or on the level: then it slides along the normals' level parts, and stays as high as it is. */
int lim_slide_by(const struct lim_solid *solid, const int32_t half_q8[3], int32_t at_q8[3], const int32_t way_q8[3],
                 uint8_t flags, bool on_level);

#endif
