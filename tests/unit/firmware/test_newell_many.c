/* SPDX-License-Identifier: MIT
 *
 * The depth sort on a hundred polygons that pass through each other all over: right, and within a number of comparisons
 * that grows with their square. And its limit, reached on purpose: each pixel is painted, and what was left is counted
 * with the reason. */
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"

#include <stdio.h>

enum { POLYGONS = 100, ROOM = 20000, DEPTH = 2400, REACH = 1100 };

typedef bool make_triangle(struct random *random, int index, int16_t at[3][3]);

static void random_corner(struct random *random, int reach, int16_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = (int16_t)random_in(random, -reach, reach);
}

static bool make_large(struct random *random, int index, int16_t at[3][3])
{
    (void)index;
    for (int k = 0; k < 3; k++)
        random_corner(random, REACH, at[k]);
    return true;
}

static bool make_thin(struct random *random, int index, int16_t at[3][3])
{
    (void)index;
    random_corner(random, REACH, at[0]);
    random_corner(random, REACH, at[1]);
    for (int i = 0; i < 3; i++)
        at[2][i] = (int16_t)(at[1][i] + random_in(random, -60, 60));
    return true;
}

/* All through one point. */
static bool make_star(struct random *random, int index, int16_t at[3][3])
{
    (void)index;
    random_corner(random, REACH / 2, at[0]);
    random_corner(random, REACH / 2, at[1]);
    for (int i = 0; i < 3; i++)
        at[2][i] = (int16_t)(-at[0][i] - at[1][i]);
    return true;
}

/* Three bars that hide each other in a ring, one ring behind the other. */
static bool make_ring(struct random *random, int index, int16_t at[3][3])
{
    static const int16_t bars[3][3][3] = {{{-1000, -400, 60}, {1000, -400, -60}, {1000, -100, -60}},
                                          {{300, -1000, 60}, {600, -1000, 60}, {-300, 1000, -60}},
                                          {{-600, -1000, -60}, {500, 1000, 60}, {100, 1000, 60}}};

    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            at[k][i] = (int16_t)(bars[index % 3][k][i] + random_in(random, -20, 20));
        at[k][2] = (int16_t)(at[k][2] + 20 * (index / 3) - 400);
    }
    return true;
}

/* Walls across walls. */
static bool make_wall(struct random *random, int index, int16_t at[3][3])
{
    const int16_t place = (int16_t)(40 * (index / 2) - 1000);
    const int16_t slope = (int16_t)random_in(random, -15, 15);
    const int across = index % 2 ? 0 : 2, along = 2 - across;

    for (int k = 0; k < 3; k++) {
        at[k][across] = (int16_t)(place + (k == 1 ? slope : 0));
        at[k][along] = (int16_t)(k == 0 ? -REACH : REACH);
        at[k][1] = (int16_t)(k == 2 ? -900 : 100 * k + 400);
    }
    return true;
}

/* As the eye sees it; false: edge-on, or nearly. */
static bool turn_to_eye(int16_t at[3][3])
{
    int64_t towards_eye = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        towards_eye += at[0][i] * ((int64_t)(at[1][j] - at[0][j]) * (at[2][k] - at[0][k]) -
                                   (int64_t)(at[1][k] - at[0][k]) * (at[2][j] - at[0][j]));
    }
    for (int i = 0; i < 3 && towards_eye < 0; i++) {
        const int16_t other = at[1][i];
        at[1][i] = at[2][i];
        at[2][i] = other;
    }
    return towards_eye > 1000000 || towards_eye < -1000000;
}

static void make_set(struct set *set, make_triangle *make, uint64_t seed)
{
    struct random random = {seed};

    set_init(set);
    for (int index = 0, name = 1; name <= POLYGONS; index++) {
        int16_t at[3][3];
        if (!make(&random, index % POLYGONS, at)) continue;
        for (int k = 0; k < 3; k++)
            at[k][2] = (int16_t)(at[k][2] + DEPTH);
        if (turn_to_eye(at)) set_add_seen(set, (uint16_t)name++, false, 3, (const int16_t(*)[3])at);
    }
}

static void assert_right_within(make_triangle *make, const char *what, uint32_t comparisons_most)
{
    static struct set set;
    static struct set_view view;
    const struct lim_camera camera = set_camera(false);

    for (uint64_t seed = 1; seed <= 3; seed++) {
        make_set(&set, make, seed);
        set_draw(&set, LIM_NEWELL, NULL, ROOM, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        const struct compare_counts counts = set_compare(&set, &view, false);
        printf("# %s: %u comparisons, %u splits, %u divisions, %u forced; wrong %zu, order errors %zu\n", what,
               stats->comparisons, stats->splits, stats->divisions, stats->forced, counts.wrong, counts.holes);
        assert_in_range(stats->comparisons, 1, comparisons_most);
        assert_int_equal(stats->forced_by[LIM_FORCED_EFFORT], 0);
        assert_int_equal(counts.holes, 0);
        set_view_free(&view);
    }
}

static void a_hundred_of_any_kind_are_right_within_40_comparisons_a_pair(void **state)
{
    const uint32_t most = 40 * POLYGONS * POLYGONS;

    (void)state;
    assert_right_within(make_large, "large", most);
    assert_right_within(make_thin, "thin", most);
    assert_right_within(make_star, "star", most);
    assert_right_within(make_ring, "rings", most);
    assert_right_within(make_wall, "walls", most);
}

/* However few comparisons: each pixel is painted once, set_draw() looks; what is left is counted. */
static void at_its_limit_a_frame_ends_and_says_why(void **state)
{
    static struct set set;
    static struct set_view view;
    const struct lim_camera camera = set_camera(false);
    uint32_t left_before = UINT32_MAX;

    (void)state;
    make_set(&set, make_large, 4);
    for (uint32_t most = 1; most <= 1000000; most *= 10) {
        const struct lim_newell_options options = {.most = most};
        set_draw(&set, LIM_NEWELL, &options, ROOM, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_true(stats->comparisons <= most + lim_stats(&view.lim)->sorted);
        if (most <= 10000) assert_in_range(stats->forced_by[LIM_FORCED_EFFORT], 1, lim_stats(&view.lim)->sorted);
        if (most == 1000000) assert_int_equal(stats->forced_by[LIM_FORCED_EFFORT], 0);
        if (most == 1) left_before = stats->forced;
        set_view_free(&view);
    }
    assert_in_range(left_before, POLYGONS - 1, POLYGONS);
}

static void what_memory_leaves_unsettled_has_its_own_reason(void **state)
{
    static struct set set;
    static struct set_view view;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    make_set(&set, make_large, 5);
    for (int pieces = 0; pieces < 2000; pieces = 3 * pieces + 40) {
        set_draw(&set, LIM_NEWELL, NULL, pieces, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_int_equal(stats->splits, pieces);
        assert_true(stats->forced_by[LIM_FORCED_ROOM] > 0);
        uint32_t sum = 0;
        for (int reason = 0; reason < LIM_FORCED_REASONS; reason++)
            sum += stats->forced_by[reason];
        assert_int_equal(sum, stats->forced);
        assert_true(stats->comparisons <= LIM_NEWELL_EFFORT * POLYGONS * POLYGONS + lim_stats(&view.lim)->sorted);
        set_view_free(&view);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hundred_of_any_kind_are_right_within_40_comparisons_a_pair),
        cmocka_unit_test(at_its_limit_a_frame_ends_and_says_why),
        cmocka_unit_test(what_memory_leaves_unsettled_has_its_own_reason),
    };

    return cmocka_run_group_tests_name("newell many", tests, NULL, NULL);
}
