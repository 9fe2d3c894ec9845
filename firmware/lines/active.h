/* SPDX-License-Identifier: MIT
 *
 * The retained polygons that cross the current line, on their way down: what both ways of painting (paint.c, flat.c)
 * have in common. Memory: what nobody else needs in pass two, and a pool that is lent by the caller. */
#ifndef LIM_ACTIVE_H
#define LIM_ACTIVE_H

#include "lines/retain.h"
#include "screen/edge.h"

static inline const struct lim_point *lim_active_points(const union lim_retained_cell *cells)
{
    return &cells[LIM_RETAINED_HEAD_CELLS].at;
}

/* Before the band's first line: pass one is done. by_gaps: lines are painted by these. */
void lim_actives_start(struct lim_actives *actives, struct lim_spans *spans, bool by_gaps);

/* One that was not used in this band, on line y. NULL: there is no room. */
struct lim_active *lim_active_fresh(struct lim_actives *actives, const struct lim_spans *spans, uint16_t y);

/* A polygon of a mover, which may have cuts. */
static inline bool lim_active_moves(const struct lim_active *active)
{
    return LIM_HAS_MOVERS && active->near->owner < LIM_STILL_MET;
}

/* Whether it has cuts on a line with such. */
static inline bool lim_active_is_cut(const struct lim_active *active)
{
    return lim_active_moves(active) && active->near->cuts;
}

/* Memory from here on is idle, up to the lines that are still to come. */
static inline uint8_t *lim_actives_idle(const struct lim_actives *actives)
{
    return actives->in_pool ? actives->at : actives->pool;
}

/* The same in bytes, as the processor has them that is counted for. */
uint32_t lim_actives_counted_idle_b(const struct lim_actives *actives, const struct lim_spans *spans, uint16_t y);

/* What crowd.c compares, as the cells before it tell. */
void lim_active_enter_crowd(struct lim_actives *actives, struct lim_active *active,
                            const union lim_retained_cell *cells);
void lim_active_leave_crowd(struct lim_actives *actives, const struct lim_active *active);

static inline void lim_active_join_crowd(struct lim_actives *actives, struct lim_active *active,
                                         const union lim_retained_cell *cells)
{
    if (LIM_HAS_MOVERS && cells[1].look.bottom & LIM_RETAINED_MET) lim_active_enter_crowd(actives, active, cells);
}

/* On line y. NULL: there is no room. */
static inline struct lim_active *lim_active_new(struct lim_actives *actives, const struct lim_spans *spans, uint16_t y)
{
    struct lim_active *active = actives->free;

    if (active)
        actives->free = active->next;
    else
        active = lim_active_fresh(actives, spans, y);
    if ((LIM_HAS_STATS || LIM_HAS_MOVERS) && active) actives->used++;
    if (LIM_HAS_MOVERS && active) active->near->owner = LIM_NONE;
    return active;
}

/* What crosses line y. */
static inline void lim_actives_count(const struct lim_actives *actives, const struct lim_spans *spans,
                                     struct lim_stats *stats, uint16_t y)
{
    if (!LIM_HAS_STATS) return;
    const uint32_t idle_b = spans->counted->idle_b + y * (uint32_t)sizeof(struct lim_line);
    const uint32_t cuts_b = LIM_HAS_MOVERS ? *actives->cut_count * (uint32_t)LIM_CROWD_CUT_B : 0u;
    const uint32_t used_b = actives->used * spans->counted->active_b + cuts_b;

    if (actives->used > stats->active_max) stats->active_max = actives->used;
    if (used_b > idle_b && used_b - idle_b > stats->active_max_b) stats->active_max_b = used_b - idle_b;
}

/* Unlinks the one that `link` leads to; what follows it takes its place there. */
static inline void lim_active_give_back(struct lim_actives *actives, struct lim_active **link)
{
    struct lim_active *active = *link;

    *link = active->next;
    active->next = actives->free;
    actives->free = active;
    if (LIM_HAS_STATS || LIM_HAS_MOVERS) actives->used--;
    if (LIM_HAS_MOVERS && active->near->owner != LIM_NONE) lim_active_leave_crowd(actives, active);
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
    if (LIM_HAS_NEWELL && !cells[0].link.n) {
        lim_active_set_line(active, cells, y);
        return;
    }
    const uint16_t at = (uint16_t)lim_edge_turn(&active->pair, lim_active_points(cells), cells[0].link.n, y);
    active->turn = at < active->bottom ? at : active->bottom;
}

/* Before its first line; not antialiased. */
static inline void lim_active_begin(struct lim_actives *actives, struct lim_active *active,
                                    const struct lim_retained *retained, uint16_t polygon, int16_t y)
{
    const union lim_retained_cell *cells = &retained->cells[polygon];

    active->polygon = polygon;
    active->bottom = lim_retained_bottom(cells);
    active->colour = cells[1].look.colour;
    lim_active_join_crowd(actives, active, cells);
    if (LIM_HAS_NEWELL && !cells[0].link.n) {
        lim_active_set_line(active, cells, y);
        return;
    }
    const uint16_t at =
        (uint16_t)lim_edge_start(&active->pair, lim_active_points(cells), cells[0].link.n, cells[0].link.first, y);
    active->turn = at < active->bottom ? at : active->bottom;
}

#endif
