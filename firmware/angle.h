/* SPDX-License-Identifier: MIT
 *
 * Sine and cosine of binary angles: a full turn is 2^32, so angles wrap by themselves and a stored
 * one never drifts. */
#ifndef LIM_ANGLE_H
#define LIM_ANGLE_H

#include "config.h"

LIM_C_BEGIN

#define LIM_ANGLE_QUARTER (UINT32_C(1) << 30)

/* Within -1..1, and within 3.3 units of 2^-30 of the truth over all angles; exact at multiples of a quarter
 * turn. Antisymmetric to the bit. */
int32_t lim_sin_q30(uint32_t angle);
int32_t lim_cos_q30(uint32_t angle);

LIM_C_END

#endif
