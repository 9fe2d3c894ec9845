/* SPDX-License-Identifier: MIT
 *
 * The retained polygons that cross the current line, on their way down: what both ways of painting (paint.c, flat.c)
 * have in common. Memory: a pool, lent by the caller. */
#ifndef LIM_ACTIVE_H
#define LIM_ACTIVE_H

#include "lines/retain.h"
#include "screen/edge.h"

static inline const struct lim_point *lim_active_points(const union lim_retained_cell *cells)
{
    return &cells[LIM_RETAINED_HEAD_CELLS].at;
}

static inline void lim_actives_start(struct lim_actives *actives)
{
    actives->first = actives->free = NULL;
    actives->fresh = actives->used = 0;
    actives->spares = false;
}

/* Once the pool is used up, what is left of the cells serves, too: in pass two nothing is retained. NULL: nothing is.
 */
struct lim_active *lim_active_spare(struct lim_actives *actives, const struct lim_retained *retained);

/* NULL: there is no room. */
static inline struct lim_active *lim_active_new(struct lim_actives *actives, const struct lim_retained *retained)
{
    struct lim_active *active = actives->free;

    if (active)
        actives->free = active->next;
    else if (actives->fresh < actives->pool_size)
        active = &actives->pool[actives->fresh++];
    else
        active = lim_active_spare(actives, retained);
    if (LIM_HAS_STATS && active) actives->used++;
    return active;
}

/* Unlinks the one that `link` leads to; what follows it takes its place there. */
static inline void lim_active_give_back(struct lim_actives *actives, struct lim_active **link)
{
    struct lim_active *active = *link;

    *link = active->next;
    active->next = actives->free;
    actives->free = active;
    if (LIM_HAS_STATS) actives->used--;
}

/* A piece has no edges: its lines are there, the last one first. */
static LIM_RARE void lim_active_set_line(struct lim_active *active, const union lim_retained_cell *cells, int16_t y)
{
    const struct lim_point line = lim_active_points(cells)[(int16_t)active->bottom - 1 - y];

    lim_edge_put(&active->pair.left, (int16_t)line.x);
    lim_edge_put(&active->pair.right, (int16_t)line.y);
    active->turn = (uint16_t)(y + 1);
}

/* Replaces the edges that end on line y or above. */
static inline void lim_active_turn(struct lim_active *active, const union lim_retained_cell *cells, int16_t y)
{
    if (LIM_HAS_PIECES && !cells[0].link.n) {
        lim_active_set_line(active, cells, y);
        return;
    }
    const uint16_t at = (uint16_t)lim_edge_turn(&active->pair, lim_active_points(cells), cells[0].link.n, y);
    active->turn = at < active->bottom ? at : active->bottom;
}

/* Before its first line; not antialiased. */
static inline void lim_active_begin(struct lim_active *active, const struct lim_retained *retained, uint16_t polygon,
                                    int16_t y)
{
    const union lim_retained_cell *cells = &retained->cells[polygon];

    active->polygon = polygon;
    active->bottom = lim_retained_bottom(cells);
    active->colour = cells[1].look.colour;
    if (LIM_HAS_PIECES && !cells[0].link.n) {
        lim_active_set_line(active, cells, y);
        return;
    }
    const uint16_t at =
        (uint16_t)lim_edge_start(&active->pair, lim_active_points(cells), cells[0].link.n, cells[0].link.first, y);
    active->turn = at < active->bottom ? at : active->bottom;
}

#endif
