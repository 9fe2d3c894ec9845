/* SPDX-License-Identifier: MIT
 *
 * An OBJ text written anew for the importer library: with stand-ins for vertices (vertex_table.h), plain faces, and
 * materials by number (obj.h). */
#ifndef SIM_NUMBERING_H
#define SIM_NUMBERING_H

#include "base/error.h"
#include "files/words.h"
#include "gltf/vertex_table.h"

#include <stddef.h>

struct obj;

struct numbering {
    const char *path; /* for errors */
    size_t line;      /* of what is being read, from 1 */
    char *out;        /* owned by whoever began */
    size_t out_b, out_capacity;
    struct vertex_table table;
    size_t place_count; /* of texture coordinates so far */
    struct obj *obj;
    struct error *err;
};

void numbering_write(struct numbering *work, const char *bytes, size_t size_b);
void numbering_print(struct numbering *work, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* An error that names the line, unless the word is a decimal number. */
bool numbering_parse(struct numbering *work, const struct word *word, double *value);

/* Enters a vertex and writes "a b c" for it. */
bool numbering_vertex(struct numbering *work, const double point[3]);

/* Returns false with an error, or true; then `out` is what the library is to read of the text, which obj_survey() has
 * seen. If `table` is empty there is nothing to be gained. */
bool number_obj(struct numbering *work, const char *bytes, size_t size_b);

/* Writes an f statement, of words behind it. */
bool number_face(struct numbering *work, const char *corners);

#endif
