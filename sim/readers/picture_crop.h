/* SPDX-License-Identifier: MIT
 *
 * Packs of models have one picture for all: of an atlas a model keeps what its faces show. */
#ifndef SIM_PICTURE_CROP_H
#define SIM_PICTURE_CROP_H

#include "model/model.h"

/* Crops pictures to the smallest rectangle, of sides that are powers of two, that holds all that faces show of them,
 * and two pixels around it, wherever that is less than the texture of all; coordinates follow. No pixel changes. The
 * rectangle begins at a multiple of its side, of half or of a quarter of it: so smaller sizes of a picture whose sides
 * are powers of two are parts of its own smaller sizes, but for the last one or two. A side is at least a quarter of
 * the other, so that few of them are missing. Faces that common corners join may lie any number of whole pictures away,
 * together. Left as they are: skies, and pictures that repeat along faces, in that direction. Returns how many were
 * cropped. */
size_t picture_crop(struct model *model);

#endif
