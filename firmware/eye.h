/* SPDX-License-Identifier: MIT
 *
 * On which side of a node's plane is the eye? Decided exactly, in integers: a 32-bit test settles
 * nearly every case, a 64-bit one the rest. */
#ifndef LIM_EYE_H
#define LIM_EYE_H

#include "scene.h"

#define LIM_EYE_MAX_Q8 (INT32_C(1) << 28) /* |eye_q8| stays below: 64-bit plane values cannot overflow */

struct lim_eye {
    int32_t at_q8[3];    /* units */
    int32_t reduced[3];  /* floor(at / 2^shift), within 16 bits whatever the distance */
    uint8_t shift;       /* 0 inside the 16-bit cube of the scene */
    uint8_t near_kind;   /* the last enum lim_plane_kind that needs neither shift nor slack */
    int32_t large_slack; /* how far the filter of a LARGE plane can be off, in its own scale */
};

void lim_eye_set(struct lim_eye *eye, const int32_t at_q8[3]);

/* Positive: in front of the plane, negative: behind it, 0: exactly on it. The first for planes with 16-bit
 * numbers (XZ, SMALL) and an eye with shift 0, the second for every plane that has a record, and any eye. */
int16_t lim_eye_near_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane);
int16_t lim_eye_far_side(const struct lim_eye *eye, const struct lim_scene *scene,
                         const LIM_FLASH struct lim_plane *plane);

/* The same for a node's plane, whatever its kind. */
static inline int16_t lim_eye_side(const struct lim_eye *eye, const struct lim_scene *scene,
                                   const LIM_FLASH struct lim_node *node)
{
    const uint16_t kind = node->kind;

    if (!LIM_HAS_SLANTED || kind <= LIM_PLANE_Z) {
        const int32_t at_q8 = eye->at_q8[kind], plane_q8 = (int32_t)(int16_t)node->plane * 256;
        return (int16_t)((at_q8 > plane_q8) - (at_q8 < plane_q8));
    }
    const LIM_FLASH struct lim_plane *plane = &scene->planes[node->plane];
    return kind <= eye->near_kind ? lim_eye_near_side(eye, plane) : lim_eye_far_side(eye, scene, plane);
}

#endif
