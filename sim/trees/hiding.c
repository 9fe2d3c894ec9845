/* SPDX-License-Identifier: MIT
 *
 * For each polygon's plane, which others have a part in front of it and which behind: two matrices. p can hide q if p
 * is in front of q's plane and q behind p's, which is one matrix turned over, and the other. Polygons come along a
 * curve through space (Morton, 1966), so most planes pass by a block of 64 altogether, and one distance files all. */
#include "trees/hiding.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "trees/bsp.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORD_BITS = 64, MORTON_BITS = 10 };

/* 64 polygons, and a sphere that holds theirs. */
struct block {
    double centre[3], radius;
};

/* What is being found. */
struct search {
    const struct bsp *bsp;
    uint32_t *polygons; /* in the order of their bits */
    struct block *blocks;
    uint64_t *in_front, *behind; /* row p: of p's plane */
    size_t words, count;
};

/* Order ------------------------------------------------------------------------------------- */

static int compare_u64(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Bits of x, y and z in turn, of numbers from 0 to 1. */
static uint64_t morton(const double at[3])
{
    uint64_t code = 0;
    for (int bit = MORTON_BITS - 1; bit >= 0; bit--)
        for (int k = 0; k < 3; k++)
            code = code << 1 | ((uint64_t)(at[k] * ((1 << MORTON_BITS) - 1)) >> bit & 1);
    return code;
}

static void find_bounds(const struct bsp *bsp, const uint32_t *list, size_t count, double low[3], double *extent)
{
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int k = 0; k < 3; k++)
        low[k] = INFINITY;
    *extent = 1.0;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            const double at = bsp->pieces[bsp->pieces[list[i]].polygon].centre[k];
            low[k] = fmin(low[k], at);
            high[k] = fmax(high[k], at);
            *extent = fmax(*extent, high[k] - low[k]);
        }
}

/* Each of the list's polygons once. */
static size_t order_polygons(const struct bsp *bsp, const uint32_t *list, size_t count, uint32_t *polygons)
{
    uint64_t *keys = grow_zeroed(count, sizeof *keys);
    double low[3], extent;
    size_t distinct = 0;

    find_bounds(bsp, list, count, low, &extent);
    for (size_t i = 0; i < count; i++) {
        const uint32_t polygon = bsp->pieces[list[i]].polygon;
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = (bsp->pieces[polygon].centre[k] - low[k]) / extent;
        keys[i] = morton(at) << 32 | polygon;
    }
    qsort(keys, count, sizeof *keys, compare_u64);
    for (size_t i = 0; i < count; i++)
        if (!i || keys[i] != keys[i - 1]) polygons[distinct++] = (uint32_t)keys[i];
    free(keys);
    return distinct;
}

/* Sides ------------------------------------------------------------------------------------- */

static size_t block_size(const struct search *search, size_t block)
{
    const size_t left = search->count - block * WORD_BITS;
    return left < WORD_BITS ? left : WORD_BITS;
}

static struct block block_around(const struct search *search, size_t index)
{
    const uint32_t *polygons = search->polygons + index * WORD_BITS;
    const size_t count = block_size(search, index);
    struct block block = {{0.0, 0.0, 0.0}, 0.0};

    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            block.centre[k] += search->bsp->pieces[polygons[i]].centre[k] / (double)count;
    for (size_t i = 0; i < count; i++) {
        const struct bsp_piece *piece = &search->bsp->pieces[polygons[i]];
        double square = 0.0;
        for (int k = 0; k < 3; k++)
            square += (piece->centre[k] - block.centre[k]) * (piece->centre[k] - block.centre[k]);
        block.radius = fmax(block.radius, sqrt(square) + piece->radius + 0x1p-20);
    }
    return block;
}

/* Sides of a plane, of 64 polygons. */
struct word_sides {
    uint64_t in_front, behind;
};

static struct word_sides sides_of_block(const struct search *search, size_t index, uint32_t group)
{
    const struct bsp *bsp = search->bsp;
    const struct plane *plane = bsp_plane(bsp, group);
    const struct block *block = &search->blocks[index];
    const double distance = plane_distance(plane, block->centre);
    const size_t count = block_size(search, index);
    const uint64_t all = UINT64_MAX >> (WORD_BITS - count);
    struct word_sides out = {0, 0};

    if (fabs(distance) > block->radius + bsp->tolerance_units)
        return distance > 0.0 ? (struct word_sides){all, 0} : (struct word_sides){0, all};
    for (size_t i = 0; i < count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[search->polygons[index * WORD_BITS + i]];
        if (bsp->coplanar->group[piece->polygon] == group) continue;
        const int sides = bsp_piece_sides(bsp, piece, plane);
        if (sides & BSP_FRONT) out.in_front |= UINT64_C(1) << i;
        if (sides & BSP_BACK) out.behind |= UINT64_C(1) << i;
    }
    return out;
}

/* A two-sided face sees, and hides, both ways. */
static struct word_sides as_face_sees(const struct bsp *bsp, uint32_t polygon, struct word_sides sides)
{
    const uint64_t either = sides.in_front | sides.behind;
    if (bsp->mesh->polygons[polygon].two_sided) return (struct word_sides){either, either};
    if (bsp->coplanar->faces_back[polygon]) return (struct word_sides){sides.behind, sides.in_front};
    return sides;
}

static void find_sides(struct search *search, size_t p)
{
    const uint32_t polygon = search->polygons[p];
    for (size_t i = 0; i < search->words; i++) {
        const struct word_sides sides =
            as_face_sees(search->bsp, polygon, sides_of_block(search, i, search->bsp->coplanar->group[polygon]));
        search->in_front[p * search->words + i] = sides.in_front;
        search->behind[p * search->words + i] = sides.behind;
    }
}

/* From sides to hiding ---------------------------------------------------------------------- */

/* Rows become columns: halves of halves change places (Warren, Hacker's Delight, 7-3). */
static void transpose(uint64_t rows[WORD_BITS])
{
    uint64_t mask = UINT64_C(0xFFFFFFFF);
    for (unsigned half = WORD_BITS / 2; half; half /= 2, mask ^= mask << half)
        for (unsigned i = 0; i < WORD_BITS; i = (i + half + 1) & ~half) {
            const uint64_t swapped = (rows[i] >> half ^ rows[i + half]) & mask;
            rows[i] ^= swapped << half;
            rows[i + half] ^= swapped;
        }
}

/* A word of each of 64 rows. */
static void block_get(const struct search *search, const uint64_t *matrix, size_t row, size_t column, uint64_t *out)
{
    memset(out, 0, WORD_BITS * sizeof *out);
    for (size_t i = 0; i < block_size(search, row); i++)
        out[i] = matrix[(row * WORD_BITS + i) * search->words + column];
}

static void block_put(const struct search *search, uint64_t *matrix, size_t row, size_t column, const uint64_t *in)
{
    for (size_t i = 0; i < block_size(search, row); i++)
        matrix[(row * WORD_BITS + i) * search->words + column] = in[i];
}

/* What p hides takes the place of what is behind p, and what hides q that of what is in front of q: each block of the
 * one comes of one block of either. */
static void sides_to_hiding(struct search *search)
{
    uint64_t in_front[WORD_BITS], behind[WORD_BITS];
    for (size_t p = 0; p < search->words; p++)
        for (size_t q = 0; q < search->words; q++) {
            block_get(search, search->in_front, q, p, in_front);
            block_get(search, search->behind, p, q, behind);
            transpose(in_front);
            for (size_t i = 0; i < WORD_BITS; i++)
                behind[i] &= in_front[i];
            block_put(search, search->behind, p, q, behind);
            transpose(behind);
            block_put(search, search->in_front, q, p, behind);
        }
}

/* What planes do not tell, because one is within the tolerance of the other's. Polygons of a list have their bits. */
static void add_layers(const struct hiding *hiding, const struct bsp *bsp, uint32_t p)
{
    size_t count;
    const struct layer *layer = layers_of(&bsp->coplanar->layers, p, &count);
    for (; count; layer++, count--) {
        const uint32_t q = layer->other;
        if (q < p || hiding->bit_of[q] == HIDING_NONE || hiding_holds(hiding, p, q) || hiding_holds(hiding, q, p))
            continue;
        const struct layer_pair pair = layers_pair(&bsp->coplanar->layers, bsp->mesh, p, q);
        uint64_t *const p_hides = &hiding->hides[hiding->bit_of[p] * hiding->words];
        uint64_t *const q_hides = &hiding->hides[hiding->bit_of[q] * hiding->words];
        uint64_t *const hides_p = &hiding->hidden_by[hiding->bit_of[p] * hiding->words];
        uint64_t *const hides_q = &hiding->hidden_by[hiding->bit_of[q] * hiding->words];
        if (pair.p_hides_q) hiding_add(hiding, p_hides, q), hiding_add(hiding, hides_q, p);
        if (pair.q_hides_p) hiding_add(hiding, q_hides, p), hiding_add(hiding, hides_p, q);
    }
}

void hiding_find(struct hiding *hiding, const struct bsp *bsp, const uint32_t *list, size_t count)
{
    struct search search = {.bsp = bsp, .polygons = grow_zeroed(count, sizeof *search.polygons)};
    search.count = order_polygons(bsp, list, count, search.polygons);
    search.words = (search.count + WORD_BITS - 1) / WORD_BITS;
    search.blocks = grow_zeroed(search.words, sizeof *search.blocks);
    search.in_front = grow_zeroed(search.count * search.words, sizeof *search.in_front);
    search.behind = grow_zeroed(search.count * search.words, sizeof *search.behind);
    for (size_t i = 0; i < search.words; i++)
        search.blocks[i] = block_around(&search, i);
    for (size_t p = 0; p < search.count && !deadline_passed(); p++) {
        progress_bar(p, search.count, "compiling: which of %zu polygons can hide which", search.count);
        find_sides(&search, p);
    }
    sides_to_hiding(&search);

    const size_t polygons = bsp->mesh->polygon_count;
    *hiding = (struct hiding){search.behind, search.in_front, grow_zeroed(polygons, sizeof *hiding->bit_of),
                              search.words, search.count};
    for (size_t i = 0; i < polygons; i++)
        hiding->bit_of[i] = HIDING_NONE;
    for (size_t i = 0; i < search.count; i++)
        hiding->bit_of[search.polygons[i]] = (uint32_t)i;
    for (size_t i = 0; i < search.count; i++)
        add_layers(hiding, bsp, search.polygons[i]);
    free(search.polygons);
    free(search.blocks);
}

void hiding_free(struct hiding *hiding)
{
    free(hiding->hides);
    free(hiding->hidden_by);
    free(hiding->bit_of);
    *hiding = (struct hiding){0};
}
