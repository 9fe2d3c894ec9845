/* SPDX-License-Identifier: MIT
 *
 * Clipping where corners have exponents of their own, one a step away and another at the horizon, against long doubles:
 * what is left is inside, cuts lie on their edges, and two polygons that share an edge get the same cuts. Of a scene's
 * corners also where the eye is much nearer to the edge than their last bits could tell. */
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

/* Corners of a scene ------------------------------------------------------------------------------ */

/* Two triangles a b c and b a d. */
struct pair {
    struct lim_long_vertex vertices[4];
    struct lim_fraction fractions[4];
    struct lim_node node;
    struct lim_long all;
    struct lim_scene scene;
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view;
    struct seeing seeing[2]; /* by a long lens, along x and along y */
    long double at[4][3];    /* as the rows have them, of all bits, which doubles of 64 bits hold but for the last */
};

static struct lim_camera any_camera(struct random *random, int most_zoom_bits)
{
    struct lim_camera camera = {.near_q8 = 512 << random_in(random, 0, 8)};
    const int zoom_bits = (int)random_in(random, 0, most_zoom_bits);

    for (int i = 0; i < 3; i++) {
        camera.origin[i] = (int32_t)random_in(random, -1000, 1000);
        camera.eye_q8[i] = (int32_t)random_in(random, 0, 255);
    }
    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_u64(random);
    camera.roll = (uint32_t)random_u64(random);
    camera.tan_x_q28 = UINT32_C(0x0F000000) >> zoom_bits;
    camera.tan_y_q28 = UINT32_C(0x0B000000) >> zoom_bits;
    return camera;
}

static void pair_begin(struct pair *pair, const struct lim_camera *camera)
{
    *pair = (struct pair){0};
    pair->all = (struct lim_long){.vertices = pair->vertices, .fractions = pair->fractions};
    pair->node = (struct lim_node){.split = {LIM_PLANE_X, 0}, .front_run = LIM_NO_INDEX, .back_run = LIM_NO_INDEX};
    pair->node.front = pair->node.back = pair->node.box = LIM_NO_INDEX;
    pair->scene = (struct lim_scene){.of_32_bits = {&pair->all}, .vertex_count = 4, .nodes = &pair->node};
    pair->scene.node_count = 1;
    lim_view_init(&pair->view, 240, 180, pair->cache);
    assert_true(lim_view_begin(&pair->view, &pair->scene, camera));
    *pair->view.rows.eye = (struct lim_long_eye){.all = &pair->all};
    for (int i = 0; i < 3; i++) {
        pair->view.rows.eye->at[i] = camera->origin[i];
        pair->view.rows.eye->fraction_q8[i] = (uint8_t)camera->eye_q8[i];
    }
    for (int i = 0; i < 2; i++)
        pair->seeing[i] = (struct seeing){pair->view.rows.near_qv, LIM_HAS_TELE ? pair->view.rows.zoom_bits[i] : 0};
}

static long double entry_of(const struct lim_row *row, int i)
{
    long double entry = row->n_qv[i];

#if LIM_HAS_LIMBS
    entry += ldexpl(row->low_qv15[i], -15);
#endif
    return entry;
}

/* Puts a vertex some way from the eye, and says where the rows have it. */
static void pair_put(struct pair *pair, struct random *random, int vertex, const long double way[3])
{
    const struct lim_rows *rows = &pair->view.rows;
    long double exact[3];

    for (int i = 0; i < 3; i++)
        pair->vertices[vertex].at[i] = rows->eye->at[i] + (int32_t)way[i];
    pair->fractions[vertex] =
        (struct lim_fraction){(int8_t)random_in(random, -128, 127), (int8_t)random_in(random, -128, 127),
                              (int8_t)random_in(random, -128, 127)};
    const int8_t fractions[3] = {pair->fractions[vertex].x_q8, pair->fractions[vertex].y_q8,
                                 pair->fractions[vertex].z_q8};
    for (int i = 0; i < 3; i++)
        exact[i] = (int32_t)way[i] + (fractions[i] - rows->eye->fraction_q8[i]) / 256.0L;
    for (int row = 0; row < 3; row++) {
        pair->at[vertex][row] = 0;
        for (int i = 0; i < 3; i++)
            pair->at[vertex][row] += entry_of(&rows->row[row], i) * exact[i];
    }
    for (int i = 0; LIM_TURNS_ROWS && i < 2; i++)
        pair->at[vertex][i] += pair->at[vertex][2] * ldexpl(rows->turn_q32[i], -32);
    if (!LIM_HAS_LIMBS) pair->at[vertex][2] = ldexpl(pair->at[vertex][2], -rows->tele_bits);
}

/* Of a plane, in its own measure. */
static long double pair_inside(const struct pair *pair, const long double at[3], int plane)
{
    return inside_of(at, plane, &pair->seeing[plane > 2]);
}

static bool is_clearly_inside(const struct pair *pair, int vertex)
{
    for (int plane = 0; plane < PLANES; plane++)
        if (pair_inside(pair, pair->at[vertex], plane) < 0.01L * length_of(pair->at[vertex])) return false;
    return true;
}

static void any_way(struct random *random, int least_bits, int most_bits, long double way[3])
{
    const long double size = exp2l(least_bits + (most_bits - least_bits) * random_unit(random));

    for (int i = 0; i < 3; i++)
        way[i] = size * (2 * random_unit(random) - 1);
}

/* An edge that passes within some units of the eye, from somewhere to somewhere on the other side; the other corners
 * are inside. false: they are not found. */
static bool pair_build(struct pair *pair, struct random *random)
{
    const int bits = (int)random_in(random, 4, 29);
    long double there[3], aside[2][3];

    any_way(random, bits, bits, there);
    for (int i = 0; i < 2; i++) {
        const long double size = i ? -exp2l(-(int)random_in(random, 0, bits - 4)) : 1;
        any_way(random, 2, 8, aside[i]);
        for (int axis = 0; axis < 3; axis++)
            aside[i][axis] += size * there[axis];
        pair_put(pair, random, i, aside[i]);
    }
    for (int vertex = 2; vertex < 4; vertex++) {
        int tries = 1000;
        do {
            any_way(random, 4, 29, there);
            pair_put(pair, random, vertex, there);
        } while (!is_clearly_inside(pair, vertex) && --tries);
        if (!tries) return false;
    }
    return true;
}

static struct lim_clip_polygon *clip_corners(struct lim_clip_polygon polygons[2], const struct pair *pair,
                                             const lim_index corners[3])
{
    memset(polygons, 0xA5, 2 * sizeof *polygons);
    lim_clip_load(&polygons[0], &pair->view, &pair->scene, corners, 3);
    return lim_clip(polygons, pair->view.rows.near_qv);
}

struct scene_counts {
    size_t cuts, corners, moved, unshared;
    long double most_off; /* of what is allowed */
};

/* The part of the edge that is inside. false: none is, or by a hair. */
static bool pair_part(const struct pair *pair, long double ends[2], int planes[2])
{
    ends[0] = 0, ends[1] = 1, planes[0] = planes[1] = -1;
    for (int plane = 0; plane < PLANES; plane++) {
        const long double d = pair_inside(pair, pair->at[0], plane), e = pair_inside(pair, pair->at[1], plane);
        if (d < 0 && e < 0) return false;
        if (d < 0 && d / (d - e) > ends[0]) ends[0] = d / (d - e), planes[0] = plane;
        if (e < 0 && d / (d - e) < ends[1]) ends[1] = d / (d - e), planes[1] = plane;
    }
    return ends[0] < ends[1];
}

/* How far a point is off a cut, beside 2^-10 of the near plane's distance, and more along an edge that meets the plane
 * at a small angle; and 2^-24 of the cut's own distance. */
static long double off_cut(const struct pair *pair, const struct lim_view_point *point, const long double cut[3],
                           long double steepness)
{
    long double there[3], way[3];

    place(point, there);
    for (int i = 0; i < 3; i++)
        way[i] = there[i] - cut[i];
    return length_of(way) / (ldexpl(pair->view.rows.near_qv, -10) / steepness + ldexpl(length_of(cut), -24));
}

static const struct lim_view_point *nearest_to(const struct pair *pair, const struct lim_clip_polygon *polygon,
                                               const long double cut[3], long double steepness, long double *off)
{
    const struct lim_view_point *best = NULL;

    *off = INFINITY;
    for (int k = 0; k < polygon->n; k++) {
        const long double here = off_cut(pair, &polygon->at[k], cut, steepness);
        if (here >= *off) continue;
        *off = here;
        best = &polygon->at[k];
    }
    return best;
}

/* How much nearer to a plane the edge comes by one step along it. */
static long double steepness_of(const struct pair *pair, int plane)
{
    const long double d = pair_inside(pair, pair->at[0], plane), e = pair_inside(pair, pair->at[1], plane);
    long double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = pair->at[1][i] - pair->at[0][i];
    return fabsl(d - e) / length_of(way);
}

static void count_corners(const struct pair *pair, const struct lim_clip_polygon *polygon, const lim_index corners[3],
                          struct scene_counts *counts)
{
    for (int k = 0; k < 3; k++) {
        struct lim_view_point corner;
        if (!is_clearly_inside(pair, (int)corners[k])) continue;
        lim_view_transform_long(&pair->view, corners[k], &corner);
        if (*corner.exponent < 0) continue; /* it may have been made coarser */
        counts->corners++;
        counts->moved += !holds(polygon, &corner);
    }
}

static void count_pair(const struct pair *pair, struct scene_counts *counts)
{
    static const lim_index one[3] = {0, 1, 2}, other[3] = {1, 0, 3};
    struct lim_clip_polygon places[2][2];
    const struct lim_clip_polygon *left = clip_corners(places[0], pair, one);
    const struct lim_clip_polygon *right = clip_corners(places[1], pair, other);
    long double ends[2];
    int planes[2];

    count_corners(pair, left, one, counts);
    count_corners(pair, right, other, counts);
    if (!pair_part(pair, ends, planes)) return;
    for (int end = 0; end < 2; end++) {
        long double cut[3], off;
        if (planes[end] < 0) continue;
        for (int i = 0; i < 3; i++)
            cut[i] = pair->at[0][i] + (pair->at[1][i] - pair->at[0][i]) * ends[end];
        const long double steepness = steepness_of(pair, planes[end]);
        if (steepness < 0.2L) continue;
        const struct lim_view_point *point = nearest_to(pair, left, cut, steepness, &off);
        counts->cuts++;
        counts->most_off = fmaxl(counts->most_off, off);
        counts->unshared += !point || !holds(right, point);
    }
}

static void check_scenes(uint64_t seed, int most_zoom_bits)
{
    struct random random = {seed};
    struct scene_counts counts = {0};

    for (int k = 0; k < effort(PAIRS) / 8; k++) {
        const struct lim_camera camera = any_camera(&random, most_zoom_bits);
        static struct pair pair;
        pair_begin(&pair, &camera);
        if (pair_build(&pair, &random)) count_pair(&pair, &counts);
    }
    printf("# scenes' corners: %zu cuts, at most %.3Lf of what is allowed off, %zu not the neighbour's; %zu of %zu "
           "corners "
           "are not where they are unclipped\n",
           counts.cuts, counts.most_off, counts.unshared, counts.moved, counts.corners);
    assert_true(counts.cuts > (size_t)effort(PAIRS) / 100 && counts.corners > (size_t)effort(PAIRS) / 10);
    assert_true(counts.most_off <= 1);
    assert_int_equal(counts.unshared, 0);
    assert_int_equal(counts.moved, 0);
}

static void edges_that_pass_the_eye_are_cut_where_they_are(void **state)
{
    (void)state;
    check_scenes(165, 0);
}

static void by_long_lenses_too(void **state)
{
    (void)state;
    if (!LIM_HAS_TELE) skip();
    check_scenes(166, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cuts_lie_on_their_edge_whichever_way_it_is_followed),
        cmocka_unit_test(neighbours_of_all_sizes_share_their_cuts),
        cmocka_unit_test(neighbours_from_here_to_the_horizon_share_their_cuts),
        cmocka_unit_test(neighbours_share_their_cuts_by_long_lenses),
        cmocka_unit_test(edges_that_pass_the_eye_are_cut_where_they_are),
        cmocka_unit_test(by_long_lenses_too),
    };

    return cmocka_run_group_tests_name("clipping in long scenes", tests, NULL, NULL);
}
