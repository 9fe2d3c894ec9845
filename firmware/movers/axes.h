/* SPDX-License-Identifier: MIT
 *
 * An instance's axes. */
#ifndef LIM_AXES_H
#define LIM_AXES_H

#include "scene.h"

/* The sum of v[i] axes[j][i] over i: how far a vector reaches along one of the object's axes, Q30 times its own. */
static inline int64_t lim_along_axis(const struct lim_instance *instance, uint_fast8_t j, const int32_t v[3])
{
    const int32_t *axis_q30 = &instance->axes_q30[3 * j];

    return (int64_t)axis_q30[0] * v[0] + (int64_t)axis_q30[1] * v[1] + (int64_t)axis_q30[2] * v[2];
}

#endif
