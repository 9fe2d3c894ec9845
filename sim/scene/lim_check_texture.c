/* SPDX-License-Identifier: MIT
 *
 * What the renderer relies on in textures and mappings: that texels and colours lie inside of their arrays, and that
 * sums of products stay within 32 bits. */
#include "long.h"
#include "scene/lim_check.h"

#include <stdlib.h>

enum { SIDE_BITS_MAX = 10, PALETTE_COLOURS = 256, SUM_MAX = 32767, PLACE_BITS_MAX = 15 };

static bool check_texture(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_texture *texture = &scene->textures[index];
    if (texture->w_bits > SIDE_BITS_MAX)
        return error_set(err, "texture %zu: a side of more than %u texels", index, 1u << SIDE_BITS_MAX);
    if (texture->h_bits > texture->w_bits) return error_set(err, "texture %zu: higher than wide", index);
    if (texture->levels < 1 || texture->levels > texture->h_bits + 1)
        return error_set(err, "texture %zu: %u levels", index, texture->levels);
    if (*scene->uvs ? texture->place_bits > PLACE_BITS_MAX
                    : texture->place_bits && texture->place_bits != LIM_TEXTURE_MASKED &&
                          texture->place_bits != LIM_TEXTURE_SKY)
        return error_set(err, "texture %zu: places of %u bits", index, texture->place_bits);
    size_t texels = 0;
    for (unsigned level = 0; level < texture->levels; level++)
        texels += (size_t)1 << (texture->w_bits + texture->h_bits - 2 * level);
    if (texture->texels * (size_t)LIM_TEXEL_BLOCK + texels > scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK)
        return error_set(err, "texture %zu: its texels run over the end", index);
    return texture->palette + PALETTE_COLOURS <= scene->palette_colours ||
           error_set(err, "texture %zu: its palette runs over the end", index);
}

static int sum_of(const int16_t v[2])
{
    return abs(v[0]) + abs(v[1]);
}

static bool check_mapping(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_mapping *mapping = &scene->mappings[index];
    const bool upright = mapping->scale & LIM_MAPPING_UPRIGHT;
    if (sum_of(mapping->uv[0]) > SUM_MAX || sum_of(mapping->uv[1]) > SUM_MAX)
        return error_set(err, "mapping %zu: a vector is too long", index);
    if (mapping->scale >> LIM_MAPPING_AXIS_SHIFT > 2)
        return error_set(err, "mapping %zu: there is no such axis", index);
    if (mapping->texture >= (lim_mappings_name_textures(scene) ? scene->texture_count : 1))
        return error_set(err, "mapping %zu: names texture %u", index, (unsigned)mapping->texture);
    if (lim_scene_long(scene)) return lim_check_long_mapping(scene, index, err);
    const lim_offset offset = (lim_offset)mapping->plane;
    if (upright && (offset < INT16_MIN || offset > INT16_MAX))
        return error_set(err, "mapping %zu: an axis plane at %ld, outside of the grid", index, (long)offset);
    return upright ||
           (mapping->plane % LIM_PLANE_WORDS == 0 && mapping->plane / LIM_PLANE_WORDS < scene->plane_count) ||
           error_set(err, "mapping %zu: plane at word %lu, where none of %lu begins", index,
                     (unsigned long)mapping->plane, (unsigned long)scene->plane_count);
}

bool lim_check_textures(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; i < scene->texture_count; i++)
        if (!check_texture(scene, i, err)) return false;
    for (size_t i = 0; i < scene->mapping_count; i++)
        if (!check_mapping(scene, i, err)) return false;
    return true;
}
