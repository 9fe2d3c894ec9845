/* SPDX-License-Identifier: MIT
 *
 * The compiler builds a BSP tree; where that splits a quarter of up to 40,000 polygons, or if `--tree auto` asks for
 * it, clusters and an axis tree, too. It takes what draws its sampled cameras with the fewest instructions. */
#ifndef SIM_TREE_CHOICE_H
#define SIM_TREE_CHOICE_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* compile_mesh() with the tree that the options name, or with the best if they leave it open: another tree than the BSP
 * must spare a tenth of the BSP tree's predicted instructions; within a hundredth of one another, the smaller wins.
 * Where nothing is predicted, it is the BSP tree. The same model gives the same tree on every machine. */
bool tree_choice_compile(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                         struct error *err);

#endif
