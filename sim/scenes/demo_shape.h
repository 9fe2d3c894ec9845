/* SPDX-License-Identifier: MIT
 *
 * The solids that furniture is made of, placed in a frame; all sizes in millimetres. Sides that
 * touch something are left out, so that no two visible faces share a plane. */
#ifndef DEMO_SHAPE_H
#define DEMO_SHAPE_H

#include "demo_soup.h"

#include <stdbool.h>

/* Sides of a box that are not drawn. */
enum {
    NO_LEFT = 1,
    NO_RIGHT = 2,
    NO_BOTTOM = 4,
    NO_TOP = 8,
    NO_BACK = 16,
    NO_FRONT = 32,
    NO_ENDS = NO_LEFT | NO_RIGHT,
    LEG = NO_BOTTOM | NO_TOP,
    STANDING = NO_BOTTOM,
};

struct box {
    int lo_mm[3], hi_mm[3];
    int material;
    int hidden;
    int taper_mm; /* how far the drawn sides lean in towards the top */
};

/* A ring of a turned solid. Radius 0 makes a tip. */
struct ring {
    int radius_mm, y_mm;
};

enum { RINGS = 8, SIDES_MAX = 12 };

/* A solid of revolution: a prism of few sides, narrow at some rings and wide at others. */
struct turned {
    int x_mm, z_mm; /* its axis */
    int material;
    int sides;
    int rings;
    bool open_top; /* no lid on the last ring */
    struct ring ring[RINGS];
};

/* Folded cloth hanging in the plane z = 0 from the frame's origin up to height and right to width. */
struct drape {
    int width_mm, height_mm;
    int depth_mm; /* of the folds */
    int folds;
    int material;
    bool two_sided;
};

void shape_quad(struct soup *soup, const struct frame *frame, const double corner_mm[4][3], int material);
void shape_box(struct soup *soup, const struct frame *frame, const struct box *box);
void shape_turned(struct soup *soup, const struct frame *frame, const struct turned *turned);
void shape_drape(struct soup *soup, const struct frame *frame, const struct drape *drape);

#endif
