/* SPDX-License-Identifier: MIT
 *
 * The table of firmware/math/README.md against what its functions do: each is measured over its domain against long
 * doubles and 128 bits, at the ends of the domain and at random. */
#include "camera.h"
#include "math/fixed.h"
#include "math/isqrt.h"
#include "math/orientation.h"
#include "math/wide.h"
#include "rigs/camera_axes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 4000000, LINE_B = 1024 };

static const long double pi = 3.141592653589793238462643383279502884L;
static struct random numbers;

/* A length in bits at random, so that small numbers come as often as large ones; and the ends. */
static uint64_t any_u64(void)
{
    static const uint64_t ends[] = {0, 1, 2, UINT32_MAX, UINT64_MAX, UINT64_C(1) << 63, UINT64_C(1) << 32};
    const uint64_t which = random_u64(&numbers) >> 32;

    if (which % 64 < sizeof ends / sizeof *ends) return ends[which % 64];
    return random_u64(&numbers) >> (which >> 8) % 64;
}

static uint32_t any_u32(void)
{
    static const uint32_t ends[] = {0, 1, 2, UINT32_MAX, 1u << 31, (1u << 31) - 1, 1u << 30};
    const uint64_t which = random_u64(&numbers) >> 32;

    if (which % 64 < sizeof ends / sizeof *ends) return ends[which % 64];
    return (uint32_t)(random_u64(&numbers) >> 32) >> (which >> 8) % 32;
}

static int32_t any_s32(void)
{
    const uint32_t size = any_u32() & INT32_MAX;

    return random_u64(&numbers) >> 63 ? -(int32_t)size - 1 : (int32_t)size;
}

static int32_t any_fraction_q30(void)
{
    return (int32_t)random_in(&numbers, -(INT64_C(1) << 30), INT64_C(1) << 30);
}

static double of_sine(void)
{
    const uint32_t angle = any_u32();
    return (double)fabsl((long double)lim_sin_q30(angle) -
                         sinl((long double)angle * pi / 2147483648.0L) * 1073741824.0L);
}

static double of_cosine(void)
{
    const uint32_t angle = any_u32();
    return (double)fabsl((long double)lim_cos_q30(angle) -
                         cosl((long double)angle * pi / 2147483648.0L) * 1073741824.0L);
}

static double of_arctangent(void)
{
    const int32_t y = any_s32(), x = any_s32();
    const long double truth = x || y ? atan2l(y, x) * 2147483648.0L / pi : 0;
    const long double off = fabsl((long double)lim_atan2(y, x) - truth);
    return (double)fminl(off, fabsl(off - 4294967296.0L));
}

/* An exact result is off by 0, any other one by 1 at least. */
static double wrong(bool is_wrong)
{
    return is_wrong ? 1 : 0;
}

static double of_root(void)
{
    const uint64_t x = any_u64();
    const unsigned __int128 root = lim_isqrt(x);
    return wrong(root * root > x || (root + 1) * (root + 1) <= x);
}

/* How far the result is from num / 2^bits, which no floating point holds. */
static double from_shifted(__int128 result, __int128 num, unsigned bits)
{
    const __int128 off = result * ((__int128)1 << bits) - num;
    return (double)((long double)(off < 0 ? -off : off) / ldexpl(1, (int)bits));
}

static double of_product(void)
{
    const int32_t a_q30 = any_s32(), b_q30 = any_fraction_q30();
    return from_shifted(lim_mul_q30(a_q30, b_q30), (__int128)a_q30 * b_q30, 30);
}

static double of_high(void)
{
    const int32_t a = any_s32(), b = any_s32();
    return wrong(mul_high_s32(a, b) != (int64_t)(((__int128)a * b) >> 32));
}

static double of_top(void)
{
    const int32_t a = any_s32(), b = any_s32() & 0x7FFF0000;
    return wrong(mul_s32_top(a, b) != (int64_t)(((__int128)a * b) >> 32));
}

static double of_shift_32(void)
{
    const uint32_t bits = (uint32_t)random_in(&numbers, 1, 30);
    const int32_t end = INT32_MAX - (INT32_C(1) << (bits - 1)), x = any_s32();
    const int32_t within = x > end ? end : x < -end ? -end : x;
    return from_shifted(shift_round_s32(within, bits), within, bits);
}

static double of_shift_64(void)
{
    const uint8_t bits = (uint8_t)random_in(&numbers, 1, 62);
    const int64_t x = (int64_t)any_u64() >> 1;
    return from_shifted(shift_round_s64(x, bits), x, bits);
}

static double of_lerp(void)
{
    const int32_t a = any_s32(), b = any_s32();
    const uint32_t t_q31 = (uint32_t)random_in(&numbers, 0, INT64_C(1) << 31);
    return from_shifted((__int128)lerp_q31(a, b, t_q31) - a, ((__int128)b - a) * t_q31, 31);
}

/* 1 / z in the reciprocal's own format: of `bits` more than its shift is. */
static double from_reciprocal(uint32_t r, uint32_t z, uint8_t shift, int bits)
{
    return (double)fabsl((long double)r - ldexpl(1, bits - shift) / (long double)z);
}

static double of_recip_24(void)
{
    uint8_t shift;
    const uint32_t z = any_u32() | 1, r = recip_q24(z, &shift);
    return from_reciprocal(r, z, shift, 55);
}

static double of_recip_16(void)
{
    uint8_t shift;
    const uint32_t z = any_u32() | 1, r = recip_q16(z, &shift);
    return from_reciprocal(r, z, shift, 47);
}

static double of_recip_15(void)
{
    uint8_t shift;
    const uint32_t z = any_u32() | 1, r = recip_q15_of(z, &shift);
    return from_reciprocal(r, z, shift, 46);
}

static double of_recip_31(void)
{
    uint8_t shift;
    const uint32_t z = any_u32() | 1, r = recip_q31_of(z, &shift);
    return from_reciprocal(r, z, shift, 62);
}

static double of_ratio(void)
{
    const uint32_t den = any_u32() | 1, num = (uint32_t)random_in(&numbers, 0, den);
    return (double)fabsl((long double)ratio_q31(num, den) - (long double)num / (long double)den * 2147483648.0L);
}

static double of_zeros(void)
{
    const uint32_t x = any_u32() | 1;
    return wrong(clz_u32(x) != 31 - (int)floorl(log2l((long double)x)));
}

static double of_compare(void)
{
    const uint64_t a = any_u64(), b = any_u64(), c = random_u64(&numbers) % 4 ? any_u64() : b, d = a;
    const unsigned __int128 ab = (unsigned __int128)a * b, cd = (unsigned __int128)c * d;
    const int32_t sign = lim_wide_compare(a, b, c, d);
    return wrong((sign > 0) - (sign < 0) != (ab > cd) - (ab < cd));
}

static double of_orientation(void)
{
    static const int sign[3] = {1, -1, 1}; /* right, down, ahead */
    const struct lim_camera camera = {.yaw = any_u32(), .pitch = any_u32(), .roll = any_u32()};
    long double axes[3][3], worst = 0;
    int32_t axes_q30[9];

    camera_axes_set(&camera, axes);
    lim_orientation_set(axes_q30, &camera);
    for (int i = 0; i < 9; i++)
        worst = fmaxl(worst, fabsl((long double)axes_q30[i] - sign[i / 3] * axes[i / 3][i % 3] * 1073741824.0L));
    return (double)worst;
}

static const struct {
    const char *name;
    double (*error)(void); /* of one call, at random */
} functions[] = {
    {"lim_sin_q30", of_sine},      {"lim_cos_q30", of_cosine},       {"lim_atan2", of_arctangent},
    {"lim_isqrt", of_root},        {"lim_mul_q30", of_product},      {"mul_high_s32", of_high},
    {"mul_s32_top", of_top},       {"shift_round_s32", of_shift_32}, {"shift_round_s64", of_shift_64},
    {"lerp_q31", of_lerp},         {"recip_q24", of_recip_24},       {"recip_q16", of_recip_16},
    {"recip_q15_of", of_recip_15}, {"recip_q31_of", of_recip_31},    {"ratio_q31", of_ratio},
    {"clz_u32", of_zeros},         {"lim_wide_compare", of_compare}, {"lim_orientation_set", of_orientation}};

enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* The last column of a row that begins with the function's name; negative: there is no such row. */
static double stated_error(const char *name)
{
    char line[LINE_B], begin[64];
    double stated = -1;
    FILE *file = fopen("firmware/math/README.md", "r");

    assert_non_null(file);
    snprintf(begin, sizeof begin, "| `%s` |", name);
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, begin, strlen(begin)) != 0) continue;
        line[strlen(line) - 2] = '\0';
        const char *cell = strrchr(line, '|') + 1;
        stated = strstr(cell, "exact") ? 0 : strtod(cell, NULL);
    }
    fclose(file);
    return stated;
}

static int rows_of_table(void)
{
    char line[LINE_B];
    int rows = 0;
    FILE *file = fopen("firmware/math/README.md", "r");

    assert_non_null(file);
    while (fgets(line, sizeof line, file))
        rows += strncmp(line, "| `", 3) == 0;
    fclose(file);
    return rows;
}

static void errors_are_those_of_the_table(void **state)
{
    const int samples = effort(SAMPLES);

    (void)state;
    assert_int_equal(rows_of_table(), FUNCTIONS);
    for (int i = 0; i < FUNCTIONS; i++) {
        const double stated = stated_error(functions[i].name);
        double worst = 0;
        numbers = (struct random){(uint64_t)i + 1};
        for (int k = 0; k < samples; k++)
            worst = fmax(worst, functions[i].error());
        printf("# %s: %.4f of %.4f\n", functions[i].name, worst, stated);
        if (!(worst <= stated)) fail_msg("%s: %g units, and the table has %g", functions[i].name, worst, stated);
        if (worst < stated / 2 && samples == SAMPLES)
            fail_msg("%s: %g units alone, and the table has %g", functions[i].name, worst, stated);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(errors_are_those_of_the_table)};

    return cmocka_run_group_tests_name("math_table", tests, NULL, NULL);
}
