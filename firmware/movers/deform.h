/* SPDX-License-Identifier: MIT
 *
 * Polygons without stored planes: those of movers that deform, whose corners are the caller's, so nothing is known of
 * them beforehand, and those of mesh leaves. Planes come from the corners themselves, and which polygons face the eye
 * is found one by one. */
#ifndef LIM_DEFORM_H
#define LIM_DEFORM_H

#include "scene.h"
#include "stages.h"
#include "view/plane_unpacked.h"

#define LIM_HAS_CORNER_PLANES (LIM_HAS_DEFORM || LIM_HAS_MESH_LEAVES)

/* Whether the instance deforms; a constant where none can. */
static inline bool lim_deforms(const struct lim_instance *instance)
{
    return LIM_HAS_DEFORM && instance->deforms;
}

/* The plane of a record's first three corners, its front where they run counter-clockwise, in the object's units.
 * false: they lie on a line. */
bool lim_deform_plane(struct lim_plane_unpacked *plane, const struct lim_scene *object,
                      const LIM_FLASH lim_index *record);

/* Whether a record faces the eye. */
bool lim_deform_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record);

#endif
