/* SPDX-License-Identifier: MIT */
#include "files/whole_file.h"

#include "base/input_file.h"
#include "files/companion.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool read_stream(const char *path, FILE *stream, size_t size_b, struct whole_file *out, struct error *err)
{
    out->bytes = calloc(1, size_b + 1);
    if (!out->bytes) return error_set(err, "%s: not enough memory", path);
    out->size_b = fread(out->bytes, 1, size_b, stream);
    return !ferror(stream) || error_set(err, "%s: %s", path, strerror(errno));
}

bool whole_file_take(const char *name, FILE *stream, size_t size_b, struct whole_file *out, struct error *err)
{
    *out = (struct whole_file){0};
    const bool ok = read_stream(name, stream, size_b, out, err);
    fclose(stream);
    if (!ok) whole_file_free(out);
    return ok;
}

static bool take(const char *path, FILE *stream, size_t size_b, struct whole_file *out, struct error *err)
{
    *out = (struct whole_file){0};
    if (!stream) return false;
    if (size_b > 0) return whole_file_take(path, stream, size_b, out, err);
    fclose(stream);
    return error_set(err, "%s: the file is empty", path);
}

bool whole_file_read(const char *path, struct whole_file *out, struct error *err)
{
    size_t size_b = 0;
    FILE *stream = input_open(path, MODEL_FILE_MOST_B, &size_b, err);
    return take(path, stream, size_b, out, err);
}

bool whole_file_read_companion(const char *name, struct whole_file *out, struct error *err)
{
    size_t size_b = 0;
    FILE *stream = companion_open(name, MODEL_FILE_MOST_B, &size_b, err);
    return take(name, stream, size_b, out, err);
}

void whole_file_free(struct whole_file *file)
{
    free(file->bytes);
    *file = (struct whole_file){0};
}

int whole_file_mark_b(const char *text, size_t size_b)
{
    if (size_b >= WHOLE_FILE_UTF8_B && memcmp(text, "\xEF\xBB\xBF", WHOLE_FILE_UTF8_B) == 0) return WHOLE_FILE_UTF8_B;
    return size_b >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0) ? WHOLE_FILE_UTF16 : 0;
}

bool path_has_suffix(const char *path, const char *suffix)
{
    const size_t length = strlen(path), suffix_length = strlen(suffix);
    return length >= suffix_length && strcasecmp(path + length - suffix_length, suffix) == 0;
}
