/* SPDX-License-Identifier: MIT
 *
 * How vertices stay double through an importer library that has float32 and parses decimals with errors of its own:
 * it is given the file with each vertex's number in place of its coordinates. What it makes of faces, materials and
 * nodes is its own work; which vertex a corner has is read off what comes back. For OBJ.
 *
 * Two things are mended on the way. The library gathers an OBJ file's faces by object, so a file that comes back to an
 * earlier object would have its faces renumbered: objects and groups are left out, they mean nothing here. And it
 * overlooks numbers that begin with a point and lines that begin with a blank. */
#ifndef SIM_VERTEX_NUMBERS_H
#define SIM_VERTEX_NUMBERS_H

#include "files/whole_file.h"
#include "readers/vertex_table.h"

/* A file as the library is to read it. */
struct vertex_numbers {
    struct whole_file file;    /* bytes == NULL: as it is on disk */
    struct vertex_table table; /* what its vertices stand for */
};

/* Refuses, naming the line: coordinates that are no decimal numbers (decimal.h), and vertices of another length than
 * the format has. Damage that the library finds, it may pass on. */
bool vertex_numbers_make(const char *path, struct vertex_numbers *out, struct error *err);
void vertex_numbers_free(struct vertex_numbers *numbers);

#endif
