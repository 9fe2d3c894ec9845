/* SPDX-License-Identifier: MIT
 *
 * Files that a command reads: regular ones, whose size is known and bounded before memory is asked for, and lines of
 * bounded length. What is opened is looked at, not its name: pipes, devices and folders neither hang nor go on forever.
 * What is opened is noted (inputs.h). */
#ifndef SIM_INPUT_FILE_H
#define SIM_INPUT_FILE_H

#include "base/error.h"

#include <stddef.h>
#include <stdio.h>

/* Opens a regular file of most_b bytes or fewer. Its size goes to *size_b (NULL: nobody wants it). NULL on error, with
 * errno: EISDIR for a folder, EINVAL for what is larger, or no file. */
FILE *input_open(const char *path, size_t most_b, size_t *size_b, struct error *err);

/* The same, but an open pipe or terminal may be named as well: "-", /dev/stdin or /dev/fd/N. To be closed with
 * input_close_stream(). */
FILE *input_open_stream(const char *path, struct error *err);
void input_close_stream(FILE *file);

/* Whether its end is there already: no pipe, and no terminal. */
bool input_is_regular(FILE *file);

struct input_lines {
    FILE *file;
    const char *path;   /* for errors */
    size_t line_most_b; /* without the newline */
    size_t number;      /* of the line that was read last, from 1 */
    char *line;         /* which is here, without its end: \n or \r\n */
    size_t length, capacity;
};

/* Reads the next line: false at the end, or with err->text not empty (which the caller empties first) on an error: a
 * longer line, a NUL byte, or the file's. */
bool input_line(struct input_lines *lines, struct error *err);
void input_lines_free(struct input_lines *lines);

#endif
