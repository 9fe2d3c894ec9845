/* SPDX-License-Identifier: MIT
 *
 * Pictures of what reflects light and emits some: made of a material's colour and emission, each of which may have a
 * picture. */
#ifndef SIM_EMISSIVE_PICTURE_H
#define SIM_EMISSIVE_PICTURE_H

#include "model/mipmap.h"

struct emission_of {
    uint32_t colour_picture, light_picture; /* numbers, from 1; 0: it has none, and is the same everywhere */
    uint32_t colour;                        /* 0xRRGGBB, times its picture */
    double light[3];                        /* linear light, times its picture */
};

/* Those that were made. */
struct emissive_pictures {
    struct emissive_picture {
        struct emission_of of;
        uint32_t number;
    } * made;
    size_t count, capacity;
};

/* 0: it was not made yet. */
uint32_t emissive_picture_find(const struct emissive_pictures *made, const struct emission_of *of);

/* As pictures[count], for which there is room: as large as the larger of the two pictures, of which one is there at
 * least and both have pixels. What it is called, and how it is seen through and beyond its borders, is that of the
 * colour's picture, if there is one. */
uint32_t emissive_picture_make(struct emissive_pictures *made, const struct emission_of *of, struct picture *pictures,
                               uint32_t count);
void emissive_pictures_free(struct emissive_pictures *made);

#endif
