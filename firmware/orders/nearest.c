/* SPDX-License-Identifier: MIT
 *
 * Nearest first, pass one: walks the tree, or the sorted list, closes gaps, and retains the polygons that closed some;
 * by scan lines all that are in view. All at once, or, where a frame is begun while another is still on its way,
 * polygon by polygon (lim_frame_work()). bands.c drives it. */
#include "orders/nearest.h"

#include "eye.h"
#include "lines/framebuffer.h"
#include "lines/gaps.h"
#include "lines/layers.h"
#include "lines/retain.h"
#include "lines/share.h"
#include "lines/smooth.h"
#include "lines/smooth_line.h"
#include "lines/span.h"
#include "movers/meet.h"
#include "orders/room.h"
#include "pieces/entry.h"
#include "screen/project.h"
#include "screen/samples.h"
#include "view/cull.h"
#include "view/walk.h"

#if LIM_HAS_SPANS

/* Polygons come from the sorted list: a constant where nothing is walked, for meshes do not come here. */
#define IS_LISTED(nearest) (!LIM_HAS_WALKED || LIM_IS_SORTED(&(nearest)->pass->target))

static inline bool collect_seen(struct lim_nearest *nearest, const LIM_FLASH lim_index *record)
{
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest) && lim_meet_asks(nearest->progress.route))
        return lim_collect_met(nearest, record, false, lim_collect_record);
    return lim_collect_record(nearest, record);
}

/* Polygons from the walk through the tree. false: a pool is exhausted. */
static bool collect_run(struct lim_nearest *nearest, lim_index run)
{
    struct lim_pass *const pass = nearest->pass;
    const LIM_FLASH lim_index *record = &pass->scene->polygons[run];

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(record)) return lim_collect_mesh_leaf(nearest, record);
    for (;;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(pass)->records += (head & LIM_POLYGON_PLANE) != 0;
        if (lim_record_is_seen(&pass->walk->eye, record)) {
            if (!collect_seen(nearest, record)) return false;
            if (!nearest->spans.open_lines) return true;
        }
        if (head & LIM_POLYGON_LAST) return true;
        record += lim_record_words(head);
    }
}

static LIM_IF_CALLED void begin_meeting(struct lim_nearest *nearest)
{
    lim_meet_begin(nearest->progress.route, nearest->pass, *nearest->movers, lim_cull_of(nearest->pass));
}

static LIM_IF_CALLED bool collect_meeting(struct lim_nearest *nearest)
{
    lim_index what;

    begin_meeting(nearest);
    while (nearest->spans.open_lines) {
        const enum lim_meet_event event = lim_meet_next(nearest->progress.route, &what);
        if (event == LIM_MEET_END) return true;
        if (!(event == LIM_MEET_RUN ? collect_run(nearest, what) : lim_collect_mover(nearest, (uint16_t)what)))
            return false;
    }
    return true;
}

static LIM_IF_CALLED bool collect_from_tree(struct lim_nearest *nearest, const struct lim_rect *band)
{
    lim_index run;

    if (LIM_HAS_CULL)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8, band);
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest)) return collect_meeting(nearest);
    lim_walk_begin(nearest->pass->walk, false);
    while (nearest->spans.open_lines && (run = lim_walk_next(nearest->pass->walk, lim_cull_of(nearest->pass),
                                                             lim_stats_of(nearest->pass))) != LIM_NO_INDEX) {
        if (!collect_run(nearest, run)) return false;
    }
    return true;
}

/* From the sorted list. false: a pool is exhausted. */
static bool collect_entry(struct lim_nearest *nearest, uint16_t at)
{
    struct lim_sorter *const sorter = lim_nearest_sorter(nearest);
    const LIM_FLASH lim_index *record = &nearest->pass->scene->polygons[sorter->list[at].record];
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &nearest->pass->view, nearest->pass->scene, record, &nearest->spans.open,
                     lim_stats_of(nearest->pass)))
        return true;
    const bool has_room = LIM_HAS_NEWELL && lim_entry_is_split(sorter, at) ? lim_collect_piece(nearest, at, &polygon)
                                                                           : lim_collect_polygon(nearest, &polygon);
    if (!has_room) return false;
    if (++nearest->since_shrink < LIM_POLYGONS_PER_SHRINK) return true;
    nearest->since_shrink = 0;
    (void)lim_spans_shrink(&nearest->spans);
    return true;
}

static bool collect_from_list(struct lim_nearest *nearest)
{
    struct lim_sorter *const sorter = lim_nearest_sorter(nearest);

    for (uint16_t at = sorter->first; at != LIM_NONE && nearest->spans.open_lines; at = sorter->list[at].next)
        if (!collect_entry(nearest, at)) return false;
    return true;
}

static bool collect_from_source(struct lim_nearest *nearest, const struct lim_rect *band)
{
    if (IS_LISTED(nearest)) return collect_from_list(nearest);
    return collect_from_tree(nearest, band);
}

bool lim_collect(struct lim_nearest *nearest, const struct lim_rect *band)
{
    lim_nearest_open(nearest, band);
    if (!collect_from_source(nearest, band)) return false;
    if (LIM_HAS_STATS) lim_nearest_note_pools(nearest);
    return true;
}

/* The same in quanta, over all lines. What a loop above has in variables is in struct lim_progress. */

/* Records up to the next that faces the eye, and that one. */
static LIM_IF_CALLED bool collect_some_of_run(struct lim_nearest *nearest)
{
    const LIM_FLASH lim_index *record = nearest->progress.record;

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(record)) {
        nearest->progress.record = NULL;
        return lim_collect_mesh_leaf(nearest, record);
    }
    for (bool is_seen = false; record && !is_seen;) {
        const lim_index head = record[0];
        if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->records += (head & LIM_POLYGON_PLANE) != 0;
        is_seen = lim_record_is_seen(&nearest->pass->walk->eye, record);
        if (is_seen && !collect_seen(nearest, record)) return false;
        record = head & LIM_POLYGON_LAST || !nearest->spans.open_lines ? NULL : record + lim_record_words(head);
    }
    nearest->progress.record = record;
    return true;
}

static LIM_IF_CALLED void begin_tree(struct lim_nearest *nearest, const struct lim_rect *frame)
{
    nearest->progress.record = NULL;
    if (LIM_HAS_CULL)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8, frame);
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest)) {
        begin_meeting(nearest);
        return;
    }
    lim_walk_begin(nearest->pass->walk, false);
}

/* LIM_NO_INDEX: there is none. With movers, they may come instead. */
static LIM_IF_CALLED enum lim_meet_event next_of_tree(struct lim_nearest *nearest, lim_index *what)
{
    if (LIM_HAS_MOVERS && lim_nearest_moves(nearest)) return lim_meet_next(nearest->progress.route, what);
    *what = lim_walk_next(nearest->pass->walk, lim_cull_of(nearest->pass), lim_stats_of(nearest->pass));
    return *what == LIM_NO_INDEX ? LIM_MEET_END : LIM_MEET_RUN;
}

/* A quantum: a polygon, a mesh leaf, or what has moved to one place. */
static LIM_IF_CALLED enum lim_ahead_stage collect_some_of_tree(struct lim_nearest *nearest)
{
    lim_index what;

    if (!nearest->progress.record) {
        if (!nearest->spans.open_lines) return LIM_AHEAD_DONE;
        const enum lim_meet_event event = next_of_tree(nearest, &what);
        if (event == LIM_MEET_END) return LIM_AHEAD_DONE;
        if (LIM_HAS_MOVERS && event == LIM_MEET_MOVER)
            return lim_collect_mover(nearest, (uint16_t)what) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
        nearest->progress.record = &nearest->pass->scene->polygons[what];
    }
    return collect_some_of_run(nearest) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}

static LIM_IF_CALLED enum lim_ahead_stage collect_some_of_list(struct lim_nearest *nearest)
{
    const uint16_t at = nearest->progress.entry;

    if (at == LIM_NONE || !nearest->spans.open_lines) return LIM_AHEAD_DONE;
    nearest->progress.entry = lim_nearest_sorter(nearest)->list[at].next;
    return collect_entry(nearest, at) ? LIM_AHEAD_BUSY : LIM_AHEAD_EXHAUSTED;
}

void lim_collect_begin(struct lim_nearest *nearest, const struct lim_rect *frame)
{
    lim_nearest_open(nearest, frame);
    if (IS_LISTED(nearest))
        nearest->progress.entry = lim_nearest_sorter(nearest)->first;
    else
        begin_tree(nearest, frame);
}

enum lim_ahead_stage lim_collect_some(struct lim_nearest *nearest)
{
    const enum lim_ahead_stage stage =
        IS_LISTED(nearest) ? collect_some_of_list(nearest) : collect_some_of_tree(nearest);

    if (LIM_HAS_STATS && stage == LIM_AHEAD_DONE) lim_nearest_note_pools(nearest);
    return stage;
}

#endif
