/* SPDX-License-Identifier: MIT
 *
 * Pixel by pixel; only the few that are wrong cost anything. */
#include "holes.h"

#include <math.h>

/* Closer looks a frame: one that needs more is lost anyway, and they are slow. */
enum { LOOKS_MAX = 200 };

struct surroundings {
    bool has_face;      /* the rendered face is seen there */
    double depth_max_m; /* of the farthest face there; the background is infinitely far */
};

static struct surroundings look_around(const struct reference *reference, size_t pixel, uint32_t rendered)
{
    const size_t w_px = reference->w_px, h_px = reference->h_px, x_px = pixel % w_px, y_px = pixel / w_px;
    struct surroundings around = {.depth_max_m = 0};

    for (size_t y = y_px ? y_px - 1 : 0; y <= y_px + 1 && y < h_px; y++) {
        for (size_t x = x_px ? x_px - 1 : 0; x <= x_px + 1 && x < w_px; x++) {
            around.has_face |= reference->faces[y * w_px + x] == rendered;
            around.depth_max_m = fmax(around.depth_max_m, reference->depths_m[y * w_px + x]);
        }
    }
    return around;
}

void holes_add(struct holes *holes, const struct core *profile, const uint32_t *rendered,
               const struct reference *reference, double unit_m)
{
    const size_t pixels = (size_t)reference->w_px * reference->h_px;

    int looks = 0;

    holes->pixels += pixels;
    holes->frames++;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        const uint32_t face = rendered[pixel];
        if (face == reference->faces[pixel]) continue;
        holes->wrong++;
        const struct surroundings around = look_around(reference, pixel, face);
        if (around.has_face) continue;
        if (looks < LOOKS_MAX && ++looks && reference_sees_nearby(reference, NULL, face, pixel)) continue;
        holes->misplaced++;
        const double far_m = around.depth_max_m + 8 * unit_m + 0.001 * around.depth_max_m;
        holes->holes +=
            face == 0 || (profile->sub_bits > 0 && reference_depth_of(reference, NULL, face, pixel) > far_m);
    }
}

double holes_wrong_percent(const struct holes *holes)
{
    return holes->pixels ? 100 * (double)holes->wrong / (double)holes->pixels : 0;
}
