/* SPDX-License-Identifier: MIT
 *
 * Movers on their way through a frame. POSE places each instance: the view and the eye in the object's own coordinates,
 * so that it is drawn by the same stages as any scene. ROUTE carries them down the static tree: a list of whole
 * instances and of pieces goes with each subtree, and is divided by its planes. Where the list comes to empty space
 * it is put in order and drawn. Memory: the caller's, struct lim_movers_limits. */
#ifndef LIM_MOVERS_H
#define LIM_MOVERS_H

#include "instance.h"
#include "light.h"
#include "pieces/sorted.h"
#include "screen/project.h"
#include "view/eye.h"

/* An instance as this frame has it. */
struct lim_plane_unpacked;

struct lim_mover {
    struct lim_view view;  /* in the object's coordinates; the cache is shared */
    struct lim_eye eye;    /* likewise */
    int32_t centre_q12[3]; /* of the object's box, units of the static scene, |centre| + radius < 2^28 */
    int32_t radius_q12;    /* negative: it is left out */
#if LIM_HAS_LIGHT
    int16_t to_q14[3]; /* towards the light, in its own axes */
#endif
};

/* What is due when a node's near subtree is done. */
struct lim_route_pending {
    lim_index node;
    uint16_t list; /* for its far subtree, or LIM_NONE */
    int8_t side;   /* of the eye */
};

struct lim_route {
    const struct lim_scene *scene;
    const struct lim_eye *eye;
    struct lim_cull *cull; /* the open view in the scene's coordinates */
#if LIM_HAS_PORTALS
    const uint8_t *shown; /* NULL: all (portals.h) */
#endif
    struct lim_route_pending *stack;
    uint16_t depth;
    lim_index next; /* the subtree to enter, or LIM_NO_INDEX */
    uint16_t list;  /* what moves in it */
    lim_index node; /* whose run was handed out last */
    int8_t side;    /* of the eye there */
    bool back_to_front;
};

enum lim_route_event { LIM_ROUTE_END, LIM_ROUTE_RUN, LIM_ROUTE_LIST };

struct lim_movers {
    const struct lim_instance *instances; /* the caller's */
    uint16_t given, count;                /* of this frame, and how many of them there is room for */
    uint16_t most;                        /* instances that there is room for */
    struct lim_mover *movers;
    struct lim_view_cached *cache;
    uint16_t cached; /* whose vertices the cache holds */
    struct lim_route_pending *stack, *object_stack;
    uint16_t object_depth;
    bool measuring;       /* pieces are split to put them in order: what is known of them has to be kept up */
    int32_t ahead_q28[3]; /* the camera's */
    int32_t eye_q8[3];
    struct lim_view world; /* of the static scene at half its scale, so that it reaches to 2^16 units */
#if LIM_HAS_LIGHT
    struct lim_light light;
#endif
#if LIM_HAS_CULL
    struct lim_cull cull; /* of the object that is being drawn whole */
#endif
};

/* POSE, once a frame; the camera is taken in. */
void lim_movers_pose(struct lim *lim, const struct lim_camera *camera);

/* An object's vertex in the static scene. */
void lim_mover_place(const struct lim *lim, uint16_t mover, lim_index vertex, int32_t at_q12[3]);

/* The mover's view, with the cache empty or its own. */
struct lim_view *lim_mover_view(struct lim *lim, uint16_t mover);

/* How far ahead of the eye a point is, in 1/512 units. */
int32_t lim_mover_depth(const struct lim *lim, const int32_t at_q12[3]);

/* A plane of an object, as it lies in the static scene. */
void lim_mover_turn(const struct lim *lim, uint16_t mover, struct lim_plane_unpacked *plane);

/* Whether pieces are being compared: then what is known of them is kept up. */
bool lim_movers_compares(const struct lim *lim);

/* The list of all movers that `open` may show, from scratch: pieces of an earlier walk are gone. */
uint16_t lim_movers_list(struct lim *lim, const struct lim_cull *open);

/* Whether an entry is a whole instance. */
bool lim_mover_is_whole(const struct lim *lim, uint16_t entry);

/* The polygons of a whole instance that face the eye, nearest first, as a list that ends in `rest`. LIM_NONE: there is
 * no room for them. */
bool lim_mover_burst(struct lim *lim, uint16_t entry, uint16_t *list);

/* Counts the entries in use, or the cuts, whichever are more: there is room for as many. */
void lim_movers_note_entries(struct lim *lim);

/* Adds the polygons of a leaf that face the eye to the list that has come there. false: there is no room, or one of it
 * is to go by its centre; nothing has changed. */
bool lim_movers_join(struct lim *lim, lim_index run, uint16_t list);

/* Divides a list by the plane of a node of the static scene; what lies in it goes to the eye's side. */
void lim_movers_divide(struct lim *lim, lim_index node, int32_t eye_side, uint16_t list, uint16_t *front,
                       uint16_t *back);

/* Puts a list that has come to empty space in order, nearest first or the other way round. Returns its head. */
uint16_t lim_movers_order(struct lim *lim, uint16_t list, bool back_to_front);

/* Begins at the root with a list. */
void lim_route_begin(struct lim_route *route, uint16_t list);

/* What comes next: a run (its offset in *what), or a list. */
enum lim_route_event lim_route_next(struct lim *lim, struct lim_route *route, lim_index *what);

/* The next run of a route that began without a list; false: there is none. */
bool lim_route_next_alone(struct lim *lim, struct lim_route *route, lim_index *run);

/* The route through the static scene, and through an object in the view of `open`. */
struct lim_route lim_route_static(struct lim *lim, bool back_to_front);
struct lim_route lim_route_object(struct lim *lim, uint16_t mover, const struct lim_rect *open, bool back_to_front);

/* Draws the polygons of an ordered list's entries one by one; `entry` is LIM_NONE for one that was never cut. Ends with
 * what `draw` returns, if that is not 0. */
typedef int lim_mover_draw(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *polygon,
                           const struct lim_rect *open);
int lim_movers_draw(struct lim *lim, uint16_t list, const struct lim_rect *open, bool back_to_front,
                    lim_mover_draw *draw);

#endif
