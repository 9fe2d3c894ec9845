/* SPDX-License-Identifier: MIT */
#include "collide.h"
#include "long.h"

int lim_solid_init(struct lim_solid *solid, const struct lim_scene *scene, void *mem, size_t mem_b)
{
    LIM_ASSERT(solid && scene && mem && (uintptr_t)mem % LIM_ALIGNOF(lim_index) == 0);
    if (lim_scene_is_mesh(scene) || lim_scene_long(scene)) return LIM_ERR_SCENE;
    if (mem_b / sizeof(lim_index) < scene->limits.depth) return LIM_ERR_MEMORY;
    solid->scene = scene;
    solid->stack = mem;
    return LIM_OK;
}
