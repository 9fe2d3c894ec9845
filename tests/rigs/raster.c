/* SPDX-License-Identifier: MIT
 *
 * Follows a polygon's two boundaries down its lines, without any clipping. */
#include "raster.h"

#include "screen/project.h"

static void add_interval(struct coverage *coverage, int16_t y, int16_t x0, int16_t x1)
{
    const int32_t row = y - coverage->y0;

    if (row < 0 || row >= coverage->h) return;
    for (int32_t x = x0 - coverage->x0; x < x1 - coverage->x0; x++) {
        if (x < 0 || x >= coverage->w) continue;
        uint8_t *count = &coverage->count[row * coverage->w + x];
        if (*count < 255) ++*count;
    }
}

static void add_plain(struct coverage *coverage, const struct lim_edge_shape *shape, const struct lim_point *at,
                      uint8_t n)
{
    struct lim_edge_pair pair;

    if (shape->top >= shape->bottom) return;
    lim_edge_begin(&pair, n, shape->first);
    for (int16_t y = shape->top;;) {
        lim_edge_advance(&pair, at, n, y);
        add_interval(coverage, y, lim_edge_x(&pair.left), lim_edge_x(&pair.right));
        if (++y >= shape->bottom) return;
    }
}

bool raster_add(struct coverage *coverage, const struct lim_point *at, uint8_t n)
{
    struct lim_screen_polygon polygon = {.n = n}, triangle;

    lim_edge_bounds(&polygon.shape, at, n);
    if (!polygon.shape.non_monotone) {
        add_plain(coverage, &polygon.shape, at, n);
        return false;
    }
    for (uint8_t k = 0; k < n; k++) /* what the renderer can hold */
        polygon.at[k] = at[k];
    for (uint8_t k = 1; k + 1 < n; k++) {
        lim_project_fan(&polygon, k, &triangle);
        add_plain(coverage, &triangle.shape, triangle.at, 3);
    }
    return true;
}
