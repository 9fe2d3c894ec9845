/* SPDX-License-Identifier: MIT
 *
 * The formats of a precision profile. Within a profile every CPU and compiler paints the same
 * pixels. One profile, `fast`, is complete; another one is another block here plus its own
 * transform in view.c: no other stage knows the formats but by these names. */
#ifndef LIM_PROFILE_H
#define LIM_PROFILE_H

#include "config.h"

#if LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_SUB_BITS 6 /* 1/64 pixel */
#define LIM_SPLIT_ROWS 0
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_SUB_BITS 8   /* 1/256 pixel */
#define LIM_SPLIT_ROWS 1 /* matrix entries of 30 bits, in two limbs; x / z in 28 bits */
#else
#error "unknown LIM_PROFILE"
#endif

#define LIM_MATRIX_BITS 14                   /* fraction bits of a 16-bit matrix entry, and of view space */
#define LIM_SUB ((int32_t)1 << LIM_SUB_BITS) /* sub-pixels in a pixel */

/* Screen coordinates span -w/2 .. 3w/2 because of the guard band. Up to this many pixels a side they
 * fit 16 bits, and so does all of EDGE in 32; wider targets need twice as much. */
#define LIM_NARROW_SIDE_PX (21845 >> LIM_SUB_BITS)
#define LIM_WIDE (LIM_MAX_SIDE_PX > LIM_NARROW_SIDE_PX)

#if LIM_WIDE
typedef int32_t lim_sub;       /* a screen coordinate in sub-pixels */
typedef int64_t lim_sub_area;  /* a product of two */
typedef uint64_t lim_sub_wrap; /* the same, where it may wrap */
#else
typedef int16_t lim_sub;
typedef int32_t lim_sub_area;
typedef uint32_t lim_sub_wrap;
#endif

/* A point on the screen, in sub-pixels; the centre of pixel (i, j) is at (i, j) * LIM_SUB. */
struct lim_point {
    lim_sub x, y;
};

#endif
