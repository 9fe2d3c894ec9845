/* SPDX-License-Identifier: MIT
 *
 * From a polygon record of the scene to a polygon on the screen: VIEW, and CLIP where it must be. */
#ifndef LIM_PROJECT_H
#define LIM_PROJECT_H

#include "colour.h"
#include "screen/samples.h"
#include "stats.h"
#include "view/clip.h"
#include "view/cull.h"
#include "view/view.h"

#define LIM_FLAG_WORDS(count) (((count) + 15) / 16)

struct lim_screen_polygon {
    struct lim_edge_shape shape;
    uint16_t colour; /* as it lies in memory */
    uint8_t n;
    LIM_OPTIONAL(uint8_t, alpha, LIM_HAS_TRANSPARENT);
    LIM_OPTIONAL(uint16_t, hidden, LIM_HAS_WIREFRAME *LIM_FLAG_WORDS(CLIP_MAX_VERTICES)); /* an edge a bit: not drawn */
    LIM_OPTIONAL(bool, antialiased, LIM_HAS_ANTIALIAS); /* `shape` is of its samples */
    /* The word of lim_scene.polygons at which its record names its texture, or LIM_NONE. */
    LIM_OPTIONAL(uint16_t, texture, LIM_HAS_TEXTURE);
    struct lim_point at[CLIP_MAX_VERTICES];
};

static inline uint8_t lim_alpha_of(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_TRANSPARENT ? *polygon->alpha : (uint8_t)LIM_OPAQUE;
}

/* NULL: there are none. */
static inline const uint16_t *lim_hidden_of(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_WIREFRAME ? polygon->hidden : NULL;
}

static inline uint16_t lim_screen_texture(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_TEXTURE ? *polygon->texture : (uint16_t)LIM_NONE;
}

static inline void lim_set_antialiased(struct lim_screen_polygon *out, bool antialiased)
{
    if (LIM_HAS_ANTIALIAS) *out->antialiased = antialiased;
}

static inline bool lim_is_polygon_antialiased(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_ANTIALIAS && *polygon->antialiased;
}

static inline void lim_set_alpha(struct lim_screen_polygon *out, uint8_t alpha)
{
    if (LIM_HAS_TRANSPARENT) *out->alpha = alpha;
}

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

/* `record` is a polygon record (scene.h). false: nothing of it can be inside `open`. A polygon that is
 * projected once more is not counted again: `stats` is NULL. */
bool lim_project(struct lim_screen_polygon *out, struct lim_view *view, const struct lim_scene *scene,
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
