/* SPDX-License-Identifier: MIT
 *
 * What the renderer relies on in textures and mappings: that texels and colours lie inside of their arrays, and that
 * sums of products stay within 32 bits. */
#include "scene/lim_check.h"

#include <stdlib.h>

enum { SIDE_BITS_MAX = 10, PALETTE_COLOURS = 256, SUM_MAX = 32767, SHIFT_MAX = 40, LEVEL_MAX_Q4 = 16 * 64 };

static bool check_texture(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_texture *texture = &scene->textures[index];
    const unsigned least = texture->w_bits < texture->h_bits ? texture->w_bits : texture->h_bits;
    if (texture->w_bits > SIDE_BITS_MAX || texture->h_bits > SIDE_BITS_MAX)
        return error_set(err, "texture %zu: a side of more than %u texels", index, 1u << SIDE_BITS_MAX);
    if (texture->levels < 1 || texture->levels > least + 1)
        return error_set(err, "texture %zu: %u levels", index, texture->levels);
    if (texture->zero) return error_set(err, "texture %zu: its spare byte is not zero", index);
    size_t texels = 0;
    for (unsigned level = 0; level < texture->levels; level++)
        texels += (size_t)1 << (texture->w_bits + texture->h_bits - 2 * level);
    if (texture->texels * (size_t)LIM_TEXEL_BLOCK + texels > scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK)
        return error_set(err, "texture %zu: its texels run over the end", index);
    return texture->palette + PALETTE_COLOURS <= scene->palette_colours ||
           error_set(err, "texture %zu: its palette runs over the end", index);
}

static int sum_of(const int16_t v[3])
{
    return abs(v[0]) + abs(v[1]) + abs(v[2]);
}

static bool check_mapping(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_mapping *mapping = &scene->mappings[index];
    if (sum_of(mapping->n) == 0 || sum_of(mapping->n) > SUM_MAX || sum_of(mapping->uv[0]) > SUM_MAX ||
        sum_of(mapping->uv[1]) > SUM_MAX)
        return error_set(err, "mapping %zu: a vector is too long, or has no length", index);
    if (mapping->bits[0] > SHIFT_MAX || mapping->bits[1] > SHIFT_MAX || abs(mapping->level_q4) > LEVEL_MAX_Q4)
        return error_set(err, "mapping %zu: a scale is out of range", index);
    if (mapping->zero) return error_set(err, "mapping %zu: its spare field is not zero", index);
    return (mapping->d >= -LIM_PLANE_D_MAX && mapping->d <= LIM_PLANE_D_MAX) ||
           error_set(err, "mapping %zu: d is %ld, beyond %ld", index, (long)mapping->d, (long)LIM_PLANE_D_MAX);
}

bool lim_check_textures(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; i < scene->texture_count; i++)
        if (!check_texture(scene, i, err)) return false;
    for (size_t i = 0; i < scene->mapping_count; i++)
        if (!check_mapping(scene, i, err)) return false;
    return true;
}
