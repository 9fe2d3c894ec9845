/* SPDX-License-Identifier: MIT
 *
 * What the stages of a renderer share: a scene, the target that it is drawn to, the camera as this frame has it, and
 * what is counted. Which of these a method uses is said here, once. */
#ifndef LIM_PASS_H
#define LIM_PASS_H

#include "colour.h"
#include "stages.h"

/* What is not there is never read. */
static inline struct lim_stats *lim_stats_of(struct lim_pass *pass)
{
    return LIM_HAS_STATS ? pass->stats : NULL;
}

static inline struct lim_cull *lim_cull_of(struct lim_pass *pass)
{
    return LIM_HAS_CULL ? pass->cull : NULL;
}

static inline struct lim_eye *lim_eye_of(struct lim_pass *pass)
{
    return LIM_HAS_TREE ? &pass->walk->eye : pass->eye;
}

/* NULL: polygons are filled. */
static inline const struct lim_wireframe *lim_wireframe_of(const struct lim_pass *pass)
{
    return LIM_HAS_WIREFRAME && pass->wireframe->on ? pass->wireframe : NULL;
}

/* As it lies in memory. */
static inline uint16_t lim_background_of(const struct lim_pass *pass)
{
    const struct lim_wireframe *wireframe = lim_wireframe_of(pass);

    return lim_memory_colour(wireframe && wireframe->one_colour ? wireframe->background : pass->scene->background);
}

/* The next piece of memory that is shared out. */
static inline void *lim_mem_cut(uint8_t **mem, size_t size_b)
{
    void *piece = *mem;

    *mem += size_b;
    return piece;
}

/* Methods: constants where there is no choice. Who asks for a convex solid or the painter has asked for a mesh before.
 */

#define LIM_IS_MESH(target) (LIM_HAS_MESHES && (!LIM_HAS_PLANES || (target)->method >= LIM_MESH))
#define LIM_IS_MESH_DEPTH(target) (LIM_HAS_MESH_DEPTH && (!LIM_HAS_MESH || (target)->method == LIM_MESH_DEPTH))
#define LIM_IS_CONVEX(target) (LIM_HAS_CONVEX && (!LIM_HAS_HIDDEN || (target)->method == LIM_CONVEX))
#define LIM_IS_PAINTER(target) (LIM_HAS_PAINTER && (!LIM_HAS_SPANS || (target)->method == LIM_PAINTER))
#define LIM_IS_SCANLINE(target)                                                                                        \
    (LIM_HAS_SCANLINE && ((!LIM_HAS_NEAREST && !LIM_HAS_SORTED) || (target)->method == LIM_SCANLINE))

/* Polygons come from a sorted list instead of the tree. */
#define LIM_IS_SORTED(target)                                                                                          \
    (LIM_HAS_SORTED && (!LIM_HAS_TREE || (target)->method >= LIM_DEPTH) && !LIM_IS_MESH(target))
#define LIM_IS_NEWELL(target)                                                                                          \
    (LIM_HAS_NEWELL && ((!LIM_HAS_WALKED && !LIM_HAS_DEPTH) || (target)->method == LIM_NEWELL))

/* Whether what is drawn nearest first is a line's samples: what antialiasing takes. */
#define LIM_PAINTS_NEAREST_FIRST(target)                                                                               \
    (LIM_HAS_SPANS && (target)->method != LIM_CONVEX && (target)->method != LIM_PAINTER && !LIM_IS_MESH(target))

#endif
