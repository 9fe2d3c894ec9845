/* SPDX-License-Identifier: MIT
 *
 * A model as its file has it: polygons in metres, in the file's order, nothing mended yet. */
#ifndef SIM_MODEL_H
#define SIM_MODEL_H

#include "base/error.h"
#include "model/mipmap.h"
#include "model/source_motion.h"

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
    uint32_t emission;     /* 0xRRGGBB (sRGB), added to the colour once that is lit, a channel up to 255 */
    uint32_t number;       /* in the file, from 1; 0: its place among the model's faces, from 1 */
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

/* What a mover is for: it moves by its animation; or when somebody comes: a door whose way up is its animation, a lift
 * whose way down is. */
enum model_kind { MODEL_MOVES, MODEL_DOOR, MODEL_LIFT };

/* A node that an animation moves, with all below it. */
struct model_mover {
    char name[MODEL_NAME_B];
    enum model_kind kind;
    struct model_pose rest; /* where `points` have it */
    uint32_t first_key, key_count;
    uint32_t node; /* its number in the file, from 1; 0: the format has none */
};

struct model {
    double (*points)[3]; /* metres, y up, right-handed, node transforms applied; some may be unused */
    double (*uvs)[2]; /* of each point, in pictures, across from the left and down from the top; NULL: there are none */
    double (*source_points)[3]; /* the points as the reference's own reader has them (source.h); NULL: not read by it */
    bool has_no_source;         /* that reader was asked, and does not know the format */
    struct source_motion *source_motion; /* likewise what moves; NULL: keys are all that is known */
    size_t point_count;
    uint32_t *corners; /* indices into points */
    size_t corner_count;
    struct model_face *faces; /* in the file's order */
    size_t face_count;
    size_t made_faces;    /* the last ones, which are not the file's (moving_frame.h) */
    size_t alpha_clamped; /* faces whose material's opacity was below 0 or above 1, and is the nearer of them now */
    size_t faces_of_many_colours; /* whose corners' colours differ: each has the mean of them */
    struct picture *pictures;     /* also those that cannot be read */
    size_t picture_count;
    uint8_t texture_bits; /* of a part: no side of a texture is longer than 2^texture_bits; 0: nobody has said */
    struct model_mover *movers;
    size_t mover_count;
    struct model_key *keys; /* of each mover, by time */
    size_t key_count;
    size_t flat_faces, mean_faces;      /* that have a colour for their picture: all they show, or the mean of it */
    bool is_stopped;                    /* the file has animations, which were left out */
    double lattice_m;                   /* every coordinate is a multiple of this; 0: of nothing that is known */
    bool is_interior;                   /* seen from within alone: no eye is meant to be where backs are seen */
    bool says_z_up;                     /* the file itself, and it was not turned yet */
    bool z_was_up, faces_were_reversed; /* by model_orientation.h; the file has them otherwise */
    char textures_became[192];          /* all of them, for --texture-budget, for people; empty: nothing */
    char notice[8192]; /* lines of what was left out, or is not as it should be, and why; empty: nothing */
};

enum { MODEL_DEFAULT_COLOUR = 0xC8C8C8 }; /* of faces that have neither material nor vertex colours */

void model_free(struct model *model);

/* Of faces[index], in the file, from 1. */
static inline uint32_t model_face_number(const struct model *model, size_t index)
{
    return model->faces[index].number ? model->faces[index].number : (uint32_t)index + 1;
}

/* Adds a line to the notice, printf-style, without a newline. One that does not fit is replaced by words that say so.
 */
void model_note(struct model *model, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Tells each line by notice(). */
void model_tell(const char *path, const struct model *model);

#endif
