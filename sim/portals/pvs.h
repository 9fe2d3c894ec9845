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
    size_t given_up;      /* rooms from which everything counts as seen, as their portals lead too far */
    double mean_polygons; /* that a visible set shows, by volume */
};

/* How far portals are followed. */
struct pvs_effort {
    size_t zone_work, work; /* planes that windows are clipped by, for a zone and for all */
    double given_up;        /* which part of the volume may show everything, as its portals lead too far */
    double hidden;          /* which part of the polygons sets must leave out, by volume; 0: none */
};

extern const struct pvs_effort pvs_usual_effort;

/* Finds what the scene's cells see, allowing for what a renderer's rounding may shift on the screen, in radians.
 * Refuses a scene that has no closed cells, too many of them, portals that lead too far or hide too little, or polygons
 * in clusters. */
bool pvs_find(const struct lim_scene *scene, double angle_rad, const struct pvs_effort *effort, struct pvs *out,
              struct error *err);
void pvs_free(struct pvs *pvs);

/* Whether it is a scene that pvs_find() may take, and that the renderer can draw with places: asked in no time. */
bool pvs_may_be(const struct lim_scene *scene, struct error *err);

/* Packs count bytes; `out` has room for twice as many. Returns how many it takes. */
size_t pvs_pack(const uint8_t *bytes, size_t count, uint8_t *out);

#endif
