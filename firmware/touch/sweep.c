/* SPDX-License-Identifier: MIT
 *
 * A box against the polygons that DESCENT gives: the first CONTACT, less the skin. Where that is must be rounded, and
 * the rounded way is another one than was tried; so it is tried in its turn, which has an end without rounding. */
#include "collide.h"
#include "eye.h"
#include "math/wide.h"
#include "touch/contact.h"
#include "touch/descent.h"
#include "view/plane_unpacked.h"

enum { SWEEP_TRIES = 4 };

struct sweep {
    struct lim_mover_box box;
    struct lim_contact first;
    lim_index record; /* of the first; LIM_NO_INDEX: there is none */
    bool backs;
};

/* On which side of a plane its middle is when it begins. */
static int32_t side_at_begin(const struct sweep *sweep, const struct lim_plane_unpacked *plane)
{
    const int64_t value = lim_plane_value_q8(plane, sweep->box.from_q8);

    return (value > 0) - (value < 0);
}

static void try_record(struct sweep *sweep, const LIM_FLASH lim_index *record, const struct lim_plane_unpacked *plane,
                       bool from_back)
{
    struct lim_contact contact;

    if (!lim_contact_find(&sweep->box, record, plane, from_back, &contact)) return;
    if (sweep->record != LIM_NO_INDEX &&
        lim_wide_compare(contact.num, sweep->first.den, sweep->first.num, contact.den) >= 0)
        return;
    sweep->first = contact;
    sweep->record = (lim_index)(record - sweep->box.scene->polygons);
}

/* Whether polygons of a facing stop who begins on that side of their plane. */
static bool stops(const struct sweep *sweep, bool back, int32_t side)
{
    return sweep->backs || (back ? side <= 0 : side >= 0);
}

static void sweep_run(struct sweep *sweep, lim_index run, bool back, const struct lim_plane_unpacked *plane,
                      int32_t side)
{
    const LIM_FLASH lim_index *record = sweep->box.scene->polygons + run;

    if (run == LIM_NO_INDEX || !stops(sweep, back, side)) return;
    for (;; record += lim_record_words(record[0])) {
        try_record(sweep, record, plane, side ? side < 0 : back);
        if (record[0] & LIM_POLYGON_LAST) return;
    }
}

static void sweep_node(struct sweep *sweep, const LIM_FLASH struct lim_node *node)
{
    struct lim_plane_unpacked plane;

    if (node->front_run == LIM_NO_INDEX && node->back_run == LIM_NO_INDEX) return;
    lim_plane_unpack(&plane, sweep->box.scene, &node->split);
    const int32_t side = side_at_begin(sweep, &plane);
    sweep_run(sweep, node->front_run, false, &plane, side);
    sweep_run(sweep, node->back_run, true, &plane, side);
}

static void sweep_leaf(struct sweep *sweep, const LIM_FLASH struct lim_node *node)
{
    const LIM_FLASH lim_index *record = sweep->box.scene->polygons + node->front_run;

    for (;; record += lim_record_words(record[0])) {
        const bool back = record[0] & LIM_POLYGON_BACK;
        struct lim_plane_unpacked plane;
        if (lim_descent_plane(&plane, sweep->box.scene, record)) {
            const int32_t side = side_at_begin(sweep, &plane);
            if (stops(sweep, back, side)) try_record(sweep, record, &plane, side ? side < 0 : back);
        }
        if (record[0] & LIM_POLYGON_LAST) return;
    }
}

/* The first contact on the way to a point. */
static void sweep_to(struct sweep *sweep, const struct lim_solid *solid, const int32_t to_q8[3])
{
    struct lim_descent descent;
    const LIM_FLASH struct lim_node *node;

    sweep->record = LIM_NO_INDEX;
    for (uint_fast8_t i = 0; i < 3; i++)
        sweep->box.way_q8[i] = to_q8[i] - sweep->box.from_q8[i];
    lim_descent_begin(&descent, solid, sweep->box.from_q8, to_q8, sweep->box.half_q8);
    sweep->box.low = descent.low;
    sweep->box.high = descent.high;
    while ((node = lim_descent_next(&descent))) {
        const lim_index record = sweep->record;
        if (lim_node_is_leaf(node))
            sweep_leaf(sweep, node);
        else
            sweep_node(sweep, node);
        if (sweep->record != record)
            lim_descent_shorten(&descent, sweep->box.way_q8, lim_part_q30(sweep->first.num, sweep->first.den));
    }
}

/* Less the skin along the axis, and less what rounding a point may bring it nearer, less than 1 along each. */
static uint32_t part_before(const struct lim_contact *contact)
{
    const uint64_t sizes = (uint64_t)abs_s32(contact->axis[0]) + abs_s32(contact->axis[1]) + abs_s32(contact->axis[2]);
    const uint64_t less = sizes * (LIM_SKIN_Q8 + 1);

    return contact->num > less ? lim_part_q30(contact->num - less, contact->den) : 0;
}

static bool is_body_in_range(const int32_t half_q8[3], const int32_t from_q8[3], const int32_t to_q8[3])
{
    bool in = true;

    for (uint_fast8_t i = 0; i < 3; i++)
        in = in && abs_s32(from_q8[i]) < LIM_BODY_MAX_Q8 && abs_s32(to_q8[i]) < LIM_BODY_MAX_Q8 && half_q8[i] > 0 &&
             half_q8[i] <= LIM_HALF_MAX_Q8;
    return in;
}

/* Where it is stopped becomes where it is to go, until nothing stops it: then it is there. */
static bool sweep_until_free(struct sweep *sweep, const struct lim_solid *solid, const int32_t to_q8[3],
                             struct lim_hit *hit)
{
    bool moves = true;

    for (uint_fast8_t i = 0; i < 3; i++)
        hit->at_q8[i] = to_q8[i];
    hit->part_q30 = UINT32_C(1) << 30;
    hit->record = LIM_NO_INDEX;
    for (uint_fast8_t tries = 0; moves && tries < SWEEP_TRIES; tries++) {
        sweep_to(sweep, solid, hit->at_q8);
        if (sweep->record == LIM_NO_INDEX) return hit->record != LIM_NO_INDEX;
        const uint32_t part_q30 = part_before(&sweep->first);
        if (hit->record == LIM_NO_INDEX) {
            hit->record = sweep->record;
            lim_hit_normal(sweep->first.axis, false, hit->normal);
        }
        hit->part_q30 = (uint32_t)(((uint64_t)hit->part_q30 * part_q30) >> 30);
        moves = false;
        for (uint_fast8_t i = 0; i < 3; i++) {
            const int32_t step_q8 = lim_part_of(sweep->box.way_q8[i], part_q30);
            hit->at_q8[i] = sweep->box.from_q8[i] + step_q8;
            moves = moves || step_q8;
        }
    }
    hit->part_q30 = 0;
    for (uint_fast8_t i = 0; i < 3; i++)
        hit->at_q8[i] = sweep->box.from_q8[i];
    return true;
}

int lim_sweep(const struct lim_solid *solid, const int32_t half_q8[3], const int32_t from_q8[3], const int32_t to_q8[3],
              uint8_t flags, struct lim_hit *hit)
{
    LIM_ASSERT(solid && half_q8 && from_q8 && to_q8 && hit);
    struct sweep sweep = {.box.scene = solid->scene, .backs = flags & LIM_STOP_BACKS};

    if (!is_body_in_range(half_q8, from_q8, to_q8)) return LIM_ERR_CAMERA;
    for (uint_fast8_t i = 0; i < 3; i++) {
        sweep.box.from_q8[i] = from_q8[i];
        sweep.box.half_q8[i] = half_q8[i];
    }
    return sweep_until_free(&sweep, solid, to_q8, hit);
}
