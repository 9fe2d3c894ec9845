/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a camera file: refused in one line that begins with the file's name, or read; and
 * what is read makes cameras that the renderer takes, or is refused line by line. */
#include "camera_path.h"
#include "fuzz_frame.h"
#include "fuzz_room.h"

#include <stdio.h>
#include <string.h>

static const char *check_refusal(const struct error *err, const char *path)
{
    if (strncmp(err->text, path, strlen(path)) != 0) return "a refusal does not name the file";
    return strchr(err->text, '\n') ? "a refusal has several lines" : NULL;
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
            const char *broken = check_refusal(&err, path->name);
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

    if (!camera_path_read(name, &path, &err)) return check_refusal(&err, name);
    const char *broken = check_frames(&path);
    camera_path_free(&path);
    return broken;
}

const struct fuzz_target fuzz_camera_file = {"camera_file", run, NULL};
