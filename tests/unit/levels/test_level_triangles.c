/* SPDX-License-Identifier: MIT
 *
 * Triangulations of random points and lines: they cover the frame once, lines are edges of them, and no corner lies
 * within the circle of a triangle beside it unless a line parts them. Circles are computed in another way, by GMP. */
#include "levels/level_triangles.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"

#include <gmp.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 120 };

static uint32_t end_of(const struct triangles *t, uint32_t half)
{
    return t->origin[half_next(half)];
}

/* The determinant of the lifted points, as the textbooks have it. */
static int circle_sign(const struct triangles *t, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    const uint32_t rows[3] = {a, b, c};
    mpz_t m[3][3], left, right, sum;
    mpz_inits(left, right, sum, NULL);
    for (int i = 0; i < 3; i++) {
        const long x = t->points[rows[i]][0] - t->points[d][0], y = t->points[rows[i]][1] - t->points[d][1];
        const long entries[3] = {x, y, x * x + y * y};
        for (int k = 0; k < 3; k++)
            mpz_init_set_si(m[i][k], entries[k]);
    }
    for (int k = 0; k < 3; k++) {
        mpz_mul(left, m[1][(k + 1) % 3], m[2][(k + 2) % 3]);
        mpz_mul(right, m[1][(k + 2) % 3], m[2][(k + 1) % 3]);
        mpz_sub(left, left, right);
        mpz_addmul(sum, left, m[0][k]);
    }
    const int sign = mpz_sgn(sum);
    for (int i = 0; i < 9; i++)
        mpz_clear(m[i / 3][i % 3]);
    mpz_clears(left, right, sum, NULL);
    return sign;
}

static void assert_covers(const struct triangles *t)
{
    int64_t area2 = 0;
    for (uint32_t half = 0; half < t->half_count; half++) {
        const uint32_t twin = t->twin[half];
        if (half % 3 == 0) {
            const int64_t own = triangles_side(t, t->origin[half], t->origin[half + 1], t->origin[half + 2]);
            assert_true(own > 0);
            area2 += own;
        }
        if (twin == TRIANGLES_NONE) continue;
        assert_int_equal(t->twin[twin], half);
        assert_int_equal(t->origin[twin], end_of(t, half));
        assert_int_equal(t->is_fixed[twin], t->is_fixed[half]);
    }
    const int64_t side = t->points[2][0] - t->points[0][0];
    assert_true(area2 == 2 * side * side);
    for (uint32_t i = 0; i < t->point_count; i++)
        assert_int_equal(t->origin[t->leaving[i]], i);
}

static void assert_delaunay(const struct triangles *t)
{
    for (uint32_t half = 0; half < t->half_count; half++) {
        const uint32_t twin = t->twin[half];
        if (twin == TRIANGLES_NONE || t->is_fixed[half]) continue;
        assert_true(circle_sign(t, t->origin[half], end_of(t, half), t->origin[half_before(half)],
                                t->origin[half_before(twin)]) <= 0);
    }
}

static uint32_t random_points(struct random *random, int reach, int16_t (*points)[2])
{
    uint32_t count = 0;
    for (int i = 0; i < MOST; i++) {
        bool is_new = true;
        points[count][0] = (int16_t)random_in(random, -reach, reach);
        points[count][1] = (int16_t)random_in(random, -reach, reach);
        for (uint32_t k = 0; k < count; k++)
            is_new &= memcmp(points[k], points[count], sizeof points[k]) != 0;
        count += is_new;
    }
    return count;
}

static void assert_line_lies(const struct triangles *t, uint32_t from, uint32_t to)
{
    while (from != to) {
        const uint32_t half = triangles_along(t, from, to);
        assert_true(half != TRIANGLES_NONE && t->is_fixed[half]);
        from = end_of(t, half);
    }
}

static bool crosses(const struct triangles *t, const uint32_t a[2], const uint32_t b[2])
{
    const int64_t sides[4] = {triangles_side(t, a[0], a[1], b[0]), triangles_side(t, a[0], a[1], b[1]),
                              triangles_side(t, b[0], b[1], a[0]), triangles_side(t, b[0], b[1], a[1])};
    return ((sides[0] < 0 && sides[1] > 0) || (sides[0] > 0 && sides[1] < 0)) &&
           ((sides[2] < 0 && sides[3] > 0) || (sides[2] > 0 && sides[3] < 0));
}

static uint32_t random_point(const struct triangles *t, struct random *random)
{
    return (uint32_t)random_in(random, TRIANGLES_FRAME, t->point_count - 1);
}

/* Of random lines those are refused that cross one that was taken, and no others. */
static void try_lines(struct triangles *t, struct random *random)
{
    uint32_t taken[MOST][2];
    size_t count = 0;
    for (int i = 0; i < MOST; i++) {
        const uint32_t line[2] = {random_point(t, random), random_point(t, random)};
        bool is_in_way = false;
        for (size_t k = 0; k < count; k++)
            is_in_way |= crosses(t, line, taken[k]);
        if (is_in_way) continue; /* it would be taken in part */
        assert_true(triangles_fix(t, line[0], line[1]));
        memcpy(taken[count++], line, sizeof line);
    }
    for (size_t k = 0; k < count; k++)
        assert_line_lies(t, taken[k][0], taken[k][1]);
}

static void run_random(int reach)
{
    struct random random = {(uint64_t)reach};
    for (int run = 0; run < effort(40); run++) {
        int16_t points[MOST][2];
        struct triangles t;
        triangles_make(&t, (const int16_t(*)[2])points, random_points(&random, reach, points));
        assert_covers(&t);
        assert_delaunay(&t);
        try_lines(&t, &random);
        assert_covers(&t);
        triangles_settle(&t);
        assert_covers(&t);
        assert_delaunay(&t);
        triangles_free(&t);
    }
}

static void points_all_over_the_range_are_covered_and_delaunay(void **state)
{
    (void)state;
    run_random(32767);
}

static void points_on_a_coarse_lattice_lie_on_lines_and_circles_and_make_no_difference(void **state)
{
    (void)state;
    run_random(6);
}

static void a_line_that_crosses_another_is_refused(void **state)
{
    (void)state;
    static const int16_t points[4][2] = {{0, 0}, {10, 10}, {0, 10}, {10, 0}};
    struct triangles t;
    triangles_make(&t, points, 4);
    assert_true(triangles_fix(&t, 4, 5));
    assert_false(triangles_fix(&t, 6, 7));
    assert_covers(&t);
    triangles_free(&t);
}

static void a_place_is_found_in_its_triangle(void **state)
{
    (void)state;
    static const int16_t points[3][2] = {{0, 0}, {100, 0}, {0, 100}};
    struct triangles t;
    triangles_make(&t, points, 3);
    const uint32_t inside = triangles_at(&t, 10, 10);
    bool is_ours = true;
    for (uint32_t half = 3 * inside; half < 3 * inside + 3; half++)
        is_ours &= t.origin[half] >= TRIANGLES_FRAME;
    assert_true(is_ours);
    assert_true(triangles_at(&t, -10, -10) != inside);
    triangles_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_all_over_the_range_are_covered_and_delaunay),
        cmocka_unit_test(points_on_a_coarse_lattice_lie_on_lines_and_circles_and_make_no_difference),
        cmocka_unit_test(a_line_that_crosses_another_is_refused),
        cmocka_unit_test(a_place_is_found_in_its_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
