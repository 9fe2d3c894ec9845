/* SPDX-License-Identifier: MIT
 *
 * How far a model's scales are apart, and what of them its grid holds. */
#ifndef SIM_MEASURE_SCALES_H
#define SIM_MEASURE_SCALES_H

#include "model/mesh.h"

struct measure_scales {
    unsigned coordinate_bits; /* 16 or 32 */
    double unit_m;            /* of the grid */
    double longest_m;         /* the longest side of the model's bounds */
    double smallest_m;        /* the same of its smallest surface (original.h); 0: none is to be seen */
};

struct measure_scales measure_scales_of(const struct mesh *mesh);

#endif
