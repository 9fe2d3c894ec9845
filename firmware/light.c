/* SPDX-License-Identifier: MIT
 *
 * Lambert's cosine in 32 bits: the normal is made short enough first. */
#include "orders.h"

#include "math/fixed.h"
#include "math/isqrt.h"

#if LIM_HAS_LIGHT

/* -2^14..2^14: the longest component of the normal gets 14 bits, so that their products with the light's fit. */
static int32_t cosine_q14(const int16_t to_q14[3], const int32_t normal[3])
{
    const uint8_t spare = clz_u32(abs_s32(normal[0]) | abs_s32(normal[1]) | abs_s32(normal[2]));
    int32_t dot = 0, square = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t n = spare > 18 ? normal[i] * (INT32_C(1) << (spare - 18)) : normal[i] >> (18 - spare);
        dot += n * to_q14[i];
        square += n * n;
    }
    const int32_t length = (int32_t)lim_isqrt((uint64_t)square);
    const int32_t cosine = length ? dot / length : 0;
    return cosine > 16384 ? 16384 : cosine < -16384 ? -16384 : cosine;
}

uint16_t lim_light_shade(const struct lim_light *light, const int16_t to_q14[3], const int32_t normal[3],
                         uint16_t rgb565)
{
    const int32_t bright_q22 = light->middle_q8 * INT32_C(16384) + light->swing_q8 * cosine_q14(to_q14, normal);
    const uint32_t by_q8 = (uint32_t)(bright_q22 < 0 ? 0 : (bright_q22 + 8192) >> 14);
    const uint32_t red = rgb565 >> 11, green = rgb565 >> 5 & 63, blue = rgb565 & 31;

    return (uint16_t)((red * by_q8 + 128) >> 8 << 11 | (green * by_q8 + 128) >> 8 << 5 | (blue * by_q8 + 128) >> 8);
}

#endif
