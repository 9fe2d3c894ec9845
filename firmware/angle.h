/* SPDX-License-Identifier: MIT
 *
 * Binary angles: a full turn is 2^32, so angles wrap by themselves and a stored one never drifts. */
#ifndef LIM_ANGLE_H
#define LIM_ANGLE_H

#include "config.h"

LIM_C_BEGIN

#define LIM_ANGLE_QUARTER (UINT32_C(1) << 30)

/* An angle from degrees, which are a constant, whole or not: LIM_DEGREES(-22.5). Within -360..360, to a ten-thousandth
 * of a degree: so far all compilers agree, also those whose double has 32 bits. It is computed by the compiler; of a
 * variable the processor would have to compute it in floating point. */
#define LIM_DEGREES(degrees) LIM_ANGLE_OF_E4((degrees) < 0 ? (degrees)*1e4 - 0.5 : (degrees)*1e4 + 0.5)
#define LIM_ANGLE_OF_E4(degrees_e4)                                                                                    \
    ((uint32_t)((((int64_t)(int32_t)(degrees_e4) + 3600000) * (INT64_C(1) << 32) + 1800000) / 3600000))

/* Within -1..1, and within 3.3 units of 2^-30 of the truth over all angles; exact at multiples of a quarter
 * turn. Antisymmetric to the bit. */
int32_t lim_sin_q30(uint32_t angle);
int32_t lim_cos_q30(uint32_t angle);

/* The angle of the vector (x, y), from the x axis towards the y axis: within 2 units of 2^-32 of a turn (2e-7 degrees)
 * of the truth, exact at multiples of an eighth of a turn, and 0 of (0, 0). lim_atan2(-y, x) is -lim_atan2(y, x). */
uint32_t lim_atan2(int32_t y, int32_t x);

LIM_C_END

#endif
