/* SPDX-License-Identifier: MIT */
#include "binary.h"

#include "grow.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A byte more than may be there is asked for, to see whether it is. */
bool binary_read(const char *path, size_t most_b, struct binary *out, struct error *err)
{
    FILE *file = fopen(path, "rb");
    if (!file) return error_set(err, "%s: %s", path, strerror(errno));
    out->bytes = grow_zeroed(most_b + 1, 1);
    out->size_b = fread(out->bytes, 1, most_b + 1, file);
    bool ok = !ferror(file) || error_set(err, "%s: cannot be read", path);
    fclose(file);
    if (ok && out->size_b == 0) ok = error_set(err, "%s: the file is empty", path);
    if (ok && out->size_b > most_b) ok = error_set(err, "%s: more than %zu bytes", path, most_b);
    if (!ok) free(out->bytes);
    return ok;
}
