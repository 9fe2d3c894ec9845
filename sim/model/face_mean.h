/* SPDX-License-Identifier: MIT
 *
 * The mean of the texels that a face shows: its colour where it has no texture. */
#ifndef SIM_FACE_MEAN_H
#define SIM_FACE_MEAN_H

#include "model/model.h"

struct face_mean {
    uint32_t colour;    /* 0xRRGGBB, of what is not clear, without the face's own colour */
    double clear_share; /* of the face: 0..1 */
    double error;       /* mean of (red^2 + green^2 + blue^2) of what is not clear, less the mean colour */
};

/* In sRGB values, as the smaller sizes of a texture are made: a face looks as its texture does from afar. Of the whole
 * picture, if it is a sky, or if the face's coordinates are too large to tell texels apart. false: it has no
 * coordinates, or such that are not finite. The picture has pixels. */
bool face_mean_of(const struct model *model, const struct model_face *face, const struct picture *picture,
                  struct face_mean *out);

#endif
