/* SPDX-License-Identifier: MIT
 *
 * A polygon's depth is made a plane where it is first compared (near_plane.h). Polygons of one object are not compared:
 * they come in the order of its own tree. What stands still is compared with what moves alone, as pass one has found it
 * to lie before an object, or through it (meet.h). */
#include "lines/crowd.h"

#include "lines/active.h"
#include "lines/retain.h"
#include "lines/share.h"
#include "lines/smooth.h"
#include "movers/meet.h"
#include "movers/near_plane.h"
#include "view/pass.h"

#if LIM_HAS_SPANS && LIM_HAS_MOVERS

enum { MOST_BEFORE = 3 }; /* paint_released() */

struct crowd {
    struct lim_pass *pass;
    struct lim_movers *movers;
    const struct lim_retained *retained;
    struct lim_crowd_cut *at, *end; /* memory that is free */
    int32_t w_px, y;                /* of the screen, whatever of the line is painted: so cuts do not depend on that */
    enum lim_crowd_line by;
    lim_near_difference most_tie;
};

static const union lim_retained_cell *crowd_cells(const struct crowd *crowd, const struct lim_active *active)
{
    return &crowd->retained->cells[active->polygon];
}

/* Of a line; the plane is known. */
static inline void set_near_row(const struct crowd *crowd, struct lim_near *near)
{
    near->row_q30 = lim_near_row_of(&near->plane, crowd->y).at_q30;
}

static LIM_RARE void make_plane(const struct crowd *crowd, struct lim_active *active)
{
    const struct lim_met_polygon polygon = lim_met_told(crowd_cells(crowd, active));

    lim_near_plane_set(&active->near->plane, crowd->movers, crowd->pass, &polygon);
    active->near->known = true;
    set_near_row(crowd, active->near);
}

/* false: there is no room. */
static bool add_cut(struct crowd *crowd, struct lim_active *active, const struct lim_active *by,
                    struct lim_near_share share)
{
    if (share.x0 >= share.x1) return true;
    if (crowd->at == crowd->end) return false;
    struct lim_crowd_cut *const cut = crowd->at++, **link = &active->near->cuts;
    while (*link && (*link)->by->polygon > by->polygon)
        link = &(*link)->next;
    cut->next = *link;
    cut->by = by;
    cut->x0 = (int16_t)share.x0;
    cut->x1 = (int16_t)share.x1;
    *link = cut;
    return true;
}

/* What something still is to a mover's polygon: asked once, not on each line. */
static enum lim_met met_of_polygon(const struct crowd *crowd, struct lim_active *active, const struct lim_active *still)
{
    struct lim_near *const near = active->near;
    const union lim_retained_cell *const cells = crowd_cells(crowd, still);
    const enum lim_met met = lim_met_of(cells, near->owner);

    if (met != LIM_MET_THROUGH) return met;
    for (uint_fast8_t i = 0; i < 2; i++)
        if (near->still[i] == still->polygon) return (enum lim_met)near->met[i];
    near->still[1] = near->still[0];
    near->met[1] = near->met[0];
    near->still[0] = still->polygon;
    const struct lim_met_polygon polygon = lim_met_told(crowd_cells(crowd, active)), other = lim_met_told(cells);
    near->met[0] = (uint8_t)lim_met_polygons(crowd->pass, crowd->movers, &polygon, &other);
    return (enum lim_met)near->met[0];
}

/* Two that share pixels. What differs by more than the largest tie is not looked at twice. */
static inline bool compare_runs(struct crowd *crowd, struct lim_active *active, struct lim_active *by,
                                struct lim_near_share both)
{
    struct lim_near *const a = active->near, *const b = by->near;

    if (b->owner == LIM_STILL_MET) {
        const enum lim_met met = met_of_polygon(crowd, active, by);
        if (met == LIM_MET_BEHIND) return true;
        if (met != LIM_MET_THROUGH) return add_cut(crowd, active, by, both);
    }
    if (!a->known) make_plane(crowd, active);
    if (!b->known) make_plane(crowd, by);
    const lim_near_word step = a->plane.x_q30 - b->plane.x_q30;
    const lim_near_word from = a->row_q30 - b->row_q30 + step * (uint32_t)both.x0;
    const lim_near_difference d0 = (lim_near_difference)from;
    const lim_near_difference d1 = (lim_near_difference)(from + step * (uint32_t)(both.x1 - 1 - both.x0));
    if (LIM_HAS_STATS) lim_stats_of(crowd->pass)->movers.comparisons++;
    if (d0 > crowd->most_tie && d1 > crowd->most_tie) return true;
    if (d0 < -crowd->most_tie && d1 < -crowd->most_tie) return add_cut(crowd, active, by, both);
    const struct lim_near_row of_a = {a->row_q30, a->plane.x_q30}, of_b = {b->row_q30, b->plane.x_q30};
    return add_cut(crowd, active, by, lim_near_share(&of_a, &of_b, b->owner < a->owner, both));
}

/* The pixels of which an antialiased polygon may have samples. */
static LIM_IF_CALLED void set_sample_run(const struct crowd *crowd, const struct lim_active *active, int32_t *x0,
                                         int32_t *x1)
{
    struct lim_sample_edges edges = *active->samples;
    const struct lim_strip strip = lim_smooth_strip(&edges, active, crowd_cells(crowd, active), crowd->y);

    *x0 = lim_strip_first_px(&strip);
    *x1 = lim_strip_end_px(&strip);
}

/* What a polygon has of the line. */
static void set_run(const struct crowd *crowd, struct lim_active *active)
{
    int32_t x0, x1;

    if (LIM_HAS_ANTIALIAS && crowd->by == LIM_CROWD_SAMPLES) {
        set_sample_run(crowd, active, &x0, &x1);
    } else {
        x0 = lim_edge_x(&active->pair.left);
        x1 = lim_edge_x(&active->pair.right);
    }
    active->near->x0 = (int16_t)(x0 > 0 ? x0 : 0);
    active->near->x1 = (int16_t)(x1 < crowd->w_px ? x1 : crowd->w_px);
    if (active->near->known) set_near_row(crowd, active->near);
}

/* Runs of a group, and what they have lies between. */
static void set_runs(const struct crowd *crowd, struct lim_active *group)
{
    const struct lim_active *const end = group->near->owner == LIM_STILL_MET ? group->near->next : group->near->group;
    struct lim_active *active = group;
    int16_t x0 = INT16_MAX, x1 = INT16_MIN;

    do {
        set_run(crowd, active);
        if (active->near->x0 < x0) x0 = active->near->x0;
        if (active->near->x1 > x1) x1 = active->near->x1;
        active = active->near->next;
    } while (active != end);
    group->near->group_x0 = x0;
    group->near->group_x1 = x1;
    group->near->y = (int16_t)crowd->y;
}

/* Once a line. */
static inline void need_runs(const struct crowd *crowd, struct lim_active *group)
{
    if (group->near->y != crowd->y) set_runs(crowd, group);
}

/* Whether something that stands still may hide any of an object. */
static inline bool may_hide(const struct crowd *crowd, const struct lim_active *still, uint16_t mover)
{
    const enum lim_met met = lim_met_of(crowd_cells(crowd, still), mover);

    return met == LIM_MET_BEFORE || met == LIM_MET_THROUGH;
}

static inline bool groups_meet(const struct lim_near *a, const struct lim_near *b)
{
    return a->group_x0 < b->group_x1 && b->group_x0 < a->group_x1;
}

/* Polygons of a group, and those from `by` to before `end` that are listed as farther. false: there is no room. */
static LIM_INLINE bool cut_by_farther(struct crowd *crowd, struct lim_active *group, struct lim_active *by,
                                      const struct lim_active *end)
{
    const struct lim_active *const last = group->near->group;

    do {
        const int32_t x0 = by->near->x0, x1 = by->near->x1;
        for (struct lim_active *active = group; active != last; active = active->near->next) {
            const struct lim_near_share both = {x0 > active->near->x0 ? x0 : active->near->x0,
                                                x1 < active->near->x1 ? x1 : active->near->x1};
            if (both.x0 < both.x1 && !compare_runs(crowd, active, by, both)) return false;
        }
        by = by->near->next;
    } while (by != end);
    return true;
}

/* By what stands still. */
static bool cut_by_stills(struct crowd *crowd, struct lim_active *group, struct lim_active *still)
{
    for (; still; still = still->near->next) {
        if (still->polygon < group->polygon || !may_hide(crowd, still, group->near->owner)) continue;
        need_runs(crowd, group);
        need_runs(crowd, still);
        if (groups_meet(group->near, still->near) && !cut_by_farther(crowd, group, still, still->near->next))
            return false;
    }
    return true;
}

/* By objects. */
static bool cut_by_groups(struct crowd *crowd, struct lim_active *group)
{
    for (struct lim_active *other = group->near->group; other; other = other->near->group) {
        if (!lim_movers_compare(crowd->movers, group->near->owner, other->near->owner)) continue;
        need_runs(crowd, group);
        need_runs(crowd, other);
        if (groups_meet(group->near, other->near) && !cut_by_farther(crowd, group, other, other->near->group))
            return false;
    }
    return true;
}

/* Idle memory, as for layers: what active polygons leave, and all that rests in pass two. */
static void crowd_lend(struct crowd *crowd, const struct lim_actives *actives, const struct lim_spans *spans)
{
    uintptr_t at = (uintptr_t)lim_actives_idle(actives);

    at = (at + LIM_ALIGNOF(struct lim_crowd_cut) - 1) & ~(uintptr_t)(LIM_ALIGNOF(struct lim_crowd_cut) - 1);
    crowd->at = crowd->end = (struct lim_crowd_cut *)at;
    const uintptr_t end = (uintptr_t)&spans->lines[crowd->y];
    uint32_t count = end > at ? (uint32_t)((end - at) / sizeof(struct lim_crowd_cut)) : 0;
    if (LIM_HAS_STATS && spans->counted->is_apart) {
        const uint32_t counted = lim_actives_counted_idle_b(actives, spans, (uint16_t)crowd->y) / LIM_CROWD_CUT_B;
        if (counted < count) count = counted;
    }
    crowd->end += count;
}

/* Groups of what is not compared with each other, as it has an order, when they have changed: an object's polygons. */
static LIM_RARE void set_groups(const struct crowd *crowd, struct lim_active *group)
{
    while (group) {
        const uint16_t owner = group->near->owner;
        struct lim_active *active = group;
        do {
            active->near->cuts = NULL;
            active = active->near->next;
        } while (active && active->near->owner == owner && !lim_mover_is_loose(crowd->movers, owner));
        group->near->group = active;
        group->near->y = -1;
        group = active;
    }
}

static void forget_cuts(struct lim_active *active)
{
    for (; active; active = active->near->next)
        active->near->cuts = NULL;
}

static bool cut_line(struct crowd *crowd, struct lim_actives *actives, bool was_cut)
{
    const struct lim_crowd_cut *const first = crowd->at;

    if (!*actives->grouped)
        set_groups(crowd, *actives->moving);
    else if (was_cut)
        forget_cuts(*actives->moving);
    *actives->grouped = true;
    for (struct lim_active *group = *actives->moving; group; group = group->near->group)
        if ((group->near->group && !cut_by_groups(crowd, group)) || !cut_by_stills(crowd, group, *actives->met))
            return false;
    if (crowd->at == first) return true;
    *actives->cut_count = (uint16_t)(crowd->at - first);
    *actives->cuts_end = (uint8_t *)crowd->at;
    *actives->crowded = true;
    if (LIM_HAS_STATS) lim_stats_of(crowd->pass)->movers.cuts += *actives->cut_count;
    return true;
}

/* Each polygon and each cut divides a gap at most; of pixels every other one can be a gap. */
static bool has_gaps(const struct lim_actives *actives, const struct lim_spans *spans, const struct lim_gap *within,
                     struct lim_stats *stats, enum lim_crowd_line by)
{
    const uint_fast16_t gaps = (uint_fast16_t)(lim_share_gaps_end(spans) - spans->lowest);
    const uint_fast16_t most = (uint_fast16_t)((within->x1 - within->x0) / 2);
    uint_fast16_t needed = (uint_fast16_t)(actives->used + *actives->cut_count + 1);

    if (by == LIM_CROWD_OVER) return true;
    if (by == LIM_CROWD_GAPS && needed > most) needed = most;
    if (LIM_HAS_STATS && needed > stats->gaps_max) stats->gaps_max = (uint16_t)needed;
    return needed <= gaps;
}

bool lim_crowd_cut_line(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                        const struct lim_gap *within, uint16_t y, enum lim_crowd_line by)
{
    struct lim_actives *const actives = &paint->actives;
    struct crowd crowd; /* each field for itself: an initialiser would be a call of memset() */
    const bool was_cut = *actives->cut_count;

    *actives->cut_count = 0;
    if (*actives->moving) {
        crowd.pass = paint->pass;
        crowd.movers = *actives->movers;
        crowd.retained = retained;
        crowd.w_px = paint->pass->target.w_px;
        crowd.y = y;
        crowd.by = by;
        crowd.most_tie = LIM_NEAR_TIE_MOST;
        if (LIM_HAS_LONG && *crowd.movers->far) crowd.most_tie <<= LIM_NEAR_FAR_BITS;
        crowd_lend(&crowd, actives, spans);
        if (!cut_line(&crowd, actives, was_cut)) return false;
    }
    return !lim_moves(*actives->movers) || has_gaps(actives, spans, within, lim_stats_of(paint->pass), by);
}

/* Shortens [x, *to) to what is wholly inside of a cut or outside. true: inside. */
static bool is_inside_cut(const struct lim_crowd_cut *cut, int32_t x, int32_t *to)
{
    const bool inside = cut->x0 <= x && x < cut->x1;

    if (inside && cut->x1 < *to) *to = cut->x1;
    if (!inside && cut->x0 > x && cut->x0 < *to) *to = cut->x0;
    return inside;
}

static const struct lim_crowd_cut *cut_of(const struct lim_active *active, const struct lim_active *by)
{
    const struct lim_crowd_cut *cut = active->near->cuts;

    while (cut && cut->by != by)
        cut = cut->next;
    return cut;
}

/* How many of those that wait as `cut` does are nearer at x, and are listed as farther; up to *to it is the same. */
static uint_fast8_t count_before(const struct lim_crowd_cut *cut, int32_t x, int32_t *to)
{
    uint_fast8_t count = 0;

    for (const struct lim_crowd_cut *nearer = cut->next; nearer; nearer = nearer->next) {
        const struct lim_crowd_cut *const waits = lim_active_moves(nearer->by) ? cut_of(nearer->by, cut->by) : NULL;
        count = (uint_fast8_t)(count + (is_inside_cut(nearer, x, to) && waits && is_inside_cut(waits, x, to)));
    }
    return count;
}

/* What waited for a polygon, and waits for none that is painted after it: of these, too, the nearer comes first. Up to
 * MOST_BEFORE at a pixel are told apart. */
static bool paint_released(const struct lim_actives *actives, const struct lim_active *by, uint_fast8_t before,
                           lim_crowd_part *part, void *ctx)
{
    bool others_wait = false;

    for (struct lim_active *active = *actives->moving; active && active->polygon < by->polygon;
         active = active->near->next) {
        const struct lim_crowd_cut *const cut = cut_of(active, by);
        if (!cut) continue;
        for (int32_t x = cut->x0, to; lim_crowd_next(active->near->cuts, cut, &x, cut->x1, &to); x = to) {
            const uint_fast8_t count = count_before(cut, x, &to);
            if (count == before || (before == MOST_BEFORE && count > before)) part(ctx, active, x, to);
            others_wait = others_wait || count > before;
        }
    }
    return others_wait && before < MOST_BEFORE;
}

void lim_crowd_paint(const struct lim_actives *actives, const struct lim_gap *within, lim_crowd_part *part, void *ctx)
{
    for (struct lim_active *active = actives->first; active; active = active->next) {
        if (!lim_active_is_cut(active)) {
            part(ctx, active, within->x0, within->x1);
        } else {
            for (int32_t x = active->near->x0, to; lim_crowd_next(active->near->cuts, NULL, &x, active->near->x1, &to);
                 x = to)
                part(ctx, active, x, to);
        }
        for (uint_fast8_t before = 0; active->near->owner != LIM_NONE; before++)
            if (!paint_released(actives, active, before, part, ctx)) break;
    }
}

bool lim_crowd_next(const struct lim_crowd_cut *cuts, const struct lim_crowd_cut *last, int32_t *x, int32_t end,
                    int32_t *to)
{
    const struct lim_crowd_cut *cut = cuts;

    *to = end;
    while (cut != last && *x < end) {
        if (cut->x0 <= *x && cut->x1 > *x) {
            *x = cut->x1;
            *to = end;
            cut = cuts;
            continue;
        }
        if (cut->x0 > *x && cut->x0 < *to) *to = cut->x0;
        cut = cut->next;
    }
    return *x < end;
}

#endif
