/* SPDX-License-Identifier: MIT
 *
 * Sampled cameras, on which pools are measured: of a map none stands outside of its sectors, where nobody is meant to
 * be and all rooms are seen at once through their backs. */
#include "cameras/sample.h"
#include "compiler/compile.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "unit/levels/level_rig.h"

#include <math.h>

enum { ROOM = 128, APART = 2000 };

static bool is_in_a_room(const double eye_m[3])
{
    const double x = eye_m[0] * 32, y = -eye_m[2] * 32, height = eye_m[1] * 32;
    const double left = x < APART / 2 ? 0 : APART;
    return x > left && x < left + ROOM && y > left && y < left + ROOM && height > 0 && height < ROOM;
}

/* The rooms are a thousandth of the bounds. */
static void sampled_eyes_are_within_rooms_that_are_small_and_far_apart(void **state)
{
    (void)state;
    const unsigned sector = wad_sector(&level_map, 0, ROOM, 255, "FLOOR", "CEIL");
    wad_room(&level_map, 0, 0, ROOM, sector);
    wad_room(&level_map, APART, APART, ROOM, sector);
    level_save("MAP01");
    struct compiled scene;
    struct sampler sampler;
    struct error err;
    if (!compile_model("a.wad:MAP01", &(struct compile_options){.tolerance_units = 0.5, .splitter = "auto"}, &scene,
                       &err))
        fail_msg("%s", err.text);
    sampler_init(&sampler, &scene);
    size_t sides[2] = {0};
    for (int i = 0; i < effort(200); i++) {
        const struct viewpoint viewpoint = sampler_next(&sampler);
        if (!is_in_a_room(viewpoint.eye_m))
            fail_msg("%g %g %g", viewpoint.eye_m[0], viewpoint.eye_m[1], viewpoint.eye_m[2]);
        sides[viewpoint.eye_m[0] * 32 > APART / 2]++;
    }
    assert_true(sides[0] && sides[1]);
    compiled_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(sampled_eyes_are_within_rooms_that_are_small_and_far_apart, level_begin),
    };
    return cmocka_run_group_tests(tests, level_enter, level_leave);
}
