/* SPDX-License-Identifier: MIT
 *
 * Scenes from bytes: whatever the bytes, the scene keeps every promise of scene.h. Its polygons are anything
 * else: neither flat nor convex nor on their planes. */
#ifndef TESTS_FUZZ_SCENE_H
#define TESTS_FUZZ_SCENE_H

#include "fuzz.h"
#include "long.h"

enum {
    FUZZ_VERTICES_MAX = 16,
    FUZZ_NODES_MAX = 10,
    FUZZ_RUN_MAX = 3,
    FUZZ_CORNERS_MAX = 9,
    FUZZ_TRIANGLES_MAX = 40,
    FUZZ_PLANE_WORDS = sizeof(struct lim_plane_ref) / sizeof(lim_index),
    FUZZ_EXTRA_WORDS = 1 + 1 + LIM_POLYGON_TEXTURE_WORDS, /* alpha, edges, texture */
    FUZZ_RECORD_WORDS = LIM_POLYGON_HEAD_WORDS + FUZZ_CORNERS_MAX + FUZZ_PLANE_WORDS + FUZZ_EXTRA_WORDS,
    FUZZ_WORDS_MAX = FUZZ_NODES_MAX * 2 * FUZZ_RUN_MAX * FUZZ_RECORD_WORDS,
    FUZZ_TEXTURES_MAX = 2,
    FUZZ_TEXTURE_BITS = 3, /* a side of 8 texels at most */
    FUZZ_TEXEL_BLOCKS = FUZZ_TEXTURES_MAX * 6,
    FUZZ_MAPPINGS_MAX = 3,
    FUZZ_PALETTE_COLOURS = 256,
    FUZZ_SIGHT_BYTES = 8
};

struct fuzz_scene {
    struct lim_scene scene; /* points into the arrays */
    struct lim_vertex vertices[FUZZ_VERTICES_MAX];
    struct lim_fraction fractions[FUZZ_VERTICES_MAX];
    struct lim_node nodes[FUZZ_NODES_MAX];
    struct lim_plane planes[FUZZ_NODES_MAX];
    struct lim_plane_exact exact[FUZZ_NODES_MAX];
    struct lim_box boxes[FUZZ_NODES_MAX];
    lim_index polygons[FUZZ_WORDS_MAX];
    struct lim_mapping mappings[FUZZ_MAPPINGS_MAX];
    struct lim_texture textures[FUZZ_TEXTURES_MAX];
    uint16_t palette[FUZZ_PALETTE_COLOURS];
    uint8_t texels[FUZZ_TEXEL_BLOCKS * LIM_TEXEL_BLOCK];
    struct lim_uv uvs[FUZZ_VERTICES_MAX];
    struct lim_place places[2 * FUZZ_NODES_MAX];
    uint8_t pvs[FUZZ_SIGHT_BYTES];
    struct lim_long all;
    struct lim_long_vertex long_vertices[FUZZ_VERTICES_MAX];
    struct lim_long_plane long_planes[FUZZ_NODES_MAX];
    struct lim_long_box long_boxes[FUZZ_NODES_MAX];
    struct lim_long_mapping long_mappings[FUZZ_MAPPINGS_MAX];
};

void fuzz_scene_make(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* Without forks: what LIM_CONVEX takes. */
void fuzz_scene_make_chain(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* With coordinates of 32 bits. */
void fuzz_scene_make_long(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* Triangles without a tree: what LIM_MESH and LIM_MESH_DEPTH take. */
void fuzz_scene_make_mesh(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* To a mesh: textures, if the bytes want them. They come last, so older inputs still mean what they meant. */
void fuzz_scene_add_places(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* To a scene with extras, likewise: textures that are masked, or skies. */
void fuzz_scene_add_kinds(struct fuzz_scene *made, struct fuzz_bytes *bytes);

/* Records with masked textures get an alpha. */
void fuzz_scene_mask(struct fuzz_scene *made);

/* Adds what not every scene has, as the bytes want it: polygons that are transparent, textured or made by the compiler
 * at some of their edges; visible sets. */
void fuzz_scene_add_extras(struct fuzz_scene *made, struct fuzz_bytes *bytes);

#endif
