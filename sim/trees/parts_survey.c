/* SPDX-License-Identifier: MIT
 *
 * Leaders and lengths. */
#include "trees/parts_survey.h"

#include <math.h>

/* Each polygon leads to one of its part that comes no later. */
uint32_t parts_leader(uint32_t *leaders, uint32_t polygon)
{
    while (leaders[polygon] != polygon) {
        leaders[polygon] = leaders[leaders[polygon]];
        polygon = leaders[polygon];
    }
    return polygon;
}

double parts_diagonal(const double low[3], const double high[3])
{
    return sqrt((high[0] - low[0]) * (high[0] - low[0]) + (high[1] - low[1]) * (high[1] - low[1]) +
                (high[2] - low[2]) * (high[2] - low[2]));
}
