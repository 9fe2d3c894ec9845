/* SPDX-License-Identifier: MIT
 *
 * POSE places each instance, once a frame: the view and the eye in the object's own coordinates, so that it is drawn by
 * the same stages as any scene; and its points and planes in the static scene. In: instances, the camera. Memory: the
 * caller's, struct lim_movers_limits. */
#ifndef LIM_MOVER_H
#define LIM_MOVER_H

#include "instance.h"
#include "light.h"
#include "view/pass.h"
#include "view/plane_unpacked.h"

/* An instance as this frame has it. */
struct lim_mover {
    struct lim_view view;  /* in the object's coordinates; the cache is shared */
    struct lim_eye eye;    /* likewise */
    int32_t centre_q12[3]; /* of the object's box, units of the static scene, |centre| + radius < 2^28 */
    int32_t radius_q12;    /* negative: it is left out */
    LIM_OPTIONAL(int16_t, to_q14, 3 * LIM_HAS_LIGHT); /* towards the light, in its own axes */
};

/* What is due when a node's near subtree is done: route.h. */
struct lim_route_pending {
    lim_index node;
    uint16_t list; /* for its far subtree, or LIM_NONE */
    int8_t side;   /* of the eye */
};

struct lim_movers {
    const struct lim_instance *instances; /* the caller's */
    uint16_t given, count;                /* of this frame, and how many of them there is room for */
    uint16_t most;                        /* instances that there is room for */
    uint16_t most_corners;                /* of a polygon */
    struct lim_mover *movers;
    struct lim_view_cached *cache;
    uint16_t cached; /* whose vertices the cache holds */
    struct lim_route_pending *stack, *object_stack;
    uint16_t object_depth;
    int32_t ahead_q28[3]; /* the camera's */
    int32_t eye_q8[3];
    struct lim_view world; /* of the static scene at half its scale, so that it reaches to 2^16 units */
    LIM_OPTIONAL(struct lim_light, light, LIM_HAS_LIGHT);
    LIM_OPTIONAL(struct lim_cull, cull, LIM_HAS_CULL); /* of the object that is being drawn whole */
};

/* POSE. The camera is taken in. */
void lim_movers_pose(struct lim_movers *movers, struct lim_pass *pass, const struct lim_camera *camera);

/* In all views of the frame. */
void lim_movers_set_antialiased(struct lim_movers *movers, bool antialiased);

/* An object's vertex in the static scene. */
void lim_mover_place(const struct lim_movers *movers, uint16_t mover, lim_index vertex, int32_t at_q12[3]);

/* The mover's view, with the cache empty or its own. */
struct lim_view *lim_mover_view(struct lim_movers *movers, uint16_t mover);

/* How far ahead of the eye a point is, in 1/512 units. */
int32_t lim_mover_depth(const struct lim_movers *movers, const int32_t at_q12[3]);

/* A plane of an object, as it lies in the static scene. */
void lim_mover_turn(const struct lim_movers *movers, uint16_t mover, struct lim_plane_unpacked *plane);

#endif
