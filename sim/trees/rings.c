/* SPDX-License-Identifier: MIT
 *
 * Polygons that none left can hide, and those that can hide none left, are in no ring; so are, without these, others.
 * What remains when nothing more can go is in rings or between two. Each polygon left has two witnesses: one left that
 * it hides, and one that hides it. Only when a witness goes another is looked for, from there on along the row, since
 * none comes back: so each row is gone through once. Asked first is a witness that is near in space, for that one is
 * mostly in the same part of a set that is divided. */
#include "trees/rings.h"

#include "base/grow.h"
#include "trees/bsp.h"

#include <stdlib.h>

enum { WORD_BITS = 64 };

void rings_find(struct rings *rings, const struct bsp *bsp, const uint32_t *list, size_t count)
{
    hiding_find(&rings->hiding, bsp, list, count);
    const size_t polygons = rings->hiding.count;
    for (int i = 0; i < 2; i++) {
        rings->sides[i].near = grow_zeroed(polygons, sizeof(uint32_t));
        for (size_t p = 0; p < polygons; p++)
            rings->sides[i].near[p] = HIDING_NONE;
        rings->sides[i].witness_at = grow_zeroed(polygons, sizeof(uint32_t));
        rings->sides[i].first = grow_zeroed(polygons, sizeof(uint32_t));
        rings->sides[i].next = grow_zeroed(polygons, sizeof(uint32_t));
    }
    rings->used = grow_zeroed(rings->hiding.words, sizeof *rings->used);
    rings->gone = grow_zeroed(polygons, sizeof *rings->gone);
}

void rings_free(struct rings *rings)
{
    hiding_free(&rings->hiding);
    for (int i = 0; i < 2; i++) {
        free(rings->sides[i].near);
        free(rings->sides[i].witness_at);
        free(rings->sides[i].first);
        free(rings->sides[i].next);
    }
    free(rings->used);
    free(rings->gone);
    *rings = (struct rings){0};
}

/* A set under way: which of its words had polygons, and those taken out whose dependents wait. */
struct thinned {
    struct rings *rings;
    uint64_t *set;
    size_t used_count, gone_count;
};

static bool is_in(const struct thinned *thinned, uint32_t p)
{
    return thinned->set[p / WORD_BITS] >> p % WORD_BITS & 1;
}

static void take_out(struct thinned *thinned, uint32_t p)
{
    thinned->set[p / WORD_BITS] &= ~(UINT64_C(1) << p % WORD_BITS);
    thinned->rings->gone[thinned->gone_count++] = p;
}

/* Has p be asked again when its witness goes. */
static void wait_for(const struct rings_side *side, uint32_t p, size_t witness)
{
    side->next[p] = side->first[witness];
    side->first[witness] = p;
}

/* What p can hide (side 0), or what can hide p. */
static const uint64_t *row_of(const struct rings *rings, int side, uint32_t p)
{
    return (side ? rings->hiding.hidden_by : rings->hiding.hides) + p * rings->hiding.words;
}

/* The next that is left and in the row. False: there is none. */
static bool find_witness(const struct thinned *thinned, int side_at, uint32_t p)
{
    const struct rings *rings = thinned->rings;
    const struct rings_side *side = &rings->sides[side_at];
    const uint64_t *row = row_of(rings, side_at, p);
    for (size_t i = side->witness_at[p]; i < thinned->used_count; i++) {
        const size_t word = rings->used[i];
        const uint64_t met = row[word] & thinned->set[word];
        if (!met) continue;
        side->witness_at[p] = (uint32_t)i;
        wait_for(side, p, word * WORD_BITS + (size_t)__builtin_ctzll(met));
        return true;
    }
    return false;
}

static bool find_first_witness(const struct thinned *thinned, int side_at, uint32_t p)
{
    const struct rings_side *side = &thinned->rings->sides[side_at];
    const uint32_t near = side->near[p];
    if (near == HIDING_NONE || !is_in(thinned, near)) return find_witness(thinned, side_at, p);
    wait_for(side, p, near);
    return true;
}

static void begin(struct thinned *thinned)
{
    struct rings *rings = thinned->rings;
    for (size_t word = 0; word < rings->hiding.words; word++) {
        if (thinned->set[word]) rings->used[thinned->used_count++] = (uint32_t)word;
        for (uint64_t bits = thinned->set[word]; bits; bits &= bits - 1) {
            const size_t p = word * WORD_BITS + (size_t)__builtin_ctzll(bits);
            for (int i = 0; i < 2; i++) {
                rings->sides[i].witness_at[p] = 0;
                rings->sides[i].first[p] = HIDING_NONE;
            }
        }
    }
    for (size_t i = 0; i < thinned->used_count; i++)
        for (uint64_t bits = thinned->set[rings->used[i]]; bits; bits &= bits - 1) {
            const uint32_t p = rings->used[i] * WORD_BITS + (uint32_t)__builtin_ctzll(bits);
            if (!find_first_witness(thinned, 0, p) || !find_first_witness(thinned, 1, p)) take_out(thinned, p);
        }
}

/* Those whose witness it was look for another. */
static void release(struct thinned *thinned, uint32_t gone)
{
    for (int i = 0; i < 2; i++) {
        const struct rings_side *side = &thinned->rings->sides[i];
        for (uint32_t p = side->first[gone], next; p != HIDING_NONE; p = next) {
            next = side->next[p];
            if (is_in(thinned, p) && !find_witness(thinned, i, p)) take_out(thinned, p);
        }
    }
}

size_t rings_left(struct rings *rings, uint64_t *set)
{
    struct thinned thinned = {rings, set, 0, 0};
    size_t left = 0;

    begin(&thinned);
    while (thinned.gone_count)
        release(&thinned, rings->gone[--thinned.gone_count]);
    for (size_t i = 0; i < thinned.used_count; i++)
        left += (size_t)__builtin_popcountll(set[rings->used[i]]);
    return left;
}

/* In words of the row ever farther from the polygon's own. */
static uint32_t nearest_in(const struct rings *rings, const uint64_t *row, const uint64_t *set, size_t home)
{
    const size_t words = rings->hiding.words;
    for (size_t step = 0; step < words; step++)
        for (int way = 0; way < 2; way++) {
            const size_t word = way ? home - step : home + step;
            const uint64_t met = word < words ? row[word] & set[word] : 0;
            if (met) return (uint32_t)(word * WORD_BITS + (size_t)__builtin_ctzll(met));
        }
    return HIDING_NONE;
}

size_t rings_prepare(struct rings *rings, uint64_t *set)
{
    const size_t left = rings_left(rings, set);
    for (size_t word = 0; word < rings->hiding.words; word++)
        for (uint64_t bits = set[word]; bits; bits &= bits - 1) {
            const uint32_t p = (uint32_t)(word * WORD_BITS) + (uint32_t)__builtin_ctzll(bits);
            for (int i = 0; i < 2; i++)
                rings->sides[i].near[p] = nearest_in(rings, row_of(rings, i, p), set, word);
        }
    return left;
}

bool rings_hold(struct rings *rings, const struct bsp *bsp, const uint32_t *list, size_t count)
{
    uint64_t *whole = grow_zeroed(rings->hiding.words, sizeof *whole);
    for (size_t i = 0; i < count; i++)
        if (list[i] == bsp->pieces[list[i]].polygon) hiding_add(&rings->hiding, whole, list[i]);
    const bool hold = rings_left(rings, whole) > 0;
    free(whole);
    return hold;
}
