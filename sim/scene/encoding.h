/* SPDX-License-Identifier: MIT
 *
 * The arrays of scene.h while they are made, still of any length; and their companions. */
#ifndef SIM_ENCODING_H
#define SIM_ENCODING_H

#include "base/error.h"
#include "long.h"

#include <stddef.h>

/* Textures and mappings. */
struct texture_arrays {
    struct lim_mapping *mappings;
    struct lim_long_mapping *long_mappings; /* of a long scene, as many; else NULL */
    struct lim_texture *textures;
    uint16_t *palettes; /* as in memory */
    uint8_t *texels;
    size_t mapping_count, texture_count, palette_colours, texel_count;
    size_t mapping_capacity, long_mapping_capacity, texture_capacity, palette_capacity, texel_capacity;
};

struct encoding {
    bool is_long;                          /* then these are its vertices, planes and boxes: firmware/long.h */
    struct lim_long_vertex *long_vertices; /* counted, like the others, by vertex_count and so on */
    struct lim_long_plane *long_planes;
    struct lim_long_box *long_boxes;
    struct lim_vertex *vertices;
    struct lim_node *nodes;
    struct lim_plane *planes;
    struct lim_plane_exact *exact;
    struct lim_box *boxes;
    lim_index *words;
    uint32_t *faces;                /* of each record */
    struct lim_fraction *fractions; /* of each vertex; NULL: there are none */
    struct lim_uv *uvs;             /* of each vertex of a mesh with textures; else NULL */
    size_t vertex_count, node_count, plane_count, exact_count, box_count, word_count, record_count;
    size_t vertex_capacity, fraction_capacity, uv_capacity, plane_capacity, exact_capacity, word_capacity,
        face_capacity;
    size_t last_record; /* the word with which the newest record begins */
    struct texture_arrays textures;
    size_t depth, widest;                /* nodes on the longest path; most vertices of a record */
    size_t leaf_vertices, leaf_polygons; /* most of any mesh leaf */
    size_t collapsed;                    /* pieces that rounding left without three corners */
    uint16_t background;                 /* RGB565 as a number */
};

/* Gives every subtree of SUBTREE_BOX_POLYGONS polygons or more, and every mesh leaf, its bounding box; a mesh has one
 * of all of it. */
enum { SUBTREE_BOX_POLYGONS = 4 };
void encode_boxes(struct encoding *encoding);

/* Refuses a count that does not fit 16 bits. */
bool encoding_check_count(size_t count, const char *what, struct error *err);

void texture_arrays_free(struct texture_arrays *arrays);
void encoding_free(struct encoding *encoding);

#endif
