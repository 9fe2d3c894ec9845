/* SPDX-License-Identifier: MIT
 *
 * From what the mesh knows of the model and of its grid. */
#include "measure/measure_scales.h"

#include "model/extent.h"
#include "model/original.h"

struct measure_scales measure_scales_of(const struct mesh *mesh)
{
    const struct original *original = mesh->original;
    return (struct measure_scales){
        .coordinate_bits = mesh->grid.is_long ? 32 : 16,
        .unit_m = 1.0 / mesh->grid.units_per_m,
        .longest_m = extent_longest_side(mesh->points, mesh->corners, mesh->corner_count),
        .smallest_m = original && original->seen_count ? original->faces[original->by_size[0]].size_m : 0.0};
}
