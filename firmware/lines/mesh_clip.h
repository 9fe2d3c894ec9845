/* SPDX-License-Identifier: MIT
 *
 * A mesh's triangles that meet the near plane or the guard band. Nothing of them is kept: whoever wants their corners
 * clips them again, and gets the same. */
#ifndef LIM_MESH_CLIP_H
#define LIM_MESH_CLIP_H

#include "meshes.h"
#include "view/view.h"

/* Most corners of what is left of a triangle; and most triangles of a fan of them. */
enum { MESH_CORNERS = 3 + CLIP_PLANES, MESH_FAN = MESH_CORNERS - 2 };

/* What is left of a triangle. */
struct lim_mesh_clipped {
    struct lim_edge_shape shape;
    uint8_t n; /* corners; 3 or more */
    uint16_t nearness[MESH_CORNERS];
    struct lim_point at[MESH_CORNERS];
};

/* Words of a triangle. */
static inline const LIM_FLASH lim_index *lim_mesh_triangle(const struct lim_mesh *mesh, lim_index triangle)
{
    return mesh->pass->scene->polygons + (size_t)triangle * LIM_TRIANGLE_WORDS;
}

/* Of an entry, whose rank has it below its nearness. */
static inline lim_index lim_mesh_number(const struct lim_mesh_active *active)
{
    return (lim_index)active->rank;
}

/* Whether a triangle has to be clipped. */
static inline bool lim_mesh_is_cut(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    return mesh->extent == LIM_VIEW_CLIPPED &&
           (!mesh->nearness[corners[0]] || !mesh->nearness[corners[1]] || !mesh->nearness[corners[2]]);
}

/* false: nothing of it is left, or it faces away. */
bool lim_mesh_clip(const struct lim_mesh *mesh, lim_index triangle, struct lim_mesh_clipped *out);

/* A triangle of the fan that stands for a non-monotone one, 1 <= part <= n - 2. false: rounding turned it over, and it
 * has no pixels. */
bool lim_mesh_fan(const struct lim_mesh_clipped *clipped, uint8_t part, struct lim_point at[3]);

#endif
