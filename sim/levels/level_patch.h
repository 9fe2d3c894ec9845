/* SPDX-License-Identifier: MIT
 *
 * Pictures in Doom's formats, in the colours of a palette: flats, and wall textures that are composed of patches. */
#ifndef SIM_LEVEL_PATCH_H
#define SIM_LEVEL_PATCH_H

#include "levels/wad.h"

enum { FLAT_SIDE_PX = 64, CLEAR_TEXEL = -1 };

struct level_picture {
    unsigned w_px, h_px;
    int16_t *texels; /* rows from the top: an index into the palette, or CLEAR_TEXEL; owned */
};

/* A lump of 64x64 texels. false: it is shorter. */
bool level_flat_read(const struct wad_lump *lump, struct level_picture *out);

/* Draws a patch over what is there; what is outside is left out. false: it is broken, and drawn as far as it is not. */
bool level_patch_draw(const struct wad_lump *lump, int left_px, int top_px, struct level_picture *picture);

void level_picture_free(struct level_picture *picture);

#endif
