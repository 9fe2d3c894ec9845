/* SPDX-License-Identifier: MIT
 *
 * Animations of a file that the importer library has read: which nodes move, and how. */
#ifndef SIM_IMPORT_MOTION_H
#define SIM_IMPORT_MOTION_H

#include "model/model.h"
#include "readers/node_transforms.h"

/* Sets the model's movers and keys, and nodes[i] to the node of movers[i], which is the caller's to free. Keys are
 * float32 numbers in files: *step_m becomes the largest step between such where a key is, if it is less. */
bool import_motions(const char *path, const struct aiScene *scene, const struct node_transforms *transforms,
                    struct model *model, const struct aiNode ***nodes, double *step_m, struct error *err);

#endif
