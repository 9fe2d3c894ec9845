/* SPDX-License-Identifier: MIT
 *
 * Animations as the importer library hands them on: linear keys of nodes that are known by their names. */
#ifndef SIM_MOTION_ASSIMP_H
#define SIM_MOTION_ASSIMP_H

#include "readers/node_motion.h"

/* Adds what moves nodes. Refuses, naming the node, one that has not its name alone, and keys that are no numbers. */
bool motion_assimp_read(const char *path, const struct aiScene *scene, const struct node_transforms *transforms,
                        struct node_motions *out, struct error *err);

#endif
