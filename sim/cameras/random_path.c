/* SPDX-License-Identifier: MIT
 *
 * Each camera is drawn on its own. */
#include "cameras/random_path.h"

#include "cameras/grazing.h"
#include "cameras/sample.h"
#include "scene/moving.h"

#include <stdlib.h>
#include <string.h>

typedef bool next_fn(struct sampler *sampler, struct viewpoint *out);

/* `lens`: where its near plane decides where eyes may be; else NULL. */
static bool draw_path(const struct compiled *scene, next_fn *next, const struct lens *lens, const char *name,
                      uint32_t seed, size_t count, struct camera_path *out, struct error *err)
{
    struct sampler sampler;
    if (scene->scene.vertex_count == 0) return error_set(err, "%s: nothing stands still in this scene", name);
    *out = (struct camera_path){.name = strdup(name), .frames = calloc(count, sizeof *out->frames)};
    bool ok = (out->name && out->frames) || error_set(err, "%s: out of memory", name);
    sampler_init(&sampler, scene);
    sampler_seed(&sampler, seed);
    if (lens) sampler.near_m = lens->near_m;
    for (; ok && out->count < count; out->count += ok) {
        struct viewpoint *viewpoint = &out->frames[out->count];
        if (scene->moving) sampler.time_s = moving_time_s(scene->moving, out->count, count);
        ok = next(&sampler, viewpoint) || error_set(err, "%s: the scene has no free space", name);
        viewpoint->line = out->count + 1;
    }
    if (!ok) camera_path_free(out);
    return ok;
}

bool random_path(const struct compiled *scene, const char *name, uint32_t seed, size_t count, struct camera_path *out,
                 struct error *err)
{
    return draw_path(scene, sampler_anywhere, NULL, name, seed, count, out, err);
}

/* Such as look at the model's faces. */
static bool draw_faces_path(const struct compiled *scene, next_fn *next, const struct lens *lens, const char *name,
                            uint32_t seed, size_t count, struct camera_path *out, struct error *err)
{
    if (!scene->original)
        return error_set(err, "%s: a .lim file does not hold the model's faces; give the model", name);
    return draw_path(scene, next, lens, name, seed, count, out, err);
}

bool near_path(const struct compiled *scene, const struct lens *lens, const char *name, uint32_t seed, size_t count,
               struct camera_path *out, struct error *err)
{
    return draw_faces_path(scene, sampler_near, lens, name, seed, count, out, err);
}

bool grazing_path(const struct compiled *scene, const struct lens *lens, const char *name, uint32_t seed, size_t count,
                  struct camera_path *out, struct error *err)
{
    return draw_faces_path(scene, sampler_grazing, lens, name, seed, count, out, err);
}
