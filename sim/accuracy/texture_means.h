/* SPDX-License-Identifier: MIT
 *
 * What it takes and loses to show no texture: each face of it in its mean colour. */
#ifndef SIM_TEXTURE_MEANS_H
#define SIM_TEXTURE_MEANS_H

#include "model/model.h"

struct texture_mean {
    double error;   /* mean of (red^2 + green^2 + blue^2) of the differences; each face counts alike */
    size_t colours; /* that the faces have then, in a display's 16 bits */
};

/* Of each picture, of what faces show of it; free() it. */
struct texture_mean *texture_means_make(const struct model *model);

#endif
