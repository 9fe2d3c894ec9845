/* SPDX-License-Identifier: MIT
 *
 * Differences of corners have 17 bits and their products 34, so a normal has 36 at most: it is shortened to 29, which
 * no corner of the 16-bit cube can tell, and its plane goes through the first corner. */
#include "movers/deform.h"

#include "stages.h"

#if LIM_HAS_CORNER_PLANES

#define NORMAL_END (INT64_C(1) << 29)

/* a b - c d of differences of two corners' coordinates, 17 bits each. */
/*@ requires -65535 <= a <= 65535 && -65535 <= b <= 65535 && -65535 <= c <= 65535 && -65535 <= d <= 65535;
    assigns \nothing;
    ensures -8589672450 <= \result <= 8589672450; */
static int64_t deform_area(int32_t a, int32_t b, int32_t c, int32_t d)
{
    //@ assert -4294836225 <= a * b <= 4294836225 && -4294836225 <= c * d <= 4294836225;
    return (int64_t)a * b - (int64_t)c * d;
}

/*@ requires -536870912 <= n < 536870912 && -32768 <= v <= 32767;
    assigns \nothing;
    ensures -17592186044416 <= \result <= 17592186044416; */
static int64_t moment(int32_t n, int32_t v)
{
    return (int64_t)n * v;
}

/* The normal of three corners that run counter-clockwise. */
/*@ requires \valid(n + (0 .. 2)) && \valid_read(a + (0 .. 2)) && \valid_read(b + (0 .. 2)) && \valid_read(c + (0 ..
   2)); requires \separated(n + (0 .. 2), a + (0 .. 2), b + (0 .. 2), c + (0 .. 2)); requires -32768 <= a[0] <= 32767 &&
   -32768 <= a[1] <= 32767 && -32768 <= a[2] <= 32767; requires -32768 <= b[0] <= 32767 && -32768 <= b[1] <= 32767 &&
   -32768 <= b[2] <= 32767; requires -32768 <= c[0] <= 32767 && -32768 <= c[1] <= 32767 && -32768 <= c[2] <= 32767;
    assigns n[0 .. 2];
    ensures -8589672450 <= n[0] <= 8589672450 && -8589672450 <= n[1] <= 8589672450;
    ensures -8589672450 <= n[2] <= 8589672450; */
static void set_normal(int64_t n[3], const int32_t a[3], const int32_t b[3], const int32_t c[3])
{
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        n[i] = deform_area(b[j] - a[j], c[k] - a[k], b[k] - a[k], c[j] - a[j]);
    }
}

/* Of a normal of 29 bits and a sign: d stays below 3 * 2^44. */
/*@ requires \valid(plane) && \valid_read(n + (0 .. 2)) && \valid_read(through + (0 .. 2));
    requires \separated(plane, n + (0 .. 2), through + (0 .. 2));
    requires -536870912 <= n[0] < 536870912 && -536870912 <= n[1] < 536870912 && -536870912 <= n[2] < 536870912;
    requires -32768 <= through[0] <= 32767 && -32768 <= through[1] <= 32767 && -32768 <= through[2] <= 32767;
    assigns *plane;
    ensures -536870912 <= plane->n[0] < 536870912 && -536870912 <= plane->n[1] < 536870912;
    ensures -536870912 <= plane->n[2] < 536870912;
    ensures -52776558133248 <= plane->d <= 52776558133248 && 0 <= plane->slack <= 1610612736; */
static void set_through(struct lim_plane_unpacked *plane, const int64_t n[3], const int32_t through[3])
{
    plane->d = plane->slack = 0;
    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    //@ loop pragma UNROLL "completely", 4;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t part = (int32_t)n[i];
        plane->n[i] = part;
        plane->d += moment(part, through[i]);
        plane->slack += abs_s32(part);
    }
}

bool lim_deform_plane(struct lim_plane_unpacked *plane, const struct lim_scene *object,
                      const LIM_FLASH lim_index *record)
{
    int32_t at[3][3];
    int64_t n[4];

    for (uint_fast8_t k = 0; k < 3; k++) {
        const struct lim_vertex vertex = object->vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        at[k][0] = vertex.x;
        at[k][1] = vertex.y;
        at[k][2] = vertex.z;
    }
    set_normal(n, at[0], at[1], at[2]);
    n[3] = 0;
    shorten_s64(n, NORMAL_END);
    set_through(plane, n, at[0]);
    if (LIM_HAS_LONG) *plane->along = LIM_NO_AXIS;
    return plane->slack != 0;
}

/* |n| < 2^29 and |c| < 2^28 with 8 fraction bits: below 2^60. */
bool lim_deform_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record)
{
    struct lim_plane_unpacked plane;

    if (LIM_HAS_LONG && eye->far->all) {
        if (!lim_deform_plane(&plane, eye->scene, record)) return false;
        return lim_plane_value(&plane, eye->far->at[0], eye->far->at[1], eye->far->at[2], 1) >= 0;
    }
    return lim_deform_plane(&plane, eye->scene, record) &&
           lim_plane_value(&plane, eye->at_q8[0], eye->at_q8[1], eye->at_q8[2], 256) > 0;
}

#endif
