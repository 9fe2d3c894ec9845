/* SPDX-License-Identifier: MIT
 *
 * On which side of a node's plane is the eye? Decided exactly, in integers: a 32-bit test settles
 * nearly every case, a 64-bit one the rest. */
#ifndef LIM_EYE_H
#define LIM_EYE_H

#include "long.h"
#include "math/fixed.h"
#include "stages.h"

#define LIM_EYE_MAX_Q8 (INT32_C(1) << 28) /* |eye_q8| stays below: 64-bit plane values cannot overflow */

void lim_eye_set(struct lim_eye *eye, const struct lim_scene *scene, const int32_t at_q8[3]);

/* The same in a long scene; false: the camera is out of range. Then the side of any plane, as lim_eye_side() has it,
 * and a box that holds a box as it is seen from the eye, in units that make it fit. */
bool lim_eye_set_long(struct lim_eye *eye, const struct lim_scene *scene, const struct lim_camera *camera);
int32_t lim_eye_long_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref);
/* n . (e - v) - rest of a plane at its vertex, rounded down; what is left goes to *fraction_q8. */
int64_t lim_eye_long_value(const struct lim_long_eye *eye, const LIM_FLASH struct lim_long_plane *plane,
                           const LIM_FLASH struct lim_long_vertex *vertex, uint8_t *fraction_q8);
void lim_eye_long_box(const struct lim_eye *eye, const LIM_FLASH struct lim_long_box *box, struct lim_box *out);

/* How far in front of a long scene's plane the eye is, rounded down, in parts of a unit: a unit's distance is *length
 * of them at most, < 2^32. */
int64_t lim_eye_long_distance(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref, uint32_t *length);

/* Whichever the scene is. */
static inline bool lim_eye_begin(struct lim_eye *eye, const struct lim_scene *scene, const struct lim_camera *camera)
{
    if (LIM_HAS_LONG && lim_scene_long(scene)) return lim_eye_set_long(eye, scene, camera);
    lim_eye_set(eye, scene, camera->eye_q8);
    return true;
}

/* The side of a plane that is not an axis plane, from anywhere: positive in front, negative behind, 0 exactly
 * on it. The second multiplies in 64 bits at once: for where the filter cannot tell, and for builds without one. */
int32_t lim_eye_far_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref);
int32_t lim_eye_close_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref);

/* n . s of the reduced eye s. */
//@ logic integer size(integer i) = i < 0 ? -i : i;
/*@ requires \valid_read(eye) && \valid_read(plane);
    requires -32768 <= eye->reduced[0] <= 32767 && -32768 <= eye->reduced[1] <= 32767;
    requires -32768 <= eye->reduced[2] <= 32767;
    requires size((int16_t)plane->n_yx) + size(plane->n_yx >> 16) + size(plane->n_z_exact >> 16) <= 32767;
    assigns \nothing;
    ensures -32767 * 32768 <= \result <= 32767 * 32768; */
static inline int32_t lim_eye_dot(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane)
{
#if LIM_DUAL_MULTIPLY
    const int32_t of_z = lim_plane_z(plane) * eye->reduced[2];
    return (int32_t)fixed_dot_pairs((const int16_t *)&plane->n_yx, eye->reduced, (uint32_t)of_z);
#else
    const int32_t x = lim_plane_x(plane), y = lim_plane_y(plane), z = lim_plane_z(plane);
    //@ assert size(x) + size(y) + size(z) <= 32767;
    //@ assert -size(x) * 32768 <= x * eye->reduced[0] <= size(x) * 32768;
    //@ assert -size(y) * 32768 <= y * eye->reduced[1] <= size(y) * 32768;
    //@ assert -size(z) * 32768 <= z * eye->reduced[2] <= size(z) * 32768;
    int32_t sum = x * eye->reduced[0];

    sum += y * eye->reduced[1];
    sum += z * eye->reduced[2];
    return sum;
#endif
}

/* 0: the eye may be on either side. The sum is n . s - d + slack, so a shift of slack's bits and one more leaves
 * nothing of -slack .. slack - 1, and only there. scene.h's bounds keep it in 32 bits. Bytes are shifted slowly: there
 * only the eye inside of the cube comes here. */
/*@ requires \valid_read(eye) && \valid_read(plane) && 0 <= eye->shift <= 12;
    requires -1073676289 <= plane->slack_less_d - 65536 <= 1073676289;
    requires eye->shift == 0 ? eye->slack_rest == 0 : 0 <= eye->slack_rest <= 65536;
    requires -32768 <= eye->reduced[0] <= 32767 && -32768 <= eye->reduced[1] <= 32767;
    requires -32768 <= eye->reduced[2] <= 32767;
    requires size((int16_t)plane->n_yx) + size(plane->n_yx >> 16) + size(plane->n_z_exact >> 16) <= 32767;
    assigns \nothing; */
static inline int32_t lim_eye_near_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane)
{
    if (LIM_8_BIT) return (lim_eye_dot(eye, plane) + plane->slack_less_d) >> 17;
    return (lim_eye_dot(eye, plane) + (plane->slack_less_d >> eye->shift) + eye->slack_rest) >> 17;
}

/* On which side of a plane the eye is: positive in front, negative behind, 0 exactly on it. */
static inline int32_t lim_eye_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref)
{
    const lim_index at = ref->plane;

    if (LIM_HAS_LONG && eye->far->all) return lim_eye_long_side(eye, ref);
    if (LIM_HAS_FILTER && at < eye->near_end) {
        const int32_t side = lim_eye_near_side(eye, lim_plane_at(eye->planes, at));
        return side ? side : lim_eye_close_side(eye, ref);
    }
    if (LIM_HAS_SLANTED && at < LIM_PLANE_X)
        return LIM_HAS_FILTER ? lim_eye_far_side(eye, ref) : lim_eye_close_side(eye, ref);
    return eye->at_q8[at & 3] - (int32_t)ref->offset * 256;
}

/* Whether a record of a run that WALK gave faces the eye: those of a node do, those of a leaf may. */
static LIM_INLINE bool lim_record_is_seen(const struct lim_eye *eye, const LIM_FLASH lim_index *record)
{
    if (!LIM_HAS_LEAVES || !(record[0] & LIM_POLYGON_PLANE)) return true;
    const LIM_FLASH struct lim_plane_ref *ref = lim_record_plane(record);
    const uint32_t back = (uint32_t)record[0] * (0x80000000u / LIM_POLYGON_BACK);
    if (LIM_HAS_FILTER && ref->plane < eye->near_end) {
        const int32_t near = lim_eye_near_side(eye, lim_plane_at(eye->planes, ref->plane));
        if (near) return (int32_t)((uint32_t)near ^ back) >= 0;
    }
    const int32_t side = lim_eye_side(eye, ref);
    return side && (int32_t)((uint32_t)side ^ back) >= 0;
}

#endif
