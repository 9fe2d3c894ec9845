/* SPDX-License-Identifier: MIT
 *
 * What moves, on one line. Polygons come in an order that is right but for some pairs: two movers that meet, a mover
 * and what it reaches through. Each of these is compared with those that are listed as farther, at the ends of what
 * their runs share, as near / z is linear in both: one is nearer all along, or they cross at one column. Where the
 * other one is nearer it has a cut. A run without its cuts is painted in its turn, by any order of painting: the
 * nearest polygon of a pixel has no cut there, and what is listed as nearer has one. In: the polygons that cross the
 * line. Out: lim_near.cuts. Memory: what is idle in pass two. */
#ifndef LIM_CROWD_H
#define LIM_CROWD_H

#include "stages.h"

/* Pixels x0 <= x < x1 of a run, where another polygon is nearer that is listed as farther. */
struct lim_crowd_cut {
    struct lim_crowd_cut *next; /* by one that is listed as nearer than `by`, or NULL */
    const struct lim_active *by;
    int16_t x0, x1;
};

/* Whether a line has cuts; a constant where nothing moves. */
static inline bool lim_crowd_cuts(const struct lim_actives *actives)
{
    return LIM_HAS_MOVERS && *actives->cut_count;
}

/* What is left of the pixels *x <= .. < end without the cuts up to `last`, piece by piece: the next one begins at *x,
 * and ends at *to. false: there is none. */
bool lim_crowd_next(const struct lim_crowd_cut *cuts, const struct lim_crowd_cut *last, int32_t *x, int32_t end,
                    int32_t *to);

/* What a line is painted by: polygons from far to near, gaps, or strips of samples. */
enum lim_crowd_line { LIM_CROWD_OVER, LIM_CROWD_GAPS, LIM_CROWD_SAMPLES };

/* Makes the cuts of line y, within pixels of a gap; edges are on it. false: there is no room, for these or for the gaps
 * that polygons leave, as pass one has not counted them. */
bool lim_crowd_cut_line(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                        const struct lim_gap *within, uint16_t y, enum lim_crowd_line by);

static inline bool lim_crowd_line(struct lim_paint *paint, const struct lim_spans *spans,
                                  const struct lim_retained *retained, const struct lim_gap *within, uint16_t y,
                                  enum lim_crowd_line by)
{
    struct lim_actives *const actives = &paint->actives;

    if (!LIM_HAS_MOVERS || (!*actives->moving && by == LIM_CROWD_OVER)) {
        if (LIM_HAS_MOVERS) *actives->cut_count = 0;
        return true;
    }
    return lim_crowd_cut_line(paint, spans, retained, within, y, by);
}

/* Paints a line with cuts from near to far: pixels x0 <= x < x1 of each polygon, as they come. What a cut has left out
 * comes again behind the polygon that it was for: that may be transparent, or have some of a pixel's samples. */
typedef void lim_crowd_part(void *ctx, struct lim_active *active, int32_t x0, int32_t x1);
void lim_crowd_paint(const struct lim_actives *actives, const struct lim_gap *within, lim_crowd_part *part, void *ctx);

#endif
