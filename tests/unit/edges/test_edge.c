/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact: the intervals of polygons that tile the plane cover every pixel once. */
#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"
#include "rigs/raster.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 240, BAND_PX = 2 * SIDE_PX, MAX_TRIANGLES = 2000, MESHES = 60 };

struct triangle {
    struct lim_point at[3];
};

struct mesh2 {
    struct triangle triangles[MAX_TRIANGLES];
    size_t count;
};

static int64_t doubled_area(const struct lim_point *a, const struct lim_point *b, const struct lim_point *c)
{
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(b->y - a->y) * (c->x - a->x);
}

/* Counter-clockwise as seen, y down: the doubled area is negative. */
static bool is_inside(const struct triangle *t, const struct lim_point *p)
{
    return doubled_area(&t->at[0], &t->at[1], p) < 0 && doubled_area(&t->at[1], &t->at[2], p) < 0 &&
           doubled_area(&t->at[2], &t->at[0], p) < 0;
}

/* The whole guard band of a 240-pixel screen: pixel centres -120 .. 359. */
static void start_mesh(struct mesh2 *mesh)
{
    const lim_sub low = -SIDE_PX / 2 * LIM_SUB, high = 3 * SIDE_PX / 2 * LIM_SUB;
    const struct lim_point corners[4] = {{low, low}, {low, high}, {high, high}, {high, low}};

    mesh->triangles[0] = (struct triangle){{corners[0], corners[1], corners[2]}};
    mesh->triangles[1] = (struct triangle){{corners[0], corners[2], corners[3]}};
    mesh->count = 2;
}

static struct lim_point random_point_in(struct random *random, const struct triangle *t)
{
    double u = random_unit(random), v = random_unit(random);

    if (u + v > 1) u = 1 - u, v = 1 - v;
    return (struct lim_point){(lim_sub)(t->at[0].x + u * (t->at[1].x - t->at[0].x) + v * (t->at[2].x - t->at[0].x)),
                              (lim_sub)(t->at[0].y + u * (t->at[1].y - t->at[0].y) + v * (t->at[2].y - t->at[0].y))};
}

/* One triangle becomes three around a point strictly inside it; again and again, slivers result. */
static void insert_point(struct mesh2 *mesh, struct random *random)
{
    struct triangle *t = &mesh->triangles[random_in(random, 0, (int64_t)mesh->count - 1)];
    const struct lim_point p = random_point_in(random, t);

    if (!is_inside(t, &p)) return;
    const struct triangle old = *t;
    for (uint8_t k = 0; k < 3; k++) {
        const struct triangle piece = {{old.at[k], old.at[(k + 1) % 3], p}};
        if (k == 0)
            *t = piece;
        else
            mesh->triangles[mesh->count++] = piece;
    }
}

static void assert_covered_once(const struct coverage *coverage)
{
    size_t gaps = 0, doubles = 0;

    for (int32_t i = 0; i < coverage->w * coverage->h; i++) {
        gaps += coverage->count[i] == 0;
        doubles += coverage->count[i] > 1;
    }
    assert_int_equal(gaps, 0);
    assert_int_equal(doubles, 0);
}

static void random_meshes_cover_every_pixel_exactly_once(void **state)
{
    struct random random = {20261};
    struct mesh2 *mesh = malloc(sizeof *mesh);
    struct coverage coverage = {-SIDE_PX / 2, -SIDE_PX / 2, BAND_PX, BAND_PX, malloc(BAND_PX * BAND_PX)};
    size_t pixels = 0, triangles = 0;

    (void)state;
    for (int k = 0; k < MESHES; k++) {
        start_mesh(mesh);
        while (mesh->count + 2 < MAX_TRIANGLES)
            insert_point(mesh, &random);
        memset(coverage.count, 0, BAND_PX * BAND_PX);
        for (size_t i = 0; i < mesh->count; i++)
            raster_add(&coverage, mesh->triangles[i].at, 3);
        assert_covered_once(&coverage);
        pixels += BAND_PX * BAND_PX;
        triangles += mesh->count;
    }
    assert_true(pixels >= 10000000);
    printf("# %zu pixels of %zu triangles: 0 gaps, 0 double hits\n", pixels, triangles);
    free(mesh);
    free(coverage.count);
}

/* A band from left to right, cut along a nearly level chain whose corners rounding has moved up and
 * down by a sub-pixel or two: what T-vertices on a floor's edge look like. */
enum { CHAIN = 12 };

static void make_chain(struct random *random, struct lim_point chain[CHAIN])
{
    const int32_t y = (int32_t)random_in(random, 20, 60) * LIM_SUB + (int32_t)random_in(random, -2, 2);
    const int32_t slope = (int32_t)random_in(random, -3, 3);

    for (int32_t k = 0; k < CHAIN; k++) {
        chain[k].x = (lim_sub)(k * 20 * LIM_SUB + (k && k < CHAIN - 1 ? random_in(random, -300, 300) : 0));
        chain[k].y = (lim_sub)(y + k * slope + random_in(random, -2, 2));
    }
}

static void non_monotone_neighbours_leave_no_gap(void **state)
{
    struct random random = {7};
    const lim_sub right = (CHAIN - 1) * 20 * LIM_SUB, bottom = 80 * LIM_SUB;
    struct coverage coverage = {0, 0, (CHAIN - 1) * 20, 80, malloc((CHAIN - 1) * 20 * 80)};
    size_t non_monotone = 0, gaps = 0;

    (void)state;
    for (int k = 0; k < 5000; k++) {
        struct lim_point chain[CHAIN], above[CHAIN + 2], below[CHAIN + 2];
        make_chain(&random, chain);
        for (int i = 0; i < CHAIN; i++)
            above[i] = chain[i];
        above[CHAIN] = (struct lim_point){right, 0};
        above[CHAIN + 1] = (struct lim_point){0, 0};
        for (int i = 0; i < CHAIN; i++)
            below[i] = chain[CHAIN - 1 - i];
        below[CHAIN] = (struct lim_point){0, bottom};
        below[CHAIN + 1] = (struct lim_point){right, bottom};
        memset(coverage.count, 0, (size_t)(coverage.w * coverage.h));
        non_monotone += raster_add(&coverage, above, CHAIN + 2);
        non_monotone += raster_add(&coverage, below, CHAIN + 2);
        for (int32_t i = 0; i < coverage.w * coverage.h; i++)
            gaps += coverage.count[i] == 0;
    }
    assert_int_equal(gaps, 0);
    assert_true(non_monotone > 100); /* the case is really there */
    free(coverage.count);
}

/* At the largest target, 1024 pixels a side, over the whole guard band; and where edges are short. */
static void edges_are_exact_at_the_extremes(void **state)
{
    struct random random = {99};

    (void)state;
    for (int k = 0; k < 20000; k++)
        (void)edge_rig_check(&random, edge_rig_band(k % 2 ? LIM_MAX_SIDE_PX : SIDE_PX));
}

/* Corners on an ellipse, in sub-pixels, from any of them on: as many as a byte counts. */
static void a_polygon_of_255_corners_is_its_fan(void **state)
{
    enum { CORNERS = 255, SIZE = 200 };
    static uint8_t whole[SIZE * SIZE], parts[SIZE * SIZE];

    (void)state;
    for (int start = 0; start < CORNERS; start += 2) {
        struct coverage polygon = {0, 0, SIZE, SIZE, whole}, fan = {0, 0, SIZE, SIZE, parts};
        struct lim_point at[CORNERS];
        memset(whole, 0, sizeof whole);
        memset(parts, 0, sizeof parts);
        for (int k = 0; k < CORNERS; k++) {
            const double turn = -6.283185307179586 * (k + start) / CORNERS; /* counter-clockwise, y down */
            at[k] = (struct lim_point){(lim_sub)lround((100 + 99 * cos(turn)) * LIM_SUB),
                                       (lim_sub)lround((100 + 90 * sin(turn)) * LIM_SUB)};
        }
        assert_false(raster_add(&polygon, at, CORNERS));
        for (int k = 1; k + 1 < CORNERS; k++)
            raster_add(&fan, (const struct lim_point[]){at[0], at[k], at[k + 1]}, 3);
        assert_memory_equal(whole, parts, sizeof whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_meshes_cover_every_pixel_exactly_once),
        cmocka_unit_test(non_monotone_neighbours_leave_no_gap),
        cmocka_unit_test(edges_are_exact_at_the_extremes),
        cmocka_unit_test(a_polygon_of_255_corners_is_its_fan),
    };

    return cmocka_run_group_tests_name("edge", tests, NULL, NULL);
}
