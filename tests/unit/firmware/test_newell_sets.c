/* SPDX-License-Identifier: MIT
 *
 * The depth sort on random polygons, many of them through one another: right wherever the reference is certain, whole,
 * and at an end. Corners are whole units and planes exact, so that all there is to explain is the rounding on the
 * screen. */
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"

#include <stdio.h>
#include <string.h>

enum { SETS = 10000, MANY = 500, ROOM = 20000 };

static void random_vector(struct random *random, int range, int16_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = (int16_t)random_in(random, -range, range);
}

/* A triangle or a parallelogram before the eye, in whichever direction it faces it. false: it is edge-on, or too flat.
 */
static bool make_polygon(struct random *random, int range, int16_t corners[4][3], int *count)
{
    int16_t centre[3], u[3], v[3];
    int64_t towards_eye = 0;

    random_vector(random, 1800, centre);
    centre[2] = (int16_t)random_in(random, 1200, 3200);
    random_vector(random, range, u);
    random_vector(random, range, v);
    *count = (int)random_in(random, 3, 4);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        corners[0][i] = centre[i];
        corners[1][i] = (int16_t)(centre[i] + u[i]);
        corners[2][i] = (int16_t)(centre[i] + (*count == 4 ? u[i] : 0) + v[i]);
        corners[3][i] = (int16_t)(centre[i] + v[i]);
        towards_eye += centre[i] * ((int64_t)u[j] * v[k] - (int64_t)u[k] * v[j]);
    }
    if (towards_eye > 0) return towards_eye > 1000000; /* depth is ahead: a left-handed system */
    for (int i = 0; i < 3; i++) {
        const int16_t other = corners[1][i];
        corners[1][i] = corners[*count - 1][i];
        corners[*count - 1][i] = other;
    }
    return towards_eye < -1000000;
}

static void make_set(struct set *set, struct random *random, int count, int range)
{
    set_init(set);
    for (int name = 1; name <= count;) {
        int16_t corners[4][3];
        int corner_count;
        if (!make_polygon(random, range, corners, &corner_count)) continue;
        set_add_seen(set, (uint16_t)name++, false, corner_count, (const int16_t(*)[3])corners);
    }
}

/* Pixels that show nothing must be the same in whichever order all else comes: pieces have the pixels of the whole. */
static size_t lost_pixels(const struct set_view *view, const struct set_view *whole)
{
    size_t lost = 0;

    for (int y = 0; y < SET_SIDE_PX; y++) {
        for (int x = 0; x < SET_SIDE_PX; x++)
            lost += (view->pixels[y][x] == 0) != (whole->pixels[y][x] == 0);
    }
    return lost;
}

struct sum {
    struct compare_counts counts;
    struct lim_newell_stats stats;
    size_t lost, sorted;
};

static void add_to_sum(struct sum *sum, const struct set *set, const struct set_view *view)
{
    const struct compare_counts counts = set_compare(set, view, false);
    const struct lim_newell_stats *stats = &lim_stats(&view->lim)->newell;

    sum->counts.pixels += counts.pixels;
    sum->counts.wrong += counts.wrong;
    sum->counts.beyond += counts.beyond;
    sum->counts.holes += counts.holes;
    sum->stats.comparisons += stats->comparisons;
    sum->stats.swaps += stats->swaps;
    sum->stats.splits += stats->splits;
    sum->stats.forced += stats->forced;
    for (int i = 0; i < LIM_TESTS; i++)
        sum->stats.decided[i] += stats->decided[i];
    sum->sorted += lim_stats(&view->lim)->sorted;
}

static void print_sum(const char *what, const struct sum *sum)
{
    const struct lim_newell_stats *stats = &sum->stats;

    printf("# %s: %zu pixels, wrong %.4f %%, beyond %zu, order errors %zu, lost %zu\n", what, sum->counts.pixels,
           compare_wrong_percent(&sum->counts), sum->counts.beyond, sum->counts.holes, sum->lost);
    printf("#   %u comparisons; decided by x %u, y %u, 3 %u, 4 %u, 5 %u, 3' %u, 4' %u; %u swaps, %u splits, %u forced; "
           "%zu entries\n",
           stats->comparisons, stats->decided[0], stats->decided[1], stats->decided[2], stats->decided[3],
           stats->decided[4], stats->decided[5], stats->decided[6], stats->swaps, stats->splits, stats->forced,
           sum->sorted);
}

static void draw_sets(const struct lim_newell_options *options, int sets, uint64_t seed, struct sum *sum)
{
    static struct set set;
    static struct set_view view, whole;
    const struct lim_camera camera = set_camera(false);
    struct random random = {seed};

    *sum = (struct sum){.lost = 0};
    for (int s = 0; s < sets; s++) {
        make_set(&set, &random, (int)random_in(&random, 2, 12), (int)random_in(&random, 200, 2000));
        set_draw(&set, LIM_NEWELL, options, ROOM, &camera, &view);
        set_draw(&set, LIM_DEPTH, NULL, -1, &camera, &whole);
        add_to_sum(sum, &set, &view);
        sum->lost += lost_pixels(&view, &whole);
        set_view_free(&view);
        set_view_free(&whole);
    }
}

static void ten_thousand_sets_agree_with_the_reference(void **state)
{
    struct sum sum;

    (void)state;
    draw_sets(NULL, SETS, 91, &sum);
    print_sum("random sets", &sum);
    assert_int_equal(sum.lost, 0);
    assert_int_equal(sum.stats.forced, 0);
    assert_int_equal(sum.counts.holes, 0);
    assert_true(compare_wrong_percent(&sum.counts) < 0.2);
    assert_true(sum.stats.splits > SETS && sum.stats.swaps > SETS / 10);
}

static void so_do_they_with_every_option(void **state)
{
    (void)state;
    for (int i = 1; i < 4; i++) {
        const struct lim_newell_options options = {.planes_first = i & 1, .split_one = i & 2};
        struct sum sum;
        draw_sets(&options, SETS / 10, 92, &sum);
        print_sum(i == 1 ? "planes first" : i == 2 ? "split of one" : "planes first, split of one", &sum);
        assert_int_equal(sum.lost, 0);
        assert_int_equal(sum.stats.forced, 0);
        assert_int_equal(sum.counts.holes, 0);
    }
}

static void draw_many(struct set *set, const char *what, const struct lim_newell_options *options, int pieces,
                      struct sum *sum)
{
    static struct set_view view, whole;
    const struct lim_camera camera = set_camera(false);

    *sum = (struct sum){.lost = 0};
    set_draw(set, LIM_NEWELL, options, pieces, &camera, &view);
    set_draw(set, LIM_DEPTH, NULL, -1, &camera, &whole);
    add_to_sum(sum, set, &view);
    sum->lost = lost_pixels(&view, &whole);
    print_sum(what, sum);
    assert_int_equal(sum->lost, 0);
    set_view_free(&view);
    set_view_free(&whole);
}

static void five_hundred_random_polygons_end_and_are_right(void **state)
{
    static struct set set;
    struct random random = {93};

    (void)state;
    for (int range = 400; range <= 800; range += 400) {
        struct sum sum;
        make_set(&set, &random, MANY, range);
        draw_many(&set, "500 polygons", NULL, ROOM, &sum);
        assert_int_equal(sum.counts.holes, 0);
        assert_int_equal(sum.stats.forced, 0);
        assert_true(sum.stats.splits > (uint32_t)range);
    }
}

static void without_room_for_all_splits_they_end_all_the_same(void **state)
{
    static struct set set;
    static struct set_view view;
    const struct lim_camera camera = set_camera(false);
    struct random random = {94};

    (void)state;
    make_set(&set, &random, MANY, 1800);
    for (int pieces = 0; pieces <= 512; pieces = pieces * 2 + 1) {
        set_draw(&set, LIM_NEWELL, NULL, pieces, &camera, &view);
        const struct lim_newell_stats *stats = &lim_stats(&view.lim)->newell;
        assert_int_equal(stats->splits, pieces);
        assert_true(stats->forced > 0);
        set_view_free(&view);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ten_thousand_sets_agree_with_the_reference),
        cmocka_unit_test(so_do_they_with_every_option),
        cmocka_unit_test(five_hundred_random_polygons_end_and_are_right),
        cmocka_unit_test(without_room_for_all_splits_they_end_all_the_same),
    };

    return cmocka_run_group_tests_name("newell sets", tests, NULL, NULL);
}
