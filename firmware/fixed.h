/* SPDX-License-Identifier: MIT
 *
 * Fixed-point helpers. A name's suffix is its format: x_q16 has 16 fraction bits. Right shifts of
 * negative numbers are arithmetic (floor) on every compiler that this project supports; left
 * shifts of negative numbers are never written. */
#ifndef LIM_FIXED_H
#define LIM_FIXED_H

#include "config.h"

_Static_assert((-3 >> 1) == -2, "right shifts must be arithmetic");

/* round(2^24 / (256 + i)), entry 0 clipped to 65535. */
extern const LIM_FLASH uint16_t lim_recip_table_q16[257];

/* Leading zeros of x, which must not be 0. */
static inline uint8_t clz_u32(uint32_t x)
{
#if defined(__ARM_ARCH_6M__) || defined(__AVR__) || (defined(__riscv) && !defined(__riscv_zbb))
    uint8_t n = 0; /* no such instruction: halve the search five times */
    if (x < UINT32_C(1) << 16) {
        n = 16;
        x <<= 16;
    }
    if (x < UINT32_C(1) << 24) {
        n = (uint8_t)(n + 8);
        x <<= 8;
    }
    if (x < UINT32_C(1) << 28) {
        n = (uint8_t)(n + 4);
        x <<= 4;
    }
    if (x < UINT32_C(1) << 30) {
        n = (uint8_t)(n + 2);
        x <<= 2;
    }
    return (uint8_t)(n + (x < UINT32_C(1) << 31));
#else
    return (uint8_t)__builtin_clz(x);
#endif
}

static inline uint32_t abs_s32(int32_t x)
{
    return x < 0 ? 0u - (uint32_t)x : (uint32_t)x;
}

/* x / 2^bits rounded to nearest, ties up; bits 1..30, |x| + 2^(bits - 1) < 2^31. */
static inline int32_t shift_round_s32(int32_t x, uint8_t bits)
{
    return (x + ((int32_t)1 << (bits - 1))) >> bits;
}

/* The same for 64 bits; bits 1..62. */
static inline int64_t shift_round_s64(int64_t x, uint8_t bits)
{
    return (x + ((int64_t)1 << (bits - 1))) >> bits;
}

static inline int32_t mul_q30(int32_t a_q30, int32_t b_q30)
{
    return (int32_t)shift_round_s64((int64_t)a_q30 * b_q30, 30);
}

/* 1/z for z >= 1 as r * 2^(shift - 47), r in 2^15..2^16, where shift = clz(z): table and linear
 * interpolation on the mantissa. Within 1.6 units of r's last place over all 2^32 inputs. */
static inline uint32_t recip_q16(uint32_t z, uint8_t *shift)
{
    const uint8_t n = clz_u32(z);
    const uint32_t mantissa_q31 = z << n;
    const uint16_t index = (uint16_t)((mantissa_q31 >> 23) & 255u);
    const uint32_t fraction_q8 = (mantissa_q31 >> 15) & 255u;
    const uint32_t left_q16 = lim_recip_table_q16[index];
    const uint32_t fall_q16 = left_q16 - lim_recip_table_q16[index + 1];

    *shift = n;
    return ((left_q16 << 8) - fall_q16 * fraction_q8) >> 8;
}

/* The high half of a product: floor(a b / 2^32). From 16-bit limbs where a 32 x 32 -> 64 multiplication
 * is a library call; the same bits either way. */
static inline int32_t mul_high_s32(int32_t a, int32_t b)
{
#if defined(__ARM_ARCH_6M__) || defined(__AVR__)
    const int32_t a_high = a >> 16, b_high = b >> 16;
    const uint32_t a_low = (uint32_t)a & 0xFFFFu, b_low = (uint32_t)b & 0xFFFFu;
    const uint32_t low = a_low * b_low;
    const int32_t middle = a_high * (int32_t)b_low + (int32_t)(low >> 16); /* b_low < 2^16: no overflow */
    const int32_t other = b_high * (int32_t)a_low + (int32_t)((uint32_t)middle & 0xFFFFu);
    return a_high * b_high + (middle >> 16) + (other >> 16);
#else
    return (int32_t)(((int64_t)a * b) >> 32);
#endif
}

/* 1/z for z >= 1 as r * 2^(shift - 62), r in 2^30 .. 2^31 - 1, where shift = clz(z): the 16-bit reciprocal
 * and one Newton step, which squares its relative error of 2^-14.3 to 2^-28.6. */
static inline uint32_t recip_q31_of(uint32_t z, uint8_t *shift)
{
    const uint32_t guess_q31 = recip_q16(z, shift) << 15;
    const uint32_t product_q31 = (uint32_t)(((uint64_t)(z << *shift) * guess_q31) >> 31);
    const uint32_t recip_q31 = (uint32_t)(((uint64_t)guess_q31 * (0u - product_q31)) >> 31);

    return recip_q31 >> 31 ? 0x7FFFFFFFu : recip_q31;
}

/* num / den in Q31 for 0 <= num <= den, den >= 1. Never above 1. */
static inline uint32_t ratio_q31(uint32_t num, uint32_t den)
{
    uint8_t n;
    const uint32_t recip_q31 = recip_q31_of(den, &n);
    const uint64_t ratio = ((uint64_t)(num << n) * recip_q31) >> 31;

    return ratio > UINT32_C(1) << 31 ? UINT32_C(1) << 31 : (uint32_t)ratio;
}

/* a + (b - a) * t, rounded to nearest, for t in 0..1. b - a must fit 32 bits. */
static inline int32_t lerp_q31(int32_t a, int32_t b, uint32_t t_q31)
{
    return a + (int32_t)shift_round_s64((int64_t)(b - a) * (int64_t)t_q31, 31);
}

#endif
