/* SPDX-License-Identifier: MIT
 *
 * Several numbers by the same one, as EDGE divides. Where the processor does not, by a reciprocal of 16 bits, whose
 * error the remainder shows: it is exact in 32 bits even where it is taken of numbers that wrap. */
#ifndef LIM_DIVISOR_H
#define LIM_DIVISOR_H

#include "math/fixed.h"

struct divisor {
    int32_t by;
#if !LIM_DIVIDES
    int32_t recip_q16; /* 1 / by = recip * 2^(shift - 47) */
    uint8_t shift;
#endif
};

/* What divisor_q16() takes, and by how many units of the last place its result may be too low, fewer than. */
enum { DIVISOR_WIDTH = LIM_DIVIDES ? 1 << 14 : 1 << 13, DIVISOR_ERROR = LIM_DIVIDES ? 1 : 2 };

/* 0 < by < 2^16. */
/*@ requires by > 0;
    assigns \nothing;
    ensures \result.by == by; */
static inline struct divisor divisor_of(int32_t by)
{
#if LIM_DIVIDES
    return (struct divisor){by};
#else
    uint8_t shift;
    const uint32_t reciprocal_q16 = recip_q16((uint32_t)by, &shift);
    return (struct divisor){by, (int32_t)reciprocal_q16, shift};
#endif
}

/* The same for by < 2^12. */
/*@ requires 0 < by < 4096;
    assigns \nothing;
    ensures \result.by == by; */
static inline struct divisor divisor_of_short(int32_t by)
{
#if LIM_DIVIDES
    return (struct divisor){by};
#else
    uint8_t shift;
    const uint32_t mantissa_q31 = normalise_u12((uint32_t)by, &shift);
    return (struct divisor){by, (int32_t)(recip_mantissa_q24(mantissa_q31) >> 8), shift};
#endif
}

/* a / by for |a| < DIVISOR_WIDTH, never too high. */
/*@ requires \valid_read(divisor) && divisor->by > 0 && -DIVISOR_WIDTH < a < DIVISOR_WIDTH;
    assigns \nothing;
    ensures LIM_DIVIDES ==> 0 <= a * 65536 - \result * divisor->by <= divisor->by; */
static inline int32_t divisor_q16(const struct divisor *divisor, int32_t a)
{
#if LIM_DIVIDES
    return a * 65536 / divisor->by + (a >> 31);
#else
    const int32_t guess_q16 = (a * divisor->recip_q16) >> (31 - divisor->shift);
    const int32_t rest = (int32_t)((uint32_t)a * 65536u - (uint32_t)(guess_q16 * divisor->by));
    const int32_t more_q16 = (rest * divisor->recip_q16) >> (47 - divisor->shift);
    return guess_q16 + more_q16 + ((rest - more_q16 * divisor->by) >> 31);
#endif
}

/* Of a, so that its product with the reciprocal fits: |a| < 2^25, or 2^28 on larger screens. */
enum { FLOOR_DROPPED_BITS = LIM_MAX_SIDE_PX < 256 ? 10 : 13 };

/* floor(a / by) and what is left of a, 0 <= rest < by; |a / by| <= 2 LIM_MAX_SIDE_PX + 2. */
/*@ requires \valid_read(divisor) && divisor->by > 0 && \valid(rest) && \separated(divisor, rest);
    assigns *rest;
    ensures LIM_DIVIDES ==> 0 <= *rest < divisor->by && *rest == a - \result * divisor->by; */
static inline int32_t divisor_floor(const struct divisor *divisor, int32_t a, int32_t *rest)
{
    const int32_t by = divisor->by;

#if !LIM_DIVIDES
    if (by >= 512 && by <= (int32_t)UINT16_MAX) { /* else the guess might be off by much, or not fit */
        int32_t guess = ((a >> FLOOR_DROPPED_BITS) * divisor->recip_q16) >> (47 - FLOOR_DROPPED_BITS - divisor->shift);
        int32_t left = a - guess * by;
        for (; left < 0; left += by)
            guess--;
        for (; left >= by; left -= by)
            guess++;
        *rest = left;
        return guess;
    }
#endif
    const int32_t quotient = a / by, left = a - quotient * by;
    *rest = left < 0 ? left + by : left;
    return left < 0 ? quotient - 1 : quotient;
}

/* floor(rest / by * 2^bits) for rest < by < 2^20 and an even number of bits up to 24. */
/*@ requires rest < by < 1048576 && (bits == 20 || bits == 22);
    assigns \nothing; */
static inline uint32_t divided_fraction(uint32_t by, uint32_t rest, uint8_t bits)
{
    const uint8_t half = bits / 2;
    const uint32_t high = (rest << half) / by;

    return high << half | (((rest << half) - high * by) << half) / by;
}

/* The same, never too high; by < 2^16, unless the processor divides. */
/*@ requires \valid_read(divisor) && 0 < divisor->by < 1048576 && rest < divisor->by && (bits == 20 || bits == 22);
    assigns \nothing; */
static inline uint32_t divisor_fraction(const struct divisor *divisor, uint32_t rest, uint8_t bits)
{
#if LIM_DIVIDES
    return divided_fraction((uint32_t)divisor->by, rest, bits);
#else
    const uint32_t by = (uint32_t)divisor->by, recip_q16 = (uint32_t)divisor->recip_q16;
    const uint32_t guess_q16 = (rest * recip_q16) >> (31 - divisor->shift);
    const int32_t left = (int32_t)(rest * 65536u - guess_q16 * by); /* below 5 by */
    const int32_t more = (left * (int32_t)(recip_q16 >> 4)) >> (59 - bits - divisor->shift);
    const int32_t short_of = (int32_t)(((uint32_t)left << (bits - 16)) - (uint32_t)more * by);
    return (guess_q16 << (bits - 16)) + (uint32_t)(more + (short_of >> 31));
#endif
}

#endif
