/* SPDX-License-Identifier: MIT
 *
 * Any valid scene of many scales under any legal camera, in every profile, method that walks a tree and size of memory.
 */
#include "fuzz_frame.h"
#include "fuzz_scene.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

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
    fuzz_view_move_origin(&frame.camera, &made, &bytes);
    frame.scene = &made.scene;
    if (!lim_check(frame.scene, &err)) return "a valid scene was refused";
    return fuzz_draw(&frame, choice);
}

const struct fuzz_target fuzz_long = {"long", run, NULL};
