/* SPDX-License-Identifier: MIT
 *
 * Each camera is drawn on its own. */
#include "random_path.h"

#include "sample.h"

#include <stdlib.h>
#include <string.h>

bool random_path(const struct compiled *scene, const char *name, uint32_t seed, size_t count, struct camera_path *out,
                 struct error *err)
{
    struct sampler sampler;
    if (scene->scene.vertex_count == 0) return error_set(err, "%s: nothing stands still in this scene", name);
    *out = (struct camera_path){.name = strdup(name), .frames = calloc(count, sizeof *out->frames)};
    bool ok = (out->name && out->frames) || error_set(err, "%s: out of memory", name);
    sampler_init(&sampler, scene);
    sampler_seed(&sampler, seed);
    for (; ok && out->count < count; out->count += ok) {
        struct viewpoint *viewpoint = &out->frames[out->count];
        ok = sampler_anywhere(&sampler, viewpoint) || error_set(err, "%s: the scene has no free space", name);
        viewpoint->line = out->count + 1;
    }
    if (!ok) camera_path_free(out);
    return ok;
}
