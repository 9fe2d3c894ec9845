/* SPDX-License-Identifier: MIT
 *
 * What gcc calls where the LX106 has no instruction, and Debian's libgcc for it does not have: products of 64 bits, and
 * divisions. Other builds of gcc for the ESP8266 have them, and so has the chip's ROM. The core multiplies 32 x 32 ->
 * 32 bits (mull) and counts leading zeros (nsau). Names and meanings: "GCC Internals", 4.1 (libgcc's integer routines).
 */
#include <stdint.h>

int64_t __muldi3(int64_t a, int64_t b);
uint32_t __udivsi3(uint32_t a, uint32_t by);
uint32_t __umodsi3(uint32_t a, uint32_t by);
int32_t __divsi3(int32_t a, int32_t by);
uint64_t __udivdi3(uint64_t a, uint64_t by);
uint64_t __umoddi3(uint64_t a, uint64_t by);
int64_t __divdi3(int64_t a, int64_t by);

struct divided_32 {
    uint32_t quotient, rest;
};

struct divided_64 {
    uint64_t quotient, rest;
};

/* In limbs of 16 bits; of the upper words' products the low halves alone are in range. */
static uint64_t product(uint32_t a, uint32_t b)
{
    const uint32_t a_low = a & 0xFFFFu, a_high = a >> 16, b_low = b & 0xFFFFu, b_high = b >> 16;
    const uint32_t low = a_low * b_low, cross = a_high * b_low + (low >> 16);
    const uint32_t middle = a_low * b_high + (cross & 0xFFFFu);

    return (uint64_t)(a_high * b_high + (cross >> 16) + (middle >> 16)) << 32 | (middle << 16 | (low & 0xFFFFu));
}

int64_t __muldi3(int64_t a, int64_t b)
{
    const uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    const uint32_t a_high = (uint32_t)((uint64_t)a >> 32), b_high = (uint32_t)((uint64_t)b >> 32);

    return (int64_t)(product(a_low, b_low) + ((uint64_t)(a_high * b_low + a_low * b_high) << 32));
}

/* A step for each bit of the quotient. By 0: all ones. */
static struct divided_32 divided(uint32_t a, uint32_t by)
{
    struct divided_32 out = {by ? 0 : UINT32_MAX, a};

    if (!by || a < by) return out;
    int shift = __builtin_clz(by) - __builtin_clz(a);
    for (by <<= shift; shift >= 0; shift--, by >>= 1) {
        out.quotient <<= 1;
        if (out.rest < by) continue;
        out.rest -= by;
        out.quotient |= 1;
    }
    return out;
}

uint32_t __udivsi3(uint32_t a, uint32_t by)
{
    return divided(a, by).quotient;
}

uint32_t __umodsi3(uint32_t a, uint32_t by)
{
    return divided(a, by).rest;
}

static uint32_t magnitude_32(int32_t a)
{
    return a < 0 ? 0 - (uint32_t)a : (uint32_t)a;
}

int32_t __divsi3(int32_t a, int32_t by)
{
    const uint32_t quotient = divided(magnitude_32(a), magnitude_32(by)).quotient;

    return (int32_t)((a ^ by) < 0 ? 0 - quotient : quotient);
}

static struct divided_64 divided_long(uint64_t a, uint64_t by)
{
    struct divided_64 out = {by ? 0 : UINT64_MAX, a};

    if (!by || a < by) return out;
    int shift = __builtin_clzll(by) - __builtin_clzll(a);
    for (by <<= shift; shift >= 0; shift--, by >>= 1) {
        out.quotient <<= 1;
        if (out.rest < by) continue;
        out.rest -= by;
        out.quotient |= 1;
    }
    return out;
}

uint64_t __udivdi3(uint64_t a, uint64_t by)
{
    return divided_long(a, by).quotient;
}

uint64_t __umoddi3(uint64_t a, uint64_t by)
{
    return divided_long(a, by).rest;
}

static uint64_t magnitude_64(int64_t a)
{
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

int64_t __divdi3(int64_t a, int64_t by)
{
    const uint64_t quotient = divided_long(magnitude_64(a), magnitude_64(by)).quotient;

    return (int64_t)((a ^ by) < 0 ? 0 - quotient : quotient);
}
