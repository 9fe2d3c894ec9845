/* SPDX-License-Identifier: MIT
 *
 * How a file's coordinates and faces are to be taken: which axis is up, which side of a face is outside. Formats that
 * say it (glTF, COLLADA, FBX) have y up when they are read; OBJ, PLY and STL say nothing. */
#ifndef SIM_MODEL_ORIENTATION_H
#define SIM_MODEL_ORIENTATION_H

#include "base/error.h"
#include "model/model.h"

enum model_up { UP_BY_EVIDENCE, UP_Y, UP_Z };

/* What files of a format have, and how the importer hands it over. */
enum up_custom {
    CUSTOM_Y, /* y up, or nobody knows */
    CUSTOM_Z, /* mostly z up (STL): unless the model stands on the side of its least y and not on that of its least z */
    CUSTOM_ALWAYS_Y, /* y up by what reads them (maps of WADs) */
    CUSTOM_ALWAYS_Z, /* z up by the program that writes them (Blender, trueSpace) */
    CUSTOM_TURNED    /* mostly z up, and the importer has turned them by a quarter, asked or not (3ds Max's) */
};

struct orientation {
    enum model_up up;
    bool reverse_faces; /* the file's are clockwise, seen from outside */
    bool two_sided;     /* all faces are seen from both sides */
};

/* Rows of a table for getopt_long(), and what it returns then. `text`: of --up. */
#define ORIENTATION_OPTIONS                                                                                            \
    {"up", required_argument, NULL, ORIENTATION_UP}, {"reverse-faces", no_argument, NULL, ORIENTATION_REVERSE_FACES},  \
    {                                                                                                                  \
        "two-sided", no_argument, NULL, ORIENTATION_TWO_SIDED                                                          \
    }
enum orientation_code { ORIENTATION_UP = 1024, ORIENTATION_REVERSE_FACES, ORIENTATION_TWO_SIDED };
bool orientation_parse(int code, const char *text, struct orientation *out, struct error *err);

/* A point of a file whose z is up, as y is up. */
void orientation_turn_up(double at_m[3]);

/* Turns the model, whose coordinates are the file's, so that y is up. Notices tell what was found out without being
 * asked, and what looks wrong. */
void orientation_apply(const struct orientation *orientation, enum up_custom custom, struct model *model);

/* A point of the same file, as orientation_apply() has turned the model's. Exact. */
void orientation_point(const struct model *model, double at_m[3]);

/* How much of the area below the model (of the box round it, seen along the axis) is its own flat underside: 0 to 1,
 * or a little more where faces overlap; 0 of what is flat itself. axis: 1 for y, 2 for z. */
double orientation_underside(const struct model *model, int axis);

#endif
