/* SPDX-License-Identifier: MIT
 *
 * Sutherland and Hodgman, a plane at a time, each adding at most one vertex. Corners of an edge that
 * lies along a plane may cross it many times, by rounding alone: where several are outside, one that
 * stands between two inner ones is replaced by one point, not by two. Distances are taken at half scale or
 * less, because z + x/2 reaches 1.5 * 2^31. */
#include "view/clip.h"

#include "math/fixed.h"

static struct lim_clip_plane plane_of(uint_fast8_t number, int32_t near_qv)
{
    if (!number) return (struct lim_clip_plane){.near_qv2 = near_qv >> 1};
    return (struct lim_clip_plane){.of = (uint_fast8_t)(number - 1) >> 1, .kept = -1, .turned = number & 1 ? 0 : -1};
}

/* How many bits z has more than x (axis 0) or y (1). */
static inline uint8_t zoom_of(const struct lim_clip_polygon *polygon, uint_fast8_t axis)
{
    return LIM_HAS_TELE ? polygon->zoom_bits[axis] : 0;
}

/* Inside where >= 0; in a long scene as the point's exponent has it. */
static inline int32_t distance(const struct lim_view_point *p, const struct lim_clip_plane *plane)
{
    if (LIM_HAS_LONG && lim_clip_is_far(p)) return lim_clip_far_distance(p, plane);
    const int32_t quarter = (p->qv[plane->of] >> 2) & plane->kept;

    return (p->z_qv >> 1 >> (LIM_HAS_TELE ? *plane->zoom_bits : 0)) + ((quarter ^ plane->turned) - plane->turned) -
           lim_view_near(p, plane->near_qv2);
}

/* Of the two points one is inside; from it, so that both ways along an edge lead to the same cut. */
static LIM_RARE void cut(struct lim_view_point *out, const struct lim_view_point *from, int32_t from_d,
                         const struct lim_view_point *to, int32_t to_d)
{
    if (LIM_HAS_LONG && *from->exponent != *to->exponent) {
        lim_clip_cut_long(out, from, from_d, to, to_d);
        return;
    }
    const bool leaves = to_d < 0;
    const struct lim_view_point *inner = leaves ? from : to, *outer = leaves ? to : from;
    const uint32_t inner_d = (uint32_t)(leaves ? from_d : to_d), outer_d = (uint32_t)(leaves ? to_d : from_d);
    const uint32_t t_q31 = ratio_q31(inner_d, inner_d - outer_d);

    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = lerp_q31(inner->qv[i], outer->qv[i], t_q31);
    if (LIM_HAS_LONG) *out->exponent = *inner->exponent;
}

/* The edge that leads on from a cut: along the plane, or what is left of one that enters. */
static inline bool is_hidden(const struct lim_view_point *point)
{
    return LIM_HAS_WIREFRAME && *point->hidden;
}

static bool are_several_outside(const struct lim_view_point *at, uint_fast8_t n, const struct lim_clip_plane *plane)
{
    uint32_t outside = 0;

    for (; n > 0; n--)
        outside += (uint32_t)distance(at++, plane) >> 31;
    return outside > 1;
}

/* Returns how many `to` receives. */
static uint_fast8_t clip_plane(const struct lim_view_point *from, uint_fast8_t n, struct lim_view_point *to,
                               const struct lim_clip_plane *plane)
{
    const struct lim_view_point *const first = from, *const end = from + n, *here = end - 1;
    int32_t before_d = distance(here - 1, plane), here_d = distance(here, plane);
    struct lim_view_point *put = to;

    for (; from < end; here = from++) {
        const int32_t from_d = distance(from, plane);
        if ((here_d ^ from_d) < 0 && (from_d < 0 || before_d < 0 || !are_several_outside(first, n, plane))) {
            if (LIM_HAS_WIREFRAME) lim_view_hide_edge(put, from_d < 0 || is_hidden(here));
            if (LIM_HAS_LONG && (lim_clip_is_far(here) || lim_clip_is_far(from)))
                lim_clip_cut_far(put++, from_d < 0 ? here : from, from_d < 0 ? from : here, plane);
            else
                cut(put++, here, here_d, from, from_d);
        }
        if (from_d >= 0) *put++ = *from;
        before_d = here_d;
        here_d = from_d;
    }
    return (uint_fast8_t)(put - to < 3 ? 0 : put - to);
}

/* The planes that any vertex is outside of, a bit each: where a distance is negative, their bits together are. */
static uint32_t planes_crossed(const struct lim_clip_polygon *polygon, int32_t near_qv2)
{
    int32_t near = 0, low[2] = {0}, high[2] = {0};

    for (const struct lim_view_point *p = polygon->at, *const end = p + polygon->n; p < end; p++) {
        const int32_t half_z = p->z_qv >> 1;
        near |= half_z - lim_view_near(p, near_qv2);
        LIM_UNROLLED(2)
        for (uint_fast8_t i = 0; i < 2; i++) {
            const int32_t quarter = p->qv[i] >> 2;
            const int32_t zoomed = half_z >> zoom_of(polygon, i);
            low[i] |= zoomed + quarter;
            high[i] |= zoomed - quarter;
        }
    }
    return (uint32_t)near >> 31 | (uint32_t)low[0] >> 31 << 1 | (uint32_t)high[0] >> 31 << 2 |
           (uint32_t)low[1] >> 31 << 3 | (uint32_t)high[1] >> 31 << 4;
}

/* The same where some have more bits. */
static LIM_IF_CALLED uint32_t far_planes_crossed(const struct lim_clip_polygon *polygon, int32_t near_qv)
{
    uint32_t crossed = 0;

    for (uint_fast8_t number = 0; number < CLIP_PLANES; number++) {
        struct lim_clip_plane plane = plane_of(number, near_qv);
        if (LIM_HAS_TELE) *plane.zoom_bits = number ? zoom_of(polygon, plane.of) : 0;
        for (uint_fast8_t k = 0; k < polygon->n; k++)
            crossed |= (uint32_t)distance(&polygon->at[k], &plane) >> 31 << number;
    }
    return crossed;
}

/* To -limit .. limit, which is below 2^31: in one comparison, what is below -limit wraps. */
static inline int32_t clamp_s32(int32_t x, uint32_t limit)
{
    if ((uint32_t)x + limit <= 2 * limit) return x;
    return x < 0 ? -(int32_t)limit : (int32_t)limit;
}

/* Rounding may leave a cut point a unit outside of the planes; the projection needs it inside. */
static void settle(struct lim_view_point *point, int32_t least_z_qv, const struct lim_clip_polygon *begun)
{
    if (LIM_HAS_LONG && lim_clip_is_far(point)) lim_clip_end_far(point, begun);
    const int32_t near_qv = lim_view_near(point, least_z_qv);

    if (point->z_qv < near_qv) point->z_qv = near_qv;
    if (!LIM_HAS_TELE && point->z_qv > INT32_MAX / 2) return;
    const uint32_t limit_qv = 2 * (uint32_t)point->z_qv;
    LIM_UNROLLED(2)
    for (uint_fast8_t i = 0; i < 2; i++) {
        const uint32_t zoomed_qv = limit_qv >> zoom_of(begun, i);
        if (!LIM_HAS_TELE || zoomed_qv <= INT32_MAX) point->qv[i] = clamp_s32(point->qv[i], zoomed_qv);
    }
}

/* A cut lies between two corners: planes that have none of these outside have no cut there either, but by rounding. */
struct lim_clip_polygon *lim_clip(struct lim_clip_polygon polygons[2], int32_t near_qv)
{
    struct lim_clip_polygon *polygon = &polygons[0], *other = &polygons[1];

    if (LIM_HAS_LONG)
        for (uint_fast8_t k = 0; k < polygon->n; k++)
            if (*polygon->at[k].exponent < 0) lim_clip_coarsen(&polygon->at[k], near_qv);
    const bool is_far = LIM_HAS_LONG && *polygon->view && lim_clip_refine(polygon, near_qv);
    uint32_t crossed = is_far ? far_planes_crossed(polygon, near_qv) : planes_crossed(polygon, near_qv >> 1);

    for (uint_fast8_t number = 0; crossed && polygon->n; number++, crossed >>= 1) {
        if (!(crossed & 1)) continue;
        struct lim_clip_plane plane = plane_of(number, near_qv);
        if (LIM_HAS_TELE) *plane.zoom_bits = number ? zoom_of(&polygons[0], plane.of) : 0;
        LIM_DEBUG_ASSERT(polygon->n < CLIP_MAX_VERTICES); /* one more may come */
        other->n = (uint8_t)clip_plane(polygon->at, polygon->n, other->at, &plane);
        struct lim_clip_polygon *const clipped = other;
        other = polygon;
        polygon = clipped;
    }
    for (uint_fast8_t k = 0; k < polygon->n; k++)
        settle(&polygon->at[k], near_qv, &polygons[0]);
    return polygon;
}
