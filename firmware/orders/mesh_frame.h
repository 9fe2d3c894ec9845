/* SPDX-License-Identifier: MIT
 *
 * MESH: a dense mesh without a tree, line by line. All vertices are projected once; triangles that face the eye are
 * linked into the line on which they begin; then each line is painted, by distance (far to near, LIM_MESH) or with a
 * line of depths (LIM_MESH_DEPTH). In: a scene of no nodes (scene.h). Memory: what a frame must have is a point and a
 * nearness for each vertex and a link for each triangle; a pool of triangles that cross a line may be short.
 *
 * By distance is wrong where a triangle reaches behind another whose middle is farther, as large ones do; depths are
 * wrong within what 16 bits of nearness at corners tell apart. Neither is exact in order; edges are, as everywhere. */
#ifndef LIM_MESH_FRAME_H
#define LIM_MESH_FRAME_H

#include "meshes.h"

/* What a frame takes; `least`: with the smallest pool. */
size_t lim_mesh_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least);

/* Shares out memory of at least the least size. */
void lim_mesh_init(struct lim_mesh *mesh, void *mem, size_t mem_b);

/* 0, or the target's error. */
LIM_MUST_CHECK int lim_mesh_frame(struct lim_mesh *mesh);

#endif
