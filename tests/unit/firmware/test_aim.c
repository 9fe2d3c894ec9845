/* SPDX-License-Identifier: MIT
 *
 * Angles of vectors against arc tangents in long double; cameras that look at a target against where a ray in long
 * double goes, and against the cameras that the simulator makes of camera files, in doubles. */
#include "camera.h"
#include "cameras/camera_path.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const long double turn = 4294967296.0L;
static const long double pi = 3.141592653589793238462643383279502884L;

/* Between two angles, in units of 2^-32 of a turn. */
static double between(uint32_t angle, long double radians)
{
    const long double off = fmodl(angle - radians / (2 * pi) * turn, turn);

    return (double)(off > turn / 2 ? off - turn : off < -turn / 2 ? off + turn : off);
}

/* Numbers of every length and sign, and often 0. */
static int32_t any_length(struct random *random)
{
    const uint32_t size = (uint32_t)(random_u64(random) >> 32 >> random_in(random, 0, 32));

    return random_u64(random) & 1 ? (int32_t)size : (int32_t)(0u - size);
}

/* Powers of two, their neighbours, and the ends of the type. */
static size_t fill_extremes(int32_t *values)
{
    size_t count = 0;

    for (int bit = 0; bit < 32; bit++)
        for (int off = -1; off <= 1; off++)
            for (int sign = 0; sign < 2; sign++) {
                const uint32_t size = (UINT32_C(1) << bit) + (uint32_t)off;
                values[count++] = (int32_t)(sign ? 0u - size : size);
            }
    return count;
}

static double error_of(int32_t y, int32_t x)
{
    return fabs(between(lim_atan2(y, x), atan2l(y, x)));
}

static void angles_are_within_2_units(void **state)
{
    struct random random = {7};
    int32_t extremes[6 * 32];
    const size_t count = fill_extremes(extremes);
    double worst = 0, worst_extreme = 0;

    (void)state;
    for (int k = 0; k < 1 << 20; k++)
        worst = fmax(worst, error_of(any_length(&random), any_length(&random)));
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < count; j++)
            worst_extreme = fmax(worst_extreme, error_of(extremes[i], extremes[j]));
    printf("# worst error of an angle: %.2f units of 2^-32 of a turn, at extremes %.2f\n", worst, worst_extreme);
    assert_true(worst < 2 && worst_extreme < 2);
}

static void eighths_of_a_turn_are_exact(void **state)
{
    static const int32_t sizes[] = {1, 2, 3, 255, 65537, 1 << 28, INT32_MAX};

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (uint32_t eighth = 0; eighth < 8; eighth++) {
            static const int way[] = {1, 1, 0, -1, -1, -1, 0, 1};
            const int32_t x = way[eighth] * sizes[i], y = way[(eighth + 6) % 8] * sizes[i];
            assert_int_equal(lim_atan2(y, x), eighth * (LIM_ANGLE_QUARTER / 2));
        }
    assert_int_equal(lim_atan2(INT32_MIN, 0), 3 * LIM_ANGLE_QUARTER);
    assert_int_equal(lim_atan2(0, INT32_MIN), 2 * LIM_ANGLE_QUARTER);
    assert_int_equal(lim_atan2(0, 0), 0);
}

static void angles_of_mirrored_vectors_are_mirrored(void **state)
{
    struct random random = {11};

    (void)state;
    for (int k = 0; k < 1 << 16; k++) {
        const int32_t y = any_length(&random), x = any_length(&random);
        assert_int_equal(lim_atan2((int32_t)(0u - (uint32_t)y), x), 0u - lim_atan2(y, x));
    }
}

/* Degrees ---------------------------------------------------------------------------------------------------------- */

static void degrees_are_rounded_to_nearest(void **state)
{
    static const uint32_t constants[] = {LIM_DEGREES(0),   LIM_DEGREES(90),  LIM_DEGREES(-90),  LIM_DEGREES(180),
                                         LIM_DEGREES(360), LIM_DEGREES(1.5), LIM_DEGREES(-22.5)};

    (void)state;
    assert_int_equal(constants[0], 0);
    assert_int_equal(constants[1], LIM_ANGLE_QUARTER);
    assert_int_equal(constants[2], 0u - LIM_ANGLE_QUARTER);
    assert_int_equal(constants[3], 2 * LIM_ANGLE_QUARTER);
    assert_int_equal(constants[4], 0);
    assert_true(fabs(between(constants[5], 1.5L / 180 * pi)) <= 0.5);
    assert_int_equal(constants[6], 0u - LIM_ANGLE_QUARTER / 4);
    for (int e4 = -3600000; e4 <= 3600000; e4 += 7)
        assert_true(fabs(between(LIM_DEGREES(e4 / 1e4), e4 / 1e4L / 180 * pi)) <= 0.5001);
}

/* A literal with four decimals, read as float and as double. */
static void degrees_are_those_of_compilers_with_short_doubles(void **state)
{
    (void)state;
    for (int e4 = -3600000; e4 <= 3600000; e4++) {
        const float one = (float)(e4 / 1e4), in_e4 = one * 1e4f;
        const float rounded = one < 0 ? in_e4 - 0.5f : in_e4 + 0.5f;
        if (LIM_ANGLE_OF_E4(rounded) != LIM_DEGREES(e4 / 1e4)) fail_msg("%d", e4);
    }
}

/* Cameras ---------------------------------------------------------------------------------------------------------- */

/* By camera.h's words. */
static void view_direction(const struct lim_camera *camera, long double out[3])
{
    const long double yaw = camera->yaw / turn * 2 * pi, pitch = camera->pitch / turn * 2 * pi;

    out[0] = -sinl(yaw) * cosl(pitch);
    out[1] = sinl(pitch);
    out[2] = -cosl(yaw) * cosl(pitch);
}

/* How far the target is off the middle of the picture: an angle, in units of 2^-32 of a turn. */
static double off_target(const struct lim_camera *camera, const int32_t eye[3], const int32_t target[3])
{
    long double ahead[3], way[3], cross = 0, dot = 0;

    view_direction(camera, ahead);
    for (int i = 0; i < 3; i++)
        way[i] = (long double)target[i] - eye[i];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const long double part = ahead[j] * way[k] - ahead[k] * way[j];
        cross += part * part;
        dot += ahead[i] * way[i];
    }
    return (double)(atan2l(sqrtl(cross), dot) / (2 * pi) * turn);
}

static void the_target_is_in_the_middle(void **state)
{
    struct random random = {13};
    double worst = 0;

    (void)state;
    for (int k = 0; k < 1 << 18; k++) {
        int32_t eye[3], target[3];
        for (int i = 0; i < 3; i++) {
            eye[i] = any_length(&random) / 8;
            target[i] = k % 2 ? any_length(&random) : eye[i] + any_length(&random) % 32;
        }
        struct lim_camera camera = {.roll = 5, .tan_x_q28 = 6, .near_q8 = 7};
        if (memcmp(eye, target, sizeof eye) == 0) continue;
        lim_look_at(&camera, eye, target);
        worst = fmax(worst, off_target(&camera, eye, target));
        assert_memory_equal(camera.eye_q8, eye, sizeof eye);
        assert_true(camera.roll == 5 && camera.tan_x_q28 == 6 && camera.near_q8 == 7);
        assert_true(camera.pitch <= LIM_ANGLE_QUARTER || camera.pitch >= 0u - LIM_ANGLE_QUARTER); /* upright */
    }
    printf("# worst angle between the middle of the picture and the target: %.2f units of 2^-32 of a turn\n", worst);
    assert_true(worst < 4);
}

static void extremes_are_looked_at(void **state)
{
    static const int32_t ends[] = {INT32_MIN, -(1 << 28), -1, 0, 1, 1 << 28, INT32_MAX};
    enum { ENDS = sizeof ends / sizeof *ends };

    (void)state;
    for (int a = 0; a < ENDS * ENDS * ENDS; a++)
        for (int b = 0; b < ENDS * ENDS * ENDS; b++) {
            const int32_t eye[3] = {ends[a % ENDS], ends[a / ENDS % ENDS], ends[a / ENDS / ENDS]};
            const int32_t target[3] = {ends[b % ENDS], ends[b / ENDS % ENDS], ends[b / ENDS / ENDS]};
            struct lim_camera camera = {.yaw = 0};
            if (a == b) continue;
            lim_look_at(&camera, eye, target);
            assert_true(off_target(&camera, eye, target) < 4);
        }
}

static void what_has_no_direction_leaves_angles_alone(void **state)
{
    const int32_t eye[3] = {256, 512, -256}, above[3] = {256, 513, -256}, below[3] = {256, -(1 << 28), -256};
    struct lim_camera camera = {.yaw = 123, .pitch = 456, .roll = 789};

    (void)state;
    lim_look_at(&camera, eye, eye);
    assert_true(camera.yaw == 123 && camera.pitch == 456);
    assert_memory_equal(camera.eye_q8, eye, sizeof eye);
    lim_look_at(&camera, eye, above);
    assert_true(camera.yaw == 123 && camera.pitch == LIM_ANGLE_QUARTER);
    lim_look_at(&camera, eye, below);
    assert_true(camera.yaw == 123 && camera.pitch == 0u - LIM_ANGLE_QUARTER);
    lim_look_at(&camera, camera.eye_q8, above);
    assert_true(camera.pitch == LIM_ANGLE_QUARTER && camera.roll == 789);
}

/* The simulator's camera from eye to target, both in units with 8 fraction bits: a grid of a unit a metre. */
static struct lim_camera camera_of_file(const int32_t eye[3], const int32_t target[3])
{
    const struct grid grid = {.units_per_m = 1};
    struct viewpoint viewpoint = {.line = 1};
    char name[] = "test";
    const struct camera_path path = {name, &viewpoint, 1};
    struct lim_camera camera;
    struct lens lens;
    struct error err;

    for (int i = 0; i < 3; i++) {
        viewpoint.eye_m[i] = eye[i] / 256.0;
        viewpoint.target_m[i] = target[i] / 256.0;
    }
    assert_true(lens_init(&lens, 50, 16, 240, 180, &err));
    if (!camera_path_to_camera(&path, 0, &lens, &grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

static double apart(uint32_t a, uint32_t b)
{
    return fabs((double)(int32_t)(a - b));
}

static void cameras_are_those_of_the_simulator(void **state)
{
    struct random random = {17};
    double worst = 0;

    (void)state;
    for (int k = 0; k < 1 << 16; k++) {
        int32_t eye[3], target[3];
        for (int i = 0; i < 3; i++) {
            eye[i] = (int32_t)random_in(&random, -(1 << 24), 1 << 24);
            target[i] = (int32_t)random_in(&random, -(1 << 24), 1 << 24);
        }
        const struct lim_camera expected = camera_of_file(eye, target);
        struct lim_camera camera = {.yaw = 0};
        lim_look_at(&camera, eye, target);
        assert_memory_equal(camera.eye_q8, expected.eye_q8, sizeof eye);
        worst = fmax(worst, fmax(apart(camera.yaw, expected.yaw), apart(camera.pitch, expected.pitch)));
    }
    printf("# worst difference to the simulator's angles: %.0f units of 2^-32 of a turn\n", worst);
    assert_true(worst <= 5);
}

/* Orbits ----------------------------------------------------------------------------------------------------------- */

static void an_orbit_is_where_it_should_be(void **state)
{
    struct random random = {19};
    double worst = 0;

    (void)state;
    for (int k = 0; k < 1 << 18; k++) {
        const uint32_t yaw = (uint32_t)random_u64(&random), pitch = (uint32_t)random_u64(&random);
        const int32_t radius = any_length(&random) / 8;
        struct lim_camera camera = {.roll = 5, .tan_y_q28 = 6};
        int32_t target[3];
        long double ahead[3];
        for (int i = 0; i < 3; i++)
            target[i] = any_length(&random) / 8;
        lim_orbit(&camera, target, radius, yaw, pitch);
        assert_true(camera.yaw == yaw && camera.pitch == pitch && camera.roll == 5 && camera.tan_y_q28 == 6);
        view_direction(&camera, ahead);
        for (int i = 0; i < 3; i++) {
            const long double off = fabsl(target[i] - radius * ahead[i] - camera.eye_q8[i]);
            worst = fmax(worst, (double)(off - fabsl(radius / 268435456.0L)));
        }
    }
    printf("# worst place of an eye, beside 2^-28 of the radius: %.2f of the last place\n", worst);
    assert_true(worst < 1);
}

static void an_orbit_looks_at_its_target(void **state)
{
    struct random random = {23};

    (void)state;
    for (int k = 0; k < 1 << 14; k++) {
        const int32_t target[3] = {any_length(&random) / 64, any_length(&random) / 64, any_length(&random) / 64};
        const int32_t radius = (int32_t)random_in(&random, 1 << 16, 1 << 24);
        struct lim_camera orbiting, looking = {.yaw = 0};
        lim_orbit(&orbiting, target, radius, (uint32_t)random_u64(&random),
                  (uint32_t)random_in(&random, -(1 << 29), 1 << 29));
        lim_look_at(&looking, orbiting.eye_q8, target);
        const double rounding = (double)(turn / pi / radius);
        assert_true(apart(looking.yaw, orbiting.yaw) < 1.5 * rounding + 10);
        assert_true(apart(looking.pitch, orbiting.pitch) < rounding + 10);
    }
}

static void an_orbit_that_leaves_the_numbers_stays_at_their_end(void **state)
{
    const int32_t target[3] = {INT32_MAX - 10, INT32_MIN + 10, 0};
    struct lim_camera camera;

    (void)state;
    lim_orbit(&camera, target, 1 << 20, LIM_ANGLE_QUARTER, 0);
    assert_int_equal(camera.eye_q8[0], INT32_MAX);
    lim_orbit(&camera, target, INT32_MAX, 0, LIM_ANGLE_QUARTER);
    assert_int_equal(camera.eye_q8[1], INT32_MIN);
    lim_orbit(&camera, target, INT32_MIN, 0, 0); /* behind the camera */
    assert_int_equal(camera.eye_q8[2], INT32_MIN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_are_within_2_units),
        cmocka_unit_test(eighths_of_a_turn_are_exact),
        cmocka_unit_test(angles_of_mirrored_vectors_are_mirrored),
        cmocka_unit_test(degrees_are_rounded_to_nearest),
        cmocka_unit_test(degrees_are_those_of_compilers_with_short_doubles),
        cmocka_unit_test(the_target_is_in_the_middle),
        cmocka_unit_test(extremes_are_looked_at),
        cmocka_unit_test(what_has_no_direction_leaves_angles_alone),
        cmocka_unit_test(cameras_are_those_of_the_simulator),
        cmocka_unit_test(an_orbit_is_where_it_should_be),
        cmocka_unit_test(an_orbit_looks_at_its_target),
        cmocka_unit_test(an_orbit_that_leaves_the_numbers_stays_at_their_end),
    };

    return cmocka_run_group_tests_name("aim", tests, NULL, NULL);
}
