/* SPDX-License-Identifier: MIT
 *
 * Visibility methods by name: what the firmware does, and the tree that it does it on. */
#ifndef SIM_METHOD_H
#define SIM_METHOD_H

#include "base/error.h"
#include "scene.h"
#include "scene/tree_kind.h"
#include "target.h"

struct method {
    const char *name;
    enum lim_method draws;
    enum tree_kind tree; /* TREE_AUTO: any will do */
    bool portals;        /* what can be seen from where is in the scene, whether it pays or not */
    bool exact;          /* else a picture may be wrong by more than rounding */
};

enum { METHOD_DRAWS = LIM_MESH_DEPTH + 1 }; /* members of enum lim_method */

extern const struct method methods[];
extern const size_t method_count;

/* By its name, from --method; an unknown one is refused with the list of those there are. */
const struct method *method_parse(const char *text, struct error *err);

/* The first one that draws so. */
const struct method *method_that(enum lim_method draws);

/* What draws a scene of which nobody says it: a mesh, by depth where triangles have it, or a set that may be split, or
 * nearest first. */
enum lim_method method_of_scene(const struct lim_scene *scene);

/* Whether it draws objects that move; an error says that it does not. */
bool method_can_move(enum lim_method draws);
bool method_moves(enum lim_method draws, struct error *err);

/* The first name that chooses it; and what the tables and the report call it. */
const char *method_name(enum lim_method draws);
const char *method_title(enum lim_method draws);

/* Whether its pictures are right but for rounding. */
bool method_is_exact(enum lim_method draws);

/* Whether it sorts all polygons, whatever the tree. */
bool method_sorts(enum lim_method draws);

/* Whether it draws scenes without a tree, of triangles, and those alone. */
bool method_draws_meshes(enum lim_method draws);

/* Whether it sorts, or draws meshes. */
bool method_needs_no_tree(enum lim_method draws);

/* Refuses a mesh or a set by a method that walks a tree, and a scene with a tree by one of meshes; `name`: the scene's.
 */
bool method_suits(enum lim_method draws, const char *name, const struct lim_scene *scene, struct error *err);

/* Refuses what has no antialiased edges. */
bool method_antialiases(enum lim_method draws, bool wireframe, struct error *err);

/* Refuses scan lines and meshes with what they cannot paint, which is drawn nearest first: `what`: its name and
 * "is" or "are"; NULL: there is none. */
bool method_scans(enum lim_method draws, const char *what, struct error *err);

/* Refuses what cannot draw wireframes. */
bool method_draws_wireframe(enum lim_method draws, struct error *err);

/* Its C name, enum lim_method. */
const char *method_symbol(enum lim_method draws);

#endif
