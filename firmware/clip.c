/* SPDX-License-Identifier: MIT
 *
 * Sutherland and Hodgman, a plane at a time, each adding at most one vertex. Corners of an edge that
 * lies along a plane may cross it many times, by rounding alone: where several are outside, one that
 * stands between two inner ones is replaced by one point, not by two. Distances are taken at half scale or
 * less, because z + x/2 reaches 1.5 * 2^31. */
#include "clip.h"

#include "fixed.h"

enum clip_plane { CLIP_NEAR, CLIP_LEFT, CLIP_RIGHT, CLIP_TOP, CLIP_BOTTOM };

/* Inside where >= 0. */
static int32_t distance(enum clip_plane plane, const struct lim_view_point *p, int32_t near_qv)
{
    const int32_t half_z = p->z_qv >> 1;

    switch (plane) {
    case CLIP_NEAR:
        return half_z - (near_qv >> 1);
    case CLIP_LEFT:
        return half_z + (p->x_qv >> 2);
    case CLIP_RIGHT:
        return half_z - (p->x_qv >> 2);
    case CLIP_TOP:
        return half_z + (p->y_qv >> 2);
    default:
        return half_z - (p->y_qv >> 2);
    }
}

static struct lim_view_point cut(const struct lim_view_point *inner, int32_t inner_d,
                                 const struct lim_view_point *outer, int32_t outer_d)
{
    const uint32_t t_q31 = ratio_q31((uint32_t)inner_d, (uint32_t)inner_d - (uint32_t)outer_d);

    return (struct lim_view_point){lerp_q31(inner->x_qv, outer->x_qv, t_q31), lerp_q31(inner->y_qv, outer->y_qv, t_q31),
                                   lerp_q31(inner->z_qv, outer->z_qv, t_q31)};
}

static void append(struct lim_clip_polygon *polygon, struct lim_view_point point)
{
    LIM_ASSERT(polygon->n < CLIP_MAX_VERTICES);
    polygon->at[polygon->n++] = point;
}

/* from -> to, which may not be the same polygon; `outside` of from's vertices are. */
static void clip_plane(const struct lim_clip_polygon *from, struct lim_clip_polygon *to, enum clip_plane plane,
                       int32_t near_qv, uint8_t outside)
{
    const struct lim_view_point *here = &from->at[from->n - 1];
    int32_t before_d = distance(plane, &from->at[from->n - 2], near_qv), here_d = distance(plane, here, near_qv);

    to->n = 0;
    for (uint8_t k = 0; k < from->n; k++) {
        const struct lim_view_point *next = &from->at[k];
        const int32_t next_d = distance(plane, next, near_qv);

        if (here_d >= 0 && next_d < 0) append(to, cut(here, here_d, next, next_d));
        const bool alone = before_d >= 0 && outside > 1;
        if (here_d < 0 && next_d >= 0 && !alone) append(to, cut(next, next_d, here, here_d));
        if (next_d >= 0) append(to, *next);
        here = next;
        before_d = here_d;
        here_d = next_d;
    }
    if (to->n < 3) to->n = 0;
}

static uint8_t count_outside(const struct lim_clip_polygon *polygon, enum clip_plane plane, int32_t near_qv)
{
    uint8_t outside = 0;

    for (uint8_t k = 0; k < polygon->n; k++)
        outside = (uint8_t)(outside + (distance(plane, &polygon->at[k], near_qv) < 0));
    return outside;
}

static int32_t clamp_s32(int32_t x, int32_t limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

/* Rounding may leave a cut point a unit outside of the planes; the projection needs it inside. */
static void settle(struct lim_view_point *point, int32_t near_qv)
{
    if (point->z_qv < near_qv) point->z_qv = near_qv;
    const int32_t band_qv = point->z_qv > INT32_MAX / 2 ? INT32_MAX : 2 * point->z_qv;
    point->x_qv = clamp_s32(point->x_qv, band_qv);
    point->y_qv = clamp_s32(point->y_qv, band_qv);
}

void lim_clip(struct lim_clip_polygon *polygon, int32_t near_qv)
{
    struct lim_clip_polygon cut_polygon;

    for (uint8_t plane = 0; plane < CLIP_PLANES && polygon->n; plane++) {
        const uint8_t outside = count_outside(polygon, (enum clip_plane)plane, near_qv);
        if (!outside) continue;
        clip_plane(polygon, &cut_polygon, (enum clip_plane)plane, near_qv, outside);
        *polygon = cut_polygon;
    }
    for (uint8_t k = 0; k < polygon->n; k++)
        settle(&polygon->at[k], near_qv);
}
