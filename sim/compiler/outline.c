/* SPDX-License-Identifier: MIT
 *
 * Neighbours trace a common edge through the same points, so what rounding does to one it does to
 * the other. A piece that becomes a line of two points there and back may go: its two neighbours
 * meet in that line. A line of three points must stay, it bridges two outlines that differ. */
#include "compiler/outline.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

static bool same(struct grid_point a, struct grid_point b)
{
    return a.q8[0] == b.q8[0] && a.q8[1] == b.q8[1] && a.q8[2] == b.q8[2];
}

/* Where an edge shrinks to nothing, the next one leads on. */
void outline_add(struct outline *outline, struct grid_point corner, bool hidden)
{
    if (!outline->count || !same(outline->corners[outline->count - 1], corner)) {
        outline->corners = grow(outline->corners, outline->count, &outline->capacity, sizeof *outline->corners);
        outline->hidden = grow(outline->hidden, outline->count, &outline->hidden_capacity, sizeof *outline->hidden);
        outline->corners[outline->count++] = corner;
    }
    outline->hidden[outline->count - 1] = hidden;
}

static bool has_three_corners(const struct outline *outline)
{
    for (size_t i = 2; i < outline->count; i++)
        if (!same(outline->corners[i], outline->corners[0]) && !same(outline->corners[i], outline->corners[1]))
            return true;
    return false;
}

void outline_close(struct outline *outline)
{
    while (outline->count > 1 && same(outline->corners[outline->count - 1], outline->corners[0]))
        outline->count--;
    if (!has_three_corners(outline)) outline->count = 0;
}

void outline_trace(const struct bsp *bsp, const struct bsp_piece *piece, const struct grid_point *snapped,
                   struct outline *outline)
{
    const struct bsp_corner *corners = &bsp->corners[piece->first];
    outline->count = 0;
    for (size_t i = 0; i < piece->count; i++) {
        const struct bsp_corner *from = &corners[i], *to = &corners[(i + 1) % piece->count];
        const bool hidden = bsp->edges.items[from->edge].hidden;
        outline_add(outline, snapped[from->point], hidden);
        struct edge_range range = edges_between_ends(&bsp->edges, from->edge, from->point, to->point);
        for (size_t k = 0, at = range.first; k < range.count; k++, at += (size_t)range.step)
            outline_add(outline, snapped[bsp->edges.cuts[at].point], hidden);
    }
    outline_close(outline);
}

void outline_free(struct outline *outline)
{
    free(outline->corners);
    free(outline->hidden);
    *outline = (struct outline){0};
}

/* The square of twice the area of corners from .. from + count - 1. */
static double area_square(const struct outline *outline, size_t from, size_t count)
{
    double sum[3] = {0.0, 0.0, 0.0};
    struct grid_point o = outline->corners[from % outline->count];
    for (size_t i = 1; i + 1 < count; i++) {
        struct grid_point p = outline->corners[(from + i) % outline->count];
        struct grid_point q = outline->corners[(from + i + 1) % outline->count];
        double a[3], b[3];
        for (int k = 0; k < 3; k++) {
            a[k] = (double)(p.q8[k] - o.q8[k]);
            b[k] = (double)(q.q8[k] - o.q8[k]);
        }
        for (int k = 0; k < 3; k++)
            sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    return sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
}

size_t outline_chord(const struct outline *outline)
{
    size_t half = outline->count / 2, best = 0;
    double best_area = -1.0;
    for (size_t from = 0; from < outline->count; from++) {
        double area =
            fmin(area_square(outline, from, half + 1), area_square(outline, from + half, outline->count - half + 1));
        if (area > best_area) best = from;
        best_area = fmax(area, best_area);
    }
    return best;
}
