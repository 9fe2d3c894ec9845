/* SPDX-License-Identifier: MIT
 *
 * Layout of .lim images, and the turning of their bytes on big-endian hosts. The file's structs
 * are scene.h's, so their sizes and offsets are part of the format and are asserted here. */
#include "scene/lim_image.h"

#include "base/grow.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/* No text, and damaged by whatever turns line ends: the idea of PNG's signature. */
const unsigned char lim_file_magic[LIM_FILE_MAGIC_B] = {0x89, 'L', 'I', 'M', '\r', '\n', 0x1A, '\n'};

static_assert(sizeof(struct lim_file_header) == 152, "header");
static_assert(offsetof(struct lim_file_header, crc32) + 4 == LIM_FILE_CRC_FROM_B, "header");
static_assert(offsetof(struct lim_file_header, units_per_m) == 24, "header");
static_assert(offsetof(struct lim_file_header, counts) == 56, "header");
static_assert(offsetof(struct lim_file_header, limits) == 118, "header");
static_assert(offsetof(struct lim_file_header, deep_from) == 136, "header");
static_assert(offsetof(struct lim_file_header, coordinate_bits) == 144, "header");
static_assert(sizeof(struct lim_vertex) == 6, "vertex");
static_assert(sizeof(struct lim_fraction) == 3, "fraction");
static_assert(sizeof(struct lim_uv) == 4, "place of a vertex");
static_assert(sizeof(struct lim_node) == 28, "node");
static_assert(offsetof(struct lim_node, box) == 24, "node");
static_assert(sizeof(struct lim_plane) == 16, "plane");
static_assert(offsetof(struct lim_plane, exact) == 12, "plane");
static_assert(sizeof(struct lim_plane_exact) == 20, "exact plane");
static_assert(offsetof(struct lim_plane_exact, d_lo) == 16, "exact plane");
static_assert(sizeof(struct lim_box) == 12, "box");
static_assert(sizeof(struct lim_long_vertex) == 12, "vertex of 32 bits");
static_assert(sizeof(struct lim_long_plane) == 20, "plane of 32 bits");
static_assert(sizeof(struct lim_long_box) == 24, "box of 32 bits");
static_assert(sizeof(struct lim_long_mapping) == 20, "mapping of 32 bits");
static_assert(offsetof(struct lim_long_mapping, bits) == 18, "mapping of 32 bits");
static_assert(sizeof(struct lim_mapping) == 20, "mapping");
static_assert(offsetof(struct lim_mapping, level_q3) == 16, "mapping");
static_assert(sizeof(struct lim_texture) == 8, "texture");
static_assert(sizeof(struct lim_place) == 4, "place");
static_assert(sizeof(struct lim_limits) == sizeof((struct lim_file_header *)0)->limits, "limits");

/* Element size of a section, and the widths of its fields in bytes, as a repeating pattern. */
struct element {
    size_t size_b;
    const char *fields;
};

static const struct element SECTIONS[SECTION_COUNT] = {
    [SECTION_VERTICES] = {sizeof(struct lim_vertex), "2"},
    [SECTION_NODES] = {sizeof(struct lim_node), "4"},
    [SECTION_PLANES] = {sizeof(struct lim_plane), "4"},
    [SECTION_EXACT] = {sizeof(struct lim_plane_exact), "4"},
    [SECTION_BOXES] = {sizeof(struct lim_box), "2"},
    [SECTION_POLYGONS] = {sizeof(lim_index), "4"},
    [SECTION_FACES] = {sizeof(uint32_t), "4"},
    [SECTION_FRACTIONS] = {sizeof(struct lim_fraction), "1"},
    [SECTION_UVS] = {sizeof(struct lim_uv), "2"},
    [SECTION_MAPPINGS] = {sizeof(struct lim_mapping), "2222224112"},
    [SECTION_TEXTURES] = {sizeof(struct lim_texture), "221111"},
    [SECTION_PALETTES] = {sizeof(uint16_t), "1"}, /* as in memory, the same on every host */
    [SECTION_TEXELS] = {LIM_TEXEL_BLOCK, "1"},
    [SECTION_PLACES] = {sizeof(struct lim_place), "2"},
    [SECTION_PVS] = {sizeof(uint8_t), "1"},
};
static const struct element LONG_SECTIONS[SECTION_COUNT] = {
    [SECTION_VERTICES] = {sizeof(struct lim_long_vertex), "4"},
    [SECTION_PLANES] = {sizeof(struct lim_long_plane), "4"},
    [SECTION_BOXES] = {sizeof(struct lim_long_box), "4"},
    [SECTION_UVS] = {sizeof(struct lim_long_mapping), "4444211"},
};
static const char HEADER_FIELDS[] = "11111111"
                                    "4444"
                                    "8888"
                                    "444444444444444"
                                    "2"
                                    "222222222"
                                    "4444";

static bool has_32_bits(const struct lim_file_header *header)
{
    return header->coordinate_bits == 32;
}

static const struct element *element_of(const struct lim_file_header *header, enum lim_section section)
{
    return has_32_bits(header) && LONG_SECTIONS[section].size_b ? &LONG_SECTIONS[section] : &SECTIONS[section];
}

static uint64_t align_b(uint64_t size_b)
{
    return (size_b + LIM_FILE_ALIGN_B - 1) / LIM_FILE_ALIGN_B * LIM_FILE_ALIGN_B;
}

uint64_t lim_image_section_b(const struct lim_file_header *header, enum lim_section section)
{
    uint64_t at_b = sizeof *header;
    for (int i = 0; i < (int)section; i++)
        at_b += align_b((uint64_t)header->counts[i] * element_of(header, (enum lim_section)i)->size_b);
    return at_b;
}

uint64_t lim_image_section_end_b(const struct lim_file_header *header, enum lim_section section)
{
    return lim_image_section_b(header, section) +
           (uint64_t)header->counts[section] * element_of(header, section)->size_b;
}

static void *section_at(void *image, enum lim_section section)
{
    return (unsigned char *)image + lim_image_section_b(image, section);
}

/* The sections are those of scene.h by name alone. */
static void bind_long(void *image, struct compiled *scene)
{
    if (!scene->of_32_bits) scene->of_32_bits = grow_zeroed(1, sizeof *scene->of_32_bits);
    *scene->of_32_bits = (struct lim_long){.vertices = section_at(image, SECTION_VERTICES),
                                           .planes = section_at(image, SECTION_PLANES),
                                           .boxes = section_at(image, SECTION_BOXES),
                                           .fractions = scene->scene.fractions,
                                           .mappings = section_at(image, SECTION_UVS)};
    *scene->scene.uvs = NULL;
    scene->scene.vertices = NULL;
    scene->scene.planes = NULL;
    scene->scene.boxes = NULL;
    *scene->scene.of_32_bits = scene->of_32_bits;
}

void lim_image_bind(void *image, struct compiled *scene)
{
    const struct lim_file_header *header = image;
    scene->image = image;
    scene->image_b = header->file_b;
    scene->grid.units_per_m = header->units_per_m;
    scene->grid.is_long = has_32_bits(header);
    memcpy(scene->grid.origin_m, header->origin_m, sizeof scene->grid.origin_m);
    scene->faces = section_at(image, SECTION_FACES);
    scene->scene = (struct lim_scene){
        .vertices = section_at(image, SECTION_VERTICES),
        .nodes = section_at(image, SECTION_NODES),
        .planes = section_at(image, SECTION_PLANES),
        .exact = section_at(image, SECTION_EXACT),
        .boxes = section_at(image, SECTION_BOXES),
        .polygons = section_at(image, SECTION_POLYGONS),
        .fractions = header->counts[SECTION_FRACTIONS] ? section_at(image, SECTION_FRACTIONS) : NULL,
        .places = header->counts[SECTION_PLACES] ? section_at(image, SECTION_PLACES) : NULL,
        .pvs = header->counts[SECTION_PVS] ? section_at(image, SECTION_PVS) : NULL,
        .place_count = (uint16_t)header->counts[SECTION_PLACES],
        .pvs_bytes = (uint16_t)header->counts[SECTION_PVS],
        .vertex_count = header->counts[SECTION_VERTICES],
        .node_count = header->counts[SECTION_NODES],
        .plane_count = header->counts[SECTION_PLANES],
        .exact_count = header->counts[SECTION_EXACT],
        .box_count = header->counts[SECTION_BOXES],
        .polygon_words = header->counts[SECTION_POLYGONS],
        .polygon_count = header->counts[SECTION_FACES],
        .background = header->background,
        .deep_from = {header->deep_from},
        .near_deep_from = {header->near_deep_from},
        .uvs = {header->counts[SECTION_UVS] ? section_at(image, SECTION_UVS) : NULL},
    };
    if (has_32_bits(header)) bind_long(image, scene);
    memcpy(&scene->scene.limits, header->limits, sizeof scene->scene.limits);
    scene->scene.mappings = section_at(image, SECTION_MAPPINGS);
    scene->scene.textures = section_at(image, SECTION_TEXTURES);
    scene->scene.palettes = section_at(image, SECTION_PALETTES);
    scene->scene.texels = section_at(image, SECTION_TEXELS);
    scene->scene.mapping_count = (uint16_t)header->counts[SECTION_MAPPINGS];
    scene->scene.texture_count = (uint16_t)header->counts[SECTION_TEXTURES];
    scene->scene.palette_colours = (uint16_t)header->counts[SECTION_PALETTES];
    scene->scene.texel_blocks = (uint16_t)header->counts[SECTION_TEXELS];
}

static size_t uvs_of(const struct encoding *encoding)
{
    if (encoding->is_long) return encoding->textures.mapping_count;
    return encoding->uvs ? encoding->vertex_count : 0;
}

static struct lim_file_header header_of(const struct encoding *encoding, const struct grid *grid)
{
    const struct texture_arrays *textures = &encoding->textures;
    const size_t counts[SECTION_COUNT] = {encoding->vertex_count,
                                          encoding->node_count,
                                          encoding->plane_count,
                                          encoding->exact_count,
                                          encoding->box_count,
                                          encoding->word_count,
                                          encoding->record_count,
                                          encoding->fractions ? encoding->vertex_count : 0,
                                          uvs_of(encoding),
                                          textures->mapping_count,
                                          textures->texture_count,
                                          textures->palette_colours,
                                          textures->texel_count / LIM_TEXEL_BLOCK};
    const struct lim_limits limits = {.depth = (uint16_t)encoding->depth,
                                      .vertices = (uint16_t)encoding->widest,
                                      .leaf_vertices = (uint16_t)encoding->leaf_vertices,
                                      .leaf_polygons = (uint16_t)encoding->leaf_polygons};
    struct lim_file_header header = {.version = LIM_FILE_VERSION, .header_b = sizeof header};
    memcpy(header.magic, lim_file_magic, sizeof header.magic);
    header.units_per_m = grid->units_per_m;
    header.coordinate_bits = encoding->is_long ? 32 : 16;
    header.background = encoding->background;
    header.deep_from = header.near_deep_from = encoding->node_count ? 0 : (uint32_t)encoding->record_count;
    memcpy(header.origin_m, grid->origin_m, sizeof header.origin_m);
    for (int i = 0; i < SECTION_COUNT; i++)
        header.counts[i] = (uint32_t)counts[i];
    memcpy(header.limits, &limits, sizeof header.limits);
    header.file_b = (uint32_t)lim_image_section_b(&header, SECTION_COUNT);
    return header;
}

void lim_image_make(const struct encoding *encoding, const struct grid *grid, struct compiled *out)
{
    const struct lim_file_header header = header_of(encoding, grid);
    const struct texture_arrays *textures = &encoding->textures;
    const bool is_long = encoding->is_long;
    const void *sections[SECTION_COUNT] = {is_long ? (const void *)encoding->long_vertices : encoding->vertices,
                                           encoding->nodes,
                                           is_long ? (const void *)encoding->long_planes : encoding->planes,
                                           encoding->exact,
                                           is_long ? (const void *)encoding->long_boxes : encoding->boxes,
                                           encoding->words,
                                           encoding->faces,
                                           encoding->fractions,
                                           is_long ? (const void *)textures->long_mappings : encoding->uvs,
                                           textures->mappings,
                                           textures->textures,
                                           textures->palettes,
                                           textures->texels};
    unsigned char *image = grow_zeroed(header.file_b, 1);
    memcpy(image, &header, sizeof header);
    for (int i = 0; i < SECTION_COUNT; i++)
        if (header.counts[i])
            memcpy(image + lim_image_section_b(&header, (enum lim_section)i), sections[i],
                   header.counts[i] * element_of(&header, (enum lim_section)i)->size_b);
    lim_image_bind(image, out);
}

void lim_image_set_deep(struct compiled *scene, const uint8_t *deep)
{
    enum { TRIANGLE_B = LIM_TRIANGLE_WORDS * sizeof(lim_index) };
    struct lim_file_header *const header = scene->image;
    const size_t count = header->counts[SECTION_FACES];
    unsigned char *const words = section_at(scene->image, SECTION_POLYGONS);
    uint32_t *const faces = section_at(scene->image, SECTION_FACES);
    unsigned char *const old_words = grow_zeroed(count, TRIANGLE_B);
    uint32_t *const old_faces = grow_zeroed(count, sizeof *old_faces);
    size_t to = 0;

    memcpy(old_words, words, count * TRIANGLE_B);
    memcpy(old_faces, faces, count * sizeof *old_faces);
    for (int kind = 0; kind < LIM_DEEP_COUNT; kind++) {
        if (kind == LIM_DEEP_NEAR) header->near_deep_from = (uint32_t)to;
        if (kind == LIM_DEEP_ALWAYS) header->deep_from = (uint32_t)to;
        for (size_t i = 0; i < count; i++) {
            if (deep[i] != kind) continue;
            memcpy(words + to * TRIANGLE_B, old_words + i * TRIANGLE_B, TRIANGLE_B);
            faces[to++] = old_faces[i];
        }
    }
    *scene->scene.deep_from = header->deep_from;
    *scene->scene.near_deep_from = header->near_deep_from;
    free(old_words);
    free(old_faces);
}

void lim_image_set_pvs(struct compiled *scene, const struct lim_place *places, size_t place_count, const uint8_t *pvs,
                       size_t pvs_bytes)
{
    struct lim_file_header header;
    memcpy(&header, scene->image, sizeof header);
    const size_t kept_b = (size_t)lim_image_section_b(&header, SECTION_PLACES);
    header.counts[SECTION_PLACES] = (uint32_t)place_count;
    header.counts[SECTION_PVS] = (uint32_t)pvs_bytes;
    header.file_b = (uint32_t)lim_image_section_b(&header, SECTION_COUNT);
    unsigned char *image = grow_zeroed(header.file_b, 1);
    memcpy(image, scene->image, kept_b);
    memcpy(image, &header, sizeof header);
    if (place_count) memcpy(image + kept_b, places, place_count * sizeof *places);
    if (pvs_bytes) memcpy(section_at(image, SECTION_PVS), pvs, pvs_bytes);
    free(scene->image);
    lim_image_bind(image, scene);
}

void lim_image_set_textures(struct compiled *scene, const struct texture_arrays *arrays)
{
    const void *const others[SECTION_COUNT] = {[SECTION_TEXTURES] = arrays->textures,
                                               [SECTION_PALETTES] = arrays->palettes,
                                               [SECTION_TEXELS] = arrays->texels};
    struct lim_file_header header;
    memcpy(&header, scene->image, sizeof header);
    header.counts[SECTION_TEXTURES] = (uint32_t)arrays->texture_count;
    header.counts[SECTION_PALETTES] = (uint32_t)arrays->palette_colours;
    header.counts[SECTION_TEXELS] = (uint32_t)(arrays->texel_count / LIM_TEXEL_BLOCK);
    header.file_b = (uint32_t)lim_image_section_b(&header, SECTION_COUNT);
    unsigned char *image = grow_zeroed(header.file_b, 1);
    memcpy(image, &header, sizeof header);
    for (int i = 0; i < SECTION_COUNT; i++) {
        const enum lim_section section = (enum lim_section)i;
        if (header.counts[i])
            memcpy(image + lim_image_section_b(&header, section),
                   others[i] ? others[i] : section_at(scene->image, section),
                   header.counts[i] * element_of(&header, section)->size_b);
    }
    free(scene->image);
    lim_image_bind(image, scene);
}

void lim_image_set_limits(struct compiled *scene, const struct lim_limits *limits)
{
    struct lim_file_header *header = scene->image;
    memcpy(header->limits, limits, sizeof header->limits);
    scene->scene.limits = *limits;
}

/* Reverses each field's bytes; the pattern of widths repeats until the end. */
static void swap_fields(unsigned char *at, size_t size_b, const char *fields)
{
    const unsigned char *end = at + size_b;
    for (size_t field = 0; at < end; field++) {
        if (fields[field] == '\0') field = 0;
        size_t width_b = (size_t)(fields[field] - '0');
        for (size_t i = 0; i < width_b / 2; i++) {
            unsigned char byte = at[i];
            at[i] = at[width_b - 1 - i];
            at[width_b - 1 - i] = byte;
        }
        at += width_b;
    }
}

void lim_image_swap_header(void *image)
{
    swap_fields(image, sizeof(struct lim_file_header), HEADER_FIELDS);
}

void lim_image_swap_sections(void *image, const struct lim_file_header *header)
{
    for (int i = 0; i < SECTION_COUNT; i++)
        swap_fields((unsigned char *)image + lim_image_section_b(header, (enum lim_section)i),
                    header->counts[i] * element_of(header, (enum lim_section)i)->size_b,
                    element_of(header, (enum lim_section)i)->fields);
}

uint32_t lim_image_crc32(const void *image, size_t image_b)
{
    const Bytef *bytes = image;
    return (uint32_t)crc32(crc32(0, Z_NULL, 0), bytes + LIM_FILE_CRC_FROM_B, (uInt)(image_b - LIM_FILE_CRC_FROM_B));
}
