/* SPDX-License-Identifier: MIT
 *
 * Two pixels a word. Arm processors store several registers with one instruction, which no compiler makes of a loop. */
#include "fill.h"

#if defined(__arm__)

/* With as many registers as the instruction reaches. */
lim_pixel_pair *lim_fill_sixteens(lim_pixel_pair *to, uint32_t count, uint32_t pair)
{
    register uint32_t a __asm__("r3") = pair;
    register uint32_t b __asm__("r4") = pair;
    register uint32_t c __asm__("r5") = pair;
    register uint32_t d __asm__("r6") = pair;

#if defined(__thumb__) && !defined(__thumb2__)
    do
        __asm__ volatile("stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}\n\t"
                         "stmia %0!, {%1, %2, %3, %4}\n\tstmia %0!, {%1, %2, %3, %4}"
                         : "+l"(to)
                         : "l"(a), "l"(b), "l"(c), "l"(d)
                         : "memory");
    while (--count);
#else
    register uint32_t e __asm__("r8") = pair;
    register uint32_t f __asm__("r9") = pair;
    register uint32_t g __asm__("r10") = pair;
    register uint32_t h __asm__("r12") = pair;

    do
        __asm__ volatile("stmia %0!, {%1, %2, %3, %4, %5, %6, %7, %8}\n\tstmia %0!, {%1, %2, %3, %4, %5, %6, %7, %8}"
                         : "+r"(to)
                         : "r"(a), "r"(b), "r"(c), "r"(d), "r"(e), "r"(f), "r"(g), "r"(h)
                         : "memory");
    while (--count);
#endif
    return to;
}

#else

lim_pixel_pair *lim_fill_sixteens(lim_pixel_pair *to, uint32_t count, uint32_t pair)
{
    do {
        LIM_UNROLLED(16)
        for (uint_fast8_t i = 0; i < 16; i++)
            to[i] = pair;
        to += 16;
    } while (--count);
    return to;
}

#endif

void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour)
{
    if (n_px) lim_fill_inline(line, x_px, n_px, colour);
}
