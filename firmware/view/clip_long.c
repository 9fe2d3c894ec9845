/* SPDX-License-Identifier: MIT
 *
 * Cuts of edges of a long scene whose ends have different exponents: one end may be a step away, the other at the
 * horizon. The cut is taken from the end with the lower exponent, whichever way the edge is followed, and is as exact
 * as that end where it lies near it. */
#include "view/clip.h"

#include "math/fixed.h"

#if LIM_HAS_LONG

/* m / 2^31 / 2^down, which is at most 1. */
struct cut_share {
    uint32_t m_q31;
    uint_fast8_t down;
};

/* part / (part + rest 2^up), part < 2^31, rest < 2^31, up < 32: the sum fits 64 bits. */
static struct cut_share cut_share_of(uint32_t part, uint32_t rest, uint_fast8_t up)
{
    uint64_t sum = part + ((uint64_t)rest << up);
    uint_fast8_t down = 0;

    for (; sum >> 31; sum >>= 1)
        down++;
    if (down) {
        part >>= 1; /* the sum has 31 bits: the quotient is at most 1 */
        down--;
    }
    return (struct cut_share){ratio_q31(part < sum ? part : (uint32_t)sum, sum ? (uint32_t)sum : 1), down};
}

/* x / 2^down, also where that is beyond 63 bits. */
static inline int64_t cut_shifted(int64_t x, int32_t down)
{
    return x >> (down < 63 ? down : 63);
}

/* Such a point is before the near plane, and its last bits are nothing beside that. */
void lim_clip_coarsen(struct lim_view_point *point, int32_t near_qv)
{
    int_fast16_t exponent = *point->exponent;

    while (exponent < 0 && (exponent < -30 || near_qv > INT32_C(1) << (30 + exponent)))
        exponent++;
    const int_fast16_t down = exponent - *point->exponent;
    for (uint_fast8_t i = 0; i < 3; i++)
        point->qv[i] >>= down < 31 ? down : 31;
    *point->exponent = (int8_t)exponent;
}

void lim_clip_cut_long(struct lim_view_point *out, const struct lim_view_point *a, int32_t a_d,
                       const struct lim_view_point *b, int32_t b_d)
{
    const bool a_is_low = *a->exponent < *b->exponent;
    const struct lim_view_point *low = a_is_low ? a : b, *high = a_is_low ? b : a;
    const uint_fast8_t gap = (uint_fast8_t)(*high->exponent - *low->exponent), up = gap < 31 ? gap : 31;
    const struct cut_share share = cut_share_of(abs_s32(a_is_low ? a_d : b_d), abs_s32(a_is_low ? b_d : a_d), up);
    int64_t at[3];
    uint64_t size = 0;
    int_fast16_t down = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t to_high = (int64_t)high->qv[i] * share.m_q31, of_low = (int64_t)low->qv[i] * share.m_q31;
        at[i] = low->qv[i] + cut_shifted(to_high, (int32_t)(31 + share.down - up)) -
                cut_shifted(of_low, (int32_t)(31 + share.down));
        size |= (uint64_t)(at[i] ^ at[i] >> 63);
    }
    for (; size >> 30; size >>= 1)
        down++;
    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = (int32_t)(at[i] >> down);
    *out->exponent = (int8_t)(*low->exponent + (int_fast8_t)down);
}

#endif
