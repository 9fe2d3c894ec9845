/* SPDX-License-Identifier: MIT
 *
 * A model as its file has it: polygons in metres, in the file's order, nothing mended yet.
 * Imported by assimp (OBJ, glTF, STL, PLY, ...); quads and n-gons are kept. */
#ifndef SIM_MODEL_H
#define SIM_MODEL_H

#include "base/error.h"
#include "model/texture.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct model_face {
    uint32_t first, count; /* corners[first .. first + count), counter-clockwise seen from outside */
    uint32_t colour;       /* 0xRRGGBB as a display shows it (sRGB): material times vertex colours */
    bool two_sided;        /* the material asks for both sides */
    uint8_t transparency;  /* 0 is opaque, 255 invisible */
    uint32_t picture;      /* 1-based, of what the face shows, times its colour; 0: none */
    bool unlit;            /* the material's colour is final: no light is baked in */
    uint16_t mover;        /* 0: it stays where it is; else movers[mover - 1] moves it */
};

enum { MODEL_NAME_B = 48 };

/* Where a mover is at a time, as a rigid motion from its own coordinates: p = turn(l) + at. */
struct model_pose {
    double at_m[3];
    double turn[4]; /* a unit quaternion x, y, z, w */
};

struct model_key {
    double time_s;
    struct model_pose pose;
};

/* A node that an animation moves, with all below it. */
struct model_mover {
    char name[MODEL_NAME_B];
    struct model_pose rest; /* where `points` have it */
    uint32_t first_key, key_count;
};

struct model {
    double (*points)[3]; /* metres, y up, right-handed, node transforms applied; some may be unused */
    double (*uvs)[2]; /* of each point, in pictures, across from the left and down from the top; NULL: there are none */
    double (*source_points)[3]; /* the points as the reference's own reader has them (source.h); NULL: not read by it */
    size_t point_count;
    uint32_t *corners; /* indices into points */
    size_t corner_count;
    struct model_face *faces; /* faces[i] is face number i + 1 of the file */
    size_t face_count;
    const uint32_t *numbers;  /* of each face in the file, somebody else's; NULL: faces[i] is number i + 1 */
    size_t alpha_clamped;     /* faces whose material's opacity was below 0 or above 1, and is the nearer of them now */
    struct picture *pictures; /* also those that cannot be read */
    size_t picture_count;
    struct model_mover *movers;
    size_t mover_count;
    struct model_key *keys; /* of each mover, by time */
    size_t key_count;
    char notice[512]; /* what was left out, or is not as it should be, and why; empty: nothing */
};

enum { MODEL_DEFAULT_COLOUR = 0xC8C8C8 }; /* of faces that have neither material nor vertex colours */

/* Reads a model file. Refuses, naming file and reason: missing, unreadable or unknown format, no
 * faces, NaN or infinite coordinates, an opacity that is NaN, indices out of range, more than 2^26 corners. On success
 * the caller owns *model, otherwise it is empty.
 *
 * Faces are numbered from 1; points and lines are none. In OBJ, STL and PLY files the order is that
 * of the file. Formats with a node tree (glTF, ...) are numbered node by node, parents first, then
 * by mesh of the node, then by face of the mesh. A mirroring transform turns its faces round.
 *
 * OBJ colours are taken as sRGB. Base colours of physically based materials (glTF) are linear
 * light, as that format says, and become sRGB here. Of the textures the one
 * of the colour is read, as opaque (picture.clear_faces); it repeats, whatever the file says. One that cannot be read
 * is no error.
 *
 * Opacity is MTL's `d` (or 1 - `Tr`); glTF's base colour's and vertex colours' alpha where alphaMode is BLEND, all or
 * nothing where it is MASK, and nothing where it is OPAQUE.
 *
 * Animations move nodes rigidly. Points are where the nodes' own transforms have them; all animations of the file run
 * at once. Keys are joined by straight lines and even turns, whatever the file says. Refused, by name: an animated node
 * that is scaled by its keys, mirrored or sheared, below another one that is animated, or not the only one of its name.
 * Notices: one without a mesh, or with fewer than two keys, stands still; of several animations that move, or turn, the
 * same node the first counts. */
bool model_import(const char *path, struct model *model, struct error *err);
void model_free(struct model *model);

/* Adds to the notice. */
void model_note(struct model *model, const char *text);

#endif
