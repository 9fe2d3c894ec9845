/* SPDX-License-Identifier: MIT
 *
 * Corners count, not points: what no face uses may lie anywhere. */
#include "measure/measure_scales.h"

#include "model/original.h"

#include <math.h>

static double longest_side_m(const struct mesh *mesh)
{
    double longest_m = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double low_m = INFINITY, high_m = -INFINITY;
        for (size_t i = 0; i < mesh->corner_count; i++) {
            low_m = fmin(low_m, mesh->points[mesh->corners[i]][axis]);
            high_m = fmax(high_m, mesh->points[mesh->corners[i]][axis]);
        }
        longest_m = fmax(longest_m, high_m - low_m);
    }
    return longest_m;
}

struct measure_scales measure_scales_of(const struct mesh *mesh)
{
    const struct original *original = mesh->original;
    return (struct measure_scales){
        .coordinate_bits = mesh->grid.is_long ? 32 : 16,
        .unit_m = 1.0 / mesh->grid.units_per_m,
        .longest_m = longest_side_m(mesh),
        .smallest_m = original && original->seen_count ? original->faces[original->by_size[0]].size_m : 0.0};
}
