/* SPDX-License-Identifier: MIT
 *
 * Extremes of scale: scenes whose smallest things are millionths of the whole, which have coordinates of 32 bits. */
#include "extreme.h"
#include "rigs/cmocka_ready.h"
#include "scales_models.h"

enum { SCALES_FRAMES = 100, SCALES_PX = 160 };

static const struct scales *shown; /* what look() looks at: plans have no place for it */

static void look_at_shown(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    shown->look(random, eye_m, target_m);
    extreme_frame(extreme, eye_m, target_m);
}

static void scenes_of_a_scale(void **state)
{
    shown = *state;
    const struct extreme_plan plan = {.name = shown->name,
                                      .about = shown->about,
                                      .picture = {SCALES_PX, SCALES_PX, 60, shown->near_m},
                                      .build = shown->build,
                                      .look = look_at_shown,
                                      .frames = SCALES_FRAMES,
                                      .order = true};

    extreme_run_long(&plan);
}

int main(void)
{
    struct CMUnitTest tests[SCALES_COUNT];

    for (int k = 0; k < SCALES_COUNT; k++) {
        void *const scales = (void *)(uintptr_t)&scales_all[k];
        tests[k] = (struct CMUnitTest)cmocka_unit_test_prestate(scenes_of_a_scale, scales);
        tests[k].name = scales_all[k].name;
    }
    return cmocka_run_group_tests_name("extremes of scale", tests, NULL, NULL);
}
