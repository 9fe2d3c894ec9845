/* SPDX-License-Identifier: MIT
 *
 * Records are written anew with what is added to them; runs move, and nodes follow them. */
#include "fuzz_scene.h"

#include <stdlib.h>
#include <string.h>

enum {
    ALPHA_MAX = 254,
    SUM_MAX = 32767,
    EDGES_ONE_WORD = 16,
    PLACE_BITS_MAX = 15,
    EVEN_MOST = 127,
    SKY_TIMES_MAX = 16
};

/* Textures ----------------------------------------------------------------------------------- */

static void make_textures(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct lim_scene *scene = &made->scene;
    uint16_t blocks = 0;

    for (uint16_t i = 0; i < scene->texture_count; i++) {
        struct lim_texture *texture = &made->textures[i];
        size_t texels = 0;
        *texture = (struct lim_texture){.texels = blocks, .w_bits = fuzz_below(bytes, FUZZ_TEXTURE_BITS + 1)};
        texture->h_bits = fuzz_below(bytes, texture->w_bits + 1u);
        texture->levels = (uint8_t)(1 + fuzz_below(bytes, texture->h_bits + 1u));
        for (unsigned level = 0; level < texture->levels; level++)
            texels += (size_t)1 << (texture->w_bits + texture->h_bits - 2 * level);
        blocks = (uint16_t)(blocks + (texels + LIM_TEXEL_BLOCK - 1) / LIM_TEXEL_BLOCK);
    }
    scene->texel_blocks = blocks;
    const uint8_t first = fuzz_u8(bytes);
    for (size_t i = 0; i < (size_t)blocks * LIM_TEXEL_BLOCK; i++)
        made->texels[i] = (uint8_t)(first + 37 * i);
    for (uint16_t i = 0; i < FUZZ_PALETTE_COLOURS; i++)
        made->palette[i] = (uint16_t)(257 * i);
    scene->palette_colours = FUZZ_PALETTE_COLOURS;
}

static void make_vector(struct fuzz_bytes *bytes, int16_t v[2])
{
    for (int i = 0; i < 2; i++) {
        v[i] = (int16_t)fuzz_u16(bytes);
        if (v[i] == INT16_MIN) v[i] = INT16_MAX;
    }
    while (abs(v[0]) + abs(v[1]) > SUM_MAX)
        for (int i = 0; i < 2; i++)
            v[i] /= 2;
}

static void make_long_vector(struct fuzz_bytes *bytes, int32_t v[2])
{
    for (int i = 0; i < 2; i++)
        v[i] = (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);
    while (llabs(v[0]) + llabs(v[1]) > LIM_LONG_UV_MAX)
        for (int i = 0; i < 2; i++)
            v[i] /= 2;
}

/* What a mapping has beside, in a long scene. */
static void make_long_mapping(struct fuzz_bytes *bytes, struct lim_long_mapping *mapping)
{
    for (int i = 0; i < 2; i++)
        make_long_vector(bytes, mapping->uv[i]);
    mapping->bits =
        (uint8_t)(LIM_LONG_UV_BITS_MIN + fuzz_below(bytes, LIM_LONG_UV_BITS_MAX - LIM_LONG_UV_BITS_MIN + 1));
    mapping->level_q4 = (int16_t)((int16_t)fuzz_u16(bytes) % (LIM_LONG_LEVEL_MAX_Q4 + 1));
}

/* Through a vertex, or in a plane of the tree, whether that has the polygon in it or not. */
static void make_mapping(struct fuzz_scene *made, struct fuzz_bytes *bytes, struct lim_mapping *mapping)
{
    const lim_index vertex = fuzz_below(bytes, made->scene.vertex_count);
    const struct lim_vertex *through = &made->vertices[vertex];
    const int16_t at[3] = {through->x, through->y, through->z};
    const uint8_t wanted = fuzz_u8(bytes), axis = (uint8_t)((wanted >> 5) % 3);
    const bool upright = !made->scene.plane_count || wanted & 1;

    mapping->plane =
        upright ? (lim_index)(lim_offset)at[axis] : (lim_index)(wanted % made->scene.plane_count) * LIM_PLANE_WORDS;
    mapping->scale = (uint8_t)(axis << LIM_MAPPING_AXIS_SHIFT | (upright ? LIM_MAPPING_UPRIGHT : 0) |
                               fuzz_below(bytes, LIM_MAPPING_BITS + 1));
    mapping->level_q3 = (int8_t)fuzz_u8(bytes);
    for (int i = 0; i < 2; i++) {
        make_vector(bytes, mapping->uv[i]);
        mapping->at_zero_q16[i] = fuzz_u16(bytes);
    }
    if (!lim_scene_long(&made->scene)) return;
    mapping->plane = upright ? vertex : (lim_index)(wanted % made->scene.plane_count);
    make_long_mapping(bytes, &made->long_mappings[mapping - made->mappings]);
}

/* Records ------------------------------------------------------------------------------------ */

/* A record with more than it had, at *to. Returns the word behind it. */
static lim_index *add_to_record(struct fuzz_scene *made, struct fuzz_bytes *bytes, const lim_index *from, lim_index *to)
{
    struct lim_scene *scene = &made->scene;
    const uint16_t words = lim_record_words(from[0]);
    const lim_index count = from[0] & LIM_POLYGON_COUNT;
    const uint8_t wanted = fuzz_u8(bytes);
    lim_index *const head = to;

    memcpy(to, from, words * sizeof *to);
    to += words;
    if (wanted & 1) {
        *head |= LIM_POLYGON_ALPHA;
        *to++ = (lim_index)(1 + fuzz_below(bytes, ALPHA_MAX));
        if (!scene->limits.layers) scene->limits.layers = 1;
    }
    if (wanted & 2 && count <= EDGES_ONE_WORD) {
        *head |= LIM_POLYGON_EDGES;
        *to++ = fuzz_u8(bytes) & ((1u << count) - 1);
    }
    if (wanted & 4 && !(wanted & 1) && scene->texture_count) {
        *head |= LIM_POLYGON_TEXTURE;
        *to++ = fuzz_below(bytes, scene->texture_count);
        *to++ = fuzz_below(bytes, scene->mapping_count);
    }
    return to;
}

static lim_index add_to_run(struct fuzz_scene *made, struct fuzz_bytes *bytes, const lim_index *from)
{
    const lim_index run = made->scene.polygon_words;
    lim_index *to = &made->polygons[run];

    for (bool last = false; !last; from += lim_record_words(*from)) {
        last = *from & LIM_POLYGON_LAST;
        to = add_to_record(made, bytes, from, to);
    }
    made->scene.polygon_words = (lim_index)(to - made->polygons);
    return run;
}

static void add_to_records(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    lim_index polygons[FUZZ_WORDS_MAX];

    memcpy(polygons, made->polygons, sizeof polygons);
    made->scene.polygon_words = 0;
    for (lim_index i = 0; i < made->scene.node_count; i++) {
        struct lim_node *node = &made->nodes[i];
        if (node->front_run != LIM_NO_INDEX) node->front_run = add_to_run(made, bytes, polygons + node->front_run);
        if (node->back_run != LIM_NO_INDEX) node->back_run = add_to_run(made, bytes, polygons + node->back_run);
    }
}

/* Sights ------------------------------------------------------------------------------------- */

static bool has_leaf(const struct lim_scene *scene)
{
    for (lim_index i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].split.plane == LIM_NO_INDEX) return true;
    return false;
}

/* A bit a box: as many bytes in a row, of which the first zero ends what is looked at. */
static void make_pvs(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct lim_scene *scene = &made->scene;
    const uint16_t size_b = (uint16_t)((scene->box_count + 7) / 8);

    if (!scene->box_count || has_leaf(scene)) return;
    scene->pvs_bytes = (uint16_t)(2 * size_b);
    for (uint16_t i = 0; i < scene->pvs_bytes; i++) {
        const uint8_t bits = fuzz_u8(bytes);
        made->pvs[i] = bits ? bits : 1;
    }
    const uint8_t every = (uint8_t)(1 + fuzz_below(bytes, 4));
    for (uint16_t cell = 0; cell < 2 * scene->node_count; cell = (uint16_t)(cell + every)) {
        const struct lim_node *node = &made->nodes[cell / 2];
        if ((cell % 2 ? node->back : node->front) != LIM_NO_INDEX) continue; /* the tree goes on: no cell */
        const uint8_t pvs = fuzz_below(bytes, 3);
        made->places[scene->place_count++] =
            (struct lim_place){cell, pvs == 2 ? (uint16_t)LIM_NONE : (uint16_t)(pvs * size_b)};
    }
}

void fuzz_scene_add_extras(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct lim_scene *scene = &made->scene;
    const uint8_t wanted = fuzz_u8(bytes);

    scene->mappings = made->mappings;
    made->all.mappings = made->long_mappings;
    scene->textures = made->textures;
    scene->palettes = made->palette;
    scene->texels = made->texels;
    scene->places = made->places;
    scene->pvs = made->pvs;
    const uint8_t layers = fuzz_u8(bytes);
    scene->limits.pieces = fuzz_u8(bytes);
    if (wanted & 1) {
        scene->texture_count = (uint16_t)(1 + fuzz_below(bytes, FUZZ_TEXTURES_MAX));
        scene->mapping_count = (uint16_t)(1 + fuzz_below(bytes, FUZZ_MAPPINGS_MAX));
        make_textures(made, bytes);
        for (uint16_t i = 0; i < scene->mapping_count; i++)
            make_mapping(made, bytes, &made->mappings[i]);
    }
    if (wanted & 2) add_to_records(made, bytes);
    if (scene->limits.layers) scene->limits.layers = (uint16_t)(1 + layers);
    if (wanted & 4) make_pvs(made, bytes);
}

/* Textures of meshes ------------------------------------------------------------------------- */

void fuzz_scene_add_places(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct lim_scene *scene = &made->scene;

    if (!fuzz_below(bytes, 2)) return;
    scene->textures = made->textures;
    scene->palettes = made->palette;
    scene->texels = made->texels;
    *scene->uvs = made->uvs;
    scene->texture_count = (uint16_t)(1 + fuzz_below(bytes, FUZZ_TEXTURES_MAX));
    make_textures(made, bytes);
    for (uint16_t i = 0; i < scene->texture_count; i++)
        made->textures[i].place_bits = fuzz_below(bytes, PLACE_BITS_MAX + 1);
    for (lim_index i = 0; i < scene->vertex_count; i++) {
        const uint8_t smaller = fuzz_below(bytes, 16);
        made->uvs[i].u = (int16_t)((int16_t)fuzz_u16(bytes) / 2 >> smaller);
        made->uvs[i].v = (int16_t)((int16_t)fuzz_u16(bytes) / 2 >> smaller);
    }
    for (lim_index i = 0; i < scene->polygon_count; i++)
        made->polygons[(i + 1) * LIM_TRIANGLE_WORDS - 1] =
            (lim_index)(fuzz_below(bytes, scene->texture_count) | fuzz_below(bytes, EVEN_MOST + 1)
                                                                      << LIM_TRIANGLE_TEXTURE_BITS);
}

/* Masked textures and skies ------------------------------------------------------------------ */

/* A record with a masked texture has an alpha. */
static lim_index *mask_record(struct fuzz_scene *made, const lim_index *from, lim_index *to)
{
    const uint16_t words = lim_record_words(from[0]), alpha_at = lim_record_edges_at(from[0]);
    const bool is_textured = from[0] & LIM_POLYGON_TEXTURE;

    memcpy(to, from, words * sizeof *to);
    if (!is_textured || !lim_texture_is_masked(&made->textures[from[words - LIM_POLYGON_TEXTURE_WORDS]]))
        return to + words;
    to[0] |= LIM_POLYGON_ALPHA;
    to[alpha_at] = ALPHA_MAX;
    memcpy(to + alpha_at + 1, from + alpha_at, (size_t)(words - alpha_at) * sizeof *to);
    if (!made->scene.limits.layers) made->scene.limits.layers = 1;
    return to + words + 1;
}

static lim_index mask_run(struct fuzz_scene *made, const lim_index *from)
{
    const lim_index run = made->scene.polygon_words;
    lim_index *to = &made->polygons[run];

    for (bool last = false; !last; from += lim_record_words(*from)) {
        last = *from & LIM_POLYGON_LAST;
        to = mask_record(made, from, to);
    }
    made->scene.polygon_words = (lim_index)(to - made->polygons);
    return run;
}

void fuzz_scene_mask(struct fuzz_scene *made)
{
    lim_index polygons[FUZZ_WORDS_MAX];

    memcpy(polygons, made->polygons, sizeof polygons);
    made->scene.polygon_words = 0;
    for (lim_index i = 0; i < made->scene.node_count; i++) {
        struct lim_node *node = &made->nodes[i];
        if (node->front_run != LIM_NO_INDEX) node->front_run = mask_run(made, polygons + node->front_run);
        if (node->back_run != LIM_NO_INDEX) node->back_run = mask_run(made, polygons + node->back_run);
    }
}

void fuzz_scene_add_kinds(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    static const uint8_t kinds[] = {0, LIM_TEXTURE_MASKED, LIM_TEXTURE_SKY, 0};
    const uint8_t wanted = fuzz_u8(bytes);

    if (!wanted) return;
    for (uint16_t i = 0; i < made->scene.texture_count; i++)
        made->textures[i].place_bits = kinds[wanted >> 2 * i & 3];
    for (uint16_t i = 0; i < made->scene.mapping_count && wanted & 0x80; i++) {
        made->mappings[i].uv[0][0] = (int16_t)(1 + fuzz_below(bytes, SKY_TIMES_MAX));
        made->mappings[i].uv[0][1] = 0;
    }
    for (uint16_t i = 0; i < made->scene.texture_count && !(wanted & 0x80); i++)
        if (made->textures[i].place_bits == LIM_TEXTURE_SKY) made->textures[i].place_bits = 0;
    fuzz_scene_mask(made);
}
