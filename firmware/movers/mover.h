/* SPDX-License-Identifier: MIT
 *
 * POSE places each instance, once a frame: the view and the eye in the object's own coordinates, so that it is drawn by
 * the same stages as any scene; and its points and planes in the static scene. In: instances, the camera. Memory: the
 * caller's, struct lim_movers_limits. */
#ifndef LIM_MOVER_H
#define LIM_MOVER_H

#include "movers/axes.h"
#include "orders.h"
#include "view/plane_unpacked.h"

/* POSE. The camera is taken in. */
void lim_movers_pose(struct lim_movers *movers, struct lim_pass *pass, const struct lim_camera *camera);

/* In all views of the frame. */
void lim_movers_set_antialiased(struct lim_movers *movers, bool antialiased);

/* An object's vertex in the static scene, Q12: valid until another one is asked for. */
const int32_t *lim_mover_corner(struct lim_movers *movers, uint16_t mover, lim_index vertex);

/* They have moved. */
void lim_mover_forget_corners(struct lim_movers *movers);

/* The mover's view, with the cache empty or its own. */
struct lim_view *lim_mover_view(struct lim_movers *movers, uint16_t mover);

/* From where on textures of its records are numbered (texturing.h), once it has a view; LIM_NONE: it shows none. */
static inline uint16_t lim_mover_first_texture(const struct lim_movers *movers, uint16_t mover)
{
    return LIM_HAS_TEXTURE ? *movers->movers[mover].texturing->first_texture : (uint16_t)LIM_NONE;
}

/* How far ahead of the eye a point is, in 1/512 units. */
int32_t lim_mover_depth(const struct lim_movers *movers, const int32_t at_q12[3]);

/* Whether nothing of mover `b` can hide anything of `a`: a plane between them tells, or their depths. */
bool lim_mover_precedes(const struct lim_movers *movers, uint16_t a, uint16_t b);

/* A plane of an object, as it lies in the static scene. */
void lim_mover_turn(const struct lim_movers *movers, uint16_t mover, struct lim_plane_unpacked *plane);

#endif
