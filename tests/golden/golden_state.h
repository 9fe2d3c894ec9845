/* SPDX-License-Identifier: MIT
 *
 * What a frame leaves behind in the renderer's memory: the view and its rows, vertices on the screen, poses and balls
 * of movers, depths and rectangles of sorted polygons, retained corners, edges, mappings of textures, the sizes of
 * pools. Of most of it a small picture shows little. Read member by member, in each profile's own layout. */
#ifndef TESTS_GOLDEN_STATE_H
#define TESTS_GOLDEN_STATE_H

#include "golden_stage.h"

/* The memory of the renderer and its movers is all zero but for what it wrote itself, so that what it never wrote is
 * the same every time: right after golden_begin() or each init of it. */
void golden_state_clear(struct simulator *simulator, const struct golden_stage *stage);

/* A hash of it, after a frame without an error. */
uint32_t golden_state(const struct simulator *simulator);

/* The same of the profiles' own layouts. */
uint32_t golden_state_draft(const void *lim, uint16_t movers);
uint32_t golden_state_fast(const void *lim, uint16_t movers);
uint32_t golden_state_fine(const void *lim, uint16_t movers);
uint32_t golden_state_exact(const void *lim, uint16_t movers);

#endif
