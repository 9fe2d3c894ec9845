/* SPDX-License-Identifier: MIT
 *
 * The formats of a precision profile. Within a profile every CPU and compiler paints the same
 * pixels. The arithmetic that goes with them is in transform.h and perspective.h; no other stage
 * knows more than the names below.
 *
 *   draft  16-bit rows and ratios, whole pixels
 *   fast   the same, 1/128 pixel
 *   fine   rows of 29 bits in two limbs, ratios of 19 bits, 1/512 pixel
 *   exact  the same rows, ratios of 27 bits, vertices with 8 further bits, 1/4096 pixel */
#ifndef LIM_PROFILE_H
#define LIM_PROFILE_H

#include "config.h"

#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_PROFILE_SUB_BITS 0
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_PROFILE_SUB_BITS 7
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_PROFILE_SUB_BITS 9
#elif LIM_PROFILE == LIM_PROFILE_EXACT
#define LIM_PROFILE_SUB_BITS 12
#else
#error "unknown LIM_PROFILE"
#endif

/* Sub-pixel bits, 0..12: a profile's own unless a build says otherwise. */
#ifndef LIM_SUB_BITS
#define LIM_SUB_BITS LIM_PROFILE_SUB_BITS
#endif
#if LIM_SUB_BITS < 0 || LIM_SUB_BITS > 12
#error "LIM_SUB_BITS must be 0..12"
#endif

#define LIM_HAS_LIMBS (LIM_PROFILE >= LIM_PROFILE_FINE)      /* rows and ratios beyond 16 bits */
#define LIM_HAS_FRACTIONS (LIM_PROFILE == LIM_PROFILE_EXACT) /* vertices with 8 fraction bits */

#define LIM_DRAFT_MARGIN_BITS 8 /* what is outside by 2^-8 of half the screen stays outside in whole pixels too */
#define LIM_SUB ((int32_t)1 << LIM_SUB_BITS) /* sub-pixels in a pixel */

/* Screen coordinates span -w/2 .. 3w/2 because of the guard band. Up to this many pixels a side they fit
 * 16 bits, if they count from a pixel in the middle. Which one it is makes no difference to any picture. */
#define LIM_NARROW_SIDE_PX (32767 >> LIM_SUB_BITS)
#define LIM_WIDE (LIM_MAX_SIDE_PX > LIM_NARROW_SIDE_PX)
#define LIM_ORIGIN_PX (LIM_WIDE ? 0 : LIM_MAX_SIDE_PX / 2)

/* A screen coordinate in sub-pixels. */
#if LIM_WIDE
typedef int32_t lim_sub;
#else
typedef int16_t lim_sub;
#endif

/* EDGE's sums of products (edge.c), and what they are summed in: 32 bits may wrap on the way, 64 never need to. */
#if LIM_SUB_BITS > 9
typedef int64_t lim_sub_area;
typedef int64_t lim_sub_wrap;
#else
typedef int32_t lim_sub_area;
typedef uint32_t lim_sub_wrap;
#endif

/* A point on the screen; the centre of pixel (i, j) is at (i - LIM_ORIGIN_PX, j - LIM_ORIGIN_PX) * LIM_SUB. Aligned, so
 * that processors of 32 bits copy it as a word; where they must not load one from odd halves they would call memcpy().
 */
struct lim_point {
    lim_sub x LIM_WORD_ALIGNED, y;
};

#endif
