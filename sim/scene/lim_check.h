/* SPDX-License-Identifier: MIT
 *
 * Whether a scene keeps every promise of scene.h, so that the firmware, which trusts its flash,
 * may trust a file. */
#ifndef SIM_LIM_CHECK_H
#define SIM_LIM_CHECK_H

#include "base/error.h"
#include "scene.h"

/* Refuses indices out of range, nodes that are no tree, runs that do not end or overlap, planes
 * and boxes out of bounds, boxes that do not hold their subtrees, and limits that the scene exceeds. */
bool lim_check(const struct lim_scene *scene, struct error *err);

/* The part of it for a scene without nodes, whose vertices, planes and boxes are within bounds. */
bool lim_check_mesh(const struct lim_scene *scene, struct error *err);

/* The part of it for a node that is a mesh leaf, whose records are sound by themselves. */
bool lim_check_mesh_leaf(const struct lim_scene *scene, size_t node, struct error *err);

/* The parts of it for a long scene: what it may have at all, which is true of other scenes; its arrays; a plane that
 * `what` names. */
bool lim_check_long(const struct lim_scene *scene, struct error *err);
bool lim_check_long_vertices(const struct lim_scene *scene, struct error *err);
bool lim_check_long_boxes(const struct lim_scene *scene, struct error *err);
bool lim_check_long_planes(const struct lim_scene *scene, struct error *err);
bool lim_check_long_mapping(const struct lim_scene *scene, size_t index, struct error *err);
bool lim_check_long_ref(const struct lim_scene *scene, const struct lim_plane_ref *ref, const char *what, size_t index,
                        struct error *err);

/* The part of it that is about textures and mappings. */
bool lim_check_textures(const struct lim_scene *scene, struct error *err);

#endif
