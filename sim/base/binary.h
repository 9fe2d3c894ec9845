/* SPDX-License-Identifier: MIT
 *
 * A file of bytes, read as a whole. */
#ifndef SIM_BINARY_H
#define SIM_BINARY_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>

struct binary {
    uint8_t *bytes; /* to be freed */
    size_t size_b;
};

/* An empty file, or one of more than most_b, is refused. */
bool binary_read(const char *path, size_t most_b, struct binary *out, struct error *err);

#endif
