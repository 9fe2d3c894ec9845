/* SPDX-License-Identifier: MIT
 *
 * Lists of movers and the planes of the static tree. An entry is an instance as a whole, or a part of one
 * (mover_part.h); and a plane that has cut something is an entry too, in no list, for the parts to remember it. */
#include "routes/mover_split.h"

#include "eye.h"
#include "movers/mover_long.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/piece.h"
#include "routes/mover_list.h"
#include "routes/mover_part.h"
#include "routes/route.h"
#include "routes/shaft.h"

#if LIM_HAS_MOVERS

/* Planes ------------------------------------------------------------------------------------- */

struct divider {
    struct lim_plane_unpacked plane; /* in the static scene */
    struct lim_plane_unpacked own;   /* as the route's scene has it */
    const LIM_FLASH struct lim_plane_ref *ref;
    lim_index node;
    uint16_t mover; /* of which the node is, or LIM_NONE */
    uint16_t entry; /* the plane's own, once it has cut something */
    int32_t eye_side;
};

/* In a long scene, the same in the frame of a mover. */
static LIM_IF_CALLED void divider_bring(struct divider *out, const struct divider *divider,
                                        const struct lim_sorter *sorter, uint16_t entry)
{
    out->plane = divider->plane;
    out->ref = divider->ref;
    out->mover = divider->mover;
    out->eye_side = divider->eye_side;
    if (LIM_HAS_FAR_MOVERS)
        lim_plane_bring(&out->plane, sorter->movers, divider->mover, lim_entry_owner(sorter, entry));
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

/* Vertices that are asked at most, each for itself. */
enum { VERTICES_MAX = 96 };

/* Of its components, as slack is but in a frame. */
static LIM_IF_CALLED int64_t sum_of(const struct lim_plane_unpacked *plane)
{
    return (int64_t)abs_s32(plane->n[0]) + abs_s32(plane->n[1]) + abs_s32(plane->n[2]);
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
    const int64_t length = longest + ((LIM_HAS_LONG ? sum_of(plane) : plane->slack) - longest) * 107 / 256 + 1;
    const int64_t ball = length * mover->radius_q12;
    return ball < box ? ball : box;
}

/* The ball around an instance, or the box, whichever reaches less. What is within the plane's slack lies in it, so on
 * the eye's side: beyond is what lies behind that, too. */
static uint8_t sides_of_ball(const struct lim_sorter *sorter, uint16_t owner, const struct divider *divider)
{
    const struct lim_mover *mover = &sorter->movers->movers[owner];
    const int64_t value = lim_corner_value(&divider->plane, mover->centre_q12);

    if (sorter->movers->instances[owner].by_centre) return value > 0 ? LIM_SIDE_FRONT : value < 0 ? LIM_SIDE_BACK : 0;
    const int64_t reach = reach_to(mover, &divider->plane);
    const int64_t slack_q12 = divider->plane.slack * LIM_CORNER_ONE_Q12;
    const int64_t near = divider->eye_side > 0 ? value : -value; /* how far on the near side */
    if (near >= reach - slack_q12) return near_side(divider);
    return near < -reach - slack_q12 ? far_side(divider) : LIM_SIDE_BOTH;
}

/* The same of a part's box and an axis plane in a frame, if not 0: both in steps of two units. */
static LIM_IF_CALLED uint8_t sides_along(const struct lim_extent *extent, const struct lim_plane_unpacked *plane)
{
    const int64_t end = plane->d >> 29;

    if (extent->low[*plane->along] > end) return LIM_SIDE_FRONT;
    return extent->high[*plane->along] < end ? LIM_SIDE_BACK : 0;
}

/* The same of a part's box, if not 0. Sums of a plane that is not large stay below 2^30. */
static uint8_t sides_of_extent(const struct lim_extent *extent, const struct lim_plane_unpacked *plane)
{
    int32_t low = 0, high = 0;

    if (LIM_HAS_FAR_MOVERS && *plane->along != LIM_NO_AXIS) return sides_along(extent, plane);
    if (!plane->narrow) return 0;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t n = plane->n[i];
        low += n * (n >= 0 ? extent->low[i] : extent->high[i]);
        high += n * (n >= 0 ? extent->high[i] : extent->low[i]);
    }
    const int32_t half_d = (int32_t)(plane->d >> 1);
    return low > half_d ? LIM_SIDE_FRONT : high < half_d ? LIM_SIDE_BACK : 0;
}

/* Of all vertices, where there are few: 0, if they are not by far on one side. */
static uint8_t sides_of_vertices(const struct lim_sorter *sorter, uint16_t owner, const struct divider *divider)
{
    const struct lim_instance *instance = &sorter->movers->instances[owner];
    const struct lim_scene *object = instance->object;
    struct lim_turned_plane turned;
    struct lim_turned_range range = {INT32_MAX, INT32_MIN};

    if (object->vertex_count > VERTICES_MAX) return 0;
    lim_plane_turn(&turned, instance, &divider->plane);
    for (lim_index k = 0; k < object->vertex_count; k++) {
        const struct lim_vertex at = object->vertices[k];
        lim_turned_add(&range, &turned, &at);
        if (range.least_q14 <= turned.front_q14 && range.most_q14 >= turned.back_q14) return 0;
    }
    return lim_turned_sides(&range, &turned);
}

static bool is_one_plane(const struct lim_sorter *sorter, uint16_t by, const struct divider *divider)
{
    const LIM_FLASH struct lim_plane_ref *ref = lim_plane_of(sorter, by);

    return ref->plane == divider->ref->plane && ref->offset == divider->ref->offset &&
           lim_entry_owner(sorter, by) == divider->mover;
}

/* Of a part that the same plane has cut before; else 0. */
static uint8_t side_cut_to(const struct lim_sorter *sorter, uint16_t entry, const struct divider *divider)
{
    const struct lim_newell *newell = sorter->newell;

    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        const uint16_t by = newell->cuts[cut].by;
        if (is_one_plane(sorter, by & LIM_SORTED_MAX, divider))
            return by & LIM_CUT_FRONT ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
    }
    return 0;
}

/* The sides that an entry reaches to. */
static uint8_t sides_of(const struct lim_sorter *sorter, const struct divider *divider, uint16_t entry)
{
    const struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    uint8_t sides = sides_of_ball(sorter, polygon->owner, divider);

    if (sides != LIM_SIDE_BOTH) return sides;
    if ((sides = side_cut_to(sorter, entry, divider)) != 0) return sides;
    if (polygon->has_extent && (sides = sides_of_extent(&polygon->extent, &divider->plane)) != 0) return sides;
    sides = sides_of_vertices(sorter, polygon->owner, divider);
    return sides ? sides : LIM_SIDE_BOTH;
}

static LIM_IF_CALLED uint8_t sides_in_frame(const struct lim_sorter *sorter, const struct divider *divider,
                                            uint16_t entry)
{
    struct divider brought;

    if (!lim_movers_are_far(sorter->movers)) return sides_of(sorter, divider, entry);
    divider_bring(&brought, divider, sorter, entry);
    return sides_of(sorter, &brought, entry);
}

/* What cannot be divided goes where its centre is. */
static uint8_t heavier_side(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    const struct lim_mover *mover = &sorter->movers->movers[lim_entry_owner(sorter, entry)];

    return lim_corner_value(plane, mover->centre_q12) < 0 ? LIM_SIDE_BACK : LIM_SIDE_FRONT;
}

static LIM_IF_CALLED uint8_t heavier_in_frame(const struct lim_sorter *sorter, uint16_t entry,
                                              const struct divider *divider)
{
    struct divider brought;

    if (!lim_movers_are_far(sorter->movers)) return heavier_side(sorter, entry, &divider->plane);
    divider_bring(&brought, divider, sorter, entry);
    return heavier_side(sorter, entry, &brought.plane);
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

static struct lim_reach reach_of(const struct lim_sorter *sorter, uint16_t entry)
{
    const struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    const struct lim_mover *mover = &sorter->movers->movers[polygon->owner];
    struct lim_reach reach = {.low_q12 = {0}};

    for (uint_fast8_t i = 0; i < 3; i++) {
        reach.low_q12[i] = polygon->has_extent ? polygon->extent.low[i] * (INT32_C(1) << 13)
                                               : mover->centre_q12[i] - mover->half_q12[i];
        reach.high_q12[i] = polygon->has_extent ? polygon->extent.high[i] * (INT32_C(1) << 13)
                                                : mover->centre_q12[i] + mover->half_q12[i];
    }
    return reach;
}

/* The same along the axes of another mover, in units of that: of the box that turns with the instance. */
static struct lim_reach reach_beside(const struct lim_movers *movers, uint16_t mover, uint16_t beside)
{
    const struct lim_instance *instance = &movers->instances[mover], *axes = &movers->instances[beside];
    struct lim_reach reach = {.low_q12 = {0}};
    int32_t away_q12[3];

    for (uint_fast8_t i = 0; i < 3; i++)
        away_q12[i] = movers->movers[mover].centre_q12[i] - axes->at_q8[i] * 16;
    for (uint_fast8_t j = 0; j < 3; j++) {
        int64_t half_q42 = 0;
        for (uint_fast8_t k = 0; k < 3; k++) {
            const int32_t along_q30 = (int32_t)(lim_along_axis(axes, j, &instance->axes_q30[3 * k]) >> 30);
            half_q42 += (int64_t)abs_s32(along_q30) * movers->movers[mover].own_half_q12[k];
        }
        const int32_t centre_q12 = (int32_t)(lim_along_axis(axes, j, away_q12) >> 30);
        const int32_t half_q12 = (int32_t)(half_q42 >> 30) + 16; /* for what is rounded */
        reach.low_q12[j] = (centre_q12 - half_q12) * (INT32_C(1) << axes->finer_bits);
        reach.high_q12[j] = (centre_q12 + half_q12) * (INT32_C(1) << axes->finer_bits);
    }
    return reach;
}

/* Whether the shaft meets another entry. */
static bool meets_entry(struct lim_sorter *sorter, const struct lim_shaft *shaft, uint16_t entry)
{
    const struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];

    if (!polygon->has_extent) lim_entry_set_extent(sorter, entry, reach_of(sorter, entry));
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers))
        return lim_shaft_meets_far_extent(shaft, &polygon->extent, lim_mover_exponent(sorter->movers, polygon->owner));
    return lim_shaft_meets_extent(shaft, &polygon->extent);
}

/* Whether the object of an entry may be drawn before that of another, or after it. */
static bool has_order_with(const struct lim_sorter *sorter, uint16_t entry, uint16_t other, bool after)
{
    const uint16_t owner = lim_entry_owner(sorter, entry), others = lim_entry_owner(sorter, other);

    return lim_mover_precedes(sorter->movers, after ? others : owner, after ? owner : others);
}

/* Whether anything else of the list that reaches to `side` is in the way. */
static bool meets_list(struct lim_sorter *sorter, const struct lim_shaft *shaft, const struct divider *divider,
                       uint16_t list, uint16_t entry, uint8_t side)
{
    for (; list != LIM_NONE; list = sorter->list[list].next) {
        if (list == entry || !(sides_at(sorter, list) & side)) continue;
        if (divider->mover == LIM_NONE && !meets_entry(sorter, shaft, list)) continue;
        if (!has_order_with(sorter, entry, list, shaft->is_shadow)) return true;
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

    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers)) {
        shaft.far->movers = sorter->movers;
        shaft.far->mover = lim_entry_owner(sorter, entry);
    }
    if (goes_near)
        lim_shaft_set(&shaft, route->eye, reach, &divider->own, front_is_near);
    else if (!lim_shadow_set(&shaft, route->eye, reach, &divider->own, front_is_near))
        return false;
    return !meets_list(sorter, &shaft, divider, list, entry, other) &&
           !lim_shaft_meets_scene(&shaft, route, divider->eye_side, reach);
}

/* Whether any entry reaches through the plane. */
static bool find_sides(struct lim_sorter *sorter, const struct divider *divider, uint16_t list)
{
    bool reaches = false;

    for (; list != LIM_NONE; list = sorter->list[list].next) {
        const uint8_t sides =
            LIM_HAS_FAR_MOVERS ? sides_in_frame(sorter, divider, list) : sides_of(sorter, divider, list);
        set_sides(sorter, list, sides ? sides : near_side(divider));
        reaches |= sides == LIM_SIDE_BOTH;
    }
    return reaches;
}

/* Finds a side for what need not be cut; whether it has one. */
static bool keep_uncut(struct lim_sorter *sorter, const struct divider *divider, const struct lim_route *route,
                       uint16_t list, uint16_t entry)
{
    const struct lim_reach reach = divider->mover == LIM_NONE
                                       ? reach_of(sorter, entry)
                                       : reach_beside(sorter->movers, lim_entry_owner(sorter, entry), divider->mover);

    if (stays(sorter, divider, route, list, entry, &reach, true))
        set_sides(sorter, entry, near_side(divider));
    else if (stays(sorter, divider, route, list, entry, &reach, false))
        set_sides(sorter, entry, far_side(divider));
    return sides_at(sorter, entry) != LIM_SIDE_BOTH;
}

static LIM_IF_CALLED bool keep_uncut_far(struct lim_sorter *sorter, const struct divider *divider,
                                         const struct lim_route *route, uint16_t list, uint16_t entry)
{
    struct divider brought;
    struct lim_reach reach;

    if (!LIM_HAS_FAR_MOVERS || !lim_movers_are_far(sorter->movers))
        return keep_uncut(sorter, divider, route, list, entry);
    divider_bring(&brought, divider, sorter, entry);
    brought.own = divider->mover == LIM_NONE ? brought.plane : divider->own;
    if (divider->mover == LIM_NONE)
        reach = reach_of(sorter, entry);
    else if (!lim_far_reach_beside(sorter->movers, lim_entry_owner(sorter, entry), divider->mover, reach.low_q12,
                                   reach.high_q12))
        return false;
    if (stays(sorter, &brought, route, list, entry, &reach, true))
        set_sides(sorter, entry, near_side(divider));
    else if (stays(sorter, &brought, route, list, entry, &reach, false))
        set_sides(sorter, entry, far_side(divider));
    return sides_at(sorter, entry) != LIM_SIDE_BOTH;
}

/* Leaves on both sides what has to be cut. One that has found its side may let others find theirs. */
static void decide(struct lim_sorter *sorter, const struct divider *divider, const struct lim_route *route,
                   uint16_t list)
{
    bool again = true;

    while (again) {
        again = false;
        for (uint16_t at = list; at != LIM_NONE; at = sorter->list[at].next)
            if (sides_at(sorter, at) == LIM_SIDE_BOTH &&
                (LIM_HAS_FAR_MOVERS ? keep_uncut_far(sorter, divider, route, list, at)
                                    : keep_uncut(sorter, divider, route, list, at)))
                again = true;
    }
}

/* Cutting ---------------------------------------------------------------------------------------------------------- */

/* In a frame; nothing in others. */
static LIM_IF_CALLED void end_far_reach(struct lim_reach *reach, const struct lim_sorter *sorter, uint16_t entry,
                                        const struct divider *divider, bool in_front)
{
    const uint8_t along = *divider->plane.along;
    struct divider brought;

    if (along == LIM_NO_AXIS) return;
    divider_bring(&brought, divider, sorter, entry);
    const int64_t end_q12 = brought.plane.d >> 16;
    if (end_q12 <= reach->low_q12[along] || end_q12 >= reach->high_q12[along]) return;
    *(in_front ? &reach->low_q12[along] : &reach->high_q12[along]) = (int32_t)end_q12 + !in_front;
}

/* The box ends at a plane along two axes. */
static void set_part(struct lim_sorter *sorter, uint16_t entry, struct lim_reach reach, const struct divider *divider,
                     bool in_front)
{
    struct lim_newell *newell = sorter->newell;
    const uint8_t axis = divider->plane.axis;
    const int32_t end_q12 = axis == LIM_NO_AXIS ? 0 : (int32_t)divider->plane.d * (int32_t)LIM_CORNER_ONE_Q12;

    if (axis != LIM_NO_AXIS && in_front) reach.low_q12[axis] = end_q12;
    if (axis != LIM_NO_AXIS && !in_front) reach.high_q12[axis] = end_q12;
    if (LIM_HAS_FAR_MOVERS) end_far_reach(&reach, sorter, entry, divider, in_front);
    newell->cuts[newell->cuts_used] =
        (struct lim_cut){newell->polygons[entry].cuts, (uint16_t)(divider->entry | (in_front ? LIM_CUT_FRONT : 0u))};
    newell->polygons[entry].cuts = newell->cuts_used++;
    lim_entry_set_extent(sorter, entry, reach);
}

/* The part in front stays `entry`. Returns the other one, or LIM_NONE: no room. */
static uint16_t mover_split_split(struct lim_sorter *sorter, struct divider *divider, uint16_t entry)
{
    const lim_index record = LIM_NO_INDEX;
    const struct lim_reach reach = reach_of(sorter, entry);

    if (divider->entry == LIM_NONE) divider->entry = lim_entry_new(sorter, record, divider->mover, divider->node);
    if (divider->entry == LIM_NONE || !lim_piece_has_room(sorter)) return LIM_NONE;
    sorter->newell->polygons[divider->entry].eye_in_front = near_side(divider) == LIM_SIDE_FRONT;
    const uint16_t other = lim_entry_new(sorter, record, lim_entry_owner(sorter, entry), record);
    sorter->newell->polygons[other] = sorter->newell->polygons[entry];
    set_part(sorter, entry, reach, divider, true);
    set_part(sorter, other, reach, divider, false);
    lim_movers_note_entries(sorter);
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.divided++;
    return other;
}

/* Adds an entry to the side that it reaches to, or its parts to both. */
static void mover_split_one(struct lim_sorter *sorter, struct divider *divider, uint16_t entry, struct lim_queue *front,
                            struct lim_queue *back)
{
    uint8_t sides = sides_at(sorter, entry);

    if (sides == LIM_SIDE_BOTH) {
        const uint16_t other = mover_split_split(sorter, divider, entry);
        if (other != LIM_NONE) {
            lim_queue_add(front, entry);
            lim_queue_add(back, other);
            return;
        }
        if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.forced++;
        sides = LIM_HAS_FAR_MOVERS ? heavier_in_frame(sorter, entry, divider)
                                   : heavier_side(sorter, entry, &divider->plane);
    }
    lim_queue_add(sides == LIM_SIDE_FRONT ? front : back, entry);
}

void lim_movers_divide(const struct lim_route *route, int32_t eye_side, uint16_t list, uint16_t *front, uint16_t *back)
{
    struct lim_sorter *const sorter = route->sorter;
    struct divider divider; /* filled in where it is asked for: an initialiser would be a call of memset() */
    struct lim_queue fronts = lim_queue_begin(sorter, front), backs = lim_queue_begin(sorter, back);

    divider.node = route->next;
    divider.mover = route->mover;
    divider.ref = &route->scene->nodes[route->next].split;
    divider.entry = LIM_NONE;
    divider.eye_side = eye_side;
    if (LIM_HAS_FAR_MOVERS && lim_scene_long(route->scene))
        lim_plane_unpack_far(&divider.own, route->eye, divider.ref);
    else
        lim_plane_unpack(&divider.own, route->scene, divider.ref);
    divider.plane = divider.own;
    if (route->mover != LIM_NONE) lim_mover_turn(sorter->movers, route->mover, &divider.plane);
    if (find_sides(sorter, &divider, list)) decide(sorter, &divider, route, list);
    while (list != LIM_NONE) {
        const uint16_t entry = list;
        list = sorter->list[entry].next;
        mover_split_one(sorter, &divider, entry, &fronts, &backs);
    }
}

#endif
