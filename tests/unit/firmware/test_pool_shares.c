/* SPDX-License-Identifier: MIT
 *
 * How memory is shared out among the nearest-first order's pools: what is asked for is what they take; pieces and
 * layers are in proportion between the least and the scene's limits; what is left over goes to pieces, and else to what
 * cells, gaps and polygons on a line share; and pools lie side by side within the memory that was lent. */
#include "limner.h"
#include "rigs/cmocka_ready.h"
#include "rigs/set_rig.h"

#include <stdlib.h>
#include <string.h>

enum { H_PX = 40, LEAST_CELLS = LIM_RETAINED_HEAD_CELLS + 4 + 5, ALIGNED = 64 };

struct sizes {
    size_t shared_b, pieces, layers;
};

static size_t shared_b(size_t active, size_t cells, size_t gaps)
{
    const size_t sum_b =
        active * sizeof(struct lim_active) + cells * sizeof(union lim_retained_cell) + gaps * LIM_GAP_MEM_B;

    return (sum_b + 3) & ~(size_t)3;
}

static void *lend(void *ctx, uint16_t y_px)
{
    (void)y_px;
    return ctx;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

static struct lim_target target_of(enum lim_method method)
{
    return (struct lim_target){
        .w_px = 50, .h_px = H_PX, .format = LIM_RGB565, .method = method, .lend = lend, .done = done};
}

static void make_set(struct set *set)
{
    static const int16_t corners[3][3] = {{0, 0, -100}, {90, 0, -100}, {0, 90, -100}};

    set_init(set);
    set_add(set, 1, 3, corners);
    set_add(set, 2, 3, corners);
    set->scene.limits = (struct lim_limits){7, 4, 101, 33, 9, 20, 6, 0, 0};
}

/* All that a renderer is lent, in bytes, one after the other. */
static size_t sum_b(enum lim_method method, const struct sizes *sizes)
{
    const bool sorts = method == LIM_DEPTH || method == LIM_NEWELL;
    const size_t entries = 2 + sizes->pieces;
    size_t b = LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + H_PX * sizeof(struct lim_line) +
               sizes->shared_b + sizes->layers * sizeof(struct lim_layer);

    if (!sorts) b += 7 * sizeof(struct lim_walk_pending);
    if (sorts) b += entries * sizeof(struct lim_sorted);
    if (method == LIM_NEWELL)
        b += entries * sizeof(struct lim_newell_polygon) + sizes->pieces * 2 * sizeof(struct lim_cut);
    return b;
}

/* Elements have numbers of 16 bits, the last of which means none. */
static size_t numbered(size_t count)
{
    return count < 65535 ? count : 65534;
}

static struct sizes sizes_of(const struct lim *lim, enum lim_method method)
{
    const struct lim_retained *retained = &lim->nearest->retained;
    struct sizes sizes = {(size_t)((uint8_t *)lim->pass.view.cache - (uint8_t *)retained->cells), 0,
                          lim->nearest->paint.layers->own_size};

    assert_int_equal(retained->whole, numbered(sizes.shared_b / sizeof(union lim_retained_cell)));
    assert_int_equal(lim->nearest->spans.pool_size, numbered(sizes.shared_b / sizeof(struct lim_gap)));
    assert_int_equal(*lim->nearest->spans.strips_size, numbered(sizes.shared_b / LIM_GAP_MEM_B));
    assert_ptr_equal(lim->nearest->spans.pool, retained->cells);
    assert_ptr_equal(*lim->nearest->spans.strips, retained->cells);
    assert_ptr_equal(lim->nearest->paint.actives.pool, lim->pass.view.cache);

    if (method == LIM_NEWELL) {
        sizes.pieces = lim->sorter->size - 2u;
        assert_int_equal(lim->sorter->newell->cut_size, 2 * sizes.pieces);
    }
    if (method == LIM_DEPTH) assert_int_equal(lim->sorter->size, 2);
    return sizes;
}

/* Memory is lent at the widest alignment, and in any number of bytes. */
static void mark(uint8_t *mem, size_t mem_b, const void *pool, size_t pool_b, size_t align_b)
{
    const size_t at = (size_t)((const uint8_t *)pool - mem);

    assert_int_equal((uintptr_t)pool % align_b, 0);
    assert_true(at <= mem_b && pool_b <= mem_b - at);
    for (size_t k = 0; k < pool_b; k++)
        assert_int_equal(mem[at + k]++, 0);
}

/* No byte is in two pools, and none beyond the memory is in one; each is aligned. */
static void check_places(struct lim *lim, enum lim_method method, uint8_t *mem, size_t mem_b)
{
    const struct sizes sizes = sizes_of(lim, method);
    const struct lim_sorter *sorter = lim->sorter;

    memset(mem, 0, mem_b);
    mark(mem, mem_b, lim->nearest->retained.cells, sizes.shared_b, _Alignof(union lim_retained_cell));
    mark(mem, mem_b, lim->nearest->spans.lines, H_PX * sizeof(struct lim_line), _Alignof(struct lim_line));
    mark(mem, mem_b, lim->nearest->paint.layers->own, sizes.layers * sizeof(struct lim_layer),
         _Alignof(struct lim_layer));
    mark(mem, mem_b, lim->pass.view.cache, LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached),
         _Alignof(struct lim_view_cached));
    if (method == LIM_NEAREST_FIRST)
        mark(mem, mem_b, lim->pass.walk->stack, 7 * sizeof *lim->pass.walk->stack, _Alignof(struct lim_walk_pending));
    if (method != LIM_NEAREST_FIRST)
        mark(mem, mem_b, sorter->list, sorter->size * sizeof *sorter->list, _Alignof(struct lim_sorted));
    if (method != LIM_NEWELL) return;
    mark(mem, mem_b, sorter->newell->polygons, sorter->size * sizeof *sorter->newell->polygons,
         _Alignof(struct lim_newell_polygon));
    mark(mem, mem_b, sorter->newell->cuts, sorter->newell->cut_size * sizeof *sorter->newell->cuts,
         _Alignof(struct lim_cut));
}

static struct sizes share(const struct set *set, enum lim_method method, size_t mem_b)
{
    const struct lim_target target = target_of(method);
    uint8_t *mem = aligned_alloc(ALIGNED, (mem_b + ALIGNED - 1) / ALIGNED * ALIGNED);
    struct lim lim;

    assert_non_null(mem);
    assert_int_equal(lim_init(&lim, &set->scene, &target, mem, mem_b), LIM_OK);
    check_places(&lim, method, mem, mem_b);
    free(mem);
    return sizes_of(&lim, method);
}

static void assert_sizes(struct sizes found, struct sizes expected)
{
    assert_in_range(found.shared_b, expected.shared_b, expected.shared_b + 15); /* aligned */
    assert_int_equal(found.pieces, expected.pieces);
    assert_int_equal(found.layers, expected.layers);
}

static size_t proportion(size_t least, size_t most, size_t part)
{
    return least + (most - least) * part / 256;
}

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_DEPTH, LIM_NEWELL};
enum { ORDERS = sizeof orders / sizeof *orders };

/* Bands do not make up for pieces. */
static struct sizes least_of(enum lim_method method)
{
    return (struct sizes){shared_b(1, LEAST_CELLS, 1), method == LIM_NEWELL ? 20 : 0, 0};
}

static struct sizes wanted_of(enum lim_method method)
{
    return (struct sizes){shared_b(9, 101, 33), method == LIM_NEWELL ? 20 : 0, 6};
}

static void pools_are_the_least_and_those_wanted(void **state)
{
    static struct set set;

    (void)state;
    make_set(&set);
    for (int i = 0; i < ORDERS; i++) {
        const struct lim_target target = target_of(orders[i]);
        const struct sizes least = least_of(orders[i]), wanted = wanted_of(orders[i]);
        const size_t least_b = lim_mem_min_b(&set.scene, &target), wanted_b = lim_mem_b(&set.scene, &target);
        const size_t sum_least_b = sum_b(orders[i], &least), sum_wanted_b = sum_b(orders[i], &wanted);
        struct lim lim;
        assert_in_range(least_b, sum_least_b, sum_least_b + 7); /* aligned */
        assert_in_range(wanted_b, sum_wanted_b, sum_wanted_b + 15);
        assert_sizes(share(&set, orders[i], least_b), least);
        assert_sizes(share(&set, orders[i], wanted_b), wanted);
        uint8_t *mem = aligned_alloc(ALIGNED, (least_b + ALIGNED - 1) / ALIGNED * ALIGNED);
        assert_non_null(mem);
        assert_int_equal(lim_init(&lim, &set.scene, &target, mem, least_b - 1), LIM_ERR_MEMORY);
        free(mem);
    }
}

static void pools_in_between_are_in_proportion(void **state)
{
    static struct set set;

    (void)state;
    make_set(&set);
    for (int i = 0; i < ORDERS; i++) {
        const struct lim_target target = target_of(orders[i]);
        const struct sizes least = least_of(orders[i]), wanted = wanted_of(orders[i]);
        const size_t least_b = lim_mem_min_b(&set.scene, &target), wanted_b = lim_mem_b(&set.scene, &target);
        for (size_t mem_b = least_b; mem_b < wanted_b; mem_b++) {
            const size_t part = (mem_b - least_b) * 256 / (wanted_b - least_b);
            struct sizes expected = {0, proportion(least.pieces, wanted.pieces, part),
                                     proportion(least.layers, wanted.layers, part)};
            expected.shared_b = (mem_b - sum_b(orders[i], &expected)) / 8 * 8;
            assert_sizes(share(&set, orders[i], mem_b), expected);
        }
    }
}

/* A list has 32767 entries at most. */
static void what_is_left_over_goes_to_pieces(void **state)
{
    static const size_t more[] = {0, 1, 2, 63, 32766 - 22, 32767 - 22, 32768 - 22, 40000};
    const size_t piece_b = sizeof(struct lim_sorted) + sizeof(struct lim_newell_polygon) + 2 * sizeof(struct lim_cut);
    static struct set set;

    (void)state;
    make_set(&set);
    for (size_t k = 0; k < sizeof more / sizeof *more; k++)
        for (int i = 0; i < ORDERS; i++)
            for (size_t odd_b = 0; odd_b < piece_b; odd_b += piece_b - 1) {
                const struct lim_target target = target_of(orders[i]);
                struct sizes wanted = wanted_of(orders[i]);
                const size_t mem_b = lim_mem_b(&set.scene, &target) + more[k] * piece_b + odd_b;
                if (orders[i] == LIM_NEWELL) wanted.pieces += more[k] < 32767 - 22 ? more[k] : 32767 - 22;
                wanted.shared_b = 0;
                wanted.shared_b = (mem_b - sum_b(orders[i], &wanted)) / 8 * 8;
                assert_sizes(share(&set, orders[i], mem_b), wanted);
            }
}

/* Nothing else stays within what 16 bits count: a scene that says it wants more pieces than a list has gets those. */
static void pieces_end_where_a_list_does(void **state)
{
    static struct set set;

    (void)state;
    make_set(&set);
    for (unsigned pieces = 32763; pieces < 32768; pieces++) {
        const struct lim_target target = target_of(LIM_NEWELL);
        set.scene.limits.pieces = (uint16_t)pieces;
        struct sizes wanted = wanted_of(LIM_NEWELL);
        wanted.pieces = pieces < 32765 ? pieces : 32765;
        assert_sizes(share(&set, LIM_NEWELL, lim_mem_b(&set.scene, &target)), wanted);
    }
}

/* More polygons than a list holds are not sorted, and have no pieces. */
static void lists_that_would_be_too_long_have_no_pieces(void **state)
{
    const struct lim_target target = target_of(LIM_NEWELL);
    static struct set set;

    (void)state;
    make_set(&set);
    for (unsigned count = 32766; count < 32770; count++) {
        set.scene.polygon_count = (lim_index)count;
        set.scene.limits.pieces = 20;
        const size_t wanted_b = lim_mem_b(&set.scene, &target);
        set.scene.limits.pieces = 0;
        const size_t without_b = lim_mem_b(&set.scene, &target);
        const size_t piece_b =
            sizeof(struct lim_sorted) + sizeof(struct lim_newell_polygon) + 2 * sizeof(struct lim_cut);
        assert_int_equal(wanted_b - without_b, count < 32767 ? piece_b : 0);
    }
}

/* What is left over is shared, too. */
static void what_is_left_over_is_shared(void **state)
{
    static struct set set;
    const struct lim_target target = target_of(LIM_NEAREST_FIRST);

    (void)state;
    make_set(&set);
    const size_t wanted_b = lim_mem_b(&set.scene, &target);
    struct sizes wanted = wanted_of(LIM_NEAREST_FIRST);
    wanted.shared_b += 1000;
    assert_sizes(share(&set, LIM_NEAREST_FIRST, wanted_b + 1000), wanted);
}

/* Where scan lines may be antialiased they have the gaps that the scene's limits say. */
static void lines_painted_at_once_have_the_gaps_of_one(void **state)
{
    const struct lim_target target = target_of(LIM_SCANLINE);
    static struct set set;
    struct sizes wanted = wanted_of(LIM_SCANLINE);

    (void)state;
    make_set(&set);
    set.scene.limits.layers = 0;
    wanted.layers = 0;
    const size_t opaque_b = sum_b(LIM_SCANLINE, &wanted);
    assert_in_range(lim_mem_b(&set.scene, &target), opaque_b, opaque_b + 15);
}

/* Side by side, none behind another. */
static void as_many_are_active_as_cross_a_line(void **state)
{
    const struct lim_camera camera = set_camera(false);
    static struct set_view view;
    static struct set set;

    (void)state;
    for (int count = 1; count <= 5; count++) {
        set_init(&set);
        for (int i = 0; i < count; i++) {
            const int16_t x = (int16_t)(-900 + 350 * i), top = (int16_t)(500 + 90 * i);
            const int16_t corners[4][3] = {
                {x, -800, -1000}, {(int16_t)(x + 300), -800, -1000}, {(int16_t)(x + 300), top, -1000}, {x, top, -1000}};
            set_add(&set, (lim_index)(i + 1), 4, corners);
        }
        set_draw(&set, LIM_NEAREST_FIRST, NULL, -1, &camera, &view);
        assert_int_equal(lim_stats(&view.lim)->active_max, count);
        set_view_free(&view);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pools_are_the_least_and_those_wanted),
        cmocka_unit_test(pools_in_between_are_in_proportion),
        cmocka_unit_test(what_is_left_over_goes_to_pieces),
        cmocka_unit_test(pieces_end_where_a_list_does),
        cmocka_unit_test(lists_that_would_be_too_long_have_no_pieces),
        cmocka_unit_test(what_is_left_over_is_shared),
        cmocka_unit_test(lines_painted_at_once_have_the_gaps_of_one),
        cmocka_unit_test(as_many_are_active_as_cross_a_line),
    };

    return cmocka_run_group_tests_name("pool_shares", tests, NULL, NULL);
}
