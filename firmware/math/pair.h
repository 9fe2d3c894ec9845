/* SPDX-License-Identifier: MIT
 *
 * Two numbers a word, both below 2^15, and what is asked of both at once: one instruction or two where the processor
 * compares halves, else by a flag in each half's top bit. */
#ifndef LIM_PAIR_H
#define LIM_PAIR_H

#include "math/thumb.h"

#if LIM_DUAL_MULTIPLY && defined(__arm__)

static inline uint32_t pair_max(uint32_t a, uint32_t b)
{
    uint32_t greater;

    __asm__("usub16 %0, %1, %2\n\tsel %0, %1, %2" : "=&r"(greater) : "r"(a), "r"(b) : "cc");
    return greater;
}

static inline uint32_t pair_min(uint32_t a, uint32_t b)
{
    uint32_t less;

    __asm__("usub16 %0, %1, %2\n\tsel %0, %2, %1" : "=&r"(less) : "r"(a), "r"(b) : "cc");
    return less;
}

/* a - b, or 0 where that is less. */
static inline uint32_t pair_beyond(uint32_t a, uint32_t b)
{
    uint32_t beyond;

    __asm__("uqsub16 %0, %1, %2" : "=r"(beyond) : "r"(a), "r"(b));
    return beyond;
}

/* Whether a is at most b and c at most d, in both halves. */
static inline bool pair_are_most(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    return !(pair_beyond(a, b) | pair_beyond(c, d));
}

/* The high halves of two words. */
static inline uint32_t pair_of_highs(uint32_t low, uint32_t high)
{
    uint32_t pair;

    __asm__("pkhtb %0, %1, %2, asr #16" : "=r"(pair) : "r"(high), "r"(low));
    return pair;
}

/* The low halves of two words. */
static inline uint32_t pair_of_lows(uint32_t low, uint32_t high)
{
    uint32_t pair;

    __asm__("pkhbt %0, %1, %2, lsl #16" : "=r"(pair) : "r"(low), "r"(high));
    return pair;
}

#else

/* All bits of the halves in which a is at least b. */
static inline uint32_t pair_is_least(uint32_t a, uint32_t b)
{
    const uint32_t flags = ((a | 0x80008000u) - b) & 0x80008000u;

    return flags | (flags - (flags >> 15));
}

static inline uint32_t pair_max(uint32_t a, uint32_t b)
{
    return b ^ ((a ^ b) & pair_is_least(a, b));
}

static inline uint32_t pair_min(uint32_t a, uint32_t b)
{
    return a ^ ((a ^ b) & pair_is_least(a, b));
}

/* a - b, or 0 where that is less. */
static inline uint32_t pair_beyond(uint32_t a, uint32_t b)
{
    return pair_max(a, b) - b;
}

/* Whether a is at most b and c at most d, in both halves. */
static inline bool pair_are_most(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    const uint32_t flags = 0x80008000u;

    return (((b | flags) - a) & ((d | flags) - c) & flags) == flags;
}

/* The low halves of two words. */
static inline uint32_t pair_of_lows(uint32_t low, uint32_t high)
{
    return LOW_16(low) | high << 16;
}

/* The high halves of two words. */
static inline uint32_t pair_of_highs(uint32_t low, uint32_t high)
{
    return low >> 16 | (high & 0xFFFF0000);
}

#endif

static inline uint32_t pair_of(uint32_t low, uint32_t high)
{
    return low | high << 16;
}

static inline uint32_t pair_of_both(uint32_t number)
{
    return number * 0x10001u;
}

static inline uint32_t pair_low(uint32_t pair)
{
    return LOW_16(pair);
}

static inline uint32_t pair_high(uint32_t pair)
{
    return pair >> 16;
}

static inline uint32_t pair_sum(uint32_t pair)
{
    return pair_low(pair) + pair_high(pair);
}

#endif
