/* SPDX-License-Identifier: MIT
 *
 * Corners count, not points: what no face uses may lie anywhere. */
#include "model/extent.h"

#include <math.h>

double extent_longest_side(double (*points)[3], const uint32_t *corners, size_t count)
{
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            low = fmin(low, points[corners[i]][axis]);
            high = fmax(high, points[corners[i]][axis]);
        }
        longest = fmax(longest, high - low);
    }
    return longest;
}
