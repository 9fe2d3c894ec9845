/* SPDX-License-Identifier: MIT
 *
 * Animations of a file that the importer library has read: which nodes move, and how. First the movers are found, which
 * says of each node what moves it; with the faces known, keys are made (motion_keys.h). */
#ifndef SIM_IMPORT_MOTION_H
#define SIM_IMPORT_MOTION_H

#include "model/model.h"
#include "readers/node_motion.h"

struct motions {
    const char *path;
    const struct node_transforms *transforms;
    struct model *model;
    struct node_motions nodes;
    const struct aiNode **movers; /* the nodes of model->movers */
    size_t mover_capacity, node_capacity;
    struct map places; /* from a node's address to its mover, from 1 */
};

/* --movers off: whatever is animated stays where the file has it, for what is read from here on in all of the process.
 */
void motions_leave_out(bool leave_out);
bool motions_are_left_out(void);

/* Sets the model's movers, without their keys, or model->is_stopped, if they are left out. A part of a node that
 * animations keep at one value has it from here on in *transforms. Both, and the model, must outlive *out. */
bool motions_find(const char *path, const struct aiScene *scene, struct node_transforms *transforms,
                  struct model *model, struct motions *out, struct error *err);

/* Which mover a node is, from 1; 0: none, it goes with what is above it. */
uint16_t motions_mover_of(const struct motions *motions, const struct aiNode *node);

/* Sets keys, of a model with all of its faces. They are float32 numbers in files: *step_m becomes the largest step
 * between such where a key is, if it is less. */
bool motions_set_keys(struct motions *motions, double *step_m, struct error *err);
void motions_free(struct motions *motions);

#endif
