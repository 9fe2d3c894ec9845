/* SPDX-License-Identifier: MIT
 *
 * The firmware's keyframes, turned instances and lamp against double precision. */
#include "cmocka_ready.h"
#include "light.h"
#include "limner.h"
#include "pose.h"
#include "random.h"
#include "vec3.h"

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
        const struct lim_motion motion = {keys, KEYS, true};
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
    const struct lim_motion motion = {keys, 2, false};
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
    const struct lim_motion motion = {&key, 1, true};
    struct lim_instance instance = {0};
    (void)state;

    lim_motion_at(&motion, 12345, &instance);
    assert_int_equal(instance.at_q8[2], 3);
    assert_true(instance.axes_q30[0] < -1073741000 && instance.axes_q30[8] < -1073741000); /* half a turn about y */
    assert_true(instance.axes_q30[4] > 1073741000);
}

static void all_of_a_scene_move_at_once(void **state)
{
    struct lim_motion_key keys[2] = {{0, {0, 0, 0}, {0, 0, 0, 32767}, 0}, {1000, {256, 0, 0}, {0, 0, 0, 32767}, 0}};
    static const struct lim_scene objects[2] = {{0}};
    const struct lim_moved moved[2] = {{&objects[0], {keys, 2, true}, 1}, {&objects[1], {keys + 1, 1, true}, 2}};
    struct lim_instance instances[2] = {{.by_centre = true}, {0}};
    (void)state;

    lim_moved_at(moved, 2, 500, instances);
    assert_ptr_equal(instances[1].object, &objects[1]);
    assert_int_equal(instances[0].at_q8[0], 128);
    assert_int_equal(instances[1].at_q8[0], 256);
    assert_int_equal(instances[1].finer_bits, 2);
    assert_true(instances[0].by_centre);
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
        cmocka_unit_test(all_of_a_scene_move_at_once),
        cmocka_unit_test(an_instance_turns_like_a_camera),
        cmocka_unit_test(a_lit_colour_is_within_a_level_of_the_truth),
        cmocka_unit_test(the_lamp_is_the_one_that_is_baked_in),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
