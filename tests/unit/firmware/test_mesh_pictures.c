/* SPDX-License-Identifier: MIT
 *
 * Meshes without a tree against brute force: which pixels each triangle covers, to the pixel, and which of them is seen
 * there, by distance and by depth. */
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "unit/firmware/soup_rig.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct size {
    uint16_t w_px, h_px;
};

static const struct size sizes[] = {{8, 8}, {128, 64}, {1, 200}, {240, 240}, {77, 33}, {320, 480}, {1000, 3}};
enum { SIZES = sizeof sizes / sizeof *sizes, FRAMES = 150 };

static struct soup soup;

/* Some eyes among the triangles, some where all of them are a few pixels. */
static double distance_of(struct random *random, double radius)
{
    switch (random_u64(random) % 6) {
    case 0:
        return radius * random_unit(random);
    case 1:
        return fmin(radius * (3 + 100 * random_unit(random)), 1e6);
    default:
        return radius * (1.1 + 2 * random_unit(random));
    }
}

struct totals {
    uint64_t pixels, covered, ambiguous, clipped, painted;
};

static void try_one(const struct core *core, struct random *random, enum lim_method method, unsigned kind,
                    struct size size, struct totals *totals)
{
    const uint64_t seed = random->state;
    const double radius = exp(log(100) + random_unit(random) * log(300));
    struct soup_view view;

    soup_random(&soup, random, kind, radius);
    const struct lim_camera camera = soup_camera(random, kind == 6 ? 30 : distance_of(random, radius));
    assert_int_equal(soup_view_init(&view, core, &soup, method, size.w_px, size.h_px, 0, 0xA5), LIM_OK);
    assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
    const struct soup_counts counts = soup_compare(&soup, &view, method, &camera);
    if (counts.wrong)
        fail_msg("%s, kind %u, method %d, %u x %u, seed %llu: %u of %u pixels, one at %u, %u", core->name, kind,
                 (int)method, size.w_px, size.h_px, (unsigned long long)seed, counts.wrong, counts.covered, counts.at_x,
                 counts.at_y);
    const struct lim_stats *stats = core->stats(view.lim);
    if (!counts.clipped) assert_int_equal(stats->pixels_painted, counts.painted);
    assert_int_equal(stats->pixels_background, counts.pixels);
    assert_int_equal(stats->records, soup.scene.polygon_count);
    totals->pixels += counts.pixels;
    totals->covered += counts.covered;
    totals->ambiguous += counts.ambiguous;
    totals->clipped += counts.clipped;
    totals->painted += counts.painted;
    soup_view_free(&view);
}

static void try_all(enum lim_method method, uint64_t seed)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);

    for (size_t k = 0; k < count; k++) {
        struct random random = {seed + k};
        struct totals totals = {0};
        for (int i = 0; i < effort(FRAMES); i++)
            try_one(found[k], &random, method, (unsigned)i % SOUP_KINDS, sizes[i / SOUP_KINDS % SIZES], &totals);
        printf("# %s: %.0f %% of the pixels covered, %.1f times; %.2f %% ambiguous, %llu triangles clipped\n",
               found[k]->name, 100.0 * (double)totals.covered / (double)totals.pixels,
               (double)totals.painted / (double)totals.covered,
               100.0 * (double)totals.ambiguous / (double)totals.covered, (unsigned long long)totals.clipped);
        if (effort(FRAMES) < FRAMES) continue; /* too few to count */
        assert_true(totals.clipped > 0 && totals.covered > totals.pixels / 20);
        assert_true(totals.ambiguous < totals.covered / 10);
    }
}

static void by_distance_the_nearest_middle_is_seen(void **state)
{
    (void)state;
    try_all(LIM_MESH, 1100);
}

/* Its far edge is next to nothing near: less, by what rounding takes from the plane, would be nearest of all. */
static void nothing_far_away_is_nearest(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {1};
        struct totals totals = {0};
        for (int i = 0; i < effort(40); i++)
            try_one(found[k], &random, LIM_MESH_DEPTH, 6, sizes[i % 5], &totals);
        assert_true(totals.covered > 0);
    }
}

static void by_depth_the_nearest_is_seen_at_each_pixel(void **state)
{
    (void)state;
    try_all(LIM_MESH_DEPTH, 1300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_distance_the_nearest_middle_is_seen),
        cmocka_unit_test(by_depth_the_nearest_is_seen_at_each_pixel),
        cmocka_unit_test(nothing_far_away_is_nearest),
    };

    return cmocka_run_group_tests_name("mesh_pictures", tests, NULL, NULL);
}
