/* SPDX-License-Identifier: MIT
 *
 * As ROUTE, with one list of movers for all: each knows the node from which its way to the first place that it reaches
 * to goes on, and that to the last. A node waits on the stack twice: for its run, and for its far subtree. */
#include "movers/meet.h"

#include "eye.h"
#include "movers/axes.h"
#include "movers/mover.h"
#include "movers/mover_long.h"
#include "movers/near_plane.h"
#include "movers/route.h"
#include "screen/project.h"
#include "view/cull.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_MOVERS

/* What reaches so little behind a plane lies in it: a part of a unit, 2^-FLUSH_BITS. */
enum { FLUSH_BITS = LIM_HAS_FRACTIONS ? 6 : 0, MEET_VERTICES_MAX = 96 };

/* Where a mover is on the walk's way: it is due once its first place is reached, and drawn before what it may hide.
 * `first` and `last` are done where they are LIM_NO_INDEX; AT_FAR: that place is the empty one behind their node. */
enum { MEET_DUE = 1, MEET_DRAWN = 2, MEET_FIRST_AT_FAR = 4, MEET_LAST_AT_FAR = 8 };
enum { PENDING_RUN_DONE = 1, PENDING_WATCHED = 2 }; /* struct lim_route_pending.flags */

/* Its box along the scene's axes, as far as the grid reaches. false: it reaches farther. */
static bool meet_box(const struct lim_mover *mover, struct lim_box *box)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t centre = mover->centre_q12[i] >> 12, half = (mover->half_q12[i] >> 12) + 2;
        if (centre < -32768 || centre > 32767 || half > 32768) return false;
        box->centre[i] = (int16_t)centre;
        box->half[i] = (uint16_t)half;
    }
    return true;
}

/* false: it is out of view. Where it is on the screen is known of a box of the scene's grid alone. */
static bool meet_see(const struct lim_route *route, struct lim_mover *mover, const struct lim_cull *open)
{
    const struct lim_target *target = &route->pass->target;
    const bool is_far = LIM_HAS_FAR_MOVERS && lim_movers_are_far(route->movers);
    struct lim_box box;

    mover->rect = (struct lim_rect){0, 0, target->w_px, target->h_px};
    if (LIM_HAS_FAR_MOVERS && is_far)
        lim_mover_far_box(mover, &box);
    else if (!meet_box(mover, &box))
        return true;
    if (LIM_HAS_CULL && !lim_cull_sees(open, &box)) return false;
    if (!LIM_8_BIT && !is_far) /* an AVR's boxes are in flash */
        (void)lim_view_box_rect(&route->pass->view, (const LIM_FLASH struct lim_box *)&box, &mover->rect);
    return true;
}

static void set_crowded(const struct lim_route *route, struct lim_mover *mover)
{
    if (LIM_HAS_STATS && !mover->crowded) lim_stats_of(route->pass)->movers.crowded++;
    mover->crowded = true;
}

void lim_meet_begin(struct lim_route *route, struct lim_pass *pass, struct lim_movers *movers,
                    const struct lim_cull *open)
{
    uint16_t *end = &route->list;

    route->pass = pass;
    route->movers = movers;
    route->scene = pass->scene;
    route->eye = lim_eye_of(pass);
    route->cull = lim_cull_of(pass);
    route->shown = pass->walk->shown;
    route->stack = movers->stack;
    route->depth = 0;
    route->next = route->scene->node_count ? 0 : LIM_NO_INDEX;
    for (uint16_t i = 0; i < movers->count; i++) {
        struct lim_mover *const mover = &movers->movers[i];
        mover->met = LIM_MET_BEHIND;
        mover->stage = 0;
        if (mover->radius_q12 < 0) continue;
        if (!meet_see(route, mover, open)) {
            if (LIM_HAS_STATS) lim_stats_of(pass)->movers.hidden++;
            continue;
        }
        mover->first = mover->last = route->next;
        mover->stage = route->next == LIM_NO_INDEX ? MEET_DUE : 0;
        mover->crowded = false;
        mover->against = 0;
        if (lim_mover_is_loose(movers, i)) {
            set_crowded(route, mover);
            mover->against = lim_mover_bit(i);
        }
        *end = i;
        end = &mover->next;
    }
    *end = LIM_NONE;
}

static struct lim_mover *meet_first(const struct lim_route *route)
{
    return route->list == LIM_NONE ? NULL : &route->movers->movers[route->list];
}

static struct lim_mover *meet_after(const struct lim_route *route, const struct lim_mover *mover)
{
    return mover->next == LIM_NONE ? NULL : &route->movers->movers[mover->next];
}

static void load_plane(const struct lim_route *route, struct lim_plane_unpacked *plane,
                       const LIM_FLASH struct lim_plane_ref *ref)
{
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(route->movers))
        lim_plane_unpack_far(plane, route->eye, ref);
    else
        lim_plane_unpack(plane, route->scene, ref);
}

/* How far a mover reaches from its centre along a plane's normal, by its ball or by its box. */
static int64_t meet_reach(const struct lim_mover *mover, const struct lim_plane_unpacked *plane)
{
    uint32_t longest = 0, sum = 0;
    int64_t box = 0;

    if (plane->axis != LIM_NO_AXIS) return mover->half_q12[plane->axis];
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint32_t n = abs_s32(plane->n[i]);
        if (n > longest) longest = n;
        sum += n;
        box += (int64_t)n * mover->half_q12[i];
    }
    /* As in mover.c, the normal's length. */
    const int64_t length = longest + (int64_t)(sum - longest) * 107 / 256 + 1;
    const int64_t ball = length * mover->radius_q12;
    return ball < box ? ball : box;
}

/* How far in front of a plane the vertices are: the least and the most, in 2^-37 of what 2^29 / n is. */
static uint8_t meet_vertices(const struct lim_instance *instance, const struct lim_plane_unpacked *plane,
                             int64_t *least, int64_t *most)
{
    const struct lim_scene *const object = instance->object;
    const uint32_t bits = abs_s32(plane->n[0]) | abs_s32(plane->n[1]) | abs_s32(plane->n[2]);
    const uint8_t up = (uint8_t)(clz_u32(bits | 1) - 2);
    int64_t from_q8 = -plane->d * (INT64_C(256) << up);
    int32_t n[3];

    for (uint_fast8_t i = 0; i < 3; i++) {
        n[i] = (int32_t)(lim_along_axis(instance, i, plane->n) >> (30 - up));
        from_q8 += (int64_t)plane->n[i] * (INT64_C(1) << up) * instance->at_q8[i];
    }
    *least = INT64_MAX;
    *most = INT64_MIN;
    for (lim_index k = 0; k < object->vertex_count; k++) {
        int32_t at[3];
        lim_corner_load(at, object, k);
        const int64_t along =
            ((int64_t)n[0] * at[0] + (int64_t)n[1] * at[1] + (int64_t)n[2] * at[2]) >> instance->finer_bits;
        const int64_t value_q8 = from_q8 + along * (LIM_HAS_FRACTIONS ? 1 : 256);
        if (value_q8 < *least) *least = value_q8;
        if (value_q8 > *most) *most = value_q8;
    }
    return up;
}

/* Of a polygon, or a node, in a plane: what reaches it, a face of a mover may lie in. */
static enum lim_met met_in_frame(const struct lim_movers *movers, const struct lim_mover *mover,
                                 const struct lim_plane_unpacked *plane, bool eye_in_front)
{
    const struct lim_instance *const instance = &movers->instances[mover - movers->movers];
    const int64_t value = lim_corner_value(plane, mover->centre_q12), near = eye_in_front ? value : -value;
    const int64_t reach = meet_reach(mover, plane), slack = plane->slack * LIM_CORNER_ONE_Q12 >> FLUSH_BITS;
    int64_t least, most;

    if (near >= reach - slack) return LIM_MET_BEHIND;
    if (near < -reach - slack) return LIM_MET_BEFORE;
    if (instance->object->vertex_count > MEET_VERTICES_MAX) return LIM_MET_THROUGH;
    const uint8_t up = meet_vertices(instance, plane, &least, &most);
    const int64_t slack_q8 = (slack >> 4) * (INT64_C(1) << up);
    if ((eye_in_front ? least : -most) >= -slack_q8) return LIM_MET_BEHIND;
    return (eye_in_front ? most : -least) < -slack_q8 ? LIM_MET_BEFORE : LIM_MET_THROUGH;
}

/* The same of a plane of the static scene. */
static enum lim_met met_by(const struct lim_movers *movers, const struct lim_mover *mover,
                           const struct lim_plane_unpacked *plane, bool eye_in_front)
{
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) {
        struct lim_plane_unpacked brought = *plane;
        lim_plane_bring(&brought, movers, LIM_NONE, (uint16_t)(mover - movers->movers));
        return met_in_frame(movers, mover, &brought, eye_in_front);
    }
    return met_in_frame(movers, mover, plane, eye_in_front);
}

/* A mover's ways go on to the near subtree of a node, to the far one, or to both. Whether one ends behind it. */
static bool meet_go_on(struct lim_mover *mover, lim_index self, enum lim_met met, lim_index near, lim_index far)
{
    if (mover->first == self) {
        mover->first = met == LIM_MET_BEFORE ? far : near;
        if (mover->first == LIM_NO_INDEX && met == LIM_MET_BEFORE) {
            mover->first = self;
            mover->stage |= MEET_FIRST_AT_FAR;
        } else if (mover->first == LIM_NO_INDEX) {
            mover->stage |= MEET_DUE;
        }
    }
    if (mover->last == self) {
        mover->last = met == LIM_MET_BEHIND ? near : far;
        if (mover->last == LIM_NO_INDEX && met != LIM_MET_BEHIND) {
            mover->last = self;
            mover->stage |= MEET_LAST_AT_FAR;
        }
    }
    return mover->first == self || mover->last == self;
}

static bool go_on_all(const struct lim_route *route, const LIM_FLASH struct lim_node *node, int32_t side)
{
    const lim_index near = side > 0 ? node->front : node->back, far = side > 0 ? node->back : node->front;
    struct lim_plane_unpacked plane;
    bool has_plane = false, ends = false;

    for (struct lim_mover *mover = meet_first(route); mover; mover = meet_after(route, mover)) {
        if (mover->first != route->next && mover->last != route->next) continue;
        if (!has_plane) load_plane(route, &plane, &node->split);
        has_plane = true;
        ends |= meet_go_on(mover, route->next, met_by(route->movers, mover, &plane, side > 0), near, far);
    }
    return ends;
}

/* What is not entered, a leaf, or what has been left: what was on its way there has come, or is past it. */
static void arrive(const struct lim_route *route, lim_index node, bool comes, bool is_past)
{
    for (struct lim_mover *mover = meet_first(route); mover; mover = meet_after(route, mover)) {
        if (comes && mover->first == node) {
            mover->first = LIM_NO_INDEX;
            mover->stage |= MEET_DUE;
        }
        if (is_past && mover->last == node) mover->last = LIM_NO_INDEX;
    }
}

static void meet_enter(struct lim_route *route)
{
    const lim_index self = route->next;
    const LIM_FLASH struct lim_node *node = lim_route_node_to_enter(route);

    if (!node) {
        arrive(route, self, true, true);
        return;
    }
    if (lim_node_is_leaf(node)) {
        arrive(route, self, true, false);
        route->stack[route->depth++] = (struct lim_route_pending){self, PENDING_WATCHED, 1};
        route->next = LIM_NO_INDEX;
        return;
    }
    const int32_t side = lim_route_side(route, node);
    const bool is_watched = go_on_all(route, node, side);
    route->stack[route->depth++] =
        (struct lim_route_pending){self, is_watched ? PENDING_WATCHED : 0, (int8_t)((side > 0) - (side < 0))};
    route->next = side > 0 ? node->front : node->back;
}

/* Those that are drawn, or will be, and may share pixels with the next one: they have to be before it, or behind. */
static void meet_mover(const struct lim_route *route, struct lim_mover *self)
{
    struct lim_movers *const movers = route->movers;
    const uint16_t next = (uint16_t)(self - movers->movers);

    for (uint16_t number = 0; number < movers->count; number++) {
        struct lim_mover *const other = &movers->movers[number];
        const bool is_drawn = other->stage & MEET_DRAWN;
        if (other == self || !(other->stage & (MEET_DUE | MEET_DRAWN)) || !lim_rects_meet(&self->rect, &other->rect) ||
            lim_mover_precedes(movers, is_drawn ? number : next, is_drawn ? next : number))
            continue;
        set_crowded(route, self);
        set_crowded(route, other);
        self->against |= lim_mover_bit(number);
        other->against |= lim_mover_bit(next);
    }
}

/* Of those that are due, one that nothing hides of: itself, if there is no order. */
static struct lim_mover *nearest_due(const struct lim_route *route, struct lim_mover *mover)
{
    const struct lim_movers *const movers = route->movers;

    for (struct lim_mover *other = meet_first(route); other; other = meet_after(route, other)) {
        const uint16_t a = (uint16_t)(mover - movers->movers), b = (uint16_t)(other - movers->movers);
        if (a == b || !(other->stage & MEET_DUE) || !lim_rects_meet(&mover->rect, &other->rect)) continue;
        if (!lim_mover_precedes(movers, a, b) && lim_mover_precedes(movers, b, a)) mover = other;
    }
    return mover;
}

/* It is drawn next, or what is due and nearer. */
static uint16_t meet_draw(const struct lim_route *route, struct lim_mover *mover)
{
    mover = nearest_due(route, mover);
    meet_mover(route, mover);
    mover->stage = (uint8_t)((mover->stage & ~MEET_DUE) | MEET_DRAWN);
    return (uint16_t)(mover - route->movers->movers);
}

/* A mover that is due and that the walk leaves behind; those that are past fall out of the list. LIM_NONE: none is. */
static uint16_t take_due(struct lim_route *route)
{
    for (struct lim_mover *mover = meet_first(route); mover; mover = meet_after(route, mover))
        if (mover->stage & MEET_DUE && mover->last == LIM_NO_INDEX) return meet_draw(route, mover);
    for (uint16_t *link = &route->list; *link != LIM_NONE;) {
        struct lim_mover *const mover = &route->movers->movers[*link];
        if (mover->last == LIM_NO_INDEX && mover->stage & MEET_DRAWN) {
            mover->met = LIM_MET_BEHIND;
            *link = mover->next;
        } else {
            link = &mover->next;
        }
    }
    return LIM_NONE;
}

/* The node on top of the stack has its run, then its far subtree. */
static lim_index go_back(struct lim_route *route)
{
    struct lim_route_pending *const top = &route->stack[route->depth - 1];
    const LIM_FLASH struct lim_node *const node = &route->scene->nodes[top->node];
    const bool is_leaf = lim_node_is_leaf(node);

    route->node = top->node;
    route->side = top->side;
    if (!(top->flags & PENDING_RUN_DONE)) {
        top->flags |= PENDING_RUN_DONE;
        if (is_leaf) return node->front_run;
        return top->side > 0 ? node->front_run : top->side < 0 ? node->back_run : (lim_index)LIM_NO_INDEX;
    }
    route->depth--;
    if (top->flags & PENDING_WATCHED) arrive(route, top->node, true, true);
    route->next = is_leaf ? (lim_index)LIM_NO_INDEX : top->side > 0 ? node->back : node->front;
    return LIM_NO_INDEX;
}

enum lim_meet_event lim_meet_next(struct lim_route *route, lim_index *what)
{
    for (;;) {
        *what = take_due(route);
        if (*what != LIM_NONE) return LIM_MEET_MOVER;
        if (route->next != LIM_NO_INDEX) {
            meet_enter(route);
        } else if (!route->depth) {
            return LIM_MEET_END;
        } else {
            *what = go_back(route);
            if (*what != LIM_NO_INDEX) return LIM_MEET_RUN;
        }
    }
}

/* A pixel more on each side is for what is rounded. */
static void set_rect(struct lim_rect *rect, const struct lim_point *at, uint8_t n, const struct lim_target *target)
{
    int32_t x0 = at->x, x1 = x0, y0 = at->y, y1 = y0;

    for (const struct lim_point *const end = at + n; ++at != end;) {
        if (at->x < x0) x0 = at->x;
        if (at->x > x1) x1 = at->x;
        if (at->y < y0) y0 = at->y;
        if (at->y > y1) y1 = at->y;
    }
    *rect = (struct lim_rect){lim_view_pixel_within(x0, -1, target->w_px), lim_view_pixel_within(y0, -1, target->h_px),
                              lim_view_pixel_within(x1, 2, target->w_px), lim_view_pixel_within(y1, 2, target->h_px)};
}

/* What of the screen a record may have, before it is projected. false: nothing. */
static bool meet_rect(struct lim_pass *pass, const LIM_FLASH lim_index *record, struct lim_rect *rect)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point at[LIM_MAX_VERTICES];
    const uint_fast16_t codes = lim_project_corners(at, n, &pass->view, pass->scene, record + LIM_POLYGON_HEAD_WORDS);

    if (lim_view_all_outside(codes)) return false;
    if (codes & LIM_VIEW_GUARD)
        *rect = (struct lim_rect){0, 0, pass->target.w_px, pass->target.h_px};
    else
        set_rect(rect, at, n, &pass->target);
    return rect->x0 < rect->x1 && rect->y0 < rect->y1;
}

/* Whether a plane along two of the scene's axes parts a mover from a record, and what that is then. */
static bool met_along_axis(const struct lim_movers *movers, const struct lim_mover *mover,
                           const struct lim_scene *scene, const LIM_FLASH lim_index *record, enum lim_met *met)
{
    const uint_fast8_t n = record[0] & LIM_POLYGON_COUNT;
    int32_t low[3], high[3], at[3];

    lim_corner_load(low, scene, record[LIM_POLYGON_HEAD_WORDS]);
    for (uint_fast8_t i = 0; i < 3; i++)
        high[i] = low[i];
    for (uint_fast8_t k = 1; k < n; k++) {
        lim_corner_load(at, scene, record[LIM_POLYGON_HEAD_WORDS + k]);
        for (uint_fast8_t i = 0; i < 3; i++) {
            if (at[i] < low[i]) low[i] = at[i];
            if (at[i] > high[i]) high[i] = at[i];
        }
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t from = mover->centre_q12[i] - mover->half_q12[i], to = mover->centre_q12[i] + mover->half_q12[i];
        const int32_t eye_q8 = movers->camera.eye_q8[i];
        if (high[i] * LIM_CORNER_LOADED_Q12 <= from)
            *met = eye_q8 <= from >> 4 ? LIM_MET_BEFORE : LIM_MET_BEHIND;
        else if (low[i] * LIM_CORNER_LOADED_Q12 >= to)
            *met = eye_q8 > to >> 4 ? LIM_MET_BEFORE : LIM_MET_BEHIND;
        else
            continue;
        return true;
    }
    return false;
}

/* What a record is to movers that are due or drawn. */
struct meeting {
    struct lim_rect rect;
    struct lim_plane_unpacked plane;
    bool has_rect, has_plane, eye_in_front;
};

static void set_meeting_plane(const struct lim_route *route, const LIM_FLASH lim_index *record, bool of_corners,
                              struct meeting *meeting)
{
    const bool has_own = LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE;

    meeting->has_plane = true;
    if (of_corners) {
        lim_corners_plane(&meeting->plane, route->scene, record);
        meeting->eye_in_front = true;
        return;
    }
    load_plane(route, &meeting->plane, has_own ? lim_record_plane(record) : &route->scene->nodes[route->node].split);
    meeting->eye_in_front = has_own ? !(record[0] & LIM_POLYGON_BACK) : route->side > 0;
}

static enum lim_met meet_one(struct lim_route *route, const struct lim_mover *mover, const LIM_FLASH lim_index *record,
                             bool of_corners, struct meeting *meeting)
{
    enum lim_met met;

    if (!meeting->has_rect && !meet_rect(route->pass, record, &meeting->rect))
        meeting->rect = (struct lim_rect){0, 0, 0, 0};
    meeting->has_rect = true;
    if (!lim_rects_meet(&meeting->rect, &mover->rect)) return LIM_MET_APART;
    if (!meeting->has_plane) set_meeting_plane(route, record, of_corners, meeting);
    met = met_by(route->movers, mover, &meeting->plane, meeting->eye_in_front);
    if (met == LIM_MET_THROUGH && !(LIM_HAS_FAR_MOVERS && lim_movers_are_far(route->movers)))
        (void)met_along_axis(route->movers, mover, route->scene, record, &met);
    return met;
}

bool lim_meet_asks(const struct lim_route *route)
{
    for (const struct lim_mover *mover = meet_first(route); mover; mover = meet_after(route, mover))
        if (mover->stage & (MEET_DUE | MEET_DRAWN)) return true;
    return false;
}

uint16_t lim_meet_before(struct lim_route *route, const LIM_FLASH lim_index *record, bool of_corners, bool *is_any)
{
    struct meeting meeting;

    meeting.has_rect = meeting.has_plane = *is_any = false;
    for (struct lim_mover *mover = meet_first(route); mover; mover = meet_after(route, mover)) {
        mover->met = LIM_MET_BEHIND;
        if (!(mover->stage & (MEET_DUE | MEET_DRAWN))) continue;
        const enum lim_met met = meet_one(route, mover, record, of_corners, &meeting);
        if (mover->stage & MEET_DUE) {
            if (met == LIM_MET_BEHIND || met == LIM_MET_THROUGH) return meet_draw(route, mover);
        } else if (met == LIM_MET_BEFORE || met == LIM_MET_THROUGH) {
            mover->met = (uint8_t)met;
            *is_any = true;
            set_crowded(route, mover);
        }
    }
    return LIM_NONE;
}

enum lim_met lim_met_polygons(const struct lim_pass *pass, struct lim_movers *movers,
                              const struct lim_met_polygon *polygon, const struct lim_met_polygon *still)
{
    const bool is_far = LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers); /* the eye is at 0 */
    const LIM_FLASH lim_index *const record = &movers->instances[polygon->owner].object->polygons[polygon->record];
    const int32_t *const eye_q8 = movers->camera.eye_q8;
    struct lim_plane_unpacked plane;
    int64_t least = INT64_MAX, most = INT64_MIN;

    lim_still_plane(&plane, pass, still->record, still->node);
    if (LIM_HAS_FAR_MOVERS && is_far) lim_plane_bring(&plane, movers, LIM_NONE, polygon->owner);
    const int64_t slack = plane.slack * LIM_CORNER_ONE_Q12 >> FLUSH_BITS;
    const bool eye_in_front = is_far ? plane.d < 0 : lim_plane_value(&plane, eye_q8[0], eye_q8[1], eye_q8[2], 256) > 0;
    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
        const int64_t value =
            lim_corner_value(&plane, lim_mover_corner(movers, polygon->owner, record[LIM_POLYGON_HEAD_WORDS + k]));
        if (value < least) least = value;
        if (value > most) most = value;
    }
    if ((eye_in_front ? least : -most) >= -slack) return LIM_MET_BEHIND;
    return (eye_in_front ? most : -least) <= 0 ? LIM_MET_BEFORE : LIM_MET_THROUGH;
}

#endif
