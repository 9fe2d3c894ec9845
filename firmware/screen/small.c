/* SPDX-License-Identifier: MIT
 *
 * The table of reciprocals. */
#include "screen/small.h"

#if EDGE_HAS_SMALL

#define SMALL_RECIPS_4(dy) SMALL_RECIP(dy), SMALL_RECIP((dy) + 1), SMALL_RECIP((dy) + 2), SMALL_RECIP((dy) + 3)
#define SMALL_RECIPS_16(dy)                                                                                            \
    SMALL_RECIPS_4(dy), SMALL_RECIPS_4((dy) + 4), SMALL_RECIPS_4((dy) + 8), SMALL_RECIPS_4((dy) + 12)
#define SMALL_RECIPS_64(dy)                                                                                            \
    SMALL_RECIPS_16(dy), SMALL_RECIPS_16((dy) + 16), SMALL_RECIPS_16((dy) + 32), SMALL_RECIPS_16((dy) + 48)
#define SMALL_RECIPS_256(dy)                                                                                           \
    SMALL_RECIPS_64(dy), SMALL_RECIPS_64((dy) + 64), SMALL_RECIPS_64((dy) + 128), SMALL_RECIPS_64((dy) + 192)

const uint32_t lim_small_recips[SMALL_DY + 1] = {SMALL_RECIPS_256(0), SMALL_RECIPS_256(256), SMALL_RECIPS_256(512),
                                                 SMALL_RECIPS_256(768), SMALL_RECIP(SMALL_DY)};

#endif
