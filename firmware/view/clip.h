/* SPDX-License-Identifier: MIT
 *
 * CLIP: a convex polygon in view space against the near plane and the guard band |x|, |y| <= 2z (zoomed: view.h).
 * An edge is always cut from its inner to its outer end, so two polygons that share the edge get
 * the same point. Never against the screen itself: EDGE and SPAN do that without new vertices. */
#ifndef LIM_CLIP_H
#define LIM_CLIP_H

#include "long.h"
#include "view/view.h"

struct lim_clip_polygon {
    uint8_t n;                                          /* 0: nothing is left; else 3..CLIP_MAX_VERTICES */
    LIM_OPTIONAL(uint8_t, zoom_bits, LIM_HAS_TELE * 2); /* of its view's rows */
    /* Of a long scene, what it was loaded from: coarse corners are seen once more. NULL: it is of none. */
    LIM_OPTIONAL(const struct lim_view *, view, LIM_HAS_LONG);
    LIM_OPTIONAL(const LIM_FLASH lim_index *, corners, LIM_HAS_LONG);
    struct lim_view_point at[CLIP_MAX_VERTICES];
};

/* Before a polygon is clipped: the view in whose space it is. */
static inline void lim_clip_begin(struct lim_clip_polygon *polygon, const struct lim_view *view)
{
    for (uint_fast8_t i = 0; LIM_HAS_TELE && i < 2; i++)
        polygon->zoom_bits[i] = view->rows.zoom_bits[i];
    if (LIM_HAS_LONG) *polygon->view = NULL;
}

/* Corners of a scene in view space, all edges of which are drawn. */
static inline void lim_clip_load(struct lim_clip_polygon *polygon, const struct lim_view *view,
                                 const struct lim_scene *scene, const LIM_FLASH lim_index *corners, uint8_t n)
{
    lim_clip_begin(polygon, view);
    if (LIM_HAS_LONG && lim_scene_long(scene)) *polygon->view = view, *polygon->corners = corners;
    polygon->n = n;
    for (uint_fast8_t k = 0; k < n; k++) {
        if (LIM_HAS_LONG && lim_scene_long(scene))
            lim_view_transform_long(view, corners[k], &polygon->at[k]);
        else
            lim_view_transform(view, scene, &scene->vertices[corners[k]], &polygon->at[k]);
        if (LIM_HAS_WIREFRAME) lim_view_hide_edge(&polygon->at[k], false);
    }
}

/* The near plane is 0; x has planes 1 and 2, y 3 and 4, to the left or top and to the right or bottom. */
struct lim_clip_plane {
    uint_fast8_t of;                /* x or y; the near plane has none: kept is 0 */
    int32_t kept, turned, near_qv2; /* bits of it that count, its sign, and half the near plane's distance */
    LIM_OPTIONAL(uint_fast8_t, zoom_bits, LIM_HAS_TELE); /* z has so many more than x or y */
};

/* clip_far.c: of a polygon that has a view, makes each corner that is coarse beside the near plane one of LIM_VIEW_FAR.
 * Whether there is any. */
bool lim_clip_refine(struct lim_clip_polygon *polygon, int32_t near_qv);

/* Of a point of a long scene. */
static inline bool lim_clip_is_far(const struct lim_view_point *point)
{
    return *point->exponent == LIM_VIEW_FAR;
}

/* Of such a point: negative where it is outside. */
int32_t lim_clip_far_distance(const struct lim_view_point *point, const struct lim_clip_plane *plane);

/* Where the edge between two points, one of which is such a point, meets a plane that they are on either side of. */
void lim_clip_cut_far(struct lim_view_point *out, const struct lim_view_point *inner,
                      const struct lim_view_point *outer, const struct lim_clip_plane *plane);

/* Such a point as any other: a corner as it is in its neighbours, a cut with as many bits. */
void lim_clip_end_far(struct lim_view_point *point, const struct lim_clip_polygon *begun);

/* Where an edge meets a plane between two points of different exponents, at distances of which one is negative. */
void lim_clip_cut_long(struct lim_view_point *out, const struct lim_view_point *a, int32_t a_d,
                       const struct lim_view_point *b, int32_t b_d);

/* Raises the exponent, which is negative, of a point so near to the eye that the near plane's distance would have more
 * than 30 bits by it. */
void lim_clip_coarsen(struct lim_view_point *point, int32_t near_qv);

/* polygons[0] is clipped, in two places by turns; returns the one with the result. Every point that is left has
 * near <= z and |x|, |y| <= 2z. */
struct lim_clip_polygon *lim_clip(struct lim_clip_polygon polygons[2], int32_t near_qv);

#endif
