/* SPDX-License-Identifier: MIT
 *
 * No ray gets through a closed scene: 10^8 pixels of random ones in every profile. */
#include "rigs/closed_run.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

static void random_closed_scenes_have_no_holes(void **state)
{
    const struct closed_run_plan plan = {.seed = 20262, .scenes = effort(44), .frames = 40, .side_px = 240};
    struct closed_run_sum sums[PROFILES_MAX];
    const size_t count = closed_run(&plan, sums);

    (void)state;
    closed_run_judge(sums, count,
                     (size_t)plan.scenes * (size_t)plan.frames * plan.side_px * plan.side_px); /* 1.01 * 10^8 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_closed_scenes_have_no_holes)};

    return cmocka_run_group_tests_name("closed scenes", tests, NULL, NULL);
}
