/* SPDX-License-Identifier: MIT
 *
 * A point beyond the plane by b sees an eye that is a before it along a way of which b / (a + b) lies beyond. So what
 * is beyond by b at most, moved by so much of its way to the eye, bounds the shaft. What is before the plane by b casts
 * its shadow as far as b / (a - b) of its way to the eye. The share is rounded up to a power of two: the box grows, and
 * nobody divides. */
#include "routes/shaft.h"

#include "eye.h"
#include "movers/mover_long.h"
#include "routes/route.h"

#if LIM_HAS_MOVERS

/* The corner of a box that is farthest along a normal, or against it. */
static int64_t value_at_end(const struct lim_plane_unpacked *plane, const struct lim_reach *of, bool along)
{
    int32_t at_q12[3];

    for (uint_fast8_t i = 0; i < 3; i++)
        at_q12[i] = (plane->n[i] >= 0) == along ? of->high_q12[i] : of->low_q12[i];
    return lim_corner_value(plane, at_q12);
}

static uint8_t bits_of(uint64_t x)
{
    return (uint8_t)(x >> 32 ? 64 - clz_u32((uint32_t)(x >> 32)) : 32 - clz_u32((uint32_t)x));
}

/* How far it reaches beyond a plane, or to the eye's side of it; and how far away the eye is. */
static int64_t end_q8(const struct lim_reach *of, const struct lim_plane_unpacked *plane, bool in_front)
{
    const int64_t value_q12 = value_at_end(plane, of, in_front);

    return ((in_front ? value_q12 : -value_q12) >> 4) + 1;
}

static int64_t eye_q8(const struct lim_eye *eye, const struct lim_plane_unpacked *plane, bool in_front)
{
    const int64_t value_q8 = lim_plane_value(plane, eye->at_q8[0], eye->at_q8[1], eye->at_q8[2], 256);

    return in_front ? value_q8 : -value_q8;
}

/* part / all <= 2^-shift. */
static uint8_t share_of(int64_t part, int64_t all)
{
    if (part <= 0 || all <= part) return 0;
    const uint8_t bits = bits_of((uint64_t)part), all_bits = bits_of((uint64_t)all);
    const uint8_t shift = (uint8_t)(all_bits > bits ? all_bits - bits - 1 : 0);
    return shift < 31 ? shift : 31;
}

/* The box, and where it is when it moves by a share of its way to the eye, or away from it; as far as it lies in front
 * of an axis plane, or behind. */
static void set_box(struct lim_shaft *shaft, const struct lim_eye *eye, const struct lim_reach *of, uint8_t shift)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t low = of->low_q12[i] >> 12, high = (of->high_q12[i] >> 12) + 1, at = eye->at_q8[i] >> 8;
        const int32_t to_low = shaft->is_shadow ? low - at - 1 : at - low;
        const int32_t to_high = shaft->is_shadow ? high - at : at + 1 - high;
        shaft->low[i] = to_low < 0 ? low + (to_low >> shift) : low;
        shaft->high[i] = to_high > 0 ? high + (to_high >> shift) + 1 : high;
    }
}

static void end_at_plane(struct lim_shaft *shaft, const struct lim_plane_unpacked *plane, bool in_front)
{
    if (LIM_HAS_FAR_MOVERS) lim_shaft_end_far(shaft, plane, in_front);
    if (plane->axis == LIM_NO_AXIS) return;
    *(in_front ? &shaft->low[plane->axis] : &shaft->high[plane->axis]) = (int32_t)plane->d;
}

void lim_shaft_set(struct lim_shaft *shaft, const struct lim_eye *eye, const struct lim_reach *of,
                   const struct lim_plane_unpacked *plane, bool front_is_near)
{
    const int64_t beyond_q8 = end_q8(of, plane, !front_is_near), before_q8 = eye_q8(eye, plane, front_is_near);

    shaft->is_shadow = false;
    set_box(shaft, eye, of, share_of(beyond_q8, beyond_q8 + before_q8));
    end_at_plane(shaft, plane, !front_is_near);
}

bool lim_shadow_set(struct lim_shaft *shadow, const struct lim_eye *eye, const struct lim_reach *of,
                    const struct lim_plane_unpacked *plane, bool front_is_near)
{
    const int64_t before_q8 = end_q8(of, plane, front_is_near), rest_q8 = eye_q8(eye, plane, front_is_near) - before_q8;

    if (rest_q8 < before_q8) return false;
    shadow->is_shadow = true;
    set_box(shadow, eye, of, share_of(before_q8, rest_q8));
    end_at_plane(shadow, plane, front_is_near);
    return true;
}

static bool meets(const struct lim_shaft *shaft, uint_fast8_t i, int32_t low, int32_t high)
{
    return low <= shaft->high[i] && high >= shaft->low[i];
}

bool lim_shaft_meets_extent(const struct lim_shaft *shaft, const struct lim_extent *extent)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        if (!meets(shaft, i, extent->low[i] * INT32_C(2), extent->high[i] * INT32_C(2))) return false;
    return true;
}

static bool meets_box(const struct lim_shaft *shaft, const LIM_FLASH struct lim_box *box)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        if (!meets(shaft, i, box->centre[i] - (int32_t)box->half[i], box->centre[i] + (int32_t)box->half[i]))
            return false;
    return true;
}

/* The box around a polygon. */
static bool meets_polygon(const struct lim_shaft *shaft, const struct lim_scene *scene,
                          const LIM_FLASH lim_index *record)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;
    uint_fast8_t before = 7, after = 7; /* axes along which all corners so far are before the shaft, or after it */

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
        const struct lim_vertex vertex = scene->vertices[corners[k]];
        const int32_t at[3] = {vertex.x, vertex.y, vertex.z};
        for (uint_fast8_t i = 0; i < 3; i++) {
            if (at[i] >= shaft->low[i]) before &= (uint_fast8_t) ~(1u << i);
            if (at[i] <= shaft->high[i]) after &= (uint_fast8_t) ~(1u << i);
        }
        if (!(before | after)) return true;
    }
    return false;
}

/* The same in a long scene. */
static LIM_IF_CALLED bool meets_far_polygon(const struct lim_shaft *shaft, const struct lim_scene *scene,
                                            const LIM_FLASH lim_index *record)
{
    if (LIM_HAS_FAR_MOVERS) return lim_shaft_meets_long_polygon(shaft, scene, record);
    return true;
}

static LIM_IF_CALLED bool meets_far_box(const struct lim_shaft *shaft, const struct lim_scene *scene, lim_index box)
{
    if (LIM_HAS_FAR_MOVERS) return lim_shaft_meets_long_box(shaft, scene, box);
    return true;
}

static bool meets_run(const struct lim_shaft *shaft, const struct lim_route *route, lim_index run)
{
    const LIM_FLASH lim_index *record = &route->scene->polygons[run];

    if (run == LIM_NO_INDEX) return false;
    for (;; record += lim_record_words(record[0])) {
        if (lim_record_is_seen(route->eye, record) &&
            (LIM_HAS_FAR_MOVERS && lim_scene_long(route->scene) ? meets_far_polygon(shaft, route->scene, record)
                                                                : meets_polygon(shaft, route->scene, record)))
            return true;
        if (record[0] & LIM_POLYGON_LAST) return false;
    }
}

/* The run that faces the eye. */
static lim_index seen_run(const LIM_FLASH struct lim_node *node, int32_t side)
{
    return side > 0 ? node->front_run : side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
}

/* Whether all of it is on one side of a node's plane: on the eye's, where what lies in the plane counts, and then so
 * are all ways to the eye; or of a shadow on the other, and then so is that. */
static bool is_beside(const struct lim_shaft *shaft, const struct lim_reach *of, const struct lim_scene *scene,
                      const LIM_FLASH struct lim_plane_ref *ref, bool in_front)
{
    struct lim_plane_unpacked plane;

    if (LIM_HAS_FAR_MOVERS && lim_scene_long(scene)) {
        lim_shaft_unpack_far(&plane, shaft, ref);
    } else {
        lim_plane_unpack(&plane, scene, ref);
    }
    const int64_t end_q12 = value_at_end(&plane, of, !in_front), slack_q12 = plane.slack * LIM_CORNER_ONE_Q12;
    const int64_t inside_q12 = in_front ? end_q12 : -end_q12;
    return shaft->is_shadow ? inside_q12 > slack_q12 : inside_q12 >= -slack_q12;
}

bool lim_shaft_meets_scene(const struct lim_shaft *shaft, const struct lim_route *route, int32_t eye_side,
                           const struct lim_reach *of)
{
    const LIM_FLASH struct lim_node *node = &route->scene->nodes[route->next];
    struct lim_route_pending *const stack = &route->stack[route->depth];
    lim_index next = (eye_side > 0) != shaft->is_shadow ? node->back : node->front;
    uint16_t depth = 0;

    if (meets_run(shaft, route, seen_run(node, eye_side))) return true;
    for (;;) {
        while (next == LIM_NO_INDEX) {
            if (!depth) return false;
            next = stack[--depth].node;
        }
        node = &route->scene->nodes[next];
        next = LIM_NO_INDEX;
        if (LIM_HAS_CULL && node->box != LIM_NO_INDEX &&
            !(LIM_HAS_FAR_MOVERS && lim_scene_long(route->scene) ? meets_far_box(shaft, route->scene, node->box)
                                                                 : meets_box(shaft, &route->scene->boxes[node->box])))
            continue;
        if (lim_node_is_leaf(node)) {
            if (meets_run(shaft, route, node->front_run)) return true;
            continue;
        }
        const int32_t side = lim_route_side(route, node);
        const bool front_first = (side > 0) != shaft->is_shadow;
        next = front_first ? node->front : node->back;
        if (side && is_beside(shaft, of, route->scene, &node->split, front_first)) continue;
        if (meets_run(shaft, route, seen_run(node, side))) return true;
        stack[depth++].node = front_first ? node->back : node->front;
    }
}

#endif
