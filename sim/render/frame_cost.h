/* SPDX-License-Identifier: MIT
 *
 * What a frame costs on a Cortex-M0+, from the renderer's own counters: no compiler, no emulator, the same on every
 * host. For choices between trees and orders of one scene, and for reports; `limner measure` counts instead. */
#ifndef SIM_FRAME_COST_H
#define SIM_FRAME_COST_H

#include "scene.h"
#include "stages.h"
#include "target.h"

/* Whether frames drawn by a method can be predicted: nearest first, and by scan lines. */
bool frame_cost_knows(enum lim_method method);

/* Instructions of such a frame in profile fast, polygons opaque, as if they were of one colour each. Within 4 % of
 * those counted, for the scenes in sim/scenes with any tree; tests/arm/arm_splitters.sh compares. */
double frame_cost_m0plus(const struct lim_stats *stats, const struct lim_target *target);

/* What its textures add, if all of the scene's polygons have one: rounded from what `limner measure` counts of
 * stages texels, texture and texture_line, on rooms and a teapot; a tenth off, or more. */
double frame_cost_textures_m0plus(const struct lim_stats *stats);

/* Whether the scene's polygons are opaque. */
bool frame_cost_is_known(const struct lim_scene *scene);

#endif
