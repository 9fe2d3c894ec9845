/* SPDX-License-Identifier: MIT
 *
 * Pictures with holes, made of a material's picture and of what says how opaque it is: its own alpha, or the picture
 * that is its mask. */
#ifndef SIM_MASKED_PICTURE_H
#define SIM_MASKED_PICTURE_H

#include "model/mipmap.h"

struct mask_of {
    uint32_t picture, mask; /* numbers, from 1; the same: the picture has an alpha of its own */
    double least_alpha;     /* what has less is clear */
};

/* Those that were made. */
struct masked_pictures {
    struct masked_picture {
        struct mask_of of;
        uint32_t number;
    } * made;
    size_t count, capacity;
};

/* 0: it was not made yet. */
uint32_t masked_picture_find(const struct masked_pictures *masked, const struct mask_of *of);

/* As pictures[count], for which there is room. Returns its number, which is that of the picture itself where nothing is
 * clear, or where either could not be read. A mask of another size is looked up at the nearest pixels; where it has no
 * alpha, white is opaque. */
uint32_t masked_picture_make(struct masked_pictures *masked, const struct mask_of *of, struct picture *pictures,
                             uint32_t count);
void masked_pictures_free(struct masked_pictures *masked);

#endif
