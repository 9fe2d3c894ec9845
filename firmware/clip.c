/* SPDX-License-Identifier: MIT
 *
 * Sutherland and Hodgman, a plane at a time, each adding at most one vertex. Corners of an edge that
 * lies along a plane may cross it many times, by rounding alone: where several are outside, one that
 * stands between two inner ones is replaced by one point, not by two. Distances are taken at half scale or
 * less, because z + x/2 reaches 1.5 * 2^31. */
#include "clip.h"

#include "fixed.h"

/* The near plane is 0; x has planes 1 and 2, y 3 and 4, to the left or top and to the right or bottom. */
struct clip_plane {
    uint_fast8_t number;
    int32_t near_qv;
};

/* Inside where >= 0. */
static LIM_RARE int32_t distance(const struct lim_view_point *p, const struct clip_plane *plane)
{
    const int32_t half_z = p->z_qv >> 1;

    if (!plane->number) return half_z - (plane->near_qv >> 1);
    const int32_t quarter = p->qv[(plane->number - 1) >> 1] >> 2;
    return plane->number & 1 ? half_z + quarter : half_z - quarter;
}

/* 1 or 0. */
static uint32_t is_outside(const struct lim_view_point *p, const struct clip_plane *plane)
{
    return (uint32_t)distance(p, plane) >> 31;
}

static LIM_RARE void cut(struct lim_view_point *out, const struct lim_view_point *inner,
                         const struct lim_view_point *outer, const struct clip_plane *plane)
{
    const uint32_t inner_d = (uint32_t)distance(inner, plane), outer_d = (uint32_t)distance(outer, plane);
    const uint32_t t_q31 = ratio_q31(inner_d, inner_d - outer_d);

    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = lerp_q31(inner->qv[i], outer->qv[i], t_q31);
}

/* The edge that leads on from a cut: along the plane, or what is left of one that enters. */
static inline bool is_hidden(const struct lim_view_point *point)
{
#if LIM_HAS_WIREFRAME
    return point->hidden;
#else
    (void)point;
    return false;
#endif
}

/* `outside` of the n vertices are. Returns how many `to` receives. */
static uint_fast8_t clip_plane(const struct lim_view_point *from, uint_fast8_t n, struct lim_view_point *to,
                               const struct clip_plane *plane, uint32_t outside)
{
    const struct lim_view_point *here = &from[n - 1];
    uint32_t outer = is_outside(here - 1, plane) << 1 | is_outside(here, plane); /* a bit a vertex */
    uint_fast8_t put = 0;

    for (uint_fast8_t k = 0; k < n; k++, here = from++) {
        outer = outer << 1 | is_outside(from, plane);
        const bool leaves = (outer & 3) == 1, enters = (outer & 3) == 2, alone = !(outer & 4) && outside > 1;
        if (LIM_HAS_WIREFRAME && leaves) lim_view_hide_edge(&to[put], true);
        if (leaves) cut(&to[put++], here, from, plane);
        if (LIM_HAS_WIREFRAME && enters && !alone) lim_view_hide_edge(&to[put], is_hidden(here));
        if (enters && !alone) cut(&to[put++], from, here, plane);
        if (!(outer & 1)) to[put++] = *from;
    }
    return put < 3 ? 0 : put;
}

static uint32_t count_outside(const struct lim_view_point *at, uint_fast8_t n, const struct clip_plane *plane)
{
    uint32_t outside = 0;

    for (; n > 0; n--)
        outside += is_outside(at++, plane);
    return outside;
}

static LIM_RARE int32_t clamp_s32(int32_t x, int32_t limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

/* Rounding may leave a cut point a unit outside of the planes; the projection needs it inside. */
static void settle(struct lim_view_point *point, int32_t near_qv)
{
    if (point->z_qv < near_qv) point->z_qv = near_qv;
    if (point->z_qv > INT32_MAX / 2) return;
    point->x_qv = clamp_s32(point->x_qv, 2 * point->z_qv);
    point->y_qv = clamp_s32(point->y_qv, 2 * point->z_qv);
}

struct lim_clip_polygon *lim_clip(struct lim_clip_polygon polygons[2], int32_t near_qv)
{
    struct lim_clip_polygon *polygon = &polygons[0], *other = &polygons[1];

    for (struct clip_plane plane = {0, near_qv}; plane.number < CLIP_PLANES; plane.number++) {
        const uint32_t outside = count_outside(polygon->at, polygon->n, &plane);
        if (!outside) continue;
        LIM_ASSERT(polygon->n < CLIP_MAX_VERTICES); /* one more may come */
        other->n = (uint8_t)clip_plane(polygon->at, polygon->n, other->at, &plane, outside);
        struct lim_clip_polygon *const clipped = other;
        other = polygon;
        polygon = clipped;
    }
    for (uint_fast8_t k = 0; k < polygon->n; k++)
        settle(&polygon->at[k], near_qv);
    return polygon;
}
