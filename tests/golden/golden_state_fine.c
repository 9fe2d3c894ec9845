/* SPDX-License-Identifier: MIT */
#define LIM_PROFILE 2 /* fine */

#include "golden_state_of.h"

uint32_t golden_state_fine(const void *lim, uint16_t movers)
{
    return state_of(lim, movers);
}
