/* SPDX-License-Identifier: MIT
 *
 * Lists of movers and the planes of the static tree. An entry is an instance as a whole, a polygon of one, or a piece
 * of such a polygon; and a plane that has cut something is an entry too, in no list, for the pieces to remember it.
 * Lists of one instance's polygons keep the order of its own tree, nearest first. Nothing is given back before the next
 * walk. */
#include "routes/mover_split.h"

#include "eye.h"
#include "movers/deform.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/piece.h"
#include "routes/route.h"
#include "view/cull.h"

#if LIM_HAS_MOVERS

/* A list that grows at its end. */
struct queue {
    struct lim_sorted *list;
    uint16_t *head;
    uint16_t last;
};

static struct queue queue_begin(struct lim_sorter *sorter, uint16_t *head)
{
    *head = LIM_NONE;
    return (struct queue){sorter->list, head, LIM_NONE};
}

static void queue_add(struct queue *queue, uint16_t entry)
{
    *(queue->last == LIM_NONE ? queue->head : &queue->list[queue->last].next) = entry;
    queue->list[entry].next = LIM_NONE;
    queue->last = entry;
}

void lim_movers_note_entries(struct lim_sorter *sorter)
{
    const uint16_t used = sorter->used > sorter->newell->cuts_used ? sorter->used : sorter->newell->cuts_used;

    if (LIM_HAS_STATS && used > lim_stats_of(sorter->pass)->movers.entries)
        lim_stats_of(sorter->pass)->movers.entries = used;
}

static uint16_t new_entry(struct lim_sorter *sorter, lim_index record, uint16_t owner, lim_index node)
{

    if (sorter->used == sorter->size) return LIM_NONE;
    sorter->list[sorter->used] = (struct lim_sorted){.record = record, .next = LIM_NONE};
    sorter->newell->polygons[sorter->used] =
        (struct lim_newell_polygon){.node = node, .cuts = LIM_NONE, .owner = owner};
    sorter->used++;
    lim_movers_note_entries(sorter);
    return (uint16_t)(sorter->used - 1);
}

/* Whether the box around the ball, as far as the grid reaches, is in view. */
static bool is_in_view(const struct lim_mover *mover, const struct lim_cull *open)
{
    struct lim_box box;

    if (!LIM_HAS_CULL) return true;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t centre = mover->centre_q12[i] >> 12, half = (mover->radius_q12 >> 12) + 1;
        if (centre < -32768 || centre > 32767 || half > 32768) return true;
        box.centre[i] = (int16_t)centre;
        box.half[i] = (uint16_t)half;
    }
    return lim_cull_sees(open, &box);
}

uint16_t lim_movers_list(struct lim_sorter *sorter, const struct lim_cull *open)
{
    struct lim_movers *movers = sorter->movers;
    uint16_t head;
    struct queue queue = queue_begin(sorter, &head);

    sorter->used = 0;
    sorter->newell->cuts_used = 0;
    for (uint16_t i = 0; i < movers->count; i++) {
        if (movers->movers[i].radius_q12 < 0) continue;
        if (is_in_view(&movers->movers[i], open)) {
            const uint16_t entry = new_entry(sorter, LIM_NO_INDEX, i, LIM_NO_INDEX);
            LIM_DEBUG_ASSERT(entry != LIM_NONE); /* there are as many as instances */
            if (entry != LIM_NONE) queue_add(&queue, entry);
        } else if (LIM_HAS_STATS) {
            lim_stats_of(sorter->pass)->movers.hidden++;
        }
    }
    return head;
}

/* Polygons ----------------------------------------------------------------------------------- */

/* false: no room. */
static bool add_run(struct lim_sorter *sorter, struct queue *queue, const struct lim_route *route, uint16_t mover,
                    lim_index at)
{
    for (;;) {
        const LIM_FLASH lim_index *record = &route->scene->polygons[at];
        const lim_index head = record[0];
        if (lim_record_is_seen(route->eye, record)) {
            const uint16_t entry = new_entry(sorter, at, mover, route->node);
            if (entry == LIM_NONE) return false;
            sorter->newell->polygons[entry].eye_in_front =
                LIM_HAS_LEAVES && head & LIM_POLYGON_PLANE ? !(head & LIM_POLYGON_BACK) : route->side > 0;
            queue_add(queue, entry);
        }
        if (head & LIM_POLYGON_LAST) return true;
        at = (lim_index)(at + lim_record_words(head));
    }
}

/* Every record, wherever in the tree it is: it knows its own plane. */
static LIM_IF_CALLED bool add_deformed(struct lim_sorter *sorter, struct queue *queue, uint16_t mover)
{
    const struct lim_scene *object = sorter->movers->instances[mover].object;

    for (lim_index at = 0; at < object->polygon_words;) {
        const LIM_FLASH lim_index *record = &object->polygons[at];
        if (lim_deform_is_seen(&sorter->movers->movers[mover].eye, record)) {
            const uint16_t entry = new_entry(sorter, at, mover, 0);
            if (entry == LIM_NONE) return false;
            sorter->newell->polygons[entry].eye_in_front = true;
            queue_add(queue, entry);
        }
        at = (lim_index)(at + lim_record_words(record[0]));
    }
    return true;
}

static bool add_by_tree(struct lim_sorter *sorter, struct queue *queue, uint16_t mover)
{
    const struct lim_rect screen = {0, 0, sorter->pass->target.w_px, sorter->pass->target.h_px};
    struct lim_route route = lim_route_object(sorter, mover, &screen, false);
    lim_index run;

    while (lim_route_next_alone(&route, &run))
        if (!add_run(sorter, queue, &route, mover, run)) return false;
    return true;
}

bool lim_mover_burst(struct lim_sorter *sorter, uint16_t entry, uint16_t *list)
{
    const uint16_t used = sorter->used, rest = sorter->list[entry].next;
    const uint16_t mover = lim_entry_owner(sorter, entry);
    const bool deforms = lim_deforms(&sorter->movers->instances[mover]);
    uint16_t head;
    struct queue queue = queue_begin(sorter, &head);

    const bool has_room =
        LIM_HAS_DEFORM && deforms ? add_deformed(sorter, &queue, mover) : add_by_tree(sorter, &queue, mover);

    if (!has_room) {
        sorter->used = used;
        return false;
    }
    *(queue.last == LIM_NONE ? &head : &sorter->list[queue.last].next) = rest;
    *list = head;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.divided++;
    return true;
}

static bool has_centres(const struct lim_sorter *sorter, uint16_t list)
{
    for (; list != LIM_NONE; list = sorter->list[list].next)
        if (lim_mover_is_whole(sorter, list) && sorter->movers->instances[lim_entry_owner(sorter, list)].by_centre)
            return true;
    return false;
}

bool lim_movers_join(struct lim_sorter *sorter, lim_index run, uint16_t list)
{
    const struct lim_route leaf = {.scene = sorter->pass->scene, .eye = lim_eye_of(sorter->pass), .node = LIM_NO_INDEX};
    const uint16_t used = sorter->used;
    uint16_t head, last = list;
    struct queue queue = queue_begin(sorter, &head);

    if (has_centres(sorter, list)) return false;
    if (!add_run(sorter, &queue, &leaf, LIM_NONE, run)) {
        sorter->used = used;
        return false;
    }
    while (sorter->list[last].next != LIM_NONE)
        last = sorter->list[last].next;
    sorter->list[last].next = head;
    return true;
}

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

/* The ball of a whole instance against a plane. */
static uint8_t sides_of_ball(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);
    const struct lim_mover *mover = &sorter->movers->movers[owner];
    const int64_t value = lim_corner_value(plane, mover->centre_q12);
    uint32_t longest = 0;

    if (sorter->movers->instances[owner].by_centre) return value > 0 ? LIM_SIDE_FRONT : value < 0 ? LIM_SIDE_BACK : 0;
    for (uint_fast8_t i = 0; i < 3; i++)
        if (abs_s32(plane->n[i]) > longest) longest = abs_s32(plane->n[i]);
    /* As in movers.c, the normal's length. */
    const int64_t length = longest + (plane->slack - longest) * 107 / 256 + 1;
    const int64_t reach = length * mover->radius_q12;
    return value > reach ? LIM_SIDE_FRONT : value < -reach ? LIM_SIDE_BACK : LIM_SIDE_BOTH;
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

/* The piece in front stays `entry`. Returns the other one, or LIM_NONE: no room. */
static uint16_t mover_split_split(struct lim_sorter *sorter, struct divider *divider, uint16_t entry)
{
    if (divider->entry == LIM_NONE) divider->entry = new_entry(sorter, LIM_NO_INDEX, LIM_NONE, divider->node);
    if (divider->entry == LIM_NONE) return LIM_NONE;
    const uint16_t other = lim_piece_split(sorter, entry, divider->entry);
    if (other == LIM_NONE) return LIM_NONE;
    lim_movers_note_entries(sorter);
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.pieces++;
    return other;
}

static uint8_t sides_of(const struct lim_sorter *sorter, struct divider *divider, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    if (lim_mover_is_whole(sorter, entry)) return sides_of_ball(sorter, entry, &divider->plane);
    if (owner != LIM_NONE) {
        if (owner != divider->owner) turn_to(sorter, divider, owner);
        const uint8_t side = certain_side(sorter, divider, entry);
        if (side) return side;
    }
    return lim_piece_sides_of(sorter, entry, &divider->plane);
}

/* Adds an entry that reaches to neither, one, or both sides. */
static void mover_split_one(struct lim_sorter *sorter, struct divider *divider, uint16_t entry, uint8_t sides,
                            struct queue *front, struct queue *back)
{
    if (sides == LIM_SIDE_BOTH) {
        const uint16_t other =
            lim_mover_is_whole(sorter, entry) ? (uint16_t)LIM_NONE : mover_split_split(sorter, divider, entry);
        if (other != LIM_NONE) {
            queue_add(front, entry);
            queue_add(back, other);
            return;
        }
        if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.forced++;
        sides = heavier_side(sorter, entry, &divider->plane);
    }
    if (!sides) sides = divider->eye_side > 0 ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
    queue_add(sides == LIM_SIDE_FRONT ? front : back, entry);
}

void lim_movers_divide(struct lim_sorter *sorter, lim_index node, int32_t eye_side, uint16_t list, uint16_t *front,
                       uint16_t *back)
{
    struct divider divider = {.node = node, .entry = LIM_NONE, .eye_side = eye_side, .owner = LIM_NONE};
    struct queue fronts = queue_begin(sorter, front), backs = queue_begin(sorter, back);

    lim_plane_unpack(&divider.plane, sorter->pass->scene, &sorter->pass->scene->nodes[node].split);
    while (list != LIM_NONE) {
        const uint16_t entry = list;
        const uint8_t sides = sides_of(sorter, &divider, entry);
        if (sides == LIM_SIDE_BOTH && lim_mover_is_whole(sorter, entry) && lim_mover_burst(sorter, entry, &list))
            continue;
        list = sorter->list[entry].next;
        mover_split_one(sorter, &divider, entry, sides, &fronts, &backs);
    }
}

#endif
