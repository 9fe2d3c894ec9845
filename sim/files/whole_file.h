/* SPDX-License-Identifier: MIT
 *
 * A file's bytes in memory, with a 0 behind them, so that numbers at the very end can be parsed. */
#ifndef SIM_WHOLE_FILE_H
#define SIM_WHOLE_FILE_H

#include "base/error.h"

#include <stddef.h>
#include <stdio.h>

enum { MODEL_FILE_MOST_B = 256 << 20 };

struct whole_file {
    char *bytes; /* size_b of them, then a 0; owned */
    size_t size_b;
};

/* Refuses what is missing, a folder, empty, a pipe, or larger than 256 MB. An error names the file. */
bool whole_file_read(const char *path, struct whole_file *out, struct error *err);

/* The same from a stream of so many bytes, which it closes; an error calls it `name`. Nothing is refused. */
bool whole_file_take(const char *name, FILE *stream, size_t size_b, struct whole_file *out, struct error *err);

/* As whole_file_read() for what a model names, after companions_begin(). */
bool whole_file_read_companion(const char *name, struct whole_file *out, struct error *err);
void whole_file_free(struct whole_file *file);

/* How many bytes in front of a text say that it is UTF-8; or that it is UTF-16, which is left to libraries. */
enum { WHOLE_FILE_UTF8_B = 3, WHOLE_FILE_UTF16 = -1 };
int whole_file_mark_b(const char *text, size_t size_b);

/* Whether a path ends like that, in capitals or not; the suffix has its dot. */
bool path_has_suffix(const char *path, const char *suffix);

#endif
