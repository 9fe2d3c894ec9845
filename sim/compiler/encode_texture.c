/* SPDX-License-Identifier: MIT
 *
 * Baked light becomes palettes: a face's colour, of which the texture's texels are a part each, is rounded to a few
 * levels, and each pair of a texture and a colour in use gets the texture's palette times that colour. */
#include "compiler/encode_texture.h"

#include "base/grow.h"
#include "base/rgb565.h"
#include "base/rgb888.h"
#include "base/vec3.h"
#include "colour.h"
#include "model/note_words.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT_MAX = 0xFFFF, SUM_MAX = 32767, LIGHT_BITS = 4 };
static const double LEVEL_MIN = -16, LEVEL_MAX = 15.875; /* as far as 8 bits count eighths */
static const double LONG_LEVEL_MAX = LIM_LONG_LEVEL_MAX_Q4 / 16.0;
static const double ANISOTROPY_MAX = 64; /* of a mapping, as far as its level of detail knows */

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
    return rgb888_times(mesh->textures[mesh->mappings[polygon->mapping].texture].mean, polygon->colour);
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
        out->palettes[out->palette_colours++] =
            lim_memory_colour(rgb565_nearest(rgb888_times(texture->palette[i], light)));
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
static double level_of(double uv[2][3], double normal_length)
{
    double cross[3];
    for (int i = 0; i < 3; i++)
        cross[i] = uv[0][(i + 1) % 3] * uv[1][(i + 2) % 3] - uv[0][(i + 2) % 3] * uv[1][(i + 1) % 3];
    const double longest2 = fmax(vec3_dot(uv[0], uv[0]), vec3_dot(uv[1], uv[1]));
    const double area = fmax(sqrt(vec3_dot(cross, cross)), longest2 / ANISOTROPY_MAX);
    return area > 0 ? (log2(area) + log2(normal_length)) / 2 : -DBL_MAX;
}

static double length_of(const double v[3])
{
    return sqrt(vec3_dot(v, v));
}

/* How far from a point the plane is, along an axis. */
static double way_to_plane(const struct texture_plane *plane, const double point[3], int axis)
{
    return (plane->d - vec3_dot(plane->n, point)) / plane->n[axis];
}

/* A mapping of the mesh on a plane of the scene's grid. */
struct on_grid {
    const struct texture_plane *plane;
    double centre[3];    /* units */
    double texels[2][3]; /* a unit */
    double across[2][2]; /* widths of the picture a unit, along the axes j and k */
    double at_centre[2]; /* likewise widths, where the plane is above or below the centre */
    int axis;            /* of the normal's longest component */
};

static void put_on_grid(const struct mesh *mesh, const struct mapping *from, const struct texture_plane *plane,
                        struct on_grid *out)
{
    const struct texture *texture = &mesh->textures[from->texture];
    int i = 0;
    for (int axis = 0; axis < 3; axis++) {
        out->centre[axis] = (from->centre_m[axis] - mesh->grid.origin_m[axis]) * mesh->grid.units_per_m;
        if (fabs(plane->n[axis]) > fabs(plane->n[i])) i = axis;
    }
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out->plane = plane;
    out->axis = i;
    for (int c = 0; c < 2; c++) {
        double *const texels = out->texels[c];
        for (int axis = 0; axis < 3; axis++)
            texels[axis] =
                ldexp(from->gradient[c][axis], c ? texture->h_bits : texture->w_bits) / mesh->grid.units_per_m;
        out->across[c][0] = ldexp(texels[j] - texels[i] * plane->n[j] / plane->n[i], -texture->w_bits);
        out->across[c][1] = ldexp(texels[k] - texels[i] * plane->n[k] / plane->n[i], -texture->w_bits);
        const double beside = ldexp(texels[i], -texture->w_bits) * way_to_plane(plane, out->centre, i);
        out->at_centre[c] = ldexp(from->uv[c], c ? texture->h_bits - texture->w_bits : 0) + beside;
    }
}

/* Of a place in widths, modulo 1. */
static uint16_t place_q16(double place)
{
    return (uint16_t)(int64_t)floor((place - floor(place)) * 65536 + 0.5);
}

static uint8_t scale_of(const struct on_grid *on, int bits)
{
    const bool upright = on->plane->ref.plane >= LIM_PLANE_X;
    return (uint8_t)(bits | (upright ? LIM_MAPPING_UPRIGHT : 0) | on->axis << LIM_MAPPING_AXIS_SHIFT);
}

static lim_index plane_word(const struct texture_plane *plane)
{
    return plane->ref.plane >= LIM_PLANE_X ? (lim_index)plane->ref.offset : plane->ref.plane;
}

static struct lim_mapping mapping_of(const struct on_grid *on)
{
    struct lim_mapping out = {.plane = plane_word(on->plane)};
    const int j = (on->axis + 1) % 3, k = (on->axis + 2) % 3;
    int bits = LIM_MAPPING_BITS;
    while (bits > 0 && (!round_vector(on->across[0], ldexp(1, bits), out.uv[0]) ||
                        !round_vector(on->across[1], ldexp(1, bits), out.uv[1])))
        bits--;
    round_vector(on->across[0], ldexp(1, bits), out.uv[0]);
    round_vector(on->across[1], ldexp(1, bits), out.uv[1]);
    for (int c = 0; c < 2; c++) /* Rounding turns the gradient: about the centre. */
        out.at_zero_q16[c] =
            place_q16(on->at_centre[c] - ldexp(out.uv[c][0] * on->centre[j] + out.uv[c][1] * on->centre[k], -bits));
    out.scale = scale_of(on, bits);
    const double level = level_of((double(*)[3])on->texels, length_of(on->plane->n) / LIM_MAPPING_UPRIGHT_N);
    out.level_q3 = (int8_t)floor(8 * fmax(fmin(level, LEVEL_MAX), LEVEL_MIN) + 0.5);
    return out;
}

/* Of a long scene ----------------------------------------------------------------------------- */

/* v times 2^bits, rounded; false: the components add up to too much. */
static bool round_long(const double v[2], int bits, int32_t out[2])
{
    const double x = floor(ldexp(v[0], bits) + 0.5), y = floor(ldexp(v[1], bits) + 0.5);
    if (fabs(x) + fabs(y) > LIM_LONG_UV_MAX) return false;
    out[0] = (int32_t)x;
    out[1] = (int32_t)y;
    return true;
}

static void round_gradients(const struct on_grid *on, struct lim_long_mapping *out)
{
    int bits = LIM_LONG_UV_BITS_MAX;
    while (bits > LIM_LONG_UV_BITS_MIN &&
           (!round_long(on->across[0], bits, out->uv[0]) || !round_long(on->across[1], bits, out->uv[1])))
        bits--;
    for (int c = 0; c < 2; c++)
        if (!round_long(on->across[c], bits, out->uv[c])) out->uv[c][0] = out->uv[c][1] = 0;
    out->bits = (uint8_t)bits;
}

/* Rounding turns the gradient about the centre, however far away the plane's vertex is. */
static struct lim_mapping long_mapping_of(const struct on_grid *on, struct lim_long_mapping *places)
{
    struct lim_mapping out = {.plane = plane_word(on->plane), .scale = scale_of(on, 0)};
    const int32_t *vertex = on->plane->at;
    const int j = (on->axis + 1) % 3, k = (on->axis + 2) % 3;
    round_gradients(on, places);
    for (int c = 0; c < 2; c++)
        out.at_zero_q16[c] = place_q16(on->at_centre[c] - ldexp(places->uv[c][0] * (on->centre[j] - vertex[j]) +
                                                                    places->uv[c][1] * (on->centre[k] - vertex[k]),
                                                                -places->bits));
    const double level = level_of((double(*)[3])on->texels, ldexp(length_of(on->plane->n), -30));
    places->level_q4 = (int16_t)floor(16 * fmax(fmin(level, LONG_LEVEL_MAX), -LONG_LEVEL_MAX) + 0.5);
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

static uint64_t hash_of(const void *data, size_t size_b, uint64_t hash)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size_b; i++)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

/* `places`: NULL, but of a long scene. */
static void mapping_add_to(struct texture_arrays *out, const struct lim_mapping *mapping,
                           const struct lim_long_mapping *places)
{
    const size_t count = out->mapping_count;
    out->mappings = grow(out->mappings, count, &out->mapping_capacity, sizeof *out->mappings);
    out->mappings[out->mapping_count++] = *mapping;
    if (!places) return;
    out->long_mappings = grow(out->long_mappings, count, &out->long_mapping_capacity, sizeof *out->long_mappings);
    out->long_mappings[count] = *places;
}

static uint32_t mapping_index(struct texture_encoder *encoder, const struct lim_mapping *mapping,
                              const struct lim_long_mapping *places)
{
    struct texture_arrays *out = encoder->out;
    uint64_t hash = hash_of(mapping, sizeof *mapping, UINT64_C(0xcbf29ce484222325));
    if (places) hash = hash_of(places, sizeof *places, hash);
    const uint32_t index = *map_at(&encoder->same, hash, (uint32_t)out->mapping_count);
    if (index < out->mapping_count && memcmp(&out->mappings[index], mapping, sizeof *mapping) == 0 &&
        (!places || memcmp(&out->long_mappings[index], places, sizeof *places) == 0))
        return index;
    mapping_add_to(out, mapping, places);
    return (uint32_t)out->mapping_count - 1;
}

static uint32_t mapping_number(struct texture_encoder *encoder, uint32_t number, const struct texture_plane *plane)
{
    const struct mapping *from = &encoder->mesh->mappings[number];
    const struct texture *texture = &encoder->mesh->textures[from->texture];
    struct lim_mapping mapping = sky_of(texture);
    struct lim_long_mapping places = {.bits = LIM_LONG_UV_BITS_MIN}; /* a sky's, of which nothing is asked */
    struct on_grid on;
    if (!texture->sky.times) {
        put_on_grid(encoder->mesh, from, plane, &on);
        mapping = plane->is_long ? long_mapping_of(&on, &places) : mapping_of(&on);
    }
    return mapping_index(encoder, &mapping, plane->is_long ? &places : NULL);
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
    words[1] = (uint16_t)mapping_number(encoder, polygon->mapping, plane);
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
        const struct lim_mapping copy = out->mappings[mapping];
        if (out->long_mappings) {
            const struct lim_long_mapping places = out->long_mappings[mapping];
            mapping_add_to(out, &copy, &places);
        } else
            mapping_add_to(out, &copy, NULL);
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
           error_set(err, "%s" WORDS_WITHOUT, why.text);
}

void texture_encoder_free(struct texture_encoder *encoder)
{
    map_free(&encoder->same);
    map_free(&encoder->looks);
    map_free(&encoder->texels);
}
