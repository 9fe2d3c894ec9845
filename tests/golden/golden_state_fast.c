/* SPDX-License-Identifier: MIT */
#define LIM_PROFILE 1 /* fast */

#include "golden_state_of.h"

uint32_t golden_state_fast(const void *lim, uint16_t movers)
{
    return state_of(lim, movers);
}
