/* SPDX-License-Identifier: MIT
 *
 * The depth of a polygon: near / z is linear on the screen, so it is a plane over it. In: corners as they lie in their
 * scene, the camera. Out: the plane, in Q30 and modulo 2^32, so that two of them can be compared wherever both polygons
 * are; in a long scene, whose depths have many scales, in Q60 and modulo 2^64. Right to some units of the last place at
 * a corner of the screen, as its normal has 29 bits. */
#ifndef LIM_NEAR_PLANE_H
#define LIM_NEAR_PLANE_H

#include "orders.h"
#include "view/plane_unpacked.h"

/* The plane of a record's corners, which need not lie on it all; in units of its scene, which is not a long one. */
void lim_corners_plane(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                       const LIM_FLASH lim_index *record);

/* The same of a record of what stands still, of the run of a node. Of a long scene it is as seen from the eye. */
void lim_still_plane(struct lim_plane_unpacked *plane, const struct lim_pass *pass, lim_index polygon, lim_index node);

/* Of a polygon of a mover, or of what stands still. */
void lim_near_plane_set(struct lim_near_plane *out, const struct lim_movers *movers, const struct lim_pass *pass,
                        const struct lim_met_polygon *polygon);

/* What differs by less than 2^-this of its depth, all along what two runs share, is as near. */
enum { LIM_NEAR_TIE_BITS = LIM_HAS_FRACTIONS ? 18 : 13, LIM_NEAR_TIE_MOST = INT32_C(1) << (30 - LIM_NEAR_TIE_BITS) };

/* |difference|. */
static inline lim_near_word lim_near_size(lim_near_difference difference)
{
    return difference < 0 ? 0 - (lim_near_word)difference : (lim_near_word)difference;
}

/* A plane along a line of the screen: at the centre of its first pixel, and what a step adds. The nearest a polygon can
 * be is 2^30. */
struct lim_near_row {
    lim_near_word at_q30, x_q30;
};

static inline struct lim_near_row lim_near_row_of(const struct lim_near_plane *plane, int32_t y_px)
{
    return (struct lim_near_row){plane->at_q30 + plane->y_q30 * (uint32_t)y_px, plane->x_q30};
}

/* Pixels x0 <= x < x1. */
struct lim_near_share {
    int32_t x0, x1;
};

/* Of the pixels that two runs share, those where the second is nearer: all, none, or those beyond one column. */
struct lim_near_share lim_near_share(const struct lim_near_row *a, const struct lim_near_row *b, bool b_wins_ties,
                                     struct lim_near_share both);

#endif
