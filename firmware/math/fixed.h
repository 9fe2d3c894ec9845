/* SPDX-License-Identifier: MIT
 *
 * Fixed-point helpers. A name's suffix is its format: x_q16 has 16 fraction bits. Right shifts of
 * negative numbers are arithmetic (floor) on every compiler that this project supports; left
 * shifts of negative numbers are never written.
 * `make prove` proves the contracts (ACSL); what they admit, `make exhaustive` tries for all 2^32 arguments. */
#ifndef LIM_FIXED_H
#define LIM_FIXED_H

#include "math/thumb.h"

LIM_STATIC_ASSERT((-3 >> 1) == -2, "right shifts must be arithmetic");

/* Whether there is an instruction that counts leading zeros. */
#if defined(__ARM_ARCH_6M__) || defined(__AVR__) || (defined(__riscv) && !defined(__riscv_zbb))
#define LIM_HAS_CLZ 0
#else
#define LIM_HAS_CLZ 1
#endif

#if LIM_DUAL_MULTIPLY
typedef uint32_t __attribute__((may_alias, aligned(2))) fixed_pair; /* in arrays and structs of int16_t */

/* a[0] b[0] + a[1] b[1] + sum, which may wrap. */
static inline uint32_t fixed_dot_pairs(const int16_t *a, const int16_t *b, uint32_t sum)
{
    return (uint32_t)__builtin_arm_smlad((int32_t) * (const fixed_pair *)a, (int32_t) * (const fixed_pair *)b,
                                         (int32_t)sum);
}

/* a[0] b[1] - a[1] b[0]. */
static inline int32_t fixed_cross_of_pairs(uint32_t a, uint32_t b)
{
    return __builtin_arm_smusdx((int32_t)a, (int32_t)b);
}

/* floor(a b / 2^16) + sum, b of 16 bits. */
static inline int32_t fixed_add_product(int32_t a, int32_t b, int32_t sum)
{
    return __builtin_arm_smlawb(a, b, sum);
}
#else
static inline int32_t fixed_add_product(int32_t a, int32_t b, int32_t sum)
{
    sum += b * (a >> 16);
    return sum + (b * (int32_t)(uint16_t)a >> 16);
}
#endif

/* round(2^24 / (256 + i)), entry 0 clipped to 65535. */
extern const LIM_FLASH uint16_t lim_recip_table_q16[257];

/* What recip_q24() makes of the table and a mantissa, 2^31 .. 2^32 - 1, from two divisions: the same bits. */
/*@ requires 2147483648 <= mantissa_q31;
    assigns \nothing; */
uint32_t lim_recip_divided_q24(uint32_t mantissa_q31);

/* The prover multiplies no inequality unless it is told to. */
/*@ ghost
    /@ requires a <= b && 0 <= by;
       assigns \nothing;
       ensures a * by <= b * by; @/
    static inline void scale(int64_t a, int64_t b, int64_t by) {} */

/*@ predicate is_clz(integer x, integer n) =
      0 <= n <= 31 && 2147483648 <= x * (1 << n) <= 4294967295 && (x >= 32768 ==> n <= 16) &&
      (x < 2147483648 ==> n >= 1) && (x < 1073741824 ==> n >= 2); */

#if !LIM_HAS_CLZ
/* The last steps of a search that has come to within 4 bits: n of them are behind it. */
static inline uint32_t normalise_last_4(uint32_t x, uint32_t n, uint8_t *zeros)
{
    if (!(x >> 30)) {
        n += 2;
        x <<= 2;
    }
    if (!(x >> 31)) {
        n++;
        x <<= 1;
    }
    *zeros = (uint8_t)n;
    return x;
}
#endif

/* x, which must not be 0, shifted left until its highest bit is set; *zeros says how far. */
/*@ requires x >= 1 && \valid(zeros);
    assigns *zeros;
    ensures is_clz(x, *zeros) && \result == x * (1 << *zeros); */
static inline uint32_t normalise_u32(uint32_t x, uint8_t *zeros)
{
#if LIM_HAS_CLZ
    *zeros = (uint8_t)__builtin_clz(x);
    return x * (UINT32_C(1) << *zeros);
#else
    uint32_t n = 0; /* halve the search five times, or, as is the rule, twice */
    if (!(x >> 28)) {
        if (!(x >> 16)) {
            n = 16;
            x <<= 16;
        }
        if (!(x >> 24)) {
            n += 8;
            x <<= 8;
        }
        if (!(x >> 28)) {
            n += 4;
            x <<= 4;
        }
    }
    return normalise_last_4(x, n, zeros);
#endif
}

/* The same for x < 2^12: large ones are the rule, and few steps to them. */
/*@ requires 1 <= x < 4096 && \valid(zeros);
    assigns *zeros;
    ensures is_clz(x, *zeros) && \result == x * (1 << *zeros) && 2147483648 <= \result; */
static inline uint32_t normalise_u12(uint32_t x, uint8_t *zeros)
{
#if LIM_HAS_CLZ
    return normalise_u32(x, zeros);
#else
    uint32_t n = 20;

    for (x <<= 20; !(x >> 28); x <<= 4)
        n += 4;
    return normalise_last_4(x, n, zeros);
#endif
}

/* Leading zeros of x, which must not be 0. */
/*@ requires x >= 1;
    assigns \nothing;
    ensures is_clz(x, \result); */
static inline uint8_t clz_u32(uint32_t x)
{
    uint8_t zeros;

    (void)normalise_u32(x, &zeros);
    return zeros;
}

/*@ assigns \nothing;
    ensures \result == (x < 0 ? -x : x); */
static inline uint32_t abs_s32(int32_t x)
{
    return x < 0 ? (uint32_t) - (x + 1) + 1 : (uint32_t)x;
}

#if LIM_8_BIT

/* floor(x / 2^count), count 0..31: whole bytes first, because a shift by bits is a loop over them. The compiler would
 * make one of two shifts, if it knew what is between them. */
static inline int32_t shift_s32(int32_t x, uint32_t count)
{
    const uint8_t bits = (uint8_t)count;
    int32_t bytes = bits >= 24 ? x >> 24 : bits >= 16 ? x >> 16 : bits >= 8 ? x >> 8 : x;

    __asm__("" : "+r"(bytes));
    return bytes >> (bits & 7);
}

/* x / 2^bits rounded to nearest, ties up; bits 1..30, |x| + 2^(bits - 1) < 2^31. */
static inline int32_t shift_round_s32(int32_t x, uint32_t bits)
{
    return (shift_s32(x, bits - 1) + 1) >> 1;
}

/* The highest bit of a mantissa is 1: the eight bits that follow, and the next eight. */
static inline uint8_t mantissa_first_8(uint32_t mantissa_q31)
{
    return (uint8_t)((uint16_t)(mantissa_q31 >> 16) << 1 >> 8);
}

static inline uint8_t mantissa_next_8(uint32_t mantissa_q31)
{
    return (uint8_t)((uint16_t)(mantissa_q31 >> 8) << 1 >> 8);
}

#else

#define shift_s32(x, count) ((x) >> (count)) /* no function: the prover sees the shift itself */

/* x / 2^bits rounded to nearest, ties up; bits 1..30, |x| + 2^(bits - 1) < 2^31. */
/*@ requires 1 <= bits <= 30 && x + (1 << (bits - 1)) <= 2147483647;
    assigns \nothing;
    ensures \result == (x + (1 << (bits - 1))) >> bits; */
static inline int32_t shift_round_s32(int32_t x, uint32_t bits)
{
    return (x + ((int32_t)1 << (bits - 1))) >> bits;
}

#endif

/* The same for 64 bits; bits 1..62. */
/*@ requires 1 <= bits <= 62 && x + (1 << (bits - 1)) <= 9223372036854775807;
    assigns \nothing;
    ensures \result == (x + (1 << (bits - 1))) >> bits; */
static inline int64_t shift_round_s64(int64_t x, uint8_t bits)
{
    return (x + ((int64_t)1 << (bits - 1))) >> bits;
}

/* The larger of a, which is not negative, and |b|, at most 2^62. */
/*@ requires 0 <= a <= 4611686018427387904 && -4611686018427387904 <= b <= 4611686018427387904;
    assigns \nothing;
    ensures a <= \result <= 4611686018427387904 && -\result <= b <= \result; */
static inline int64_t larger_s64(int64_t a, int64_t b)
{
    const int64_t size = b < 0 ? -b : b;

    return size > a ? size : a;
}

/* Halves all four, rounding down, until each is in -end .. end - 1: what matters of them is how they relate.
 * |v| <= 2^62. */
/*@ requires \valid(v + (0 .. 3)) && 1 <= end;
    requires -4611686018427387904 <= v[0] <= 4611686018427387904 && -4611686018427387904 <= v[1] <= 4611686018427387904;
    requires -4611686018427387904 <= v[2] <= 4611686018427387904 && -4611686018427387904 <= v[3] <= 4611686018427387904;
    assigns v[0 .. 3];
    ensures -end <= v[0] < end && -end <= v[1] < end && -end <= v[2] < end && -end <= v[3] < end; */
static inline void shorten_s64(int64_t v[4], int64_t end)
{
    int64_t largest = larger_s64(larger_s64(larger_s64(larger_s64(0, v[0]), v[1]), v[2]), v[3]);

    /*@ loop invariant 0 <= largest <= 4611686018427387904;
        loop invariant -largest - 1 <= v[0] <= largest && -largest - 1 <= v[1] <= largest;
        loop invariant -largest - 1 <= v[2] <= largest && -largest - 1 <= v[3] <= largest;
        loop assigns largest, v[0 .. 3];
        loop variant largest; */
    for (; largest >= end; largest >>= 1) {
        v[0] >>= 1;
        v[1] >>= 1;
        v[2] >>= 1;
        v[3] >>= 1;
    }
}

/*@ requires -1073741824 <= b_q30 <= 1073741824;
    assigns \nothing;
    ensures 0 <= a_q30 ==> -a_q30 <= \result <= a_q30;
    ensures a_q30 <= 0 ==> a_q30 <= \result <= -a_q30;
    ensures 0 <= b_q30 && 0 <= a_q30 ==> 0 <= \result;
    ensures 0 <= b_q30 && a_q30 <= 0 ==> \result <= 0; */
int32_t lim_mul_q30(int32_t a_q30, int32_t b_q30);

#if LIM_8_BIT
/* a / b, which is below 2^9, and the rest, in the upper half, in a quarter of the time of other divisions. */
uint32_t lim_divide_u9(uint32_t a, uint16_t b);
#endif

/*@ predicate is_recip_q24(integer r, integer mantissa) =
      8388608 <= r <= 16776960 && -410 * mantissa <= r * mantissa - 36028797018963968 <= 410 * mantissa; */

/* 1/z for z >= 1 as r * 2^(shift - 55), r in 2^23 .. 2^24, where shift = clz(z), from z's mantissa: linear
 * interpolation between the table's entries, or what is divided in their place (LIM_RECIP_TABLE, config.h). */
/*@ requires 2147483648 <= mantissa_q31;
    assigns \nothing;
    admit ensures is_recip_q24(\result, mantissa_q31); */
static inline uint32_t recip_mantissa_q24(uint32_t mantissa_q31)
{
    if (!LIM_RECIP_TABLE) return lim_recip_divided_q24(mantissa_q31);
#if LIM_8_BIT
    const LIM_FLASH uint16_t *entry_q16 = &lim_recip_table_q16[mantissa_first_8(mantissa_q31)];
    const uint8_t fraction_q8 = mantissa_next_8(mantissa_q31);
#else
    const LIM_FLASH uint16_t *entry_q16 = &lim_recip_table_q16[mantissa_q31 << 1 >> 24];
    const uint32_t fraction_q8 = mantissa_q31 << 9 >> 24;
#endif
    const uint32_t left_q16 = entry_q16[0], fall_q16 = left_q16 - entry_q16[1];

    return (left_q16 << 8) - fall_q16 * fraction_q8;
}

/*@ requires z >= 1 && \valid(shift) && \separated(shift, lim_recip_table_q16 + (0 .. 256));
    assigns *shift;
    ensures is_clz(z, *shift);
    ensures is_recip_q24(\result, z * (1 << *shift)); */
static inline uint32_t recip_q24(uint32_t z, uint8_t *shift)
{
    const uint32_t mantissa_q31 = normalise_u32(z, shift);

    return recip_mantissa_q24(mantissa_q31);
}

/* The same as r * 2^(shift - 47), r in 2^15 .. 2^16 - 1. Within 1.6 units of r's last place over all 2^32
 * inputs. */
/*@ requires z >= 1 && \valid(shift) && \separated(shift, lim_recip_table_q16 + (0 .. 256));
    assigns *shift;
    ensures is_clz(z, *shift);
    ensures 32768 <= \result <= 65535; */
static inline uint32_t recip_q16(uint32_t z, uint8_t *shift)
{
    return recip_q24(z, shift) >> 8;
}

/* And as r * 2^(shift - 46), r in 2^14 .. 2^15, rounded to nearest. */
/*@ requires z >= 1 && \valid(shift) && \separated(shift, lim_recip_table_q16 + (0 .. 256));
    assigns *shift;
    ensures is_clz(z, *shift);
    ensures 16384 <= \result <= 32768;
    ensures \result * (z * (1 << *shift)) <= 70368744177664 + 8589934592; */
static inline uint32_t recip_q15_of(uint32_t z, uint8_t *shift)
{
    const uint32_t r_q24 = recip_q24(z, shift);

    //@ ghost scale(((r_q24 + 256) >> 9) * 512, (int64_t)r_q24 + 256, z * ((int64_t)1 << *shift));
    return LIM_8_BIT ? (uint32_t)shift_s32((int32_t)r_q24 + 256, 9) : (r_q24 + 256) >> 9;
}

/* The high half of a product, floor(a b / 2^32): the same bits in three forms. */
/*@ assigns \nothing;
    ensures \result == (a * b) >> 32; */
static inline int32_t mul_high_long_s32(int32_t a, int32_t b)
{
    return (int32_t)(((int64_t)a * b) >> 32);
}

/* From 16-bit limbs: |high| <= 2^15 and 0 <= low < 2^16, so no sum leaves 32 bits. */
/*@ assigns \nothing;
    ensures \result == (a * b) >> 32; */
static inline int32_t mul_high_limbs_s32(int32_t a, int32_t b)
{
    const int32_t a_high = a >> 16, b_high = b >> 16;
    const uint32_t a_low = (uint32_t)LOW_16(a), b_low = (uint32_t)LOW_16(b);
    //@ assert a == a_high * 65536 + a_low && 0 <= a_low <= 65535 && -32768 <= a_high <= 32767;
    //@ assert b == b_high * 65536 + b_low && 0 <= b_low <= 65535 && -32768 <= b_high <= 32767;
    const uint32_t low = a_low * b_low;
    const int32_t middle = a_high * (int32_t)b_low + (int32_t)(low >> 16);
    //@ assert -2147450880 <= b_high * (int32_t)a_low <= 2147385345;
    const int32_t other = b_high * (int32_t)a_low + (int32_t)LOW_16(middle);
    //@ assert -1073709056 <= a_high * b_high <= 1073741824;
    //@ assert parts: a * b == a_high * b_high * 4294967296 + (a_high * b_low + b_high * a_low) * 65536 + low;
    return a_high * b_high + (middle >> 16) + (other >> 16);
}

/*@ assigns \nothing;
    ensures \result == (a * b) >> 32; */
static inline int32_t mul_high_s32(int32_t a, int32_t b)
{
    return MUL_HIGH_S32(a, b);
}

/* floor(a b / 2^32) for a positive b of which only the upper 16 bits are set: with limbs, two products. */
/*@ requires 0 <= b && b % 65536 == 0;
    assigns \nothing;
    ensures \result == (a * b) >> 32; */
static inline int32_t mul_s32_top(int32_t a, int32_t b)
{
    if (LIM_LONG_MULTIPLY) return mul_high_long_s32(a, b);
    const uint32_t top = (uint32_t)b >> 16;
    //@ assert b == top * 65536 && a == (a >> 16) * 65536 + (a & 0xFFFF);
    //@ assert a * b == (a >> 16) * top * 4294967296 + (a & 0xFFFF) * top * 65536;
    //@ assert -1073741824 <= (a >> 16) * top <= 1073741824 && 0 <= (a & 0xFFFF) * top <= 2147450880;

    return (a >> 16) * (int32_t)top + (int32_t)(((uint32_t)LOW_16(a) * top) >> 16);
}

/* The same without signs. */
/*@ requires b % 65536 == 0;
    assigns \nothing;
    ensures !LIM_LONG_MULTIPLY ==> \result == (a * b) >> 32; */
static inline uint32_t mul_u32_top(uint32_t a, uint32_t b)
{
    if (LIM_LONG_MULTIPLY) return (uint32_t)(((uint64_t)a * b) >> 32);
    const uint32_t top = b >> 16;
    //@ assert b == top * 65536 && a == (a >> 16) * 65536 + (a & 0xFFFF);
    //@ assert a * b == (a >> 16) * top * 4294967296 + (a & 0xFFFF) * top * 65536;
    //@ assert 0 <= (a >> 16) * top <= 4294836225 && 0 <= (a & 0xFFFF) * top <= 4294836225;

    return (a >> 16) * top + ((LOW_16(a) * top) >> 16);
}

/*@ predicate is_recip_q31(integer r, integer mantissa) =
      1073741824 <= r <= 2147483647 && r * mantissa <= 4611686018427387904 + 3 * mantissa; */

/* 1/z for z >= 1 as r * 2^(shift - 62), r in 2^30 .. 2^31 - 1, where shift = clz(z): the 16-bit reciprocal
 * and one Newton step, which squares its relative error of 2^-14.3 to 2^-28.6, and never ends above 1/z
 * by more than its rounding: within 3 units of r's last place over all 2^32 inputs. */
/*@ requires z >= 1 && \valid(shift) && \separated(shift, lim_recip_table_q16 + (0 .. 256));
    assigns *shift;
    ensures is_clz(z, *shift);
    admit ensures is_recip_q31(\result, z * (1 << *shift)); */
static inline uint32_t recip_q31_of(uint32_t z, uint8_t *shift)
{
    const uint32_t guess_q32 = recip_q16(z, shift) * 65536;

    return mul_u32_top(0u - mul_u32_top(z * (UINT32_C(1) << *shift), guess_q32), guess_q32);
}

/* num / den in Q31 for 0 <= num <= den, den >= 1. Never above 1. */
/*@ requires 0 <= num <= den && den >= 1;
    assigns \nothing;
    ensures \result <= 2147483648; */
static inline uint32_t ratio_q31(uint32_t num, uint32_t den)
{
    uint8_t n;
    const uint32_t recip_q31 = recip_q31_of(den, &n);
    const uint32_t ratio_q31 = (uint32_t)(((uint64_t)(num * (UINT32_C(1) << n)) * recip_q31) >> 31);

    return ratio_q31 > UINT32_C(1) << 31 ? UINT32_C(1) << 31 : ratio_q31;
}

/* a + (b - a) * t, rounded to nearest, for t in 0..1. */
/*@ requires t_q31 <= 2147483648;
    assigns \nothing; */
static inline int32_t lerp_q31(int32_t a, int32_t b, uint32_t t_q31)
{
#if !LIM_LONG_MULTIPLY
    const int32_t way = (int32_t)((uint32_t)b - (uint32_t)a);
    if (t_q31 <= INT32_MAX && ((b ^ a) & (b ^ way)) >= 0) {
        const uint32_t low_q31 = (uint32_t)way * t_q31, high_qm1 = (uint32_t)mul_high_limbs_s32(way, (int32_t)t_q31);
        return (int32_t)((uint32_t)a + (high_qm1 << 1) + (low_q31 >> 31) + (low_q31 >> 30 & 1));
    }
#endif
    const int64_t way_q31 = ((int64_t)b - a) * t_q31;

    return (int32_t)(a + shift_round_s64(way_q31, 31));
}

/* x, y, z in turns. */
/*@ assigns \nothing;
    ensures \result == (axis < 2 ? axis + 1 : 0); */
static inline uint_fast8_t lim_axis_after(uint_fast8_t axis)
{
    return (uint_fast8_t)(axis < 2 ? axis + 1 : 0);
}

#endif
