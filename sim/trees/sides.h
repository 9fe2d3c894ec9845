/* SPDX-License-Identifier: MIT
 *
 * On which side of a plane each piece of a list lies, for many planes: what bsp_piece_filed() tells, several times
 * faster, since the pieces' spheres, bounds and corners are laid out side by side once. */
#ifndef SIM_SIDES_H
#define SIM_SIDES_H

#include "trees/bsp.h"

struct sides {
    const struct bsp *bsp;
    const uint32_t *list; /* the caller's */
    size_t count;
    double *spheres;  /* four for each piece: centre, and radius with tolerance */
    double *bounds;   /* six for each piece: least and greatest along each axis */
    double *corners;  /* three for each corner */
    uint32_t *firsts; /* of each piece among the corners; one more at the end */
    uint32_t *groups; /* of each piece */
};

void sides_begin(struct sides *sides, const struct bsp *bsp, const uint32_t *list, size_t count);

/* BSP_FRONT, BSP_BACK or BSP_BOTH for each piece, and BSP_ON for those of the group itself; `group` may be a cut. */
void sides_find(const struct sides *sides, uint32_t group, uint8_t *out);

void sides_end(struct sides *sides);

#endif
