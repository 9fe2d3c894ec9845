/* SPDX-License-Identifier: MIT
 *
 * How vertices stay double through an importer library that has float32 and parses decimals with errors of its own:
 * it is given the file with each vertex's number in place of its coordinates. Which vertex a corner has is read off
 * what comes back. For OBJ.
 *
 * The file is written anew, and its materials as well, with nothing in them but what is drawn: the library takes words
 * that it does not know for others, overlooks some, and crashes at statements where it expects none. */
#ifndef SIM_VERTEX_NUMBERS_H
#define SIM_VERTEX_NUMBERS_H

#include "files/whole_file.h"
#include "gltf/vertex_table.h"
#include "readers/obj.h"

/* A file as the library is to read it. */
struct vertex_numbers {
    struct whole_file file;      /* bytes == NULL: as it is on disk */
    struct whole_file materials; /* OBJ_MATERIALS */
    struct vertex_table table;   /* what its vertices stand for */
    struct obj obj;              /* what else it says */
};

/* Refuses, naming the line: coordinates that are no decimal numbers (decimal.h), and vertices of another length than
 * the format has. Damage that the library finds, it may pass on. */
bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err);
void vertex_numbers_free(struct vertex_numbers *numbers);

#endif
