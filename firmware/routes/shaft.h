/* SPDX-License-Identifier: MIT
 *
 * SHAFT: whether something that moves has to be cut where it reaches through a plane. All of it may be drawn before
 * what is beyond, unless something there stands between the eye and it: in the shaft, which holds all ways to the eye
 * from its part beyond, as far as they lie there. Or all of it may be drawn after what is on the eye's side, unless it
 * hides something of that: what lies in its shadow, up to the plane. In: boxes, the static tree. Memory: what is free
 * of the route's stack. */
#ifndef LIM_SHAFT_H
#define LIM_SHAFT_H

#include "orders.h"
#include "pieces/corners.h"

/* In a long scene: the frame of the mover that it is of, where its units are. */
struct lim_shaft_frame {
    const struct lim_movers *movers;
    uint16_t mover;
};

LIM_OPTIONAL_BEGIN
struct lim_shaft {
    int32_t low[3], high[3]; /* units */
    bool is_shadow;
    LIM_OPTIONAL(struct lim_shaft_frame, far, LIM_HAS_LONG);
};
LIM_OPTIONAL_END

/* Of the part of `of` beyond a plane that it reaches through, or on the eye's side of it. false: it has no end. */
void lim_shaft_set(struct lim_shaft *shaft, const struct lim_eye *eye, const struct lim_reach *of,
                   const struct lim_plane_unpacked *plane, bool front_is_near);
bool lim_shadow_set(struct lim_shaft *shadow, const struct lim_eye *eye, const struct lim_reach *of,
                    const struct lim_plane_unpacked *plane, bool front_is_near);

bool lim_shaft_meets_extent(const struct lim_shaft *shaft, const struct lim_extent *extent);

/* In a long scene: the same of another mover's, in the frame of that; of the scene's boxes and polygons. A plane of the
 * scene in the shaft's frame; and the shaft's end there, if it is an axis plane. */
bool lim_shaft_meets_far_extent(const struct lim_shaft *shaft, const struct lim_extent *extent, int8_t exponent);
bool lim_shaft_meets_long_box(const struct lim_shaft *shaft, const struct lim_scene *scene, lim_index number);
bool lim_shaft_meets_long_polygon(const struct lim_shaft *shaft, const struct lim_scene *scene,
                                  const LIM_FLASH lim_index *record);
void lim_shaft_unpack_far(struct lim_plane_unpacked *plane, const struct lim_shaft *shaft,
                          const LIM_FLASH struct lim_plane_ref *ref);
void lim_shaft_end_far(struct lim_shaft *shaft, const struct lim_plane_unpacked *plane, bool in_front);

/* Whether a polygon in the plane of the node that the route is to enter, or beyond it, may hide something of `of`; or
 * of a shadow, whether one in the plane, or on the eye's side of it, may be hidden. */
bool lim_shaft_meets_scene(const struct lim_shaft *shaft, const struct lim_route *route, int32_t eye_side,
                           const struct lim_reach *of);

#endif
