/* SPDX-License-Identifier: MIT
 *
 * Mesh leaves against brute force (soup_rig.h): which pixels each triangle covers, and which is seen by distance, by
 * each order that walks a tree; with walls of a tree around them; and the same picture from any memory, in parts, into
 * a framebuffer and antialiased by both orders. */
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "unit/firmware/soup_rig.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    RECORD_WORDS = LIM_POLYGON_HEAD_WORDS + 3,
    WORDS = SOUP_TRIANGLES * RECORD_WORDS + LIM_POLYGON_MESH_WORDS,
    FRAMES = 120
};

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_SCANLINE, LIM_PAINTER};
enum { ORDERS = sizeof orders / sizeof *orders };

struct size {
    uint16_t w_px, h_px;
};
static const struct size sizes[] = {{64, 64}, {128, 64}, {1, 100}, {120, 90}, {77, 33}};
enum { SIZES = sizeof sizes / sizeof *sizes };

static struct soup soup;

/* The same triangles as a tree of one mesh leaf. */
struct leaf {
    lim_index words[WORDS];
    struct lim_node node;
    struct soup soup; /* for soup_view_init(), which asks for its scene */
};
static struct leaf leaf;

static size_t add_record(lim_index *to, const lim_index *triangle, bool is_first, bool is_last)
{
    const lim_index more[LIM_POLYGON_MESH_WORDS] = {0, soup.scene.vertex_count, soup.scene.polygon_count, 0};

    to[0] = (lim_index)(3 | (is_first ? LIM_POLYGON_MESH : 0u) | (is_last ? LIM_POLYGON_LAST : 0u));
    to[1] = triangle[3];
    for (int k = 0; k < 3; k++)
        to[2 + k] = triangle[k];
    if (is_first) memcpy(&to[RECORD_WORDS], more, sizeof more);
    return RECORD_WORDS + (is_first ? LIM_POLYGON_MESH_WORDS : 0);
}

/* Room for all of its polygons, or some. */
static void make_leaf(struct random *random)
{
    size_t used = 0;

    for (lim_index i = 0; i < soup.scene.polygon_count; i++)
        used += add_record(&leaf.words[used], &soup.words[i * LIM_TRIANGLE_WORDS], i == 0,
                           i + 1u == soup.scene.polygon_count);
    leaf.node = (struct lim_node){.split = {.plane = LIM_NO_INDEX},
                                  .front = LIM_NO_INDEX,
                                  .back = LIM_NO_INDEX,
                                  .back_run = LIM_NO_INDEX,
                                  .box = 0};
    leaf.soup.scene = soup.scene;
    leaf.soup.scene.nodes = &leaf.node;
    leaf.soup.scene.node_count = 1;
    leaf.soup.scene.polygons = leaf.words;
    leaf.soup.scene.polygon_words = (lim_index)used;
    leaf.soup.scene.limits = (struct lim_limits){
        .depth = 1,
        .vertices = 3,
        .retained_cells = (uint16_t)(8 * soup.scene.polygon_count + 8),
        .gaps = 2000,
        .active = (uint16_t)soup.scene.polygon_count,
        .leaf_vertices = (uint16_t)soup.scene.vertex_count,
        .leaf_polygons = (uint16_t)(random_u64(random) & 1 ? soup.scene.polygon_count
                                                           : random_in(random, 1, (int)soup.scene.polygon_count))};
}

static struct lim_camera make(struct random *random, unsigned kind)
{
    const double radius = exp(log(100) + random_unit(random) * log(300));
    const double distance =
        random_u64(random) % 4 ? radius * (1.1 + 2 * random_unit(random)) : radius * random_unit(random);

    soup_random(&soup, random, kind, radius);
    make_leaf(random);
    return soup_camera(random, kind == 6 ? 30 : distance);
}

/* Against brute force ---------------------------------------------------------------------------------------------- */

static void by_every_order_the_nearest_middle_is_seen(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {2100 + k};
        uint64_t covered = 0, clipped = 0, ambiguous = 0;
        for (int i = 0; i < effort(FRAMES); i++) {
            const struct size size = sizes[i / SOUP_KINDS % SIZES];
            const uint64_t seed = random.state;
            const struct lim_camera camera = make(&random, (unsigned)i % SOUP_KINDS);
            struct soup_view view;
            assert_int_equal(
                soup_view_init(&view, found[k], &leaf.soup, orders[i % ORDERS], size.w_px, size.h_px, 0, 0xA5), LIM_OK);
            assert_int_equal(view.core->frame(view.lim, &camera), LIM_OK);
            const struct soup_counts counts = soup_compare(&soup, &view, LIM_MESH, &camera);
            if (counts.wrong)
                fail_msg("%s, kind %d, order %d, %u x %u, seed %llu: %u of %u pixels, one at %u, %u", found[k]->name,
                         i % SOUP_KINDS, i % ORDERS, size.w_px, size.h_px, (unsigned long long)seed, counts.wrong,
                         counts.covered, counts.at_x, counts.at_y);
            covered += counts.covered;
            clipped += counts.clipped;
            ambiguous += counts.ambiguous;
            soup_view_free(&view);
        }
        printf("# %s: %llu pixels covered, %llu ambiguous, %llu triangles clipped\n", found[k]->name,
               (unsigned long long)covered, (unsigned long long)ambiguous, (unsigned long long)clipped);
        assert_true(covered > 0 && ambiguous < covered / 10);
    }
}

/* The same picture ------------------------------------------------------------------------------------------------- */

enum { W_PX = 60, H_PX = 45, LINE_B = 2 * (W_PX + 2), PICTURE_B = H_PX * LINE_B };

static void *lend(void *ctx, uint16_t y_px)
{
    return (uint16_t *)ctx + (size_t)y_px * (W_PX + 2);
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    assert_true(y_px < H_PX && x_px + n_px <= W_PX);
    return 0;
}

/* part_q8: of the memory between the least and what is comfortable. */
static void draw(const struct core *core, enum lim_method method, const struct lim_camera *camera, unsigned part_q8,
                 uint16_t *out)
{
    const struct lim_target target = {
        .w_px = W_PX, .h_px = H_PX, .format = LIM_RGB565, .method = method, .ctx = out, .lend = lend, .done = done};
    const size_t least_b = core->mem_min_b(&leaf.soup.scene, &target), most_b = core->mem_b(&leaf.soup.scene, &target);
    const size_t mem_b = least_b + ((most_b - least_b) * part_q8 >> 8) / 8 * 8;
    void *lim = malloc(core->lim_b), *mem = malloc(mem_b);

    assert_true(lim && mem);
    memset(mem, 0x5A, mem_b);
    memset(out, 0, PICTURE_B);
    assert_int_equal(core->init(lim, &leaf.soup.scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(core->frame(lim, camera), LIM_OK);
    free(lim);
    free(mem);
}

static void any_order_and_any_memory_show_the_same(void **state)
{
    static uint16_t first[PICTURE_B / 2], other[PICTURE_B / 2];
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {2300 + k};
        for (int i = 0; i < effort(FRAMES); i++) {
            const uint64_t seed = random.state;
            const struct lim_camera camera = make(&random, (unsigned)i % SOUP_KINDS);
            draw(found[k], LIM_PAINTER, &camera, 256, first);
            leaf.soup.scene.limits.leaf_polygons = (uint16_t)random_in(&random, 1, (int)soup.scene.polygon_count);
            for (int part = 0; part <= 256; part += 64)
                for (int m = 0; m < 2; m++) {
                    draw(found[k], orders[m], &camera, (unsigned)part, other);
                    if (memcmp(first, other, PICTURE_B) != 0)
                        fail_msg("%s, kind %d, order %d with %d / 256 of the pools, seed %llu", found[k]->name,
                                 i % SOUP_KINDS, m, part, (unsigned long long)seed);
                }
        }
    }
}

/* What does not draw them ------------------------------------------------------------------------------------------ */

static void other_methods_refuse_them(void **state)
{
    static const enum lim_method others[] = {LIM_DEPTH, LIM_NEWELL, LIM_CONVEX, LIM_MESH, LIM_MESH_DEPTH};
    const struct core *found[PROFILES_MAX];
    struct random random = {7};

    (void)state;
    profiles_find(found);
    make(&random, 0);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        struct soup_view view;
        assert_int_not_equal(soup_view_init(&view, found[0], &leaf.soup, others[i], W_PX, H_PX, 1 << 20, 0), LIM_OK);
        soup_view_free(&view);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_every_order_the_nearest_middle_is_seen),
        cmocka_unit_test(any_order_and_any_memory_show_the_same),
        cmocka_unit_test(other_methods_refuse_them),
    };

    return cmocka_run_group_tests_name("mesh_leaves", tests, NULL, NULL);
}
