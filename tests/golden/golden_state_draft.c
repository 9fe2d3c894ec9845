/* SPDX-License-Identifier: MIT */
#define LIM_PROFILE 0 /* draft */

#include "golden_state_of.h"

uint32_t golden_state_draft(const void *lim, uint16_t movers)
{
    return state_of(lim, movers);
}
