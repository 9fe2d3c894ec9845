/* SPDX-License-Identifier: MIT
 *
 * One polygon as a closed loop of corners: indices into an array of points, counter-clockwise seen
 * from its front. Distances are metres; `near_m` is what counts as nothing: a corner nearer than
 * that to the segment between its neighbours makes no bend. */
#ifndef SIM_LOOP_H
#define SIM_LOOP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct loop {
    double (*points)[3];
    const uint32_t *corners;
    size_t count;
};

struct loop_plane {
    double normal[3]; /* of length 1, towards the front */
    double centre[3]; /* the mean of the corners */
};

/* The two axes that see most of a plane, in an order that keeps the loop counter-clockwise. */
struct loop_view {
    int u, v;
};

/* Drops repeated corners, and spikes where the loop turns back on itself, from the array in place.
 * Returns how many corners are left; fewer than 3: the loop encloses nothing. */
size_t loop_tidy(double (*points)[3], uint32_t *corners, size_t count, double near_m);

/* Do the corners leave the line through the two outermost of them? */
bool loop_has_area(const struct loop *loop, double near_m);

/* Newell's plane, which weighs all corners alike. Needs a loop that has area. */
struct loop_plane loop_plane_of(const struct loop *loop);

/* How far the farthest corner is off the plane. */
double loop_off_plane_m(const struct loop *loop, const struct loop_plane *plane);

struct loop_view loop_view_along(const double normal[3]);

/* Twice the signed area of a triangle of points as the view sees it: > 0 is counter-clockwise. */
double loop_turn(double (*points)[3], const struct loop_view *view, uint32_t a, uint32_t b, uint32_t c);

/* Convex within its plane, straight corners allowed; goes round once. */
bool loop_is_convex(const struct loop *loop, const struct loop_plane *plane, double near_m);

#endif
