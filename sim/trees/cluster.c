/* SPDX-License-Identifier: MIT
 *
 * An eye that sees both p and q is in front of both planes. Let a ray from it meet p, then q: it meets p where it
 * is still in front of q's plane, and q where it is behind p's already. So p can hide q only if p has a part in
 * front of q's plane and q has a part behind p's plane. An order in which p comes before q wherever that holds is
 * right from everywhere; it exists if the relation has no ring. */
#include "trees/cluster.h"

#include "base/deadline.h"
#include "base/grow.h"

#include <stdlib.h>

enum { WORD_BITS = 64 };

/* Pieces being put in order. Each that waits is in the list of one that can hide it and is not in order yet. */
struct sorting {
    uint64_t *hidden_by;   /* row q, bit p: p can hide q; both are numbers in the list */
    uint64_t *left, *free; /* not in order yet; not in order yet, and nothing left hides them */
    uint32_t *first, *next;
    size_t count, words;
};

/* Where a piece lies as the face of another sees it: a two-sided face sees, and hides, both ways. */
static int sides_of_face(const struct bsp *bsp, const struct bsp_piece *piece, const struct bsp_piece *face)
{
    const uint32_t group = bsp->coplanar->group[face->polygon];
    if (bsp->coplanar->group[piece->polygon] == group) return BSP_ON;
    const int sides = bsp_piece_sides(bsp, piece, bsp_plane(bsp, group));
    if (sides == BSP_ON) return BSP_ON;
    if (bsp->mesh->polygons[face->polygon].two_sided) return BSP_BOTH;
    if (sides == BSP_BOTH || !bsp->coplanar->faces_back[face->polygon]) return sides;
    return sides == BSP_FRONT ? BSP_BACK : BSP_FRONT;
}

struct cluster_pair cluster_pair(const struct bsp *bsp, uint32_t p, uint32_t q)
{
    const int p_from_q = sides_of_face(bsp, &bsp->pieces[p], &bsp->pieces[q]);
    const int q_from_p = sides_of_face(bsp, &bsp->pieces[q], &bsp->pieces[p]);
    const struct cluster_pair out = {(p_from_q & BSP_FRONT) && (q_from_p & BSP_BACK),
                                     (q_from_p & BSP_FRONT) && (p_from_q & BSP_BACK)};
    if (out.p_hides_q || out.q_hides_p) return out;
    const struct layer_pair layers =
        layers_pair(&bsp->coplanar->layers, bsp->mesh, bsp->pieces[p].polygon, bsp->pieces[q].polygon);
    return (struct cluster_pair){layers.p_hides_q, layers.q_hides_p};
}

/* Pieces of polygons of which neither can hide the other need no planes; whole ones need none at all. */
static struct cluster_pair pair_by_hiding(const struct bsp *bsp, const struct hiding *hiding, uint32_t p, uint32_t q)
{
    const uint32_t p_whole = bsp->pieces[p].polygon, q_whole = bsp->pieces[q].polygon;
    const struct cluster_pair whole = {hiding_holds(hiding, p_whole, q_whole), hiding_holds(hiding, q_whole, p_whole)};
    const bool known = (p == p_whole && q == q_whole) || (!whole.p_hides_q && !whole.q_hides_p);
    return known ? whole : cluster_pair(bsp, p, q);
}

static void bit_set(uint64_t *row, size_t at)
{
    row[at / WORD_BITS] |= UINT64_C(1) << at % WORD_BITS;
}

static void relate(struct sorting *sorting, const struct bsp *bsp, const struct hiding *hiding, const uint32_t *list)
{
    for (size_t p = 0; p < sorting->count && !deadline_passed(); p++)
        for (size_t q = p + 1; q < sorting->count; q++) {
            const struct cluster_pair pair =
                hiding ? pair_by_hiding(bsp, hiding, list[p], list[q]) : cluster_pair(bsp, list[p], list[q]);
            if (pair.p_hides_q) bit_set(sorting->hidden_by + q * sorting->words, p);
            if (pair.q_hides_p) bit_set(sorting->hidden_by + p * sorting->words, q);
        }
}

/* Has q wait for the first one left from `from` on that can hide it, or sets it free. */
static void wait_or_free(struct sorting *sorting, uint32_t q, size_t from)
{
    const uint64_t *row = sorting->hidden_by + q * sorting->words;
    for (size_t word = from / WORD_BITS; word < sorting->words; word++) {
        const uint64_t hiding = row[word] & sorting->left[word];
        if (!hiding) continue;
        const size_t p = word * WORD_BITS + (size_t)__builtin_ctzll(hiding);
        sorting->next[q] = sorting->first[p];
        sorting->first[p] = q;
        return;
    }
    bit_set(sorting->free, q);
}

/* The first in the list that none left can hide; `count`: there is none. */
static size_t next_free(const struct sorting *sorting)
{
    for (size_t word = 0; word < sorting->words; word++)
        if (sorting->free[word]) return word * WORD_BITS + (size_t)__builtin_ctzll(sorting->free[word]);
    return sorting->count;
}

static bool sort(struct sorting *sorting, const uint32_t *list, uint32_t *order)
{
    size_t done = 0;
    for (uint32_t p = 0; p < sorting->count; p++) {
        bit_set(sorting->left, p);
        sorting->first[p] = BSP_NONE;
    }
    for (uint32_t q = 0; q < sorting->count; q++)
        wait_or_free(sorting, q, 0);
    for (size_t p; (p = next_free(sorting)) < sorting->count;) {
        const uint64_t bit = UINT64_C(1) << p % WORD_BITS;
        sorting->left[p / WORD_BITS] &= ~bit;
        sorting->free[p / WORD_BITS] &= ~bit;
        order[done++] = list[p];
        for (uint32_t q = sorting->first[p], next; q != BSP_NONE; q = next) {
            next = sorting->next[q];
            wait_or_free(sorting, q, p);
        }
    }
    return done == sorting->count;
}

bool cluster_order(const struct bsp *bsp, const struct hiding *hiding, const uint32_t *list, size_t count,
                   uint32_t *order)
{
    struct sorting sorting = {.count = count, .words = (count + WORD_BITS - 1) / WORD_BITS};
    sorting.hidden_by = grow_zeroed(count * sorting.words, sizeof *sorting.hidden_by);
    sorting.left = grow_zeroed(sorting.words, sizeof *sorting.left);
    sorting.free = grow_zeroed(sorting.words, sizeof *sorting.free);
    sorting.first = grow_zeroed(count, sizeof *sorting.first);
    sorting.next = grow_zeroed(count, sizeof *sorting.next);
    relate(&sorting, bsp, hiding, list);
    const bool sorted = sort(&sorting, list, order);
    free(sorting.hidden_by);
    free(sorting.left);
    free(sorting.free);
    free(sorting.first);
    free(sorting.next);
    return sorted;
}
