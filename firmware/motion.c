/* SPDX-License-Identifier: MIT
 *
 * Shoemake's spherical interpolation: q0 sin((1 - t) a) + q1 sin(t a), a half the angle between the two. The usual
 * divisor, sin a, goes without saying, because what comes out is made a unit again. */
#include "motion.h"

#include "angle.h"
#include "fixed.h"
#include "root.h"

#if LIM_HAS_MOVERS

/* Makes a quaternion a unit; not all of it is 0. */
static void normalise(int32_t q_q30[4], const int64_t sum[4])
{
    uint64_t bits = 0, square = 0;
    uint8_t shift = 0;

    for (uint_fast8_t i = 0; i < 4; i++)
        bits |= (uint64_t)(sum[i] < 0 ? -sum[i] : sum[i]);
    while (bits >> shift >> 30)
        shift++;
    for (uint_fast8_t i = 0; i < 4; i++) {
        const int64_t part = sum[i] >> shift;
        square += (uint64_t)(part * part);
    }
    const uint32_t length = lim_root(square);
    for (uint_fast8_t i = 0; i < 4; i++) {
        const int32_t part = (int32_t)(sum[i] >> shift);
        const uint32_t size = abs_s32(part);
        const int32_t unit_q30 = (int32_t)(ratio_q31(size < length ? size : length, length ? length : 1) >> 1);
        q_q30[i] = part < 0 ? -unit_q30 : unit_q30;
    }
}

static int32_t twice(int32_t a_q30, int32_t b_q30, int32_t c_q30, int32_t d_q30)
{
    return (int32_t)shift_round_s64((int64_t)a_q30 * b_q30 + (int64_t)c_q30 * d_q30, 29);
}

static void set_axes(int32_t axes_q30[9], const int32_t q_q30[4])
{
    const int32_t one_q30 = INT32_C(1) << 30;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        axes_q30[4 * i] = one_q30 - twice(q_q30[j], q_q30[j], q_q30[k], q_q30[k]);
        axes_q30[3 * i + j] = twice(q_q30[i], q_q30[j], q_q30[k], q_q30[3]);
        axes_q30[3 * i + k] = twice(q_q30[i], q_q30[k], -q_q30[j], q_q30[3]);
    }
}

/* The part t of the way from one key to the next. */
static void interpolate(const LIM_FLASH struct lim_motion_key *from, const LIM_FLASH struct lim_motion_key *to,
                        uint32_t t_q31, struct lim_instance *instance)
{
    const uint32_t arc = (uint32_t)from->arc << 16, there = (uint32_t)(((uint64_t)arc * t_q31) >> 31);
    const bool is_still = !from->arc;
    const int32_t w0_q30 = is_still ? INT32_C(1) << 30 : lim_sin_q30(arc - there);
    const int32_t w1_q30 = is_still ? 0 : lim_sin_q30(there);
    int64_t sum[4];
    int32_t turn_q30[4];

    for (uint_fast8_t i = 0; i < 3; i++)
        instance->at_q8[i] = lerp_q31(from->at_q8[i], to->at_q8[i], t_q31);
    for (uint_fast8_t i = 0; i < 4; i++)
        sum[i] = (int64_t)from->turn_q15[i] * w0_q30 + (int64_t)to->turn_q15[i] * w1_q30;
    normalise(turn_q30, sum);
    set_axes(instance->axes_q30, turn_q30);
}

void lim_motion_at(const struct lim_motion *motion, uint32_t time_ms, struct lim_instance *instance)
{
    const LIM_FLASH struct lim_motion_key *key = motion->keys, *last = key + motion->count - 1;

    if (motion->repeats && last->time_ms) time_ms %= last->time_ms;
    while (key < last && key[1].time_ms <= time_ms)
        key++;
    const bool moves = key < last && time_ms > key->time_ms;
    const uint32_t t_q31 = moves ? ratio_q31(time_ms - key->time_ms, key[1].time_ms - key->time_ms) : 0;
    interpolate(key, key < last ? key + 1 : key, t_q31, instance);
}

void lim_moved_at(const struct lim_moved *moved, uint16_t count, uint32_t time_ms, struct lim_instance *instances)
{
    for (uint16_t i = 0; i < count; i++) {
        instances[i].object = moved[i].object;
        instances[i].finer_bits = moved[i].finer_bits;
        lim_motion_at(&moved[i].motion, time_ms, &instances[i]);
    }
}

#endif
