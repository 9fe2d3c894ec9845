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

static void note(struct rings *rings, size_t p, size_t q)
{
    bit_set(rings->hides + p * rings->words, q);
    bit_set(rings->hidden_by + q * rings->words, p);
}

void rings_find(struct rings *rings, const struct bsp *bsp)
{
    const size_t count = bsp->piece_count;
    make(rings, count);
    for (uint32_t p = 0; p < count && !deadline_passed(); p++)
        for (uint32_t q = p + 1; q < count; q++) {
            const struct cluster_pair pair = cluster_pair(bsp, p, q);
            if (pair.p_hides_q) note(rings, p, q);
            if (pair.q_hides_p) note(rings, q, p);
        }
}

/* A set under way, and which of its words are not 0: most sets are small. */
struct thinned {
    uint64_t *set;
    uint32_t *used;
    size_t used_count;
};

static void keep_used(struct thinned *thinned)
{
    size_t kept = 0;
    for (size_t i = 0; i < thinned->used_count; i++)
        if (thinned->set[thinned->used[i]]) thinned->used[kept++] = thinned->used[i];
    thinned->used_count = kept;
}

static bool meets(const uint64_t *row, const struct thinned *thinned)
{
    for (size_t i = 0; i < thinned->used_count; i++)
        if (row[thinned->used[i]] & thinned->set[thinned->used[i]]) return true;
    return false;
}

/* One pass over the set; false: nothing went. */
static bool thin_out(const struct rings *rings, struct thinned *thinned, size_t *left)
{
    bool went = false;
    *left = 0;
    for (size_t i = 0; i < thinned->used_count; i++) {
        const size_t word = thinned->used[i];
        for (uint64_t bits = thinned->set[word]; bits; bits &= bits - 1) {
            const size_t p = word * WORD_BITS + (size_t)__builtin_ctzll(bits);
            if (meets(rings->hides + p * rings->words, thinned) &&
                meets(rings->hidden_by + p * rings->words, thinned)) {
                ++*left;
                continue;
            }
            thinned->set[word] &= ~(bits & -bits);
            went = true;
        }
    }
    keep_used(thinned);
    return went;
}

size_t rings_left(const struct rings *rings, uint64_t *set)
{
    size_t left = 0;
    struct thinned thinned = {set, grow_zeroed(rings->words, sizeof *thinned.used), rings->words};
    for (size_t i = 0; i < rings->words; i++)
        thinned.used[i] = (uint32_t)i;
    keep_used(&thinned);
    while (thin_out(rings, &thinned, &left))
        continue;
    free(thinned.used);
    return left;
}

bool rings_hold(const struct rings *rings, const uint32_t *list, size_t count)
{
    uint64_t *whole = grow_zeroed(rings->words, sizeof *whole);
    for (size_t i = 0; i < count; i++)
        if (list[i] < rings->count) bit_set(whole, list[i]);
    const bool hold = rings_left(rings, whole) > 0;
    free(whole);
    return hold;
}

void rings_free(struct rings *rings)
{
    free(rings->hides);
    free(rings->hidden_by);
    *rings = (struct rings){0};
}
