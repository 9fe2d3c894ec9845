/* SPDX-License-Identifier: MIT
 *
 * Square roots, for orientations and for normals under a light. */
#ifndef LIM_ROOT_H
#define LIM_ROOT_H

#include "config.h"

/* floor(sqrt(x)), a bit a turn: no division. */
/*@ assigns \nothing; */
uint32_t lim_root(uint64_t x);

#endif
