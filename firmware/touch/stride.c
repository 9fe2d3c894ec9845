/* SPDX-License-Identifier: MIT
 *
 * A walker's move: on the level, over a step, and down. It is tried on the level first. Where that is stopped it is
 * tried a step higher, and set down there. That way counts if it goes further, unless it comes down on something too
 * steep to stand on. Ground is what is no steeper than 45 degrees. */
#include "collide.h"
#include "math/fixed.h"
#include "touch/slide.h"

struct stride {
    const struct lim_solid *solid;
    int32_t half_q8[3];
    int32_t from_q8[3]; /* the middle of its box, before */
    int32_t at_q8[3];   /* and where it has come to */
    bool is_out;        /* of range, on its way */
};

static bool is_ground(const int16_t n[3])
{
    const int32_t up = (int32_t)n[1] * n[1];

    return n[1] > 0 && (uint32_t)((int32_t)n[0] * n[0]) + (uint32_t)((int32_t)n[2] * n[2]) <= (uint32_t)up;
}

/* Up or down by that, as far as it goes: whether something is in the way, and *ground, whether that is ground. */
static bool lift(struct stride *stride, int32_t at_q8[3], int32_t by_q8, bool *ground)
{
    const int32_t to_q8[3] = {at_q8[0], at_q8[1] + by_q8, at_q8[2]};
    struct lim_hit hit;
    const int stopped = lim_sweep(stride->solid, stride->half_q8, at_q8, to_q8, 0, &hit);

    if (stopped < 0) {
        stride->is_out = true;
        return false;
    }
    at_q8[1] = hit.at_q8[1];
    *ground = stopped && is_ground(hit.normal);
    return stopped;
}

/* Whether it was stopped. */
static bool go_on_level(struct stride *stride, int32_t at_q8[3], const int32_t way_q8[3])
{
    const int stops = lim_slide_by(stride->solid, stride->half_q8, at_q8, way_q8, 0, true);

    stride->is_out = stride->is_out || stops < 0;
    return stops > 0;
}

static uint64_t square_gone(const struct stride *stride, const int32_t at_q8[3])
{
    const int64_t x_q8 = at_q8[0] - stride->from_q8[0], z_q8 = at_q8[2] - stride->from_q8[2];

    return (uint64_t)(x_q8 * x_q8) + (uint64_t)(z_q8 * z_q8);
}

static void try_step(struct stride *stride, const int32_t way_q8[3], int32_t step_q8)
{
    int32_t at_q8[3] = {stride->from_q8[0], stride->from_q8[1], stride->from_q8[2]};
    bool ground = false;

    lift(stride, at_q8, step_q8, &ground);
    const int32_t raised_q8 = at_q8[1] - stride->from_q8[1];
    go_on_level(stride, at_q8, way_q8);
    if (square_gone(stride, at_q8) <= square_gone(stride, stride->at_q8)) return;
    if (lift(stride, at_q8, -raised_q8, &ground) && !ground) return;
    for (uint_fast8_t i = 0; i < 3; i++)
        stride->at_q8[i] = at_q8[i];
}

/* Stays on ground that goes down by a step at most. */
static bool keeps_ground(struct stride *stride, int32_t step_q8)
{
    int32_t at_q8[3] = {stride->at_q8[0], stride->at_q8[1], stride->at_q8[2]};
    bool ground = false;

    lift(stride, at_q8, -(step_q8 + LIM_SKIN_Q8), &ground);
    if (!ground) return false;
    stride->at_q8[1] = at_q8[1];
    return true;
}

/* Beside what is no ground it goes on falling; a ceiling ends a jump. */
static void fall(struct stride *stride, struct lim_walker *walker)
{
    const int32_t faster_q8 = walker->fall_q8 + walker->gravity_q8, before_q8 = stride->at_q8[1];
    bool ground = false;

    walker->fall_q8 = faster_q8 < LIM_FALL_MAX_Q8 ? faster_q8 : LIM_FALL_MAX_Q8;
    const bool stopped = lift(stride, stride->at_q8, -walker->fall_q8, &ground);
    walker->stands = ground;
    if (stopped && !ground && walker->fall_q8 > 0) {
        const int32_t left_q8[3] = {0, before_q8 - walker->fall_q8 - stride->at_q8[1], 0};
        if (lim_slide_by(stride->solid, stride->half_q8, stride->at_q8, left_q8, 0, false) < 0) stride->is_out = true;
    } else if (stopped) {
        walker->fall_q8 = 0;
    }
}

static bool is_walker_in_range(const struct lim_walker *walker, int32_t x_q8, int32_t z_q8)
{
    return abs_s32(x_q8) < LIM_WALKER_WAY_MAX_Q8 && abs_s32(z_q8) < LIM_WALKER_WAY_MAX_Q8 && walker->radius_q8 > 0 &&
           walker->radius_q8 <= LIM_HALF_MAX_Q8 && walker->height_q8 > 0 && walker->height_q8 <= 2 * LIM_HALF_MAX_Q8 &&
           walker->step_q8 >= 0 && walker->step_q8 < walker->height_q8 && walker->gravity_q8 >= 0 &&
           walker->gravity_q8 <= LIM_GRAVITY_MAX_Q8 && abs_s32(walker->fall_q8) <= LIM_FALL_MAX_Q8 &&
           abs_s32(walker->at_q8[0]) < LIM_BODY_MAX_Q8 && abs_s32(walker->at_q8[1]) < LIM_BODY_MAX_Q8 &&
           abs_s32(walker->at_q8[2]) < LIM_BODY_MAX_Q8;
}

int lim_walker_move(const struct lim_solid *solid, struct lim_walker *walker, int32_t x_q8, int32_t z_q8)
{
    LIM_ASSERT(solid && walker);
    const int32_t way_q8[3] = {x_q8, 0, z_q8};
    struct lim_walker moved = *walker;
    struct stride stride = {.solid = solid};

    if (!is_walker_in_range(walker, x_q8, z_q8)) return LIM_ERR_CAMERA;
    for (uint_fast8_t i = 0; i < 3; i++) {
        stride.half_q8[i] = i == 1 ? (walker->height_q8 + 1) / 2 : walker->radius_q8;
        stride.from_q8[i] = stride.at_q8[i] = walker->at_q8[i] + (i == 1 ? stride.half_q8[1] : 0);
    }
    if ((x_q8 || z_q8) && go_on_level(&stride, stride.at_q8, way_q8) && walker->stands && walker->step_q8)
        try_step(&stride, way_q8, walker->step_q8);
    if (!walker->stands || walker->fall_q8 < 0 || !keeps_ground(&stride, walker->step_q8)) fall(&stride, &moved);
    if (stride.is_out) return LIM_ERR_CAMERA;
    for (uint_fast8_t i = 0; i < 3; i++)
        moved.at_q8[i] = stride.at_q8[i] - (i == 1 ? stride.half_q8[1] : 0);
    *walker = moved;
    return LIM_OK;
}
