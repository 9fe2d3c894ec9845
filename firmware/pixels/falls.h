/* SPDX-License-Identifier: MIT
 *
 * How a case says that it goes on in the next one. */
#ifndef LIM_FALLS_H
#define LIM_FALLS_H

#if __GNUC__ >= 7 || defined(__clang__)
#define LIM_FALL_THROUGH __attribute__((fallthrough))
#else
#define LIM_FALL_THROUGH ((void)0)
#endif

#endif
