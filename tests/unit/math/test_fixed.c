/* SPDX-License-Identifier: MIT
 *
 * The fixed-point helpers against independent arithmetic: wide integers, and doubles where the
 * truth is irrational. fixed_vectors.c has their limits; here are their bounds. */
#include "rigs/cmocka_ready.h"

#include "camera.h"
#include "math/fixed.h"
#include "rigs/fixed_vectors.h"
#include "rigs/random.h"
#include "view/view.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* No box: the whole grid may be full. */
static const struct lim_scene grid_scene = {0};

static const double pi = 3.14159265358979323846;

static void show_if_wrong(const char *line)
{
    if (strstr(line, "should be")) printf("# %s\n", line);
}

static void every_helper_is_right_at_its_limits(void **state)
{
    (void)state;
    assert_int_equal(fixed_vectors_run(show_if_wrong), 0);
}

/* All 2^24 leading mantissas, and 2^20 numbers of every length. */
static void reciprocal_is_within_1_6_ulp(void **state)
{
    struct random random = {3};
    double worst = 0;

    (void)state;
    for (uint32_t m = UINT32_C(1) << 23; m < UINT32_C(1) << 24; m++) {
        uint8_t shift;
        const uint32_t z = m << 8 | (m * 37u & 255u);
        const double truth_q16 = 65536.0 * 2147483648.0 / z;
        const double error = fabs(recip_q16(z, &shift) - truth_q16);
        if (error > worst) worst = error;
        assert_int_equal(shift, 0);
    }
    for (int k = 0; k < 1 << 20; k++) {
        uint8_t shift;
        const uint32_t z = (uint32_t)(random_u64(&random) >> 32 >> (random_u64(&random) % 32)) | 1;
        const uint32_t got_q16 = recip_q16(z, &shift);
        assert_true(fabs(ldexp(got_q16, (int)shift - 47) * z - 1) < 1.6 / 32768);
    }
    printf("# worst error of the reciprocal: %.2f units of 2^-16\n", worst);
    assert_true(worst < 1.6);
}

/* Whichever of the two this build links: every entry, and between two entries every fraction. */
static void the_reciprocals_table_and_divisions_agree(void **state)
{
    (void)state;
    for (uint32_t m = UINT32_C(1) << 16; m < UINT32_C(1) << 17; m++) {
        const uint16_t *entry_q16 = &lim_recip_table_q16[(m >> 8) - 256];
        const uint32_t from_table_q24 = entry_q16[0] * 256u - (uint32_t)(entry_q16[0] - entry_q16[1]) * (m & 255);
        uint8_t shift;
        assert_int_equal(lim_recip_divided_q24(m << 15), from_table_q24);
        assert_int_equal(recip_q24(m << 15, &shift), from_table_q24);
    }
}

/* Where limbs carry, borrow or change sign: within two of 0, of every power of two and of both ends. */
static size_t fill_edge_cases(int32_t cases[static 5 * 33])
{
    size_t count = 0;

    for (int bit = 0; bit <= 32; bit++)
        for (int offset = -2; offset <= 2; offset++)
            cases[count++] = (int32_t)(uint32_t)((bit < 32 ? UINT64_C(1) << bit : 0) + (uint64_t)offset);
    return count;
}

static void limbs_multiply_like_wide_integers(void **state)
{
    enum { RANDOM_PAIRS = 10000000 };
    int32_t cases[5 * 33];
    const size_t count = fill_edge_cases(cases);
    struct random random = {6};

    (void)state;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < count; k++)
            assert_int_equal(mul_high_limbs_s32(cases[i], cases[k]), mul_high_long_s32(cases[i], cases[k]));
    for (int k = 0; k < RANDOM_PAIRS; k++) {
        const uint64_t pair = random_u64(&random);
        const int32_t a = (int32_t)(uint32_t)(pair >> 32), b = (int32_t)(uint32_t)pair;
        const uint16_t c = (uint16_t)pair;
        if (mul_high_limbs_s32(a, b) != mul_high_long_s32(a, b) ||
            mul_s32_top(a, c / 2 * 65536) != (int32_t)(((int64_t)a * (c / 2)) >> 16) ||
            mul_u32_top((uint32_t)a, (uint32_t)c << 16) != (uint32_t)(((uint64_t)(uint32_t)a * c) >> 16))
            fail_msg("%ld * %ld or %u", (long)a, (long)b, (unsigned)c);
    }
    assert_int_equal(mul_high_long_s32(INT32_MIN, INT32_MAX), -1073741824);
    assert_int_equal(mul_high_long_s32(INT32_MIN, INT32_MIN), 1073741824);
    assert_int_equal(mul_high_long_s32(-1, 1), -1);
}

static void ratio_is_within_8_units_of_2_31(void **state)
{
    struct random random = {4};
    double worst = 0;

    (void)state;
    for (int k = 0; k < 2000000; k++) {
        const uint32_t den = (uint32_t)(random_u64(&random) >> 32 >> (random_u64(&random) % 32)) | 1;
        const uint32_t num = (uint32_t)random_in(&random, 0, den);
        const uint32_t got = ratio_q31(num, den);
        const double error = fabs(got - 2147483648.0 * num / den);
        if (error > worst) worst = error;
        assert_true(got <= UINT32_C(1) << 31);
    }
    printf("# worst error of the ratio: %.2f units of 2^-31\n", worst);
    assert_true(worst < 8);
}

static void lerp_rounds_to_nearest_and_meets_its_ends(void **state)
{
    struct random random = {5};

    (void)state;
    for (int k = 0; k < 1000000; k++) {
        const int32_t a = (int32_t)random_in(&random, INT32_MIN, INT32_MAX);
        const int32_t b = (int32_t)random_in(&random, INT32_MIN, INT32_MAX);
        const uint32_t t_q31 = (uint32_t)random_in(&random, 0, INT64_C(1) << 31);
        const __int128 scaled = (__int128)a * (INT64_C(1) << 31) + ((__int128)b - a) * t_q31;
        assert_int_equal(lerp_q31(a, b, t_q31), (int64_t)((scaled + (1 << 30)) >> 31));
        assert_int_equal(lerp_q31(a, b, 0), a);
        assert_int_equal(lerp_q31(a, b, UINT32_C(1) << 31), b);
    }
}

static void sine_is_within_4_units_of_2_30(void **state)
{
    double worst = 0;

    (void)state;
    for (uint64_t k = 0; k < UINT64_C(1) << 32; k += 4093) { /* all four quadrants */
        const uint32_t angle = (uint32_t)k;
        const double turn = 2 * pi * angle / 4294967296.0;
        const double error = fabs(lim_sin_q30(angle) - 1073741824.0 * sin(turn));
        const double cosine_error = fabs(lim_cos_q30(angle) - 1073741824.0 * cos(turn));
        if (error > worst) worst = error;
        if (cosine_error > worst) worst = cosine_error;
    }
    printf("# worst error of sine and cosine: %.2f units of 2^-30\n", worst);
    assert_true(worst < 4);
}

static struct lim_camera random_camera(struct random *random, int64_t range_q8)
{
    struct lim_camera camera = {.near_q8 = 256 * 4};

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)random_in(random, -range_q8, range_q8);
    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_u64(random);
    camera.roll = (uint32_t)random_u64(random);
    assert_int_equal(lim_camera_set_fov(&camera, (uint32_t)random_in(random, 1 << 28, 1 << 30), 240, 180), LIM_OK);
    return camera;
}

/* View coordinates over z, by the definition in limner.h's words: yaw, pitch, then roll. */
static void reference_ratios(const struct lim_camera *c, const struct lim_vertex *v, double out[3])
{
    const double yaw = 2 * pi * c->yaw / 4294967296.0, pitch = 2 * pi * c->pitch / 4294967296.0;
    const double roll = 2 * pi * c->roll / 4294967296.0;
    const double d[3] = {v->x - c->eye_q8[0] / 256.0, v->y - c->eye_q8[1] / 256.0, v->z - c->eye_q8[2] / 256.0};
    const double right0[3] = {cos(yaw), 0, -sin(yaw)};
    const double up0[3] = {sin(yaw) * sin(pitch), cos(pitch), cos(yaw) * sin(pitch)};
    const double ahead[3] = {-sin(yaw) * cos(pitch), sin(pitch), -cos(yaw) * cos(pitch)};
    double x = 0, y = 0, z = 0;

    for (int i = 0; i < 3; i++) {
        x += d[i] * (right0[i] * cos(roll) - up0[i] * sin(roll));
        y -= d[i] * (up0[i] * cos(roll) + right0[i] * sin(roll));
        z += d[i] * ahead[i];
    }
    out[0] = x / z / (c->tan_x_q28 / 268435456.0);
    out[1] = y / z / (c->tan_y_q28 / 268435456.0);
    out[2] = z;
}

/* Vertices in view, from `range` units of eye positions: how far off is the pixel? */
static double worst_projection_px(int64_t range_q8, uint64_t seed, uint16_t side_px)
{
    struct random random = {seed};
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view;
    double worst = 0;
    int seen = 0;

    lim_view_init(&view, side_px, side_px, cache);
    for (int k = 0; k < 400000 || seen < 1000; k++) {
        const struct lim_camera camera = random_camera(&random, range_q8);
        const struct lim_vertex v = {(int16_t)random_u64(&random), (int16_t)random_u64(&random),
                                     (int16_t)random_u64(&random)};
        struct lim_view_point p;
        double truth[3];
        assert_true(lim_view_begin(&view, &grid_scene, &camera));
        lim_view_transform(&view, &grid_scene, &v, &p);
        reference_ratios(&camera, &v, truth);
        if (truth[2] < 1000 || fabs(truth[0]) > 1 || fabs(truth[1]) > 1) continue;
        struct lim_point at;
        lim_view_project(&view, &p, &at);
        const double x_px = (truth[0] + 1) * side_px / 2 - 0.5, y_px = (truth[1] + 1) * side_px / 2 - 0.5;
        const double error = fmax(fabs((double)at.x / LIM_SUB - x_px), fabs((double)at.y / LIM_SUB - y_px));
        if (error > worst) worst = error;
        seen++;
    }
    return worst;
}

static void vertices_project_within_a_sixteenth_of_a_pixel(void **state)
{
    const double inside = worst_projection_px(32767 * 256, 6, 240);
    const double near_by = worst_projection_px(100000 * 256, 7, 240);
    const double far = worst_projection_px((INT64_C(1) << 28) - 1, 8, 240);
    const double wide = worst_projection_px(32767 * 256, 9, 1024);

    (void)state;
    printf("# worst vertex error at 240 px: %.4f px from inside, %.4f beside, %.4f far away; at 1024 px: %.4f\n",
           inside, near_by, far, wide);
    assert_true(inside < 0.0625 && near_by < 0.0625 && far < 0.0625);
    assert_true(wide < 0.25);
}

static void field_of_view_is_the_tangent_of_half_the_angle(void **state)
{
    struct lim_camera camera;

    (void)state;
    for (int degrees = 2; degrees <= 150; degrees++) {
        const uint32_t fov = (uint32_t)(degrees / 360.0 * 4294967296.0);
        const double truth = tan(pi * degrees / 360) * 268435456.0;
        assert_int_equal(lim_camera_set_fov(&camera, fov, 100, 100), LIM_OK);
        assert_true(fabs(camera.tan_y_q28 - truth) < 64 * (1 + truth / 268435456.0));
        assert_int_equal(camera.tan_x_q28, camera.tan_y_q28);
    }
    assert_int_equal(lim_camera_set_fov(&camera, UINT32_C(1) << 31, 100, 100), LIM_ERR_CAMERA);
    assert_int_equal(lim_camera_set_fov(&camera, 0, 100, 100), LIM_ERR_CAMERA);
    assert_int_equal(lim_camera_set_fov(&camera, UINT32_C(1) << 30, 900, 100), LIM_ERR_CAMERA);
    assert_int_equal(lim_camera_set_fov(&camera, UINT32_C(1) << 30, 100, 0), LIM_ERR_CAMERA);
}

/* Each tangent is the nearest to what it is computed from, ties up: |2 t c - 2 s| <= c, in 128 bits. */
static void field_of_view_is_rounded_to_nearest(void **state)
{
    struct random random = {23};

    (void)state;
    for (int i = 0; i < 20000; i++) {
        const uint32_t fov_y = (uint32_t)random_in(&random, INT64_C(1) << 24, INT64_C(1) << 30);
        const uint16_t w_px = (uint16_t)random_in(&random, 1, 480), h_px = (uint16_t)random_in(&random, 1, 480);
        struct lim_camera camera;
        if (lim_camera_set_fov(&camera, fov_y, w_px, h_px)) continue;
        const __int128 sine = lim_sin_q30(fov_y / 2), cosine = lim_cos_q30(fov_y / 2);
        const __int128 off_y = 2 * (camera.tan_y_q28 * cosine - (sine << 28));
        const __int128 off_x = 2 * ((__int128)camera.tan_x_q28 * h_px - (__int128)camera.tan_y_q28 * w_px);
        assert_true(-cosine <= off_y && off_y <= cosine);
        assert_true(-h_px <= off_x && off_x <= h_px);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_helper_is_right_at_its_limits),
        cmocka_unit_test(reciprocal_is_within_1_6_ulp),
        cmocka_unit_test(the_reciprocals_table_and_divisions_agree),
        cmocka_unit_test(limbs_multiply_like_wide_integers),
        cmocka_unit_test(ratio_is_within_8_units_of_2_31),
        cmocka_unit_test(lerp_rounds_to_nearest_and_meets_its_ends),
        cmocka_unit_test(sine_is_within_4_units_of_2_30),
        cmocka_unit_test(vertices_project_within_a_sixteenth_of_a_pixel),
        cmocka_unit_test(field_of_view_is_the_tangent_of_half_the_angle),
        cmocka_unit_test(field_of_view_is_rounded_to_nearest),
    };

    return cmocka_run_group_tests_name("fixed", tests, NULL, NULL);
}
