/* SPDX-License-Identifier: MIT
 *
 * Two convex bodies are apart if they are along one of a few axes: for a polygon and an upright box the polygon's
 * normal, the scene's three axes, and each edge's products with these three. Along an axis m the polygon is a range
 * low..high around the box's middle at its beginning, the box one of r = |m| . half to either side, and on its way the
 * box moves by w = m . way. So they overlap for one stretch of the way, from (low - r) / w to (high + r) / w, and the
 * bodies overlap where all of these stretches do: from the last that begins until the first that ends. There is no root
 * in it, and no rounding.
 *
 * Any axis may be tried, if both bodies are measured along the same one: so an approximate normal does no harm. Fewer
 * axes, or a polygon that is not flat, can only report a contact too early. None is missed.
 *
 * Corners are 256 v - from, below 2^23 + 2^24 each, edges below 2^17: products are below 2^42, sums below 2^44. */
#include "touch/contact.h"

#include "math/wide.h"
#include "touch/descent.h"
#include "view/plane_unpacked.h"

struct stretch {
    uint64_t begin_num, begin_den, end_num, end_den;
    int32_t axis[3]; /* along which it begins, towards the box */
    bool has_begin, has_end;
};

struct span_of_axis {
    int64_t low, high;
};

/* Along an axis, round the middle of the box at its beginning. */
static int64_t corner_along(const struct lim_mover_box *box, const LIM_FLASH struct lim_vertex *vertex,
                            const int32_t axis[3])
{
    return (int64_t)axis[0] * (vertex->x * INT32_C(256) - box->from_q8[0]) +
           (int64_t)axis[1] * (vertex->y * INT32_C(256) - box->from_q8[1]) +
           (int64_t)axis[2] * (vertex->z * INT32_C(256) - box->from_q8[2]);
}

static struct span_of_axis record_along(const struct lim_mover_box *box, const LIM_FLASH lim_index *record,
                                        const int32_t axis[3])
{
    const uint_fast8_t count = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    const LIM_FLASH struct lim_vertex *vertices = box->scene->vertices;
    struct span_of_axis along;

    along.low = along.high = corner_along(box, &vertices[record[LIM_POLYGON_HEAD_WORDS]], axis);
    for (uint_fast8_t k = 1; k < count; k++) {
        const int64_t at = corner_along(box, &vertices[record[LIM_POLYGON_HEAD_WORDS + k]], axis);
        if (at < along.low) along.low = at;
        if (at > along.high) along.high = at;
    }
    return along;
}

/* The last that begins. */
static void note_begin(struct stretch *stretch, const int32_t axis[3], int64_t num, int64_t den, bool other_way)
{
    if (stretch->has_begin &&
        lim_wide_compare((uint64_t)num, stretch->begin_den, stretch->begin_num, (uint64_t)den) <= 0)
        return;
    stretch->has_begin = true;
    stretch->begin_num = (uint64_t)num;
    stretch->begin_den = (uint64_t)den;
    for (uint_fast8_t i = 0; i < 3; i++)
        stretch->axis[i] = other_way ? -axis[i] : axis[i];
}

/* The first that ends. */
static void note_end(struct stretch *stretch, int64_t num, int64_t den)
{
    if (stretch->has_end && lim_wide_compare((uint64_t)num, stretch->end_den, stretch->end_num, (uint64_t)den) >= 0)
        return;
    stretch->has_end = true;
    stretch->end_num = (uint64_t)num;
    stretch->end_den = (uint64_t)den;
}

/* reach: of the box to either side; way: how far it moves. false: they are apart along this axis on all of the way.
 * What touches does not overlap. */
static bool narrow_by(struct stretch *stretch, const int32_t axis[3], struct span_of_axis along, int64_t reach,
                      int64_t way)
{
    const bool down = way < 0;
    const int64_t begin = down ? -(along.high + reach) : along.low - reach;
    const int64_t end = down ? -(along.low - reach) : along.high + reach;
    const int64_t den = down ? -way : way;

    if (!den) return begin < 0 && end > 0;
    if (end <= 0 || begin >= den) return false;
    if (begin >= 0) note_begin(stretch, axis, begin, den, !down);
    if (end < den) note_end(stretch, end, den);
    return true;
}

static bool try_axis(const struct lim_mover_box *box, const LIM_FLASH lim_index *record, const int32_t axis[3],
                     struct stretch *stretch)
{
    int64_t reach = 0, way = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        reach += (int64_t)abs_s32(axis[i]) * box->half_q8[i];
        way += (int64_t)axis[i] * box->way_q8[i];
    }
    return narrow_by(stretch, axis, record_along(box, record, axis), reach, way);
}

/* Along the scene's axes, units. */
struct bounds {
    int16_t low[3], high[3];
};

static void widen(struct bounds *bounds, uint_fast8_t axis, int16_t at)
{
    if (at < bounds->low[axis]) bounds->low[axis] = at;
    if (at > bounds->high[axis]) bounds->high[axis] = at;
}

/* false: the polygon is out of all that the box sweeps over, as most are. */
static bool bound_record(const struct lim_mover_box *box, const LIM_FLASH lim_index *record, struct bounds *bounds)
{
    const LIM_FLASH struct lim_vertex *vertices = box->scene->vertices;
    const LIM_FLASH struct lim_vertex *first = &vertices[record[LIM_POLYGON_HEAD_WORDS]];
    const uint_fast8_t count = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);

    bounds->low[0] = bounds->high[0] = first->x;
    bounds->low[1] = bounds->high[1] = first->y;
    bounds->low[2] = bounds->high[2] = first->z;
    for (uint_fast8_t k = 1; k < count; k++) {
        const LIM_FLASH struct lim_vertex *vertex = &vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        widen(bounds, 0, vertex->x);
        widen(bounds, 1, vertex->y);
        widen(bounds, 2, vertex->z);
    }
    for (uint_fast8_t i = 0; i < 3; i++)
        if (bounds->low[i] > box->high[i] || bounds->high[i] < box->low[i]) return false;
    return true;
}

static bool try_scene_axes(const struct lim_mover_box *box, const struct bounds *bounds, struct stretch *stretch)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t axis[3] = {i == 0, i == 1, i == 2};
        const struct span_of_axis along = {bounds->low[i] * INT32_C(256) - box->from_q8[i],
                                           bounds->high[i] * INT32_C(256) - box->from_q8[i]};
        if (!narrow_by(stretch, axis, along, box->half_q8[i], box->way_q8[i])) return false;
    }
    return true;
}

/* The filter of a LARGE plane is its normal, too: 16 bits of the exact one are as good here. */
static void normal_of(const struct lim_plane_unpacked *plane, int32_t axis[3])
{
    int16_t normal[3];

    lim_hit_normal(plane->n, false, normal);
    for (uint_fast8_t i = 0; i < 3; i++)
        axis[i] = normal[i];
}

/* An edge's products with the scene's axes, as far as they are none of these themselves. */
static bool try_edge(const struct lim_mover_box *box, const LIM_FLASH lim_index *record, const int32_t edge[3],
                     struct stretch *stretch)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        int32_t axis[3] = {0, 0, 0};
        if (!edge[j] || !edge[k]) continue;
        axis[j] = -edge[k];
        axis[k] = edge[j];
        if (!try_axis(box, record, axis, stretch)) return false;
    }
    return true;
}

static bool try_edges(const struct lim_mover_box *box, const LIM_FLASH lim_index *record, struct stretch *stretch)
{
    const uint_fast8_t count = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    const LIM_FLASH struct lim_vertex *vertices = box->scene->vertices;
    const LIM_FLASH struct lim_vertex *p = &vertices[record[LIM_POLYGON_HEAD_WORDS + count - 1]];

    for (uint_fast8_t k = 0; k < count; k++) {
        const LIM_FLASH struct lim_vertex *q = &vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        const int32_t edge[3] = {(int32_t)q->x - p->x, (int32_t)q->y - p->y, (int32_t)q->z - p->z};
        if (!try_edge(box, record, edge, stretch)) return false;
        p = q;
    }
    return true;
}

/* It begins in the polygon, which stops what goes on to its other side. */
static bool is_inwards(const struct lim_mover_box *box, const int32_t axis[3], bool from_back)
{
    const int64_t way =
        (int64_t)axis[0] * box->way_q8[0] + (int64_t)axis[1] * box->way_q8[1] + (int64_t)axis[2] * box->way_q8[2];

    return from_back ? way > 0 : way < 0;
}

static bool find_near(const struct lim_mover_box *box, const LIM_FLASH lim_index *record, const struct bounds *bounds,
                      const struct lim_plane_unpacked *plane, bool from_back, struct lim_contact *contact)
{
    struct stretch stretch = {.has_begin = false};
    int32_t normal[3];

    if (!try_scene_axes(box, bounds, &stretch)) return false;
    normal_of(plane, normal);
    if (plane->axis == LIM_NO_AXIS && !try_axis(box, record, normal, &stretch)) return false;
    if (!try_edges(box, record, &stretch)) return false;
    if (!stretch.has_begin) {
        if (!is_inwards(box, normal, from_back)) return false;
        *contact = (struct lim_contact){.num = 0, .den = 1};
        for (uint_fast8_t i = 0; i < 3; i++)
            contact->axis[i] = from_back ? -normal[i] : normal[i];
        return true;
    }
    if (stretch.has_end &&
        lim_wide_compare(stretch.begin_num, stretch.end_den, stretch.end_num, stretch.begin_den) >= 0)
        return false;
    *contact = (struct lim_contact){.num = stretch.begin_num, .den = stretch.begin_den};
    for (uint_fast8_t i = 0; i < 3; i++)
        contact->axis[i] = stretch.axis[i];
    return true;
}

bool lim_contact_find(const struct lim_mover_box *box, const LIM_FLASH lim_index *record,
                      const struct lim_plane_unpacked *plane, bool from_back, struct lim_contact *contact)
{
    struct bounds bounds;

    return bound_record(box, record, &bounds) && find_near(box, record, &bounds, plane, from_back, contact);
}
