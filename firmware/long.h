/* SPDX-License-Identifier: MIT
 *
 * Scenes of many scales: a screw and the ship that it is in. Units are as fine as the screw wants them, and coordinates
 * have 32 bits in place of 16. Such a scene is called long. It has these arrays instead of lim_scene.vertices, planes,
 * exact and boxes, and one more beside lim_scene.mappings; nodes, records, textures and all else are as in any scene.
 * What moves in them are scenes of 16 bits in any case, each with a unit of its own: struct lim_instance.
 *
 * Nothing is asked of the grid but to hold the scene: a point is seen from the eye, as a way of three numbers with one
 * exponent (math/relative.h), so what is near is as exact as if the rest were not there. */
#ifndef LIM_LONG_H
#define LIM_LONG_H

#include "scene.h"

/* Of lim_instance finer_bits are 0..8 here, and where they are 0 coarser_bits 0..14; |origin|, and together with at_q8,
 * is below 2^30. An object from which the eye is 2^29 of its own units away or more is left out: it is a part of a
 * pixel. In lim_motion each key's at_q8 counts from origins[]. */

#define LIM_LONG_END (INT32_C(1) << 29)     /* |coordinate| of vertices and boxes up to this, units: a span of 2^30 */
#define LIM_LONG_EYE_END (INT32_C(1) << 30) /* |coordinate| of the eye, rounded down, below this, units */
#define LIM_LONG_FAR_BITS 32                /* no vertex is 2^this units away from such an eye */
#define LIM_LONG_NEAR_MAX_Q8 (INT32_C(14000) * 256) /* lim_camera.near_q8 beyond this is drawn as about this */

struct lim_long_vertex {
    int32_t at[3]; /* units */
};

/* A plane that is not an axis plane, of all p with n . (p - v) = rest, where v is a vertex near it. Its front is where
 * n . (p - v) is more. |n[i]| <= 2^30. */
struct lim_long_plane {
    int32_t n[3];
    int32_t rest;
    uint32_t vertex; /* index of v */
};

/* Holds every polygon of a subtree: |p[i] - centre[i]| <= half[i]. */
struct lim_long_box {
    int32_t centre[3]; /* units */
    uint32_t half[3];  /* units, up to 2^30 */
};

/* Of lim_scene.mappings, the one of the same index has a texture, a plane and an axis as in any scene, but the plane is
 * named as by lim_plane_ref of a long scene: of an axis plane by a vertex in it. What it says of a sky holds, too; its
 * other uv, its bits and its level mean nothing. A point p shows uv[i] . (p_j - v_j, p_k - v_k) / 2^bits +
 * at_zero_q16[i] / 2^16, v being the vertex by which the plane goes, in widths of the picture. */
struct lim_long_mapping {
    int32_t uv[2][2]; /* the components of either add up to LIM_LONG_UV_MAX at most, without their signs */
    int16_t level_q4; /* log2 of texels a unit, the mean of both directions, and half of log2(|n| / 2^30) */
    uint8_t bits, zero;
};
#define LIM_LONG_UV_MAX (INT32_C(32766) * 65536) /* so that 16 bits, rounded, add up to 32767 */
enum { LIM_LONG_UV_BITS_MIN = 16, LIM_LONG_UV_BITS_MAX = 62, LIM_LONG_LEVEL_MAX_Q4 = 1023 }; /* |level_q4| */

/* lim_plane_ref.plane counts planes, not words. With an axis plane, LIM_PLANE_X and so on, lim_plane_ref.offset is the
 * index of a vertex in it. */
struct lim_long {
    const LIM_FLASH struct lim_long_vertex *vertices; /* lim_scene.vertex_count of them, and so on */
    const LIM_FLASH struct lim_long_plane *planes;
    const LIM_FLASH struct lim_long_box *boxes;
    const LIM_FLASH struct lim_fraction *fractions; /* lim_scene.fractions, or NULL; in any profile */
    const LIM_FLASH struct lim_long_mapping *mappings;
};

/* NULL: the scene is one of 16 bits. */
static inline const struct lim_long *lim_scene_long(const struct lim_scene *scene)
{
    return LIM_HAS_LONG ? *scene->of_32_bits : NULL;
}

#endif
