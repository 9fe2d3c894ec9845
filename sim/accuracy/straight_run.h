/* SPDX-License-Identifier: MIT
 *
 * Straight pieces of a line of texels: pixels whose places advance evenly. What of their error no straight piece would
 * spare is the perspective step's. */
#ifndef SIM_STRAIGHT_RUN_H
#define SIM_STRAIGHT_RUN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A pixel, and what it shows: in texels of its level. */
struct straight_pixel {
    uint16_t x_px, y_px;
    unsigned level;
    bool begins;              /* a stretch */
    double texels[2], way[2]; /* the place that is shown, and how far that is from the true one */
    double sides[2];          /* of the level: places repeat */
};

struct straight_run {
    struct straight_pixel first, last;
    double step[2]; /* a pixel, once there are two */
    size_t count;
    double x, xx, way[2], x_way[2], ways2; /* sums, x from the first pixel on */
};

/* Adds a pixel; where it does not go on as the run does it begins another one. Returns what straight_run_end() of the
 * run before it does, or 0. */
double straight_run_add(struct straight_run *run, const struct straight_pixel *pixel);

/* Ends a run: the sum of the squares of what is left of its errors beside the straight line that fits them best. */
double straight_run_end(struct straight_run *run);

#endif
