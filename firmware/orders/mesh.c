/* SPDX-License-Identifier: MIT */
#include "orders/mesh.h"

#if LIM_HAS_MESHES

enum { LEAST_ACTIVE = 8 };

size_t lim_mesh_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    const size_t depth_b = LIM_HAS_MESH_DEPTH ? LIM_MESH_DEPTH_MEM_B(target->w_px) : 0;

    return depth_b + LIM_MESH_MEM_B(target->h_px, scene->vertex_count, scene->polygon_count,
                                    least || scene->limits.active < LEAST_ACTIVE ? LEAST_ACTIVE : scene->limits.active);
}

void lim_mesh_init(struct lim_mesh *mesh, void *mem, size_t mem_b)
{
    (void)mesh, (void)mem, (void)mem_b;
}

int lim_mesh_frame(struct lim_mesh *mesh)
{
    (void)mesh;
    return LIM_ERR_TARGET;
}

#endif
