/* SPDX-License-Identifier: MIT */
#include "files/masked_picture.h"

#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

static bool is_same(const struct mask_of *a, const struct mask_of *b)
{
    return a->picture == b->picture && a->mask == b->mask && a->least_alpha == b->least_alpha;
}

uint32_t masked_picture_find(const struct masked_pictures *masked, const struct mask_of *of)
{
    for (size_t i = 0; i < masked->count; i++)
        if (is_same(&masked->made[i].of, of)) return masked->made[i].number;
    return 0;
}

/* 0..1, at a pixel of a picture of this size. */
static double opacity_at(const struct picture *mask, bool is_own, size_t x, size_t y, const struct picture *picture)
{
    const size_t column = (2 * x + 1) * mask->w_px / (2 * (size_t)picture->w_px);
    const size_t row = (2 * y + 1) * mask->h_px / (2 * (size_t)picture->h_px), at = row * mask->w_px + column;
    if (mask->alpha) return mask->alpha[at] / 255.0;
    if (is_own) return 1;
    const uint32_t rgb = mask->pixels[at];
    return (2 * (rgb >> 16 & 0xFF) + 5 * (rgb >> 8 & 0xFF) + (rgb & 0xFF)) / (8 * 255.0);
}

/* Whether any pixel is clear. */
static bool cut_holes(struct picture *picture, const struct picture *mask, const struct mask_of *of)
{
    bool any = false;
    for (size_t y = 0; y < picture->h_px; y++)
        for (size_t x = 0; x < picture->w_px; x++) {
            if (opacity_at(mask, of->mask == of->picture, x, y, picture) >= of->least_alpha) continue;
            picture->pixels[y * picture->w_px + x] |= PICTURE_CLEAR;
            any = true;
        }
    return any;
}

static bool make(const struct mask_of *of, struct picture *pictures, struct picture *out)
{
    const struct picture *from = &pictures[of->picture - 1], *mask = &pictures[of->mask - 1];
    const size_t count = (size_t)from->w_px * from->h_px;
    if (!from->pixels || !mask->pixels) return false;
    *out = *from;
    out->faces = out->clear_faces = 0;
    out->alpha = NULL;
    out->pixels = grow_zeroed(count, sizeof *out->pixels);
    memcpy(out->pixels, from->pixels, count * sizeof *out->pixels);
    out->is_masked = cut_holes(out, mask, of);
    if (!out->is_masked) free(out->pixels);
    return out->is_masked;
}

uint32_t masked_picture_make(struct masked_pictures *masked, const struct mask_of *of, struct picture *pictures,
                             uint32_t count)
{
    const uint32_t number = make(of, pictures, &pictures[count]) ? count + 1 : of->picture;
    masked->made = grow(masked->made, masked->count, &masked->capacity, sizeof *masked->made);
    masked->made[masked->count++] = (struct masked_picture){*of, number};
    return number;
}

void masked_pictures_free(struct masked_pictures *masked)
{
    free(masked->made);
    *masked = (struct masked_pictures){0};
}
