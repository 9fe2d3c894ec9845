/* SPDX-License-Identifier: MIT
 *
 * What accessors of a glTF 2.0 file say, read for the reference: by code of its own, apart from the importer's
 * (gltf_numbers.h), with which it shares the bytes of buffers alone. */
#ifndef SIM_SOURCE_GLTF_NUMBERS_H
#define SIM_SOURCE_GLTF_NUMBERS_H

#include "gltf/gltf_numbers.h"

struct source_numbers {
    double *values; /* count * width; owned */
    size_t count, width;
};

/* false: the accessor has another width, or leads out of its buffer. What was read is to be freed in any case. */
bool source_numbers_read(const struct gltf_file *file, const struct gltf_buffers *buffers, size_t accessor,
                         size_t width, struct source_numbers *out);
void source_numbers_free(struct source_numbers *numbers);

#endif
