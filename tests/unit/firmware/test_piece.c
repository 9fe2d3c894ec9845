/* SPDX-License-Identifier: MIT
 *
 * Pieces of polygons, each function alone, on lists that are made by hand. What a piece has of a line is compared with
 * the rays through its pixels, its corners with cutting in doubles, overlaps with separating axes on the screen. */
#include "limner.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/newell.h"
#include "pieces/piece.h"
#include "pieces/trace.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"
#include "screen/project.h"
#include "view/plane_unpacked.h"

#include <math.h>
#include <string.h>

enum { ROUNDS = 600, MOST = 6, ROOM = 40, CORNERS_MAX = 32 };

struct polygon {
    int16_t corners[4][3];
    int count;
    double n[3], d; /* n . p = d, n towards the eye */
};

/* Some polygons, each an entry of the list, whole, with the name of its number. */
struct stage {
    struct set set;
    struct set_view view;
    struct polygon polygons[MOST];
    int count;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double value_of(const struct polygon *plane, const double at[3])
{
    return dot(plane->n, at) - plane->d;
}

static void set_plane(struct polygon *polygon)
{
    double a[3], b[3], first[3];

    for (int i = 0; i < 3; i++) {
        first[i] = polygon->corners[0][i];
        a[i] = polygon->corners[1][i] - first[i];
        b[i] = polygon->corners[2][i] - first[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        polygon->n[i] = a[j] * b[k] - a[k] * b[j];
    }
    polygon->d = dot(polygon->n, first);
}

/* A triangle or a parallelogram in view, seen from the origin, and not nearly edge-on; 2^bits times as small, and as
 * near. With its first corner in a given place, if there is one. */
static void make_polygon(struct polygon *polygon, struct random *random, int bits, const int16_t *first)
{
    do {
        int16_t centre[3], u[3], v[3];
        for (int i = 0; i < 3; i++) {
            centre[i] = (int16_t)random_in(random, -(500 >> bits), 500 >> bits);
            u[i] = (int16_t)random_in(random, -(1200 >> bits), 1200 >> bits);
            v[i] = (int16_t)random_in(random, -(1200 >> bits), 1200 >> bits);
        }
        centre[2] = (int16_t)(centre[2] - (2000 >> bits));
        polygon->count = (int)random_in(random, 3, 4);
        for (int i = 0; i < 3; i++) {
            polygon->corners[0][i] = (int16_t)(first ? first[i] : centre[i] - u[i] / 2 - v[i] / 2);
            polygon->corners[1][i] = (int16_t)(polygon->corners[0][i] + u[i]);
            polygon->corners[2][i] = (int16_t)(polygon->corners[1][i] + v[i]);
            polygon->corners[3][i] = (int16_t)(polygon->corners[0][i] + v[i]);
        }
        set_plane(polygon);
    } while (polygon->d > -0.2 * (2000 >> bits) * sqrt(dot(polygon->n, polygon->n)) ||
             dot(polygon->n, polygon->n) < ldexp(1e10, -4 * bits) || polygon->corners[1][2] > -(600 >> bits) ||
             polygon->corners[2][2] > -(600 >> bits) || polygon->corners[3][2] > -(600 >> bits));
}

/* All entries whole again, as in the records' order. false: one has no pixel. */
static bool stage_list(struct stage *stage)
{
    struct lim *lim = &stage->view.lim;
    lim_index at = 0;

    lim->sorter->used = (uint16_t)stage->count;
    lim->sorter->newell->cuts_used = 0;
    for (int i = 0; i < stage->count; i++) {
        const lim_index *record = &stage->set.polygons[at];
        lim->sorter->list[i] = (struct lim_sorted){.record = at, .next = LIM_NONE};
        if (!lim_newell_add(lim->sorter, (uint16_t)i, 0, 0, true)) return false;
        at = (lim_index)(at + lim_record_words(record[0]));
    }
    return true;
}

/* At random far and large, or near and small; the second one's plane often goes through a corner of the first. */
static bool stage_try(struct stage *stage, int count, struct random *random)
{
    const int bits = (int)random_in(random, 0, 2) * 3;
    const bool touches = random_in(random, 0, 1);
    const struct lim_camera camera = set_camera(false);

    set_init(&stage->set);
    stage->count = count;
    for (int i = 0; i < count; i++) {
        struct polygon *polygon = &stage->polygons[i];
        make_polygon(polygon, random, bits, touches && i == 1 ? stage->polygons[0].corners[2] : NULL);
        set_add(&stage->set, (lim_index)(i + 1), polygon->count, (const int16_t(*)[3])polygon->corners);
    }
    set_draw(&stage->set, LIM_NEWELL, NULL, ROOM, &camera, &stage->view);
    if (stage_list(stage)) return true;
    set_view_free(&stage->view);
    return false;
}

static void stage_open(struct stage *stage, int count, struct random *random)
{
    while (!stage_try(stage, count, random)) {
    }
}

static void stage_close(struct stage *stage)
{
    set_view_free(&stage->view);
}

/* Corners in doubles ------------------------------------------------------------------------- */

struct corners {
    int n;
    double at[CORNERS_MAX][3];
};

static void corners_of(struct corners *corners, const struct polygon *polygon)
{
    corners->n = polygon->count;
    for (int k = 0; k < polygon->count; k++) {
        for (int i = 0; i < 3; i++)
            corners->at[k][i] = polygon->corners[k][i];
    }
}

static void cut_corners(struct corners *corners, const struct polygon *plane, bool front)
{
    const struct corners from = *corners;

    corners->n = 0;
    for (int k = 0; k < from.n; k++) {
        const double *a = from.at[(k + from.n - 1) % from.n], *b = from.at[k];
        const double va = value_of(plane, a), vb = value_of(plane, b);
        if ((va < 0 && vb > 0) || (va > 0 && vb < 0)) {
            for (int i = 0; i < 3; i++)
                corners->at[corners->n][i] = a[i] + (b[i] - a[i]) * va / (va - vb);
            corners->n++;
        }
        if (front ? vb >= 0 : vb <= 0) memcpy(corners->at[corners->n++], b, sizeof corners->at[0]);
    }
}

/* Whether the plane is clear of all corners but those just on it: then nothing hangs on how a corner was rounded. */
static bool is_clear(const struct corners *corners, const struct polygon *plane)
{
    const double clear = 3 * sqrt(dot(plane->n, plane->n));
    bool front = false, back = false;

    for (int k = 0; k < corners->n; k++) {
        const double value = value_of(plane, corners->at[k]);
        if (value != 0 && fabs(value) < clear) return false;
        front |= value > 0;
        back |= value < 0;
    }
    return front && back;
}

static void assert_corners(const struct lim_corners *corners, const struct corners *expected, double off_q12)
{
    assert_non_null(corners);
    assert_int_equal(corners->n, expected->n);
    for (int k = 0; k < expected->n; k++) {
        for (int i = 0; i < 3; i++)
            assert_true(fabs(corners->at_q12[k][i] - expected->at[k][i] * 4096) <= off_q12);
    }
}

/* Pixels ------------------------------------------------------------------------------------- */

/* On which side of a plane the way through a place of the screen meets a polygon: 1, -1. */
static int side_at(const struct polygon *polygon, const struct polygon *plane, double x_px, double y_px)
{
    const double half_px = SET_SIDE_PX / 2.0;
    const double ray[3] = {(x_px + 0.5 - half_px) / half_px, -(y_px + 0.5 - half_px) / half_px, -1};
    const double far = polygon->d / dot(polygon->n, ray);
    const double at[3] = {ray[0] * far, ray[1] * far, ray[2] * far};

    return value_of(plane, at) >= 0 ? 1 : -1;
}

/* 0: it is too near to call. */
static int certain_side_at(const struct polygon *polygon, const struct polygon *plane, int x_px, int y_px)
{
    const double off_px = 1.0 / 64;
    const int side = side_at(polygon, plane, x_px, y_px);

    for (int k = 0; k < 4; k++)
        if (side_at(polygon, plane, x_px + (k & 1 ? off_px : -off_px), y_px + (k & 2 ? off_px : -off_px)) != side)
            return 0;
    return side;
}

static bool has(struct lim_point line, int x_px)
{
    return x_px >= line.x && x_px < line.y;
}

static void project_whole(struct stage *stage, uint16_t entry, struct lim_screen_polygon *whole)
{
    const struct lim_rect screen = {0, 0, SET_SIDE_PX, SET_SIDE_PX};
    struct lim *lim = &stage->view.lim;

    assert_true(lim_project(whole, &lim->pass.view, lim->pass.scene,
                            &lim->pass.scene->polygons[lim->sorter->list[entry].record], &screen, NULL));
}

/* The lines of one polygon and of its pieces, and of some cut once more: each pixel of the whole is in one of them, and
 * in that on whose side it is. */
static size_t check_lines(struct stage *stage, const uint16_t *pieces, int count)
{
    const struct lim *lim = &stage->view.lim;
    const struct lim_newell *newell = lim->sorter->newell;
    struct lim_screen_polygon whole;
    size_t certain = 0;

    project_whole(stage, pieces[0], &whole);
    for (int y = whole.shape.top > 0 ? whole.shape.top : 0; y < whole.shape.bottom && y < SET_SIDE_PX; y++) {
        struct lim_point lines[4], line;
        for (int k = 0; k < count; k++)
            lines[k] = lim_piece_line(lim->sorter, pieces[k], &whole, (int16_t)y);
        const uint16_t cuts = newell->polygons[pieces[0]].cuts;
        newell->polygons[pieces[0]].cuts = LIM_NONE;
        line = lim_piece_line(lim->sorter, pieces[0], &whole, (int16_t)y);
        newell->polygons[pieces[0]].cuts = cuts;
        for (int x = 0; x < SET_SIDE_PX; x++) {
            int in = 0;
            for (int k = 0; k < count; k++)
                in += has(lines[k], x);
            assert_int_equal(in, has(line, x));
            for (int k = 0; k < count; k++)
                for (uint16_t cut = newell->polygons[pieces[k]].cuts; has(lines[k], x) && cut != LIM_NONE;
                     cut = newell->cuts[cut].next) {
                    const uint16_t by = newell->cuts[cut].by;
                    const int side = certain_side_at(&stage->polygons[0], &stage->polygons[by & LIM_SORTED_MAX], x, y);
                    certain += side != 0;
                    assert_int_not_equal(side, by & LIM_CUT_FRONT ? -1 : 1);
                }
        }
    }
    return certain;
}

/* What is known of a piece: depths to a few units of the view, a rectangle that holds it and a pixel more. */
static void check_known(const struct stage *stage, uint16_t entry, const struct corners *corners)
{
    const struct lim *lim = &stage->view.lim;
    const struct lim_newell_polygon *polygon = &lim->sorter->newell->polygons[entry];
    const double scale = -(double)lim->pass.view.rows.row[2].n_qv[2];
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};

    for (int k = 0; k < corners->n; k++) {
        const double *at = corners->at[k];
        const double seen[3] = {(1 + at[0] / -at[2]) * SET_SIDE_PX / 2, (1 + at[1] / at[2]) * SET_SIDE_PX / 2, -at[2]};
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], seen[i]);
            high[i] = fmax(high[i], seen[i]);
        }
    }
    assert_true(fabs(polygon->near_qv - low[2] * scale) <= scale / 1000 + 2);
    assert_true(fabs(lim->sorter->list[entry].far_qv - high[2] * scale) <= scale / 1000 + 2);
    for (int i = 0; i < 2; i++) {
        const uint16_t from = i ? polygon->rect.y0 : polygon->rect.x0, to = i ? polygon->rect.y1 : polygon->rect.x1;
        if (high[i] - low[i] < 3 || high[0] < 3 || high[1] < 3 || low[0] > SET_SIDE_PX - 3 || low[1] > SET_SIDE_PX - 3)
            continue;
        /* Pixels whose centres are within, and one more on each side. */
        assert_true(from <= fmax(0, ceil(low[i] - 0.45)) && from >= ceil(low[i] - 0.55) - 1);
        assert_true(to >= fmin(SET_SIDE_PX, ceil(high[i] - 0.55)) && to <= fmax(0, ceil(high[i] - 0.45)) + 1);
    }
}

/* Tests -------------------------------------------------------------------------------------- */

static void pieces_have_the_pixels_on_their_side(void **state)
{
    static struct stage stage;
    struct random random = {501};
    size_t certain = 0;
    int splits = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct corners front, back;
        stage_open(&stage, 3, &random);
        corners_of(&front, &stage.polygons[0]);
        back = front;
        if (is_clear(&front, &stage.polygons[1])) {
            struct lim *lim = &stage.view.lim;
            uint16_t pieces[3] = {0, lim_piece_split(lim->sorter, 0, 1)};
            assert_int_equal(pieces[1], 3);
            cut_corners(&front, &stage.polygons[1], true);
            cut_corners(&back, &stage.polygons[1], false);
            check_known(&stage, pieces[0], &front);
            check_known(&stage, pieces[1], &back);
            certain += check_lines(&stage, pieces, 2);
            if (is_clear(&back, &stage.polygons[2])) {
                pieces[2] = lim_piece_split(lim->sorter, pieces[1], 2);
                assert_int_equal(pieces[2], 4);
                certain += check_lines(&stage, pieces, 3);
            }
            splits++;
        }
        stage_close(&stage);
    }
    assert_true(splits > ROUNDS / 4 && certain > (size_t)splits * 200);
}

static void corners_are_where_planes_cut(void **state)
{
    static struct stage stage;
    struct random random = {502};
    int cuts = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_corners places[2];
        struct lim_plane_unpacked plane;
        struct corners corners;
        stage_open(&stage, 3, &random);
        const struct lim *lim = &stage.view.lim;
        for (int front = 0; front < 2; front++) {
            assert_true(stage_list(&stage));
            corners_of(&corners, &stage.polygons[0]);
            assert_corners(lim_corners_of(lim->sorter, 0, places), &corners, 0);
            if (!is_clear(&corners, &stage.polygons[1])) continue;
            cut_corners(&corners, &stage.polygons[1], front);
            lim_plane_load(&plane, lim->sorter, 1);
            assert_corners(lim_corners_cut(lim->sorter, 0, &plane, front, places), &corners, 1.01);
            if (!is_clear(&corners, &stage.polygons[2])) continue;
            lim->sorter->newell->cuts[0] = (struct lim_cut){LIM_NONE, (uint16_t)(1 | (front ? LIM_CUT_FRONT : 0))};
            lim->sorter->newell->polygons[0].cuts = 0;
            assert_corners(lim_corners_of(lim->sorter, 0, places), &corners, 1.01);
            cut_corners(&corners, &stage.polygons[2], !front);
            lim_plane_load(&plane, lim->sorter, 2);
            assert_corners(lim_corners_cut(lim->sorter, 0, &plane, !front, places), &corners, 40);
            cuts++;
        }
        stage_close(&stage);
    }
    assert_true(cuts > ROUNDS / 8);
}

/* On either side of a plane, or on it: what crosses it has a corner there, on both sides. */
static void corners_are_added_where_the_plane_is_crossed(void **state)
{
    enum { VALUES = 5, CASES = VALUES * VALUES * VALUES };
    static const struct lim_plane_unpacked along_x = {.n = {1, 0, 0}, .slack = 1, .narrow = true, .axis = 0};
    static struct stage stage;
    struct random random = {507};

    (void)state;
    stage_open(&stage, 1, &random);
    stage.set.polygons[0] = (lim_index)((stage.set.polygons[0] & ~LIM_POLYGON_COUNT) | 3u);
    for (int k = 0; k < CASES; k++)
        for (int front = 0; front < 2; front++) {
            const int x[3] = {k % VALUES - 2, k / VALUES % VALUES - 2, k / VALUES / VALUES - 2};
            struct lim_corners places[2];
            int expected = 0;
            for (int i = 0; i < 3; i++) {
                stage.set.vertices[i].x = (int16_t)x[i];
                expected += (front ? x[i] >= 0 : x[i] <= 0) + (x[i] * x[(i + 1) % 3] < 0);
            }
            const struct lim_corners *corners = lim_corners_cut(stage.view.lim.sorter, 0, &along_x, front, places);
            assert_int_equal(corners ? corners->n : 0, expected < 3 ? 0 : expected);
            for (int i = 0; corners && i < expected; i++)
                assert_true(front ? corners->at_q12[i][0] >= 0 : corners->at_q12[i][0] <= 0);
        }
    stage_close(&stage);
}

/* The scene's limit and what cuts may add, of which a corner may bring two: one more than it has need be. */
static void polygons_have_as_many_corners_as_cuts_may_add(void **state)
{
    static const struct lim_plane_unpacked along_x = {.n = {1, 0, 0}, .slack = 1, .narrow = true, .axis = 0};
    static struct stage stage;
    struct random random = {508};

    (void)state;
    stage_open(&stage, 1, &random);
    for (uint16_t limit = 0; limit < 8; limit++)
        for (int n = 3; n < LIM_CUT_VERTICES + 8; n++) {
            struct lim_corners places[2];
            stage.set.scene.limits.vertices = limit;
            stage.set.polygons[0] = (lim_index)n;
            for (int k = 0; k < n; k++) {
                stage.set.vertices[k] = (struct lim_vertex){7, (int16_t)(k * k), (int16_t)k};
                stage.set.polygons[LIM_POLYGON_HEAD_WORDS + k] = (lim_index)k;
            }
            const struct lim_corners *corners = lim_corners_cut(stage.view.lim.sorter, 0, &along_x, true, places);
            assert_int_equal(corners != NULL, n < limit + LIM_CUT_VERTICES);
            if (corners) assert_int_equal(corners->n, n);
        }
    stage_close(&stage);
}

/* Whatever its corners say. */
static void what_was_cut_to_a_side_is_on_it(void **state)
{
    static struct stage stage;
    struct random random = {503};

    (void)state;
    for (int round = 0; round < 40; round++) {
        stage_open(&stage, 4, &random);
        struct lim *lim = &stage.view.lim;
        struct lim_newell *newell = lim->sorter->newell;
        newell->cuts[0] = (struct lim_cut){LIM_NONE, 1 | LIM_CUT_FRONT};
        newell->cuts[1] = (struct lim_cut){0, 2};
        newell->cuts[2] = (struct lim_cut){LIM_NONE, 1};
        newell->cuts_used = 3;
        newell->polygons[0].cuts = 1;
        assert_int_equal(lim_piece_sides(lim->sorter, 0, 1), LIM_SIDE_FRONT);
        assert_int_equal(lim_piece_sides(lim->sorter, 0, 2), LIM_SIDE_BACK);
        newell->polygons[0].cuts = 2;
        assert_int_equal(lim_piece_sides(lim->sorter, 0, 1), LIM_SIDE_BACK);
        stage_close(&stage);
    }
}

/* Vertices within the sum of a plane's normal are on it. */
static void sides_are_those_of_corners(void **state)
{
    static struct stage stage;
    struct random random = {504};
    int found[4] = {0};

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        stage_open(&stage, 4, &random);
        const struct lim *lim = &stage.view.lim;
        for (uint16_t of = 0; of < 4; of++)
            for (uint16_t by = 0; by < 4; by++) {
                const struct polygon *plane = &stage.polygons[by];
                const double slack = fabs(plane->n[0]) + fabs(plane->n[1]) + fabs(plane->n[2]);
                struct corners corners;
                int expected = 0;
                corners_of(&corners, &stage.polygons[of]);
                for (int k = 0; k < corners.n; k++) {
                    const double value = value_of(plane, corners.at[k]);
                    expected |= value > slack ? LIM_SIDE_FRONT : value < -slack ? LIM_SIDE_BACK : 0;
                }
                assert_int_equal(lim_piece_sides(lim->sorter, of, by), expected);
                found[expected]++;
            }
        stage_close(&stage);
    }
    for (int sides = 0; sides < 4; sides++)
        assert_true(found[sides] > ROUNDS / 4);
}

/* What of it reaches 5 units before the plane x = 0 is cut off, and the rest lies on that: it is before the plane, as
 * the whole is. */
static void sides_are_the_wholes_as_long_as_they_decide(void **state)
{
    enum { OF, CUT, BY, POLYGONS };
    static const int16_t by[3][3] = {{0, 0, -1200}, {0, 90, -1200}, {0, 0, -1100}};     /* faces along x */
    static const int16_t cutter[3][3] = {{0, 1, -1200}, {0, 1, -1100}, {90, 1, -1200}}; /* faces up */
    static struct stage stage;
    const struct lim_camera camera = set_camera(false);

    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const int16_t whole[3][3] = {{0, 0, -1200}, {0, 10, -1200}, {(int16_t)(5 * sign), 10, -1200}};
        set_init(&stage.set);
        set_add(&stage.set, 1, 3, whole);
        set_add(&stage.set, 2, 3, cutter);
        set_add(&stage.set, 3, 3, by);
        set_draw(&stage.set, LIM_NEWELL, NULL, ROOM, &camera, &stage.view);
        struct lim_sorter *const sorter = stage.view.lim.sorter;
        for (lim_index i = 0; i < POLYGONS; i++) {
            const lim_index words = (lim_index)lim_record_words(stage.set.polygons[0]);
            sorter->list[i] = (struct lim_sorted){.record = i * words, .next = LIM_NONE};
            sorter->newell->polygons[i] = (struct lim_newell_polygon){.cuts = LIM_NONE};
        }
        sorter->newell->cuts[0] = (struct lim_cut){LIM_NONE, CUT};
        sorter->newell->polygons[OF].cuts = 0;
        assert_int_equal(lim_piece_sides(sorter, OF, BY), sign > 0 ? LIM_SIDE_FRONT : LIM_SIDE_BACK);
        set_view_free(&stage.view);
    }
}

static void a_split_takes_what_room_there_is_and_no_more(void **state)
{
    static struct stage stage;
    struct random random = {505};
    int splits = 0;

    (void)state;
    for (int round = 0; round < 60; round++) {
        struct corners corners;
        stage_open(&stage, 2, &random);
        corners_of(&corners, &stage.polygons[0]);
        struct lim_sorter *sorter = stage.view.lim.sorter;
        if (is_clear(&corners, &stage.polygons[1])) {
            const uint16_t cut_size = sorter->newell->cut_size, size = sorter->size;
            sorter->newell->cut_size = 1;
            assert_int_equal(lim_piece_split(stage.view.lim.sorter, 0, 1), LIM_NONE);
            sorter->newell->cut_size = cut_size;
            sorter->size = 2;
            assert_int_equal(lim_piece_split(stage.view.lim.sorter, 0, 1), LIM_NONE);
            sorter->size = 3;
            sorter->newell->cut_size = 2;
            assert_int_equal(sorter->newell->polygons[0].cuts, LIM_NONE);
            assert_int_equal(lim_piece_split(stage.view.lim.sorter, 0, 1), 2);
            assert_int_equal(sorter->used, 3);
            assert_int_equal(sorter->newell->cuts_used, 2);
            assert_int_equal(sorter->newell->cuts[sorter->newell->polygons[0].cuts].by, 1 | LIM_CUT_FRONT);
            assert_int_equal(sorter->newell->cuts[sorter->newell->polygons[2].cuts].by, 1);
            assert_false(lim_piece_has_room(stage.view.lim.sorter));
            sorter->newell->cut_size = cut_size;
            sorter->size = size;
            splits++;
        }
        stage_close(&stage);
    }
    assert_true(splits > 15);
}

/* On the screen, in pixels, of corners that are before the eye. */
struct outline {
    int n;
    double at[CORNERS_MAX][2];
};

static void outline_of(struct outline *outline, const struct corners *corners)
{
    outline->n = corners->n;
    for (int k = 0; k < corners->n; k++) {
        outline->at[k][0] = corners->at[k][0] / -corners->at[k][2] * (SET_SIDE_PX / 2.0);
        outline->at[k][1] = corners->at[k][1] / corners->at[k][2] * (SET_SIDE_PX / 2.0);
    }
}

/* The widest gap between the two across an edge of the first; negative: how deep they overlap there. */
static double gap_px(const struct outline *a, const struct outline *b)
{
    double widest = -INFINITY;

    for (int k = 0; k < a->n; k++) {
        const double *from = a->at[k], *to = a->at[(k + 1) % a->n];
        const double dx = to[0] - from[0], dy = to[1] - from[1], length = hypot(dx, dy);
        double inner = INFINITY;
        if (length < 1) continue;
        for (int i = 0; i < b->n; i++) /* corners run counter-clockwise, y down */
            inner = fmin(inner, (dx * (b->at[i][1] - from[1]) - dy * (b->at[i][0] - from[0])) / length);
        widest = fmax(widest, inner);
    }
    return widest;
}

static void what_overlaps_on_the_screen_is_found(void **state)
{
    static struct stage stage;
    struct random random = {506};
    int apart = 0, overlapping = 0;

    (void)state;
    for (int round = 0; round < ROUNDS * 2; round++) {
        struct corners corners[2];
        struct outline outlines[2];
        const uint8_t part = (uint8_t)random_in(&random, LIM_SIDE_FRONT, LIM_SIDE_BOTH);
        stage_open(&stage, 2, &random);
        corners_of(&corners[0], &stage.polygons[0]);
        corners_of(&corners[1], &stage.polygons[1]);
        if (part == LIM_SIDE_BOTH || is_clear(&corners[0], &stage.polygons[1])) {
            if (part != LIM_SIDE_BOTH) cut_corners(&corners[0], &stage.polygons[1], part == LIM_SIDE_FRONT);
            outline_of(&outlines[0], &corners[0]);
            outline_of(&outlines[1], &corners[1]);
            const double gap = fmax(gap_px(&outlines[0], &outlines[1]), gap_px(&outlines[1], &outlines[0]));
            const bool overlaps = lim_piece_overlaps(stage.view.lim.sorter, 0, 1, part);
            if (gap > 0.1) assert_false(overlaps);
            if (gap < -0.1) assert_true(overlaps);
            apart += gap > 0.1;
            overlapping += gap < -0.1;
        }
        stage_close(&stage);
    }
    assert_true(apart > 20 && overlapping > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_have_the_pixels_on_their_side),
        cmocka_unit_test(corners_are_where_planes_cut),
        cmocka_unit_test(corners_are_added_where_the_plane_is_crossed),
        cmocka_unit_test(polygons_have_as_many_corners_as_cuts_may_add),
        cmocka_unit_test(what_was_cut_to_a_side_is_on_it),
        cmocka_unit_test(sides_are_those_of_corners),
        cmocka_unit_test(sides_are_the_wholes_as_long_as_they_decide),
        cmocka_unit_test(a_split_takes_what_room_there_is_and_no_more),
        cmocka_unit_test(what_overlaps_on_the_screen_is_found),
    };

    return cmocka_run_group_tests_name("piece", tests, NULL, NULL);
}
