/* SPDX-License-Identifier: MIT
 *
 * Sides are those of whole vertices, exact, as long as they decide. What they leave open is decided on the piece's
 * own corners. */
#include "pieces/piece.h"

#include "pieces/corners.h"
#include "pieces/entry.h"
#include "screen/edge.h"
#include "screen/project.h"
#include "view/clip.h"
#include "view/plane_unpacked.h"
#include "view/transform.h"
#include "view/view.h"

#if LIM_HAS_NEWELL

static uint8_t piece_side_of(int64_t value, int64_t slack)
{
    return value > slack ? LIM_SIDE_FRONT : value < -slack ? LIM_SIDE_BACK : 0;
}

/* The same for a vertex and a narrow plane. */
static uint8_t narrow_side_of(const struct lim_plane_unpacked *plane, const struct lim_vertex *at)
{
    const int32_t slack = (int32_t)plane->slack, d = (int32_t)plane->d;
    const int32_t value = plane->n[0] * at->x + plane->n[1] * at->y + plane->n[2] * at->z - d;

    return value > slack ? LIM_SIDE_FRONT : value < -slack ? LIM_SIDE_BACK : 0;
}

static uint8_t sides_of_whole(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    const LIM_FLASH struct lim_vertex *vertices = sorter->pass->scene->vertices;
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
    uint8_t sides = 0;

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT) && sides != LIM_SIDE_BOTH; k++) {
        const struct lim_vertex at = vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        const uint8_t side = plane->narrow ? narrow_side_of(plane, &at)
                                           : piece_side_of(lim_plane_value(plane, at.x, at.y, at.z, 1), plane->slack);
        sides |= side;
    }
    return sides;
}

static bool piece_is_same(const LIM_FLASH struct lim_plane_ref *a, const LIM_FLASH struct lim_plane_ref *b)
{
    return a->plane == b->plane && a->offset == b->offset;
}

/* 0: it was never cut by that plane. */
static uint8_t remembered_side(const struct lim_sorter *sorter, uint16_t entry,
                               const LIM_FLASH struct lim_plane_ref *plane)
{
    const struct lim_newell *newell = sorter->newell;

    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        const uint16_t by = newell->cuts[cut].by;
        if (!piece_is_same(lim_plane_of(sorter, by & LIM_SORTED_MAX), plane)) continue;
        return by & LIM_CUT_FRONT ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
    }
    return 0;
}

static LIM_RARE uint8_t sides_of_piece(const struct lim_sorter *sorter, uint16_t entry,
                                       const struct lim_plane_unpacked *plane)
{
    struct lim_corners places[2];
    const struct lim_corners *corners = lim_corners_of(sorter, entry, places);
    uint8_t sides = 0;

    if (!corners) return LIM_SIDE_FRONT;
    for (uint_fast8_t k = 0; k < corners->n; k++)
        sides |= piece_side_of(lim_corner_value(plane, corners->at_q12[k]), plane->slack * LIM_CORNER_ONE_Q12);
    return sides;
}

uint8_t lim_piece_sides(const struct lim_sorter *sorter, uint16_t of, uint16_t by)
{
    const bool whole = !lim_entry_is_cut(sorter, of);
    struct lim_plane_unpacked plane;

    if (!whole) {
        const uint8_t side = remembered_side(sorter, of, lim_plane_of(sorter, by));
        if (side) return side;
    }
    lim_plane_load(&plane, sorter, by);
    const uint8_t sides = sides_of_whole(sorter, of, &plane);
    return whole || sides != LIM_SIDE_BOTH ? sides : sides_of_piece(sorter, of, &plane);
}

/* On the screen ------------------------------------------------------------------------------- */

/* transform.h's rows times a corner. Sums stay below 2^59; values where a vertex's do. */
static int32_t transform_q12(const struct lim_row *row, const int32_t at_q12[3])
{
    int64_t sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
#if LIM_HAS_LIMBS
        sum += ((int64_t)row->n_qv[i] * 32768 + row->low_qv15[i]) * at_q12[i];
#else
        sum += (int64_t)row->n_qv[i] * at_q12[i];
#endif
    }
    return (int32_t)(sum >> (LIM_HAS_LIMBS ? 27 : 12)) + row->shift_qv;
}

static void view_corner(const struct lim_view *view, const int32_t at_q12[3], struct lim_view_point *out)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = transform_q12(&view->rows.row[i], at_q12);
    transform_settle(&view->rows, out->qv);
    if (LIM_HAS_LONG) *out->exponent = 0;
    lim_view_hide_edge(out, false);
}

static LIM_RARE bool project_corners(const struct lim_sorter *sorter, const struct lim_corners *corners,
                                     struct lim_screen_polygon *out)
{
    const struct lim_view *view = &sorter->pass->view;
    struct lim_clip_polygon clips[2];

    lim_clip_begin(&clips[0], view);
    clips[0].n = corners->n;
    for (uint_fast8_t k = 0; k < corners->n; k++)
        view_corner(view, corners->at_q12[k], &clips[0].at[k]);
    const struct lim_clip_polygon *clipped = lim_clip(clips, view->rows.near_qv);
    out->n = clipped->n;
    for (uint_fast8_t k = 0; k < clipped->n; k++)
        lim_view_project(view, &clipped->at[k], &out->at[k]);
    return out->n >= 3;
}

static uint16_t piece_greater(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

static uint16_t smaller(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

static struct lim_rect intersection(const struct lim_rect *a, const struct lim_rect *b)
{
    return (struct lim_rect){piece_greater(a->x0, b->x0), piece_greater(a->y0, b->y0), smaller(a->x1, b->x1),
                             smaller(a->y1, b->y1)};
}

/* Whether no corner of a polygon lies on the outer side of an edge of it from `from` by (dx, dy), farther than
 * the two sub-pixels that it and the edge may be rounded by. Corners that all but coincide are rounded one by one: the
 * edge between them may have any direction, and is none of the polygon as a whole. */
static LIM_RARE bool lies_within(const struct lim_screen_polygon *polygon, const struct lim_point *from, int32_t dx,
                                 int32_t dy)
{
    const int64_t rounding = 2 * ((int64_t)abs_s32(dx) + abs_s32(dy));

    for (uint_fast8_t i = 0; i < polygon->n; i++) {
        const int32_t x = (int32_t)polygon->at[i].x - from->x, y = (int32_t)polygon->at[i].y - from->y;
        if ((int64_t)dx * y - (int64_t)dy * x > rounding) return false;
    }
    return true;
}

/* Whether an edge of `a` has all of `b` on its outer side, or on it, and `a` on the inner one. y points down and
 * corners run counter-clockwise as seen: the inner side is the negative one. */
static bool parts(const struct lim_screen_polygon *a, const struct lim_screen_polygon *b)
{
    struct lim_point from = a->at[a->n - 1];

    for (uint_fast8_t k = 0; k < a->n; from = a->at[k++]) {
        const int32_t dx = (int32_t)a->at[k].x - from.x, dy = (int32_t)a->at[k].y - from.y;
        uint_fast8_t i = 0;
        if (!dx && !dy) continue;
        while (i < b->n && (int64_t)dx * ((int32_t)b->at[i].y - from.y) >= (int64_t)dy * ((int32_t)b->at[i].x - from.x))
            i++;
        if (i == b->n && lies_within(a, &from, dx, dy)) return true;
    }
    return false;
}

/* Of entry `of` what lies on one side of the plane of `by`, or all. */
static bool piece_project(struct lim_sorter *sorter, uint16_t of, uint16_t by, uint8_t part,
                          const struct lim_rect *open, struct lim_screen_polygon *out)
{
    const struct lim_newell_polygon *polygons = sorter->newell->polygons;
    struct lim_corners places[2];
    const struct lim_corners *corners;
    struct lim_plane_unpacked plane;

    if (part == LIM_SIDE_BOTH && !lim_entry_is_cut(sorter, of))
        return lim_project(out, &sorter->pass->view, sorter->pass->scene, lim_entry_record(sorter, of), open, NULL);
    if (part == LIM_SIDE_BOTH) {
        corners = lim_corners_of(sorter, of, places);
    } else {
        lim_plane_load(&plane, sorter, by);
        corners = lim_corners_cut(sorter, of, &plane, (part == LIM_SIDE_FRONT) == polygons[by].eye_in_front, places);
    }
    return corners && project_corners(sorter, corners, out);
}

bool lim_piece_overlaps(struct lim_sorter *sorter, uint16_t of, uint16_t by, uint8_t part)
{
    const struct lim_newell_polygon *polygons = sorter->newell->polygons;
    const struct lim_rect both = intersection(&polygons[of].rect, &polygons[by].rect);
    struct lim_screen_polygon first, second;

    if (!piece_project(sorter, of, by, part, &both, &first) ||
        !piece_project(sorter, by, of, LIM_SIDE_BOTH, &both, &second))
        return false;
    return !parts(&first, &second) && !parts(&second, &first);
}

/* Splitting ----------------------------------------------------------------------------------- */

/* A pixel more on each side, for a piece is painted by its whole and a line. Without any pixel it is nearer than the
 * near plane, or out of view: what the whole has is as good. */
static struct lim_rect rect_of(const struct lim_sorter *sorter, const struct lim_corners *corners,
                               const struct lim_rect *whole)
{
    struct lim_screen_polygon polygon;

    if (!project_corners(sorter, corners, &polygon)) return *whole;
    lim_edge_bounds(&polygon.shape, polygon.at, polygon.n);
    lim_edge_bounds_sides(&polygon.shape, polygon.at, polygon.n);
    const struct lim_edge_shape *shape = &polygon.shape;
    const struct lim_rect own = {
        shape->left > 0 ? (uint16_t)(shape->left - 1) : 0, shape->top > 0 ? (uint16_t)(shape->top - 1) : 0,
        shape->right >= 0 ? (uint16_t)(shape->right + 1) : 0, shape->bottom >= 0 ? (uint16_t)(shape->bottom + 1) : 0};
    const struct lim_rect both = intersection(&own, whole);
    return both.x0 < both.x1 && both.y0 < both.y1 ? both : *whole;
}

/* What is known of a piece. false: it has too many corners. */
static bool find_bounds(struct lim_sorter *sorter, uint16_t entry)
{
    struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    struct lim_corners places[2];
    const struct lim_corners *corners = lim_corners_of(sorter, entry, places);
    int32_t near_qv = INT32_MAX, far_qv = INT32_MIN;

    if (!corners) return false;
    for (uint_fast8_t k = 0; k < corners->n; k++) {
        const int32_t z_qv = transform_q12(&sorter->pass->view.rows.row[2], corners->at_q12[k]);
        if (z_qv < near_qv) near_qv = z_qv;
        if (z_qv > far_qv) far_qv = z_qv;
    }
    polygon->near_qv = near_qv;
    sorter->list[entry].far_qv = far_qv;
    polygon->rect = rect_of(sorter, corners, &polygon->rect);
    return true;
}

static void remember(struct lim_sorter *sorter, uint16_t entry, uint16_t by)
{
    struct lim_newell *newell = sorter->newell;

    newell->cuts[newell->cuts_used] = (struct lim_cut){newell->polygons[entry].cuts, by};
    newell->polygons[entry].cuts = newell->cuts_used++;
}

bool lim_piece_has_room(const struct lim_sorter *sorter)
{
    return sorter->used != sorter->size && sorter->newell->cut_size - sorter->newell->cuts_used >= 2;
}

uint16_t lim_piece_split(struct lim_sorter *sorter, uint16_t entry, uint16_t by)
{
    struct lim_newell *newell = sorter->newell;
    const uint16_t other = sorter->used;

    if (!lim_piece_has_room(sorter)) return LIM_NONE;
    const struct lim_sorted before = sorter->list[entry];
    const struct lim_newell_polygon polygon = newell->polygons[entry];
    sorter->list[other] = before;
    newell->polygons[other] = polygon;
    remember(sorter, entry, (uint16_t)(by | LIM_CUT_FRONT));
    remember(sorter, other, by);
    if (!find_bounds(sorter, entry) || !find_bounds(sorter, other)) {
        newell->cuts_used = (uint16_t)(newell->cuts_used - 2);
        sorter->list[entry] = before;
        newell->polygons[entry] = polygon;
        return LIM_NONE;
    }
    sorter->used++;
    return other;
}

static uint16_t piece_within(int16_t at, uint16_t end)
{
    return at < 0 ? 0 : at > (int16_t)end ? end : (uint16_t)at;
}

bool lim_piece_rect(struct lim_sorter *sorter, uint16_t entry)
{
    const uint16_t w_px = sorter->pass->target.w_px, h_px = sorter->pass->target.h_px;
    const struct lim_rect screen = {0, 0, w_px, h_px};
    struct lim_screen_polygon whole;

    if (!lim_project(&whole, &sorter->pass->view, sorter->pass->scene, lim_entry_record(sorter, entry), &screen, NULL))
        return false;
    const struct lim_edge_shape *shape = &whole.shape;
    sorter->newell->polygons[entry].rect =
        (struct lim_rect){piece_within(shape->left, w_px), piece_within(shape->top, h_px),
                          piece_within(shape->right, w_px), piece_within(shape->bottom, h_px)};
    return true;
}

#endif
