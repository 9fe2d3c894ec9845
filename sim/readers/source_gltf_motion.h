/* SPDX-License-Identifier: MIT
 *
 * Animations of a glTF 2.0 file for the reference, number by number: nothing of it is the importer's but the bytes. */
#ifndef SIM_SOURCE_GLTF_MOTION_H
#define SIM_SOURCE_GLTF_MOTION_H

#include "gltf/gltf_file.h"
#include "gltf/gltf_numbers.h"
#include "model/source_motion.h"

/* All nodes, and their keys unless animations are left out (import_motion.h). Keys that keep a part at one value become
 * that part, and `kept` says so. Empty where the file has what this reader does not know. */
void source_gltf_motion_read(const struct gltf_file *file, const struct gltf_buffers *buffers,
                             struct source_motion *out);

#endif
