/* SPDX-License-Identifier: MIT
 *
 * Faces of a map as those of a model: metres, y up, textures as pictures, light in the colours. */
#ifndef SIM_LEVEL_FACES_H
#define SIM_LEVEL_FACES_H

#include "levels/level_textures.h"
#include "model/model.h"

/* A player's eyes are 41 units above the floor: 1.28 m. */
enum { LEVEL_UNITS_A_M = 32, LEVEL_EYE_UNITS = 41 };

struct level_faces {
    struct model *model;
    struct level_textures *textures;
    bool is_textured;
    uint16_t mover;     /* of faces that are added: model_face.mover */
    uint32_t *pictures; /* of each look, whole, masked and as a sky, model_face.picture; 0: not yet */
    size_t picture_capacity, look_capacity;
    size_t point_capacity, uv_capacity, corner_capacity, face_capacity;
};

/* On the map, in its units; u and v in texels, across and down. */
struct level_corner {
    double x, y, height, u, v;
};

struct level_paint {
    size_t look;
    bool is_plain;        /* its mean colour, not its texels */
    bool is_sky;          /* around the eye */
    uint32_t light;       /* 0xVVVVVV */
    uint8_t transparency; /* 255: invisible; with a texture, whose clear texels are holes: the share of these */
};

/* Corners run counter-clockwise as seen from outside. */
void level_face_add(struct level_faces *faces, const struct level_corner *corners, size_t count,
                    const struct level_paint *paint);

/* A place on the map in metres. */
void level_place(double x, double y, double height, double out_m[3]);

#endif
