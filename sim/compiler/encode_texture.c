/* SPDX-License-Identifier: MIT
 *
 * Baked light becomes palettes: a face's colour, of which the texture's texels are a part each, is rounded to a few
 * levels, and each pair of a texture and a colour in use gets the texture's palette times that colour. */
#include "compiler/encode_texture.h"

#include "base/grow.h"
#include "base/rgb565.h"
#include "base/vec3.h"
#include "colour.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT_MAX = 0xFFFF, SUM_MAX = 32767, LIGHT_BITS = 4 };
static const double LEVEL_MIN = -16, LEVEL_MAX = 15.875; /* as far as 8 bits count eighths */
static const double ANISOTROPY_MAX = 64;                 /* of a mapping, as far as its level of detail knows */

static const uint32_t NO_TEXTURE = UINT32_MAX;
static const uint64_t NO_PICTURE = UINT64_C(1) << 63; /* of a colour alone: no texture has that number */

/* Light -------------------------------------------------------------------------------------- */

/* To the nearest of 2^bits levels a channel; no light and full light are levels. */
static uint32_t light_of(uint32_t colour, unsigned bits)
{
    const unsigned steps = (1u << bits) - 1;
    uint32_t light = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const unsigned level = ((colour >> shift & 0xFF) * steps + 127) / 255;
        light = light << 8 | (level * 255 + steps / 2) / steps;
    }
    return light;
}

static uint32_t lit(uint32_t colour, uint32_t light)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out = out << 8 | ((colour >> shift & 0xFF) * (light >> shift & 0xFF) + 127) / 255;
    return out;
}

bool texture_is_masked(const struct mesh *mesh, const struct mesh_polygon *polygon)
{
    return polygon->mapping && mesh->textures[mesh->mappings[polygon->mapping].texture].is_masked;
}

uint32_t texture_light_of(uint32_t colour)
{
    return light_of(colour, LIGHT_BITS);
}

uint32_t texture_flat_colour(const struct mesh *mesh, const struct mesh_polygon *polygon)
{
    return lit(mesh->textures[mesh->mappings[polygon->mapping].texture].mean, polygon->colour);
}

static uint64_t look_key(const struct texture_encoder *encoder, const struct mesh_polygon *polygon)
{
    return (uint64_t)encoder->mesh->mappings[polygon->mapping].texture << 24 |
           light_of(polygon->colour, encoder->light_bits);
}

static size_t palette_colours(const struct texture_encoder *encoder)
{
    const struct mesh *mesh = encoder->mesh;
    struct map seen = {0};
    size_t colours = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        if (!polygon->mapping) continue;
        const size_t before = seen.count;
        map_at(&seen, look_key(encoder, polygon), 0);
        if (seen.count > before) colours += mesh->textures[mesh->mappings[polygon->mapping].texture].colours;
    }
    map_free(&seen);
    return colours;
}

void texture_encoder_init(struct texture_encoder *encoder, const struct mesh *mesh, struct texture_arrays *out)
{
    *encoder = (struct texture_encoder){.mesh = mesh, .out = out, .light_bits = LIGHT_BITS};
    while (encoder->light_bits > 1 && palette_colours(encoder) > COUNT_MAX - TEXTURE_COLOURS)
        encoder->light_bits--;
}

/* Textures ----------------------------------------------------------------------------------- */

static uint16_t texels_add(struct texture_arrays *out, const struct texture *texture)
{
    const size_t first = out->texel_count;
    while (first + texture->texel_count > out->texel_capacity)
        out->texels = grow(out->texels, out->texel_capacity, &out->texel_capacity, 1);
    memcpy(out->texels + first, texture->texels, texture->texel_count);
    out->texel_count += texture->texel_count;
    return (uint16_t)(first / LIM_TEXEL_BLOCK);
}

static uint16_t palette_add(struct texture_arrays *out, const struct texture *texture, uint32_t light)
{
    const size_t first = out->palette_colours;
    for (size_t i = 0; i < texture->colours; i++) {
        out->palettes = grow(out->palettes, out->palette_colours, &out->palette_capacity, sizeof *out->palettes);
        out->palettes[out->palette_colours++] = lim_memory_colour(rgb565_nearest(lit(texture->palette[i], light)));
    }
    return (uint16_t)first;
}

static void look_add(struct texture_encoder *encoder, const struct mesh_polygon *polygon)
{
    struct texture_arrays *out = encoder->out;
    const uint32_t number = encoder->mesh->mappings[polygon->mapping].texture;
    const struct texture *texture = &encoder->mesh->textures[number];
    const uint32_t *known = map_find(&encoder->texels, number);
    const uint16_t texels = known ? (uint16_t)*known : texels_add(out, texture);
    map_at(&encoder->texels, number, texels);
    out->textures = grow(out->textures, out->texture_count, &out->texture_capacity, sizeof *out->textures);
    out->textures[out->texture_count++] =
        (struct lim_texture){.texels = texels,
                             .palette = palette_add(out, texture, light_of(polygon->colour, encoder->light_bits)),
                             .w_bits = texture->w_bits,
                             .h_bits = texture->h_bits,
                             .levels = texture->levels,
                             .place_bits = encoder->place_bits  ? encoder->place_bits[number]
                                           : texture->sky.times ? (uint8_t)LIM_TEXTURE_SKY
                                           : texture->is_masked ? (uint8_t)LIM_TEXTURE_MASKED
                                                                : 0};
}

/* Mappings ----------------------------------------------------------------------------------- */

/* v times `by`, rounded; false: the components add up to too much. */
static bool round_vector(const double v[2], double by, int16_t out[2])
{
    double sum = 0, rounded[2];
    for (int i = 0; i < 2; i++) {
        rounded[i] = floor(v[i] * by + 0.5);
        sum += fabs(rounded[i]);
    }
    if (sum > SUM_MAX) return false;
    for (int i = 0; i < 2; i++)
        out[i] = (int16_t)rounded[i];
    return true;
}

/* log2 of texels a unit: the mean of both directions, or of the finer one and what it is held to be at least. */
static int8_t level_of(double uv[2][3], double normal_length)
{
    double cross[3];
    for (int i = 0; i < 3; i++)
        cross[i] = uv[0][(i + 1) % 3] * uv[1][(i + 2) % 3] - uv[0][(i + 2) % 3] * uv[1][(i + 1) % 3];
    const double longest2 = fmax(vec3_dot(uv[0], uv[0]), vec3_dot(uv[1], uv[1]));
    const double area = fmax(sqrt(vec3_dot(cross, cross)), longest2 / ANISOTROPY_MAX);
    const double level = area > 0 ? (log2(area) + log2(normal_length / LIM_MAPPING_UPRIGHT_N)) / 2 : LEVEL_MIN;
    return (int8_t)floor(8 * fmax(fmin(level, LEVEL_MAX), LEVEL_MIN) + 0.5);
}

/* How far from a point the plane is, along an axis. */
static double way_to_plane(const struct texture_plane *plane, const double point[3], int axis)
{
    return (plane->d - vec3_dot(plane->n, point)) / plane->n[axis];
}

static struct lim_mapping mapping_of(const struct mesh *mesh, const struct mapping *from,
                                     const struct texture_plane *plane)
{
    const struct texture *texture = &mesh->textures[from->texture];
    struct lim_mapping out = {0};
    double centre[3], texels[2][3], across[2][2];
    int i = 0;
    for (int axis = 0; axis < 3; axis++) {
        centre[axis] = (from->centre_m[axis] - mesh->grid.origin_m[axis]) * mesh->grid.units_per_m;
        if (fabs(plane->n[axis]) > fabs(plane->n[i])) i = axis;
    }
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (int c = 0; c < 2; c++) {
        for (int axis = 0; axis < 3; axis++)
            texels[c][axis] =
                ldexp(from->gradient[c][axis], c ? texture->h_bits : texture->w_bits) / mesh->grid.units_per_m;
        across[c][0] = ldexp(texels[c][j] - texels[c][i] * plane->n[j] / plane->n[i], -texture->w_bits);
        across[c][1] = ldexp(texels[c][k] - texels[c][i] * plane->n[k] / plane->n[i], -texture->w_bits);
    }
    int bits = LIM_MAPPING_BITS;
    while (bits > 0 &&
           (!round_vector(across[0], ldexp(1, bits), out.uv[0]) || !round_vector(across[1], ldexp(1, bits), out.uv[1])))
        bits--;
    round_vector(across[0], ldexp(1, bits), out.uv[0]);
    round_vector(across[1], ldexp(1, bits), out.uv[1]);
    for (int c = 0; c < 2; c++) {
        const double beside = ldexp(texels[c][i], -texture->w_bits) * way_to_plane(plane, centre, i);
        const double at_centre = ldexp(from->uv[c], c ? texture->h_bits - texture->w_bits : 0) + beside;
        /* Rounding turns the gradient: about the centre. */
        const double at_zero = at_centre - ldexp(out.uv[c][0] * centre[j] + out.uv[c][1] * centre[k], -bits);
        out.at_zero_q16[c] = (uint16_t)(int64_t)floor((at_zero - floor(at_zero)) * 65536 + 0.5);
    }
    const bool upright = plane->ref.plane >= LIM_PLANE_X;
    out.plane = upright ? (lim_index)plane->ref.offset : plane->ref.plane;
    out.scale = (uint8_t)(bits | (upright ? LIM_MAPPING_UPRIGHT : 0) | i << LIM_MAPPING_AXIS_SHIFT);
    out.level_q3 = level_of(texels, sqrt(vec3_dot(plane->n, plane->n)));
    return out;
}

/* Only what is asked of a sky's; the rest is that of a plane. */
static struct lim_mapping sky_of(const struct texture *texture)
{
    const double horizon = ldexp(texture->sky.horizon, 15 + texture->h_bits - texture->w_bits);
    return (struct lim_mapping){.uv = {{(int16_t)texture->sky.times, 0}, {0, 0}},
                                .at_zero_q16 = {0, (uint16_t)fmin(fmax(floor(horizon + 0.5), 0), UINT16_MAX)},
                                .scale = LIM_MAPPING_UPRIGHT};
}

static uint64_t hash_of(const struct lim_mapping *mapping)
{
    const unsigned char *bytes = (const unsigned char *)mapping;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < sizeof *mapping; i++)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint32_t mapping_index(struct texture_encoder *encoder, uint32_t number, const struct texture_plane *plane)
{
    struct texture_arrays *out = encoder->out;
    const struct mapping *from = &encoder->mesh->mappings[number];
    const struct texture *texture = &encoder->mesh->textures[from->texture];
    const struct lim_mapping mapping = texture->sky.times ? sky_of(texture) : mapping_of(encoder->mesh, from, plane);
    const uint32_t index = *map_at(&encoder->same, hash_of(&mapping), (uint32_t)out->mapping_count);
    if (index < out->mapping_count && memcmp(&out->mappings[index], &mapping, sizeof mapping) == 0) return index;
    out->mappings = grow(out->mappings, out->mapping_count, &out->mapping_capacity, sizeof *out->mappings);
    out->mappings[out->mapping_count] = mapping;
    return (uint32_t)out->mapping_count++;
}

/* The texel that single ones share is a texture of its own. */
static void colour_add(struct texture_encoder *encoder, uint16_t rgb565)
{
    uint8_t block[LIM_TEXEL_BLOCK] = {0};
    const struct texture one = {.texels = block, .texel_count = sizeof block};
    struct texture_arrays *out = encoder->out;
    const uint32_t *known = map_find(&encoder->texels, NO_PICTURE);
    const uint16_t texels = known ? (uint16_t)*known : texels_add(out, &one);
    map_at(&encoder->texels, NO_PICTURE, texels);
    out->textures = grow(out->textures, out->texture_count, &out->texture_capacity, sizeof *out->textures);
    out->textures[out->texture_count++] =
        (struct lim_texture){.texels = texels, .palette = (uint16_t)out->palette_colours, .levels = 1};
    out->palettes = grow(out->palettes, out->palette_colours, &out->palette_capacity, sizeof *out->palettes);
    out->palettes[out->palette_colours++] = lim_memory_colour(rgb565);
}

uint16_t texture_encode_look(struct texture_encoder *encoder, const struct mesh_polygon *polygon)
{
    const uint32_t count = (uint32_t)encoder->out->texture_count;
    const uint16_t rgb565 = rgb565_nearest(polygon->colour);
    const uint64_t key = polygon->mapping ? look_key(encoder, polygon) : NO_PICTURE | rgb565;
    const uint32_t index = *map_at(&encoder->looks, key, count);
    if (index == count && polygon->mapping)
        look_add(encoder, polygon);
    else if (index == count)
        colour_add(encoder, rgb565);
    return (uint16_t)index;
}

bool texture_encode(struct texture_encoder *encoder, const struct mesh_polygon *polygon,
                    const struct texture_plane *plane, uint16_t words[2])
{
    if (!polygon->mapping) return false;
    words[0] = texture_encode_look(encoder, polygon);
    words[1] = (uint16_t)mapping_index(encoder, polygon->mapping, plane);
    return true;
}

/* The mapping's copy that names the texture. The first texture that a mapping is shown with gets the mapping itself. */
static uint32_t named_mapping(struct texture_arrays *out, struct map *copies, uint32_t mapping, uint32_t texture)
{
    const uint64_t key = (uint64_t)mapping << 32 | texture;
    const bool is_first = !map_find(copies, (uint64_t)mapping << 32 | NO_TEXTURE);
    map_at(copies, (uint64_t)mapping << 32 | NO_TEXTURE, 0);
    const uint32_t index = *map_at(copies, key, is_first ? mapping : (uint32_t)out->mapping_count);
    if (index == out->mapping_count) {
        out->mappings = grow(out->mappings, out->mapping_count, &out->mapping_capacity, sizeof *out->mappings);
        out->mappings[out->mapping_count++] = out->mappings[mapping];
    }
    out->mappings[index].texture = (uint16_t)texture;
    return index;
}

void texture_name_by_mappings(struct encoding *encoding)
{
    struct map copies = {0};
    for (size_t at = 0; at < encoding->word_count; at += lim_record_words(encoding->words[at])) {
        lim_index *const end = &encoding->words[at + lim_record_words(encoding->words[at])];
        if (encoding->words[at] & LIM_POLYGON_TEXTURE)
            end[-1] = named_mapping(&encoding->textures, &copies, end[-1], end[-2]);
    }
    map_free(&copies);
}

/* A palette of fewer colours runs on into the next one; the last one is filled up, so that any texel finds a colour. */
void texture_encoder_finish(struct texture_encoder *encoder)
{
    struct texture_arrays *out = encoder->out;
    if (out->texture_count == 0) return;
    const size_t end = out->textures[out->texture_count - 1].palette + (size_t)TEXTURE_COLOURS;
    while (out->palette_colours < end) {
        out->palettes = grow(out->palettes, out->palette_colours, &out->palette_capacity, sizeof *out->palettes);
        out->palettes[out->palette_colours++] = 0;
    }
}

bool texture_arrays_check(const struct texture_arrays *arrays, struct error *err)
{
    struct error why;
    return (encoding_check_count(arrays->mapping_count, "texture mappings", &why) &&
            encoding_check_count(arrays->texture_count, "textures, each light counted", &why) &&
            encoding_check_count(arrays->palette_colours, "colours of palettes", &why) &&
            encoding_check_count(arrays->texel_count / LIM_TEXEL_BLOCK, "blocks of texels", &why)) ||
           error_set(err, "%s; --no-textures does without", why.text);
}

void texture_encoder_free(struct texture_encoder *encoder)
{
    map_free(&encoder->same);
    map_free(&encoder->looks);
    map_free(&encoder->texels);
}
