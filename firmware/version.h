/* SPDX-License-Identifier: MIT
 *
 * Which renderer this is, and which generated scenes it takes. What a version promises: DESIGN.md. */
#ifndef LIM_VERSION_H
#define LIM_VERSION_H

#define LIM_VERSION_MAJOR 0
#define LIM_VERSION_MINOR 1
#define LIM_VERSION_PATCH 0

/* For #if: 0.1.0 is 0x000100. */
#define LIM_VERSION (LIM_VERSION_MAJOR * 0x10000 + LIM_VERSION_MINOR * 0x100 + LIM_VERSION_PATCH)

/* The form of a scene's NAME.c and NAME.h, which say for which one they were written. It changes whenever files that
 * were written before would compile to something wrong. */
#define LIM_SCENE_FORMAT 7

#endif
