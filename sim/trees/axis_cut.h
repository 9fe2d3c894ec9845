/* SPDX-License-Identifier: MIT
 *
 * Axis planes that divide a list of polygons, whatever planes these lie in: axis trees and octrees. */
#ifndef SIM_AXIS_CUT_H
#define SIM_AXIS_CUT_H

#include "trees/bsp.h"
#include "trees/splitter.h"

/* Candidates: up to `most` whole coordinates along an axis at which a piece begins or ends, in order, evenly chosen.
 * Returns how many. */
size_t axis_cut_candidates(const struct bsp *bsp, const uint32_t *list, size_t count, int axis, size_t most,
                           int32_t *out);

/* The candidate on any axis that is cheapest by the splitter's weights, and what it costs. BSP_NONE: each splits many,
 * or leaves nearly the whole list on one side. */
uint32_t axis_cut_best(struct bsp *bsp, const struct splitter *splitter, const uint32_t *list, size_t count,
                       double *least);

/* The plane that halves the cube, or the half or quarter of one, in which the list stands: x, y and z by turns, and
 * those at once that leave all pieces on one side. BSP_NONE: the cube has become too small, or many pieces lie across.
 */
uint32_t axis_cut_halving(struct bsp *bsp, struct bsp_place place, const uint32_t *list, size_t count);

#endif
