/* SPDX-License-Identifier: MIT
 *
 * Rational points: exact where doubles cannot be, and stored planes that keep their promises. */
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "trees/exact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct grid metres = {.units_per_m = 1.0};

static uint32_t add(struct exact_points *points, double x, double y, double z)
{
    const double at_m[3] = {x, y, z};
    return exact_add_m(points, at_m, &metres);
}

static struct plane plane_of(int64_t a, int64_t b, int64_t c, int64_t d)
{
    const double length = sqrt((double)a * (double)a + (double)b * (double)b + (double)c * (double)c);
    return (struct plane){.n = {a, b, c}, .d = d, .kind = PLANE_LARGE, .length = length};
}

static struct plane random_plane(struct random *random, int64_t most)
{
    int64_t n[3];
    for (int k = 0; k < 3; k++)
        n[k] = random_in(random, -most, most);
    return plane_of(n[0], n[1], n[2] | 1, random_in(random, -most * 30000, most * 30000));
}

static void scaling_to_units_does_not_round(void **state)
{
    (void)state;
    struct exact_points points = {0};
    const struct grid grid = {.origin_m = {0.1, 0.0, 0.0}, .units_per_m = 3.0};
    const double at_m[3] = {0.3, 1e-300, 0x1p52};
    uint32_t point = exact_add_m(&points, at_m, &grid);
    mpq_t expected, other;
    mpq_inits(expected, other, NULL);
    mpq_set_d(expected, 0.3);
    mpq_set_d(other, 0.1);
    mpq_sub(expected, expected, other);
    mpq_set_ui(other, 3, 1);
    mpq_mul(expected, expected, other);
    assert_true(mpq_equal(points.at[point][0], expected));
    assert_true(mpq_sgn(points.at[point][1]) > 0);
    assert_true(points.approx[point][2] == 3.0 * 0x1p52);
    mpq_clears(expected, other, NULL);
    exact_free(&points);
}

static void snapping_rounds_halves_up(void **state)
{
    (void)state;
    static const struct {
        double at;
        int snapped;
    } cases[] = {{0.5, 1},           {-0.5, 0},   {1.5, 2},          {-1.5, -1},         {0.49999999999999994, 0},
                 {2.25, 2},          {-2.75, -3}, {32767.25, 32767}, {-32767.5, -32767}, {-32767.25, -32767},
                 {-0.5000000001, -1}};
    struct exact_points points = {0};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const struct grid_point snapped = exact_snap(&points, add(&points, cases[i].at, -cases[i].at, 7.0), 0);
        assert_int_equal(snapped.q8[0], cases[i].snapped * 256);
        assert_int_equal(snapped.q8[2], 7 * 256);
        const struct grid_point finer =
            exact_snap(&points, add(&points, cases[i].at / 256.0, -cases[i].at / 256.0, 7.125), 8);
        assert_int_equal(finer.q8[0], cases[i].snapped);
        assert_int_equal(finer.q8[2], 7 * 256 + 32);
    }
    exact_free(&points);
}

/* The crossing of a random line lies exactly on the plane: a test that rounds would call about
 * half of them front or back. Moved by 2^-300 it lies exactly beside it. */
static void a_crossing_lies_exactly_on_plane_and_line(void **state)
{
    (void)state;
    struct random random = {1};
    struct exact_points points = {0};
    mpq_t tiny;
    mpq_init(tiny);
    mpz_ui_pow_ui(mpq_denref(tiny), 2, 300);
    mpz_set_ui(mpq_numref(tiny), 1);
    for (int i = 0; i < 2000; i++) {
        struct plane plane = random_plane(&random, INT64_C(1) << (1 + i % 30));
        double at[2][3];
        for (int k = 0; k < 6; k++)
            at[k / 3][k % 3] = random_unit(&random) * 65534.0 - 32767.0;
        uint32_t a = add(&points, at[0][0], at[0][1], at[0][2]), b = add(&points, at[1][0], at[1][1], at[1][2]);
        uint32_t cut = exact_add_crossing(&points, a, b, &plane);
        assert_int_equal(exact_side(&points, cut, &plane), 0);
        for (int k = 0; k < 3; k++) {
            uint32_t again = exact_add_crossing(&points, b, a, &plane);
            assert_true(mpq_equal(points.at[again][k], points.at[cut][k]));
        }
        mpq_add(points.at[cut][2], points.at[cut][2], tiny);
        assert_int_equal(exact_side(&points, cut, &plane), plane.n[2] > 0 ? 1 : -1);
        assert_int_equal(exact_compare(&points, cut, exact_add_crossing(&points, a, b, &plane), 2), 1);
        exact_truncate(&points, 0);
    }
    mpq_clear(tiny);
    exact_free(&points);
}

/* The oracle multiplies everything out in integers: coordinates are multiples of 2^-20. */
static void sides_agree_with_whole_numbers(void **state)
{
    (void)state;
    struct random random = {2};
    struct exact_points points = {0};
    int zeros = 0;
    for (int i = 0; i < 100000; i++) {
        struct plane plane = random_plane(&random, 1000);
        int64_t at_q20[3], value = 0;
        for (int k = 0; k < 3; k++)
            at_q20[k] = random_in(&random, -32767, 32767) * (1 << 20);
        for (int k = 0; k < 3; k++)
            value += plane.n[k] * at_q20[k];
        plane.d = value / (1 << 20) + random_in(&random, -1, 1);
        at_q20[0] += random_in(&random, -1, 1);
        value = -plane.d * (1 << 20);
        for (int k = 0; k < 3; k++)
            value += plane.n[k] * at_q20[k];
        uint32_t point =
            add(&points, (double)at_q20[0] / (1 << 20), (double)at_q20[1] / (1 << 20), (double)at_q20[2] / (1 << 20));
        assert_int_equal(exact_side(&points, point, &plane), (value > 0) - (value < 0));
        zeros += value == 0;
        exact_truncate(&points, 0);
    }
    assert_true(zeros > 1000);
    exact_free(&points);
}

/* Stored planes ------------------------------------------------------------------------------ */

enum { FIT_POINTS = 500 };

struct fit_rig {
    double corners[4][3], points[FIT_POINTS][3];
    struct point_blocks blocks;
    struct plane_fit fit;
};

/* A square patch of half a side somewhere on the plane through `at` with a normal, and points at
 * distances 0 and 1 from the ideal plane as well as anywhere. point_blocks_free() them. */
static void fit_setup(struct fit_rig *rig, struct random *random, const double normal[3], double side, double tolerance)
{
    double along[3] = {normal[1] - normal[2], normal[2] - normal[0], normal[0] - normal[1]}, across[3], at[3];
    double length = sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    for (int k = 0; k < 3; k++) {
        along[k] /= length;
        at[k] = random_unit(random) * 20000.0 - 10000.0;
    }
    for (int k = 0; k < 3; k++)
        across[k] = normal[(k + 1) % 3] * along[(k + 2) % 3] - normal[(k + 2) % 3] * along[(k + 1) % 3];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            rig->corners[i][k] = at[k] + (i & 1 ? side : -side) * along[k] + (i & 2 ? side : -side) * across[k];
    for (int i = 0; i < FIT_POINTS; i++) {
        double u = random_unit(random) * 40000.0 - 20000.0, v = random_unit(random) * 40000.0 - 20000.0;
        double off = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : random_unit(random) * 10000.0;
        for (int k = 0; k < 3; k++)
            rig->points[i][k] = at[k] + u * along[k] + v * across[k] + off * normal[k];
    }
    point_blocks_build(&rig->blocks, rig->points, FIT_POINTS);
    rig->fit = (struct plane_fit){
        .corners = rig->corners, .corner_count = 4, .blocks = &rig->blocks, .tolerance_units = tolerance};
    memcpy(rig->fit.normal, normal, sizeof rig->fit.normal);
}

static void assert_within_bounds(const struct plane *plane)
{
    int64_t sum = 0, longest = 0;
    for (int k = 0; k < 3; k++) {
        int64_t size = llabs((long long)plane->n[k]);
        sum += size;
        longest = size > longest ? size : longest;
    }
    if (plane->kind == PLANE_LARGE) {
        assert_true(longest <= INT64_C(1) << 30 && llabs((long long)plane->d) < INT64_C(1) << 48);
        return;
    }
    assert_true(sum > 0 && sum <= 32767 && llabs((long long)plane->d) <= LIM_PLANE_D_MAX);
    if (plane->kind == PLANE_XZ) assert_true(plane->n[1] == 0);
    if (plane->kind <= PLANE_Z) assert_true(sum == 1 && plane->n[plane->kind] == 1);
}

/* With the tolerance: what lies on the ideal plane stays on the stored one, a unit off stays off. */
static void stored_planes_decide_as_ideal_ones(void **state)
{
    (void)state;
    struct random random = {3};
    int kinds[6] = {0};
    for (int i = 0; i < 400; i++) {
        double normal[3] = {random_unit(&random) - 0.5, i % 4 == 0 ? 0.0 : random_unit(&random) - 0.5,
                            random_unit(&random) - 0.5};
        double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (int k = 0; k < 3; k++)
            normal[k] = i % 8 == 1 ? (k == i / 8 % 3 ? -1.0 : 0.0) : normal[k] / length;
        struct fit_rig rig;
        struct plane plane;
        double tolerance = i % 5 ? 0.5 : 0.001;
        fit_setup(&rig, &random, normal, 1000.0, tolerance);
        plane_store(&rig.fit, &plane);
        point_blocks_free(&rig.blocks);
        kinds[plane.kind]++;
        assert_within_bounds(&plane);
        double facing = 0.0;
        for (int k = 0; k < 3; k++)
            facing += (double)plane.n[k] * normal[k];
        for (int p = 0; p < FIT_POINTS; p++) {
            double distance = plane_distance(&plane, rig.points[p]) * (facing < 0.0 ? -1.0 : 1.0);
            if (p % 3 == 0) assert_true(fabs(distance) <= tolerance);
            if (p % 3 == 1) assert_true(distance > tolerance);
        }
    }
    for (int kind = 0; kind < 6; kind++)
        assert_true(kinds[kind] > 0);
}

static void simple_normals_stay_simple(void **state)
{
    (void)state;
    struct random random = {4};
    struct fit_rig rig;
    struct plane plane;
    const double diagonal[3] = {sqrt(0.5), 0.0, -sqrt(0.5)};
    fit_setup(&rig, &random, diagonal, 100.0, 0.5);
    plane_store(&rig.fit, &plane);
    point_blocks_free(&rig.blocks);
    assert_int_equal(plane.kind, PLANE_XZ);
    assert_int_equal(plane.n[0], -plane.n[2]);
    const double slope[3] = {2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0};
    fit_setup(&rig, &random, slope, 100.0, 0.5);
    plane_store(&rig.fit, &plane);
    point_blocks_free(&rig.blocks);
    assert_int_equal(plane.n[0], plane.n[1]);
    assert_int_equal(plane.n[0], 2 * plane.n[2]);
}

/* Against the definition in rationals: n * 8191 / longest and d * 8191 / longest to nearest. */
static void filters_are_exact_planes_scaled_and_rounded(void **state)
{
    (void)state;
    struct random random = {5};
    for (int i = 0; i < 100000; i++) {
        int64_t n[3], longest = 0;
        for (int k = 0; k < 3; k++) {
            n[k] = random_in(&random, -(INT64_C(1) << 30), INT64_C(1) << 30) / (1 << (i % 8 * k));
            longest = llabs((long long)n[k]) > longest ? llabs((long long)n[k]) : longest;
        }
        if (longest < INT64_C(1) << 28) continue; /* the compiler's normals are long */
        int64_t d = random_in(&random, -90000 * longest, 90000 * longest);
        struct lim_plane filter = plane_filter(n, d, 7);
        const long long scaled[3] = {lim_plane_x(&filter), lim_plane_y(&filter), lim_plane_z(&filter)};
        for (int k = 0; k < 3; k++)
            assert_true(llabs(2 * (n[k] * 8191 - scaled[k] * longest)) <= longest);
        assert_true(llabs(2 * (d * 8191 - lim_plane_d(&filter) * (long long)longest)) <= longest);
        assert_int_equal(lim_plane_exact(&filter), 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scaling_to_units_does_not_round),
        cmocka_unit_test(snapping_rounds_halves_up),
        cmocka_unit_test(a_crossing_lies_exactly_on_plane_and_line),
        cmocka_unit_test(sides_agree_with_whole_numbers),
        cmocka_unit_test(stored_planes_decide_as_ideal_ones),
        cmocka_unit_test(simple_normals_stay_simple),
        cmocka_unit_test(filters_are_exact_planes_scaled_and_rounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
