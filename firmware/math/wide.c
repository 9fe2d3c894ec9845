/* SPDX-License-Identifier: MIT
 *
 * Where both products fit 64 bits, which they mostly do, they are compared there. */
#include "math/wide.h"

struct wide {
    uint64_t high, low;
};

static bool fits_u32(uint64_t x)
{
    return !(x >> 32);
}

/* In limbs of 32 bits: the middle sum is at most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1. */
static struct wide wide_product(uint64_t a, uint64_t b)
{
    const uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    const uint64_t low = a0 * b0, cross = a1 * b0 + (low >> 32);
    const uint64_t middle = a0 * b1 + (uint32_t)cross;

    return (struct wide){a1 * b1 + (cross >> 32) + (middle >> 32), middle << 32 | (uint32_t)low};
}

static int32_t order_of_u64(uint64_t a, uint64_t b)
{
    return (a > b) - (a < b);
}

int32_t lim_wide_compare(uint64_t a, uint64_t b, uint64_t c, uint64_t d)
{
    if (fits_u32(a | b | c | d)) return order_of_u64(a * b, c * d);
    const struct wide left = wide_product(a, b), right = wide_product(c, d);

    return left.high != right.high ? order_of_u64(left.high, right.high) : order_of_u64(left.low, right.low);
}

int32_t lim_wide_sign(int64_t x, uint64_t m, int64_t y, uint64_t n)
{
    if (x >= 0 && y >= 0) return (x && m) || (y && n);
    if (x <= 0 && y <= 0) return -((x && m) || (y && n));
    if (x > 0) return lim_wide_compare((uint64_t)x, m, 0 - (uint64_t)y, n);
    return lim_wide_compare((uint64_t)y, n, 0 - (uint64_t)x, m);
}
