/* SPDX-License-Identifier: MIT
 *
 * The tests' pseudo-random numbers: xorshift64*, seeded by the test, the same on every machine. */
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include <stdint.h>

struct random {
    uint64_t state; /* not 0 */
};

static inline uint64_t random_u64(struct random *random)
{
    random->state ^= random->state >> 12;
    random->state ^= random->state << 25;
    random->state ^= random->state >> 27;
    return random->state * UINT64_C(0x2545F4914F6CDD1D);
}

/* low .. high, both included. */
static inline int64_t random_in(struct random *random, int64_t low, int64_t high)
{
    return low + (int64_t)(random_u64(random) % (uint64_t)(high - low + 1));
}

/* 0 <= x < 1 */
static inline double random_unit(struct random *random)
{
    return (double)(random_u64(random) >> 11) / 9007199254740992.0;
}

#endif
