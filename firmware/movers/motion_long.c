/* SPDX-License-Identifier: MIT
 *
 * A way is below 2^31, and t at most 1: 62 bits hold a way in Q31. */
#include "movers/motion_long.h"

#include "long.h"

#if LIM_HAS_LONG && LIM_HAS_MOVERS

void lim_motion_go_far(const struct lim_motion *motion, uint16_t from, uint16_t to, uint32_t t_q31,
                       struct lim_instance *instance)
{
    const LIM_FLASH struct lim_long_vertex *origins = *motion->origins;

    for (uint_fast8_t i = 0; i < 3; i++) {
        if (!origins) {
            instance->origin[i] = 0;
            continue;
        }
        const int64_t way_q31 = ((int64_t)origins[to].at[i] - origins[from].at[i]) * t_q31;
        instance->origin[i] = (int32_t)(origins[from].at[i] + (way_q31 >> 31));
        instance->at_q8[i] += (int32_t)((way_q31 & INT32_MAX) >> 23);
    }
}

#endif
