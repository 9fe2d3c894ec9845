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

#include "math/fixed.h"
#include "stages.h"

/* The 16-bit form shifts z right to 15 bits; the others use a scale half as large (rows.c). */
#define PERSPECTIVE_Z_MIN_QV (LIM_HAS_LIMBS ? INT32_C(1) << 14 : INT32_C(1) << 15)
/* |x| and z of a vertex in view space (transform.h). */
#define PERSPECTIVE_MAX_QV (LIM_HAS_LIMBS ? (INT32_C(1) << 30) - 1 : INT32_MAX - (INT32_C(1) << 17))

/* Fraction bits: of the ratio, of what of it the side is multiplied with, of half-pixels below sub-pixels. */
enum {
    PERSPECTIVE_RATIO_BITS = LIM_HAS_LIMBS ? 28 : 29,
    PERSPECTIVE_SCREEN_BITS = LIM_HAS_FRACTIONS ? 12 : 19,
    PERSPECTIVE_DROPPED_BITS = PERSPECTIVE_SCREEN_BITS + 1 - LIM_SUB_BITS
};

/* What |x| <= 2z comes to: 2, and 2^-11 for the errors. */
#define PERSPECTIVE_RATIO_MAX ((INT32_C(2) << PERSPECTIVE_RATIO_BITS) + (INT32_C(1) << (PERSPECTIVE_RATIO_BITS - 11)))

/* The same of the ratio that the side is multiplied with. */
#define PERSPECTIVE_SCREEN_MAX (PERSPECTIVE_RATIO_MAX >> (PERSPECTIVE_RATIO_BITS - PERSPECTIVE_SCREEN_BITS))

/*@ predicate is_side(struct lim_side side) =
      1 <= side.px <= LIM_MAX_SIDE_PX &&
      side.middle_qs == (side.px - 1 - 2 * LIM_ORIGIN_PX) * (1 << PERSPECTIVE_SCREEN_BITS) +
                        (1 << (PERSPECTIVE_DROPPED_BITS - 1)); */

/* Pixel centres are whole, so the middle of n pixels is n - 1 half-pixels from the first. */
/*@ requires \valid(side) && 1 <= px <= LIM_MAX_SIDE_PX;
    assigns *side;
    ensures is_side(*side); */
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

/* x / z can be taken: x keeps its 32 bits, and what the ratio will be its bound. */
/*@ predicate is_in_band(integer x, struct lim_depth depth) =
      depth.shift <= 30 && 0 <= depth.recip_q31 &&
      -2147483647 <= x * (1 << depth.shift) <= 2147483647 &&
      -2305843021024854016 <= x * (1 << depth.shift) * depth.recip_q31 <= 2305843021024854016; */

/*@ requires PERSPECTIVE_Z_MIN_QV <= z_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures is_in_band(2 * z_qv, \result); */
static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const int32_t recip_q31 = (int32_t)recip_q31_of((uint32_t)z_qv, &zeros);

    //@ assert is_clz(z_qv, zeros) && is_recip_q31(recip_q31, z_qv * (1 << zeros)) && 2 <= zeros <= 31;
    //@ assert z_qv * (1 << zeros) <= 4294967295;
    //@ assert z_qv * (1 << zeros) * recip_q31 <= 4611686018427387904 + 3 * 4294967295;
    //@ assert (1 << zeros) == 4 * (1 << (zeros - 2));
    //@ assert 4 * (z_qv * (1 << (zeros - 2))) <= 4294967295;
    //@ assert 4 * (z_qv * (1 << (zeros - 2)) * recip_q31) <= 4611686018427387904 + 3 * 4294967295;
    return (struct lim_depth){recip_q31, zeros - 2u};
}

/*@ requires is_in_band(x_qv, depth) && -PERSPECTIVE_MAX_QV <= x_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures -PERSPECTIVE_RATIO_MAX <= \result <= PERSPECTIVE_RATIO_MAX; */
static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    return mul_high_s32(x_qv * ((int32_t)1 << depth.shift), depth.recip_q31);
}

/* 1 / z, 1..32769, rounded down; `near_shift` is the shift of the nearest depth that there is. */
static inline uint16_t perspective_nearness(struct lim_depth depth, uint32_t near_shift)
{
    return (uint16_t)(((uint32_t)depth.recip_q31 >> 16 >> (near_shift - depth.shift)) + 1);
}

/* The shift with which nearness is 2^bits times as fine. */
static inline uint32_t perspective_finer(uint32_t near_shift, uint8_t bits)
{
    return near_shift - bits;
}

#elif LIM_HAS_LIMBS

struct lim_depth {
    int32_t short_by_q20; /* 1 - m r, within 2^7 */
    int32_t recip_q31;    /* 15 bits of it */
    uint32_t shift;       /* of x, left */
};

/*@ predicate is_in_band(integer x, struct lim_depth depth) =
      depth.shift <= 30 && -128 <= depth.short_by_q20 <= 128 && 0 <= depth.recip_q31 && depth.recip_q31 % 65536 == 0 &&
      -2147483647 <= x * (1 << depth.shift) <= 2147483647 &&
      -2305983746702049280 <= x * (1 << depth.shift) * depth.recip_q31 <= 2305983746702049280; */

/*@ requires PERSPECTIVE_Z_MIN_QV <= z_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures is_in_band(2 * z_qv, \result); */
static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const uint32_t exact_q24 = recip_q24((uint32_t)z_qv, &zeros), recip_q31 = (exact_q24 >> 9) * 65536;
    const uint32_t mantissa_q31 = (uint32_t)z_qv * (UINT32_C(1) << zeros);
    //@ assert is_clz(z_qv, zeros) && is_recip_q24(exact_q24, z_qv * (1 << zeros)) && 2 <= zeros <= 31;
    /*@ ghost const int64_t m_q31 = z_qv * ((int64_t)1 << zeros), r_q15 = exact_q24 >> 9;
        scale(r_q15 * 512, exact_q24, m_q31);
        scale(exact_q24, r_q15 * 512 + 511, m_q31);
        scale(mantissa_q31, m_q31, recip_q31);
        scale(m_q31, mantissa_q31, recip_q31); */
    //@ assert 70361018269696 <= (exact_q24 >> 9) * (z_qv * (1 << zeros)) <= 70373039144960;
    //@ assert recip_q31 == (exact_q24 >> 9) * 65536 && recip_q31 % 65536 == 0 && recip_q31 <= 2147483647;
    //@ assert z_qv * (1 << zeros) * recip_q31 == 65536 * ((exact_q24 >> 9) * (z_qv * (1 << zeros)));
    //@ assert z_qv * (1 << zeros) <= 4294967295;
    const int32_t product_q30 = (int32_t)mul_u32_top(mantissa_q31, recip_q31);

    //@ assert 1073623935 <= product_q30 <= 1073807360;
    //@ assert 0 <= z_qv * (1 << zeros) * recip_q31 <= 4611967493404098560;
    //@ assert (1 << zeros) == 4 * (1 << (zeros - 2));
    //@ assert 4 * (z_qv * (1 << (zeros - 2))) <= 4294967295;
    //@ assert 0 <= 4 * (z_qv * (1 << (zeros - 2)) * recip_q31) <= 4611967493404098560;
    //@ assert (int32_t)recip_q31 == recip_q31;
    //@ assert 0 <= 4 * (z_qv * (1 << (zeros - 2)) * (int32_t)recip_q31) <= 4611967493404098560;
    return (struct lim_depth){((INT32_C(1) << 30) - product_q30) >> 10, (int32_t)recip_q31, zeros - 2u};
}

/*@ requires is_in_band(x_qv, depth) && -PERSPECTIVE_MAX_QV <= x_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures -PERSPECTIVE_RATIO_MAX <= \result <= PERSPECTIVE_RATIO_MAX; */
static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    const int32_t q_q28 = mul_s32_top(x_qv * ((int32_t)1 << depth.shift), depth.recip_q31);

    return q_q28 + (q_q28 >> 20) * depth.short_by_q20;
}

/* 1 / z, 1..32769, rounded down; `near_shift` is the shift of the nearest depth that there is. */
static inline uint16_t perspective_nearness(struct lim_depth depth, uint32_t near_shift)
{
    return (uint16_t)(((uint32_t)depth.recip_q31 >> 16 >> (near_shift - depth.shift)) + 1);
}

/* The shift with which nearness is 2^bits times as fine. */
static inline uint32_t perspective_finer(uint32_t near_shift, uint8_t bits)
{
    return near_shift - bits;
}

#else

struct lim_depth {
    int32_t recip_q15;
    uint32_t shift; /* of x, right: 1..16 */
};

/*@ predicate is_in_band(integer x, struct lim_depth depth) =
      1 <= depth.shift <= 16 && 16384 <= depth.recip_q15 <= 32768 &&
      -1073872896 * (1 << depth.shift) <= x * depth.recip_q15 <= 1073872896 * (1 << depth.shift); */

/*@ requires PERSPECTIVE_Z_MIN_QV <= z_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures is_in_band(2 * z_qv, \result); */
static inline struct lim_depth perspective_depth(int32_t z_qv)
{
    uint8_t zeros;
    const int32_t recip_q15 = (int32_t)recip_q15_of((uint32_t)z_qv, &zeros);

    //@ assert 1 <= zeros <= 16;
    //@ assert z_qv * recip_q15 <= 536936448 * (1 << (17 - zeros));
    const struct lim_depth depth = {recip_q15, 17u - zeros};
    return depth;
}

/*@ requires is_in_band(x_qv, depth) && -PERSPECTIVE_MAX_QV <= x_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures -PERSPECTIVE_RATIO_MAX <= \result <= PERSPECTIVE_RATIO_MAX; */
static inline int32_t perspective_ratio(int32_t x_qv, struct lim_depth depth)
{
    //@ assert 1 <= depth.shift <= 16 && 0 <= depth.recip_q15 <= 32768;
    //@ assert -1073872896 * (1 << depth.shift) <= x_qv * depth.recip_q15 <= 1073872896 * (1 << depth.shift);
    const int32_t short_qv = shift_round_s32(x_qv, depth.shift);

    //@ assert -(1 << depth.shift) < 2 * (short_qv * (1 << depth.shift) - x_qv) <= (1 << depth.shift);
    /*@ ghost const int64_t unit = (int64_t)1 << depth.shift, twice = 2 * short_qv * unit;
        scale(2 * (int64_t)x_qv - unit, twice, depth.recip_q15);
        scale(twice, 2 * (int64_t)x_qv + unit, depth.recip_q15); */
    //@ assert -1073889280 <= short_qv * depth.recip_q15 <= 1073889280;
    return short_qv * depth.recip_q15;
}

/* 1 / z, 1..32769, rounded down; `near_shift` is the shift of the nearest depth that there is. */
static inline uint16_t perspective_nearness(struct lim_depth depth, uint32_t near_shift)
{
    return (uint16_t)(((uint32_t)depth.recip_q15 >> (depth.shift - near_shift)) + 1);
}

/* The shift with which nearness is 2^bits times as fine. */
static inline uint32_t perspective_finer(uint32_t near_shift, uint8_t bits)
{
    return near_shift + bits;
}

#endif

/* For a long lens: x is 2^zoom_bits times as much, and |x| <= 2 (z >> zoom_bits), so what is shifted left stays below
 * 2z. */
static inline void perspective_zoom(int32_t *x_qv, struct lim_depth *depth, uint8_t zoom_bits)
{
    if (LIM_HAS_LIMBS) {
        depth->shift += zoom_bits;
    } else if (depth->shift > zoom_bits) {
        depth->shift -= zoom_bits;
    } else {
        *x_qv *= (int32_t)1 << (zoom_bits + 1u - depth->shift);
        depth->shift = 1;
    }
}

/* log2 of nearness times z, but for rounding. */
static inline uint32_t perspective_nearness_bits(uint32_t near_shift)
{
    return LIM_HAS_LIMBS ? 44 - near_shift : 29 + near_shift;
}

/* Within half a screen and a pixel of the screen. */
/*@ requires \valid_read(side) && is_side(*side);
    requires is_in_band(x_qv, depth) && -PERSPECTIVE_MAX_QV <= x_qv <= PERSPECTIVE_MAX_QV;
    assigns \nothing;
    ensures -(side->px + 2) * LIM_SUB <= 2 * (\result + LIM_ORIGIN_PX * LIM_SUB) <= 3 * side->px * LIM_SUB; */
static inline lim_sub perspective_at(int32_t x_qv, struct lim_depth depth, const struct lim_side *side)
{
    const int32_t ratio = perspective_ratio(x_qv, depth);
    const int32_t from_middle_qs = LIM_HAS_FRACTIONS
                                       ? mul_s32_top(ratio, side->px * 65536)
                                       : shift_s32(ratio, PERSPECTIVE_RATIO_BITS - PERSPECTIVE_SCREEN_BITS) * side->px;

    //@ assert -PERSPECTIVE_SCREEN_MAX * side->px <= from_middle_qs <= PERSPECTIVE_SCREEN_MAX * side->px;
    return (lim_sub)shift_s32(from_middle_qs + side->middle_qs, PERSPECTIVE_DROPPED_BITS);
}

#endif
