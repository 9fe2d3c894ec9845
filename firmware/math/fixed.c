/* SPDX-License-Identifier: MIT
 *
 * What of fixed.h is not worth a copy at each call. The reciprocal table: entry i is 2^24 / (256 + i), rounded to
 * nearest; the first, 65536, does not fit 16 bits and is one less. Linked if LIM_RECIP_TABLE is 1. */
#include "math/fixed.h"

const LIM_FLASH uint16_t lim_recip_table_q16[257] = {
    65535, 65281, 65028, 64777, 64528, 64281, 64035, 63792, 63550, 63310, 63072, 62836, 62602, 62369, 62138, 61909,
    61681, 61455, 61231, 61008, 60787, 60568, 60350, 60133, 59919, 59705, 59494, 59283, 59075, 58867, 58662, 58457,
    58254, 58053, 57852, 57654, 57456, 57260, 57065, 56872, 56680, 56489, 56299, 56111, 55924, 55738, 55554, 55370,
    55188, 55007, 54828, 54649, 54471, 54295, 54120, 53946, 53773, 53601, 53431, 53261, 53092, 52925, 52759, 52593,
    52429, 52265, 52103, 51942, 51782, 51622, 51464, 51306, 51150, 50995, 50840, 50686, 50534, 50382, 50231, 50081,
    49932, 49784, 49637, 49490, 49345, 49200, 49056, 48913, 48771, 48630, 48489, 48349, 48210, 48072, 47935, 47798,
    47663, 47528, 47393, 47260, 47127, 46995, 46864, 46733, 46603, 46474, 46346, 46218, 46091, 45965, 45839, 45714,
    45590, 45467, 45344, 45222, 45100, 44979, 44859, 44739, 44620, 44502, 44384, 44267, 44151, 44035, 43919, 43805,
    43691, 43577, 43464, 43352, 43240, 43129, 43019, 42908, 42799, 42690, 42582, 42474, 42367, 42260, 42154, 42048,
    41943, 41838, 41734, 41631, 41528, 41425, 41323, 41222, 41121, 41020, 40920, 40820, 40721, 40623, 40525, 40427,
    40330, 40233, 40137, 40041, 39946, 39851, 39756, 39662, 39569, 39476, 39383, 39291, 39199, 39108, 39017, 38926,
    38836, 38746, 38657, 38568, 38480, 38392, 38304, 38217, 38130, 38044, 37958, 37872, 37787, 37702, 37617, 37533,
    37449, 37366, 37283, 37200, 37118, 37036, 36954, 36873, 36792, 36712, 36631, 36552, 36472, 36393, 36314, 36236,
    36158, 36080, 36003, 35926, 35849, 35772, 35696, 35620, 35545, 35470, 35395, 35320, 35246, 35172, 35099, 35026,
    34953, 34880, 34808, 34735, 34664, 34592, 34521, 34450, 34380, 34309, 34239, 34169, 34100, 34031, 33962, 33893,
    33825, 33757, 33689, 33622, 33554, 33487, 33421, 33354, 33288, 33222, 33157, 33091, 33026, 32961, 32897, 32832,
    32768};

/* An entry: 2^24 / divisor. */
static uint32_t divided_q16(uint32_t divisor)
{
    const uint32_t rounded_q16 = ((UINT32_C(1) << 24) + divisor / 2) / divisor;

    return rounded_q16 - (rounded_q16 >> 16);
}

uint32_t lim_recip_divided_q24(uint32_t mantissa_q31)
{
    const uint32_t divisor = mantissa_q31 >> 23, fraction_q8 = mantissa_q31 << 9 >> 24;
    const uint32_t left_q16 = divided_q16(divisor), fall_q16 = left_q16 - divided_q16(divisor + 1);

    return (left_q16 << 8) - fall_q16 * fraction_q8;
}

#if LIM_8_BIT

/* Shifts are by bytes where they can be: of the library's, and the compiler's, each bit is a turn of a loop. */
LIM_ALONE int32_t lim_mul_q30(int32_t a_q30, int32_t b_q30)
{
    const union {
        int64_t q60;
        struct {
            uint32_t low;
            int32_t high;
        };
    } product = {(int64_t)a_q30 * b_q30};
    const uint8_t below = (uint8_t)(product.low >> 24);

    return (int32_t)((uint32_t)product.high * 4 + (uint8_t)((uint8_t)(below >> 6) + (below >> 5 & 1)));
}

/* Digit by digit, each in place of a bit of `a` that is used up. The rest may need a 17th bit for a moment. */
uint32_t lim_divide_u9(uint32_t a, uint16_t b)
{
    const uint32_t b_high = (uint32_t)b << 16;
    uint32_t both = a >> 1 << 8 | (uint8_t)((a & 1) << 7);

    for (uint8_t i = 9; i; i--) {
        const int8_t top = (int8_t)(both >> 24); /* negative: of 17 bits */
        both <<= 1;
        if (top < 0 || (uint16_t)(both >> 16) >= b) both = (both - b_high) | 1;
    }
    return both;
}

#else

/* Not inlined where all sources are one file either: rows and angles call it often, and seldom. */
LIM_ALONE int32_t lim_mul_q30(int32_t a_q30, int32_t b_q30)
{
    return (int32_t)shift_round_s64((int64_t)a_q30 * b_q30, 30);
}

#endif
