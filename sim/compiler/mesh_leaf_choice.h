/* SPDX-License-Identifier: MIT
 *
 * Whether dense parts of a model become mesh leaves (firmware/SCENE.md): where that is cheaper, and where the order by
 * distance errs no more than the scene's profile promises. What is wrong is looked for on cameras that nothing was
 * tuned on. */
#ifndef SIM_MESH_LEAF_CHOICE_H
#define SIM_MESH_LEAF_CHOICE_H

#include "accuracy/reference.h"
#include "compiler/compile_mesh.h"

/* What might take the scene's place. */
struct leaf_trial {
    struct compile_options options; /* work leads to them */
    struct compilation work;        /* its parts are those still in it */
    struct compiled candidate;
};

/* Compiles the scene with all its dense parts as leaves, if the options leave the choice and that is predicted to be
 * cheaper than the scene that has been compiled. Returns whether the reference is wanted; leaf_trial_free() in any
 * case. */
bool leaf_trial_begin(struct leaf_trial *trial, const struct mesh *mesh, const struct compile_options *options,
                      struct compiled *scene);

/* Draws both, and takes the candidate for the scene if it is right enough; else the part that errs most leaves it, up
 * to four times. `groups` as in compare.h. */
bool leaf_trial_settle(struct leaf_trial *trial, struct reference *reference, const uint32_t *groups,
                       struct compiled *scene, struct error *err);

void leaf_trial_free(struct leaf_trial *trial);

#endif
