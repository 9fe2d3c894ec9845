/* SPDX-License-Identifier: MIT
 *
 * Faces that get a colour for their picture. Pictures are often palettes: modelling programs put the colours of a whole
 * model, or of a pack of models, into one picture, and all of a face onto one of them. */
#ifndef SIM_FLAT_TEXTURE_H
#define SIM_FLAT_TEXTURE_H

#include "model/model.h"

/* Faces that show one colour of their picture alone lose the picture and get that colour: at the picture's full size
 * nothing changes, and smaller sizes would mix in the colours around it. Returns how many. */
size_t flat_texture_find(struct model *model);

/* The face gets the mean of the texels that it shows (face_mean.h). Where some are clear, it becomes as transparent as
 * is their share; of a material that is glass itself they do not count. false: it has no picture with pixels, or no
 * coordinates in it. */
bool flat_texture_take_mean(struct model *model, struct model_face *face);

/* All faces do. Returns how many. */
size_t flat_texture_take_means(struct model *model);

#endif
