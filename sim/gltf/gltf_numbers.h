/* SPDX-License-Identifier: MIT
 *
 * What a glTF 2.0 file's accessors say, as doubles, for the importer. The reference has a reader of its own
 * (source_gltf_numbers.h). */
#ifndef SIM_GLTF_NUMBERS_H
#define SIM_GLTF_NUMBERS_H

#include "gltf/gltf_file.h"

struct gltf_buffer {
    const char *bytes;
    size_t size_b;
    void *owned; /* what of it is to be freed */
};

struct gltf_buffers {
    struct gltf_buffer *items; /* the file's, then those that were decompressed */
    size_t count, capacity;
};

struct gltf_array {
    double *values; /* count * components, owned */
    size_t count;
};

/* A list without an accessor's bytes may be all zeros: no longer than that. */
enum { GLTF_ARRAY_MOST = 1 << 23 };

/* Inside the file, beside it, or written into it as base64. Views that are compressed are decompressed, and the file's
 * JSON says where they are then. */
bool gltf_buffers_read(const char *path, const struct gltf_file *file, struct gltf_buffers *out, struct error *err);
/* Takes the buffer, and returns its index. */
size_t gltf_buffers_add(struct gltf_buffers *buffers, const struct gltf_buffer *buffer);
void gltf_buffers_free(struct gltf_buffers *buffers);

/* An accessor of so many components, sparse or normalised ones too. false: it, or what it leads to, is not there. */
bool gltf_array_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                     size_t components, struct gltf_array *out);

#endif
