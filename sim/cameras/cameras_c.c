/* SPDX-License-Identifier: MIT
 *
 * A camera path as a C header. What fails to be written shows when the file is closed. */
#include "cameras/cameras_c.h"

#include <inttypes.h>

static void write_camera(FILE *file, const struct lim_camera *camera)
{
    fprintf(file, "    {{%" PRId32 ", %" PRId32 ", %" PRId32 "}, ", camera->eye_q8[0], camera->eye_q8[1],
            camera->eye_q8[2]);
    fprintf(file, "%" PRIu32 "u, %" PRIu32 "u, %" PRIu32 "u, %" PRIu32 "u, %" PRIu32 "u, ", camera->yaw, camera->pitch,
            camera->roll, camera->tan_x_q28, camera->tan_y_q28);
    fprintf(file, "LIM_CAMERA_END(%" PRId32 ", %" PRId32 ", %" PRId32 ", %" PRId32 ")},\n", camera->near_q8,
            camera->origin[0], camera->origin[1], camera->origin[2]);
}

static void write_times(FILE *file, const double *times_s, size_t count)
{
    fprintf(file, "static const LIM_FLASH uint32_t cameras_time_ms[CAMERAS_COUNT] = {");
    for (size_t frame = 0; frame < count; frame++)
        fprintf(file, "%s%.0f,", frame % 16 ? " " : "\n    ", 1000 * times_s[frame]);
    fprintf(file, "\n};\n#define CAMERAS_TIME_MS(frame) cameras_time_ms[frame]\n\n");
}

bool cameras_c_write(const struct camera_path *path, const double *times_s, const struct lens *lens,
                     const struct grid *grid, unsigned w_px, unsigned h_px, FILE *file, struct error *err)
{
    fprintf(file, "/* Cameras in a scene's units, written by `limner render --write-cameras`. */\n");
    fprintf(file, "#ifndef CAMERAS_H\n#define CAMERAS_H\n\n#include \"camera.h\"\n\n");
    fprintf(file, "#define CAMERAS_W_PX %u\n#define CAMERAS_H_PX %u\n#define CAMERAS_COUNT %zu\n\n", w_px, h_px,
            path->count);
    if (times_s) write_times(file, times_s, path->count);
    fprintf(file, "static const LIM_FLASH struct lim_camera cameras[CAMERAS_COUNT] = {\n");
    for (size_t frame = 0; frame < path->count; frame++) {
        struct lim_camera camera;
        if (!camera_path_to_camera(path, frame, lens, grid, &camera, err)) return false;
        write_camera(file, &camera);
    }
    fprintf(file, "};\n\n#endif\n");
    return true;
}
