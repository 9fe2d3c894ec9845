/* SPDX-License-Identifier: MIT
 *
 * Any valid scene of many scales under any legal camera, in every profile, method that walks a tree and size of memory.
 */
#include "fuzz_frame.h"
#include "fuzz_scene.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

/* With what eye_q8 may add, below LIM_LONG_EYE_END. */
#define ORIGIN_END (LIM_LONG_EYE_END - (INT32_C(1) << 20) - 1)

/* Near one of the vertices, or anywhere. */
static void move_origin(struct lim_camera *camera, const struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    const bool is_near = fuzz_below(bytes, 4);
    const lim_index vertex = fuzz_below(bytes, made->scene.vertex_count);

    for (int i = 0; i < 3; i++) {
        const int32_t away = (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);
        const int64_t at = is_near ? (int64_t)made->long_vertices[vertex].at[i] + away : away;
        camera->origin[i] = (int32_t)(at < -ORIGIN_END ? -ORIGIN_END : at > ORIGIN_END ? ORIGIN_END : at);
    }
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_frame frame = {.is_ordered = true};
    struct fuzz_scene made;
    struct error err;

    const uint8_t choice = fuzz_u8(&bytes);
    frame.w_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.h_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.camera = fuzz_legal_camera(&bytes);
    fuzz_scene_make_long(&made, &bytes);
    move_origin(&frame.camera, &made, &bytes);
    frame.scene = &made.scene;
    if (!lim_check(frame.scene, &err)) return "a valid scene was refused";
    return fuzz_draw(&frame, choice);
}

const struct fuzz_target fuzz_long = {"long", run, NULL};
