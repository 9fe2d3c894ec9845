/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a camera file: refused in one line that begins with the file's name, or read; and
 * what is read makes cameras that the renderer takes, or is refused line by line. */
#include "cameras/camera_path.h"
#include "fuzz_frame.h"
#include "fuzz_room.h"

/* Any numbers as a lens: refused in a line, or within the renderer's range. */
static const char *check_lens(const struct viewpoint *numbers)
{
    const double fov_deg = numbers->eye_m[0], near_m = numbers->eye_m[1];
    struct error err;
    struct lens lens;

    if (!lens_init(&lens, fov_deg, near_m, 16, 9, &err)) return fuzz_check_refusal(err.text, "--");
    const bool ok = lens.tan_x >= 1.0 / 2048 && lens.tan_x <= 4 && lens.tan_y >= 1.0 / 2048 && lens.tan_y <= 4;
    return ok && near_m > 0 ? NULL : "a lens out of range was taken";
}

static const char *check_few(const struct camera_path *path)
{
    struct camera_path few;
    struct error err;

    if (!camera_path_few(path, 3, &few, &err)) return "a short path cannot be made shorter";
    const bool ok = few.count == (path->count < 3 ? path->count : 3) && few.frames[0].line == path->frames[0].line;
    camera_path_free(&few);
    return ok ? NULL : "a few cameras are others";
}

static const char *check_frames(const struct camera_path *path)
{
    const struct compiled *room = fuzz_room();
    struct fuzz_frame frame = {.scene = &room->scene, .w_px = 2, .h_px = 1, .is_ordered = true};
    struct error err;
    struct lens lens;

    if (path->count == 0) return "a path without a camera";
    if (!lens_init(&lens, 60.0, 0.1, frame.w_px, frame.h_px, &err)) return "the lens was refused";
    for (size_t i = 0; i < path->count; i++) {
        if (!camera_path_to_camera(path, i, &lens, &room->grid, &frame.camera, &err)) {
            const char *broken = fuzz_check_refusal(err.text, NULL);
            if (broken) return broken;
        } else if (!fuzz_camera_is_legal(&frame.camera)) {
            return "a camera file made an illegal camera";
        } else if (i == 0) {
            const char *broken = fuzz_draw(&frame, (uint8_t)path->frames[i].line);
            if (broken) return broken;
        }
    }
    return NULL;
}

static const char *run(const uint8_t *bytes, size_t size_b)
{
    const char *name = fuzz_as_file(bytes, size_b);
    struct camera_path path;
    struct error err;

    if (!camera_path_read(name, &path, &err)) return fuzz_check_refusal(err.text, name);
    const char *broken = check_frames(&path);
    if (!broken) broken = check_few(&path);
    if (!broken) broken = check_lens(&path.frames[0]);
    camera_path_free(&path);
    return broken;
}

const struct fuzz_target fuzz_camera_file = {"camera_file", run, NULL};
