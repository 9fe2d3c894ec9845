/* SPDX-License-Identifier: MIT
 *
 * From the tree to the arrays of scene.h, still of any length. */
#ifndef SIM_ENCODE_H
#define SIM_ENCODE_H

#include "scene/encoding.h"
#include "trees/bsp.h"

/* Encodes a tree, with the vertices' fractions or without, with what wireframe wants to know of the edges or without.
 * Refuses one that leaves nothing to draw, or too much, saying what there is too much of, and by how much.
 * The caller frees *out either way. */
bool encode_bsp(const struct bsp *bsp, bool with_fractions, bool with_edges, struct encoding *out, struct error *err);

#endif
