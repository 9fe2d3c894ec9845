/* SPDX-License-Identifier: MIT
 *
 * What cuts leave of a run, against a bitmap of the same: pieces are the pixels that no cut has, from left to right,
 * each as long as it can be, none empty. Of a list up to one of its cuts those before it count, and no others. */
#include "lines/crowd.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <string.h>

enum { ROUNDS = 300000, SIDE_PX = 64, CUTS = 6 };

/* One after another in any order, some of them side by side, one in another, or all of the run. */
static int any_cuts(struct lim_crowd_cut cuts[CUTS], struct random *random)
{
    const int count = (int)random_in(random, 0, CUTS);
    const int64_t most = INT64_C(1) << random_in(random, 0, 6);

    for (int k = 0; k < count; k++) {
        const int16_t from =
            k && random_in(random, 0, 2) == 0 ? cuts[k - 1].x1 : (int16_t)random_in(random, 0, SIDE_PX - 1);
        cuts[k].x0 = from < SIDE_PX ? from : 0;
        cuts[k].x1 = (int16_t)(cuts[k].x0 + random_in(random, 1, most));
        if (cuts[k].x1 > SIDE_PX) cuts[k].x1 = SIDE_PX;
        cuts[k].by = NULL;
        cuts[k].next = k + 1 < count ? &cuts[k + 1] : NULL;
    }
    return count;
}

/* The pieces of the pixels x0 <= x < x1, of which the map has those that no cut has, and takes them. */
static void take_pieces(const struct lim_crowd_cut *cuts, const struct lim_crowd_cut *last, int32_t x0, int32_t x1,
                        bool open[SIDE_PX], size_t *pieces)
{
    int32_t end = x0, to;

    for (int32_t x = x0; lim_crowd_next(cuts, last, &x, x1, &to); x = to) {
        assert_true((x > end || x == x0) && x < to && to <= x1);
        assert_true(to == x1 || !open[to]);
        for (int32_t px = end; px < x; px++)
            assert_false(open[px]);
        for (int32_t px = x; px < to; px++) {
            assert_true(open[px]);
            open[px] = false;
        }
        ++*pieces;
        end = to;
    }
}

static size_t compare(struct random *random, bool has_last)
{
    struct lim_crowd_cut cuts[CUTS];
    bool open[SIDE_PX];
    size_t pieces = 0;
    const int count = any_cuts(cuts, random);
    const int until = has_last && count ? (int)random_in(random, 0, count - 1) : count;
    const int32_t x0 = (int32_t)random_in(random, 0, SIDE_PX), x1 = (int32_t)random_in(random, x0, SIDE_PX);

    for (int px = 0; px < SIDE_PX; px++) {
        open[px] = px >= x0 && px < x1;
        for (int k = 0; k < until; k++)
            open[px] &= px < cuts[k].x0 || px >= cuts[k].x1;
    }
    take_pieces(count ? cuts : NULL, until < count ? &cuts[until] : NULL, x0, x1, open, &pieces);
    for (int px = 0; px < SIDE_PX; px++)
        assert_false(open[px]);
    return pieces;
}

static void pieces_are_what_no_cut_has(void **state)
{
    struct random random = {911};
    size_t found[4] = {0};

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        const size_t pieces = compare(&random, false);
        found[pieces < 3 ? pieces : 3]++;
    }
    print_message("# runs of no piece %zu, of one %zu, two %zu, more %zu\n", found[0], found[1], found[2], found[3]);
    for (int k = 0; k < 4; k++)
        assert_true(found[k] > ROUNDS / 50);
}

static void cuts_count_up_to_the_last(void **state)
{
    struct random random = {912};
    size_t pieces = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++)
        pieces += compare(&random, true);
    assert_true(pieces > ROUNDS / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_are_what_no_cut_has),
        cmocka_unit_test(cuts_count_up_to_the_last),
    };

    return cmocka_run_group_tests_name("crowd_cuts", tests, NULL, NULL);
}
