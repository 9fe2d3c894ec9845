/* SPDX-License-Identifier: MIT
 *
 * The firmware's keyframes, turned instances and lamp against double precision. */
#include "base/vec3.h"
#include "limner.h"
#include "math/isqrt.h"
#include "model/baked_light.h"
#include "model/pose.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <stdlib.h>
#include <string.h>

enum { KEYS = 6 };

static const double Q30 = 1073741824.0;

static void random_turn(struct random *random, double turn[4])
{
    double length = 0;

    for (int i = 0; i < 4; i++) {
        turn[i] = random_unit(random) * 2 - 1;
        length = hypot(length, turn[i]);
    }
    for (int i = 0; i < 4; i++)
        turn[i] /= length;
}

/* As the compiler makes them: each quaternion the one of two that is nearer to the one before it. */
static void random_motion(struct random *random, struct lim_motion_key keys[KEYS], struct model_key exact[KEYS])
{
    for (int k = 0; k < KEYS; k++) {
        double dot = 0;
        keys[k].time_ms = k ? keys[k - 1].time_ms + (uint32_t)random_in(random, 1, 5000) : 0;
        exact[k].time_s = keys[k].time_ms / 1000.0;
        random_turn(random, exact[k].pose.turn);
        for (int i = 0; i < 4 && k; i++)
            dot += exact[k].pose.turn[i] * exact[k - 1].pose.turn[i];
        for (int i = 0; i < 4; i++) {
            if (dot < 0) exact[k].pose.turn[i] *= -1;
            keys[k].turn_q15[i] = (int16_t)fmin(fmax(round(exact[k].pose.turn[i] * 32768), -32767), 32767);
        }
        if (k) keys[k - 1].arc = (uint16_t)lround(acos(fmin(fabs(dot), 1)) / (2 * acos(-1)) * 65536);
        for (int i = 0; i < 3; i++) {
            keys[k].at_q8[i] = (int32_t)random_in(random, -0xFFFFFF, 0xFFFFFF);
            exact[k].pose.at_m[i] = keys[k].at_q8[i];
        }
    }
    keys[KEYS - 1].arc = 0;
}

static void assert_pose(const struct lim_instance *instance, const struct model_pose *pose)
{
    double axes[3][3];

    pose_axes(pose, axes);
    for (int i = 0; i < 9; i++)
        assert_true(fabs(instance->axes_q30[i] / Q30 - axes[i / 3][i % 3]) < 3e-4);
    for (int i = 0; i < 3; i++)
        assert_true(fabs(instance->at_q8[i] - pose->at_m[i]) <= 1);
}

/* Lengths and angles are far better than where the axes point: keys have 16 bits. */
static void assert_rotation(const struct lim_instance *instance)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double dot = 0;
            for (int k = 0; k < 3; k++)
                dot += instance->axes_q30[3 * i + k] / Q30 * instance->axes_q30[3 * j + k] / Q30;
            assert_true(fabs(dot - (i == j)) < 2e-8);
        }
}

static void between_keys_it_is_where_the_reference_is(void **state)
{
    struct random random = {7};
    (void)state;

    for (int round = 0; round < 200; round++) {
        struct lim_motion_key keys[KEYS];
        struct model_key exact[KEYS];
        struct model_mover mover = {.key_count = KEYS};
        const struct model model = {.keys = exact, .movers = &mover};
        random_motion(&random, keys, exact);
        const struct lim_motion motion = {.keys = keys, .count = KEYS, .repeats = true};
        for (int i = 0; i < 50; i++) {
            struct lim_instance instance = {0};
            const uint32_t time_ms = (uint32_t)random_in(&random, 0, 2 * keys[KEYS - 1].time_ms);
            const struct model_pose pose = pose_at(&model, &mover, time_ms / 1000.0);
            lim_motion_at(&motion, time_ms, &instance);
            assert_pose(&instance, &pose);
            assert_rotation(&instance);
        }
    }
}

static void what_does_not_repeat_stays_at_its_last_key(void **state)
{
    struct lim_motion_key keys[2] = {{1000, {0, 0, 0}, {0, 0, 0, 32767}, 0}, {2000, {512, -7, 0}, {0, 0, 0, 32767}, 0}};
    const struct lim_motion motion = {.keys = keys, .count = 2};
    struct lim_instance instance = {0};
    (void)state;

    lim_motion_at(&motion, 5, &instance);
    assert_int_equal(instance.at_q8[0], 0);
    lim_motion_at(&motion, 1500, &instance);
    assert_int_equal(instance.at_q8[0], 256);
    lim_motion_at(&motion, UINT32_MAX, &instance);
    assert_int_equal(instance.at_q8[0], 512);
    assert_int_equal(instance.at_q8[1], -7);
}

static void one_key_is_a_place(void **state)
{
    struct lim_motion_key key = {0, {1, 2, 3}, {0, 32767, 0, 0}, 0};
    const struct lim_motion motion = {.keys = &key, .count = 1, .repeats = true};
    struct lim_instance instance = {0};
    (void)state;

    lim_motion_at(&motion, 12345, &instance);
    assert_int_equal(instance.at_q8[2], 3);
    assert_true(instance.axes_q30[0] < -1073741000 && instance.axes_q30[8] < -1073741000); /* half a turn about y */
    assert_true(instance.axes_q30[4] > 1073741000);
}

/* Two of three axes point the other way: in Q30 the formula goes through 2, which 32 bits do not hold. */
static void half_turns_and_what_is_near_them_are_right(void **state)
{
    struct random random = {19};
    (void)state;

    for (int round = 0; round < 3000; round++) {
        struct lim_motion_key key = {0, {0, 0, 0}, {0, 0, 0, 0}, 0};
        struct model_pose pose = {.at_m = {0, 0, 0}};
        struct lim_instance instance = {0};
        const int axis = round % 3, off = round < 6 ? 0 : (int)random_in(&random, 0, 40);
        double length = 0;
        for (int i = 0; i < 4; i++)
            key.turn_q15[i] = (int16_t)random_in(&random, -off, off);
        key.turn_q15[axis] = round % 2 ? 32767 : -32767;
        for (int i = 0; i < 4; i++)
            length = hypot(length, key.turn_q15[i]);
        for (int i = 0; i < 4; i++)
            pose.turn[i] = key.turn_q15[i] / length;
        lim_motion_at(&(struct lim_motion){.keys = &key, .count = 1}, 0, &instance);
        assert_pose(&instance, &pose);
        assert_rotation(&instance);
    }
}

static void no_orientation_turns_nothing(void **state)
{
    const struct lim_motion_key keys[2] = {{0, {0, 0, 0}, {0, 0, 0, 0}, 0}, {1000, {256, 0, 0}, {0, 0, 0, 0}, 65535}};
    struct lim_instance instance = {0};
    (void)state;

    lim_motion_at(&(struct lim_motion){.keys = keys, .count = 2, .repeats = true}, 500, &instance);
    for (int i = 0; i < 9; i++)
        assert_int_equal(instance.axes_q30[i], i % 4 ? 0 : 1 << 30);
    assert_int_equal(instance.at_q8[0], 128);
}

static int64_t one_of(struct random *random, const int64_t *values, int count, int64_t low, int64_t high)
{
    const int64_t which = random_in(random, 0, count);
    return which < count ? values[which] : random_in(random, low, high);
}

/* Each field of a key anywhere in its type, its ends most of all. */
static struct lim_motion_key any_key(struct random *random)
{
    static const int64_t TIMES[] = {0, 1, 2, UINT32_MAX - 1, UINT32_MAX, INT64_C(1) << 31};
    static const int64_t PLACES[] = {INT32_MIN, INT32_MAX, 0, -1, 0xFFFFFF, -0xFFFFFF};
    static const int64_t TURNS[] = {INT16_MIN, -INT16_MAX, INT16_MAX, 0, 0, 1, -1};
    static const int64_t ARCS[] = {0, 1, 16383, 16384, 32768, 65535};
    struct lim_motion_key key = {.time_ms = (uint32_t)one_of(random, TIMES, 6, 0, UINT32_MAX)};
    for (int i = 0; i < 3; i++)
        key.at_q8[i] = (int32_t)one_of(random, PLACES, 6, INT32_MIN, INT32_MAX);
    for (int i = 0; i < 4; i++)
        key.turn_q15[i] = (int16_t)one_of(random, TURNS, 7, INT16_MIN, INT16_MAX);
    key.arc = (uint16_t)one_of(random, ARCS, 6, 0, UINT16_MAX);
    return key;
}

/* A place lies between the keys', and no component of an axis beyond 1, whatever the keys say and in whatever order. */
static void keys_beyond_their_bounds_overflow_nothing(void **state)
{
    static const int64_t TIMES[] = {0, UINT32_MAX, INT64_C(1) << 31, 1};
    struct random random = {23};
    (void)state;

    for (int round = 0; round < 40000; round++) {
        struct lim_motion_key keys[3];
        const uint16_t count = (uint16_t)random_in(&random, 1, 3);
        for (int i = 0; i < 3; i++)
            keys[i] = any_key(&random);
        struct lim_instance instance = {0};
        const struct lim_motion motion = {.keys = keys, .count = count, .repeats = round % 2};
        lim_motion_at(&motion, (uint32_t)one_of(&random, TIMES, 4, 0, UINT32_MAX), &instance);
        for (int i = 0; i < 9; i++)
            assert_in_range(instance.axes_q30[i] + (INT64_C(1) << 30), 0, INT64_C(1) << 31);
        for (int i = 0; i < 3; i++) {
            int64_t low = INT32_MAX, high = INT32_MIN;
            for (int k = 0; k < count; k++) {
                low = keys[k].at_q8[i] < low ? keys[k].at_q8[i] : low;
                high = keys[k].at_q8[i] > high ? keys[k].at_q8[i] : high;
            }
            assert_true(low <= instance.at_q8[i] && instance.at_q8[i] <= high);
        }
    }
}

static void a_root_is_the_largest_that_fits(void **state)
{
    struct random random = {29};
    (void)state;

    assert_int_equal(lim_isqrt(0), 0);
    assert_int_equal(lim_isqrt(UINT64_MAX), UINT32_MAX);
    for (int round = 0; round < 100000; round++) {
        const uint64_t root = random_u64(&random) >> 32 >> round % 32, x = random_u64(&random) >> round % 64;
        assert_int_equal(lim_isqrt(root * root), root);
        assert_int_equal(lim_isqrt(root * root + 2 * root), root);
        if (root) assert_int_equal(lim_isqrt(root * root - 1), root - 1);
        const uint64_t got = lim_isqrt(x);
        assert_true(got * got <= x && x - got * got <= 2 * got);
    }
}

/* Normals of any length, ends of the type included: brightness stays between both ends of the light's swing. */
static void a_light_takes_normals_of_any_length(void **state)
{
    static const int64_t PARTS[] = {INT32_MIN, INT32_MAX, 0, 1, -1, INT32_MIN + 1};
    struct random random = {31};
    (void)state;

    for (int round = 0; round < 40000; round++) {
        const struct lim_light light = {true, {16384, 0, 0}, (uint8_t)random_in(&random, 0, 255), 1};
        int32_t normal[3];
        int16_t to_q14[3];
        for (int i = 0; i < 3; i++) {
            normal[i] = (int32_t)one_of(&random, PARTS, 6, INT32_MIN, INT32_MAX);
            to_q14[i] = (int16_t)random_in(&random, INT16_MIN, INT16_MAX);
        }
        if (!normal[0] && !normal[1] && !normal[2]) continue;
        const int green = lim_light_shade(&light, to_q14, normal, 63 << 5) >> 5 & 63;
        assert_true(abs(green * 256 - 63 * light.middle_q8) <= 63 + 256);
    }
}

static void all_of_a_scene_move_at_once(void **state)
{
    struct lim_motion_key keys[2] = {{0, {0, 0, 0}, {0, 0, 0, 32767}, 0}, {1000, {256, 0, 0}, {0, 0, 0, 32767}, 0}};
    static const struct lim_scene objects[2] = {{0}};
    const struct lim_moved moved[2] = {
        {.object = &objects[0], .motion = {.keys = keys, .count = 2, .repeats = true}, .finer_bits = 1},
        {.object = &objects[1], .motion = {.keys = keys + 1, .count = 1, .repeats = true}, .finer_bits = 2}};
    struct lim_instance instances[2] = {{0}};
    (void)state;

    lim_moved_at(moved, 2, 500, instances);
    assert_ptr_equal(instances[1].object, &objects[1]);
    assert_int_equal(instances[0].at_q8[0], 128);
    assert_int_equal(instances[1].at_q8[0], 256);
    assert_int_equal(instances[1].finer_bits, 2);
    assert_int_equal(instances[0].finer_bits, 1);
}

/* Yaw turns counter-clockwise from above, pitch raises what looks along -z, as for a camera. */
static void an_instance_turns_like_a_camera(void **state)
{
    const uint32_t quarter = UINT32_C(1) << 30;
    struct lim_instance instance = {0};
    (void)state;

    lim_instance_turn(&instance, 0, 0, 0);
    for (int i = 0; i < 9; i++)
        assert_int_equal(instance.axes_q30[i], i % 4 ? 0 : 1 << 30);
    lim_instance_turn(&instance, quarter, 0, 0);
    assert_int_equal(instance.axes_q30[6], 1 << 30); /* its z axis points along x, its -z along -x */
    assert_int_equal(instance.axes_q30[2], -(1 << 30));
    lim_instance_turn(&instance, 0, quarter, 0);
    assert_int_equal(instance.axes_q30[7], -(1 << 30)); /* its -z points up */
    assert_int_equal(instance.axes_q30[5], 1 << 30);
}

static int channel(uint32_t rgb565, int which)
{
    return (int)(which == 0 ? rgb565 >> 11 : which == 1 ? rgb565 >> 5 & 63 : rgb565 & 31);
}

static void a_lit_colour_is_within_a_level_of_the_truth(void **state)
{
    const struct lim_light light = light_lamp();
    struct random random = {11};
    (void)state;

    for (int round = 0; round < 20000; round++) {
        const int bits = (int)random_in(&random, 1, 31);
        const int64_t end = (INT64_C(1) << bits) - 1;
        const int32_t normal[3] = {(int32_t)random_in(&random, -end, end), (int32_t)random_in(&random, -end, end),
                                   (int32_t)random_in(&random, -end, end)};
        const uint16_t colour = (uint16_t)random_u64(&random);
        double n[3], to[3], brightness = light.middle_q8 / 256.0;
        for (int i = 0; i < 3; i++) {
            n[i] = normal[i];
            to[i] = light.to_q14[i] / 16384.0;
        }
        if (!(vec3_dot(n, n) > 0)) continue;
        brightness += light.swing_q8 / 256.0 * vec3_dot(n, to) / sqrt(vec3_dot(n, n));
        const uint16_t lit = lim_light_shade(&light, light.to_q14, normal, colour);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(channel(lit, i) - channel(colour, i) * brightness) <= 1);
    }
}

/* The lamp that is baked in, and the one in the firmware, are the same. */
static void the_lamp_is_the_one_that_is_baked_in(void **state)
{
    const struct lim_light light = light_lamp();
    (void)state;

    assert_true(light.on);
    assert_true(light.middle_q8 + light.swing_q8 <= 256);
    assert_true(light.to_q14[1] > 0 && light.to_q14[0] < 0 && light.to_q14[2] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(between_keys_it_is_where_the_reference_is),
        cmocka_unit_test(what_does_not_repeat_stays_at_its_last_key),
        cmocka_unit_test(one_key_is_a_place),
        cmocka_unit_test(half_turns_and_what_is_near_them_are_right),
        cmocka_unit_test(no_orientation_turns_nothing),
        cmocka_unit_test(keys_beyond_their_bounds_overflow_nothing),
        cmocka_unit_test(a_root_is_the_largest_that_fits),
        cmocka_unit_test(a_light_takes_normals_of_any_length),
        cmocka_unit_test(all_of_a_scene_move_at_once),
        cmocka_unit_test(an_instance_turns_like_a_camera),
        cmocka_unit_test(a_lit_colour_is_within_a_level_of_the_truth),
        cmocka_unit_test(the_lamp_is_the_one_that_is_baked_in),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
