/* SPDX-License-Identifier: MIT
 *
 * The polygons of a mesh while a stage rewrites them. */
#ifndef SIM_POLYGON_LIST_H
#define SIM_POLYGON_LIST_H

#include "model/mesh.h"

struct polygon_list {
    uint32_t *corners;
    size_t corner_count, corner_capacity;
    struct mesh_polygon *polygons;
    size_t polygon_count, polygon_capacity;
    bool full; /* it had to stop */
};

/* Appends a polygon with these corners; everything else is as in `like`. */
void polygon_list_add(struct polygon_list *list, const uint32_t *corners, size_t count,
                      const struct mesh_polygon *like);

/* Gives the list to the mesh, in place of the polygons that it had. Refuses a list that had to stop
 * at 2^28 corners; the mesh is as it was then, and the list empty in any case. */
bool polygon_list_move(struct polygon_list *list, struct mesh *mesh, struct error *err);

#endif
