/* SPDX-License-Identifier: MIT */
#define LIM_PROFILE 3 /* exact */

#include "golden_state_of.h"

uint32_t golden_state_exact(const void *lim, uint16_t movers)
{
    return state_of(lim, movers);
}
