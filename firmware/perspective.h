/* SPDX-License-Identifier: MIT
 *
 * From view space to the screen: x / z by a reciprocal, times half the screen's side, rounded to
 * sub-pixels. Needs PERSPECTIVE_Z_MIN_QV <= z and |x| <= 2z: what CLIP leaves, and what the codes of VIEW let pass.
 *
 * Three forms of x / z, by profile; let m be z shifted to a mantissa, and r the table's reciprocal of m.
 *   draft, fast  m of 15 bits, r of 15; x, shifted along, rounded to 17: x r is x / z in Q29, right to 2^-14.
 *   fine         m of 31 bits, r of 15: q = x r in Q28, right to 2^-13 like r itself; but 1 - m r is known,
 *                so q (1 + (1 - m r)) is right to 2^-19.
 *   exact        the same correction for r, which becomes a reciprocal of 31 bits: x / z in Q28, right to 2^-27.
 * Either, times the side, is the distance from the middle in half-pixels, below 2^11. */
#ifndef LIM_PERSPECTIVE_H
#define LIM_PERSPECTIVE_H

#include "fixed.h"
#include "profile.h"

/* The 16-bit form shifts z right to 15 bits; the others use a scale half as large (rows.c). */
#define PERSPECTIVE_Z_MIN_QV (LIM_HAS_LIMBS ? INT32_C(1) << 14 : INT32_C(1) << 15)

/* Fraction bits: of the ratio, of what of it the side is multiplied with, of half-pixels below sub-pixels. */
enum {
    PERSPECTIVE_RATIO_BITS = LIM_HAS_LIMBS ? 28 : 29,
    PERSPECTIVE_SCREEN_BITS = LIM_HAS_FRACTIONS ? 12 : 19,
    PERSPECTIVE_DROPPED_BITS = PERSPECTIVE_SCREEN_BITS + 1 - LIM_SUB_BITS
};

/* One side of the screen. */
struct lim_side {
    int32_t px;
    int32_t middle_qs; /* half-pixels from the origin, and what makes the last shift round */
};

/* Pixel centres are whole, so the middle of n pixels is n - 1 half-pixels from the first. */
/*@ requires \valid(side) && 1 <= px <= 1024;
    assigns *side;
    ensures 1 <= side->px <= 1024; */
static inline void perspective_set(struct lim_side *side, uint16_t px)
{
    side->px = px;
    side->middle_qs = (side->px - 1 - 2 * LIM_ORIGIN_PX) * ((int32_t)1 << PERSPECTIVE_SCREEN_BITS) +
                      ((int32_t)1 << (PERSPECTIVE_DROPPED_BITS - 1));
}

#if LIM_HAS_FRACTIONS

/* What the coordinates of a point have in common. */
struct lim_depth {
    int32_t recip_q31;
    uint32_t shift; /* of x, left */
};

static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const int32_t recip_q31 = (int32_t)recip_q31_of((uint32_t)z_qv, &zeros);

    return (struct lim_depth){recip_q31, zeros - 2u};
}

static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    return mul_high_s32(x_qv * ((int32_t)1 << depth.shift), depth.recip_q31);
}

#elif LIM_HAS_LIMBS

struct lim_depth {
    int32_t short_by_q20; /* 1 - m r, 0 .. 2^7 */
    int32_t recip_q31;    /* 15 bits of it */
    uint32_t shift;       /* of x, left */
};

static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const uint32_t recip_q31 = recip_q24((uint32_t)z_qv, &zeros) >> 9 << 16;
    const uint32_t product_q30 = mul_u32_top((uint32_t)z_qv << zeros, recip_q31);

    return (struct lim_depth){(int32_t)((UINT32_C(1) << 30) - product_q30) >> 10, (int32_t)recip_q31, zeros - 2u};
}

static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    const int32_t q_q28 = mul_s32_top(x_qv * ((int32_t)1 << depth.shift), depth.recip_q31);

    return q_q28 + (q_q28 >> 20) * depth.short_by_q20;
}

#else

struct lim_depth {
    int32_t recip_q15;
    uint32_t shift; /* of x, right: 1..16 */
};

/*@ requires 32768 <= z_qv;
    assigns \nothing; */
static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const int32_t recip_q15 = (int32_t)recip_q15_of((uint32_t)z_qv, &zeros);

    return (struct lim_depth){recip_q15, 17u - zeros};
}

static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    return shift_round_s32(x_qv, depth.shift) * depth.recip_q15;
}

#endif

static inline lim_sub perspective_at(int32_t x_qv, struct lim_depth depth, const struct lim_side *side)
{
    const int32_t ratio = perspective_ratio(x_qv, depth);
    const int32_t from_middle_qs = LIM_HAS_FRACTIONS
                                       ? mul_s32_top(ratio, side->px * 65536)
                                       : (ratio >> (PERSPECTIVE_RATIO_BITS - PERSPECTIVE_SCREEN_BITS)) * side->px;

    return (lim_sub)((from_middle_qs + side->middle_qs) >> PERSPECTIVE_DROPPED_BITS);
}

#endif
