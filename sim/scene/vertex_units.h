/* SPDX-License-Identifier: MIT
 *
 * Where a scene's vertices are, whichever of its arrays they are in. */
#ifndef SIM_VERTEX_UNITS_H
#define SIM_VERTEX_UNITS_H

#include "long.h"

/* In units, without the fraction that profile exact draws it with. */
static inline void vertex_units(const struct lim_scene *scene, lim_index vertex, double out[3])
{
    const struct lim_long *of_32_bits = lim_scene_long(scene);
    const struct lim_vertex *at = of_32_bits ? NULL : &scene->vertices[vertex];
    for (int i = 0; i < 3; i++)
        out[i] = of_32_bits ? of_32_bits->vertices[vertex].at[i] : i == 0 ? at->x : i == 1 ? at->y : at->z;
}

#endif
