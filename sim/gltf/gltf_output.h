/* SPDX-License-Identifier: MIT
 *
 * The fresh buffer of a plain glTF file (gltf_plain.h), and the accessors and views that describe it. */
#ifndef SIM_GLTF_OUTPUT_H
#define SIM_GLTF_OUTPUT_H

#include "files/whole_file.h"

#include <jansson.h>

struct gltf_output {
    char *bytes;
    size_t size_b, capacity_b;
    json_t *accessors, *views; /* arrays, owned until gltf_output_write() */
};

void gltf_output_begin(struct gltf_output *out);

/* Returns the view's index. */
size_t gltf_output_view(struct gltf_output *out, const void *bytes, size_t size_b);

/* Lists of float32, 1 to 4 to an element, or of uint32. They return the accessor's index. */
size_t gltf_output_floats(struct gltf_output *out, const float *values, size_t count, size_t components);
size_t gltf_output_indices(struct gltf_output *out, const double *values, size_t count);

/* An accessor that is described elsewhere: of what the library unpacks. */
size_t gltf_output_accessor(struct gltf_output *out, json_t *taken);

/* Puts all that into the root, and both into a .glb. false: out of memory. */
bool gltf_output_write(struct gltf_output *out, json_t *root, struct whole_file *glb);
void gltf_output_free(struct gltf_output *out);

#endif
