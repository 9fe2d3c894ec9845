/* SPDX-License-Identifier: MIT
 *
 * Pictures that are clamped or mirrored beyond their borders (picture.wrap), for a renderer whose textures repeat.
 * Where a face leaves a mirrored picture, the picture is made twice as long, with its mirror image behind it. Where one
 * leaves a clamped picture, the face is cut along its border, and what is outside shows the border's texels, drawn out.
 */
#ifndef SIM_TEXTURE_WRAP_H
#define SIM_TEXTURE_WRAP_H

#include "model/model.h"

/* Whether texture_wrap_apply() would cut faces: then the model has more faces than its file, and those of one of the
 * file's have its number. */
bool texture_wrap_cuts(const struct model *model);

/* Afterwards all pictures repeat. Source points are cut as the points are. */
void texture_wrap_apply(struct model *model);

#endif
