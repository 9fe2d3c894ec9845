/* SPDX-License-Identifier: MIT
 *
 * The one decision of how a model is drawn: by which method, on which tree, with which parts as mesh leaves, with what
 * portals show or without. Every command that draws or compiles a model takes it here, so what one draws is what
 * another writes. What was decided before is remembered (decision_cache.h). */
#ifndef SIM_DECISION_H
#define SIM_DECISION_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* Whether the reference may have a say: what is named is not chosen, and exact keeps its tree. */
bool decision_asks_reference(const struct compile_options *options);

/* From a mesh that has its T-vertices to the scene. `fine`: the file's faces as the reference sees them
 * (mesh_clean_fine()); only their places count; NULL where it has no say. options->predict changes nothing. */
bool decision_make(const struct mesh *mesh, const struct mesh *fine, const struct compile_options *options,
                   struct compiled *out, struct error *err);

#endif
