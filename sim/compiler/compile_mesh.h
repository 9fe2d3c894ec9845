/* SPDX-License-Identifier: MIT
 *
 * From a mesh to a compiled scene. */
#ifndef SIM_COMPILE_MESH_H
#define SIM_COMPILE_MESH_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"
#include "trees/coplanar.h"
#include "trees/exact.h"
#include "trees/parts.h"

/* What every tree of a mesh starts from. */
struct compilation {
    const struct mesh *mesh;
    const struct compile_options *options;
    struct exact_points points;
    struct coplanar coplanar;
    struct parts parts; /* those that become mesh leaves; none of them are found otherwise */
};

/* Of a mesh with T-vertices already in it. compilation_end() it either way. */
bool compilation_begin(struct compilation *work, const struct mesh *mesh, const struct compile_options *options,
                       struct error *err);

/* Builds the best tree of a kind, TREE_AUTO being BSP, and encodes it. */
bool compilation_tree(struct compilation *work, enum tree_kind kind, struct compiled *out, struct error *err);

/* What portals show of it, if the options want that and it pays: of the tree that is kept, as it takes seconds. */
bool compilation_portals(const struct compilation *work, struct compiled *out, struct error *err);

void compilation_end(struct compilation *work);

/* Whether a tree splits so much that other heuristics, or other kinds, are better. */
bool compilation_splits_much(const struct compile_report *report);

/* All of it at once, for the tree that the options name, or for none. */
bool compile_mesh(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                  struct error *err);

#endif
