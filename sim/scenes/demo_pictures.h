/* SPDX-License-Identifier: MIT
 *
 * The painter's work: pictures made of coloured polygons inlaid in a canvas. */
#ifndef DEMO_PICTURES_H
#define DEMO_PICTURES_H

#include "demo_soup.h"

enum picture_id { SEASCAPE, WINDMILL, PORTRAIT, STILL_LIFE, MINIATURE_LADY, MINIATURE_LORD, MAP, PICTURES };

/* Framed, on a wall: the frame stands at the middle of the picture, on the wall's surface. */
void picture_hang(struct soup *soup, const struct frame *frame, enum picture_id id, int width_mm, int height_mm);

/* A bare canvas on a stretcher 25 mm thick, standing on the frame's origin. */
void picture_stretch(struct soup *soup, const struct frame *frame, enum picture_id id, int width_mm, int height_mm);

#endif
