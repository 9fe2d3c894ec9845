/* SPDX-License-Identifier: MIT
 *
 * Whether texels may advance evenly over a triangle, as the eye sees it. In: nearness at its corners, and the ways
 * between their places. Between corners where 1 / z is w an even way is off by a quarter of the product of what place
 * and w gain along a side, over the least w, and nowhere by more. */
#ifndef LIM_MESH_EVEN_H
#define LIM_MESH_EVEN_H

#include "lines/mesh_clip.h"
#include "lines/mesh_way.h"
#include "pixels/texture_planes.h"

/* What the corners b and c are nearer than a. */
struct nears {
    int32_t a, b, c;
};

static LIM_INLINE struct nears nears_of(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    const int32_t a = mesh->nearness[corners[0]];

    return (struct nears){a, mesh->nearness[corners[1]] - a, mesh->nearness[corners[2]] - a};
}

/* What nearness and a coordinate gain along each side, multiplied: over four times the nearness, how far off an even
 * way is there. */
struct mesh_sides {
    int32_t b, c, across;
};

static LIM_INLINE struct mesh_sides mesh_sides_of(const struct nears *nears, int32_t b, int32_t c)
{
    return (struct mesh_sides){b * nears->b, c * nears->c, (c - b) * (nears->c - nears->b)};
}

/* nearly_abs() of them, OR'ed. */
static inline uint32_t most_of_sides(const struct mesh_sides *sides)
{
    return nearly_abs(sides->b) | nearly_abs(sides->c) | nearly_abs(sides->across);
}

/* How far apart they are, and 0; and twice the middle between. */
static LIM_INLINE uint32_t spread_of(const struct mesh_sides *sides, int32_t *twice_middle)
{
    const int32_t b = sides->b, c = sides->c, across = sides->across;
    int32_t least = b < 0 ? b : 0, most = b < 0 ? 0 : b;

    least = c < least ? c : least;
    most = c > most ? c : most;
    least = across < least ? across : least;
    most = across > most ? across : most;
    *twice_middle = least + most;
    return (uint32_t)most - (uint32_t)least;
}

static inline int32_t least_of(const struct nears *nears)
{
    const int32_t b = nears->b < 0 ? nears->b : 0;

    return nears->a + (nears->c < b ? nears->c : b);
}

/* Whether even texels are right enough between the corners; nearness is rounded at both ends of a side. Where an even
 * way is not, it may be if it leaves the corners, by the middle of all errors: *moved is that, packed. `bits`: a texel
 * of the level, in units of places, and of what it may be off.
 *
 * Between two corners places differ by less than 2^15, and nearness as well: products are below 2^30, and 2 most below
 * 2^16. least << 15 is about 2^30, so the bound grows no more from there on. For the second test all have 14 bits, and
 * spreads 31. */
static LIM_INLINE bool is_even(const struct nears *nears, mesh_way b, mesh_way c, int_fast16_t bits, uint_fast8_t up,
                               uint32_t *moved)
{
    const struct mesh_sides u = mesh_sides_of(nears, mesh_way_x(b), mesh_way_x(c)),
                            v = mesh_sides_of(nears, mesh_way_y(b), mesh_way_y(c));
    const uint32_t most = mesh_way_most(b, c);
    const int32_t least = least_of(nears);
    int32_t u_middle, v_middle;

    if (bits < 0) return false;
    if ((most_of_sides(&u) | most_of_sides(&v)) + 2 * most < (uint32_t)least << (bits < 13 ? bits + 2 : 15))
        return true;
    if ((most | nearly_abs(nears->b) | nearly_abs(nears->c)) >> 14) return false;
    const uint32_t u_spread = spread_of(&u, &u_middle), v_spread = spread_of(&v, &v_middle);
    if ((u_spread > v_spread ? u_spread : v_spread) + 2 * most > (uint32_t)least << (bits < 12 ? bits + 3 : 15))
        return false;
    *moved = lim_texture_packed((uint32_t)(u_middle / (8 * least)) << up, (uint32_t)(v_middle / (8 * least)) << up);
    return true;
}

/* Steps are rounded: whether that leads less than half of what even texels may be off, over pixels that are not more
 * than four times the longest way. */
static LIM_INLINE bool is_within_reach(uint32_t most_half, int_fast16_t bits)
{
    return bits >= 0 && !((most_half + 1) * 8 >> LIM_SUB_BITS >> (bits < 31 ? bits : 31));
}

#endif
