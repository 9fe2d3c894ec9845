/* SPDX-License-Identifier: MIT
 *
 * What can be seen from a zone: the cells that rays from it reach through sequences of openings, and the polygons
 * that touch them. Conservative: more may be in the set than can be seen, never less. */
#ifndef SIM_FLOW_H
#define SIM_FLOW_H

#include "portals/zones.h"

struct flow {
    const struct cells *cells;
    const struct zones *zones;
    double angle_rad; /* what a renderer's rounding may shift on the screen */
    /* Working memory: of each opening, the part that rays from the zone come through; a list of those to look at. */
    struct patch *grown; /* as wide as rounding may make it */
    size_t *grown_for;   /* zone_number when that was found */
    size_t zone_number;
    size_t *window_for;  /* group_number when the window was begun */
    size_t group_number; /* of the openings that rays leave the zone through */
    struct patch *windows;
    uint8_t *widened;
    bool *waiting;
    uint32_t *queue;
    bool *visible; /* the caller's: each record */
    size_t unseen; /* records that are still looked for */
    size_t work, work_max;
};

void flow_init(struct flow *flow, const struct cells *cells, const struct zones *zones, double angle_rad);
void flow_free(struct flow *flow);

/* Fills visible[record_count]. false: it would take more than flow->work_max planes that windows are clipped by; then
 * nothing is known. */
bool flow_see(struct flow *flow, size_t zone, bool *visible);

#endif
