/* SPDX-License-Identifier: MIT
 *
 * What a mesh's triangles show where its scene has textures. In: a triangle's corners on the screen and their places in
 * the picture. Out: how texels advance over it: evenly, or in perspective, by struct lim_gradients which lie at the end
 * of the pool. */
#ifndef LIM_MESH_TEXTURE_H
#define LIM_MESH_TEXTURE_H

#include "meshes.h"
#include "view/pass.h"

/* Room for one triangle's gradients, in entries of the pool. */
enum { MESH_GRADIENT_ENTRIES = 2 };

/* How far away a triangle has to be for texels to advance evenly, as the compiler sees it (sim/compiler/encode_even.c),
 * in profile fast and up to a lens in which what is as wide as it is far away has so many pixels; else farther. */
enum { MESH_EVEN_LENS_PX = LIM_HAS_LIMBS || LIM_SUB_BITS < 8 ? 350 : 3 << (14 - LIM_SUB_BITS) };

/* Whether triangles name textures instead of colours. */
static inline bool lim_mesh_has_textures(const struct lim_mesh *mesh)
{
    return LIM_HAS_TEXTURE && lim_texture_count(mesh->pass->scene) > 0;
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

/* Of an entry that begins: what has no pixels needs no more than that. */
static inline void lim_mesh_texture_begin(const struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    active->look->level.w_bits = mesh->looks->first;
}

static inline void lim_mesh_texture_begin_clipped(const struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    active->look->level.w_bits = mesh->looks->first == LIM_MESH_UNSET ? LIM_MESH_UNSET_CLIPPED : LIM_MESH_COLOUR;
}

/* Of an entry that is given back. */
static inline void lim_mesh_texture_leave(struct lim_mesh *mesh, const struct lim_mesh_active *active)
{
    if (active->look->level.w_bits != LIM_MESH_PERSPECTIVE || !active->look->gradients) return;
    active->look->gradients->next = mesh->looks->free;
    mesh->looks->free = active->look->gradients;
}

/* Functions that are there if LIM_HAS_TEXTURE. */

/* Once a frame, when nearness is as fine as it gets: after lim_view_refine(). */
void lim_mesh_texture_frame(struct lim_mesh *mesh);

/* What an entry that is unset shows, before its first pixels. */
void lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active);
void lim_mesh_texture_set_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active);

/* Pixels x0 <= x < x1 of one in perspective, or clipped, which reaches from left to right. */
void lim_mesh_texture_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                            int32_t left, int32_t right, int32_t x0, int32_t x1);

/* The same of what has depth, evenly or not, where it is the nearest. There if LIM_HAS_MESH_DEPTH, too. */
struct lim_mesh_depth_span {
    uint16_t *depths; /* of the line */
    int32_t left, right, x0, x1;
};
void lim_mesh_texture_paint_deep(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                 struct lim_mesh_active *active, const struct lim_mesh_depth_span *deep);

/* Gradients of one in perspective: its own, or those that `made` has room for. */
struct lim_gradients *lim_mesh_texture_gradients(struct lim_mesh *mesh, struct lim_mesh_active *active,
                                                 struct lim_gradients *made);

#endif
