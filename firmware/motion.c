/* SPDX-License-Identifier: MIT
 *
 * Shoemake's spherical interpolation: q0 sin((1 - t) a) + q1 sin(t a), a half the angle between the two. The usual
 * divisor, sin a, goes without saying, because what comes out is made a unit again. */
#include "scene.h"

#include "camera.h"
#include "math/fixed.h"
#include "math/isqrt.h"
#include "movers/motion_long.h"

#if LIM_HAS_MOVERS

#define ONE_Q30 (INT32_C(1) << 30)

/* A component by the length, which is rounded down, and 0 only if all components are. */
/*@ requires -1073741824 <= part <= 1073741824;
    assigns \nothing;
    ensures -1073741824 <= \result <= 1073741824; */
static int32_t part_q30(int32_t part, uint32_t length)
{
    const uint32_t size = abs_s32(part);
    const uint32_t unit_q31 = ratio_q31(size < length ? size : length, length ? length : 1);
    const int32_t unit_q30 = (int32_t)(unit_q31 >> 1);

    return part < 0 ? -unit_q30 : unit_q30;
}

/*@ requires -1073741824 <= x <= 1073741824;
    assigns \nothing;
    ensures \result <= 1152921504606846976; */
static uint64_t square_of(int64_t x)
{
    //@ assert 0 <= x * x <= 1152921504606846976;
    return (uint64_t)(x * x);
}

/* Makes a quaternion a unit. All zeros stay what they are, and turn nothing. */
/*@ requires \valid(q_q30 + (0 .. 3)) && \valid(sum + (0 .. 3)) && \separated(q_q30 + (0 .. 3), sum + (0 .. 3));
    requires -70368744177664 <= sum[0] <= 70368744177664 && -70368744177664 <= sum[1] <= 70368744177664;
    requires -70368744177664 <= sum[2] <= 70368744177664 && -70368744177664 <= sum[3] <= 70368744177664;
    assigns q_q30[0 .. 3], sum[0 .. 3];
    ensures -1073741824 <= q_q30[0] <= 1073741824 && -1073741824 <= q_q30[1] <= 1073741824;
    ensures -1073741824 <= q_q30[2] <= 1073741824 && -1073741824 <= q_q30[3] <= 1073741824; */
static void normalise(int32_t q_q30[4], int64_t sum[4])
{
    uint64_t square = 0;

    shorten_s64(sum, ONE_Q30);
    //@ loop pragma UNROLL "completely", 5;
    for (uint_fast8_t i = 0; i < 4; i++)
        square += square_of(sum[i]);
    const uint32_t length = lim_isqrt(square);
    //@ loop pragma UNROLL "completely", 5;
    for (uint_fast8_t i = 0; i < 4; i++)
        q_q30[i] = part_q30((int32_t)sum[i], length);
}

/* 2 (a b + c d), which is 2 where a turn is a half one: more than 32 bits have room for. */
/*@ requires -1073741824 <= a_q30 <= 1073741824 && -1073741824 <= b_q30 <= 1073741824;
    requires -1073741824 <= c_q30 <= 1073741824 && -1073741824 <= d_q30 <= 1073741824;
    assigns \nothing;
    ensures -4294967296 <= \result <= 4294967296; */
static int64_t twice(int32_t a_q30, int32_t b_q30, int32_t c_q30, int32_t d_q30)
{
    //@ assert -1152921504606846976 <= a_q30 * b_q30 <= 1152921504606846976;
    //@ assert -1152921504606846976 <= c_q30 * d_q30 <= 1152921504606846976;
    return shift_round_s64((int64_t)a_q30 * b_q30 + (int64_t)c_q30 * d_q30, 29);
}

/* Within -1..1, which rounding may leave by a little, and keys that are no unit quaternions by a lot. */
/*@ assigns \nothing;
    ensures -1073741824 <= \result <= 1073741824;
    ensures -1073741824 <= x_q30 <= 1073741824 ==> \result == x_q30; */
static int32_t saturate_q30(int64_t x_q30)
{
    return x_q30 > ONE_Q30 ? ONE_Q30 : x_q30 < -ONE_Q30 ? -ONE_Q30 : (int32_t)x_q30;
}

/*@ requires \valid(axes_q30 + (0 .. 8)) && \valid_read(q_q30 + (0 .. 3));
    requires \separated(axes_q30 + (0 .. 8), q_q30 + (0 .. 3));
    requires -1073741824 <= q_q30[0] <= 1073741824 && -1073741824 <= q_q30[1] <= 1073741824;
    requires -1073741824 <= q_q30[2] <= 1073741824 && -1073741824 <= q_q30[3] <= 1073741824;
    assigns axes_q30[0 .. 8];
    ensures \forall integer i; 0 <= i < 9 ==> -1073741824 <= axes_q30[i] <= 1073741824; */
static void set_axes(int32_t axes_q30[9], const int32_t q_q30[4])
{
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        axes_q30[4 * i] = saturate_q30(ONE_Q30 - twice(q_q30[j], q_q30[j], q_q30[k], q_q30[k]));
        axes_q30[3 * i + j] = saturate_q30(twice(q_q30[i], q_q30[j], q_q30[k], q_q30[3]));
        axes_q30[3 * i + k] = saturate_q30(twice(q_q30[i], q_q30[k], -q_q30[j], q_q30[3]));
    }
}

/* What one of two keys gives to a component. */
/*@ requires -1073741824 <= weight_q30 <= 1073741824;
    assigns \nothing;
    ensures -35184372088832 <= \result <= 35184372088832; */
static int64_t share_q45(int16_t turn_q15, int32_t weight_q30)
{
    return (int64_t)turn_q15 * weight_q30;
}

/* The part t of the way from one key to the next. */
/*@ requires \valid_read(from) && \valid_read(to) && \valid(instance) && t_q31 <= 2147483648;
    requires \separated(instance, from) && \separated(instance, to);
    assigns instance->at_q8[0 .. 2], instance->axes_q30[0 .. 8];
    ensures \forall integer i; 0 <= i < 9 ==> -1073741824 <= instance->axes_q30[i] <= 1073741824; */
static void interpolate(const LIM_FLASH struct lim_motion_key *from, const LIM_FLASH struct lim_motion_key *to,
                        uint32_t t_q31, struct lim_instance *instance)
{
    const uint32_t arc = (uint32_t)from->arc << 16, there = (uint32_t)(((uint64_t)arc * t_q31) >> 31);
    const bool is_still = !from->arc;
    const int32_t w0_q30 = is_still ? ONE_Q30 : lim_sin_q30(arc - there);
    const int32_t w1_q30 = is_still ? 0 : lim_sin_q30(there);
    int64_t sum[4];
    int32_t turn_q30[4];

    /*@ loop invariant 0 <= i <= 3;
        loop assigns i, instance->at_q8[0 .. 2];
        loop variant 3 - i; */
    for (uint_fast8_t i = 0; i < 3; i++)
        instance->at_q8[i] = lerp_q31(from->at_q8[i], to->at_q8[i], t_q31);
    /*@ loop invariant 0 <= i <= 4;
        loop invariant \forall integer k; 0 <= k < i ==> -70368744177664 <= sum[k] <= 70368744177664;
        loop assigns i, sum[0 .. 3];
        loop variant 4 - i; */
    for (uint_fast8_t i = 0; i < 4; i++)
        sum[i] = share_q45(from->turn_q15[i], w0_q30) + share_q45(to->turn_q15[i], w1_q30);
    normalise(turn_q30, sum);
    set_axes(instance->axes_q30, turn_q30);
}

/* Whatever the order of the keys' times, the next one's is later where the way between two is taken. */
void lim_motion_at(const struct lim_motion *motion, uint32_t time_ms, struct lim_instance *instance)
{
    LIM_ASSERT(motion && instance);
    const LIM_FLASH struct lim_motion_key *keys = motion->keys;
    const uint16_t last = (uint16_t)(motion->count - 1);
    uint16_t k = 0;

    if (motion->repeats && keys[last].time_ms) time_ms %= keys[last].time_ms;
    /*@ loop invariant 0 <= k <= last;
        loop assigns k;
        loop variant last - k; */
    while (k < last && keys[k + 1].time_ms <= time_ms)
        k++;
    const bool moves = k < last && time_ms > keys[k].time_ms;
    const uint32_t t_q31 = moves ? ratio_q31(time_ms - keys[k].time_ms, keys[k + 1].time_ms - keys[k].time_ms) : 0;
    interpolate(&keys[k], &keys[k < last ? k + 1 : k], t_q31, instance);
    if (LIM_HAS_LONG) lim_motion_go_far(motion, k, k < last ? (uint16_t)(k + 1) : k, t_q31, instance);
}

void lim_moved_at(const struct lim_moved *moved, uint16_t count, uint32_t time_ms, struct lim_instance *instances)
{
    LIM_ASSERT(!count || (moved && instances));
    for (uint16_t i = 0; i < count; i++) {
        instances[i].object = moved[i].object;
        instances[i].finer_bits = moved[i].finer_bits;
        if (LIM_HAS_LONG) *instances[i].coarser_bits = *moved[i].coarser_bits;
        lim_motion_at(&moved[i].motion, time_ms, &instances[i]);
    }
}

#endif
