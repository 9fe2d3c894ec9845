/* SPDX-License-Identifier: MIT
 *
 * DESCENT: the nodes of a tree whose polygons a box may meet on its way, nearest first. In: the tree, a box that moves
 * along a segment; of a ray it has no size. Out: nodes and leaves, whose runs the caller asks one polygon after the
 * other. Memory: the stack of a struct lim_solid; no recursion.
 *
 * What is left out holds no polygon that can be met, whatever rounding and the compiler's tolerance (half a unit) did
 * to it. Where that is not certain, a node is given. */
#ifndef LIM_DESCENT_H
#define LIM_DESCENT_H

#include "collide.h"
#include "math/fixed.h"
#include "view/plane_unpacked.h"

/* An end of the way. */
struct lim_descent_end {
    int32_t at_q8[3];
    int32_t whole[3]; /* floor(at / 2^shift) in units, within 16 bits */
    uint8_t shift;    /* 0 inside of the scene's cube */
};

struct lim_descent {
    const struct lim_scene *scene;
    lim_index *stack;
    lim_index next;
    uint16_t depth; /* of what waits on the stack */
    bool is_ray;
    struct lim_descent_end from, to;   /* `to` comes nearer when something is met */
    int32_t half_q8[3], half_units[3]; /* of the box; the second rounded up */
    int32_t low[3], high[3];           /* what it sweeps over, units: with the slack that boxes are tested with */
    int32_t way[3];                    /* of a ray: its direction in 13 bits */
};

/* half_q8: NULL for a ray. */
void lim_descent_begin(struct lim_descent *descent, const struct lim_solid *solid, const int32_t from_q8[3],
                       const int32_t to_q8[3], const int32_t half_q8[3]);

/* Something was met: what lies beyond this part of the way, and a little more, is no longer asked for. way_q8: the
 * whole way. */
void lim_descent_shorten(struct lim_descent *descent, const int32_t way_q8[3], uint32_t part_q30);

/* The next node that has polygons, or NULL. */
const LIM_FLASH struct lim_node *lim_descent_next(struct lim_descent *descent);

/* The plane of a leaf's record; of a mesh leaf's that of its corners, whose front they run around counter-clockwise.
 * false: they lie on a line. */
bool lim_descent_plane(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                       const LIM_FLASH lim_index *record);

/* How far along, 0..1, num / den is, rounded down by 2^-29 at most: 0 <= num <= den, 0 < den. */
uint32_t lim_part_q30(uint64_t num, uint64_t den);

/* That part of a way, rounded towards its beginning: |way| < 2^30. */
static inline int32_t lim_part_of(int32_t way_q8, uint32_t part_q30)
{
    const uint32_t size_q8 = (uint32_t)(((uint64_t)abs_s32(way_q8) * part_q30) >> 30);

    return way_q8 < 0 ? -(int32_t)size_q8 : (int32_t)size_q8;
}

/* An axis as a hit's normal: its sign, and as many of its bits as 16 hold. */
void lim_hit_normal(const int32_t axis[3], bool other_way, int16_t normal[3]);

#endif
