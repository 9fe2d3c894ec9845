/* SPDX-License-Identifier: MIT
 *
 * What kind of value each member of a glTF 2.0 file is that is read here, by the tables of its specification ("glTF 2.0
 * Specification", section 5, and those of the extensions in gltf_extensions.c). Who reads a member may then take what
 * is of another kind for what is not there. */
#ifndef SIM_GLTF_TYPES_H
#define SIM_GLTF_TYPES_H

#include "gltf/gltf_file.h"

/* An error names the first member that is of another kind, as `materials[0].alphaCutoff is no number`. Whole numbers
 * that are written as 3.0 become 3. */
bool gltf_types_check(const char *path, struct gltf_file *file, struct error *err);

#endif
