/* SPDX-License-Identifier: MIT
 *
 * CLIP on polygons that rounding made not quite convex. */
#include "camera.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "view/clip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t turn(double radians)
{
    return (uint32_t)(int64_t)llround(radians / 6.283185307179586 * 4294967296.0);
}

/* A floor with T-vertices, rounded to the grid, in an edge that lies along the near plane: every other one of
 * them is outside. */
static void an_edge_that_zigzags_across_a_clip_plane_adds_one_vertex_at_most(void **state)
{
    enum { T_VERTICES = 16, N = T_VERTICES + 2 };
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_vertex corners[N];
    const struct lim_scene scene = {.vertices = corners};
    struct lim_view view;
    int zigzags = 0;

    (void)state;
    for (int k = 0; k < T_VERTICES; k++)
        corners[k] = (struct lim_vertex){(int16_t)(k * 11), 0, (int16_t)((k * 11 + 1) / 2)};
    corners[T_VERTICES] = (struct lim_vertex){T_VERTICES * 11 + 989, 0, -1918};
    corners[T_VERTICES + 1] = (struct lim_vertex){1000, 0, -2000};
    lim_view_init(&view, 240, 240, cache);
    for (int32_t near_q8 = 1000 * 256 - 512; near_q8 < 1000 * 256 + 512; near_q8 += 8) {
        const uint32_t along = turn(atan2(-1, 2)), one_q28 = UINT32_C(1) << 28;
        const struct lim_camera camera = {.eye_q8 = {-114487, 102400, 228973},
                                          .yaw = along,
                                          .tan_x_q28 = one_q28,
                                          .tan_y_q28 = one_q28,
                                          .near_q8 = near_q8};
        struct lim_clip_polygon polygons[2] = {{.n = N}};
        int outside = 0;
        assert_true(lim_view_begin(&view, &scene, &camera));
        for (int k = 0; k < N; k++) {
            lim_view_transform(&view, &scene, &corners[k], &polygons[0].at[k]);
            outside += polygons[0].at[k].z_qv < view.rows.near_qv;
        }
        zigzags += outside > 4 && outside < T_VERTICES / 2 + 2;
        assert_in_range(lim_clip(polygons, view.rows.near_qv)->n, 3, N + 1);
    }
    assert_true(zigzags > 4);
}

/* Just inside of the near plane, but for every other corner of `outside`: those are as far outside, and no plane but
 * the near one is crossed. */
static void make_comb(struct lim_clip_polygon *polygon, int n, int outside, int32_t near_qv)
{
    polygon->n = (uint8_t)n;
    for (int k = 0; k < n; k++) {
        const bool is_out = k % 2 == 1 && k / 2 < outside;
        polygon->at[k] = (struct lim_view_point){
            .x_qv = (int32_t)lround(2000 * cos(k * 6.283185307179586 / n)),
            .y_qv = (int32_t)lround(2000 * sin(k * 6.283185307179586 / n)),
            .z_qv = is_out ? near_qv - 64 : near_qv + 64,
        };
    }
}

/* One that stands alone is cut twice, as any corner is; several cannot be but by rounding, and each of them is replaced
 * by one point. */
static void each_of_several_lone_corners_outside_is_replaced_by_one_point(void **state)
{
    enum { NEAR_QV = 1 << 15 };

    (void)state;
    for (int n = 8; n < CLIP_MAX_VERTICES; n++)
        for (int outside = 0; outside <= n / 2 - 1; outside++) {
            struct lim_clip_polygon polygons[2] = {{0}};
            make_comb(&polygons[0], n, outside, NEAR_QV);
            assert_int_equal(lim_clip(polygons, NEAR_QV)->n, outside == 1 ? n + 1 : n);
        }
}

static struct lim_view_point any_point(struct random *random, int64_t reach_qv)
{
    struct lim_view_point point = {.z_qv = (int32_t)random_in(random, -reach_qv, reach_qv)};

    point.x_qv = (int32_t)random_in(random, -reach_qv, reach_qv);
    point.y_qv = (int32_t)random_in(random, -reach_qv, reach_qv);
    return point;
}

/* How far a point is from a triangle's plane; 0: the triangle is too thin to tell. */
static double distance_qv(const struct lim_view_point *at, const struct lim_view_point *of)
{
    double u[3], v[3], w[3], n[3], dot = 0, square = 0;

    for (int i = 0; i < 3; i++) {
        u[i] = (double)of[1].qv[i] - of[0].qv[i];
        v[i] = (double)of[2].qv[i] - of[0].qv[i];
        w[i] = (double)at->qv[i] - of[0].qv[i];
    }
    for (int i = 0; i < 3; i++) {
        n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        dot += n[i] * w[i];
        square += n[i] * n[i];
    }
    return square > 1e12 ? fabs(dot) / sqrt(square) : 0;
}

/* Corners on planes, a unit off them, and anywhere; the near plane at an odd distance, of which half is not whole. */
static void what_is_left_of_any_triangle_is_a_part_of_it_inside_of_all_planes(void **state)
{
    enum { POLYGONS = 200000, NEAR_QV = (1 << 15) + 1 };
    struct random random = {57};
    uint32_t left = 0, gone = 0;

    (void)state;
    for (int i = 0; i < POLYGONS; i++) {
        struct lim_clip_polygon polygons[2] = {{.n = 3}};
        struct lim_view_point whole[3];
        const int64_t reach_qv = INT64_C(1) << random_in(&random, 16, 30);
        for (int k = 0; k < 3; k++) {
            struct lim_view_point *at = &polygons[0].at[k];
            *at = any_point(&random, reach_qv - 1);
            const int32_t twice_qv = 2 * (at->z_qv / 4);
            if (random_u64(&random) % 4 == 0) at->x_qv = twice_qv + (int32_t)random_in(&random, -3, 3);
            if (random_u64(&random) % 4 == 0) at->y_qv = -twice_qv + (int32_t)random_in(&random, -3, 3);
            if (random_u64(&random) % 4 == 0) at->z_qv = NEAR_QV + (int32_t)random_in(&random, -3, 3);
        }
        memcpy(whole, polygons[0].at, sizeof whole);
        const struct lim_clip_polygon *clipped = lim_clip(polygons, NEAR_QV);
        left += clipped->n > 0;
        gone += clipped->n == 0;
        for (int k = 0; k < clipped->n; k++) {
            const struct lim_view_point *at = &clipped->at[k];
            assert_true(at->z_qv >= NEAR_QV && at->z_qv <= reach_qv + 1);
            assert_true(llabs(at->x_qv) <= 2 * (int64_t)at->z_qv && llabs(at->y_qv) <= 2 * (int64_t)at->z_qv);
            assert_true(distance_qv(at, whole) < 64);
        }
    }
    assert_true(left > POLYGONS / 10 && gone > POLYGONS / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edge_that_zigzags_across_a_clip_plane_adds_one_vertex_at_most),
        cmocka_unit_test(each_of_several_lone_corners_outside_is_replaced_by_one_point),
        cmocka_unit_test(what_is_left_of_any_triangle_is_a_part_of_it_inside_of_all_planes),
    };

    return cmocka_run_group_tests_name("clip", tests, NULL, NULL);
}
