/* SPDX-License-Identifier: MIT
 *
 * Hosts hold every scene with indices of 32 bits. Firmware has indices of 16 bits wherever those suffice: which it is,
 * and what a scene's elements take in flash then. */
#ifndef SIM_WIDTH_H
#define SIM_WIDTH_H

#include "scene.h"

#include <stddef.h>

/* Whether something of the scene has more elements than 16 bits can count. */
bool width_is_wide(const struct lim_scene *scene);

/* Bytes in flash. */
size_t width_node_b(bool wide);
size_t width_plane_b(const struct lim_scene *scene, bool wide);
size_t width_vertex_b(const struct lim_scene *scene);
size_t width_box_b(const struct lim_scene *scene);
size_t width_mapping_b(const struct lim_scene *scene, bool wide);
size_t width_word_b(bool wide); /* of a polygon's record */

#endif
