/* SPDX-License-Identifier: MIT
 *
 * Which of several animations of one node counts. */
#include "readers/node_motion.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

static struct aiNode node;
static struct node_motions motions;

static int begin(void **state)
{
    (void)state;
    motions = (struct node_motions){0};
    strcpy(node.mName.data, "box");
    node.mName.length = 3;
    return 0;
}

static int end(void **state)
{
    (void)state;
    node_motions_free(&motions);
    return 0;
}

/* Two keys, a second apart, from 0 to `to` along x. */
static void take(enum node_part part, double to, const char *animation)
{
    struct track track = track_make(2, part == PART_TURN ? 4 : 3, TRACK_LINEAR);
    for (size_t k = 0; k < 2; k++) {
        memset(track_key(&track, k), 0, track.width * sizeof *track.values);
        track.times_s[k] = (double)k;
        track_key(&track, k)[0] = k ? to : 0;
    }
    node_motion_take(&motions, node_motions_make(&motions, &node), part, &track, animation);
}

static double end_of(enum node_part part)
{
    const struct track *track = &node_motions_of(&motions, &node)->tracks[part];
    return track->count ? track_key(track, track->count - 1)[0] : -1;
}

static void still_parts_are_not_mixed_with_others(void **state)
{
    (void)state;
    take(PART_AT, 0, "first");
    take(PART_TURN, 0.5, "first");
    node_motions_settle(&motions);
    take(PART_AT, 3, "second");
    take(PART_TURN, 0, "second");
    node_motions_settle(&motions);
    assert_true(end_of(PART_AT) == 0 && end_of(PART_TURN) == 0.5);
    assert_true(node_motions_of(&motions, &node)->is_twice);
}

static void what_moves_counts_before_what_does_not(void **state)
{
    (void)state;
    take(PART_AT, 0, "first");
    node_motions_settle(&motions);
    take(PART_AT, 3, "second");
    node_motions_settle(&motions);
    assert_true(end_of(PART_AT) == 3);
    assert_false(node_motions_of(&motions, &node)->is_twice);
}

static void an_animation_of_its_own_name_counts_first(void **state)
{
    (void)state;
    take(PART_AT, 1, "box|ballAction");
    node_motions_settle(&motions);
    take(PART_AT, 3, "box|boxAction");
    node_motions_settle(&motions);
    take(PART_AT, 5, "ball|boxAction");
    node_motions_settle(&motions);
    assert_true(end_of(PART_AT) == 3);
}

/* An object "box" beside one "box2"; and an animation of its own that moves nothing. */
static void a_name_is_whole_and_of_one_animation(void **state)
{
    (void)state;
    take(PART_AT, 1, "box|box2Action");
    node_motions_settle(&motions);
    take(PART_AT, 0, "box|boxAction");
    node_motions_settle(&motions);
    node_motions_settle(&motions); /* an animation of others */
    assert_true(end_of(PART_AT) == 1);
    take(PART_AT, 3, "box|boxAction.001");
    node_motions_settle(&motions);
    assert_true(end_of(PART_AT) == 3);
}

static void what_one_says_nothing_of_is_the_other_s(void **state)
{
    (void)state;
    take(PART_AT, 3, "first");
    node_motions_settle(&motions);
    take(PART_TURN, 0.5, "second");
    node_motions_settle(&motions);
    assert_true(end_of(PART_AT) == 3 && end_of(PART_TURN) == 0.5);
    assert_false(node_motions_of(&motions, &node)->is_twice);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(still_parts_are_not_mixed_with_others, begin, end),
        cmocka_unit_test_setup_teardown(what_moves_counts_before_what_does_not, begin, end),
        cmocka_unit_test_setup_teardown(an_animation_of_its_own_name_counts_first, begin, end),
        cmocka_unit_test_setup_teardown(a_name_is_whole_and_of_one_animation, begin, end),
        cmocka_unit_test_setup_teardown(what_one_says_nothing_of_is_the_other_s, begin, end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
