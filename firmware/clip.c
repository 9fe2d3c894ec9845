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
    uint_fast8_t of;                /* x or y; the near plane has none: kept is 0 */
    int32_t kept, turned, near_qv2; /* bits of it that count, its sign, and half the near plane's distance */
};

static struct clip_plane plane_of(uint_fast8_t number, int32_t near_qv)
{
    if (!number) return (struct clip_plane){.near_qv2 = near_qv >> 1};
    return (struct clip_plane){.of = (uint_fast8_t)(number - 1) >> 1, .kept = -1, .turned = number & 1 ? 0 : -1};
}

/* Inside where >= 0. */
static inline int32_t distance(const struct lim_view_point *p, const struct clip_plane *plane)
{
    const int32_t quarter = (p->qv[plane->of] >> 2) & plane->kept;

    return (p->z_qv >> 1) + ((quarter ^ plane->turned) - plane->turned) - plane->near_qv2;
}

static LIM_RARE void cut(struct lim_view_point *out, const struct lim_view_point *inner, int32_t inner_d,
                         const struct lim_view_point *outer, int32_t outer_d)
{
    const uint32_t t_q31 = ratio_q31((uint32_t)inner_d, (uint32_t)inner_d - (uint32_t)outer_d);

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

static uint32_t count_outside(const struct lim_view_point *at, uint_fast8_t n, const struct clip_plane *plane)
{
    uint32_t outside = 0;

    for (; n > 0; n--)
        outside += (uint32_t)distance(at++, plane) >> 31;
    return outside;
}

/* Returns how many `to` receives. */
static uint_fast8_t clip_plane(const struct lim_view_point *from, uint_fast8_t n, struct lim_view_point *to,
                               const struct clip_plane *plane)
{
    const bool several = count_outside(from, n, plane) > 1;
    const struct lim_view_point *here = &from[n - 1];
    int32_t here_d = distance(here, plane);
    bool before_is_outer = distance(here - 1, plane) < 0;
    uint_fast8_t put = 0;

    for (uint_fast8_t k = 0; k < n; k++, here = from++) {
        const int32_t from_d = distance(from, plane);
        const bool leaves = here_d >= 0 && from_d < 0, enters = here_d < 0 && from_d >= 0;
        const bool alone = !before_is_outer && several;
        if (LIM_HAS_WIREFRAME && leaves) lim_view_hide_edge(&to[put], true);
        if (leaves) cut(&to[put++], here, here_d, from, from_d);
        if (LIM_HAS_WIREFRAME && enters && !alone) lim_view_hide_edge(&to[put], is_hidden(here));
        if (enters && !alone) cut(&to[put++], from, from_d, here, here_d);
        if (from_d >= 0) to[put++] = *from;
        before_is_outer = here_d < 0;
        here_d = from_d;
    }
    return put < 3 ? 0 : put;
}

/* The planes that a vertex is outside of, a bit each. */
static uint32_t planes_outside(const struct lim_view_point *p, int32_t near_qv)
{
    const int32_t half_z = p->z_qv >> 1;
    uint32_t outside = (uint32_t)(half_z < near_qv >> 1);

    for (uint_fast8_t i = 0; i < 2; i++) {
        const int32_t quarter = p->qv[i] >> 2;
        if (half_z + quarter < 0) outside |= 2u << (2 * i);
        if (half_z - quarter < 0) outside |= 4u << (2 * i);
    }
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

/* A cut lies between two corners: planes that have none of these outside have no cut there either, but by rounding. */
struct lim_clip_polygon *lim_clip(struct lim_clip_polygon polygons[2], int32_t near_qv)
{
    struct lim_clip_polygon *polygon = &polygons[0], *other = &polygons[1];
    uint32_t crossed = 0;

    for (uint_fast8_t k = 0; k < polygon->n; k++)
        crossed |= planes_outside(&polygon->at[k], near_qv);
    for (uint_fast8_t number = 0; number < CLIP_PLANES && polygon->n; number++) {
        const struct clip_plane plane = plane_of(number, near_qv);
        if (!(crossed >> number & 1)) continue;
        LIM_ASSERT(polygon->n < CLIP_MAX_VERTICES); /* one more may come */
        other->n = (uint8_t)clip_plane(polygon->at, polygon->n, other->at, &plane);
        struct lim_clip_polygon *const clipped = other;
        other = polygon;
        polygon = clipped;
    }
    for (uint_fast8_t k = 0; k < polygon->n; k++)
        settle(&polygon->at[k], near_qv);
    return polygon;
}
