/* SPDX-License-Identifier: MIT
 *
 * Where movers come in the walk's order. A mover is drawn where the walk comes to the first place that it reaches to:
 * all that came before is before it. What comes until the walk has left the last one is asked: its plane says whether
 * it is before all of the mover, behind it, or may lie through it. The mover is drawn before the first that is not
 * before it. What comes after is behind. So a mover in one place costs nothing but its polygons.
 *
 * What is not behind is retained with cells before it, which tell, of each mover, what was found; a mover's polygon has
 * such cells, too. */
#ifndef LIM_MEET_H
#define LIM_MEET_H

#include "movers/deform.h"
#include "orders.h"
#include "view/plane_unpacked.h"

/* What stands still is, to a mover. */
enum lim_met { LIM_MET_BEHIND, LIM_MET_BEFORE, LIM_MET_THROUGH, LIM_MET_APART };

/* Cells before a polygon, from its head down: owner, record, and of what stands still its node and two bits a mover. */
enum { LIM_TOLD_OWNER = 1, LIM_TOLD_RECORD, LIM_TOLD_NODE, LIM_TOLD_MOVERS };

static inline uint16_t lim_met_owner(const union lim_retained_cell *polygon)
{
    return polygon[-LIM_TOLD_OWNER].met.owner;
}

static inline struct lim_met_polygon lim_met_told(const union lim_retained_cell *polygon)
{
    struct lim_met_polygon met;

    met.owner = lim_met_owner(polygon);
    met.record = (lim_index)polygon[-LIM_TOLD_RECORD].word;
    met.node = met.owner < LIM_STILL_MET ? 0 : (lim_index)polygon[-LIM_TOLD_NODE].word;
    return met;
}

static inline enum lim_met lim_met_of(const union lim_retained_cell *still, uint16_t mover)
{
    return (enum lim_met)(still[-LIM_TOLD_MOVERS - (int_fast16_t)(mover / 16)].word >> 2 * (mover % 16) & 3);
}

/* Whether it meets what it is not drawn in the right order with. */
static inline bool lim_mover_is_crowded(const struct lim_movers *movers, uint16_t mover)
{
    return movers->movers[mover].crowded;
}

/* Whether its own polygons have no order. */
static inline bool lim_mover_is_loose(const struct lim_movers *movers, uint16_t mover)
{
    return lim_deforms(&movers->instances[mover]);
}

static inline uint32_t lim_mover_bit(uint16_t mover)
{
    return UINT32_C(1) << (mover & 31);
}

/* Whether polygons of two movers, or of one, have to be compared. */
static inline bool lim_movers_compare(const struct lim_movers *movers, uint16_t a, uint16_t b)
{
    return movers->movers[a].against & lim_mover_bit(b) && (a != b || lim_mover_is_loose(movers, a));
}

static inline bool lim_rects_meet(const struct lim_rect *a, const struct lim_rect *b)
{
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}

/* The walk through the static scene, nearest first, with all movers that `open` shows: what comes next is a run of the
 * static scene, or a mover that is to be drawn now. */
enum lim_meet_event { LIM_MEET_END, LIM_MEET_RUN, LIM_MEET_MOVER };
void lim_meet_begin(struct lim_route *route, struct lim_pass *pass, struct lim_movers *movers,
                    const struct lim_cull *open);
enum lim_meet_event lim_meet_next(struct lim_route *route, lim_index *what);

/* Whether any mover has to be asked about records of the run that came last. */
bool lim_meet_asks(const struct lim_route *route);

/* Of a record of that run: a mover that has to be drawn before it, after which this is to be asked again. LIM_NONE:
 * there is none; what the record is to each mover is noted, and whether it is anything but behind. of_corners: no plane
 * of it is stored, and it faces the eye. */
uint16_t lim_meet_before(struct lim_route *route, const LIM_FLASH lim_index *record, bool of_corners, bool *is_any);

/* What something still is to one polygon of a mover. What lies in its plane is before it: a door in its wall. */
enum lim_met lim_met_polygons(const struct lim_pass *pass, struct lim_movers *movers,
                              const struct lim_met_polygon *polygon, const struct lim_met_polygon *still);

#endif
