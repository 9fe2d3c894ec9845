/* SPDX-License-Identifier: MIT
 *
 * Prints products and quotients of integers of all lengths, as the processor or the compiler's library computes them;
 * the same program runs on the host, and the texts must be equal. Divisors are never 0, and no quotient overflows. */
#include "console.h"

#include <stdint.h>

enum { PAIRS = 400 };

int main(void);

/* xorshift, of 64 bits: Marsaglia, "Xorshift RNGs". */
static uint64_t next_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    return *state ^= *state << 17;
}

static void put_number(uint64_t number)
{
    char digits[18];

    for (int8_t i = 15; i >= 0; i--, number >>= 4)
        digits[i] = "0123456789abcdef"[number & 15u];
    digits[16] = ' ';
    digits[17] = 0;
    console_put(digits);
}

static void put_long(uint64_t a, uint64_t by)
{
    const int64_t signed_a = (int64_t)a, signed_by = (int64_t)(by >> 1) + 1;

    put_number(a * by);
    put_number(a / by);
    put_number(a % by);
    put_number((uint64_t)(signed_a / signed_by));
    put_number((uint64_t)(signed_a / -signed_by));
}

static void put_short(uint32_t a, uint32_t by)
{
    const int32_t signed_a = (int32_t)a, signed_by = (int32_t)(by >> 1) + 1;

    put_number(a / by);
    put_number(a % by);
    put_number((uint32_t)(signed_a / signed_by));
    put_number((uint32_t)(signed_a % -signed_by));
    put_number((uint64_t)((int64_t)signed_a * signed_by));
}

int main(void)
{
    uint64_t state = UINT64_C(0x123456789abcdef);

    for (uint16_t i = 0; i < PAIRS; i++) {
        const uint64_t a = next_random(&state) >> i % 61, by = next_random(&state) >> i % 59 | 1u;
        put_long(a, by);
        put_short((uint32_t)a, (uint32_t)by | 1u);
        console_put("\n");
    }
    return 0;
}
