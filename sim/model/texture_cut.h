/* SPDX-License-Identifier: MIT
 *
 * Smaller textures: without their finest levels, and how far one picture is from another. */
#ifndef SIM_TEXTURE_CUT_H
#define SIM_TEXTURE_CUT_H

#include "model/mipmap.h"

/* Leaves out so many of the finest levels, fewer than there are, and colours that nothing shows any more. Of a
 * plain texture. */
void texture_cut(struct texture *texture, unsigned levels);

/* Texels, filled up to blocks, and colours that it would have then. */
size_t texture_cut_texels(const struct texture *texture, unsigned levels);
size_t texture_cut_colours(const struct texture *texture, unsigned levels);

/* Whether it is neither masked, whose holes no mean shows, nor a sky. The others stay as they are. */
bool texture_is_plain(const struct texture *texture);

/* Whether both are plain, of one size, and lie alike. */
bool texture_is_alike(const struct texture *a, const struct texture *b);

/* Mean of (red^2 + green^2 + blue^2) of the differences, where `level` of one is shown as the same or a coarser level
 * of the other: of two that are alike. Colours count 0..255. */
double texture_error(const struct texture *texture, unsigned level, const struct texture *as, unsigned as_level);

/* The same where its mean colour is shown. */
double texture_error_flat(const struct texture *texture, unsigned level);

#endif
