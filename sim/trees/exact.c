/* SPDX-License-Identifier: MIT
 *
 * Rational points and the exact tests on them. A double filter stands in front of each test; its
 * error bounds are derived where they are used. */
#include "trees/exact.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

void exact_truncate(struct exact_points *points, size_t count)
{
    for (; points->count > count; points->count--)
        for (int i = 0; i < 3; i++)
            mpq_clear(points->at[points->count - 1][i]);
}

void exact_free(struct exact_points *points)
{
    exact_truncate(points, 0);
    free(points->at);
    free(points->approx);
    *points = (struct exact_points){0};
}

/* A new point, all zero. */
static uint32_t points_add(struct exact_points *points)
{
    size_t index = points->count;
    points->at = grow(points->at, index, &points->at_capacity, sizeof *points->at);
    points->approx = grow(points->approx, index, &points->approx_capacity, sizeof *points->approx);
    for (int i = 0; i < 3; i++)
        mpq_init(points->at[index][i]);
    points->count++;
    return (uint32_t)index;
}

static void points_approximate(struct exact_points *points, uint32_t point)
{
    for (int i = 0; i < 3; i++)
        points->approx[point][i] = mpq_get_d(points->at[point][i]);
}

uint32_t exact_add_m(struct exact_points *points, const double point_m[3], const struct grid *grid)
{
    uint32_t index = points_add(points);
    mpq_t term;
    mpq_init(term);
    for (int i = 0; i < 3; i++) {
        mpq_t *at = &points->at[index][i];
        mpq_set_d(*at, point_m[i]);
        mpq_set_d(term, grid->origin_m[i]);
        mpq_sub(*at, *at, term);
        mpq_set_d(term, grid->units_per_m);
        mpq_mul(*at, *at, term);
    }
    mpq_clear(term);
    points_approximate(points, index);
    return index;
}

/* n . p - d. Plane integers stay below 2^53, so a double carries each exactly. */
static void plane_value(const struct exact_points *points, uint32_t point, const struct plane *plane, mpq_t value)
{
    mpq_t term;
    mpq_init(term);
    mpq_set_d(value, -(double)plane->d);
    for (int i = 0; i < 3; i++) {
        mpq_set_d(term, (double)plane->n[i]);
        mpq_mul(term, term, points->at[point][i]);
        mpq_add(value, value, term);
    }
    mpq_clear(term);
}

uint32_t exact_add_crossing(struct exact_points *points, uint32_t a, uint32_t b, const struct plane *plane)
{
    uint32_t index = points_add(points);
    mpq_t value_a, value_b, t;
    mpq_inits(value_a, value_b, t, NULL);
    plane_value(points, a, plane, value_a);
    plane_value(points, b, plane, value_b);
    mpq_sub(value_b, value_a, value_b);
    mpq_div(t, value_a, value_b);
    for (int i = 0; i < 3; i++) {
        mpq_t *at = &points->at[index][i];
        mpq_sub(*at, points->at[b][i], points->at[a][i]);
        mpq_mul(*at, *at, t);
        mpq_add(*at, *at, points->at[a][i]);
    }
    mpq_clears(value_a, value_b, t, NULL);
    points_approximate(points, index);
    return index;
}

/* Error of the sum in doubles, u = 2^-53: a coordinate is off by 2u, its product by another u,
 * and three additions by u each of sums that `scale` bounds: below 7u * scale, taken as 16u. */
int exact_side(const struct exact_points *points, uint32_t point, const struct plane *plane)
{
    double sum = -(double)plane->d, scale = fabs((double)plane->d);
    for (int i = 0; i < 3; i++) {
        double product = (double)plane->n[i] * points->approx[point][i];
        sum += product;
        scale += fabs(product);
    }
    if (fabs(sum) > scale * 0x1p-49) return sum > 0.0 ? 1 : -1;
    mpq_t value;
    mpq_init(value);
    plane_value(points, point, plane, value);
    int side = mpq_sgn(value);
    mpq_clear(value);
    return side;
}

int exact_compare(const struct exact_points *points, uint32_t a, uint32_t b, int axis)
{
    double at_a = points->approx[a][axis], at_b = points->approx[b][axis];
    if (fabs(at_a - at_b) > (fabs(at_a) + fabs(at_b)) * 0x1p-50) return at_a > at_b ? 1 : -1;
    return mpq_cmp(points->at[a][axis], points->at[b][axis]);
}

/* floor(q 2^bits + 1/2) = floor((2^(bits + 1) num + den) / (2 den)) */
static long round_half_up(const mpq_t q, int bits)
{
    mpz_t num, den;
    mpz_inits(num, den, NULL);
    mpz_mul_2exp(num, mpq_numref(q), (mp_bitcnt_t)bits + 1);
    mpz_add(num, num, mpq_denref(q));
    mpz_mul_2exp(den, mpq_denref(q), 1);
    mpz_fdiv_q(num, num, den);
    long rounded = mpz_get_si(num);
    mpz_clears(num, den, NULL);
    return rounded;
}

struct grid_point exact_snap(const struct exact_points *points, uint32_t point, int fraction_bits)
{
    const int64_t step_q8 = 256 >> fraction_bits;
    struct grid_point snapped;
    for (int k = 0; k < 3; k++)
        snapped.q8[k] = round_half_up(points->at[point][k], fraction_bits) * step_q8;
    return snapped;
}
