/* SPDX-License-Identifier: MIT
 *
 * A text read line by line or word by word, and its copy, written with stand-ins for vertices (vertex_table.h). */
#ifndef SIM_NUMBERING_H
#define SIM_NUMBERING_H

#include "base/error.h"
#include "files/words.h"
#include "readers/vertex_table.h"

#include <stddef.h>

struct numbering {
    const char *path; /* for errors */
    const char *at, *end;
    size_t line; /* of `at`, from 1 */
    char *out;   /* owned by whoever began */
    size_t out_b, out_capacity;
    struct vertex_table table;
    struct error *err;
};

void numbering_write(struct numbering *work, const char *bytes, size_t size_b);

/* Takes the next `count` characters, which it writes or leaves out, and counts lines. */
void numbering_copy(struct numbering *work, size_t count);
void numbering_skip(struct numbering *work, size_t count);

/* An error that names the line, unless the word is a decimal number. */
bool numbering_parse(struct numbering *work, const struct word *word, double *value);

/* Enters a vertex and writes "a b c" for it. */
bool numbering_vertex(struct numbering *work, const double point[3]);

/* Writes a blank and the word; one that begins with its point gets a 0 in front, for libraries that would overlook it.
 */
void numbering_word(struct numbering *work, const struct word *word);

/* Returns false with an error, or true; then `out` is what the library is to read. If `table` is empty there is nothing
 * to be gained. */
bool number_obj(struct numbering *work);

#endif
