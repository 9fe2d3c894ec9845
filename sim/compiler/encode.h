/* SPDX-License-Identifier: MIT
 *
 * From the tree to the arrays of scene.h, still of any length; and the arrays' companions. */
#ifndef SIM_ENCODE_H
#define SIM_ENCODE_H

#include "base/map.h"
#include "compiler/bsp.h"
#include "compiler/encode_texture.h"
#include "scene/compiled.h"

struct encoding {
    struct lim_vertex *vertices;
    struct lim_node *nodes;
    struct lim_plane *planes;
    struct lim_plane_exact *exact;
    struct lim_box *boxes;
    lim_index *words;
    uint32_t *faces;                /* of each record */
    struct lim_fraction *fractions; /* of each vertex; NULL: there are none */
    size_t vertex_count, node_count, plane_count, exact_count, box_count, word_count, record_count;
    size_t vertex_capacity, fraction_capacity, plane_capacity, exact_capacity, word_capacity, face_capacity;
    size_t last_record; /* the word with which the newest record begins */
    struct texture_arrays textures;
    size_t depth, widest; /* nodes on the longest path; most vertices of a record */
    size_t collapsed;     /* pieces that rounding left without three corners */
};

/* Encodes a tree, with the vertices' fractions or without, with what wireframe wants to know of the edges or without.
 * Refuses one that leaves nothing to draw, or too much, saying what there is too much of, and by how much.
 * The caller frees *out either way. */
bool encode_bsp(const struct bsp *bsp, bool with_fractions, bool with_edges, struct encoding *out, struct error *err);

/* Refuses a count that does not fit 16 bits. */
bool encode_check_count(size_t count, const char *what, struct error *err);

/* Gives every subtree of SUBTREE_BOX_POLYGONS polygons or more its bounding box. */
enum { SUBTREE_BOX_POLYGONS = 4 };
void encode_boxes(struct encoding *encoding);

void encoding_free(struct encoding *encoding);

/* The bytes of a .lim file with the encoded scene, in this host's byte order, and the struct
 * lim_scene that leads into it: sets everything in *out but the report. */
void lim_image_make(const struct encoding *encoding, const struct grid *grid, struct compiled *out);

/* 0xRRGGBB to RGB565, each part to nearest. */
uint16_t rgb565_from_rgb888(uint32_t colour);

#endif
