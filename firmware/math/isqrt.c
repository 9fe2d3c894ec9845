/* SPDX-License-Identifier: MIT
 *
 * The digits of a root, two bits of its square at a time. */
#include "math/isqrt.h"

uint32_t lim_isqrt(uint64_t x)
{
    uint64_t root = 0;

    for (uint64_t bit = UINT64_C(1) << 62; bit; bit >>= 2) {
        const uint64_t with = root + bit;
        root >>= 1;
        if (x < with) continue;
        x -= with;
        root += bit;
    }
    return (uint32_t)root;
}
