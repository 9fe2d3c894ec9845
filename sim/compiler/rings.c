/* SPDX-License-Identifier: MIT
 *
 * Polygons that none left can hide, and those that can hide none left, are in no ring; so are, without these, others.
 * What remains when nothing more can go is in rings or between two. */
#include "compiler/rings.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "compiler/bsp.h"
#include "compiler/cluster.h"

#include <stdlib.h>
#include <string.h>

enum { WORD_BITS = 64 };

static void bit_set(uint64_t *row, size_t at)
{
    row[at / WORD_BITS] |= UINT64_C(1) << at % WORD_BITS;
}

/* Room for a relation of so many polygons, in which none hides another. */
static void make(struct rings *rings, size_t count)
{
    const size_t words = (count + WORD_BITS - 1) / WORD_BITS;
    *rings = (struct rings){grow_zeroed(count * words, sizeof *rings->hides),
                            grow_zeroed(count * words, sizeof *rings->hidden_by), words, count};
}

void rings_find(struct rings *rings, const struct bsp *bsp)
{
    const size_t count = bsp->piece_count;
    make(rings, count);
    const size_t words = rings->words;
    for (uint32_t p = 0; p < count && !deadline_passed(); p++)
        for (uint32_t q = 0; q < count; q++) {
            if (p == q || !cluster_hides(bsp, p, q)) continue;
            bit_set(rings->hides + p * words, q);
            bit_set(rings->hidden_by + q * words, p);
        }
}

static bool meets(const uint64_t *a, const uint64_t *b, size_t words)
{
    for (size_t i = 0; i < words; i++)
        if (a[i] & b[i]) return true;
    return false;
}

/* One pass over the set; false: nothing went. */
static bool thin_out(const struct rings *rings, uint64_t *set, size_t *left)
{
    bool went = false;
    *left = 0;
    for (size_t i = 0; i < rings->words; i++)
        for (uint64_t bits = set[i]; bits; bits &= bits - 1) {
            const size_t p = i * WORD_BITS + (size_t)__builtin_ctzll(bits);
            if (meets(rings->hides + p * rings->words, set, rings->words) &&
                meets(rings->hidden_by + p * rings->words, set, rings->words)) {
                ++*left;
                continue;
            }
            set[i] &= ~(bits & -bits);
            went = true;
        }
    return went;
}

size_t rings_left(const struct rings *rings, uint64_t *set)
{
    size_t left = 0;
    while (thin_out(rings, set, &left))
        continue;
    return left;
}

void rings_free(struct rings *rings)
{
    free(rings->hides);
    free(rings->hidden_by);
    *rings = (struct rings){0};
}
