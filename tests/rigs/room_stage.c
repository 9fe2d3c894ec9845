/* SPDX-License-Identifier: MIT */
#include "room_stage.h"

#include "cmocka_ready.h"
#include "compiler/compile.h"

#include <stdlib.h>

int room_stage_set_up(void **state, uint32_t seed)
{
    struct room_stage *stage = calloc(1, sizeof *stage);

    stage->random.state = seed;
    room_scene_random(&stage->room, &stage->random);
    assert_true(room_scene_compile(&stage->room, PORTALS_OFF, NULL, &stage->scene, NULL));
    *state = stage;
    return 0;
}

int room_stage_tear_down(void **state)
{
    struct room_stage *stage = *state;

    compiled_free(&stage->scene);
    room_scene_free(&stage->room);
    free(stage);
    return 0;
}

struct lim_camera room_stage_view(struct room_stage *stage, unsigned w_px, unsigned h_px)
{
    struct viewpoint viewpoint = room_scene_view(&stage->room, &stage->random);
    const struct camera_path path = {"views", &viewpoint, 1};
    struct lim_camera camera;
    struct lens lens;
    struct error err;

    assert_true(lens_init(&lens, 60, 0.05, w_px, h_px, &err));
    assert_true(camera_path_to_camera(&path, 0, &lens, &stage->scene.grid, &camera, &err));
    return camera;
}
