/* SPDX-License-Identifier: MIT
 *
 * What a build of the renderer contains. A scene's generated header states its needs and
 * limits; a build names that header in LIM_CONFIG (-DLIM_CONFIG='"hall.h"'). Whatever the
 * header leaves open gets the host's generous value here, so every flag is always defined. */
#ifndef LIM_CONFIG_H
#define LIM_CONFIG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef LIM_CONFIG
#include LIM_CONFIG
#endif

/* Precision profiles; profile.h turns the choice into formats. */
#define LIM_PROFILE_DRAFT 0
#define LIM_PROFILE_FAST 1
#define LIM_PROFILE_FINE 2

#ifndef LIM_PROFILE
#define LIM_PROFILE LIM_PROFILE_FAST
#endif

/* 1: lim_frame() counts its work in struct lim_stats. 0: the counters stay zero and cost nothing. */
#ifndef LIM_HAS_STATS
#define LIM_HAS_STATS 1
#endif

/* 1: the back-to-front painter into a framebuffer is linked. */
#ifndef LIM_HAS_PAINTER
#define LIM_HAS_PAINTER 1
#endif

/* Longest side of any target, in pixels: 8..1024. Up to 341 all screen arithmetic fits 32 bits. */
#ifndef LIM_MAX_SIDE_PX
#define LIM_MAX_SIDE_PX 1024
#endif

/* Most vertices of a polygon in the scene, before clipping: 3..250. */
#ifndef LIM_MAX_VERTICES
#define LIM_MAX_VERTICES 64
#endif

/* Const scene data lives in flash. Only AVR needs another address space to reach it. */
#if defined(__AVR__)
#define LIM_FLASH __flash
#else
#define LIM_FLASH
#endif

/* A caller's bug ends here. Define LIM_ASSERT before this header to hook it up; the default keeps
 * the renderer free of any library. The condition is evaluated only where a hook asks for it. */
#ifndef LIM_ASSERT
#define LIM_ASSERT(condition) ((void)0)
#endif

#if LIM_MAX_SIDE_PX < 8 || LIM_MAX_SIDE_PX > 1024
#error "LIM_MAX_SIDE_PX must be 8..1024"
#endif
#if LIM_MAX_VERTICES < 3 || LIM_MAX_VERTICES > 250
#error "LIM_MAX_VERTICES must be 3..250"
#endif

#endif
