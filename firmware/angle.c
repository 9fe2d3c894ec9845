/* SPDX-License-Identifier: MIT
 *
 * sin(pi/2 * t) on one quarter turn by its Taylor series up to t^15, whose remainder at t = 1 is
 * 6e-12 (2^-37); seven 64-bit multiplications, done a handful of times a frame. */
#include "camera.h"

#include "math/fixed.h"

enum { SERIES_TERMS = 8 };

/* (-1)^k (pi/2)^(2k+1) / (2k+1)! in Q30. */
static const LIM_FLASH int32_t series_q30[SERIES_TERMS] = {1686629713, -693598668, 85569306, -5026995,
                                                           172272,     -3864,      61,       -1};

/* t_q30 in 0..2^30: the part of a quarter turn. */
/*@ requires 0 <= t_q30 <= 1073741824;
    assigns \nothing;
    ensures 0 <= \result <= 1073741824; */
static int32_t quarter_sin_q30(int32_t t_q30)
{
    const int32_t square_q30 = lim_mul_q30(t_q30, t_q30);
    int32_t sum_q30 = 0;

    //@ loop pragma UNROLL "completely", 9;
    for (uint8_t k = SERIES_TERMS; k-- > 0;)
        sum_q30 = lim_mul_q30(sum_q30, square_q30) + series_q30[k];
    const int32_t sine_q30 = lim_mul_q30(sum_q30, t_q30);
    return sine_q30 > INT32_C(1) << 30 ? INT32_C(1) << 30 : sine_q30; /* rounding exceeds it by 1 */
}

/*@ assigns \nothing;
    ensures -1073741824 <= \result <= 1073741824; */
int32_t lim_sin_q30(uint32_t angle)
{
    const int32_t part_q30 = (int32_t)(angle & (LIM_ANGLE_QUARTER - 1));
    const bool falling = (angle & LIM_ANGLE_QUARTER) != 0;
    const int32_t sine_q30 = quarter_sin_q30(falling ? (INT32_C(1) << 30) - part_q30 : part_q30);

    return angle >> 31 ? -sine_q30 : sine_q30;
}

/*@ assigns \nothing;
    ensures -1073741824 <= \result <= 1073741824; */
int32_t lim_cos_q30(uint32_t angle)
{
    return lim_sin_q30(angle + LIM_ANGLE_QUARTER);
}
