/* SPDX-License-Identifier: MIT */
#include "base/binary.h"

#include "base/grow.h"
#include "base/input_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool binary_read(const char *path, size_t most_b, struct binary *out, struct error *err)
{
    size_t size_b = 0;
    FILE *file = input_open(path, most_b, &size_b, err);
    if (!file) return false;
    out->bytes = grow_zeroed(size_b, 1);
    out->size_b = fread(out->bytes, 1, size_b, file);
    bool ok = !ferror(file) || error_set(err, "%s: cannot be read", path);
    fclose(file);
    if (ok && out->size_b == 0) ok = error_set(err, "%s: the file is empty", path);
    if (!ok) free(out->bytes);
    return ok;
}
