/* SPDX-License-Identifier: MIT
 *
 * The header of a PLY file: elements in their order, how many there are of each, and their properties, which are
 * numbers or lists of numbers. Source: Turk, The PLY Polygon File Format, 1994; names of colours and places in pictures
 * are those that MeshLab, Blender and CloudCompare write. */
#ifndef SIM_PLY_HEADER_H
#define SIM_PLY_HEADER_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { PLY_ELEMENTS = 32, PLY_PROPERTIES = 256, PLY_PICTURES = 64, PLY_NAME_B = 64, PLY_FILE_B = 256 };

enum ply_type { PLY_CHAR, PLY_UCHAR, PLY_SHORT, PLY_USHORT, PLY_INT, PLY_UINT, PLY_FLOAT, PLY_DOUBLE, PLY_NO_TYPE };
enum ply_coding { PLY_TEXT, PLY_LITTLE, PLY_BIG, PLY_NO_CODING };
enum ply_kind { PLY_VERTEX, PLY_FACE, PLY_STRIPS, PLY_OTHER };

/* What a property says of its element. */
enum ply_role {
    PLY_X,
    PLY_Y,
    PLY_Z,
    PLY_RED,
    PLY_GREEN,
    PLY_BLUE,
    PLY_ALPHA,
    PLY_ACROSS,  /* in a picture */
    PLY_UP,      /* the same, from its bottom */
    PLY_PICTURE, /* number of a face's picture, from 0 */
    PLY_NUMBERS, /* of roles above, each of which is a number */
    PLY_CORNERS = PLY_NUMBERS,
    PLY_PLACES, /* in a picture, of each corner */
    PLY_NO_ROLE
};

struct ply_property {
    enum ply_type type, count; /* count: of what is in front of a list; PLY_NO_TYPE: it is none */
    enum ply_role role;
};

struct ply_element {
    char name[PLY_NAME_B];
    enum ply_kind kind;
    unsigned long count;
    size_t first, properties; /* of ply_header.properties */
    unsigned roles;           /* a bit for each role that a property has */
};

struct ply_header {
    enum ply_coding coding;
    struct ply_element elements[PLY_ELEMENTS];
    struct ply_property properties[PLY_PROPERTIES];
    size_t element_count, property_count;
    char pictures[PLY_PICTURES][PLY_FILE_B]; /* that comments name: TextureFile */
    size_t picture_count;
    size_t lines, body_at_b; /* how long it is */
};

size_t ply_type_b(enum ply_type type);

/* Refuses, naming the line, what is not understood, and a file that ends within its header. */
bool ply_header_read(const char *path, const char *bytes, size_t size_b, struct ply_header *out, struct error *err);

#endif
