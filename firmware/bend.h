/* SPDX-License-Identifier: MIT
 *
 * Movers that bend: their corners are the caller's, so nothing is known of them beforehand. Planes come from the
 * corners themselves, and which polygons face the eye is found one by one. */
#ifndef LIM_BEND_H
#define LIM_BEND_H

#include "corners.h"
#include "eye.h"
#include "instance.h"

/* Whether the instance bends; a constant where none can. */
static inline bool lim_bends(const struct lim_instance *instance)
{
    return LIM_HAS_BENDING && instance->bends;
}

/* The plane of a record's first three corners, its front where they run counter-clockwise, in the object's units.
 * false: they lie on a line. */
bool lim_bend_plane(struct lim_plane_wide *plane, const struct lim_scene *object, const LIM_FLASH lim_index *record);

/* Whether a record faces the eye. */
bool lim_bend_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record);

#endif
