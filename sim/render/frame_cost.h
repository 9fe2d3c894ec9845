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

/* Instructions of such a frame in profile fast, polygons opaque and of one colour each. Within 4 % of those counted,
 * for the scenes in sim/scenes with any tree; tests/arm/arm_splitters.sh compares. */
double frame_cost_m0plus(const struct lim_stats *stats, const struct lim_target *target);

/* Whether the scene's polygons are. */
bool frame_cost_is_known(const struct lim_scene *scene);

#endif
