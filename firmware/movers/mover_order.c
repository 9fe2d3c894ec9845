/* SPDX-License-Identifier: MIT
 *
 * A list of movers in empty space, from which nothing of the static scene divides them. One object's polygons
 * are in the order of its own tree. Objects whose extents in depth do not overlap follow each other; else all their
 * polygons are sorted as Newell, Newell and Sancha did (newell.c), which splits what passes through each other. */
#include "movers/movers.h"

#include "pieces/corners.h"
#include "pieces/deform.h"
#include "pieces/entry.h"
#include "pieces/piece.h"
#include "pixels/fill.h"

#if LIM_HAS_MOVERS

static bool deforms(const struct lim *lim, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(lim, entry);

    return owner != LIM_NONE && lim_deforms(&lim->movers.instances[owner]);
}

/* One that has an order of its own. */
static bool has_one_owner(const struct lim *lim, uint16_t list)
{
    const uint16_t owner = lim_entry_owner(lim, list);

    if (deforms(lim, list)) return false;
    for (; list != LIM_NONE; list = lim->sorter.list[list].next)
        if (lim_entry_owner(lim, list) != owner) return false;
    return true;
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

/* Along the camera's axis. An instance that enters by its centre is a point. */
static void measure_ball(struct lim *lim, uint16_t entry)
{
    const uint16_t owner = lim_entry_owner(lim, entry);
    const struct lim_mover *mover = &lim->movers.movers[owner];
    const int32_t depth = lim_mover_depth(lim, mover->centre_q12);
    const int32_t reach = lim->movers.instances[owner].by_centre ? 0 : (mover->radius_q12 >> 3) + 1;

    lim->sorter.list[entry].far_qv = depth + reach;
    lim->sorter.newell.polygons[entry].near_qv = depth - reach;
}

/* Whether the list is of whole instances, one behind the other or by their centres; it is sorted then, nearest first.
 */
static bool is_row(struct lim *lim, uint16_t *list)
{
    struct lim_sorted *entries = lim->sorter.list;
    int32_t end = INT32_MIN;

    for (uint16_t at = *list; at != LIM_NONE; at = entries[at].next) {
        if (!lim_mover_is_whole(lim, at) || deforms(lim, at)) return false;
        measure_ball(lim, at);
    }
    *list = reverse(entries, lim_sorted_sort(entries, *list));
    for (uint16_t at = *list; at != LIM_NONE; at = entries[at].next) {
        if (lim->sorter.newell.polygons[at].near_qv < end) return false;
        end = entries[at].far_qv;
    }
    return true;
}

/* Every entry a polygon or a piece, with all that Newell's sort wants to know; what has no pixel is dropped. false: no
 * room. */
static bool measure_all(struct lim *lim, uint16_t *list)
{
    uint16_t *link = list;

    while (*link != LIM_NONE) {
        const uint16_t entry = *link;
        if (lim_mover_is_whole(lim, entry)) {
            const bool stays = lim->movers.instances[lim_entry_owner(lim, entry)].by_centre && !deforms(lim, entry);
            if (stays || !lim_mover_burst(lim, entry, link)) return false;
        } else if (lim_piece_bounds(lim, entry)) {
            link = &lim->sorter.list[entry].next;
        } else {
            *link = lim->sorter.list[entry].next;
        }
    }
    return true;
}

/* Nothing better can be done: by farthest points, whatever they are. */
static uint16_t sort_roughly(struct lim *lim, uint16_t list)
{
    for (uint16_t at = list; at != LIM_NONE; at = lim->sorter.list[at].next) {
        if (lim_mover_is_whole(lim, at))
            measure_ball(lim, at);
        else
            (void)lim_piece_bounds(lim, at);
    }
    if (LIM_HAS_STATS) lim_stats_of(lim)->movers.forced++;
    return reverse(lim->sorter.list, lim_sorted_sort(lim->sorter.list, list));
}

static uint16_t sort(struct lim *lim, uint16_t list)
{
    if (is_row(lim, &list)) return list;
    if (!measure_all(lim, &list)) return sort_roughly(lim, list);
    lim->sorter.first = lim_sorted_sort(lim->sorter.list, list);
    lim->movers.measuring = true;
    lim_newell_order(lim);
    lim->movers.measuring = false;
    lim_movers_note_entries(lim);
    return lim->sorter.first;
}

uint16_t lim_movers_order(struct lim *lim, uint16_t list, bool back_to_front)
{
    if (!has_one_owner(lim, list)) list = sort(lim, list);
    return back_to_front ? reverse(lim->sorter.list, list) : list;
}

/* Drawing ------------------------------------------------------------------------------------ */

/* A polygon of a mover: its plane, in its object, and on which side of that the eye is. */
struct face {
    const LIM_FLASH lim_index *record;
    const LIM_FLASH struct lim_plane_ref *plane;
    uint16_t mover;
    bool eye_in_front;
};

#if LIM_HAS_LIGHT
/* What has no plane, because its corners have come to lie on a line, is not lit. */
static uint16_t colour_of(const struct lim *lim, const struct face *face)
{
    const struct lim_scene *object = lim->movers.instances[face->mover].object;
    struct lim_plane_unpacked plane;

    if (!LIM_HAS_DEFORM || !lim_deforms(&lim->movers.instances[face->mover]))
        lim_plane_unpack(&plane, object, face->plane);
    else if (!lim_deform_plane(&plane, object, face->record))
        return (uint16_t)face->record[1];
    for (uint_fast8_t i = 0; i < 3 && !face->eye_in_front; i++)
        plane.n[i] = -plane.n[i];
    return lim_light_shade(&lim->movers.light, lim->movers.movers[face->mover].to_q14, plane.n,
                           (uint16_t)face->record[1]);
}
#endif

/* Objects are not textured: what they show is their records' colours. */
static bool mover_order_project(struct lim *lim, struct lim_screen_polygon *out, const struct face *face,
                                const struct lim_rect *open)
{
    const struct lim_scene *object = lim->movers.instances[face->mover].object;

    if (!lim_project(out, lim_mover_view(lim, face->mover), object, face->record, open, lim_stats_of(lim)))
        return false;
#if LIM_HAS_LIGHT
    if (lim->movers.light.on) out->colour = lim_memory_colour(colour_of(lim, face));
#endif
#if LIM_HAS_TEXTURE
    out->texture = LIM_NONE;
#endif
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

static int draw_run(struct lim *lim, const struct lim_route *route, uint16_t mover, lim_index run,
                    const struct lim_rect *open, lim_mover_draw *draw)
{
    const LIM_FLASH lim_index *const first = &route->scene->polygons[run];
    const LIM_FLASH lim_index *record = route->back_to_front ? last_record(first) : first;
    struct lim_screen_polygon polygon;
    struct face face = {.plane = &route->scene->nodes[route->node].split, .mover = mover};

    while (record) {
        face.record = record;
        face.eye_in_front = route->side > 0;
        if (LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE) {
            face.plane = lim_record_plane(record);
            face.eye_in_front = !(record[0] & LIM_POLYGON_BACK);
        }
        if (lim_record_is_seen(route->eye, record) && mover_order_project(lim, &polygon, &face, open)) {
            const int err = draw(lim, LIM_NONE, &polygon, open);
            if (err) return err;
        }
        record = route->back_to_front ? record_before(first, record) : record_after(record);
    }
    return 0;
}

/* By the order of its own tree. */
static int draw_whole(struct lim *lim, uint16_t mover, const struct lim_rect *open, bool back_to_front,
                      lim_mover_draw *draw)
{
    struct lim_route route = lim_route_object(lim, mover, open, back_to_front);
    lim_index run;

    while (lim_route_next_alone(lim, &route, &run)) {
        const int err = draw_run(lim, &route, mover, run, open, draw);
        if (err) return err;
    }
    return 0;
}

/* A polygon of a leaf that movers have come to. */
static int draw_still(struct lim *lim, uint16_t entry, const struct lim_rect *open, lim_mover_draw *draw)
{
    const bool is_cut = lim->sorter.newell.polygons[entry].cuts != LIM_NONE;
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &lim->view, lim->scene, lim_entry_record(lim, entry), open, lim_stats_of(lim))) return 0;
    return draw(lim, is_cut ? entry : (uint16_t)LIM_NONE, &polygon, open);
}

static int draw_entry(struct lim *lim, uint16_t entry, const struct lim_rect *open, lim_mover_draw *draw)
{
    if (lim_entry_owner(lim, entry) == LIM_NONE) return draw_still(lim, entry, open, draw);
    const bool is_cut = lim->sorter.newell.polygons[entry].cuts != LIM_NONE;
    const struct face face = {lim_entry_record(lim, entry), lim_plane_of(lim, entry), lim_entry_owner(lim, entry),
                              lim->sorter.newell.polygons[entry].eye_in_front};
    struct lim_screen_polygon polygon;

    if (!mover_order_project(lim, &polygon, &face, open)) return 0;
    return draw(lim, is_cut ? entry : (uint16_t)LIM_NONE, &polygon, open);
}

int lim_movers_draw(struct lim *lim, uint16_t list, const struct lim_rect *open, bool back_to_front,
                    lim_mover_draw *draw)
{
    for (; list != LIM_NONE; list = lim->sorter.list[list].next) {
        const int err = lim_mover_is_whole(lim, list)
                            ? draw_whole(lim, lim_entry_owner(lim, list), open, back_to_front, draw)
                            : draw_entry(lim, list, open, draw);
        if (err) return err;
    }
    return 0;
}

#endif
