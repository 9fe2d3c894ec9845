/* SPDX-License-Identifier: MIT
 *
 * A list of movers in empty space, from which nothing of the static scene divides them. One object's polygons
 * are in the order of its own tree. Objects follow each other where a plane between them tells which is nearer; of
 * those between which none does, all polygons are sorted as Newell, Newell and Sancha did (newell.c), which splits what
 * passes through each other. */
#include "routes/mover_order.h"

#include "eye.h"
#include "movers/deform.h"
#include "movers/mover_long.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/mesh_leaf.h"
#include "pieces/newell.h"
#include "pieces/piece.h"
#include "pieces/sorter.h"
#include "pieces/trace.h"
#include "routes/mover_list.h"
#include "routes/mover_merge.h"
#include "routes/mover_part.h"
#include "routes/route.h"
#include "screen/polygon.h"
#include "screen/project.h"

#if LIM_HAS_MOVERS

static bool deforms(const struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(sorter, entry);

    return owner != LIM_NONE && lim_deforms(&sorter->movers->instances[owner]);
}

static uint16_t reverse(struct lim_sorted *list, uint16_t first)
{
    uint16_t reversed = LIM_NONE;

    while (first != LIM_NONE) {
        const uint16_t next = list[first].next;
        list[first].next = reversed;
        reversed = first;
        first = next;
    }
    return reversed;
}

/* From the nearest on, or from the farthest. */
static uint16_t order_to(struct lim_sorter *sorter, uint16_t list, bool back_to_front)
{
    return back_to_front ? reverse(sorter->list, list) : list;
}

/* Every entry a polygon or a piece, with all that Newell's sort wants to know; what has no pixel is dropped. false: no
 * room. */
static bool bound_all(struct lim_sorter *sorter, uint16_t *list)
{
    uint16_t *link = list;

    while (*link != LIM_NONE) {
        const uint16_t entry = *link;
        if (lim_mover_is_whole(sorter, entry)) {
            const bool stays =
                sorter->movers->instances[lim_entry_owner(sorter, entry)].by_centre && !deforms(sorter, entry);
            if (stays || !lim_mover_burst(sorter, entry, link)) return false;
        } else if (lim_piece_bounds(sorter, entry)) {
            link = &sorter->list[entry].next;
        } else {
            *link = sorter->list[entry].next;
        }
    }
    return true;
}

static int32_t depth_of_centre(const struct lim_movers *movers, uint16_t mover)
{
    const struct lim_mover *self = &movers->movers[mover];

    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers))
        return lim_far_depth(movers, lim_mover_exponent(movers, mover), self->centre_q12);
    return lim_mover_depth(movers, self->centre_q12);
}

/* Nothing better can be done: by farthest points, whatever they are. */
static uint16_t sort_roughly(struct lim_sorter *sorter, uint16_t list)
{
    for (uint16_t at = list; at != LIM_NONE; at = sorter->list[at].next) {
        if (lim_mover_is_whole(sorter, at))
            sorter->list[at].far_qv = depth_of_centre(sorter->movers, lim_entry_owner(sorter, at));
        else
            (void)lim_piece_bounds(sorter, at);
    }
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.forced++;
    return reverse(sorter->list, lim_sorted_sort(sorter->list, list));
}

/* What no order of whole objects is right for. */
static uint16_t sort(struct lim_sorter *sorter, uint16_t list)
{
    if (!bound_all(sorter, &list)) return sort_roughly(sorter, list);
    sorter->first = lim_sorted_sort(sorter->list, list);
    sorter->comparing = true;
    lim_newell_order(sorter);
    sorter->comparing = false;
    lim_movers_note_entries(sorter);
    return sorter->first;
}

/* Objects ---------------------------------------------------------------------------------------------------------- */

/* The entries of one object follow each other in a list. Returns the last of those that begin at `first`. */
static uint16_t last_of(const struct lim_sorter *sorter, uint16_t first)
{
    const uint16_t owner = lim_entry_owner(sorter, first);

    while (sorter->list[first].next != LIM_NONE && lim_entry_owner(sorter, sorter->list[first].next) == owner)
        first = sorter->list[first].next;
    return first;
}

static uint16_t next_object(const struct lim_sorter *sorter, uint16_t first)
{
    return sorter->list[last_of(sorter, first)].next;
}

/* Whether the object of one entry may be drawn before that of another, nearest first. */
static bool mover_may_precede(const struct lim_sorter *sorter, uint16_t a, uint16_t b)
{
    return lim_mover_precedes(sorter->movers, lim_entry_owner(sorter, a), lim_entry_owner(sorter, b));
}

static bool is_grouped(const struct lim_sorter *sorter, uint16_t first)
{
    return sorter->newell->polygons[first].grouped;
}

/* An object that has to come before one of the group, or all before each other; LIM_NONE: none. */
static uint16_t find_blocker(const struct lim_sorter *sorter, uint16_t list)
{
    for (uint16_t a = list; a != LIM_NONE; a = next_object(sorter, a)) {
        if (!is_grouped(sorter, a)) continue;
        for (uint16_t b = list; b != LIM_NONE; b = next_object(sorter, b))
            if (!is_grouped(sorter, b) && !mover_may_precede(sorter, a, b)) return b;
    }
    return LIM_NONE;
}

static void set_group(struct lim_sorter *sorter, uint16_t list, uint16_t only)
{
    for (; list != LIM_NONE; list = next_object(sorter, list))
        sorter->newell->polygons[list].grouped = list == only;
}

/* Groups objects that may be drawn before all others: one, if there is one. Where two come before each other, or some
 * in a circle, they are one group. */
static void find_group(struct lim_sorter *sorter, uint16_t list)
{
    uint16_t first = list, blocker, steps = sorter->movers->count;

    set_group(sorter, list, first);
    while ((blocker = find_blocker(sorter, list)) != LIM_NONE) {
        if (steps && mover_may_precede(sorter, blocker, first)) {
            steps--;
            first = blocker;
            set_group(sorter, list, first);
        } else {
            steps = 0;
            sorter->newell->polygons[blocker].grouped = true;
        }
    }
}

/* Takes the group out of a list. */
static uint16_t take_group(struct lim_sorter *sorter, uint16_t *list)
{
    uint16_t group, *end = &group, *link = list;

    while (*link != LIM_NONE) {
        const uint16_t first = *link, last = last_of(sorter, first);
        if (is_grouped(sorter, first)) {
            *link = sorter->list[last].next;
            *end = first;
            end = &sorter->list[last].next;
        } else {
            link = &sorter->list[last].next;
        }
    }
    *end = LIM_NONE;
    return group;
}

/* Polygons of a leaf belong to no object, and have no place before or behind one. */
static bool has_still(const struct lim_sorter *sorter, uint16_t list)
{
    for (; list != LIM_NONE; list = next_object(sorter, list))
        if (lim_entry_owner(sorter, list) == LIM_NONE) return true;
    return false;
}

/* Takes the first of several lists, which ends with what is marked. */
static uint16_t take_marked(struct lim_sorter *sorter, uint16_t *lists)
{
    const uint16_t first = *lists;
    uint16_t last = first;

    while (!sorter->newell->polygons[last].last && sorter->list[last].next != LIM_NONE)
        last = sorter->list[last].next;
    sorter->newell->polygons[last].last = false;
    *lists = sorter->list[last].next;
    sorter->list[last].next = LIM_NONE;
    return first;
}

/* The link at the end of what another one leads to, of which the last entry is marked or not. */
static uint16_t *end_of(struct lim_sorter *sorter, uint16_t *link, bool marked)
{
    while (*link != LIM_NONE) {
        const uint16_t entry = *link;
        link = &sorter->list[entry].next;
        if (marked && *link == LIM_NONE) sorter->newell->polygons[entry].last = true;
    }
    return link;
}

/* Puts in their place those of the objects at *link that may come first. Returns the link behind them; or `link`, if
 * they are to be ordered once more. */
static uint16_t *order_next(struct lim_sorter *sorter, uint16_t *link)
{
    uint16_t rest = *link, list = take_marked(sorter, &rest);

    find_group(sorter, list);
    *link = take_group(sorter, &list);
    const bool is_one = sorter->list[*link].next == LIM_NONE;
    const bool is_merged = !is_one && lim_movers_merge(sorter, link);
    if (!is_merged && (!is_one || deforms(sorter, *link))) *link = sort(sorter, *link);
    uint16_t *const behind = end_of(sorter, link, false);
    *behind = list;
    *end_of(sorter, behind, true) = rest;
    return is_merged ? link : behind;
}

uint16_t lim_movers_order(struct lim_sorter *sorter, uint16_t list, bool back_to_front)
{
    uint16_t *link = &list;

    if (has_still(sorter, list)) return order_to(sorter, sort(sorter, list), back_to_front);
    while (*link != LIM_NONE)
        link = lim_mover_is_whole(sorter, *link) ? order_next(sorter, link) : &sorter->list[*link].next;
    return order_to(sorter, list, back_to_front);
}

/* Drawing ------------------------------------------------------------------------------------ */

/* A polygon of a mover: its plane, in its object, and on which side of that the eye is. */
struct face {
    const LIM_FLASH lim_index *record;
    const LIM_FLASH struct lim_plane_ref *plane; /* NULL: of its corners */
    uint16_t mover;
    bool eye_in_front;
};

/* What has no plane, because its corners have come to lie on a line, is not lit. */
static LIM_IF_CALLED uint16_t colour_of(const struct lim_sorter *sorter, const struct face *face)
{
    const struct lim_scene *object = sorter->movers->instances[face->mover].object;
    struct lim_plane_unpacked plane;

    if (!LIM_HAS_CORNER_PLANES || face->plane)
        lim_plane_unpack(&plane, object, face->plane);
    else if (!lim_deform_plane(&plane, object, face->record))
        return (uint16_t)face->record[1];
    for (uint_fast8_t i = 0; i < 3 && !face->eye_in_front; i++)
        plane.n[i] = -plane.n[i];
    return lim_light_shade(sorter->movers->light, sorter->movers->movers[face->mover].to_q14, plane.n,
                           (uint16_t)face->record[1]);
}

/* The word of its texture, as the frame counts them. */
static LIM_IF_CALLED void number_texture(const struct lim_sorter *sorter, struct lim_screen_polygon *out,
                                         uint16_t mover)
{
    const uint16_t first = lim_mover_first_texture(sorter->movers, mover), own = lim_screen_texture(out);

    *out->texture = first == LIM_NONE || own == LIM_NONE ? (uint16_t)LIM_NONE : (uint16_t)(first + own);
}

static void light_face(const struct lim_sorter *sorter, struct lim_screen_polygon *out, const struct face *face)
{
    if (LIM_HAS_LIGHT && sorter->movers->light->on) out->colour = lim_memory_colour(colour_of(sorter, face));
    if (LIM_HAS_TEXTURE) number_texture(sorter, out, face->mover);
}

static bool mover_order_project(struct lim_sorter *sorter, struct lim_screen_polygon *out, const struct face *face,
                                const struct lim_rect *open)
{
    const struct lim_scene *object = sorter->movers->instances[face->mover].object;

    if (!lim_project(out, lim_mover_view(sorter->movers, face->mover), object, face->record, open,
                     lim_stats_of(sorter->pass)))
        return false;
    light_face(sorter, out, face);
    return true;
}

/* The record before `record` in its run, which begins at `first`; NULL: there is none. */
static const LIM_FLASH lim_index *record_before(const LIM_FLASH lim_index *first, const LIM_FLASH lim_index *record)
{
    const LIM_FLASH lim_index *before = first;

    if (record == first) return NULL;
    while (before + lim_record_words(before[0]) != record)
        before += lim_record_words(before[0]);
    return before;
}

static const LIM_FLASH lim_index *record_after(const LIM_FLASH lim_index *record)
{
    return record[0] & LIM_POLYGON_LAST ? NULL : record + lim_record_words(record[0]);
}

static const LIM_FLASH lim_index *last_record(const LIM_FLASH lim_index *record)
{
    while (!(record[0] & LIM_POLYGON_LAST))
        record += lim_record_words(record[0]);
    return record;
}

/* A polygon, or a piece of one: `entry`. */
static int draw_cut(struct lim_sorter *sorter, uint16_t entry, const struct face *face,
                    const struct lim_mover_sink *sink)
{
    struct lim_screen_polygon polygon;

    if (!mover_order_project(sorter, &polygon, face, sink->open)) return 0;
    const bool is_cut = entry != LIM_NONE && lim_trace_is_needed(sorter, entry, &polygon);
    return sink->draw(sink->ctx, is_cut ? entry : (uint16_t)LIM_NONE, &polygon, sink->open);
}

/* A polygon that nothing has cut: LIM_NONE; or a piece that is painted as its whole, if it is opaque. */
static int draw_uncut(struct lim_sorter *sorter, uint16_t entry, const struct face *face,
                      const struct lim_mover_sink *sink)
{
    if (sink->take && !(LIM_HAS_LIGHT && sorter->movers->light->on)) {
        struct lim_view *const view = lim_mover_view(sorter->movers, face->mover);
        const int err = sink->take(sink->ctx, view, sorter->movers->instances[face->mover].object, face->record,
                                   lim_mover_first_texture(sorter->movers, face->mover));
        if (err != LIM_MOVER_DRAW) return err;
    }
    return draw_cut(sorter, entry, face, sink);
}

/* What of a polygon the cuts of an entry leave. */
static int draw_piece(struct lim_sorter *sorter, uint16_t entry, const struct face *face,
                      const struct lim_mover_sink *sink)
{
    const bool is_whole = !lim_entry_is_cut(sorter, entry);

    if (!is_whole && lim_trace_is_needed_of_opaque(sorter, entry)) {
        if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.pieces++;
        return draw_cut(sorter, entry, face, sink);
    }
    return draw_uncut(sorter, is_whole ? (uint16_t)LIM_NONE : entry, face, sink);
}

/* What of a polygon belongs to a part. The part's entry stands for it meanwhile, for the polygon's own to be cut. */
static int draw_share(struct lim_sorter *sorter, uint16_t entry, const struct lim_part *part, const struct face *face,
                      const struct lim_mover_sink *sink)
{
    const uint16_t cuts_used = sorter->newell->cuts_used;
    int err = 0;

    sorter->list[entry].record = (lim_index)(face->record - sorter->movers->instances[face->mover].object->polygons);
    const enum lim_part_share share = lim_part_take(part, sorter, entry);
    lim_movers_note_entries(sorter);
    if (share != LIM_PART_NOTHING) err = draw_piece(sorter, entry, face, sink);
    sorter->newell->cuts_used = cuts_used;
    return err;
}

static LIM_IF_CALLED int draw_mesh_leaf(struct lim_sorter *sorter, const struct lim_route *route, uint16_t entry,
                                        const struct lim_part *part, const LIM_FLASH lim_index *run,
                                        const struct lim_mover_sink *sink)
{
    const uint16_t mover = lim_entry_owner(sorter, entry);
    const struct lim_mesh_leaf_seen seen = {route->scene, lim_mover_view(sorter->movers, mover), route->back_to_front};
    struct lim_mesh_leaf *const leaf = sorter->movers->leaf;
    struct face face = {.mover = mover, .eye_in_front = true};
    struct lim_screen_polygon polygon;
    int err = 0;

    lim_mesh_leaf_sort(leaf, &seen, run);
    while (!err && (face.record = lim_mesh_leaf_next(leaf)) != NULL) {
        if (part->cuts != LIM_NONE) {
            err = draw_share(sorter, entry, part, &face, sink);
        } else if (lim_mesh_leaf_project(&polygon, leaf, face.record, sink->open, lim_stats_of(sorter->pass))) {
            light_face(sorter, &polygon, &face);
            err = sink->draw(sink->ctx, LIM_NONE, &polygon, sink->open);
        }
    }
    return err;
}

static int draw_run(struct lim_sorter *sorter, const struct lim_route *route, uint16_t entry,
                    const struct lim_part *part, lim_index run, const struct lim_mover_sink *sink)
{
    const LIM_FLASH lim_index *const first = &route->scene->polygons[run];
    const LIM_FLASH lim_index *record = route->back_to_front ? last_record(first) : first;
    struct face face = {.plane = &route->scene->nodes[route->node].split, .mover = lim_entry_owner(sorter, entry)};

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(first)) return draw_mesh_leaf(sorter, route, entry, part, first, sink);
    while (record) {
        face.record = record;
        face.eye_in_front = route->side > 0;
        if (LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE) {
            face.plane = lim_record_plane(record);
            face.eye_in_front = !(record[0] & LIM_POLYGON_BACK);
        }
        if (lim_record_is_seen(route->eye, record)) {
            const int err = part->cuts == LIM_NONE ? draw_uncut(sorter, LIM_NONE, &face, sink)
                                                   : draw_share(sorter, entry, part, &face, sink);
            if (err) return err;
        }
        record = route->back_to_front ? record_before(first, record) : record_after(record);
    }
    return 0;
}

/* By the order of its own tree: all of it, or a part. */
static int draw_whole(struct lim_sorter *sorter, uint16_t entry, const struct lim_mover_sink *sink)
{
    struct lim_route route;
    struct lim_part part;
    lim_index run;
    int err = 0;

    lim_route_object(&route, sorter, lim_entry_owner(sorter, entry), sink->open, sink->back_to_front);
    lim_part_begin(&part, sorter, entry);
    while (!err && (run = lim_route_next_alone(&route)) != LIM_NO_INDEX)
        err = draw_run(sorter, &route, entry, &part, run, sink);
    sorter->list[entry].record = LIM_NO_INDEX;
    sorter->newell->polygons[entry].cuts = part.cuts;
    return err;
}

/* A polygon of a leaf that movers have come to. */
static int draw_still(struct lim_sorter *sorter, uint16_t entry, const struct lim_mover_sink *sink)
{
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &sorter->pass->view, sorter->pass->scene, lim_entry_record(sorter, entry), sink->open,
                     lim_stats_of(sorter->pass)))
        return 0;
    return sink->draw(sink->ctx, lim_trace_is_needed(sorter, entry, &polygon) ? entry : (uint16_t)LIM_NONE, &polygon,
                      sink->open);
}

static int draw_entry(struct lim_sorter *sorter, uint16_t entry, const struct lim_mover_sink *sink)
{
    if (lim_entry_owner(sorter, entry) == LIM_NONE) return draw_still(sorter, entry, sink);
    const bool has_own = LIM_HAS_CORNER_PLANES && lim_plane_is_of_corners(sorter, entry);
    const struct face face = {lim_entry_record(sorter, entry), has_own ? NULL : lim_plane_of(sorter, entry),
                              lim_entry_owner(sorter, entry), sorter->newell->polygons[entry].eye_in_front};

    return draw_piece(sorter, entry, &face, sink);
}

int lim_movers_draw(struct lim_sorter *sorter, uint16_t list, const struct lim_mover_sink *sink)
{
    for (; list != LIM_NONE; list = sorter->list[list].next) {
        const int err =
            lim_mover_is_whole(sorter, list) ? draw_whole(sorter, list, sink) : draw_entry(sorter, list, sink);
        if (err) return err;
    }
    return 0;
}

#endif
