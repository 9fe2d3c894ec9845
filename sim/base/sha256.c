/* SPDX-License-Identifier: MIT
 *
 * The constants are the first 32 bits of the fractions of the cube roots of the first 64 primes, and of the square
 * roots of the first 8: they are worked out in whole numbers, as the standard defines them. */
#include "base/sha256.h"

#include <stdbool.h>
#include <string.h>

enum { BLOCK_B = 64, ROUNDS = 64, WORDS = 8, LENGTH_B = 8 };

struct constants {
    uint32_t rounds[ROUNDS], start[WORDS];
};

static bool is_prime(unsigned n)
{
    for (unsigned by = 2; by * by <= n; by++)
        if (n % by == 0) return false;
    return true;
}

/* Of the root the 32 bits behind the point: the greatest r with (r / 2^32)^power <= n, found bit by bit. */
static uint32_t root_fraction(unsigned n, unsigned power)
{
    uint64_t root = 0;

    for (uint64_t bit = UINT64_C(1) << 36; bit; bit >>= 1) {
        const unsigned __int128 r = root | bit; /* below 2^37: its cube is below 2^111 */
        const unsigned __int128 most = (unsigned __int128)n << 32 * power;
        if ((power == 2 ? r * r : r * r * r) <= most) root |= bit;
    }
    return (uint32_t)root;
}

static void find_constants(struct constants *constants)
{
    for (unsigned n = 2, count = 0; count < ROUNDS; n++) {
        if (!is_prime(n)) continue;
        if (count < WORDS) constants->start[count] = root_fraction(n, 2);
        constants->rounds[count++] = root_fraction(n, 3);
    }
}

static uint32_t rotate(uint32_t word, unsigned by)
{
    return word >> by | word << (32 - by);
}

static void extend(uint32_t words[ROUNDS], const uint8_t block[BLOCK_B])
{
    for (int i = 0; i < 16; i++)
        words[i] = (uint32_t)block[4 * i] << 24 | (uint32_t)block[4 * i + 1] << 16 | (uint32_t)block[4 * i + 2] << 8 |
                   block[4 * i + 3];
    for (int i = 16; i < ROUNDS; i++) {
        const uint32_t a = words[i - 15], b = words[i - 2];
        words[i] = words[i - 16] + (rotate(a, 7) ^ rotate(a, 18) ^ a >> 3) + words[i - 7] +
                   (rotate(b, 17) ^ rotate(b, 19) ^ b >> 10);
    }
}

static void add_block(const struct constants *constants, uint32_t hash[WORDS], const uint8_t block[BLOCK_B])
{
    uint32_t words[ROUNDS], at[WORDS];

    extend(words, block);
    memcpy(at, hash, sizeof at);
    for (int i = 0; i < ROUNDS; i++) {
        const uint32_t a = at[0], e = at[4];
        const uint32_t one = at[7] + (rotate(e, 6) ^ rotate(e, 11) ^ rotate(e, 25)) + ((e & at[5]) ^ (~e & at[6])) +
                             constants->rounds[i] + words[i];
        const uint32_t two =
            (rotate(a, 2) ^ rotate(a, 13) ^ rotate(a, 22)) + ((a & at[1]) ^ (a & at[2]) ^ (at[1] & at[2]));
        memmove(at + 1, at, 7 * sizeof *at);
        at[4] += one;
        at[0] = one + two;
    }
    for (int i = 0; i < WORDS; i++)
        hash[i] += at[i];
}

/* A bit behind the last byte, zeros, the length in bits: one block, or two. */
static void add_end(const struct constants *constants, uint32_t hash[WORDS], const uint8_t *rest, size_t rest_b,
                    uint64_t n_b)
{
    uint8_t blocks[2 * BLOCK_B] = {0};
    const size_t end_b = rest_b + 1 + LENGTH_B > BLOCK_B ? 2 * BLOCK_B : BLOCK_B;

    if (rest_b) memcpy(blocks, rest, rest_b);
    blocks[rest_b] = 0x80;
    for (unsigned i = 0; i < LENGTH_B; i++)
        blocks[end_b - 1 - i] = (uint8_t)(n_b * 8 >> 8 * i);
    for (size_t at = 0; at < end_b; at += BLOCK_B)
        add_block(constants, hash, blocks + at);
}

void sha256(uint8_t digest[SHA256_B], const uint8_t *bytes, size_t n_b)
{
    struct constants constants;
    size_t at = 0;

    find_constants(&constants);
    for (; n_b - at >= BLOCK_B; at += BLOCK_B)
        add_block(&constants, constants.start, bytes + at);
    add_end(&constants, constants.start, bytes + at, n_b - at, n_b);
    for (unsigned i = 0; i < SHA256_B; i++)
        digest[i] = (uint8_t)(constants.start[i / 4] >> (24 - 8 * (i % 4)));
}
