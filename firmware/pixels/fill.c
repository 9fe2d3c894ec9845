/* SPDX-License-Identifier: MIT
 *
 * Two pixels a word. Arm processors store several registers with one instruction, which no compiler makes of a loop. */
#include "pixels/fill.h"

/* 16 pairs at a time, and the last 16, some of which are written already. */
#if defined(__arm__)

/* With as many registers as the instruction reaches, but for r7, which may be the frame's. */
void lim_fill_many(lim_pixel_pair *to, uint_fast16_t pairs, uint32_t pair)
{
    lim_pixel_pair *last = to + pairs - 16;
    uint_fast16_t count = pairs >> 4;
    register uint32_t a __asm__("r2") = pair;
    register uint32_t b __asm__("r3") = pair;
    register uint32_t c __asm__("r4") = pair;
    register uint32_t d __asm__("r5") = pair;

#if defined(__thumb__) && !defined(__thumb2__)
    __asm__ volatile(".syntax unified\n"
                     "1:\n\tstmia %0!, {%3, %4, %5, %6}\n\tstmia %0!, {%3, %4, %5, %6}\n\t"
                     "stmia %0!, {%3, %4, %5, %6}\n\tstmia %0!, {%3, %4, %5, %6}\n\tsubs %2, #1\n\tbne 1b\n\t"
                     "stmia %1!, {%3, %4, %5, %6}\n\tstmia %1!, {%3, %4, %5, %6}\n\t"
                     "stmia %1!, {%3, %4, %5, %6}\n\tstmia %1!, {%3, %4, %5, %6}"
                     : "+l"(to), "+l"(last), "+l"(count)
                     : "l"(a), "l"(b), "l"(c), "l"(d)
                     : "memory", "cc");
#else
    register uint32_t e __asm__("r6") = pair;
    register uint32_t f __asm__("r8") = pair;
    register uint32_t g __asm__("r9") = pair;
    register uint32_t h __asm__("r10") = pair;

    __asm__ volatile("1:\n\tstmia %0!, {%3, %4, %5, %6, %7, %8, %9, %10}\n\t"
                     "stmia %0!, {%3, %4, %5, %6, %7, %8, %9, %10}\n\tsubs %2, %2, #1\n\tbne 1b\n\t"
                     "stmia %1!, {%3, %4, %5, %6, %7, %8, %9, %10}\n\t"
                     "stmia %1!, {%3, %4, %5, %6, %7, %8, %9, %10}"
                     : "+r"(to), "+r"(last), "+r"(count)
                     : "r"(a), "r"(b), "r"(c), "r"(d), "r"(e), "r"(f), "r"(g), "r"(h)
                     : "memory", "cc");
#endif
}

#else

static inline void fill_sixteen(lim_pixel_pair *to, uint32_t pair)
{
    LIM_UNROLLED(16)
    for (uint_fast8_t i = 0; i < 16; i++)
        to[i] = pair;
}

void lim_fill_many(lim_pixel_pair *to, uint_fast16_t pairs, uint32_t pair)
{
    lim_pixel_pair *const last = to + pairs - 16;
    uint_fast16_t count = pairs >> 4;

    do {
        fill_sixteen(to, pair);
        to += 16;
    } while (--count);
    fill_sixteen(last, pair);
}

#endif

void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour)
{
    if (n_px) lim_fill_inline(line, (int_fast16_t)x_px, (int_fast16_t)(x_px + n_px), colour);
}
