/* SPDX-License-Identifier: MIT
 *
 * On which side of a long scene's plane is the eye? n . (e - v) against the plane's rest.
 *
 * The filter has the way d from the eye to v in 16 bits, |d| <= 2^15, and the upper 16 bits m of n, |m| <= 2^14. Let
 * n = 2^16 (m + f), 0 <= f < 1 in each component. The way is 2^s (d + g) units: -1 < g < 1 for what is shifted out and
 * for the eye's fraction. Then n . way / 2^(16 + s) is m . d, off by f . d + m . g + f . g: below 3 * 2^15 + 3 * 2^14
 * + 3. The rest, shifted likewise, is off by less than 1. LONG_SLACK is more than all of that; what is beyond it is
 * decided. The other sums are exact. */
#include "eye.h"

#include "math/relative.h"
#include "view/plane_unpacked.h"

#if LIM_HAS_LONG

enum { LONG_FILTER_BITS = 15 };
#define LONG_SLACK (INT32_C(1) << 18)

bool lim_eye_set_long(struct lim_eye *eye, const struct lim_scene *scene, const struct lim_camera *camera)
{
    eye->scene = scene;
    eye->far->all = lim_scene_long(scene);
    for (uint_fast8_t i = 0; i < 3; i++) {
        eye->at_q8[i] = 0;
        if (abs_s32(camera->origin[i]) >= (uint32_t)LIM_LONG_EYE_END) return false;
        eye->far->at[i] = camera->origin[i] + (camera->eye_q8[i] >> 8);
        eye->far->fraction_q8[i] = (uint8_t)camera->eye_q8[i];
        if (abs_s32(eye->far->at[i]) >= (uint32_t)LIM_LONG_EYE_END) return false;
    }
    eye->far->unit = 0;
    eye->near_end = 0;
    return true;
}

/* What was put by whole units. */
static void become_far(struct lim_camera *camera)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        camera->origin[i] = camera->eye_q8[i];
        camera->eye_q8[i] = 0;
    }
}

void lim_look_at_far(struct lim_camera *camera, const int32_t eye[3], const int32_t target[3])
{
    lim_look_at(camera, eye, target);
    become_far(camera);
}

void lim_orbit_far(struct lim_camera *camera, const int32_t target[3], int32_t radius, uint32_t yaw, uint32_t pitch)
{
    lim_orbit(camera, target, radius, yaw, pitch);
    become_far(camera);
}

void lim_camera_carry(struct lim_camera *camera)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        camera->origin[i] += camera->eye_q8[i] >> 8;
        camera->eye_q8[i] &= 0xFF;
    }
}

/* It is below 3 * 2^30 * 1.5 * 2^30 < 2^63. */
int64_t lim_eye_long_value(const struct lim_long_eye *eye, const LIM_FLASH struct lim_long_plane *plane,
                           const LIM_FLASH struct lim_long_vertex *vertex, uint8_t *fraction_q8)
{
    int64_t whole = -(int64_t)plane->rest, rest_q8 = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        whole += (int64_t)plane->n[i] * (eye->at[i] - vertex->at[i]);
        rest_q8 += (int64_t)plane->n[i] * eye->fraction_q8[i];
    }
    *fraction_q8 = (uint8_t)rest_q8;
    return whole + (rest_q8 >> 8);
}

static LIM_RARE int32_t exact_long_side(const struct lim_long_eye *eye, const LIM_FLASH struct lim_long_plane *plane,
                                        const LIM_FLASH struct lim_long_vertex *vertex)
{
    uint8_t fraction_q8;
    const int64_t whole = lim_eye_long_value(eye, plane, vertex, &fraction_q8);

    return whole ? (whole > 0) - (whole < 0) : fraction_q8 != 0;
}

static int32_t side_of_axis(const struct lim_long_eye *eye, const LIM_FLASH struct lim_long_vertex *vertex,
                            uint_fast8_t axis)
{
    const int32_t whole = eye->at[axis] - vertex->at[axis];

    return whole ? whole : eye->fraction_q8[axis];
}

/* So that numbers of that size have LONG_FILTER_BITS; some less where leading zeros would have to be searched for. */
static inline uint8_t filter_shift(uint32_t size)
{
    if (LIM_HAS_CLZ) {
        const uint8_t zeros = clz_u32(size | 1);
        return zeros < 32 - LONG_FILTER_BITS ? (uint8_t)(32 - LONG_FILTER_BITS - zeros) : 0;
    }
    uint8_t shift = size >> (LONG_FILTER_BITS + 5) ? 8 : 0;
    for (size >>= shift; size >> LONG_FILTER_BITS; size >>= 4)
        shift = (uint8_t)(shift + 4);
    return shift;
}

/* Of an object that moves, from so far away that only whole units fit: |n| < 2^31 and |e| < 2^29, as |d| < 2^48. */
static LIM_RARE int32_t remote_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref)
{
    const struct lim_long_eye *from = eye->far;
    struct lim_plane_unpacked plane;
    int64_t rest_q8 = 0;

    lim_plane_unpack(&plane, eye->scene, ref);
    int64_t whole = -plane.d;
    for (uint_fast8_t i = 0; i < 3; i++) {
        whole += (int64_t)plane.n[i] * from->at[i];
        rest_q8 += (int64_t)plane.n[i] * from->fraction_q8[i];
    }
    whole += rest_q8 >> 8;
    return whole ? (whole > 0) - (whole < 0) : (rest_q8 & 0xFF) != 0;
}

int32_t lim_eye_long_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref)
{
    const struct lim_long_eye *from = eye->far;
    const struct lim_long *all = from->all;

    if (LIM_HAS_MOVERS && !all->vertices) return remote_side(eye, ref);
    if (ref->plane >= LIM_PLANE_X) return side_of_axis(from, &all->vertices[(lim_index)ref->offset], ref->plane & 3);
    const LIM_FLASH struct lim_long_plane *plane = &all->planes[ref->plane];
    const LIM_FLASH struct lim_long_vertex *vertex = &all->vertices[plane->vertex];
    const int32_t x = vertex->at[0] - from->at[0], y = vertex->at[1] - from->at[1], z = vertex->at[2] - from->at[2];
    const uint8_t shift = filter_shift(relative_size(x) | relative_size(y) | relative_size(z));
    int32_t sum = plane->rest >> 16 >> shift;

    sum += (plane->n[0] >> 16) * (x >> shift);
    sum += (plane->n[1] >> 16) * (y >> shift);
    sum += (plane->n[2] >> 16) * (z >> shift);
    if (sum >= LONG_SLACK || sum <= -LONG_SLACK) return -sum;
    return exact_long_side(from, plane, vertex);
}

int64_t lim_eye_long_distance(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref, uint32_t *length)
{
    const struct lim_long_eye *from = eye->far;
    const struct lim_long *all = from->all;
    uint8_t fraction_q8;

    *length = 1;
    if (ref->plane >= LIM_PLANE_X)
        return from->at[ref->plane & 3] - all->vertices[(lim_index)ref->offset].at[ref->plane & 3];
    const LIM_FLASH struct lim_long_plane *plane = &all->planes[ref->plane];
    *length = abs_s32(plane->n[0]) + abs_s32(plane->n[1]) + abs_s32(plane->n[2]);
    return lim_eye_long_value(from, plane, &all->vertices[plane->vertex], &fraction_q8);
}

void lim_eye_long_box(const struct lim_eye *eye, const LIM_FLASH struct lim_long_box *box, struct lim_box *out)
{
    uint32_t size = 0;
    int32_t way[3];

    for (uint_fast8_t i = 0; i < 3; i++) {
        way[i] = box->centre[i] - eye->far->at[i];
        size |= abs_s32(way[i]) + box->half[i];
    }
    const uint8_t zeros = clz_u32(size | 1);
    const uint8_t shift = zeros < 18 ? (uint8_t)(18 - zeros) : 0; /* |way| + half < 2^14 */
    for (uint_fast8_t i = 0; i < 3; i++) {
        out->centre[i] = (int16_t)(way[i] >> shift);
        out->half[i] = (uint16_t)((box->half[i] >> shift) + 3); /* rounding of both, and the eye's fraction */
    }
}

#endif
