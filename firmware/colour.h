/* SPDX-License-Identifier: MIT
 *
 * Colours as a target's memory holds them: RGB565 as the bus wants it, the byte with the red bits first. */
#ifndef LIM_COLOUR_H
#define LIM_COLOUR_H

#include "config.h"

LIM_C_BEGIN

enum { LIM_OPAQUE = 255 }; /* the alpha of what hides all behind it */

static inline uint16_t lim_memory_colour(uint16_t rgb565)
{
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
    return LIM_CAST(uint16_t, rgb565 << 8 | rgb565 >> 8);
#else
    return rgb565;
#endif
}

LIM_C_END

#endif
