/* SPDX-License-Identifier: MIT
 *
 * The same for 10^9 pixels in every profile, other scenes, larger pictures. */
#include "rigs/closed_run.h"
#include "rigs/cmocka_ready.h"

static void many_more_closed_scenes_have_no_holes(void **state)
{
    const struct closed_run_plan plan = {.seed = 31337, .scenes = 220, .frames = 20, .side_px = 480};
    struct closed_run_sum sums[PROFILES_MAX];
    const size_t count = closed_run(&plan, sums);

    (void)state;
    closed_run_judge(sums, count, 1000000000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(many_more_closed_scenes_have_no_holes)};

    return cmocka_run_group_tests_name("soak of closed scenes", tests, NULL, NULL);
}
