/* SPDX-License-Identifier: MIT
 *
 * Planes of a scene, unpacked, and where points lie to them: in units, or with 12 fraction bits. */
#ifndef LIM_PLANE_UNPACKED_H
#define LIM_PLANE_UNPACKED_H

#include "math/fixed.h"
#include "stages.h"

enum { LIM_CORNER_ONE_Q12 = 4096, LIM_NO_AXIS = 3 };

void lim_plane_unpack(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                      const LIM_FLASH struct lim_plane_ref *ref);

/* n . p - d, of a point in units where one is 1, or in units / one. */
static inline int64_t lim_plane_value(const struct lim_plane_unpacked *plane, int32_t x, int32_t y, int32_t z,
                                      int32_t one)
{
    return (int64_t)plane->n[0] * x + (int64_t)plane->n[1] * y + (int64_t)plane->n[2] * z - plane->d * one;
}

/* The same in 2^-8 units, of an axis plane without its normal. */
static inline int64_t lim_plane_value_q8(const struct lim_plane_unpacked *plane, const int32_t at_q8[3])
{
    if (plane->axis != LIM_NO_AXIS) return at_q8[plane->axis] - (int32_t)plane->d * 256;
    return lim_plane_value(plane, at_q8[0], at_q8[1], at_q8[2], 256);
}

static inline int64_t lim_corner_value(const struct lim_plane_unpacked *plane, const int32_t at_q12[3])
{
    if (plane->axis != LIM_NO_AXIS) return at_q12[plane->axis] - (int32_t)plane->d * (int32_t)LIM_CORNER_ONE_Q12;
    return lim_plane_value(plane, at_q12[0], at_q12[1], at_q12[2], LIM_CORNER_ONE_Q12);
}

/* A vertex, with LIM_HAS_FRACTIONS in 1/256 units; of a scene that is not long. */
void lim_corner_load(int32_t at[3], const struct lim_scene *scene, lim_index vertex);

/* What one of these is in Q12. */
#define LIM_CORNER_LOADED_Q12 (LIM_HAS_FRACTIONS ? 16 : (int32_t)LIM_CORNER_ONE_Q12)

/* How far along from a value to one of the other sign 0 is. */
uint32_t lim_plane_zero_q31(int64_t from, int64_t to);

/* Where the plane meets the way from a point in front to one behind, any three coordinates: always from the front, so
 * that both sides get the same. The values are n . p - d there, in any one scale. */
void lim_plane_cross(int32_t out[3], const int32_t front[3], int64_t front_value, const int32_t back[3],
                     int64_t back_value);

#endif
