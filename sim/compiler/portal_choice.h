/* SPDX-License-Identifier: MIT
 *
 * Whether a scene gets what its portals show: --portals. */
#ifndef SIM_PORTAL_CHOICE_H
#define SIM_PORTAL_CHOICE_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* Adds places and visible sets to a compiled scene: if they are wanted, or, automatically, if they pay. Draws sampled
 * cameras with and without; where a picture differs, the scene goes without, and it is an error if they are wanted.
 * What was found is in scene->report.portals. */
bool portals_add(struct compiled *scene, const struct compile_options *options, struct error *err);

#endif
