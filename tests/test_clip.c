/* SPDX-License-Identifier: MIT
 *
 * CLIP on polygons that rounding made not quite convex. */
#include "clip.h"
#include "cmocka_ready.h"

#include <math.h>

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
        const struct lim_camera camera = {{-114487, 102400, 228973}, along, 0, 0, one_q28, one_q28, near_q8};
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edge_that_zigzags_across_a_clip_plane_adds_one_vertex_at_most),
    };

    return cmocka_run_group_tests_name("clip", tests, NULL, NULL);
}
