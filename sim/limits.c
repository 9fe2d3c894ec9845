/* SPDX-License-Identifier: MIT
 *
 * What memory a frame of a scene needs. Depth and vertices are facts of the tree. */
#include "encode.h"

/* Pools that hold an average indoor or single-object frame at 240x240; more falls back to bands. */
enum { RETAINED_CELLS = 1024, GAPS = 160, ACTIVE = 48 };

struct lim_limits encode_limits(const struct encoding *encoding)
{
    return (struct lim_limits){.depth = (uint16_t)encoding->depth,
                               .vertices = (uint16_t)encoding->widest,
                               .retained_cells = RETAINED_CELLS,
                               .gaps = GAPS,
                               .active = ACTIVE};
}
