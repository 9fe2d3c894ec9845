/* SPDX-License-Identifier: MIT
 *
 * Points in the order of a space-filling curve (Morton's), cut every so many points. */
#include "base/point_blocks.h"

#include "base/grow.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK_POINTS = 64, CURVE_BITS = 20 };

struct place {
    uint64_t along; /* the curve */
    size_t point;
};

/* A block's sphere, a little widened against rounding. */
static void block_enclose(struct point_block *block)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, square = 0.0;
    for (size_t i = 0; i < block->count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], block->points[i][k]);
            high[k] = fmax(high[k], block->points[i][k]);
        }
    for (int k = 0; k < 3; k++) {
        block->centre[k] = (low[k] + high[k]) / 2.0;
        square += (high[k] - low[k]) * (high[k] - low[k]) / 4.0;
    }
    block->radius = sqrt(square) * (1.0 + 0x1p-40) + 0x1p-20;
}

static uint64_t along_curve(const double point[3], const double low[3], double scale)
{
    uint64_t along = 0;
    for (int k = 0; k < 3; k++) {
        const uint64_t step = (uint64_t)((point[k] - low[k]) * scale);
        for (int bit = 0; bit < CURVE_BITS; bit++)
            along |= (step >> bit & 1) << (3 * bit + k);
    }
    return along;
}

static int by_curve(const void *left, const void *right)
{
    const struct place *a = left, *b = right;
    if (a->along != b->along) return a->along < b->along ? -1 : 1;
    return (a->point > b->point) - (a->point < b->point);
}

static void sort_points(double (*points)[3], size_t count, double (*out)[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, extent = 0.0;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            low[k] = fmin(low[k], points[i][k]);
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, points[i][k] - low[k]);
    struct place *places = grow_zeroed(count, sizeof *places);
    for (size_t i = 0; i < count; i++)
        places[i] =
            (struct place){along_curve(points[i], low, extent > 0.0 ? ((1 << CURVE_BITS) - 1) / extent : 0.0), i};
    qsort(places, count, sizeof *places, by_curve);
    for (size_t i = 0; i < count; i++)
        memcpy(out[i], points[places[i].point], sizeof out[i]);
    free(places);
}

void point_blocks_build(struct point_blocks *out, double (*points)[3], size_t count)
{
    *out = (struct point_blocks){.points = grow_zeroed(count, sizeof *out->points),
                                 .blocks = grow_zeroed(count / BLOCK_POINTS + 1, sizeof *out->blocks)};
    sort_points(points, count, out->points);
    for (size_t first = 0; first < count; first += BLOCK_POINTS) {
        struct point_block *block = &out->blocks[out->count++];
        block->points = out->points + first;
        block->count = count - first < BLOCK_POINTS ? count - first : BLOCK_POINTS;
        block_enclose(block);
    }
}

void point_blocks_free(struct point_blocks *blocks)
{
    free(blocks->points);
    free(blocks->blocks);
    *blocks = (struct point_blocks){0};
}
