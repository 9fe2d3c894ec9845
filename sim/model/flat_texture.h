/* SPDX-License-Identifier: MIT
 *
 * Pictures that are palettes: modelling programs put the colours of a whole model into one picture, and all of a face
 * onto one of them. */
#ifndef SIM_FLAT_TEXTURE_H
#define SIM_FLAT_TEXTURE_H

#include "model/model.h"

/* Faces that show one colour of their picture alone lose the picture and get that colour. Returns how many. */
size_t flat_texture_find(struct model *model);

#endif
