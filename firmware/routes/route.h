/* SPDX-License-Identifier: MIT
 *
 * ROUTE carries movers down the static tree: a list of whole instances and of pieces goes with each subtree, and is
 * divided by its planes. Where the list comes to empty space it is put in order (mover_order.h). */
#ifndef LIM_ROUTE_H
#define LIM_ROUTE_H

#include "movers/mover.h"
#include "pieces/sorted.h"

struct lim_route {
    struct lim_sorter *sorter; /* of the lists */
    const struct lim_scene *scene;
    const struct lim_eye *eye;
    struct lim_cull *cull; /* the open view in the scene's coordinates */
    const uint8_t *shown;  /* NULL: all (portals.h) */
    struct lim_route_pending *stack;
    uint16_t depth;
    lim_index next; /* the subtree to enter, or LIM_NO_INDEX */
    uint16_t list;  /* what moves in it */
    lim_index node; /* whose run was handed out last */
    int8_t side;    /* of the eye there */
    bool back_to_front;
};

enum lim_route_event { LIM_ROUTE_END, LIM_ROUTE_RUN, LIM_ROUTE_LIST };

/* The route through the static scene, and through an object in the view of `open`. */
struct lim_route lim_route_static(struct lim_sorter *sorter, bool back_to_front);
struct lim_route lim_route_object(struct lim_sorter *sorter, uint16_t mover, const struct lim_rect *open,
                                  bool back_to_front);

/* Begins at the root with a list. */
void lim_route_begin(struct lim_route *route, uint16_t list);

/* What comes next: a run (its offset in *what), or a list. */
enum lim_route_event lim_route_next(struct lim_route *route, lim_index *what);

/* The next run of a route that began without a list; false: there is none. */
bool lim_route_next_alone(struct lim_route *route, lim_index *run);

#endif
