/* SPDX-License-Identifier: MIT
 *
 * Views of a glTF 2.0 file's buffers that EXT_meshopt_compression has packed, by libmeshoptimizer. */
#ifndef SIM_GLTF_MESHOPT_H
#define SIM_GLTF_MESHOPT_H

#include "gltf/gltf_file.h"

bool gltf_meshopt_is_packed(const json_t *view);

/* The buffer that has the packed bytes. false: it is not said. */
bool gltf_meshopt_buffer(const json_t *view, size_t *buffer);

/* Unpacks a view from that buffer, whose bytes these are, into memory that is the caller's to free. An error says no
 * more than what is wrong. */
bool gltf_meshopt_unpack(const json_t *view, const char *bytes, size_t bytes_b, void **out, size_t *out_b,
                         struct error *err);

/* From here on the view is one of so many unpacked bytes: all of another buffer. */
void gltf_meshopt_mend(json_t *view, size_t buffer);

#endif
