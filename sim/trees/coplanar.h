/* SPDX-License-Identifier: MIT
 *
 * Which polygons of a mesh share a plane, and which of those lies over which. Every polygon belongs to one group; a
 * group has one stored plane, from which the sides and facings of all its polygons are decided. */
#ifndef SIM_COPLANAR_H
#define SIM_COPLANAR_H

#include "model/mesh.h"
#include "scene/plane.h"
#include "trees/plane_layers.h"

struct coplanar {
    struct plane *planes; /* of the groups */
    size_t count;
    uint32_t *group;  /* of each polygon of the mesh */
    bool *faces_back; /* of each polygon: does it face the back of its plane? */
    struct layers layers;
};

/* Groups the polygons whose corners lie within the tolerance of one plane, the largest polygon's.
 * `points` are the mesh's, in units. */
void coplanar_find(const struct mesh *mesh, double (*points)[3], double tolerance_units, struct coplanar *out);

void coplanar_free(struct coplanar *coplanar);

#endif
