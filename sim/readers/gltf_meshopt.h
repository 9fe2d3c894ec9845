/* SPDX-License-Identifier: MIT
 *
 * Views of a glTF 2.0 file's buffers that EXT_meshopt_compression has packed, by libmeshoptimizer. */
#ifndef SIM_GLTF_MESHOPT_H
#define SIM_GLTF_MESHOPT_H

#include "readers/gltf_numbers.h"

/* Unpacks them into buffers of their own, and mends the file's JSON, which has no such view then. An error says which
 * view is damaged. */
bool gltf_meshopt_decode(const char *path, const struct gltf_file *file, struct gltf_buffers *buffers,
                         struct error *err);

#endif
