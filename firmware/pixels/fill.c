/* SPDX-License-Identifier: MIT
 *
 * Two pixels a word. Arm processors store several registers with one instruction, which no compiler makes of a loop. */
#include "pixels/fill.h"

/* Writes `count` times 16 pairs, once at least. */
#if defined(__arm__)

/* With as many registers as the instruction reaches, but for r7, which may be the frame's. */
static inline void fill_sixteens(lim_pixel_pair *to, uint_fast16_t count, uint32_t pair)
{
    register uint32_t a __asm__("r2") = pair;
    register uint32_t b __asm__("r3") = pair;
    register uint32_t c __asm__("r4") = pair;
    register uint32_t d __asm__("r5") = pair;

#if defined(__thumb__) && !defined(__thumb2__)
    __asm__ volatile(".syntax unified\n"
                     "1:\n\tstmia %0!, {%2, %3, %4, %5}\n\tstmia %0!, {%2, %3, %4, %5}\n\t"
                     "stmia %0!, {%2, %3, %4, %5}\n\tstmia %0!, {%2, %3, %4, %5}\n\tsubs %1, #1\n\tbne 1b"
                     : "+l"(to), "+l"(count)
                     : "l"(a), "l"(b), "l"(c), "l"(d)
                     : "memory", "cc");
#else
    register uint32_t e __asm__("r6") = pair;
    register uint32_t f __asm__("r8") = pair;
    register uint32_t g __asm__("r9") = pair;
    register uint32_t h __asm__("r10") = pair;

    __asm__ volatile("1:\n\tstmia %0!, {%2, %3, %4, %5, %6, %7, %8, %9}\n\t"
                     "stmia %0!, {%2, %3, %4, %5, %6, %7, %8, %9}\n\tsubs %1, %1, #1\n\tbne 1b"
                     : "+r"(to), "+r"(count)
                     : "r"(a), "r"(b), "r"(c), "r"(d), "r"(e), "r"(f), "r"(g), "r"(h)
                     : "memory", "cc");
#endif
}

#else

static inline void fill_sixteens(lim_pixel_pair *to, uint_fast16_t count, uint32_t pair)
{
    do {
        LIM_UNROLLED(16)
        for (uint_fast8_t i = 0; i < 16; i++)
            to[i] = pair;
        to += 16;
    } while (--count);
}

#endif

void lim_fill_many(lim_pixel_pair *to, uint_fast16_t pairs, uint32_t pair)
{
    fill_sixteens(to, pairs >> 4, pair);
    fill_sixteens(to + pairs - 16, 1, pair); /* what is left, and some of the others again */
}

void lim_fill(uint16_t *line, uint16_t x_px, uint16_t n_px, uint16_t colour)
{
    if (n_px) lim_fill_inline(line, (int_fast16_t)x_px, (int_fast16_t)(x_px + n_px), colour);
}
