/* SPDX-License-Identifier: MIT
 *
 * Lists of movers and the planes of the static tree. An entry is an instance as a whole, a polygon of one, or a piece
 * of such a polygon; and a plane that has cut something is an entry too, in no list, for the pieces to remember it.
 * Lists of one instance's polygons keep the order of its own tree, nearest first. */
#include "routes/mover_split.h"

#include "eye.h"
#include "movers/deform.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/piece.h"
#include "routes/mover_list.h"
#include "routes/route.h"
#include "routes/shaft.h"

#if LIM_HAS_MOVERS

/* Planes ------------------------------------------------------------------------------------- */

struct divider {
    struct lim_plane_unpacked plane;
    lim_index node;
    uint16_t entry; /* the plane's own, once it has cut something */
    int32_t eye_side;
    uint16_t owner; /* whose the next ones are, LIM_NONE: nobody's */
    int32_t n_q14[3];
    int32_t front_q14, back_q14; /* n . v beyond these is certainly in front, or behind */
};

/* Q14 and the object's units, more than all that is left out: the normal's fraction, and a vertex's; what lies within
 * the plane's slack; the rounding of a corner in its place. */
#define DOUBT_Q14 (3 * INT32_C(32768) + 6 * INT32_C(16384))
#define DOUBT_A_UNIT_Q14 (4 * INT32_C(16384))

static int32_t saturate(int64_t x)
{
    return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (int32_t)x;
}

/* The plane as an object has it, of which most polygons lie on one side by far. With n < 2^(32 - spare), n_q14 is a
 * normal of a length below sqrt(3) 2^14, and products with a vertex add up to less than 3 * 2^29; offsets stay below
 * 2^62. */
static void turn_to(const struct lim_sorter *sorter, struct divider *divider, uint16_t owner)
{
    const struct lim_instance *instance = &sorter->movers->instances[owner];
    const int32_t *n = divider->plane.n;
    const uint8_t spare = clz_u32(abs_s32(n[0]) | abs_s32(n[1]) | abs_s32(n[2]));
    int64_t offset_q8 = divider->plane.d * 256;

    for (uint_fast8_t i = 0; i < 3; i++) {
        int64_t sum = 0;
        for (uint_fast8_t k = 0; k < 3; k++)
            sum += (int64_t)instance->axes_q30[3 * i + k] * n[k];
        divider->n_q14[i] = (int32_t)(sum >> (48 - spare));
        offset_q8 -= (int64_t)n[i] * instance->at_q8[i];
    }
    offset_q8 *= INT32_C(1) << instance->finer_bits;
    const int64_t offset_q14 = spare > 26 ? offset_q8 * (INT64_C(1) << (spare - 26)) : offset_q8 >> (26 - spare);
    const int64_t doubt_q14 = DOUBT_Q14 + (DOUBT_A_UNIT_Q14 * (INT64_C(1) << instance->finer_bits));
    divider->front_q14 = saturate(offset_q14 + doubt_q14);
    divider->back_q14 = saturate(offset_q14 - doubt_q14);
    divider->owner = owner;
}

/* 0: not certain. */
static uint8_t certain_side(const struct lim_sorter *sorter, const struct divider *divider, uint16_t entry)
{
    const LIM_FLASH struct lim_vertex *vertices = lim_entry_scene(sorter, entry)->vertices;
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
    uint8_t sides = LIM_SIDE_BOTH;

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT) && sides; k++) {
        const struct lim_vertex at = vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        const int32_t value = divider->n_q14[0] * at.x + divider->n_q14[1] * at.y + divider->n_q14[2] * at.z;
        if (value <= divider->front_q14) sides &= (uint8_t)~LIM_SIDE_FRONT;
        if (value >= divider->back_q14) sides &= (uint8_t)~LIM_SIDE_BACK;
    }
    return sides;
}

/* Where the eye is, or the side that is walked first. */
static uint8_t near_side(const struct divider *divider)
{
    return divider->eye_side > 0 ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
}

static uint8_t far_side(const struct divider *divider)
{
    return divider->eye_side > 0 ? LIM_SIDE_BACK : LIM_SIDE_FRONT;
}

/* How far it reaches from its centre along a plane's normal. */
static int64_t reach_to(const struct lim_mover *mover, const struct lim_plane_unpacked *plane)
{
    uint32_t longest = 0;
    int64_t box = 0;

    if (plane->axis != LIM_NO_AXIS) return mover->half_q12[plane->axis];
    for (uint_fast8_t i = 0; i < 3; i++) {
        if (abs_s32(plane->n[i]) > longest) longest = abs_s32(plane->n[i]);
        box += (int64_t)abs_s32(plane->n[i]) * mover->half_q12[i];
    }
    /* As in mover.c, the normal's length. */
    const int64_t length = longest + (plane->slack - longest) * 107 / 256 + 1;
    const int64_t ball = length * mover->radius_q12;
    return ball < box ? ball : box;
}

/* A whole instance against a plane: the ball around it, or the box, whichever reaches less. What is within the plane's
 * slack lies in it, so on the eye's side: beyond is what lies behind that, too. */
static uint8_t split_sides_of_whole(const struct lim_sorter *sorter, uint16_t entry, const struct divider *divider)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);
    const struct lim_mover *mover = &sorter->movers->movers[owner];
    const int64_t value = lim_corner_value(&divider->plane, mover->centre_q12);

    if (sorter->movers->instances[owner].by_centre) return value > 0 ? LIM_SIDE_FRONT : value < 0 ? LIM_SIDE_BACK : 0;
    const int64_t reach = reach_to(mover, &divider->plane);
    const int64_t slack_q12 = divider->plane.slack * LIM_CORNER_ONE_Q12;
    const int64_t near = divider->eye_side > 0 ? value : -value; /* how far on the near side */
    if (near >= reach - slack_q12) return near_side(divider);
    return near < -reach - slack_q12 ? far_side(divider) : LIM_SIDE_BOTH;
}

/* The same of an extent; 0: not certain. Sums of a plane that is not large stay below 2^30. */
static uint8_t side_of_extent(const struct lim_extent *extent, const struct lim_plane_unpacked *plane)
{
    int32_t low = 0, high = 0;

    if (!plane->narrow) return 0;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t n = plane->n[i];
        low += n * (n >= 0 ? extent->low[i] : extent->high[i]);
        high += n * (n >= 0 ? extent->high[i] : extent->low[i]);
    }
    const int32_t half_d = (int32_t)(plane->d >> 1);
    return low > half_d ? LIM_SIDE_FRONT : high < half_d ? LIM_SIDE_BACK : 0;
}

/* The sides that an entry reaches to. */
static uint8_t sides_of(const struct lim_sorter *sorter, struct divider *divider, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    if (lim_mover_is_whole(sorter, entry)) return split_sides_of_whole(sorter, entry, divider);
    const struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    const uint8_t by_extent = polygon->has_extent ? side_of_extent(&polygon->extent, &divider->plane) : 0;
    if (by_extent) return by_extent;
    if (owner != LIM_NONE && !lim_entry_is_cut(sorter, entry)) {
        if (owner != divider->owner) turn_to(sorter, divider, owner);
        const uint8_t side = certain_side(sorter, divider, entry);
        if (side) return side;
    }
    return lim_piece_sides_of(sorter, entry, &divider->plane);
}

/* What cannot be divided goes where it reaches farther. */
static uint8_t heavier_side(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    struct lim_corners places[2];
    int64_t front = 0, back = 0;

    if (lim_mover_is_whole(sorter, entry)) {
        const struct lim_mover *mover = &sorter->movers->movers[lim_entry_owner(sorter, entry)];
        return lim_corner_value(plane, mover->centre_q12) < 0 ? LIM_SIDE_BACK : LIM_SIDE_FRONT;
    }
    const struct lim_corners *corners = lim_corners_of(sorter, entry, places);
    for (uint_fast8_t k = 0; corners && k < corners->n; k++) {
        const int64_t value = lim_corner_value(plane, corners->at_q12[k]);
        if (value > front) front = value;
        if (-value > back) back = -value;
    }
    return back > front ? LIM_SIDE_BACK : LIM_SIDE_FRONT;
}

static void set_sides(struct lim_sorter *sorter, uint16_t entry, uint8_t sides)
{
    sorter->newell->polygons[entry].sides = sides & 3u; /* LIM_SIDE_BOTH, as compilers know it */
}

static uint8_t sides_at(const struct lim_sorter *sorter, uint16_t entry)
{
    return sorter->newell->polygons[entry].sides;
}

/* Uncut ------------------------------------------------------------------------------------------------------------ */

/* false: a piece has too many corners. */
static bool reach_of(const struct lim_sorter *sorter, uint16_t entry, struct lim_reach *reach)
{
    const struct lim_mover *mover = &sorter->movers->movers[lim_entry_owner(sorter, entry)];
    struct lim_corners places[2];

    if (lim_mover_is_whole(sorter, entry)) {
        for (uint_fast8_t i = 0; i < 3; i++) {
            reach->low_q12[i] = mover->centre_q12[i] - mover->half_q12[i];
            reach->high_q12[i] = mover->centre_q12[i] + mover->half_q12[i];
        }
        return true;
    }
    const struct lim_corners *corners = lim_corners_of(sorter, entry, places);
    if (corners) *reach = lim_corners_reach(corners);
    return corners;
}

/* Whether the shaft meets another entry; what it is not known of it does. */
static bool meets_entry(struct lim_sorter *sorter, const struct lim_shaft *shaft, uint16_t entry)
{
    const struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    struct lim_reach reach;

    if (!polygon->has_extent) {
        if (!reach_of(sorter, entry, &reach)) return true;
        lim_entry_set_extent(sorter, entry, reach);
    }
    return lim_shaft_meets_extent(shaft, &polygon->extent);
}

/* Whether the object of an entry may be drawn before that of another, or after it. */
static bool has_order_with(const struct lim_sorter *sorter, uint16_t entry, uint16_t other, bool after)
{
    const uint16_t owner = lim_entry_owner(sorter, entry), others = lim_entry_owner(sorter, other);

    return owner != others && lim_mover_precedes(sorter->movers, after ? others : owner, after ? owner : others);
}

/* Whether anything else of the list that reaches to `side` is in the way. Of one object what comes later hides nothing
 * of what comes before. */
static bool meets_list(struct lim_sorter *sorter, const struct lim_shaft *shaft, uint16_t list, uint16_t entry,
                       uint8_t side)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);
    const bool has_order = !lim_deforms(&sorter->movers->instances[owner]);
    bool is_later = false;

    for (; list != LIM_NONE; list = sorter->list[list].next) {
        if (list == entry) is_later = true;
        if (list == entry || !(sides_at(sorter, list) & side)) continue;
        if (is_later != shaft->is_shadow && has_order && lim_entry_owner(sorter, list) == owner) continue;
        if (meets_entry(sorter, shaft, list) && !has_order_with(sorter, entry, list, shaft->is_shadow)) return true;
    }
    return false;
}

/* Whether an entry that reaches through the plane may go to the near side as it is, or to the far one. */
static bool stays(struct lim_sorter *sorter, const struct divider *divider, const struct lim_route *route,
                  uint16_t list, uint16_t entry, const struct lim_reach *reach, bool goes_near)
{
    const bool front_is_near = divider->eye_side > 0;
    const uint8_t other = goes_near ? far_side(divider) : near_side(divider);
    struct lim_shaft shaft;

    if (goes_near)
        lim_shaft_set(&shaft, route->eye, reach, &divider->plane, front_is_near);
    else if (!lim_shadow_set(&shaft, route->eye, reach, &divider->plane, front_is_near))
        return false;
    return !meets_list(sorter, &shaft, list, entry, other) &&
           !lim_shaft_meets_scene(&shaft, route, divider->eye_side, reach);
}

/* Finds the sides of all entries up to `end`. Whether any reaches through the plane. */
static bool find_sides(struct lim_sorter *sorter, struct divider *divider, uint16_t list, uint16_t end)
{
    bool reaches = false;

    for (; list != end; list = sorter->list[list].next) {
        const uint8_t sides = sides_of(sorter, divider, list);
        set_sides(sorter, list, sides ? sides : near_side(divider));
        reaches |= sides == LIM_SIDE_BOTH;
    }
    return reaches;
}

/* Finds a side for what need not be cut; whether it has one. */
static bool keep_uncut(struct lim_sorter *sorter, const struct divider *divider, const struct lim_route *route,
                       uint16_t list, uint16_t entry)
{
    const uint8_t near = near_side(divider);
    struct lim_reach reach;

    if (!reach_of(sorter, entry, &reach)) return false;
    if (stays(sorter, divider, route, list, entry, &reach, true))
        set_sides(sorter, entry, near);
    else if (stays(sorter, divider, route, list, entry, &reach, false))
        set_sides(sorter, entry, far_side(divider));
    return sides_at(sorter, entry) != LIM_SIDE_BOTH;
}

/* Whole instances first: one that has found its side may let others find theirs. */
static void keep_whole(struct lim_sorter *sorter, const struct divider *divider, const struct lim_route *route,
                       uint16_t list)
{
    bool again = true;

    while (again) {
        again = false;
        for (uint16_t at = list; at != LIM_NONE; at = sorter->list[at].next)
            if (sides_at(sorter, at) == LIM_SIDE_BOTH && lim_mover_is_whole(sorter, at) &&
                keep_uncut(sorter, divider, route, list, at))
                again = true;
    }
}

/* Bursts the first instance that has found none. false: there is none. */
static bool burst_one(struct lim_sorter *sorter, struct divider *divider, uint16_t *list)
{
    for (uint16_t *link = list; *link != LIM_NONE; link = &sorter->list[*link].next) {
        const uint16_t entry = *link, rest = sorter->list[entry].next;
        if (sides_at(sorter, entry) != LIM_SIDE_BOTH || !lim_mover_is_whole(sorter, entry)) continue;
        if (!lim_mover_burst(sorter, entry, link)) continue;
        (void)find_sides(sorter, divider, *link, rest);
        return true;
    }
    return false;
}

/* Leaves on both sides what has to be cut. */
static void decide(struct lim_sorter *sorter, struct divider *divider, const struct lim_route *route, uint16_t *list)
{
    do
        keep_whole(sorter, divider, route, *list);
    while (burst_one(sorter, divider, list));
    for (uint16_t at = *list; at != LIM_NONE; at = sorter->list[at].next)
        if (sides_at(sorter, at) == LIM_SIDE_BOTH && !lim_mover_is_whole(sorter, at))
            (void)keep_uncut(sorter, divider, route, *list, at);
}

/* Cutting ---------------------------------------------------------------------------------------------------------- */

/* The piece in front stays `entry`. Returns the other one, or LIM_NONE: no room. */
static uint16_t mover_split_split(struct lim_sorter *sorter, struct divider *divider, uint16_t entry)
{
    if (divider->entry == LIM_NONE) divider->entry = lim_entry_new(sorter, LIM_NO_INDEX, LIM_NONE, divider->node);
    if (divider->entry == LIM_NONE) return LIM_NONE;
    sorter->newell->polygons[divider->entry].eye_in_front = near_side(divider) == LIM_SIDE_FRONT;
    const uint16_t other = lim_piece_split(sorter, entry, divider->entry);
    if (other == LIM_NONE) return LIM_NONE;
    lim_movers_note_entries(sorter);
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.pieces++;
    return other;
}

/* Adds an entry to the side that it reaches to, or its pieces to both. */
static void mover_split_one(struct lim_sorter *sorter, struct divider *divider, uint16_t entry, struct lim_queue *front,
                            struct lim_queue *back)
{
    uint8_t sides = sides_at(sorter, entry);

    if (sides == LIM_SIDE_BOTH) {
        const uint16_t other =
            lim_mover_is_whole(sorter, entry) ? (uint16_t)LIM_NONE : mover_split_split(sorter, divider, entry);
        if (other != LIM_NONE) {
            lim_queue_add(front, entry);
            lim_queue_add(back, other);
            return;
        }
        if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.forced++;
        sides = heavier_side(sorter, entry, &divider->plane);
    }
    lim_queue_add(sides == LIM_SIDE_FRONT ? front : back, entry);
}

void lim_movers_divide(const struct lim_route *route, int32_t eye_side, uint16_t list, uint16_t *front, uint16_t *back)
{
    struct lim_sorter *const sorter = route->sorter;
    struct divider divider; /* filled in where it is asked for: an initialiser would be a call of memset() */
    struct lim_queue fronts = lim_queue_begin(sorter, front), backs = lim_queue_begin(sorter, back);

    divider.node = route->next;
    divider.entry = divider.owner = LIM_NONE;
    divider.eye_side = eye_side;
    lim_plane_unpack(&divider.plane, route->scene, &route->scene->nodes[route->next].split);
    if (find_sides(sorter, &divider, list, LIM_NONE)) decide(sorter, &divider, route, &list);
    while (list != LIM_NONE) {
        const uint16_t entry = list;
        list = sorter->list[entry].next;
        mover_split_one(sorter, &divider, entry, &fronts, &backs);
    }
}

#endif
