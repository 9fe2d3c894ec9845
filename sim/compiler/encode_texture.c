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

enum { COUNT_MAX = 0xFFFF, SUM_MAX = 32767, BITS_MAX = 40, LIGHT_BITS = 4 };
static const double ANISOTROPY_MAX = 64; /* of a mapping, as far as its level of detail knows */

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
                             .levels = texture->levels};
}

/* Mappings ----------------------------------------------------------------------------------- */

/* v times `by`, rounded; false: the components add up to too much. */
static bool round_vector(const double v[3], double by, int16_t out[3])
{
    double sum = 0, rounded[3];
    for (int i = 0; i < 3; i++) {
        rounded[i] = floor(v[i] * by + 0.5);
        sum += fabs(rounded[i]);
    }
    if (sum > SUM_MAX) return false;
    for (int i = 0; i < 3; i++)
        out[i] = (int16_t)rounded[i];
    return true;
}

/* The normal's length is free: the one that rounds best. */
static double set_normal(const double normal[3], int16_t out[3])
{
    double best = 0, least = INFINITY;
    for (int length = SUM_MAX / 2; length <= SUM_MAX; length++) {
        double off = 0;
        int16_t rounded[3];
        if (!round_vector(normal, length, rounded)) break;
        for (int i = 0; i < 3; i++)
            off = fmax(off, fabs(rounded[i] / (double)length - normal[i]));
        if (off >= least) continue;
        least = off;
        best = length;
    }
    round_vector(normal, best, out);
    return best;
}

/* log2 of texels a unit: the mean of both directions, or of the finer one and what it is held to be at least. */
static int16_t level_of(double uv[2][3], double normal_length)
{
    double cross[3];
    for (int i = 0; i < 3; i++)
        cross[i] = uv[0][(i + 1) % 3] * uv[1][(i + 2) % 3] - uv[0][(i + 2) % 3] * uv[1][(i + 1) % 3];
    const double longest2 = fmax(vec3_dot(uv[0], uv[0]), vec3_dot(uv[1], uv[1]));
    const double area = fmax(sqrt(vec3_dot(cross, cross)), longest2 / ANISOTROPY_MAX);
    const double level = area > 0 ? (log2(area) + log2(normal_length)) / 2 : -BITS_MAX;
    return (int16_t)floor(16 * fmax(level, -BITS_MAX) + 0.5);
}

static struct lim_mapping mapping_of(const struct mesh *mesh, const struct mapping *from)
{
    const struct texture *texture = &mesh->textures[from->texture];
    struct lim_mapping out = {0};
    double centre[3], texels[2][3];
    for (int axis = 0; axis < 3; axis++)
        centre[axis] = (from->centre_m[axis] - mesh->grid.origin_m[axis]) * mesh->grid.units_per_m;
    const double normal_length = set_normal(from->normal, out.n);
    out.d = (int32_t)floor(out.n[0] * centre[0] + out.n[1] * centre[1] + out.n[2] * centre[2] + 0.5);
    for (int i = 0; i < 2; i++) {
        const double side_px = (double)(1u << (i ? texture->h_bits : texture->w_bits));
        for (int axis = 0; axis < 3; axis++)
            texels[i][axis] = from->gradient[i][axis] * side_px / mesh->grid.units_per_m;
        out.bits[i] = BITS_MAX;
        while (!round_vector(texels[i], ldexp(1, out.bits[i]), out.uv[i]))
            out.bits[i]--;
        double at_zero = from->uv[i] * side_px; /* rounding turns the gradient: about the centre */
        for (int axis = 0; axis < 3; axis++)
            at_zero -= ldexp(out.uv[i][axis], -out.bits[i]) * centre[axis];
        out.at_zero_q16[i] = (int32_t)(uint32_t)(int64_t)floor(fmod(at_zero, 65536) * 65536 + 0.5);
    }
    out.level_q4 = level_of(texels, normal_length);
    return out;
}

static uint64_t hash_of(const struct lim_mapping *mapping)
{
    const unsigned char *bytes = (const unsigned char *)mapping;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < sizeof *mapping; i++)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint32_t mapping_index(struct texture_encoder *encoder, uint32_t number)
{
    struct texture_arrays *out = encoder->out;
    const uint32_t *known = map_find(&encoder->mappings, number);
    if (known) return *known;
    const struct lim_mapping mapping = mapping_of(encoder->mesh, &encoder->mesh->mappings[number]);
    uint32_t index = *map_at(&encoder->same, hash_of(&mapping), (uint32_t)out->mapping_count);
    if (index == out->mapping_count || memcmp(&out->mappings[index], &mapping, sizeof mapping) != 0) {
        index = (uint32_t)out->mapping_count;
        out->mappings = grow(out->mappings, out->mapping_count, &out->mapping_capacity, sizeof *out->mappings);
        out->mappings[out->mapping_count++] = mapping;
    }
    return *map_at(&encoder->mappings, number, index);
}

bool texture_encode(struct texture_encoder *encoder, const struct mesh_polygon *polygon, uint16_t words[2])
{
    if (!polygon->mapping) return false;
    const uint32_t count = (uint32_t)encoder->out->texture_count;
    const uint32_t index = *map_at(&encoder->looks, look_key(encoder, polygon), count);
    if (index == count) look_add(encoder, polygon);
    words[0] = (uint16_t)index;
    words[1] = (uint16_t)mapping_index(encoder, polygon->mapping);
    return true;
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
    return encoding_check_count(arrays->mapping_count, "texture mappings", err) &&
           encoding_check_count(arrays->texture_count, "textures, each light counted", err) &&
           encoding_check_count(arrays->palette_colours, "colours of palettes", err) &&
           encoding_check_count(arrays->texel_count / LIM_TEXEL_BLOCK, "blocks of texels", err);
}

void texture_encoder_free(struct texture_encoder *encoder)
{
    map_free(&encoder->mappings);
    map_free(&encoder->same);
    map_free(&encoder->looks);
    map_free(&encoder->texels);
}
