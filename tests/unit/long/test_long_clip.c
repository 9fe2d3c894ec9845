/* SPDX-License-Identifier: MIT
 *
 * Clipping where corners have exponents of their own, one a step away and another at the horizon, against long doubles:
 * what is left is inside, cuts lie on their edges, and two polygons that share an edge get the same cuts. */
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"
#include "view/clip.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CUTS = 1000000, PAIRS = 400000, PLANES = 5 };

/* A point of view space by its exponent. */
static long double coordinate(const struct lim_view_point *point, int i)
{
    return ldexpl(point->qv[i], *point->exponent);
}

/* What the last bit of a point's coordinates is. */
static long double unit_of(const struct lim_view_point *point)
{
    return ldexpl(1, *point->exponent);
}

/* A size from 2^14, half a unit of a scene, to 2^45 along a random way, with exponents in steps of 4 and as many bits
 * as a view has: 26 to 30. */
static struct lim_view_point point_of_size(struct random *random, int least_bits, int most_bits)
{
    const int bits = (int)random_in(random, least_bits, most_bits);
    const int exponent = ((bits - 26 + 64) & ~3) - 64, mantissa = bits - exponent;
    struct lim_view_point point = {0};

    for (int i = 0; i < 3; i++)
        point.qv[i] = (int32_t)random_in(random, -(INT64_C(1) << mantissa), INT64_C(1) << mantissa);
    *point.exponent = (int8_t)exponent;
    return point;
}

/* What is seen, and how: a long lens sees |x| <= z / 2^zoom_bits. */
struct seeing {
    int32_t near_qv;
    int zoom_bits;
};

static struct seeing any_seeing(struct random *random, int most_zoom_bits)
{
    const int64_t near_qv = (INT64_C(1) << random_in(random, 15, 29)) - random_in(random, 0, 1) * 7;

    return (struct seeing){(int32_t)near_qv, (int)random_in(random, 0, most_zoom_bits)};
}

/* One inside of all planes, with some room. */
static struct lim_view_point point_inside(struct random *random, const struct seeing *seeing)
{
    for (;;) {
        struct lim_view_point point = point_of_size(random, 16, 45);
        const long double z = fabsl(coordinate(&point, 2));
        point.z_qv = point.z_qv < 0 ? -point.z_qv : point.z_qv;
        for (int i = 0; i < 2; i++)
            point.qv[i] >>= seeing->zoom_bits;
        if (z > 1.5L * seeing->near_qv && fabsl(coordinate(&point, 0)) < ldexpl(z * 1.5L, -seeing->zoom_bits) &&
            fabsl(coordinate(&point, 1)) < ldexpl(z * 1.5L, -seeing->zoom_bits))
            return point;
    }
}

/* How far inside of a plane a point is, in the plane's own measure: z - near, or 2z and x. */
static long double inside_of(const long double at[3], int plane, const struct seeing *seeing)
{
    const long double band = ldexpl(2 * at[2], -seeing->zoom_bits);

    if (plane == 0) return at[2] - seeing->near_qv;
    return plane % 2 ? band + at[(plane - 1) / 2] : band - at[(plane - 1) / 2];
}

static void place(const struct lim_view_point *point, long double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = coordinate(point, i);
}

static long double length_of(const long double v[3])
{
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static long double off_line(const struct lim_view_point *point, const struct lim_view_point *a,
                            const struct lim_view_point *b)
{
    long double way[3], from[3], cross[3];

    for (int i = 0; i < 3; i++) {
        way[i] = coordinate(b, i) - coordinate(a, i);
        from[i] = coordinate(point, i) - coordinate(a, i);
    }
    for (int i = 0; i < 3; i++)
        cross[i] = way[(i + 1) % 3] * from[(i + 2) % 3] - way[(i + 2) % 3] * from[(i + 1) % 3];
    return length_of(cross) / length_of(way);
}

/* An end's last bits, and what of the way from there has rounded: as many of it as the other end has. */
static long double tolerance_of(const long double at[3], const struct lim_view_point *a, const struct lim_view_point *b)
{
    const struct lim_view_point *low = *a->exponent < *b->exponent ? a : b;
    long double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = at[i] - coordinate(low, i);
    return 4 * unit_of(low) + ldexpl(length_of(way), -28);
}

static bool is_same(const struct lim_view_point *a, const struct lim_view_point *b)
{
    return memcmp(a->qv, b->qv, sizeof a->qv) == 0 && *a->exponent == *b->exponent;
}

/* A cut by itself --------------------------------------------------------------------------------- */

/* How far inside the plane a cut is, that has a_d and b_d at the ends of its edge, by how far along that it is. */
static long double distance_at(const struct lim_view_point *cut, const struct lim_view_point *a, long double a_d,
                               const struct lim_view_point *b, long double b_d)
{
    long double square = 0, dot = 0;

    for (int i = 0; i < 3; i++) {
        const long double way = coordinate(b, i) - coordinate(a, i);
        square += way * way;
        dot += way * (coordinate(cut, i) - coordinate(a, i));
    }
    return a_d + (b_d - a_d) * (dot / square);
}

/* Distances as the caller has them, of the points' own exponents. No plane's distance changes by more than twice the
 * way. */
static void cuts_lie_on_their_edge_whichever_way_it_is_followed(void **state)
{
    struct random random = {161};
    long double most = 0, most_off = 0;
    size_t apart = 0, cuts = 0;

    (void)state;
    for (int k = 0; k < effort(CUTS); k++) {
        const struct lim_view_point a = point_of_size(&random, 14, 45), b = point_of_size(&random, 14, 45);
        const int32_t a_d = (int32_t)random_in(&random, 0, INT32_MAX / 4) >> random_in(&random, 0, 29);
        const int32_t b_d = (int32_t)random_in(&random, INT32_MIN / 4, -1) >> random_in(&random, 0, 29);
        const long double a_true = ldexpl(a_d, *a.exponent), b_true = ldexpl(b_d, *b.exponent);
        struct lim_view_point cut = {0}, back = {0};
        long double way[3], at[3];
        for (int i = 0; i < 3; i++)
            way[i] = coordinate(&b, i) - coordinate(&a, i);
        if (*a.exponent == *b.exponent || a_true - b_true > 2 * length_of(way)) continue;
        lim_clip_cut_long(&cut, &a, a_d, &b, b_d);
        lim_clip_cut_long(&back, &b, b_d, &a, a_d);
        assert_true(is_same(&cut, &back));
        place(&cut, at);
        const long double tolerance = tolerance_of(at, &a, &b);
        most = fmaxl(most, off_line(&cut, &a, &b) / tolerance);
        most_off = fmaxl(most_off, fabsl(distance_at(&cut, &a, a_true, &b, b_true)) / tolerance);
        for (int i = 0; i < 3; i++)
            assert_true(cut.qv[i] < 1 << 30 && cut.qv[i] >= -(1 << 30));
        apart += *a.exponent > *b.exponent + 15 || *b.exponent > *a.exponent + 15;
        cuts++;
    }
    printf("# cuts: %.3f of what is allowed off their edges, %.3f off the plane; %zu of %zu of ends 2^15 apart\n",
           (double)most, (double)most_off, apart, cuts);
    assert_true(most <= 1 && most_off <= 2); /* the quotient has 28.6 bits */
    assert_true(cuts > (size_t)effort(CUTS) / 3 && apart > cuts / 20);
}

/* Polygons ---------------------------------------------------------------------------------------- */

static void assert_inside(const struct lim_clip_polygon *polygon, const struct seeing *seeing)
{
    for (int k = 0; k < polygon->n; k++) {
        const struct lim_view_point *point = &polygon->at[k];
        const long double z = coordinate(point, 2), unit = unit_of(point);
        assert_true(point->z_qv > 0 && z >= seeing->near_qv - unit);
        for (int i = 0; i < 2; i++)
            assert_true(fabsl(coordinate(point, i)) <= ldexpl(2 * z, -seeing->zoom_bits));
    }
}

/* The part of an edge that is inside, as shares of it. false: none is, or by a hair. */
static bool part_inside(const struct lim_view_point *a, const struct lim_view_point *b, const struct seeing *seeing,
                        long double ends[2], int planes[2])
{
    long double from[3], to[3];

    place(a, from);
    place(b, to);
    ends[0] = 0, ends[1] = 1, planes[0] = planes[1] = -1;
    for (int plane = 0; plane < PLANES; plane++) {
        const long double d = inside_of(from, plane, seeing), e = inside_of(to, plane, seeing);
        if (d < 0 && e < 0) return false;
        if (d < 0 && d / (d - e) > ends[0]) ends[0] = d / (d - e), planes[0] = plane;
        if (e < 0 && d / (d - e) < ends[1]) ends[1] = d / (d - e), planes[1] = plane;
    }
    return ends[0] < ends[1] * 0.999L;
}

/* What is left has a point where the edge meets the plane, or nearly; that point is given out. */
static bool has_cut(const struct lim_clip_polygon *polygon, const struct lim_view_point *a,
                    const struct lim_view_point *b, const long double at[3], int plane, const struct seeing *seeing,
                    struct lim_view_point *out)
{
    /* The near plane is met at half its distance, rounded, and z is put right: 1/8000 pixel. */
    const long double settled = 1 + (plane ? 0 : ldexpl(seeing->near_qv, -20));
    const long double tolerance = 64 * tolerance_of(at, a, b) + settled;
    long double least = INFINITY;

    for (int k = 0; k < polygon->n; k++) {
        long double there[3], way[3];
        place(&polygon->at[k], there);
        for (int i = 0; i < 3; i++)
            way[i] = there[i] - at[i];
        if (off_line(&polygon->at[k], a, b) > tolerance) continue;
        if (fabsl(inside_of(there, plane, seeing)) > 16 * tolerance) continue;
        if (length_of(way) >= least) continue;
        least = length_of(way);
        *out = polygon->at[k];
    }
    return isfinite(least);
}

/* The one with some corners, in that order. */
static struct lim_clip_polygon *clip_triangle(struct lim_clip_polygon polygons[2], const struct lim_view_point *a,
                                              const struct lim_view_point *b, const struct lim_view_point *c,
                                              const struct seeing *seeing)
{
    polygons[0] = (struct lim_clip_polygon){.n = 3, .at = {*a, *b, *c}};
    for (int i = 0; LIM_HAS_TELE && i < 2; i++)
        polygons[0].zoom_bits[i] = (uint8_t)seeing->zoom_bits;
    return lim_clip(polygons, seeing->near_qv);
}

static bool holds(const struct lim_clip_polygon *polygon, const struct lim_view_point *point)
{
    for (int k = 0; k < polygon->n; k++)
        if (is_same(&polygon->at[k], point)) return true;
    return false;
}

struct counts {
    size_t cuts, near_cuts, missed, unshared;
};

/* Two triangles on either side of an edge, which they follow in opposite ways; their other corners are inside. */
static void check_pair(struct random *random, const struct seeing *seeing, const struct lim_view_point *a,
                       const struct lim_view_point *b, struct counts *counts)
{
    const struct lim_view_point c = point_inside(random, seeing), d = point_inside(random, seeing);
    struct lim_clip_polygon one[2], other[2];
    const struct lim_clip_polygon *left = clip_triangle(one, a, b, &c, seeing);
    const struct lim_clip_polygon *right = clip_triangle(other, b, a, &d, seeing);
    long double ends[2];
    int planes[2];

    assert_inside(left, seeing);
    assert_inside(right, seeing);
    if (!part_inside(a, b, seeing, ends, planes)) return;
    for (int end = 0; end < 2; end++) {
        struct lim_view_point cut;
        long double at[3];
        if (planes[end] < 0) continue;
        for (int i = 0; i < 3; i++)
            at[i] = coordinate(a, i) + (coordinate(b, i) - coordinate(a, i)) * ends[end];
        counts->cuts++;
        counts->near_cuts += planes[end] == 0;
        if (!has_cut(left, a, b, at, planes[end], seeing, &cut))
            counts->missed++;
        else
            counts->unshared += !holds(right, &cut);
    }
}

static void report_pairs(const char *name, const struct counts *counts)
{
    printf("# %s: %zu cuts, %zu by the near plane; %zu are not where they should be, %zu not the neighbour's\n", name,
           counts->cuts, counts->near_cuts, counts->missed, counts->unshared);
    assert_int_equal(counts->missed, 0);
    assert_int_equal(counts->unshared, 0);
    assert_true(counts->cuts > (size_t)effort(PAIRS) / 10 && counts->near_cuts > counts->cuts / 50);
}

static void neighbours_of_all_sizes_share_their_cuts(void **state)
{
    struct random random = {162};
    struct counts counts = {0};

    (void)state;
    for (int k = 0; k < effort(PAIRS); k++) {
        const struct lim_view_point a = point_of_size(&random, 14, 45), b = point_of_size(&random, 14, 45);
        const struct seeing seeing = any_seeing(&random, 0);
        check_pair(&random, &seeing, &a, &b, &counts);
    }
    report_pairs("any corners", &counts);
}

/* Of a ground: one corner a few units from the eye, often behind it, the other one at the horizon. */
static void neighbours_from_here_to_the_horizon_share_their_cuts(void **state)
{
    struct random random = {163};
    struct counts counts = {0};

    (void)state;
    for (int k = 0; k < effort(PAIRS); k++) {
        const struct lim_view_point here = point_of_size(&random, 15, 19), far = point_of_size(&random, 43, 45);
        const struct seeing seeing = any_seeing(&random, 0);
        check_pair(&random, &seeing, k % 2 ? &here : &far, k % 2 ? &far : &here, &counts);
    }
    report_pairs("to the horizon", &counts);
}

static void neighbours_share_their_cuts_by_long_lenses(void **state)
{
    enum { MOST_ZOOM_BITS = 10 };
    struct random random = {164};
    struct counts counts = {0};

    (void)state;
    if (!LIM_HAS_TELE) skip();
    for (int k = 0; k < effort(PAIRS); k++) {
        const struct seeing seeing = any_seeing(&random, MOST_ZOOM_BITS);
        struct lim_view_point a = point_of_size(&random, 14, 45), b = point_of_size(&random, 14, 45);
        for (int i = 0; i < 2; i++) {
            a.qv[i] >>= seeing.zoom_bits;
            b.qv[i] >>= random_in(&random, 0, seeing.zoom_bits);
        }
        check_pair(&random, &seeing, &a, &b, &counts);
    }
    report_pairs("long lenses", &counts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cuts_lie_on_their_edge_whichever_way_it_is_followed),
        cmocka_unit_test(neighbours_of_all_sizes_share_their_cuts),
        cmocka_unit_test(neighbours_from_here_to_the_horizon_share_their_cuts),
        cmocka_unit_test(neighbours_share_their_cuts_by_long_lenses),
    };

    return cmocka_run_group_tests_name("clipping in long scenes", tests, NULL, NULL);
}
