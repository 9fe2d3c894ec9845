/* SPDX-License-Identifier: MIT
 *
 * Baked light: so that a model without any light of its own reads as solid. */
#ifndef BAKED_LIGHT_H
#define BAKED_LIGHT_H

#include "model/model.h"
#include "orders.h"

/* Dims each face's colour by its angle to a light above the viewer's left shoulder: full where the
 * face looks at it, a quarter where it looks away. Faces whose material is unlit keep theirs. Then
 * what they emit is added. */
void light_bake(struct model *model);

/* Adds what faces emit, and no more. */
void light_none(struct model *model);

/* For a panel of black and white pixels: tones (mono_tones.h), and more between light and shade. */
void light_bake_mono(struct model *model);

/* The same light for firmware that lights movers in each frame. */
struct lim_light light_lamp(void);
struct lim_light light_lamp_mono(void);

#endif
