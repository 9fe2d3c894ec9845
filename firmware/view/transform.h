/* SPDX-License-Identifier: MIT
 *
 * From a vertex to view space: three rows. A row's entries have 16 bits; profiles with limbs add 15 further
 * bits, profile exact 8 further bits of the vertex. Where a long multiplication is one instruction, an
 * entry and its limb are one number: other instructions, the same bits, because for n = 2^15 high + low
 *
 *     floor(n . v / 2^15) = high . v + floor(low . v / 2^15).
 *
 * Range: rows.c scales the rows so that every vertex lies below 2^31 - 2^18 in view space, in truth, 2^30 - 2^18 with
 * limbs; rounding three entries adds 98,304 at most, the limb 1 and the fraction 49,151. Sums wrap on the way; their
 * values do not. */
#ifndef LIM_TRANSFORM_H
#define LIM_TRANSFORM_H

#include "math/fixed.h"
#include "stages.h"

/* n . v + sum, which may wrap. |n| <= 2^15, |v| <= 2^15: no single product does. */
/*@ requires \valid_read(n + (0 .. 2)) && \valid_read(at);
    requires -32768 <= n[0] <= 32767 && -32768 <= n[1] <= 32767 && -32768 <= n[2] <= 32767;
    assigns \nothing; */
static inline uint32_t transform_dot(const lim_row_entry n[3], const struct lim_vertex *at, uint32_t sum)
{
#if LIM_DUAL_MULTIPLY
    return fixed_dot_pairs(n, &at->x, sum) + (uint32_t)((int32_t)n[2] * at->z);
#else
    return (uint32_t)((int32_t)n[0] * at->x) + (uint32_t)((int32_t)n[1] * at->y) + (uint32_t)((int32_t)n[2] * at->z) +
           sum;
#endif
}

/*@ requires \valid_read(row) && \valid_read(at);
    requires -32767 <= row->n_qv[0] <= 32767 && -32767 <= row->n_qv[1] <= 32767 && -32767 <= row->n_qv[2] <= 32767;
    assigns \nothing; */
static inline int32_t transform_short(const struct lim_row *row, const struct lim_vertex *at)
{
    return (int32_t)transform_dot(row->n_qv, at, (uint32_t)row->shift_qv);
}

#if LIM_HAS_LIMBS

/*@ requires \valid_read(row) && \valid_read(at);
    requires -32767 <= row->n_qv[0] <= 32767 && -32767 <= row->n_qv[1] <= 32767 && -32767 <= row->n_qv[2] <= 32767;
    requires -16384 <= row->low_qv15[0] <= 16384 && -16384 <= row->low_qv15[1] <= 16384;
    requires -16384 <= row->low_qv15[2] <= 16384;
    assigns \nothing; */
static inline int32_t transform_limbs(const struct lim_row *row, const struct lim_vertex *at)
{
    const int32_t low_qv15 = (int32_t)transform_dot(row->low_qv15, at, 0);

    return (int32_t)((uint32_t)transform_short(row, at) + (uint32_t)(low_qv15 >> 15));
}

#if LIM_LONG_MULTIPLY
/*@ requires \valid_read(row) && \valid_read(at);
    assigns \nothing; */
static inline int32_t transform_long(const struct lim_row *row, const struct lim_vertex *at)
{
    const uint64_t sum_qv32 = (uint64_t)((int64_t)row->n_qv16[0] * (at->x * INT32_C(65536))) +
                              (uint64_t)((int64_t)row->n_qv16[1] * (at->y * INT32_C(65536))) +
                              (uint64_t)((int64_t)row->n_qv16[2] * (at->z * INT32_C(65536)));

    return (int32_t)((uint32_t)(sum_qv32 >> 32) + (uint32_t)row->shift_qv);
}
#endif

/* An entry with all its bits. */
static inline int32_t transform_entry_qv15(const struct lim_row *row, uint_fast8_t i)
{
    return (int32_t)row->n_qv[i] * (INT32_C(1) << 15) + (int32_t)row->low_qv15[i];
}

/* n . d / 2^17 of a way from the eye to a point of a long scene: |n . d| < 2^61 sqrt(3). */
static inline int32_t transform_way(const struct lim_row *row, const int32_t way[3])
{
    int64_t sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++)
        sum += ((int64_t)row->n_qv[i] * (INT32_C(1) << 15) + row->low_qv15[i]) * way[i];
    return (int32_t)(sum >> 32);
}

#else

static inline int32_t transform_entry_qv15(const struct lim_row *row, uint_fast8_t i)
{
    return (int32_t)row->n_qv[i] * (INT32_C(1) << 15);
}

/* The same, 2^-16: each product rounded down, below 2^30 sqrt(3) together. */
static inline int32_t transform_way(const struct lim_row *row, const int32_t way[3])
{
    int32_t sum = 0;

    LIM_UNROLLED(3)
    for (uint_fast8_t i = 0; i < 3; i++)
        sum = fixed_add_product(way[i], (int32_t)row->n_qv[i], sum);
    return sum;
}

#endif

static inline int32_t transform_row(const struct lim_row *row, const struct lim_vertex *at)
{
#if LIM_HAS_LIMBS && LIM_LONG_MULTIPLY
    return transform_long(row, at);
#elif LIM_HAS_LIMBS
    return transform_limbs(row, at);
#else
    return transform_short(row, at);
#endif
}

/* Sums of the rows, to view space: a long lens's x and y are turned back, and z gets its length. */
static inline void transform_settle(const struct lim_rows *rows, int32_t qv[3])
{
    if (LIM_TURNS_ROWS) {
        qv[0] += mul_high_s32(qv[2], rows->turn_q32[0]);
        qv[1] += mul_high_s32(qv[2], rows->turn_q32[1]);
    }
    if (!LIM_HAS_LIMBS) qv[2] >>= rows->tele_bits;
}

/* What a vertex's fraction adds to a row: at most 3/2 of its largest entry, 49,151. */
/*@ requires \valid_read(row) && \valid_read(fraction);
    requires -32767 <= row->n_qv[0] <= 32767 && -32767 <= row->n_qv[1] <= 32767 && -32767 <= row->n_qv[2] <= 32767;
    assigns \nothing;
    ensures -49151 <= \result <= 49151; */
static inline int32_t transform_fraction(const struct lim_row *row, const struct lim_fraction *fraction)
{
    return shift_round_s32((int32_t)row->n_qv[0] * fraction->x_q8 + (int32_t)row->n_qv[1] * fraction->y_q8 +
                               (int32_t)row->n_qv[2] * fraction->z_q8,
                           8);
}

#endif
