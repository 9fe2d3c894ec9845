/* SPDX-License-Identifier: MIT
 *
 * From the motions of a node and of all above it to one list of keys, which lines and even turns join: what firmware
 * has. */
#ifndef SIM_MOTION_KEYS_H
#define SIM_MOTION_KEYS_H

#include "model/model.h"
#include "readers/node_motion.h"

struct motion_keys {
    const char *path;
    const struct node_transforms *transforms;
    const struct node_motions *nodes;
    struct model *model; /* its faces tell how large a mover is */
    double *step_m;      /* becomes the largest float32 step of a key's position, if it is less */
};

/* What the keys may be wrong between their times, as the way that any point of the mover is off: 1/1024 of how far the
 * mover reaches from its node's origin, or half a unit of the scene's grid if that is more; but no two keys
 * lie nearer than a millisecond. Where the motion jumps, it does so within the millisecond before. */
double motion_keys_tolerance_m(const struct model *model, size_t mover);

/* Sets the place at rest and the keys of model->movers[mover], which is the node. Refuses, by name, motion that is not
 * rigid, or takes more keys than there may be. */
bool motion_keys_set(const struct motion_keys *from, const struct aiNode *node, size_t mover, struct error *err);

#endif
