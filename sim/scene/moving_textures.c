/* SPDX-License-Identifier: MIT
 *
 * Two textures are one if their sizes, their texels, the colours that these name and what they are for are. */
#include "scene/moving_textures.h"

#include "base/grow.h"
#include "scene/encoding.h"
#include "scene/lim_image.h"
#include "scene/records.h"

#include <stdlib.h>
#include <string.h>

enum { COUNT_MAX = 0xFFFF };

static size_t texels_of(const struct lim_texture *texture)
{
    return texture_texels(texture->w_bits, texture->h_bits);
}

static const uint8_t *first_texel(const struct lim_scene *object, const struct lim_texture *texture)
{
    return object->texels + (size_t)texture->texels * LIM_TEXEL_BLOCK;
}

/* How many colours it names, at most: a sky those above and below it, too. */
static size_t colours_of(const struct lim_scene *object, const struct lim_texture *texture)
{
    size_t most = texture->place_bits & LIM_TEXTURE_SKY ? 1 : 0;
    for (size_t i = 0, count = texels_of(texture); i < count; i++)
        if (first_texel(object, texture)[i] > most) most = first_texel(object, texture)[i];
    return most + 1;
}

static bool is_as_large(const struct lim_texture *a, const struct lim_texture *b)
{
    return a->w_bits == b->w_bits && a->h_bits == b->h_bits && a->levels == b->levels;
}

static bool has_texels(const struct texture_arrays *all, size_t index, const struct lim_scene *object,
                       const struct lim_texture *texture)
{
    const struct lim_texture *there = &all->textures[index];
    return is_as_large(there, texture) && memcmp(all->texels + (size_t)there->texels * LIM_TEXEL_BLOCK,
                                                 first_texel(object, texture), texels_of(texture)) == 0;
}

static bool is_same(const struct texture_arrays *all, size_t index, const struct lim_scene *object,
                    const struct lim_texture *texture)
{
    const struct lim_texture *there = &all->textures[index];
    return there->place_bits == texture->place_bits && has_texels(all, index, object, texture) &&
           memcmp(all->palettes + there->palette, object->palettes + texture->palette,
                  colours_of(object, texture) * sizeof *all->palettes) == 0;
}

/* Where texels are that the scene has already; COUNT_MAX: it has none of these. */
static size_t find_texels(const struct texture_arrays *all, const struct lim_scene *object,
                          const struct lim_texture *texture)
{
    for (size_t i = 0; i < all->texture_count; i++)
        if (has_texels(all, i, object, texture)) return all->textures[i].texels;
    return COUNT_MAX;
}

static size_t add_texels(struct texture_arrays *all, const uint8_t *texels, size_t count)
{
    const size_t first = all->texel_count;
    while (first + count > all->texel_capacity)
        all->texels = grow(all->texels, all->texel_capacity, &all->texel_capacity, 1);
    memcpy(all->texels + first, texels, count);
    all->texel_count += count;
    return first / LIM_TEXEL_BLOCK;
}

static void add_colour(struct texture_arrays *all, uint16_t colour)
{
    all->palettes = grow(all->palettes, all->palette_colours, &all->palette_capacity, sizeof *all->palettes);
    all->palettes[all->palette_colours++] = colour;
}

/* Room for so many texels, a texture, and the end of the last palette. */
static bool has_room(const struct texture_arrays *all, size_t texels)
{
    return all->texture_count < COUNT_MAX && all->palette_colours + 2 * TEXTURE_COLOURS <= COUNT_MAX &&
           (all->texel_count + texels) / LIM_TEXEL_BLOCK <= COUNT_MAX;
}

/* The number that it has among all; COUNT_MAX: there is no room for it. */
static size_t add_texture(struct texture_arrays *all, const struct lim_scene *object, const struct lim_texture *texture)
{
    const size_t colours = colours_of(object, texture);
    struct lim_texture own = *texture;
    for (size_t i = 0; i < all->texture_count; i++)
        if (is_same(all, i, object, texture)) return i;
    size_t block = find_texels(all, object, texture);
    if (!has_room(all, block == COUNT_MAX ? texels_of(texture) : 0)) return COUNT_MAX;
    if (block == COUNT_MAX) block = add_texels(all, first_texel(object, texture), texels_of(texture));
    own.texels = (uint16_t)block;
    own.palette = (uint16_t)all->palette_colours;
    for (size_t i = 0; i < colours; i++)
        add_colour(all, object->palettes[texture->palette + i]);
    all->textures = grow(all->textures, all->texture_count, &all->texture_capacity, sizeof *all->textures);
    all->textures[all->texture_count] = own;
    return all->texture_count++;
}

static void begin(const struct lim_scene *scene, struct texture_arrays *all)
{
    *all = (struct texture_arrays){.texture_count = scene->texture_count, .texture_capacity = scene->texture_count};
    all->textures = grow_zeroed(scene->texture_count, sizeof *all->textures);
    memcpy(all->textures, scene->textures, scene->texture_count * sizeof *all->textures);
    for (size_t i = 0; i < scene->palette_colours; i++)
        add_colour(all, scene->palettes[i]);
    if (scene->texel_blocks) add_texels(all, scene->texels, scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK);
}

/* Any texel finds a colour. */
static void fill_palette(struct texture_arrays *all)
{
    size_t end = 0;
    for (size_t i = 0; i < all->texture_count; i++)
        if (all->textures[i].palette + (size_t)TEXTURE_COLOURS > end)
            end = all->textures[i].palette + (size_t)TEXTURE_COLOURS;
    while (all->palette_colours < end)
        add_colour(all, 0);
}

static size_t texture_flash_b(const struct lim_scene *scene)
{
    return scene->texture_count * sizeof *scene->textures + scene->palette_colours * sizeof *scene->palettes +
           scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK;
}

static void renumber(struct moving_object *object, const size_t *numbers)
{
    const struct lim_scene *scene = &object->scene.scene;
    object->words = grow_zeroed(scene->polygon_words, sizeof *object->words);
    memcpy(object->words, scene->polygons, scene->polygon_words * sizeof *object->words);
    for (size_t word = 0; word < scene->polygon_words; word += record_at(scene, word).words) {
        const struct record record = record_at(scene, word);
        if (!(record.flags & LIM_POLYGON_TEXTURE)) continue;
        lim_index *const texture = &object->words[word + record.words - LIM_POLYGON_TEXTURE_WORDS];
        *texture = (lim_index)numbers[*texture];
    }
}

static void lead_into(struct moving_object *object, const struct lim_scene *all)
{
    struct lim_scene *scene = &object->scene.scene;
    object->scene.report.flash_b -= texture_flash_b(scene);
    scene->polygons = object->words;
    scene->textures = all->textures;
    scene->palettes = all->palettes;
    scene->texels = all->texels;
    scene->texture_count = all->texture_count;
    scene->palette_colours = all->palette_colours;
    scene->texel_blocks = all->texel_blocks;
}

static void leave_out(struct moving *moving)
{
    for (size_t i = 0; i < moving->count; i++) {
        struct compiled *object = &moving->objects[i].scene;
        object->report.flash_b -= texture_flash_b(&object->scene);
        object->scene.texture_count = 0;
    }
}

static bool collect(const struct moving *moving, struct texture_arrays *all, size_t **numbers)
{
    for (size_t i = 0; i < moving->count; i++) {
        const struct lim_scene *object = &moving->objects[i].scene.scene;
        if (!object->texture_count) continue;
        if (lim_mappings_name_textures(object)) return false; /* its mappings would have to be numbered, too */
        numbers[i] = grow_zeroed(object->texture_count, sizeof **numbers);
        for (size_t k = 0; k < object->texture_count; k++) {
            numbers[i][k] = add_texture(all, object, &object->textures[k]);
            if (numbers[i][k] == COUNT_MAX) return false;
        }
    }
    return true;
}

bool moving_share_textures(struct moving *moving, struct compiled *scene)
{
    struct texture_arrays all;
    size_t **const numbers = grow_zeroed(moving->count, sizeof *numbers);
    begin(&scene->scene, &all);
    const bool ok = collect(moving, &all, numbers);
    if (ok && all.texture_count > 0) {
        fill_palette(&all);
        scene->report.flash_b -= texture_flash_b(&scene->scene);
        lim_image_set_textures(scene, &all);
        scene->report.flash_b += texture_flash_b(&scene->scene);
    }
    for (size_t i = 0; ok && i < moving->count; i++) {
        if (!moving->objects[i].scene.scene.texture_count) continue;
        renumber(&moving->objects[i], numbers[i]);
        lead_into(&moving->objects[i], &scene->scene);
    }
    if (!ok) leave_out(moving);
    for (size_t i = 0; i < moving->count; i++)
        free(numbers[i]);
    free(numbers);
    free(all.textures);
    free(all.palettes);
    free(all.texels);
    return ok;
}
