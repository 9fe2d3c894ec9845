/* SPDX-License-Identifier: MIT
 *
 * What a frame costs on a Cortex-M0+, from the renderer's own counters: no compiler, no emulator, the same on every
 * host. For choices between trees and orders of one scene, and for reports; `limner measure` counts instead. */
#ifndef SIM_FRAME_COST_H
#define SIM_FRAME_COST_H

#include "scene.h"
#include "stages.h"
#include "target.h"

/* Whether frames drawn by a method can be predicted: nearest first, by scan lines, and as a mesh. */
bool frame_cost_knows(enum lim_method method);

/* Instructions of such a frame in profile fast, polygons opaque, as if they were of one colour each. Within 4 % of
 * those counted, for the scenes in sim/scenes with any tree, at 240x240 pixels; within 7 % at 128x64; meshes: see
 * frame_cost.c. tests/arm/arm_splitters.sh compares. */
double frame_cost_m0plus(const struct lim_stats *stats, const struct lim_target *target);

/* The same with what the scene's textures add, as if all of its polygons had one: rounded from what `limner measure`
 * counts of stages texels, texture and texture_line, on rooms and a teapot; a tenth off, or more. */
double frame_cost_of_scene_m0plus(const struct lim_stats *stats, const struct lim_target *target,
                                  const struct lim_scene *scene);

/* What all vertices of a scene drawn as a mesh take: a frame transforms each of them. */
double frame_cost_of_mesh_vertices_m0plus(size_t vertices);

/* What that of polygons of one colour is the sum of. */
struct frame_cost_term {
    const char *name;
    double count, each; /* instructions */
};
enum { FRAME_COST_TERMS = 14 };
void frame_cost_terms(const struct lim_stats *stats, const struct lim_target *target,
                      struct frame_cost_term terms[FRAME_COST_TERMS]);

/* The same for frames that nothing predicts, with a rough measure for what they have beside: no instructions, but of
 * two frames of one scene the dearer one mostly has more of it. */
double frame_cost_work(const struct lim_stats *stats, const struct lim_target *target);

/* Whether the scene's polygons are. */
bool frame_cost_is_known(const struct lim_scene *scene);

#endif
