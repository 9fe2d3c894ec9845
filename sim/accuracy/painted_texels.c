/* SPDX-License-Identifier: MIT
 *
 * Textures that share texels are of one size, so what a texel says of its place is the same for all of them. */
#include "accuracy/painted_texels.h"

#include "colour.h"

#include <stdlib.h>
#include <string.h>

enum { COLOURS = 256, LOW_BITS = 8, HIGH = 3, LEVEL_SHIFT = 4, Y_SHIFT = 2 };

static uint8_t code_of(int pass, unsigned x, unsigned y, unsigned level)
{
    if (pass == 0) return (uint8_t)x;
    if (pass == 1) return (uint8_t)y;
    return (uint8_t)(x >> LOW_BITS | y >> LOW_BITS << Y_SHIFT | level << LEVEL_SHIFT);
}

static void fill(uint8_t *to, const struct lim_texture *texture, int pass)
{
    for (unsigned level = 0; level < texture->levels; level++)
        for (unsigned y = 0; y < 1u << (texture->h_bits - level); y++)
            for (unsigned x = 0; x < 1u << (texture->w_bits - level); x++)
                *to++ = code_of(pass, x, y, level);
}

static bool make_textures(struct painted_texels *painted, const struct lim_scene *scene)
{
    painted->textures = malloc(scene->texture_count * sizeof *painted->textures);
    if (!painted->textures) return false;
    memcpy(painted->textures, scene->textures, scene->texture_count * sizeof *painted->textures);
    for (int pass = 0; pass < PAINTED_PASSES; pass++) {
        painted->texels[pass] = calloc(scene->texel_blocks, LIM_TEXEL_BLOCK);
        if (!painted->texels[pass]) return false;
        for (size_t i = 0; i < scene->texture_count; i++)
            fill(painted->texels[pass] + scene->textures[i].texels * (size_t)LIM_TEXEL_BLOCK, &scene->textures[i],
                 pass);
    }
    for (size_t i = 0; i < scene->texture_count; i++)
        painted->textures[i].palette = 0;
    return true;
}

bool painted_texels_init(struct painted_texels *painted, const struct compiled *scene,
                         const struct simulator_setup *setup, struct error *err)
{
    painted->scene = scene->scene;
    painted->pixels = calloc((size_t)setup->w_px * setup->h_px, sizeof *painted->pixels);
    if (!painted->pixels || !make_textures(painted, &scene->scene)) return error_set(err, "texels: out of memory");
    painted->scene.textures = painted->textures;
    for (unsigned i = 0; i < COLOURS; i++)
        painted->palette[i] = lim_memory_colour((uint16_t)i);
    painted->scene.palettes = painted->palette;
    painted->scene.palette_colours = COLOURS;
    painted->scene.texels = painted->texels[0];
    return simulator_init(&painted->simulator, &painted->scene, setup, err);
}

bool painted_texels_frame(struct painted_texels *painted, const struct lim_camera *camera, struct error *err)
{
    const size_t count = simulator_pixel_count(&painted->simulator);
    for (int pass = 0; pass < PAINTED_PASSES; pass++) {
        painted->scene.texels = painted->texels[pass];
        if (painted->simulator.roomy) painted->simulator.roomy->texels = painted->texels[pass];
        if (!simulator_frame(&painted->simulator, camera, err)) return false;
        for (size_t i = 0; i < count; i++) {
            struct painted_texel *const pixel = &painted->pixels[i];
            const unsigned code = painted->simulator.pixels[i];
            if (pass == 0) pixel->x = (uint16_t)code;
            if (pass == 1) pixel->y = (uint16_t)code;
            if (pass < 2) continue;
            pixel->x = (uint16_t)(pixel->x | (code & HIGH) << LOW_BITS);
            pixel->y = (uint16_t)(pixel->y | (code >> Y_SHIFT & HIGH) << LOW_BITS);
            pixel->level = (uint8_t)(code >> LEVEL_SHIFT);
        }
    }
    return true;
}

void painted_texels_free(struct painted_texels *painted)
{
    simulator_free(&painted->simulator);
    for (int pass = 0; pass < PAINTED_PASSES; pass++)
        free(painted->texels[pass]);
    free(painted->textures);
    free(painted->pixels);
    *painted = (struct painted_texels){.pixels = NULL};
}
