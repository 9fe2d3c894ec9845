/* SPDX-License-Identifier: MIT */
#include "cameras/level_path_cameras.h"

#include "levels/level_cameras.h"

#include <stdlib.h>
#include <string.h>

bool level_path_cameras(const char *path, size_t most, struct camera_path *out, struct error *err)
{
    struct level_camera *cameras;
    size_t there;
    if (!level_cameras_read(path, &cameras, &there, err)) return false;
    const size_t count = most && most < there ? most : there;
    *out = (struct camera_path){.name = strdup(path), .frames = calloc(count, sizeof *out->frames), .count = count};
    const bool ok = (out->name && out->frames) || error_set(err, "%s: out of memory", path);
    for (size_t i = 0; ok && i < count; i++) {
        const struct level_camera *camera = &cameras[i * there / count];
        out->frames[i].line = i + 1;
        memcpy(out->frames[i].eye_m, camera->eye_m, sizeof camera->eye_m);
        memcpy(out->frames[i].target_m, camera->target_m, sizeof camera->target_m);
    }
    free(cameras);
    if (!ok) camera_path_free(out);
    return ok;
}
