/* SPDX-License-Identifier: MIT
 *
 * Time goes in whole milliseconds, as firmware counts it. */
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>

double moving_time_s(const struct moving *moving, size_t frame, size_t count)
{
    return floor(moving_length_s(moving) * 1000 * (double)frame / (double)count) / 1000;
}

double moving_length_s(const struct moving *moving)
{
    const struct lim_motion *motion = &moving->objects[0].motion;
    return motion->keys[motion->count - 1].time_ms / 1000.0;
}

void moving_pose(struct moving *moving, double time_s)
{
    for (size_t i = 0; i < moving->count; i++)
        lim_motion_at(&moving->objects[i].motion, (uint32_t)llround(time_s * 1000), &moving->instances[i]);
}

bool moving_clean_still(const struct moving *moving, const struct model *still, struct mesh *mesh, struct error *err)
{
    return moving->grid.is_long ? mesh_clean_on(still, &moving->grid, mesh, err) : mesh_clean(still, mesh, err);
}

void moving_free(struct moving *moving)
{
    for (size_t i = 0; i < moving->count; i++) {
        compiled_free(&moving->objects[i].scene);
        free(moving->objects[i].keys);
        free(moving->objects[i].origins);
        free(moving->objects[i].words);
    }
    free(moving->objects);
    free(moving->instances);
    model_free(&moving->model);
    *moving = (struct moving){0};
}
