/* SPDX-License-Identifier: MIT
 *
 * What stops who moves in a scene, by asking each of its polygons, without its tree: in GMP, and in 128 bits where
 * these hold everything. Shares no code with the renderer but the records of scenes. */
#ifndef TESTS_SOLID_ORACLE_H
#define TESTS_SOLID_ORACLE_H

#include "scene.h"

#include <stddef.h>

/* A polygon as it is stored: exact plane, facing, corners. */
struct solid_polygon {
    int64_t n[3], d;
    bool back; /* it faces the back of that plane */
    lim_index record;
    const lim_index *corners;
    size_t count;
    int16_t low[3], high[3]; /* of its corners */
};

struct solid_list {
    const struct lim_scene *scene;
    struct solid_polygon *polygons;
    size_t count;
};

/* Of a scene with nodes. */
void solid_list_init(struct solid_list *list, const struct lim_scene *scene);
void solid_list_free(struct solid_list *list);

/* n . at - d in 2^-8 units. */
__int128 solid_value(const struct solid_polygon *polygon, const int32_t at_q8[3]);

/* How far along a segment polygons are met. */
struct solid_ray {
    bool hit;
    __int128 num, den; /* of the first */
    size_t crossed;    /* polygons whose plane was crossed nearby */
};

/* As lim_trace() has it. */
struct solid_ray solid_trace(const struct solid_list *list, const int32_t from_q8[3], const int32_t to_q8[3],
                             bool backs);

/* Whether one polygon is met, and just as far along as that. */
bool solid_meets_at(const struct solid_list *list, lim_index record, const int32_t from_q8[3], const int32_t to_q8[3],
                    bool backs, const struct solid_ray *ray);

/* Whether a box has an inner point in common with a polygon. */
bool solid_overlaps(const struct solid_list *list, const struct solid_polygon *polygon, const int32_t at_q8[3],
                    const int32_t half_q8[3]);

#endif
