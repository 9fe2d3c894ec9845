/* SPDX-License-Identifier: MIT
 *
 * Movers of a scene of many scales (long.h). Each has a frame of reference: its origin is the eye, its axes are the
 * scene's, and its units are 2^exponent of the scene's, such that the mover lies within 2^16 of them. There it is what
 * a mover of any scene is, in the same formats: lim_movers.instances are copies that say where in its frame each is.
 * Planes go from frame to frame. */
#ifndef LIM_MOVER_LONG_H
#define LIM_MOVER_LONG_H

#include "long.h"
#include "orders.h"
#include "view/plane_unpacked.h"

#define LIM_HAS_FAR_MOVERS (LIM_HAS_LONG && LIM_HAS_MOVERS)
#define LIM_FAR_AXIS (INT32_C(1) << 28) /* in a frame, n of an axis plane along its axis */

/* Whether the scene that they move in is long. Who asks has asked for LIM_HAS_FAR_MOVERS. */
static inline bool lim_movers_are_far(const struct lim_movers *movers)
{
    return LIM_HAS_FAR_MOVERS && *movers->far;
}

/* A mover's frame: its units are 2^this of the scene's. */
static inline int8_t lim_mover_exponent(const struct lim_movers *movers, uint16_t mover)
{
    return (int8_t)(movers->movers[mover].eye.far->unit + movers->instances[mover].finer_bits);
}

/* POSE in a long scene: takes in copies of the instances, before the others' POSE. Then of each: its frame, its place
 * there, and its eye. false: it is out of range. */
void lim_movers_copy(struct lim_movers *movers);
bool lim_mover_approach(struct lim_movers *movers, uint16_t mover);

/* Once its rows are those of a long scene's, turned: the rest of its view. */
void lim_mover_set_far_view(struct lim_mover *mover);

/* Whether the eye is so far away that its object has no coordinates for it: lim_eye.at_q8 is 0, its object without
 * textures. */
static inline bool lim_mover_is_remote(const struct lim_mover *mover)
{
    return LIM_HAS_FAR_MOVERS && mover->eye.far->all;
}

/* As lim_cull_set(), of a mover's object. */
void lim_mover_set_far_cull(struct lim_cull *cull, const struct lim_mover *mover, const struct lim_rect *open);

/* A box in a frame, as lim_cull_sees() of the long scene wants it. */
void lim_mover_far_box(const struct lim_mover *mover, struct lim_box *box);

/* A plane of the long scene, as seen from the eye, in its units; for lim_plane_bring() alone. */
void lim_plane_unpack_far(struct lim_plane_unpacked *plane, const struct lim_eye *eye,
                          const LIM_FLASH struct lim_plane_ref *ref);

/* Brings a plane from the frame of mover `from`, or LIM_NONE: from the long scene, to that of mover `to`. */
void lim_plane_bring(struct lim_plane_unpacked *plane, const struct lim_movers *movers, uint16_t from, uint16_t to);

/* x 2^up, and as much as a frame has numbers for at most. */
int64_t lim_plane_scaled(int64_t x, int_fast8_t up);

#endif
