/* SPDX-License-Identifier: MIT
 *
 * Animations of a glTF 2.0 file, from its JSON: the importer library would find nodes by their names, which need not
 * differ, takes keys for float32, and does not hand on how they are joined. */
#ifndef SIM_MOTION_GLTF_H
#define SIM_MOTION_GLTF_H

#include "readers/node_motion.h"

/* Adds what moves nodes of the scene that is shown. Refuses, naming the animation, keys that are not where or what the
 * file says. */
bool motion_gltf_read(const char *path, const struct node_transforms *transforms, struct node_motions *out,
                      struct error *err);

#endif
