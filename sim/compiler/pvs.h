/* SPDX-License-Identifier: MIT
 *
 * What is seen from each zone, as a scene stores it: a bit a box, similar zones sharing one, packed. */
#ifndef SIM_PVS_H
#define SIM_PVS_H

#include "base/error.h"
#include "scene.h"

#include <stdint.h>

struct pvs {
    struct lim_place *places;
    uint8_t *bytes;
    size_t place_count, byte_count;
    size_t zones, kept;   /* rooms found; different visible sets stored */
    double mean_polygons; /* that a visible set shows, by volume */
};

/* Finds what the scene's cells see, allowing for what a renderer's rounding may shift on the screen, in radians.
 * Refuses a scene that has no closed cells, too many of them, or polygons in clusters. */
bool pvs_find(const struct lim_scene *scene, double angle_rad, struct pvs *out, struct error *err);
void pvs_free(struct pvs *pvs);

/* Packs count bytes; `out` has room for twice as many. Returns how many it takes. */
size_t pvs_pack(const uint8_t *bytes, size_t count, uint8_t *out);

#endif
