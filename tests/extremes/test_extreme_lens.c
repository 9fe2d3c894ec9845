/* SPDX-License-Identifier: MIT
 *
 * Extremes of the lens and of the display: fields of view from 5 to 150 degrees, pictures from a pixel to
 * 1024x600 of them. */
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>

static void look_from_anywhere(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    boxes_random_point(random, BOXES_END_M, 1.0 / 256, eye_m);
    boxes_random_point(random, BOXES_END_M, 1, target_m);
    extreme_frame(extreme, eye_m, target_m);
}

static void every_field_of_view_from_5_to_150_degrees(void **state)
{
    static const int fov_deg[] = {5, 10, 22, 45, 60, 90, 120, 150};
    char name[32], about[64];

    (void)state;
    for (size_t i = 0; i < sizeof fov_deg / sizeof *fov_deg; i++) {
        const struct extreme_plan plan = {name, about, {120, 120, fov_deg[i], 4}, boxes_add_jumble, look_from_anywhere,
                                          100,  true};
        snprintf(name, sizeof name, "fov-%d", fov_deg[i]);
        snprintf(about, sizeof about, "The lens sees %d degrees from top to bottom", fov_deg[i]);
        extreme_run(&plan);
    }
}

static void every_display_from_a_pixel_to_1024x600(void **state)
{
    static const unsigned sizes_px[][2] = {{1, 1}, {8, 8}, {84, 48}, {320, 480}, {480, 320}, {1024, 600}};
    char name[32], about[64];

    (void)state;
    for (size_t i = 0; i < sizeof sizes_px / sizeof *sizes_px; i++) {
        const unsigned w_px = sizes_px[i][0], h_px = sizes_px[i][1];
        const int frames = w_px * h_px < 10000 ? 400 : w_px * h_px < 200000 ? 15 : 5;
        const struct extreme_plan plan = {name,   about, {w_px, h_px, 60, 4}, boxes_add_jumble, look_from_anywhere,
                                          frames, true};
        snprintf(name, sizeof name, "display-%ux%u", w_px, h_px);
        snprintf(about, sizeof about, "The display has %u x %u pixels", w_px, h_px);
        extreme_run(&plan);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_field_of_view_from_5_to_150_degrees),
        cmocka_unit_test(every_display_from_a_pixel_to_1024x600),
    };

    return cmocka_run_group_tests_name("extremes of lens and display", tests, NULL, NULL);
}
