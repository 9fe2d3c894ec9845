/* SPDX-License-Identifier: MIT
 *
 * From a polygon record of the scene to a polygon on the screen: VIEW, and CLIP where it must be. */
#ifndef LIM_PROJECT_H
#define LIM_PROJECT_H

#include "screen/edge.h"
#include "stages.h"
#include "view/view.h"

/* Whether some columns of the screen are no longer open, so that those of polygons have to be looked at. What is beyond
 * the screen's own sides CULL and the codes leave out. */
static inline bool lim_project_is_narrow(const struct lim_view *view, const struct lim_rect *open)
{
    return LIM_HAS_HIDDEN && (open->x0 || (int32_t)open->x1 != view->width.px);
}

/* To the left or right of the view a convex solid may keep faces that the tree's orders drop: they cover no pixel. */
static inline bool lim_shape_meets_sides(const struct lim_edge_shape *shape, const struct lim_rect *open)
{
    return shape->left < shape->right && shape->left < (int16_t)open->x1 && shape->right > (int16_t)open->x0;
}

/* What of a polygon's lines lies within. */
static inline struct lim_span_extent lim_shape_lines(const struct lim_edge_shape *shape, const struct lim_rect *within)
{
    const int16_t y0 = (int16_t)within->y0, y1 = (int16_t)within->y1;

    const struct lim_span_extent lines = {shape->top > y0 ? shape->top : y0, shape->bottom < y1 ? shape->bottom : y1};
    return lines;
}

/* Where a vertex that lim_view_all() has seen lies outside of the screen: by its code, or by its point, whose pixels
 * begin there. */
static inline uint_fast8_t lim_project_codes(const struct lim_view *view, struct lim_point at, uint16_t nearness)
{
    if (!nearness) return (uint_fast8_t)at.x;
    const int32_t x = lim_edge_pixel(at.x), y = lim_edge_pixel(at.y);
    return (uint_fast8_t)((x <= 0                ? LIM_VIEW_LEFT
                           : x >= view->width.px ? LIM_VIEW_RIGHT
                                                 : 0) |
                          (y <= 0                 ? LIM_VIEW_TOP
                           : y >= view->height.px ? LIM_VIEW_BOTTOM
                                                  : 0));
}

/* `record` is a polygon record (scene.h). false: nothing of it can be inside `open`. A polygon that is
 * projected once more is not counted again: `stats` is NULL. */
bool lim_project(struct lim_screen_polygon *out, struct lim_view *view, const struct lim_scene *scene,
                 const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats);

/* The same of a record whose corners are in out->at, and need not be clipped. */
bool lim_project_at(struct lim_screen_polygon *out, const struct lim_view *view, const struct lim_scene *scene,
                    const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats);

/* The k-th triangle, 1 <= k <= n - 2, of the fan that stands for a non-monotone polygon. */
void lim_project_fan(const struct lim_screen_polygon *non_monotone, uint8_t k, struct lim_screen_polygon *triangle);

/* A polygon's n corners through the cache. Returns their lim_view_codes(), OR'ed. */
static inline uint_fast16_t lim_project_corners(struct lim_point *at, uint8_t n, struct lim_view *view,
                                                const struct lim_scene *scene, const LIM_FLASH lim_index *corners)
{
    const struct lim_point *const end = at + n;
    uint_fast16_t codes = 0;

    do {
        const struct lim_view_cached *corner = lim_view_vertex(view, scene, *corners++);
        codes |= lim_view_codes(corner);
        *at++ = corner->at;
    } while (at != end);
    return codes;
}

/* A polygon as most are, of n corners, and the codes of these. false: it is clipped or non-monotone, and only
 * lim_project() can tell. true: it lies outside of one side of the screen, or `shape` is set. */
static inline bool lim_project_fast(struct lim_edge_shape *shape, struct lim_point *at, uint8_t n,
                                    struct lim_view *view, const struct lim_scene *scene,
                                    const LIM_FLASH lim_index *record, uint_fast16_t *codes)
{
    *codes = lim_project_corners(at, n, view, scene, record + LIM_POLYGON_HEAD_WORDS);
    return lim_view_all_outside(*codes) || (!(*codes & LIM_VIEW_GUARD) && lim_edge_bounds_plain(shape, at, n));
}

#endif
