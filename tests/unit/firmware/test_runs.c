/* SPDX-License-Identifier: MIT
 *
 * Lines as runs against lines as pixels: frame after frame of random lines through rings of any size, noted in any
 * order or looked at; what is said to have changed is what has, and what is painted from runs is the line. */
#include "pixels/runs.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <string.h>

enum { W = 97, H = 13, RING = 600 };

struct fixture {
    struct lim_runs runs;
    uint32_t line[W], ring[RING];
    uint16_t first[H + 1];
    uint32_t shown[H][W]; /* each pixel's look in the last frame */
    bool known[H];
};

static void begin(struct fixture *f, uint16_t size)
{
    memset(f, 0, sizeof *f);
    f->runs =
        (struct lim_runs){.line = f->line, .ring = f->ring, .size = size, .first = f->first, .w_px = W, .h_px = H};
    lim_runs_forget(&f->runs);
}

/* Few colours, so that neighbours are often the same; some pieces have a texture. */
static void draw_line(struct random *random, uint32_t looks[W])
{
    uint32_t x = 0;

    while (x < W) {
        const uint32_t n = (uint32_t)random_in(random, 1, 20);
        const uint32_t look = (uint32_t)random_in(random, 0, 3) | (random_in(random, 0, 5) == 0 ? LIM_RUN_TEXTURED : 0);
        for (uint32_t i = 0; i < n && x < W; i++)
            looks[x++] = look;
    }
}

/* As they come: from the right, say, cut anywhere. */
static void note(struct fixture *f, struct random *random, const uint32_t looks[W])
{
    for (uint32_t x1 = W; x1 > 0;) {
        uint32_t x0 = x1 - 1;
        while (x0 > 0 && looks[x0 - 1] == looks[x1 - 1] && random_in(random, 0, 4))
            x0--;
        lim_runs_note(&f->runs, (uint16_t)x0, (uint16_t)x1, looks[x0]);
        x1 = x0;
    }
}

static void assert_changes(const struct fixture *f, uint16_t y, const uint32_t looks[W], bool still)
{
    struct lim_changes changes = lim_runs_compare(&f->runs, y, still);
    bool changed[W] = {false};
    uint16_t x0, x1, last = 0;

    while (lim_changes_next(&changes, &x0, &x1)) {
        assert_true((x0 > last || last == 0) && x0 < x1 && x1 <= W);
        memset(changed + x0, true, (size_t)(x1 - x0));
        last = x1;
    }
    for (uint32_t x = 0; x < W; x++)
        assert_int_equal(changed[x], looks[x] != f->shown[y][x] || (looks[x] & LIM_RUN_TEXTURED && !still));
}

static void assert_painted(const struct fixture *f, struct random *random, uint16_t y, const uint32_t looks[W])
{
    const uint16_t x0 = (uint16_t)random_in(random, 0, W - 1), x1 = (uint16_t)random_in(random, x0 + 1, W);
    _Alignas(4) uint16_t kept[W + 1], noted[W + 1];

    memset(kept, 0xEE, sizeof kept);
    memset(noted, 0xEE, sizeof noted);
    lim_runs_paint(&f->runs, y, kept, x0, x1);
    lim_runs_paint_noted(&f->runs, noted, x0, x1);
    for (uint32_t x = 0; x <= W; x++) {
        assert_int_equal(kept[x], x >= x0 && x < x1 ? (uint16_t)looks[x] : 0xEEEE);
        assert_int_equal(noted[x], kept[x]);
    }
}

static unsigned count_of(const uint32_t looks[W])
{
    unsigned count = 1;

    for (uint32_t x = 1; x < W; x++)
        count += looks[x] != looks[x - 1];
    return count;
}

/* Returns how many of its lines were lost. */
static unsigned frame(struct fixture *f, struct random *random, int same_in_ten)
{
    const bool still = random_in(random, 0, 1);
    unsigned lost = 0;

    for (uint16_t y = 0; y < H; y++) {
        uint32_t looks[W];
        draw_line(random, looks);
        if (random_in(random, 0, 9) < same_in_ten) memcpy(looks, f->shown[y], sizeof looks);
        bool textured = false;
        for (uint32_t x = 0; x < W; x++)
            textured |= (looks[x] & LIM_RUN_TEXTURED) != 0;
        const bool known = lim_runs_begin(&f->runs, y);
        assert_int_equal(known, f->known[y]);
        const unsigned room = f->runs.size - 1u - lim_runs_used(&f->runs);
        note(f, random, looks);
        const enum lim_runs_kept kept = lim_runs_keep(&f->runs, y);
        assert_int_equal(kept, count_of(looks) > room ? LIM_RUNS_LOST : textured ? LIM_RUNS_TEXTURED : LIM_RUNS_KEPT);
        f->known[y] = kept != LIM_RUNS_LOST;
        if (known && f->known[y]) assert_changes(f, y, looks, still);
        if (f->known[y]) assert_painted(f, random, y, looks);
        memcpy(f->shown[y], looks, sizeof looks);
        lost += !f->known[y];
    }
    return lost;
}

static void changes_are_those_of_the_pixels(void **state)
{
    static struct fixture f;
    struct random random = {5};

    (void)state;
    begin(&f, RING);
    for (int i = 0; i < 500; i++)
        assert_int_equal(frame(&f, &random, i % 10), 0);
}

static void rings_of_any_size_lose_lines_and_nothing_else(void **state)
{
    static struct fixture f;
    struct random random = {6};
    unsigned lost = 0;

    (void)state;
    for (uint16_t size = 1; size < 250; size++) {
        begin(&f, size);
        for (int i = 0; i < 12; i++)
            lost += frame(&f, &random, 3);
    }
    assert_true(lost > 1000);
}

static void lost_and_forgotten_lines_are_unknown(void **state)
{
    static struct fixture f;
    struct random random = {7};

    (void)state;
    begin(&f, RING);
    frame(&f, &random, 0);
    for (uint16_t y = 0; y < H; y++) {
        uint32_t looks[W];
        draw_line(&random, looks);
        assert_true(lim_runs_begin(&f.runs, y));
        note(&f, &random, looks);
        if (y % 3 == 0) lim_runs_lose(&f.runs, y);
        if (y % 3) assert_int_not_equal(lim_runs_keep(&f.runs, y), LIM_RUNS_LOST);
        memcpy(f.shown[y], looks, sizeof looks);
        f.known[y] = y % 3;
    }
    frame(&f, &random, 5);
    lim_runs_forget(&f.runs);
    memset(f.known, false, sizeof f.known);
    frame(&f, &random, 5);
    frame(&f, &random, 5);
}

static void a_line_that_was_painted_is_looked_at(void **state)
{
    static struct fixture f;
    struct random random = {8};

    (void)state;
    begin(&f, RING);
    for (int round = 0; round < 200; round++) {
        const uint16_t x0 = (uint16_t)random_in(&random, 0, W - 1), x1 = (uint16_t)random_in(&random, x0 + 1, W);
        _Alignas(4) uint16_t line[W + 1], painted[W + 1];
        uint32_t looks[W];
        draw_line(&random, looks);
        for (uint32_t x = 0; x < W; x++)
            line[x] = (uint16_t)looks[x];
        lim_runs_scan(&f.runs, line, x0, x1);
        if (x0 > 0) lim_runs_note(&f.runs, 0, x0, LIM_RUN_UNSEEN);
        if (x1 < W) lim_runs_note(&f.runs, x1, W, LIM_RUN_UNSEEN);
        assert_int_equal(lim_runs_begin(&f.runs, 0), round > 0);
        assert_int_equal(lim_runs_keep(&f.runs, 0), LIM_RUNS_KEPT);
        lim_runs_paint(&f.runs, 0, painted, 0, W);
        for (uint32_t x = 0; x < W; x++)
            assert_int_equal(painted[x], x < x0 || x >= x1 ? 0 : line[x]);
        for (uint16_t y = 1; y < H; y++) {
            (void)lim_runs_begin(&f.runs, y);
            lim_runs_lose(&f.runs, y);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_are_those_of_the_pixels),
        cmocka_unit_test(rings_of_any_size_lose_lines_and_nothing_else),
        cmocka_unit_test(lost_and_forgotten_lines_are_unknown),
        cmocka_unit_test(a_line_that_was_painted_is_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
