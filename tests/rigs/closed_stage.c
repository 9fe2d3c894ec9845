/* SPDX-License-Identifier: MIT */
#include "closed_stage.h"

#include "cmocka_ready.h"
#include "compiler/compile_mesh.h"

#include <string.h>

void closed_stage_make(struct closed_stage *stage, struct random *random)
{
    memset(stage, 0, sizeof *stage);
    closed_scene_make(&stage->closed, random);
}

void closed_stage_compile(struct closed_stage *stage, const struct compile_options *options, unsigned w_px,
                          unsigned h_px)
{
    struct error err;

    if (!mesh_clean(&stage->closed.model, &stage->mesh, &err) || !mesh_insert_t_vertices(&stage->mesh, &err) ||
        !compile_mesh(&stage->mesh, options, &stage->scene, &err) ||
        !lens_init(&stage->lens, 60, 0.1, w_px, h_px, &err))
        fail_msg("%s", err.text);
}

void closed_stage_close(struct closed_stage *stage)
{
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
    closed_scene_free(&stage->closed);
}

struct lim_camera closed_stage_camera(const struct closed_stage *stage, struct random *random)
{
    struct viewpoint viewpoint = closed_scene_viewpoint(&stage->closed, random);
    const struct camera_path path = {"random", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    assert_true(camera_path_to_camera(&path, 0, &stage->lens, &stage->scene.grid, &camera, &err));
    camera.roll = (uint32_t)random_u64(random);
    return camera;
}
