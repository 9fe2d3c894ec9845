/* SPDX-License-Identifier: MIT
 *
 * What GCC makes much of on a Cortex-M0 and M0+, written in assembly: the same bits. Everybody else has the C, and so
 * has the prover where it reads that core's. */
#ifndef LIM_THUMB_H
#define LIM_THUMB_H

#include "config.h"

#if defined(__thumb__) && defined(__ARM_ARCH_6M__)

#define LIM_WRITTEN_THUMB 1

/* The lower half of a word: GCC takes two shifts. */
static inline uint32_t low_16_written(uint32_t x)
{
    uint32_t low;

    __asm__("uxth %0, %1" : "=l"(low) : "l"(x));
    return low;
}

#define LOW_16(x) low_16_written((uint32_t)(x))

/* mul_high_limbs_s32() in 17 instructions and five registers; GCC moves limbs to and fro. */
static inline int32_t mul_high_written_s32(int32_t a, int32_t b)
{
    int32_t a_high, b_high, part;

    __asm__(".syntax unified\n\t"
            "asrs %[a_high], %[a], #16\n\t"
            "uxth %[a], %[a]\n\t"
            "asrs %[b_high], %[b], #16\n\t"
            "uxth %[b], %[b]\n\t"
            "movs %[part], %[a]\n\t"
            "muls %[part], %[b]\n\t"
            "lsrs %[part], %[part], #16\n\t"
            "muls %[b], %[a_high]\n\t"
            "adds %[b], %[b], %[part]\n\t" /* middle */
            "muls %[a], %[b_high]\n\t"
            "uxth %[part], %[b]\n\t"
            "adds %[a], %[a], %[part]\n\t" /* other */
            "muls %[a_high], %[b_high]\n\t"
            "asrs %[a], %[a], #16\n\t"
            "asrs %[b], %[b], #16\n\t"
            "adds %[a], %[a], %[b]\n\t"
            "adds %[a], %[a], %[a_high]"
            : [a] "+l"(a), [b] "+l"(b), [a_high] "=&l"(a_high), [b_high] "=&l"(b_high), [part] "=&l"(part)
            :
            : "cc");
    return a;
}

#define MUL_HIGH_S32(a, b) mul_high_written_s32(a, b)

/* What is found from x on is not found from what x was made of. */
#define FOUND_FROM(x) __asm__("" : "+l"(x))

#else

#define LIM_WRITTEN_THUMB 0
#define LOW_16(x) ((x)&0xFFFF)
#define MUL_HIGH_S32(a, b) (LIM_LONG_MULTIPLY ? mul_high_long_s32(a, b) : mul_high_limbs_s32(a, b))
#define FOUND_FROM(x) ((void)0)

#endif

#endif
