/* SPDX-License-Identifier: MIT */
#include "readers/emissive_picture.h"

#include "base/grow.h"
#include "model/srgb.h"

#include <stdlib.h>
#include <string.h>

static bool is_same(const struct emission_of *a, const struct emission_of *b)
{
    return a->colour_picture == b->colour_picture && a->light_picture == b->light_picture && a->colour == b->colour &&
           memcmp(a->light, b->light, sizeof a->light) == 0;
}

uint32_t emissive_picture_find(const struct emissive_pictures *made, const struct emission_of *of)
{
    for (size_t i = 0; i < made->count; i++)
        if (is_same(&made->made[i].of, of)) return made->made[i].number;
    return 0;
}

/* The pixel that lies where pixel x, y of a picture of that size does. */
static size_t nearest(const struct picture *picture, size_t x, size_t y, const struct picture *size)
{
    const size_t column = (2 * x + 1) * picture->w_px / (2 * (size_t)size->w_px);
    const size_t row = (2 * y + 1) * picture->h_px / (2 * (size_t)size->h_px);
    return row * picture->w_px + column;
}

static uint32_t emitted(uint32_t texel, const double light[3])
{
    uint32_t out = 0;
    for (int i = 0; i < 3; i++) {
        const double own = srgb_to_linear((texel >> (16 - 8 * i) & 0xFF) / 255.0);
        out = out << 8 | srgb_byte(srgb_from_linear(light[i] * own));
    }
    return out;
}

static void paint(const struct emission_of *of, const struct picture *pictures, struct picture *out)
{
    const struct picture *colour = of->colour_picture ? &pictures[of->colour_picture - 1] : NULL;
    const struct picture *light = of->light_picture ? &pictures[of->light_picture - 1] : NULL;
    for (size_t y = 0; y < out->h_px; y++)
        for (size_t x = 0; x < out->w_px; x++) {
            const uint32_t own = colour ? colour->pixels[nearest(colour, x, y, out)] : 0xFFFFFF;
            const uint32_t glow = light ? light->pixels[nearest(light, x, y, out)] : 0xFFFFFF;
            const size_t at = y * out->w_px + x;
            out->pixels[at] = srgb_sum(srgb_tinted(own, of->colour), emitted(glow, of->light));
            if (out->alpha) out->alpha[at] = colour->alpha[nearest(colour, x, y, out)];
        }
}

static uint32_t larger(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

static void make(const struct emission_of *of, struct picture *pictures, struct picture *out)
{
    const struct picture *light = &pictures[(of->light_picture ? of->light_picture : of->colour_picture) - 1];
    const struct picture *like = of->colour_picture ? &pictures[of->colour_picture - 1] : light;
    *out = *like;
    out->faces = out->clear_faces = 0;
    out->w_px = larger(like->w_px, light->w_px);
    out->h_px = larger(like->h_px, light->h_px);
    out->found_w_px = larger(like->found_w_px, light->found_w_px);
    out->found_h_px = larger(like->found_h_px, light->found_h_px);
    const size_t count = (size_t)out->w_px * out->h_px;
    const bool has_alpha = of->colour_picture && like->alpha;
    out->has_alpha = has_alpha;
    out->alpha = has_alpha ? grow_zeroed(count, 1) : NULL;
    out->pixels = grow_zeroed(count, sizeof *out->pixels);
    paint(of, pictures, out);
}

uint32_t emissive_picture_make(struct emissive_pictures *made, const struct emission_of *of, struct picture *pictures,
                               uint32_t count)
{
    make(of, pictures, &pictures[count]);
    made->made = grow(made->made, made->count, &made->capacity, sizeof *made->made);
    made->made[made->count++] = (struct emissive_picture){*of, count + 1};
    return count + 1;
}

void emissive_pictures_free(struct emissive_pictures *made)
{
    free(made->made);
    *made = (struct emissive_pictures){0};
}
