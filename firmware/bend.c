/* SPDX-License-Identifier: MIT
 *
 * Differences of corners have 17 bits and their products 34, so a normal has 36 at most: it is shortened to 29, which
 * no corner of the 16-bit cube can tell, and its plane goes through the first corner. */
#include "bend.h"

#if LIM_HAS_BENDING

#define NORMAL_END (INT64_C(1) << 29)

/* a b - c d of differences of two corners' coordinates, 17 bits each. */
/*@ requires -65535 <= a <= 65535 && -65535 <= b <= 65535 && -65535 <= c <= 65535 && -65535 <= d <= 65535;
    assigns \nothing;
    ensures -8589672450 <= \result <= 8589672450; */
static int64_t area(int32_t a, int32_t b, int32_t c, int32_t d)
{
    //@ assert -4294836225 <= a * b <= 4294836225 && -4294836225 <= c * d <= 4294836225;
    return (int64_t)a * b - (int64_t)c * d;
}

bool lim_bend_plane(struct lim_plane_wide *plane, const struct lim_scene *object, const LIM_FLASH lim_index *record)
{
    int32_t at[3][3];
    int64_t n[3];

    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t k = 0; k < 3; k++) {
        const LIM_FLASH struct lim_vertex *vertex = &object->vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        at[k][0] = vertex->x;
        at[k][1] = vertex->y;
        at[k][2] = vertex->z;
    }
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        n[i] = area(at[1][j] - at[0][j], at[2][k] - at[0][k], at[1][k] - at[0][k], at[2][j] - at[0][j]);
    }
    shorten_s64(n, 3, NORMAL_END);
    plane->d = plane->slack = 0;
    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        plane->n[i] = (int32_t)n[i];
        //@ assert -17592186044416 <= plane->n[i] * at[0][i] <= 17592186044416;
        plane->d += (int64_t)plane->n[i] * at[0][i];
        plane->slack += abs_s32(plane->n[i]);
    }
    return plane->slack != 0;
}

/* |n| < 2^29 and |c| < 2^28 with 8 fraction bits: below 2^60. */
bool lim_bend_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record)
{
    struct lim_plane_wide plane;

    return lim_bend_plane(&plane, eye->scene, record) &&
           lim_plane_value(&plane, eye->at_q8[0], eye->at_q8[1], eye->at_q8[2], 256) > 0;
}

#endif
