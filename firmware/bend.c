/* SPDX-License-Identifier: MIT
 *
 * Differences of corners have 17 bits and their products 34, so a normal has 36 at most: it is shortened to 29, which
 * no corner of the 16-bit cube can tell, and its plane goes through the first corner. */
#include "bend.h"

#if LIM_HAS_BENDING

enum { NORMAL_BITS = 29 };

bool lim_bend_plane(struct lim_plane_wide *plane, const struct lim_scene *object, const LIM_FLASH lim_index *record)
{
    int32_t at[3][3];
    int64_t n[3];
    uint64_t bits = 0;
    uint8_t shift = 0;

    for (uint_fast8_t k = 0; k < 3; k++) {
        const struct lim_vertex vertex = object->vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        at[k][0] = vertex.x;
        at[k][1] = vertex.y;
        at[k][2] = vertex.z;
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        n[i] = (int64_t)(at[1][j] - at[0][j]) * (at[2][k] - at[0][k]) -
               (int64_t)(at[1][k] - at[0][k]) * (at[2][j] - at[0][j]);
        bits |= (uint64_t)(n[i] < 0 ? -n[i] : n[i]);
    }
    while (bits >> shift >> NORMAL_BITS)
        shift++;
    plane->d = plane->slack = 0;
    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    for (uint_fast8_t i = 0; i < 3; i++) {
        plane->n[i] = (int32_t)(n[i] >> shift);
        plane->d += (int64_t)plane->n[i] * at[0][i];
        plane->slack += abs_s32(plane->n[i]);
    }
    return bits != 0;
}

/* |n| < 2^29 and |c| < 2^28 with 8 fraction bits: below 2^60. */
bool lim_bend_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record)
{
    struct lim_plane_wide plane;

    return lim_bend_plane(&plane, eye->scene, record) &&
           lim_plane_value(&plane, eye->at_q8[0], eye->at_q8[1], eye->at_q8[2], 256) > 0;
}

#endif
