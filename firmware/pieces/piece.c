/* SPDX-License-Identifier: MIT
 *
 * Sides are those of whole vertices, exact, as long as they decide. What they leave open is decided on the piece's
 * own corners. */
#include "pieces/piece.h"

#include "movers/deform.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "screen/edge.h"
#include "screen/project.h"
#include "view/clip.h"
#include "view/transform.h"
#include "view/view.h"

#if LIM_HAS_PIECES

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

static uint8_t sides_of_mover(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
    const int64_t slack_q12 = plane->slack * LIM_CORNER_ONE_Q12;
    uint8_t sides = 0;

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT) && sides != LIM_SIDE_BOTH; k++) {
        int32_t at_q12[3];
        lim_entry_corner(sorter, entry, record[LIM_POLYGON_HEAD_WORDS + k], at_q12);
        sides |= piece_side_of(lim_corner_value(plane, at_q12), slack_q12);
    }
    return sides;
}

/* The plane is of the scene that the record is of. */
static uint8_t sides_at_home(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    const LIM_FLASH struct lim_vertex *vertices = lim_entry_scene(sorter, entry)->vertices;
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

static uint8_t sides_of_whole(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane)
{
    if (LIM_HAS_MOVERS && lim_entry_owner(sorter, entry) != LIM_NONE) return sides_of_mover(sorter, entry, plane);
    return sides_at_home(sorter, entry, plane);
}

static bool piece_is_same(const LIM_FLASH struct lim_plane_ref *a, const LIM_FLASH struct lim_plane_ref *b)
{
    return a->plane == b->plane && a->offset == b->offset;
}

/* Whether two entries whose records name the same plane have the same one: other objects have others, and polygons
 * whose plane is that of their corners only their own. */
static bool have_one_plane(const struct lim_sorter *sorter, uint16_t a, uint16_t b)
{
    const uint16_t owner = lim_entry_owner(sorter, a);

    if (owner != lim_entry_owner(sorter, b)) return false;
    if (LIM_HAS_CORNER_PLANES && lim_plane_is_of_corners(sorter, a))
        return sorter->list[a].record == sorter->list[b].record;
    return true;
}

/* 0: it was never cut by that plane. */
static uint8_t remembered_side(const struct lim_sorter *sorter, uint16_t entry, uint16_t other)
{
    const struct lim_newell *newell = sorter->newell;
    const LIM_FLASH struct lim_plane_ref *plane = lim_plane_of(sorter, other);

    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        const uint16_t by = newell->cuts[cut].by;
        if (!piece_is_same(lim_plane_of(sorter, by & LIM_SORTED_MAX), plane)) continue;
        if (!have_one_plane(sorter, by & LIM_SORTED_MAX, other)) continue;
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

uint8_t lim_piece_sides_of(const struct lim_sorter *sorter, uint16_t of, const struct lim_plane_unpacked *plane)
{
    const uint8_t sides = sides_of_whole(sorter, of, plane);

    return !lim_entry_is_cut(sorter, of) || sides != LIM_SIDE_BOTH ? sides : sides_of_piece(sorter, of, plane);
}

/* Two polygons of one object, whose planes are its own. */
static bool are_of_one_object(const struct lim_sorter *sorter, uint16_t a, uint16_t b)
{
    const uint16_t owner = lim_entry_owner(sorter, a);

    return owner != LIM_NONE && owner == lim_entry_owner(sorter, b) && !lim_deforms(&sorter->movers->instances[owner]);
}

uint8_t lim_piece_sides(const struct lim_sorter *sorter, uint16_t of, uint16_t by)
{
    const bool whole = !lim_entry_is_cut(sorter, of);
    struct lim_plane_unpacked plane;

    if (!whole) {
        const uint8_t side = remembered_side(sorter, of, by);
        if (side) return side;
    }
    if (LIM_HAS_MOVERS && are_of_one_object(sorter, of, by)) { /* as if they stood still */
        lim_plane_load_own(&plane, sorter, by);
        const uint8_t sides = sides_at_home(sorter, of, &plane);
        if (whole || sides != LIM_SIDE_BOTH) return sides;
    }
    lim_plane_load_for(&plane, sorter, by, of);
    const uint8_t sides = sides_of_whole(sorter, of, &plane);
    return whole || sides != LIM_SIDE_BOTH ? sides : sides_of_piece(sorter, of, &plane);
}

/* On the screen ------------------------------------------------------------------------------- */

/* transform.h's rows times a corner with `bits` fraction bits. Sums stay below 2^60; values where a vertex's do. */
static int32_t transform_fine(const struct lim_row *row, const int32_t at[3], uint8_t bits)
{
    int64_t sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
#if LIM_HAS_LIMBS
        sum += ((int64_t)row->n_qv[i] * 32768 + row->low_qv15[i]) * at[i];
#else
        sum += (int64_t)row->n_qv[i] * at[i];
#endif
    }
    return (int32_t)(sum >> (LIM_HAS_LIMBS ? bits + 15 : bits)) + row->shift_qv;
}

/* Movers may leave the scene's box, for which its own view has room. */
static const struct lim_view *view_of(const struct lim_sorter *sorter, uint8_t *bits)
{
    const bool is_newell = !LIM_HAS_MOVERS || LIM_IS_NEWELL(&sorter->pass->target);

    *bits = is_newell ? 12 : 13;
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers)) return &sorter->pass->view;
    if (LIM_HAS_MOVERS && !is_newell) return lim_movers_world(sorter->movers);
    return &sorter->pass->view;
}

/* Along z, in the scale in which entries are compared. */
static int32_t depth_of(const struct lim_sorter *sorter, const int32_t at_q12[3])
{
    if (LIM_HAS_MOVERS && !LIM_IS_NEWELL(&sorter->pass->target)) return lim_mover_depth(sorter->movers, at_q12);
    return transform_fine(&sorter->pass->view.rows.row[2], at_q12, 12);
}

static LIM_IF_CALLED int32_t frame_depth_of(const struct lim_sorter *sorter, const struct lim_corners *corners,
                                            uint_fast8_t k)
{
    if (!lim_movers_are_far(sorter->movers)) return depth_of(sorter, corners->at_q12[k]);
    return lim_far_depth(sorter->movers, *corners->exponent, corners->at_q12[k]);
}

static void view_corner(const struct lim_sorter *sorter, const int32_t at_q12[3], struct lim_view_point *out)
{
    uint8_t bits;
    const struct lim_view *view = view_of(sorter, &bits);

    for (uint_fast8_t i = 0; i < 3; i++)
        out->qv[i] = transform_fine(&view->rows.row[i], at_q12, bits);
    transform_settle(&view->rows, out->qv);
    if (LIM_HAS_LONG) *out->exponent = 0;
}

static LIM_IF_CALLED void frame_view_corner(const struct lim_sorter *sorter, const struct lim_corners *corners,
                                            uint_fast8_t k, struct lim_view_point *out)
{
    if (lim_movers_are_far(sorter->movers))
        lim_far_view_corner(&sorter->pass->view, *corners->exponent, corners->at_q12[k], out);
    else
        view_corner(sorter, corners->at_q12[k], out);
}

static LIM_RARE bool project_corners(const struct lim_sorter *sorter, const struct lim_corners *corners,
                                     struct lim_screen_polygon *out)
{
    struct lim_clip_polygon clips[2];
    uint8_t bits;
    const struct lim_view *view = view_of(sorter, &bits);

    lim_clip_begin(&clips[0], view);
    clips[0].n = corners->n;
    for (uint_fast8_t k = 0; k < corners->n; k++) {
        LIM_HAS_FAR_MOVERS ? frame_view_corner(sorter, corners, k, &clips[0].at[k])
                           : view_corner(sorter, corners->at_q12[k], &clips[0].at[k]);
        lim_view_hide_edge(&clips[0].at[k], false);
    }
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
        return lim_project(out, lim_entry_view(sorter, of), lim_entry_scene(sorter, of), lim_entry_record(sorter, of),
                           open, NULL);
    if (part == LIM_SIDE_BOTH) {
        corners = lim_corners_of(sorter, of, places);
    } else {
        lim_plane_load_for(&plane, sorter, by, of);
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

/* Corners that are kept for what comes next, before the cuts are remembered. false: a piece would have too many. */
static LIM_IF_CALLED bool split_corners(struct lim_sorter *sorter, uint16_t entry, uint16_t by)
{
    struct lim_plane_unpacked plane;

    if (LIM_OPTIMISE_SIZE) return true;
    lim_plane_load_for(&plane, sorter, by, entry);
    return lim_corners_split(sorter, entry, &plane, sorter->newell->cuts_used);
}

/* What is known of an entry that is compared; of a piece's pixels, too. false: it has too many corners. */
static bool find_bounds(struct lim_sorter *sorter, uint16_t entry, bool on_screen)
{
    struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];
    struct lim_corners places[2];
    const struct lim_corners *corners = lim_corners_of(sorter, entry, places);
    int32_t near_qv = INT32_MAX, far_qv = INT32_MIN;

    if (!corners) return false;
    for (uint_fast8_t k = 0; k < corners->n; k++) {
        const int32_t z_qv =
            LIM_HAS_FAR_MOVERS ? frame_depth_of(sorter, corners, k) : depth_of(sorter, corners->at_q12[k]);
        if (z_qv < near_qv) near_qv = z_qv;
        if (z_qv > far_qv) far_qv = z_qv;
    }
    polygon->near_qv = near_qv;
    sorter->list[entry].far_qv = far_qv;
    if (on_screen) polygon->rect = rect_of(sorter, corners, &polygon->rect);
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
    const bool moves = LIM_HAS_MOVERS && !LIM_IS_NEWELL(&sorter->pass->target);
    const bool has_corners = !moves || split_corners(sorter, entry, by);
    remember(sorter, entry, (uint16_t)(by | LIM_CUT_FRONT));
    remember(sorter, other, by);
    if (!has_corners || !find_bounds(sorter, entry, true) || !find_bounds(sorter, other, true)) {
        newell->cuts_used = (uint16_t)(newell->cuts_used - 2);
        if (LIM_HAS_MOVERS && !LIM_OPTIMISE_SIZE) lim_mover_forget_pieces(sorter->movers);
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

    if (!lim_project(&whole, lim_entry_view(sorter, entry), lim_entry_scene(sorter, entry),
                     lim_entry_record(sorter, entry), &screen, NULL))
        return false;
    const struct lim_edge_shape *shape = &whole.shape;
    sorter->newell->polygons[entry].has_extent = false;
    sorter->newell->polygons[entry].rect =
        (struct lim_rect){piece_within(shape->left, w_px), piece_within(shape->top, h_px),
                          piece_within(shape->right, w_px), piece_within(shape->bottom, h_px)};
    return true;
}

bool lim_piece_bounds(struct lim_sorter *sorter, uint16_t entry)
{
    return lim_piece_rect(sorter, entry) && find_bounds(sorter, entry, lim_entry_is_cut(sorter, entry));
}

#endif
