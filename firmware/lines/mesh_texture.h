/* SPDX-License-Identifier: MIT
 *
 * What a mesh's triangles show where its scene has textures. In: a triangle's corners on the screen and their places in
 * the picture. Out: how texels advance over it: evenly, or in perspective, by struct lim_gradients for which there has
 * to be room at the end of the pool. */
#ifndef LIM_MESH_TEXTURE_H
#define LIM_MESH_TEXTURE_H

#include "orders.h"
#include "view/pass.h"

struct lim_mesh_clipped;

/* Room for one triangle's gradients, in entries of the pool. */
enum { MESH_GRADIENT_ENTRIES = 2 };

/* Whether triangles name textures instead of colours. */
static inline bool lim_mesh_has_textures(const struct lim_mesh *mesh)
{
    return LIM_HAS_TEXTURE && lim_texture_count(mesh->pass->scene) > 0;
}

/* Of an entry: else it has one colour. */
static inline bool lim_mesh_is_textured(const struct lim_mesh_active *active)
{
    return active->look->level.texels != NULL;
}

static inline bool lim_mesh_is_in_perspective(const struct lim_mesh_active *active)
{
    return active->look->level.texels && !active->look->level.palette;
}

/* All room for gradients is free. */
static inline void lim_mesh_texture_clear(struct lim_mesh *mesh)
{
    mesh->looks->free = NULL;
    mesh->pool_size = mesh->looks->whole_size;
}

/* Entries of the pool that this frame has used, free again or not. */
static inline uint16_t lim_mesh_texture_used(const struct lim_mesh *mesh)
{
    return (uint16_t)(mesh->unused + (mesh->looks->whole_size - mesh->pool_size));
}

/* Of an entry that is given back. */
static inline void lim_mesh_texture_leave(struct lim_mesh *mesh, const struct lim_mesh_active *active)
{
    if (!lim_mesh_is_in_perspective(active)) return;
    active->look->gradients->next = mesh->looks->free;
    mesh->looks->free = active->look->gradients;
}

/* Functions that are there if LIM_HAS_TEXTURE. */

/* Look, or colour, of a triangle that is not clipped; and of what is left of one that is. false: no room. */
bool lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active, const LIM_FLASH lim_index *corners);
bool lim_mesh_texture_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active,
                              const struct lim_mesh_clipped *clipped, lim_index triangle);

/* Pixels x0 <= x < x1 of one in perspective, which reaches from left to right. */
void lim_mesh_texture_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                            int32_t left, int32_t right, int32_t x0, int32_t x1);

/* The same of what has depth, evenly or not, where it is the nearest. There if LIM_HAS_MESH_DEPTH, too. */
struct lim_mesh_depth_span {
    uint16_t *depths; /* of the line */
    int32_t left, right, x0, x1;
};
void lim_mesh_texture_paint_deep(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                 const struct lim_mesh_active *active, const struct lim_mesh_depth_span *deep);

#endif
