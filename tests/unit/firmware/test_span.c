/* SPDX-License-Identifier: MIT
 *
 * SPAN against a picture of booleans: what is open, which pieces come out, when the pool ends. */
#include "lines/span.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <string.h>

enum { W = 200, POOL = 100 };

struct fixture {
    struct lim_line line;
    LIM_ALIGNAS(4) struct lim_gap pool[POOL];
    struct lim_retained retained; /* nothing, in the same memory */
    struct lim_spans spans;
    bool open[W];
    bool fresh[W]; /* what the pieces of the last call covered */
    uint16_t last_end;
};

static const struct lim_target everything; /* is seen */

static void open_line(struct fixture *f, uint16_t pool_size)
{
    const struct lim_rect all = {0, 0, W, 1};

    memset(f, 0, sizeof *f);
    f->spans.lines = &f->line;
    f->spans.pool = f->pool;
    f->spans.pool_size = pool_size;
    f->spans.retained = &f->retained;
    f->retained.cells = (void *)f->pool;
    lim_spans_open(&f->spans, &everything, &all);
    for (int x = 0; x < W; x++)
        f->open[x] = true;
}

static void note_piece(void *ctx, uint16_t x0, uint16_t x1)
{
    struct fixture *f = ctx;

    assert_true(x0 < x1 && x1 <= W);
    assert_true(x0 >= f->last_end); /* left to right */
    f->last_end = x1;
    for (int x = x0; x < x1; x++)
        f->fresh[x] = true;
}

static enum lim_span_result close_and_compare(struct fixture *f, int16_t x0, int16_t x1)
{
    bool any = false;

    memset(f->fresh, 0, sizeof f->fresh);
    f->last_end = 0;
    const enum lim_span_result result = lim_span_close(&f->spans, &f->line, x0, x1, note_piece, f);
    if (result == LIM_SPAN_EXHAUSTED) return result;
    for (int x = 0; x < W; x++) {
        const bool expected = f->open[x] && x >= x0 && x < x1;
        assert_int_equal(f->fresh[x], expected);
        any |= expected;
        if (expected) f->open[x] = false;
    }
    assert_int_equal(result, any ? LIM_SPAN_SOME : LIM_SPAN_NOTHING);
    return result;
}

static void assert_gaps_are_what_is_open(const struct fixture *f)
{
    bool open[W] = {false};
    uint16_t end = 0;

    for (const struct lim_gap *gap = &f->line.gap;; gap = &f->pool[gap->next]) {
        for (int x = gap->x0; x < gap->x1; x++)
            open[x] = true;
        assert_true(gap->x0 >= end);
        end = gap->x1;
        if (gap->next == LIM_NONE) break;
        assert_true(gap->x0 < gap->x1); /* only a closed line's own gap may be empty */
    }
    assert_memory_equal(open, f->open, sizeof open);
}

static void random_intervals_agree_with_a_picture(void **state)
{
    struct random random = {5};

    (void)state;
    for (int round = 0; round < 3000; round++) {
        struct fixture f;
        open_line(&f, POOL);
        const int64_t longest = random_in(&random, 1, 80);
        for (int k = 0; k < 60; k++) {
            const int16_t x0 = (int16_t)random_in(&random, -60, W + 20);
            const int16_t x1 = (int16_t)(x0 + random_in(&random, 1, longest));
            assert_int_not_equal(close_and_compare(&f, x0, x1), LIM_SPAN_EXHAUSTED);
            assert_gaps_are_what_is_open(&f);
        }
        bool any = false;
        for (int x = 0; x < W; x++)
            any |= f.open[x];
        assert_int_equal(f.spans.open_lines, any);
    }
}

static void closing_everything_closes_the_line(void **state)
{
    struct fixture f;

    (void)state;
    open_line(&f, POOL);
    for (int16_t x = 10; x < W; x = (int16_t)(x + 20))
        close_and_compare(&f, x, (int16_t)(x + 5));
    assert_int_equal(close_and_compare(&f, -512, 1536), LIM_SPAN_SOME);
    assert_int_equal(f.spans.open_lines, 0);
    assert_int_equal(close_and_compare(&f, 0, W), LIM_SPAN_NOTHING);
}

static void gaps_that_were_given_back_are_used_again(void **state)
{
    struct fixture f;

    (void)state;
    open_line(&f, 2);
    close_and_compare(&f, 50, 60);
    close_and_compare(&f, 100, 110);
    assert_int_equal(close_and_compare(&f, 150, 160), LIM_SPAN_EXHAUSTED);
    assert_int_equal(close_and_compare(&f, 110, W), LIM_SPAN_SOME); /* the last gap goes */
    assert_int_equal(close_and_compare(&f, 20, 30), LIM_SPAN_SOME); /* and is used here */
    assert_gaps_are_what_is_open(&f);
}

static void an_empty_pool_still_cuts_ends(void **state)
{
    struct fixture f;

    (void)state;
    open_line(&f, 0);
    assert_int_equal(close_and_compare(&f, -5, 30), LIM_SPAN_SOME);
    assert_int_equal(close_and_compare(&f, 170, 300), LIM_SPAN_SOME);
    assert_int_equal(close_and_compare(&f, 80, 90), LIM_SPAN_EXHAUSTED);
    assert_int_equal(close_and_compare(&f, 30, 170), LIM_SPAN_SOME);
    assert_int_equal(f.spans.open_lines, 0);
}

static void the_open_rectangle_shrinks_to_what_is_open(void **state)
{
    struct lim_line lines[10];
    LIM_ALIGNAS(4) struct lim_gap pool[POOL];
    struct lim_retained retained = {.cells = (void *)pool};
    struct lim_spans spans = {.lines = lines, .pool = pool, .pool_size = POOL, .retained = &retained};
    const struct lim_rect all = {0, 0, W, 10};

    (void)state;
    lim_spans_open(&spans, &everything, &all);
    assert_false(lim_spans_shrink(&spans));
    for (int y = 0; y < 10; y++) {
        if (y < 3 || y == 9)
            lim_span_close(&spans, &lines[y], 0, W, NULL, NULL);
        else
            lim_span_close(&spans, &lines[y], -9, (int16_t)(40 + y), NULL, NULL);
    }
    lim_span_close(&spans, &lines[5], 100, 120, NULL, NULL);
    for (int y = 3; y < 9; y++)
        lim_span_close(&spans, &lines[y], (int16_t)(150 + y), 999, NULL, NULL);
    assert_true(lim_spans_shrink(&spans));
    assert_int_equal(spans.open.x0, 43);
    assert_int_equal(spans.open.x1, 158);
    assert_int_equal(spans.open.y0, 3);
    assert_int_equal(spans.open.y1, 9);
    assert_int_equal(spans.open_lines, 6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_intervals_agree_with_a_picture),
        cmocka_unit_test(closing_everything_closes_the_line),
        cmocka_unit_test(gaps_that_were_given_back_are_used_again),
        cmocka_unit_test(an_empty_pool_still_cuts_ends),
        cmocka_unit_test(the_open_rectangle_shrinks_to_what_is_open),
    };

    return cmocka_run_group_tests_name("span", tests, NULL, NULL);
}
