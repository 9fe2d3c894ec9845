/* SPDX-License-Identifier: MIT
 *
 * Objects that move where nothing else is: each is seen as its records say, nearest first and by scan lines; those one
 * behind the other are drawn one after the other, and those whose boxes overlap are compared line by line. */
#include "colour.h"
#include "limner.h"
#include "rigs/cmocka_ready.h"
#include "rigs/moving_mem.h"
#include "rigs/plain_lines.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"

#include <stdlib.h>
#include <string.h>

enum { OBJECTS = 3 };

/* A scene without a node, and what draws objects in it. */
struct stage {
    struct set nothing, objects[OBJECTS];
    struct lim_instance instances[OBJECTS];
    struct lim lim;
    struct moving_mem mem;
    struct plain_lines lines;
    uint16_t pixels[SET_SIDE_PX][SET_SIDE_PX];
};

static const enum lim_method orders[] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
enum { ORDERS = sizeof orders / sizeof *orders };

static void stage_init(struct stage *stage)
{
    memset(stage, 0, sizeof *stage);
    set_init(&stage->nothing);
    stage->nothing.scene.nodes = NULL;
    stage->nothing.scene.node_count = 0;
    for (int i = 0; i < OBJECTS; i++) {
        set_init(&stage->objects[i]);
        stage->instances[i].object = &stage->objects[i].scene;
        lim_instance_turn(&stage->instances[i], 0, 0, 0);
    }
}

static const struct lim_stats *draw(struct stage *stage, enum lim_method method, uint16_t count)
{
    const struct lim_movers_limits limits = {OBJECTS, 1, 0, 0};
    const struct lim_target target = plain_lines_target(&stage->lines, SET_SIDE_PX, SET_SIDE_PX, method);
    const struct lim_camera camera = set_camera(false);

    stage->lines = (struct plain_lines){stage->pixels[0], SET_SIDE_PX};
    moving_mem_free(&stage->mem);
    memset(stage->pixels, 0xA5, sizeof stage->pixels);
    moving_mem_init(&stage->mem, &stage->lim, &stage->nothing.scene, &target, &limits);
    assert_int_equal(lim_movers_frame(&stage->lim, &camera, stage->instances, count), LIM_OK);
    const struct lim_stats *stats = lim_stats(&stage->lim);
    assert_int_equal(stats->movers.left_out, 0);
    return stats;
}

static void stage_free(struct stage *stage)
{
    moving_mem_free(&stage->mem);
}

/* A square across the way that the eye looks, of pixels x0 <= x < x1 and y alike, that depth ahead. */
static void add_square(struct set *set, uint16_t colour, int x0, int y0, int x1, int y1, int depth)
{
    const int half_px = SET_SIDE_PX / 2, x[4] = {x0, x1, x1, x0}, y[4] = {y1, y1, y0, y0};
    int16_t corners[4][3];

    for (int k = 0; k < 4; k++) {
        corners[k][0] = (int16_t)((x[k] - half_px) * depth / half_px);
        corners[k][1] = (int16_t)((half_px - y[k]) * depth / half_px);
        corners[k][2] = (int16_t)-depth;
    }
    set_add(set, colour, 4, (const int16_t(*)[3])corners);
}

static uint16_t pixel_at(const struct stage *stage, int x, int y)
{
    return lim_memory_colour(stage->pixels[y][x]);
}

/* Some squares, nearest first, each larger than the one before: one run of records. */
static void all_records_of_a_run_are_seen(void **state)
{
    static struct stage stage;

    (void)state;
    for (int count = 1; count <= 4; count++)
        for (int i = 0; i < ORDERS; i++) {
            stage_init(&stage);
            for (int k = 1; k <= count; k++)
                add_square(&stage.objects[0], (uint16_t)k, 32 - 6 * k, 32 - 5 * k, 32 + 4 * k, 32 + 3 * k,
                           640 + 64 * k);
            const struct lim_stats *stats = draw(&stage, orders[i], 1);
            assert_int_equal(stats->movers.crowded, 0);
            for (int y = 0; y < SET_SIDE_PX; y++)
                for (int x = 0; x < SET_SIDE_PX; x++) {
                    int nearest = 0;
                    for (int k = count; k >= 1; k--)
                        if (x >= 32 - 6 * k && x < 32 + 4 * k && y >= 32 - 5 * k && y < 32 + 3 * k) nearest = k;
                    assert_int_equal(pixel_at(&stage, x, y), nearest);
                }
            stage_free(&stage);
        }
}

/* A cube of faces towards the eye and from it: what the ball is about. Centred on the origin of its object. */
static void add_thing(struct set *set, uint16_t colour, int16_t half)
{
    const int16_t low = (int16_t)-half;
    const int16_t faces[2][4][3] = {{{low, low, half}, {half, low, half}, {half, half, half}, {low, half, half}},
                                    {{low, half, low}, {half, half, low}, {half, low, low}, {low, low, low}}};

    for (int i = 0; i < 2; i++)
        set_add(set, colour, 4, faces[i]);
}

/* Two things, one behind the other, their boxes `gap_q8` apart: how many are compared. */
static uint32_t crowded(struct stage *stage, enum lim_method method, int32_t gap_q8, bool swapped)
{
    stage_init(stage);
    for (int i = 0; i < 2; i++)
        add_thing(&stage->objects[i], (uint16_t)(i + 1), (int16_t)(100 + 60 * i));
    stage->instances[0].at_q8[2] = -1000 * 256;
    stage->instances[1].at_q8[2] = -2000 * 256;
    (void)draw(stage, method, 2);
    const struct lim_mover *movers = stage->lim.movers->movers;
    assert_in_range(movers[0].half_q12[2] + movers[1].half_q12[2], 262 * 4096, 262 * 4096 + 4); /* but for rounding */
    stage->instances[1].at_q8[2] = -1000 * 256 - (262 * 256 + 1) - gap_q8;
    if (swapped) {
        const struct lim_instance first = stage->instances[0];
        stage->instances[0] = stage->instances[1];
        stage->instances[1] = first;
    }
    const struct lim_stats *stats = draw(stage, method, 2);
    assert_int_equal(pixel_at(stage, 32, 32), 1);
    const uint32_t count = stats->movers.crowded;
    stage_free(stage);
    return count;
}

static void those_one_behind_the_other_are_not_compared(void **state)
{
    static struct stage stage;

    (void)state;
    for (int i = 0; i < ORDERS * 2; i++) {
        const enum lim_method method = orders[i / 2];
        for (int32_t gap_q8 = 1; gap_q8 < 1 << 16; gap_q8 *= 4)
            assert_int_equal(crowded(&stage, method, gap_q8, i & 1), 0);
        for (int32_t gap_q8 = 1; gap_q8 < 1 << 15; gap_q8 *= 4)
            assert_int_equal(crowded(&stage, method, -gap_q8, i & 1), 2);
        assert_int_equal(crowded(&stage, method, 0, i & 1), 0);
    }
}

/* One in front of another, beside it, and nothing: what moves is the scene. */
static void where_nothing_else_is_they_are_seen(void **state)
{
    static struct stage stage;

    (void)state;
    for (int i = 0; i < ORDERS; i++)
        for (uint16_t count = 0; count <= OBJECTS; count++) {
            stage_init(&stage);
            for (int k = 0; k < OBJECTS; k++)
                add_square(&stage.objects[k], (uint16_t)(k + 1), 8 + 8 * k, 8 + 4 * k, 40 + 8 * k, 40, 800 + 320 * k);
            (void)draw(&stage, orders[i], count);
            for (int y = 0; y < SET_SIDE_PX; y++)
                for (int x = 0; x < SET_SIDE_PX; x++) {
                    int nearest = 0;
                    for (int k = count - 1; k >= 0; k--)
                        if (x >= 8 + 8 * k && x < 40 + 8 * k && y >= 8 + 4 * k && y < 40) nearest = k + 1;
                    assert_int_equal(pixel_at(&stage, x, y), nearest);
                }
            stage_free(&stage);
        }
}

/* Nor does anything remain of it from the frame before. */
static void what_is_left_out_is_not_seen(void **state)
{
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (int i = 0; i < ORDERS; i++) {
        stage_init(&stage);
        add_square(&stage.objects[0], 7, 8, 8, 40, 40, 800);
        (void)draw(&stage, orders[i], 1);
        assert_int_equal(pixel_at(&stage, 20, 20), 7);
        stage.instances[0].finer_bits = 4; /* more than there are */
        assert_int_equal(lim_movers_frame(&stage.lim, &camera, stage.instances, 1), LIM_OK);
        assert_int_equal(lim_stats(&stage.lim)->movers.left_out, 1);
        for (int k = 0; k < SET_SIDE_PX * SET_SIDE_PX; k++)
            assert_int_equal(pixel_at(&stage, k % SET_SIDE_PX, k / SET_SIDE_PX), 0);
        stage_free(&stage);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_records_of_a_run_are_seen),
        cmocka_unit_test(where_nothing_else_is_they_are_seen),
        cmocka_unit_test(what_is_left_out_is_not_seen),
        cmocka_unit_test(those_one_behind_the_other_are_not_compared),
    };

    return cmocka_run_group_tests_name("mover_alone", tests, NULL, NULL);
}
