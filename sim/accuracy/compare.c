/* SPDX-License-Identifier: MIT
 *
 * A pixel is judged against the 3x3 pixels of the reference around it (fewer at the border): that
 * is all that rounding an edge to the grid can change. Where something is thinner than a pixel
 * those may miss what lies beside it, so a hole has to stand a closer look as well. */
#include "accuracy/compare.h"

#include <math.h>

struct neighbourhood {
    bool has_face;      /* the rendered face occurs in it */
    double depth_max_m; /* the farthest of it; the background is infinitely far */
};

static uint32_t group_of(const uint32_t *groups, uint32_t face)
{
    return groups && groups[face] ? groups[face] : face; /* 0: it was dropped, and is itself */
}

static struct neighbourhood look_around(const struct reference *reference, const uint32_t *groups, size_t pixel,
                                        uint32_t rendered)
{
    struct neighbourhood around = {.depth_max_m = 0.0};
    const size_t w_px = reference->w_px, h_px = reference->h_px;
    const size_t x_px = pixel % w_px, y_px = pixel / w_px;
    for (size_t y = y_px ? y_px - 1 : 0; y <= y_px + 1 && y < h_px; y++) {
        for (size_t x = x_px ? x_px - 1 : 0; x <= x_px + 1 && x < w_px; x++) {
            uint32_t face = reference->faces[y * w_px + x];
            around.has_face |= group_of(groups, face) == rendered;
            around.depth_max_m = fmax(around.depth_max_m, reference->depths_m[y * w_px + x]);
        }
    }
    return around;
}

static bool is_farther(const struct reference *reference, const uint32_t *groups, const struct neighbourhood *around,
                       size_t pixel, uint32_t group, double unit_m)
{
    if (group == 0) return true;
    double tolerance_m = 8.0 * unit_m + 0.001 * around->depth_max_m;
    return reference_depth_of(reference, groups, group, pixel) > around->depth_max_m + tolerance_m;
}

enum compare_verdict compare_pixel(const uint32_t *rendered, const struct reference *reference, const uint32_t *groups,
                                   double unit_m, size_t pixel)
{
    const uint32_t group = group_of(groups, rendered[pixel]);
    if (group == group_of(groups, reference->faces[pixel])) return COMPARE_RIGHT;
    const struct neighbourhood around = look_around(reference, groups, pixel, group);
    if (around.has_face) return COMPARE_WRONG;
    if (!is_farther(reference, groups, &around, pixel, group, unit_m) ||
        reference_sees_nearby(reference, groups, group, pixel))
        return COMPARE_BEYOND;
    return group ? COMPARE_ORDER : COMPARE_OPEN;
}

struct compare_counts compare_picture(const uint32_t *rendered, const struct reference *reference,
                                      const uint32_t *groups, double unit_m)
{
    struct compare_counts counts = {.pixels = (size_t)reference->w_px * reference->h_px};
    for (size_t pixel = 0; pixel < counts.pixels; pixel++) {
        const enum compare_verdict verdict = compare_pixel(rendered, reference, groups, unit_m, pixel);
        counts.wrong += verdict >= COMPARE_WRONG;
        counts.beyond += verdict >= COMPARE_BEYOND;
        counts.holes += verdict >= COMPARE_OPEN;
        counts.order += verdict == COMPARE_ORDER;
    }
    return counts;
}

struct compare_counts compare_wrong(const uint32_t *rendered, const struct reference *reference, const uint32_t *groups)
{
    struct compare_counts counts = {.pixels = (size_t)reference->w_px * reference->h_px};
    for (size_t pixel = 0; pixel < counts.pixels; pixel++)
        counts.wrong += group_of(groups, rendered[pixel]) != group_of(groups, reference->faces[pixel]);
    return counts;
}

void compare_count_faces(const uint32_t *rendered, const struct reference *reference, const uint32_t *groups,
                         uint32_t *wrong_of_face)
{
    for (size_t pixel = 0; pixel < (size_t)reference->w_px * reference->h_px; pixel++) {
        const uint32_t seen = group_of(groups, rendered[pixel]), wanted = group_of(groups, reference->faces[pixel]);
        if (seen == wanted) continue;
        wrong_of_face[seen]++;
        wrong_of_face[wanted]++;
    }
}

bool compare_is_faultier(const struct compare_counts *a, const struct compare_counts *b)
{
    return a->holes > b->holes || (a->holes == b->holes && a->wrong > b->wrong);
}

void comparison_add(struct comparison *comparison, const struct compare_counts *frame)
{
    if (comparison->frames == 0 || frame->wrong > comparison->worst.wrong) {
        comparison->worst = *frame;
        comparison->worst_frame = comparison->frames;
    }
    if (comparison->frames == 0 || compare_is_faultier(frame, &comparison->faultiest)) {
        comparison->faultiest = *frame;
        comparison->faultiest_frame = comparison->frames;
    }
    comparison->total.pixels += frame->pixels;
    comparison->total.wrong += frame->wrong;
    comparison->total.beyond += frame->beyond;
    comparison->total.holes += frame->holes;
    comparison->total.order += frame->order;
    comparison->frames++;
}

double compare_wrong_percent(const struct compare_counts *counts)
{
    return counts->pixels ? 100.0 * (double)counts->wrong / (double)counts->pixels : 0.0;
}

double compare_beyond_ppm(const struct compare_counts *counts)
{
    return counts->pixels ? 1e6 * (double)counts->beyond / (double)counts->pixels : 0.0;
}
