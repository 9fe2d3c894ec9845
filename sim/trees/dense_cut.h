/* SPDX-License-Identifier: MIT
 *
 * Planes that divide lists with pieces of dense parts (parts.h), which shall become leaves as they are: none of their
 * own planes divides, and what splits them is dear. */
#ifndef SIM_DENSE_CUT_H
#define SIM_DENSE_CUT_H

#include "trees/bsp.h"
#include "trees/parts.h"
#include "trees/splitter.h"

/* How many pieces of a list belong to dense parts. NULL: there are none. */
size_t dense_count(const struct bsp *bsp, const struct parts *parts, const uint32_t *list, size_t count);

/* Of a list of both kinds: the cheapest of the other polygons' planes and of the axis planes at the sides of parts'
 * boxes. */
uint32_t dense_cut_best(struct bsp *bsp, const struct splitter *splitter, const struct parts *parts,
                        const uint32_t *list, size_t count);

/* Of a list of dense parts alone: an axis plane between them that splits no piece, with as many parts on either side as
 * possible; or BSP_NONE: it is a leaf, of one part, or of several that reach into each other's boxes. */
uint32_t dense_cut_apart(struct bsp *bsp, const struct parts *parts, const uint32_t *list, size_t count);

/* Whether a mesh leaf has room for the list. */
bool dense_fits(const struct bsp *bsp, const uint32_t *list, size_t count);

#endif
