/* SPDX-License-Identifier: MIT
 *
 * Rectangles round what changed: every changed pixel is in one, none costs more than what it holds would have cost
 * apart, and which are put together goes by what a window costs. */
#include "pixels/rects.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <string.h>

enum { W = 120, H = 80 };

static struct lim_rects list_for(uint32_t window_px)
{
    return (struct lim_rects){.window_px = window_px};
}

static bool add(struct lim_rects *rects, unsigned x0, unsigned y, unsigned x1)
{
    return lim_rects_add(rects, &(struct lim_rect){(uint16_t)x0, (uint16_t)y, (uint16_t)x1, (uint16_t)(y + 1)});
}

static void assert_rect(const struct lim_rects *rects, uint16_t i, unsigned x0, unsigned y0, unsigned x1, unsigned y1)
{
    const struct lim_rect *rect = &rects->rect[i];

    assert_true(i < rects->count);
    assert_int_equal(rect->x0, x0);
    assert_int_equal(rect->y0, y0);
    assert_int_equal(rect->x1, x1);
    assert_int_equal(rect->y1, y1);
}

static void stretches_one_below_the_other_are_one_rectangle(void **state)
{
    struct lim_rects rects = list_for(5);

    (void)state;
    for (unsigned y = 10; y < 30; y++)
        assert_true(add(&rects, 7, y, 9));
    assert_int_equal(rects.count, 1);
    assert_rect(&rects, 0, 7, 10, 9, 30);
}

/* Two pixels, three pixels apart: together they take 3 pixels more, which is less than a window of 4 and not of 3. */
static void neighbours_are_joined_where_a_window_costs_more_than_the_gap(void **state)
{
    (void)state;
    for (uint32_t window_px = 1; window_px <= 8; window_px++) {
        struct lim_rects rects = list_for(window_px);
        assert_true(add(&rects, 10, 0, 11) && add(&rects, 14, 0, 15));
        assert_int_equal(rects.count, window_px > 3 ? 1 : 2);
    }
}

static void a_rectangle_does_not_grow_over_a_gap_that_costs_a_window(void **state)
{
    struct lim_rects near = list_for(20), far = list_for(20);

    (void)state;
    assert_true(add(&near, 0, 0, 5) && add(&near, 0, 4, 5)); /* 3 lines of 5 between */
    assert_int_equal(near.count, 1);
    assert_true(add(&far, 0, 0, 5) && add(&far, 0, 5, 5)); /* 4 of them */
    assert_int_equal(far.count, 2);
}

static void a_full_list_takes_what_another_rectangle_can_hold(void **state)
{
    struct lim_rects rects = list_for(1);

    (void)state;
    for (unsigned i = 0; i < LIM_DELTA_RECTS; i++)
        assert_true(add(&rects, 4 * i, 0, 4 * i + 1));
    assert_int_equal(rects.count, LIM_DELTA_RECTS);
    assert_true(add(&rects, 4, 1, 5));
    assert_false(add(&rects, 500, 1, 501));
    assert_int_equal(rects.count, LIM_DELTA_RECTS);
    lim_rects_clear(&rects);
    assert_true(add(&rects, 500, 1, 501));
    assert_rect(&rects, 0, 500, 1, 501, 2);
}

/* Two that have grown towards each other. */
static void rectangles_that_meet_are_joined_at_the_end(void **state)
{
    struct lim_rects rects = list_for(6);

    (void)state;
    assert_true(add(&rects, 0, 0, 8) && add(&rects, 20, 0, 28));
    assert_true(add(&rects, 0, 1, 13) && add(&rects, 15, 1, 28));
    assert_int_equal(rects.count, 2);
    lim_rects_join(&rects);
    assert_int_equal(rects.count, 1);
    assert_rect(&rects, 0, 0, 0, 28, 2);
}

struct frame {
    bool changed[H][W], sent[H][W];
    unsigned long stretches, stretch_px, rects, rect_px;
};

static void send(struct frame *frame, struct lim_rects *rects)
{
    lim_rects_join(rects);
    for (uint16_t i = 0; i < rects->count; i++) {
        const struct lim_rect *rect = &rects->rect[i];
        assert_true(rect->x0 < rect->x1 && rect->x1 <= W && rect->y0 < rect->y1 && rect->y1 <= H);
        for (unsigned y = rect->y0; y < rect->y1; y++)
            memset(&frame->sent[y][rect->x0], true, (size_t)(rect->x1 - rect->x0));
        frame->rects++;
        frame->rect_px += (unsigned long)(rect->x1 - rect->x0) * (unsigned long)(rect->y1 - rect->y0);
    }
    lim_rects_clear(rects);
}

static void take(struct frame *frame, struct lim_rects *rects, unsigned x0, unsigned y, unsigned x1)
{
    memset(&frame->changed[y][x0], true, x1 - x0);
    frame->stretches++;
    frame->stretch_px += x1 - x0;
    if (add(rects, x0, y, x1)) return;
    send(frame, rects);
    assert_true(add(rects, x0, y, x1));
}

/* Slanted edges that wander, as a turned picture's do. */
static void random_changes_are_all_sent_and_never_dearer_than_apart(void **state)
{
    static struct frame frame;
    struct random random = {77};

    (void)state;
    for (int round = 0; round < 200; round++) {
        const uint32_t window_px = (uint32_t)random_in(&random, 1, 60);
        struct lim_rects rects = list_for(window_px);
        unsigned at[8];
        memset(&frame, 0, sizeof frame);
        for (int i = 0; i < 8; i++)
            at[i] = (unsigned)random_in(&random, 0, 13);
        for (unsigned y = 0; y < H; y++) {
            for (unsigned i = 0; i < 8; i++) {
                if (random_in(&random, 0, 9) == 0) at[i] = (unsigned)random_in(&random, 0, 10);
                if (at[i] < 9) take(&frame, &rects, 15 * i + at[i], y, 15 * i + at[i] + 1 + at[i] % 5);
            }
        }
        send(&frame, &rects);
        for (unsigned y = 0; y < H; y++)
            for (unsigned x = 0; x < W; x++)
                assert_true(frame.sent[y][x] || !frame.changed[y][x]);
        assert_true(frame.rects * window_px + frame.rect_px <= frame.stretches * window_px + frame.stretch_px);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stretches_one_below_the_other_are_one_rectangle),
        cmocka_unit_test(neighbours_are_joined_where_a_window_costs_more_than_the_gap),
        cmocka_unit_test(a_rectangle_does_not_grow_over_a_gap_that_costs_a_window),
        cmocka_unit_test(a_full_list_takes_what_another_rectangle_can_hold),
        cmocka_unit_test(rectangles_that_meet_are_joined_at_the_end),
        cmocka_unit_test(random_changes_are_all_sent_and_never_dearer_than_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
