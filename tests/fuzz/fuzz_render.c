/* SPDX-License-Identifier: MIT
 *
 * Any valid scene under any legal camera, in every profile, method and size of memory. That of fuzz_long has many
 * scales, and methods that walk a tree draw it. */
#include "fuzz_frame.h"
#include "fuzz_scene.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

static const char *draw(const uint8_t *input, size_t size_b, bool is_long)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_frame frame = {.is_ordered = true};
    struct fuzz_scene made;
    struct error err;

    const uint8_t choice = fuzz_u8(&bytes);
    frame.w_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.h_px = (uint16_t)(1 + fuzz_below(&bytes, FUZZ_SIDE_MAX_PX));
    frame.camera = fuzz_legal_camera(&bytes);
    if (is_long) {
        fuzz_scene_make_long(&made, &bytes);
        fuzz_view_move_origin(&frame.camera, &made, &bytes);
    } else {
        fuzz_scene_make(&made, &bytes);
    }
    frame.scene = &made.scene;
    if (!lim_check(frame.scene, &err)) return "a valid scene was refused";
    return fuzz_draw(&frame, choice);
}

static const char *run(const uint8_t *input, size_t size_b)
{
    return draw(input, size_b, false);
}

static const char *run_long(const uint8_t *input, size_t size_b)
{
    return draw(input, size_b, true);
}

const struct fuzz_target fuzz_render = {"render", run, NULL};
const struct fuzz_target fuzz_long = {"long", run_long, NULL};
