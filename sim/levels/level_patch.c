/* SPDX-License-Identifier: MIT
 *
 * A patch has its sides, and for each column where its posts are: runs of texels with what is clear between them.
 * Source: Fell, The Unofficial Doom Specs 1.666, 1994, chapter 5. Posts of patches higher than 254 begin at a place
 * that counts from the post before, where it is not below that. */
#include "levels/level_patch.h"

#include "base/grow.h"

#include <stdlib.h>

enum { PATCH_HEADER_B = 8, POST_END = 255, PATCH_SIDE_MAX = 4096 };

bool level_flat_read(const struct wad_lump *lump, struct level_picture *out)
{
    *out = (struct level_picture){FLAT_SIDE_PX, FLAT_SIDE_PX, NULL};
    if (!lump->bytes || lump->size_b < FLAT_SIDE_PX * FLAT_SIDE_PX) return false;
    out->texels = grow_zeroed(FLAT_SIDE_PX * FLAT_SIDE_PX, sizeof *out->texels);
    for (size_t i = 0; i < FLAT_SIDE_PX * FLAT_SIDE_PX; i++)
        out->texels[i] = lump->bytes[i];
    return true;
}

static void draw_post(const uint8_t *texels, int count, int x, int y, struct level_picture *picture)
{
    if (x < 0 || x >= (int)picture->w_px) return;
    for (int i = 0; i < count; i++)
        if (y + i >= 0 && y + i < (int)picture->h_px)
            picture->texels[(size_t)(y + i) * picture->w_px + (size_t)x] = texels[i];
}

static bool draw_column(const struct wad_lump *lump, size_t at, int x, int top_px, struct level_picture *picture)
{
    int row = -1;
    for (; at < lump->size_b && lump->bytes[at] != POST_END;) {
        if (lump->size_b - at < 4) return false;
        const int from = lump->bytes[at], count = lump->bytes[at + 1];
        if (lump->size_b - at < (size_t)count + 4) return false;
        row = from <= row ? row + from : from;
        draw_post(lump->bytes + at + 3, count, x, top_px + row, picture);
        at += (size_t)count + 4;
    }
    return at < lump->size_b;
}

bool level_patch_draw(const struct wad_lump *lump, int left_px, int top_px, struct level_picture *picture)
{
    if (!lump->bytes || lump->size_b < PATCH_HEADER_B) return false;
    const int w_px = wad_u16(lump->bytes);
    if (w_px > PATCH_SIDE_MAX || lump->size_b < PATCH_HEADER_B + 4 * (size_t)w_px) return false;
    bool is_good = true;
    for (int x = 0; x < w_px; x++)
        is_good &= draw_column(lump, wad_u32(lump->bytes + PATCH_HEADER_B + 4 * x), left_px + x, top_px, picture);
    return is_good;
}

void level_picture_free(struct level_picture *picture)
{
    free(picture->texels);
    *picture = (struct level_picture){0};
}
