/* SPDX-License-Identifier: MIT */
#include "whole_file.h"

#include "model_io.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool read_stream(const char *path, FILE *stream, struct whole_file *out, struct error *err)
{
    struct stat status;
    if (fstat(fileno(stream), &status)) return error_set(err, "%s: %s", path, strerror(errno));
    out->bytes = calloc(1, (size_t)status.st_size + 1);
    if (!out->bytes) return error_set(err, "%s: not enough memory", path);
    out->size_b = fread(out->bytes, 1, (size_t)status.st_size, stream);
    return !ferror(stream) || error_set(err, "%s: %s", path, strerror(errno));
}

bool whole_file_read(const char *path, struct whole_file *out, struct error *err)
{
    *out = (struct whole_file){0};
    if (!model_io_check(path, err)) return false;
    FILE *stream = fopen(path, "rb");
    if (!stream) return error_set(err, "%s: %s", path, strerror(errno));
    const bool ok = read_stream(path, stream, out, err);
    fclose(stream);
    if (!ok) whole_file_free(out);
    return ok;
}

void whole_file_free(struct whole_file *file)
{
    free(file->bytes);
    *file = (struct whole_file){0};
}

bool path_has_suffix(const char *path, const char *suffix)
{
    const size_t length = strlen(path), suffix_length = strlen(suffix);
    return length >= suffix_length && strcasecmp(path + length - suffix_length, suffix) == 0;
}
