/* SPDX-License-Identifier: MIT
 *
 * Sorted by opacity, ties by their places in a matrix of 8x8 thresholds. Source of the matrix: Bayer, An optimum method
 * for two-level rendition of continuous-tone pictures, 1973. */
#include "model/coverage.h"

#include <math.h>
#include <stdlib.h>

struct texel {
    double opacity;
    int rank, at; /* of equal opacities the lower rank is opaque */
};

static int bayer_rank(int x, int y)
{
    int rank = 0;
    for (int bit = 0; bit < 3; bit++)
        rank = rank << 2 | (((x ^ y) >> bit & 1) << 1 | (y >> bit & 1));
    return rank;
}

static int by_opacity(const void *left, const void *right)
{
    const struct texel *a = left, *b = right;
    if (a->opacity != b->opacity) return a->opacity > b->opacity ? -1 : 1;
    if (a->rank != b->rank) return a->rank < b->rank ? -1 : 1;
    return a->at < b->at ? -1 : 1;
}

bool coverage_keep(const struct coverage *coverage, double share)
{
    const int count = coverage->w_px * coverage->h_px;
    struct texel *texels = malloc((size_t)count * sizeof *texels);
    if (!texels) return false;
    for (int i = 0; i < count; i++) {
        const int x = i % coverage->w_px, y = i / coverage->w_px;
        const double opacity = coverage->opacity[y * coverage->row_px + x];
        texels[i] = (struct texel){floor(opacity * 256 + 0.5), bayer_rank(x, y), y * coverage->row_px + x};
    }
    qsort(texels, (size_t)count, sizeof *texels, by_opacity);
    const int opaque = (int)(share * count + 0.5);
    for (int i = 0; i < count; i++)
        coverage->opacity[texels[i].at] = i < opaque ? 1 : 0;
    free(texels);
    return true;
}
