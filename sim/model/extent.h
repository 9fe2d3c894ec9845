/* SPDX-License-Identifier: MIT
 *
 * How large faces are. */
#ifndef SIM_EXTENT_H
#define SIM_EXTENT_H

#include <stddef.h>
#include <stdint.h>

/* The longest side of the box around points[corners[0 .. count)], in their unit; 0 of none. */
double extent_longest_side(double (*points)[3], const uint32_t *corners, size_t count);

#endif
