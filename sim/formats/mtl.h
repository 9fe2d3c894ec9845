/* SPDX-License-Identifier: MIT
 *
 * Materials of OBJ models, as far as they say what a face looks like without light: colour, glow, opacity, pictures.
 * Source: Wavefront, Advanced Visualizer manual, appendix B1; statements and options that others added since. */
#ifndef SIM_MTL_H
#define SIM_MTL_H

#include "base/error.h"
#include "base/names.h"
#include "files/text_lines.h"

#include <stdbool.h>
#include <stddef.h>

enum mtl_picture { MTL_COLOUR, MTL_GLOW, MTL_OPACITY, MTL_PICTURES };

/* A picture, and which part of it coordinates u, v show: u scale[0] + offset[0], likewise v, which runs up. */
struct mtl_map {
    char *name; /* owned; NULL: there is none */
    double scale[2], offset[2];
    bool clamps; /* it is not repeated */
};

struct mtl_number {
    double value;
    bool is_set;
};

struct mtl_material {
    char *name;                        /* owned, without blanks at its ends; several words, perhaps none */
    struct mtl_number colour[3];       /* Kd */
    struct mtl_number glow[3];         /* Ke */
    struct mtl_number opacity;         /* d, or what Tr means */
    struct mtl_number transparency;    /* Tr */
    struct mtl_number light;           /* illum */
    struct mtl_map maps[MTL_PICTURES]; /* map_Kd, map_Ke, map_d */
};

/* Materials of all files that a model names, in their order, and what of them is not drawn, by kind. All zeros: none
 * were read. */
struct mtl {
    struct mtl_material *materials; /* of those with one name the first counts */
    size_t count, capacity;
    struct names early;       /* statements before a newmtl */
    struct names left_out;    /* statements that nothing is made of */
    struct names options;     /* of pictures, the same */
    struct names no_rgb;      /* colours that are curves or CIE XYZ */
    struct names beyond;      /* materials with colours beyond 0..1 */
    struct names black;       /* materials whose colour makes their picture black */
    struct names doubled;     /* materials that are defined twice */
    struct names contradicts; /* materials whose Tr and d say different things */
    struct names meshlab;     /* materials whose Tr is an opacity */
};

/* Adds a file's materials. An error names file and line: of what is drawn, something is no number. */
bool mtl_read(struct mtl *mtl, const char *path, const char *bytes, size_t size_b, struct error *err);

/* When all files are read: says what Tr means. */
void mtl_settle(struct mtl *mtl);

/* The picture whose part a material shows; NULL: it has none. */
const struct mtl_map *mtl_map_of(const struct mtl_material *material);

/* NULL: no file defines it. */
const struct mtl_material *mtl_find(const struct mtl *mtl, const char *name, size_t length);
void mtl_free(struct mtl *mtl);

/* A line's words of a picture: options, then its name, which may have blanks. */
bool mtl_map_read(struct mtl *mtl, struct text *line, enum mtl_picture kind, struct mtl_map *map);

#endif
