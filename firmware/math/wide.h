/* SPDX-License-Identifier: MIT
 *
 * Products of 64 bits by 64, compared: 128 bits where no type has as many. */
#ifndef LIM_WIDE_H
#define LIM_WIDE_H

#include "config.h"

/* The sign of a b - c d. */
int32_t lim_wide_compare(uint64_t a, uint64_t b, uint64_t c, uint64_t d);

/* The sign of x m + y n. */
int32_t lim_wide_sign(int64_t x, uint64_t m, int64_t y, uint64_t n);

#endif
