/* SPDX-License-Identifier: MIT
 *
 * What a mesh's triangles show where its scene has textures. In: a triangle's corners on the screen and their places in
 * the picture. Out: how texels advance over it: evenly, or in perspective, by struct lim_gradients which lie at the end
 * of the pool. */
#ifndef LIM_MESH_TEXTURE_H
#define LIM_MESH_TEXTURE_H

#include "meshes.h"
#include "pixels/texels.h"
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

/* Shown before any other pixels of an entry: those find out what it shows. Functions that are there if LIM_HAS_TEXTURE.
 */
void lim_mesh_show_first(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);
void lim_mesh_show_first_clipped(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);

/* What has depth shows pixels where it is the nearest. There if LIM_HAS_MESH_DEPTH, too. */
void lim_mesh_show_deep(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);

/* Of an entry that begins: what has no pixels needs no more than that. */
static inline void lim_mesh_texture_begin(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    active->look->show = lim_mesh_show_first;
    active->look->mesh = mesh;
}

static inline void lim_mesh_texture_begin_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    active->look->show = lim_mesh_show_first_clipped;
    active->look->mesh = mesh;
    active->look->level.w_bits = LIM_MESH_UNSET_CLIPPED;
}

/* Of an entry that begins, and has got a plane of nearness. */
static inline void lim_mesh_texture_deepen(struct lim_mesh_active *active)
{
    active->depth->mesh = active->look->mesh;
    active->look->show = lim_mesh_show_deep;
}

/* Where an entry's pixels would reach to, if the line did not end. */
static inline void lim_mesh_texture_reach(struct lim_mesh *mesh, int32_t left, int32_t right)
{
    mesh->looks->left = (int16_t)left;
    mesh->looks->right = (int16_t)right;
}

/* It shows nothing yet, and holds no gradients: a new entry, or one that begins with depth. */
static inline void lim_mesh_texture_unset(struct lim_mesh_active *active)
{
    active->look->level.w_bits = LIM_MESH_UNSET;
}

/* Of an entry that is given back. */
static inline void lim_mesh_texture_leave(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    if (active->look->level.w_bits != LIM_MESH_PERSPECTIVE) return;
    active->look->level.w_bits = LIM_MESH_UNSET;
    if (!active->look->gradients) return;
    active->look->gradients->next = mesh->looks->free;
    mesh->looks->free = active->look->gradients;
}

/* Functions that are there if LIM_HAS_TEXTURE. */

/* Once a frame, when nearness is as fine as it gets: after lim_view_refine(). */
void lim_mesh_texture_frame(struct lim_mesh *mesh);

/* What an entry that is unset shows, before its first pixels. */
void lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active);
void lim_mesh_texture_set_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active);

/* The entry whose level that is. */
static inline struct lim_mesh_active *lim_mesh_of_level(const struct lim_texture_level *level)
{
    const size_t at_b = offsetof(struct lim_mesh_active, look) + offsetof(struct lim_mesh_look, level);

    return (struct lim_mesh_active *)(void *)((uintptr_t)level - at_b);
}

/* Pixels x0 <= x < x1 of the line that is painted. */
struct lim_mesh_run {
    const struct lim_mesh_line *line;
    int32_t x0, x1;
};

static inline struct lim_mesh_run lim_mesh_run(const struct lim_mesh *mesh, const uint16_t *end, uint_fast16_t n)
{
    const struct lim_mesh_line *const line = mesh->looks->line;
    const int32_t x1 = (int32_t)(end - line->pixels);

    return (struct lim_mesh_run){line, x1 - (int32_t)n, x1};
}

/* A line of one in perspective. */
struct lim_textured_span lim_mesh_span(const struct lim_mesh *mesh, const struct lim_mesh_run *run,
                                       struct lim_gradients *gradients);

/* What has no level, once that is known. */
void lim_mesh_show_other(uint16_t *end, uint_fast16_t n, const struct lim_texture_level *level);

/* How entries of one colour, and those in perspective, paint themselves. */
void lim_mesh_show_colour(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);
void lim_mesh_show_perspective(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);

/* Gradients of one in perspective: its own, or those that `made` has room for. */
struct lim_gradients *lim_mesh_texture_gradients(struct lim_mesh *mesh, struct lim_mesh_active *active,
                                                 struct lim_gradients *made);

#endif
