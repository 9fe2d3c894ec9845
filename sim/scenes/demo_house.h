/* SPDX-License-Identifier: MIT
 *
 * The house of the demo scene: its shell, openings and built-in parts, and where its light comes
 * from. x runs east, z south; the ground floor is at y = 0. */
#ifndef DEMO_HOUSE_H
#define DEMO_HOUSE_H

#include "demo_soup.h"
#include "demo_window.h"

#include <stdbool.h>
#include <stddef.h>

/* A rectangle through which skylight comes, or sky itself. Light leaves along edge_u x edge_v. */
struct opening {
    struct vec3 corner, edge_u, edge_v;
    double brightness;
};

struct lamp {
    struct vec3 at;
    double radius_m; /* of the ball that the light comes from: softens shadows */
    struct vec3 power;
};

extern const struct window house_windows[];
extern const size_t house_window_count;
extern const struct opening house_skies[];
extern const size_t house_sky_count;
extern const struct lamp house_lamps[];
extern const size_t house_lamp_count;

/* The way that sunlight goes; not a unit vector. */
extern const struct vec3 house_sun;

/* The sun also comes through the kitchen's door, and into the court past two edges; the point
 * named lit lies on the sunny side of both. */
extern const struct vec3 house_kitchen_door[4];
extern const struct vec3 house_court_edges[2][2];
extern const struct vec3 house_court_lit;

void house_build(struct soup *soup);

#endif
