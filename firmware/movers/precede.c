/* SPDX-License-Identifier: MIT
 *
 * Which of two movers is nearer: a plane between them says so, if there is one. Some are tried. In: posed movers. */
#include "movers/mover.h"

#include "movers/mover_long.h"

#if LIM_HAS_MOVERS

/* As in rows.c, no less than a length. */
static uint32_t length_above(const int32_t v[3])
{
    uint32_t longest = 0, sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        sum += abs_s32(v[i]);
        if (abs_s32(v[i]) > longest) longest = abs_s32(v[i]);
    }
    return longest + (uint32_t)(((uint64_t)(sum - longest) * 107) >> 8) + 1;
}

/* Nearer by all of its ball. */
static bool is_nearer(const struct lim_movers *movers, uint16_t a, uint16_t b)
{
    const int32_t far = lim_mover_depth(movers, movers->movers[a].centre_q12) + (movers->movers[a].radius_q12 >> 3);
    const int32_t near = lim_mover_depth(movers, movers->movers[b].centre_q12) - (movers->movers[b].radius_q12 >> 3);

    return far <= near;
}

/* Whether a plane along two of the scene's axes has all of `b` on the side where the eye is not, and all of `a` on the
 * eye's. */
static bool is_before_along_axis(const struct lim_movers *movers, const struct lim_mover *a, const struct lim_mover *b)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t away_q12 = b->centre_q12[i] - a->centre_q12[i];
        if ((int32_t)abs_s32(away_q12) < a->half_q12[i] + b->half_q12[i]) continue;
        const int32_t end_q8 = (b->centre_q12[i] + (away_q12 > 0 ? -b->half_q12[i] : b->half_q12[i])) >> 4;
        if (away_q12 > 0 ? movers->camera.eye_q8[i] <= end_q8 : movers->camera.eye_q8[i] > end_q8) return true;
    }
    return false;
}

/* A ball beside a box, as the box has it: along its own axes, from its centre. */
struct beside {
    int32_t ball_q8[3], eye_q8[3], half_q8[3];
    int64_t radius_q8; /* two units are for all that is rounded */
};

/* Whether a plane along two of the box's axes parts them, and the eye is on the box's side, or on the ball's. */
static bool is_parted_along_axis(const struct beside *beside, bool eye_beside_box)
{
    for (uint_fast8_t j = 0; j < 3; j++) {
        const int64_t end_q8 = (int64_t)abs_s32(beside->ball_q8[j]) - beside->radius_q8;
        const int32_t to_eye_q8 = beside->ball_q8[j] < 0 ? -beside->eye_q8[j] : beside->eye_q8[j];
        if (end_q8 < beside->half_q8[j]) continue;
        if (eye_beside_box ? to_eye_q8 <= end_q8 : to_eye_q8 >= beside->half_q8[j]) return true;
    }
    return false;
}

/* The same of a plane upright on the way from the box to the ball's centre. */
static bool is_parted_along_way(const struct beside *beside, bool eye_beside_box)
{
    int64_t square = 0, eye = 0; /* of the way, and along it */
    int32_t way_q8[3];

    for (uint_fast8_t j = 0; j < 3; j++) {
        const int32_t half_q8 = beside->half_q8[j], ball_q8 = beside->ball_q8[j];
        const int32_t from_q8 = ball_q8 > half_q8 ? half_q8 : ball_q8 < -half_q8 ? -half_q8 : ball_q8;
        way_q8[j] = ball_q8 - from_q8;
        square += (int64_t)way_q8[j] * way_q8[j];
        eye += (int64_t)way_q8[j] * ((int64_t)beside->eye_q8[j] - from_q8);
    }
    if (square < beside->radius_q8 * beside->radius_q8) return false;
    return eye_beside_box ? eye <= square - beside->radius_q8 * length_above(way_q8) : eye >= 0;
}

/* Whether a plane parts a mover's own box from the ball of another one, with the eye on the side of the box, or on the
 * ball's. */
static bool is_parted(const struct lim_movers *movers, uint16_t of, uint16_t ball, bool eye_beside_box)
{
    const struct lim_mover *mover = &movers->movers[of], *other = &movers->movers[ball];
    int32_t away_q8[3], to_eye_q8[3];
    struct beside beside; /* filled in below: an initialiser would be a call of memset() */

    beside.radius_q8 = (other->radius_q12 >> 4) + 512;
    for (uint_fast8_t i = 0; i < 3; i++) {
        away_q8[i] = (other->centre_q12[i] >> 4) - (mover->centre_q12[i] >> 4);
        to_eye_q8[i] = movers->camera.eye_q8[i] - (mover->centre_q12[i] >> 4);
    }
    for (uint_fast8_t j = 0; j < 3; j++) {
        beside.ball_q8[j] = (int32_t)(lim_along_axis(&movers->instances[of], j, away_q8) >> 30);
        beside.eye_q8[j] = (int32_t)(lim_along_axis(&movers->instances[of], j, to_eye_q8) >> 30);
        beside.half_q8[j] = mover->own_half_q12[j] >> 4;
    }
    return is_parted_along_axis(&beside, eye_beside_box) || is_parted_along_way(&beside, eye_beside_box);
}

/* In a long scene: a mover in the frame of another one, whose units are as large as its own or larger. */
struct in_frame {
    const struct lim_instance *instance;
    int32_t centre_q12[3], radius_q12, half_q12[3], own_half_q12[3];
};

static LIM_IF_CALLED void set_in_frame(struct in_frame *out, const struct lim_movers *movers, uint16_t mover,
                                       int8_t exponent)
{
    const struct lim_mover *self = &movers->movers[mover];
    const uint8_t down = (uint8_t)(exponent - lim_mover_exponent(movers, mover));

    out->instance = &movers->instances[mover];
    out->radius_q12 = (self->radius_q12 >> down) + 2;
    for (uint_fast8_t i = 0; i < 3; i++) {
        out->centre_q12[i] = self->centre_q12[i] >> down;
        out->half_q12[i] = (self->half_q12[i] >> down) + 2;
        out->own_half_q12[i] = (self->own_half_q12[i] >> down) + 2;
    }
}

static LIM_IF_CALLED bool is_before_in_frame(const struct in_frame *a, const struct in_frame *b)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t away_q12 = b->centre_q12[i] - a->centre_q12[i];
        if ((int32_t)abs_s32(away_q12) < a->half_q12[i] + b->half_q12[i]) continue;
        const int32_t end_q12 = b->centre_q12[i] + (away_q12 > 0 ? -b->half_q12[i] : b->half_q12[i]);
        if (away_q12 > 0 ? end_q12 >= 0 : end_q12 < 0) return true;
    }
    return false;
}

static LIM_IF_CALLED bool is_parted_in_frame(const struct in_frame *box, const struct in_frame *ball,
                                             bool eye_beside_box)
{
    int32_t away_q8[3], to_eye_q8[3];
    struct beside beside;

    beside.radius_q8 = (ball->radius_q12 >> 4) + 512;
    for (uint_fast8_t i = 0; i < 3; i++) {
        away_q8[i] = (ball->centre_q12[i] >> 4) - (box->centre_q12[i] >> 4);
        to_eye_q8[i] = -(box->centre_q12[i] >> 4);
    }
    for (uint_fast8_t j = 0; j < 3; j++) {
        beside.ball_q8[j] = (int32_t)(lim_along_axis(box->instance, j, away_q8) >> 30);
        beside.eye_q8[j] = (int32_t)(lim_along_axis(box->instance, j, to_eye_q8) >> 30);
        beside.half_q8[j] = box->own_half_q12[j] >> 4;
    }
    return is_parted_along_axis(&beside, eye_beside_box) || is_parted_along_way(&beside, eye_beside_box);
}

static LIM_IF_CALLED bool precedes_in_frame(const struct lim_movers *movers, uint16_t a, uint16_t b)
{
    const int8_t of_a = lim_mover_exponent(movers, a), of_b = lim_mover_exponent(movers, b);
    struct in_frame first, second;

    set_in_frame(&first, movers, a, of_a > of_b ? of_a : of_b);
    set_in_frame(&second, movers, b, of_a > of_b ? of_a : of_b);
    const int32_t far = lim_mover_depth(movers, first.centre_q12) + (first.radius_q12 >> 3);
    const int32_t near = lim_mover_depth(movers, second.centre_q12) - (second.radius_q12 >> 3);
    return far <= near || is_before_in_frame(&first, &second) || is_parted_in_frame(&first, &second, true) ||
           is_parted_in_frame(&second, &first, false);
}

bool lim_mover_precedes(const struct lim_movers *movers, uint16_t a, uint16_t b)
{
    const struct lim_mover *first = &movers->movers[a], *second = &movers->movers[b];

    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) return precedes_in_frame(movers, a, b);
    return is_nearer(movers, a, b) || is_before_along_axis(movers, first, second) || is_parted(movers, a, b, true) ||
           is_parted(movers, b, a, false);
}

#endif
