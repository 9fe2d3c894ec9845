/* SPDX-License-Identifier: MIT
 *
 * Whether a model is drawn as a mesh without a tree: for a dense one that is cheaper, but its order is approximate. So
 * it is held against the reference first, on cameras that nothing was tuned on, and taken if it is as right as its
 * profile promises. */
#ifndef SIM_MESH_CHOICE_H
#define SIM_MESH_CHOICE_H

#include "accuracy/reference.h"
#include "compiler/compile_options.h"
#include "scene/compiled.h"

struct core;

/* What might take the scene's place. */
struct mesh_trials {
    struct compiled by_distance, by_depth; /* without polygons: it is out */
};

/* The most that a scene may have wrong in place of one that has tree_percent wrong: what its options or its profile
 * promise, or a little more than that one. */
double mesh_choice_bound_percent(const struct compile_options *options, double tree_percent);

/* The worse of all cameras and of portraits. */
double mesh_choice_worst_percent(const struct predicted *wrong);

/* Compiles them, if the options leave the choice and it is predicted to need fewer instructions than the scene that has
 * been compiled, which notes what was tried. Returns whether the reference is wanted; mesh_trials_free() in any case.
 */
bool mesh_choice_try(const struct mesh *mesh, const struct compile_options *options, struct compiled *scene,
                     struct mesh_trials *trials);

/* Draws them and the scene, and takes the cheapest that is right enough for the scene. `groups` as in compare.h. */
bool mesh_choice_settle(struct mesh_trials *trials, const struct mesh *mesh, const struct compile_options *options,
                        struct reference *reference, const uint32_t *groups, struct compiled *scene, struct error *err);

void mesh_trials_free(struct mesh_trials *trials);

#endif
