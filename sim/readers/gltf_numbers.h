/* SPDX-License-Identifier: MIT
 *
 * What a glTF 2.0 file's accessors say, as doubles, for the reference's reader. */
#ifndef SIM_GLTF_NUMBERS_H
#define SIM_GLTF_NUMBERS_H

#include "readers/gltf_file.h"

struct gltf_buffer {
    const char *bytes;
    size_t size_b;
    void *owned; /* what of it is to be freed */
};

struct gltf_buffers {
    struct gltf_buffer *items;
    size_t count;
};

struct gltf_array {
    double *values; /* count * components, owned */
    size_t count;
};

/* Inside the file, beside it, or written into it as base64. */
bool gltf_buffers_read(const char *path, const struct gltf_file *file, struct gltf_buffers *out, struct error *err);
void gltf_buffers_free(struct gltf_buffers *buffers);

/* An accessor of so many components, sparse or normalised ones too. false: it, or what it leads to, is not there. */
bool gltf_array_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                     size_t components, struct gltf_array *out);

#endif
