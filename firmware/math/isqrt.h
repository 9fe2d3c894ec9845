/* SPDX-License-Identifier: MIT
 *
 * Square roots, for orientations and for normals under a light. */
#ifndef LIM_ISQRT_H
#define LIM_ISQRT_H

#include "config.h"

/* floor(sqrt(x)), a bit a turn: no division. */
/*@ assigns \nothing; */
uint32_t lim_isqrt(uint64_t x);

#endif
