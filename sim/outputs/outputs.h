/* SPDX-License-Identifier: MIT
 *
 * The files that a command writes: all of them or none. Each is written beside its place as NAME.WORD-NUMBER.part,
 * and takes its place when the command has succeeded; folders are made as needed. A signal that ends the process
 * removes what is not in its place yet (ending.h). A file has the permissions that fopen() would give or leave it; a
 * link in its place stays, and the file that it names is written. */
#ifndef SIM_OUTPUTS_H
#define SIM_OUTPUTS_H

#include "base/error.h"

#include <stddef.h>
#include <stdio.h>

struct output_path; /* of a file or folder */
struct output_run;

struct outputs {
    struct output_path *paths; /* in the order of their making */
    size_t count;
    struct output_run *run; /* NULL: nothing is begun */
};

/* Begins a file, its folders included; NULL on error. Devices and pipes are opened as they are. A
 * file of which two outputs are named, however its path is spelled, or that has been read (inputs.h), is refused. */
FILE *outputs_open(struct outputs *outputs, const char *path, struct error *err);

/* Closes a file of outputs_open(); what could not be written is an error. */
bool outputs_close(FILE *file, const char *path, struct error *err);

/* Output `index` < count, closed, to be read before it is in its place; *path: where that is, NULL for a folder. NULL:
 * it is one, or cannot be read. */
FILE *outputs_reread(const struct outputs *outputs, size_t index, const char **path);

/* Refuses to go on if one of the files to be written has been read since it was begun. outputs_keep() asks, too; who
 * has much to do before that asks early. */
bool outputs_check(const struct outputs *outputs, struct error *err);

/* Puts every file in its place, says so (written.h) and frees the list. */
bool outputs_keep(struct outputs *outputs, struct error *err);

/* The same, but the caller says so: `text` has WRITTEN_B bytes. */
bool outputs_keep_untold(struct outputs *outputs, char *text, struct error *err);

/* Removes every file and folder made, and frees the list. */
void outputs_discard(struct outputs *outputs);

/* A pattern with exactly one %d, %5d or %05d becomes the path of a numbered file; `path` holds
 * size bytes. Anything else is refused. */
bool output_pattern_check(const char *pattern, struct error *err);

/* A name without %: that of one file. output_pattern_path() gives it to number 0. */
bool output_is_one(const char *pattern);
bool output_pattern_path(const char *pattern, size_t number, char *path, size_t size, struct error *err);

#endif
