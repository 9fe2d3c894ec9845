/* SPDX-License-Identifier: MIT
 *
 * Ways between a triangle's corners, on the screen and in its texture: two signed numbers each, below 2^15. Where two
 * products of 16 bits are one instruction both are in one word. The same values everywhere. */
#ifndef LIM_MESH_WAY_H
#define LIM_MESH_WAY_H

#include "lines/mesh_plane.h"
#include "math/pair.h"
#include "scene.h"
#include "view/packed.h"

/* |x|, or one less. */
static inline uint32_t nearly_abs(int32_t x)
{
    return (uint32_t)(x ^ x >> 31);
}

/* Numerators of what a pixel adds to a place, times the area. */
struct mesh_numerators {
    int32_t ux, uy, vx, vy; /* u to the right and down, v likewise */
};

#if LIM_IS_PACKED && LIM_DUAL_MULTIPLY && !LIM_HAS_LIMBS

typedef uint32_t mesh_way;
typedef uint32_t __attribute__((may_alias)) mesh_way_word;

static inline mesh_way mesh_way_of_points(lim_packed from, lim_packed to)
{
    return (uint32_t)__builtin_arm_ssub16(to, from);
}

static inline mesh_way mesh_way_to_place(const struct lim_uv *to)
{
    return *(const mesh_way_word *)to;
}

static inline mesh_way mesh_way_between(mesh_way from, mesh_way to)
{
    return (uint32_t)__builtin_arm_ssub16((int32_t)to, (int32_t)from);
}

static inline int32_t mesh_way_cross(mesh_way a, mesh_way b)
{
    return __builtin_arm_smusdx((int32_t)a, (int32_t)b);
}

static inline int32_t mesh_way_x(mesh_way way)
{
    return (int16_t)way;
}

static inline int32_t mesh_way_y(mesh_way way)
{
    return (int32_t)way >> 16;
}

/* nearly_abs() of all, OR'ed. */
static inline uint32_t mesh_way_most(mesh_way a, mesh_way b)
{
    const uint32_t high = nearly_abs((int32_t)a) | nearly_abs((int32_t)b);

    return high >> 16 | nearly_abs((int16_t)a) | nearly_abs((int16_t)b);
}

/* The same of half the ways from a point to two others, which may be too long for a way. */
static inline uint32_t mesh_way_most_half(lim_packed a, lim_packed b, lim_packed c)
{
    return mesh_way_most((uint32_t)__builtin_arm_shsub16(b, a), (uint32_t)__builtin_arm_shsub16(c, a));
}

static inline void mesh_way_halve(mesh_way *u, mesh_way *v, uint8_t halved[2])
{
    (void)u, (void)v;
    halved[0] = halved[1] = 0;
}

/* Of places that gain b and c on the ways u and v. */
static inline void mesh_way_numerators(mesh_way u, mesh_way v, mesh_way b, mesh_way c, struct mesh_numerators *out)
{
    const mesh_way across = pair_of_lows(u, v), down = pair_of_highs(u, v);
    const mesh_way of_u = pair_of_lows(b, c), of_v = pair_of_highs(b, c);

    out->ux = mesh_way_cross(down, of_u);
    out->uy = mesh_way_cross(of_u, across);
    out->vx = mesh_way_cross(down, of_v);
    out->vy = mesh_way_cross(of_v, across);
}

#else

typedef struct {
    int32_t x, y;
} mesh_way;

static inline mesh_way mesh_way_of_points(lim_packed from, lim_packed to)
{
    const mesh_way way = {lim_packed_x(to) - lim_packed_x(from), lim_packed_y(to) - lim_packed_y(from)};
    return way;
}

static inline mesh_way mesh_way_to_place(const LIM_FLASH struct lim_uv *to)
{
    const mesh_way way = {to->u, to->v};
    return way;
}

static inline mesh_way mesh_way_between(mesh_way from, mesh_way to)
{
    const mesh_way way = {to.x - from.x, to.y - from.y};
    return way;
}

static inline int32_t mesh_way_cross(mesh_way a, mesh_way b)
{
    return a.x * b.y - a.y * b.x;
}

static inline int32_t mesh_way_x(mesh_way way)
{
    return way.x;
}

static inline int32_t mesh_way_y(mesh_way way)
{
    return way.y;
}

static inline uint32_t mesh_way_most(mesh_way a, mesh_way b)
{
    return nearly_abs(a.x) | nearly_abs(a.y) | nearly_abs(b.x) | nearly_abs(b.y);
}

static inline uint32_t mesh_way_most_half(lim_packed a, lim_packed b, lim_packed c)
{
    return mesh_way_most(mesh_way_of_points(a, b), mesh_way_of_points(a, c)) >> 1;
}

static inline void mesh_way_halve(mesh_way *u, mesh_way *v, uint8_t halved[2])
{
    halved[0] = LIM_HAS_LIMBS ? mesh_halve(&u->x, &v->x) : 0;
    halved[1] = LIM_HAS_LIMBS ? mesh_halve(&u->y, &v->y) : 0;
}

static inline void mesh_way_numerators(mesh_way u, mesh_way v, mesh_way b, mesh_way c, struct mesh_numerators *out)
{
    out->ux = c.x * u.y - b.x * v.y;
    out->uy = b.x * v.x - c.x * u.x;
    out->vx = c.y * u.y - b.y * v.y;
    out->vy = b.y * v.x - c.y * u.x;
}

#endif

#endif
