/* SPDX-License-Identifier: MIT
 *
 * Which pixels of a line a piece has, where numbers are at their worst: polygons that the eye sees at a grazing angle,
 * cut so that all but a sliver lies on one side. And which samples, by frames of polygons that pass through each other.
 * Both on a screen that is no square, compared with rays. */
#include "colour.h"
#include "limner.h"
#include "pieces/trace.h"
#include "rigs/cmocka_ready.h"
#include "rigs/plain_lines.h"
#include "rigs/random.h"
#include "rigs/set_rig.h"
#include "screen/project.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 40, ROUNDS = 3000, WHOLE = 0, CUTTER = 1, BEHIND = 2, ENTRIES = 3 };

/* To the right and down, as far as the depth ahead. */
#define TAN_X 1.5
#define TAN_Y 0.625
static const struct lim_camera camera = {.tan_x_q28 = 3u << 27, .tan_y_q28 = 5u << 25, .near_q8 = 256};

struct surface {
    double n[3], d;
};

struct stage {
    struct set set;
    struct lim lim;
    void *mem;
    struct plain_lines lines;
    uint16_t line[W_PX];
    struct surface planes[2];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double value_of(const struct surface *plane, const double at[3])
{
    return dot(plane->n, at) - plane->d;
}

static void plane_of(struct surface *plane, const int16_t (*corners)[3])
{
    double a[3], b[3], first[3];

    for (int i = 0; i < 3; i++) {
        first[i] = corners[0][i];
        a[i] = corners[1][i] - first[i];
        b[i] = corners[2][i] - first[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        plane->n[i] = a[j] * b[k] - a[k] * b[j];
    }
    plane->d = dot(plane->n, first);
}

static void turn_over(int16_t (*corners)[3], int count)
{
    for (int k = 0; k < count / 2; k++)
        for (int i = 0; i < 3; i++) {
            const int16_t other = corners[count - 1 - k][i];
            corners[count - 1 - k][i] = corners[k][i];
            corners[k][i] = other;
        }
}

/* A long strip that begins beside the eye, and how it leads on. false: its plane goes through the eye, or nearly. */
static bool make_strip(int16_t corners[4][3], struct random *random)
{
    int16_t aside[3], ahead[3], beside[3];
    struct surface plane;

    for (int i = 0; i < 3; i++) {
        const int reach = i < 2 ? 900 : 200;
        aside[i] = (int16_t)(2 * random_in(random, -reach, reach));
        ahead[i] = (int16_t)random_in(random, -600, 600);
        beside[i] = (int16_t)random_in(random, -5, 5);
    }
    ahead[2] = (int16_t)random_in(random, -3800, -1500);
    for (int i = 0; i < 3; i++) {
        corners[0][i] = (int16_t)(beside[i] - aside[i] / 2);
        corners[1][i] = (int16_t)(corners[0][i] + aside[i]);
        corners[2][i] = (int16_t)(corners[1][i] + ahead[i]);
        corners[3][i] = (int16_t)(corners[0][i] + ahead[i]);
    }
    plane_of(&plane, (const int16_t(*)[3])corners);
    const double length = sqrt(dot(plane.n, plane.n));
    if (length < 1e5 || fabs(plane.d) < length / 64) return false;
    if (plane.d > 0) turn_over(corners, 4);
    return true;
}

/* A triangle whose plane cuts off a part of the strip at one end, or at one corner, of up to 2^bits units. */
static void make_cutter(int16_t cutter[3][3], const int16_t corners[4][3], struct random *random)
{
    const int end = (int)random_in(random, 0, 3);
    const int16_t *near[2] = {corners[end], corners[(end + 1) & 3]},
                  *far[2] = {corners[(end + 3) & 3], corners[(end + 2) & 3]};

    for (int k = 0; k < 2; k++) {
        const double part = ldexp((double)random_in(random, 1, 64), (int)random_in(random, -18, -7));
        for (int i = 0; i < 3; i++)
            cutter[k][i] = (int16_t)lround(near[k][i] + part * (far[k][i] - near[k][i]));
    }
    for (int i = 0; i < 3; i++)
        cutter[2][i] = (int16_t)(cutter[0][i] + random_in(random, -300, 300));
    if (random_in(random, 0, 1)) turn_over(cutter, 3);
}

/* Both orders of the cutter's corners, so that the sliver is now in front of its plane and now behind it. */
static bool make_pair(struct stage *stage, struct random *random)
{
    int16_t corners[4][3], cutter[3][3];
    bool front = false, back = false;

    set_init(&stage->set);
    if (!make_strip(corners, random)) return false;
    make_cutter(cutter, (const int16_t(*)[3])corners, random);
    plane_of(&stage->planes[WHOLE], (const int16_t(*)[3])corners);
    plane_of(&stage->planes[CUTTER], (const int16_t(*)[3])cutter);
    const double *n = stage->planes[CUTTER].n;
    for (int k = 0; k < 4; k++) {
        const double at[3] = {corners[k][0], corners[k][1], corners[k][2]};
        const double value = value_of(&stage->planes[CUTTER], at);
        const double slack = fabs(n[0]) + fabs(n[1]) + fabs(n[2]);
        front |= value > slack / 16;
        back |= value < -slack / 16;
    }
    if (!front || !back) return false;
    set_add(&stage->set, 2, 3, (const int16_t(*)[3])cutter);
    set_add(&stage->set, 1, 4, (const int16_t(*)[3])corners);
    return true;
}

/* The strip's part in front of the cutter, the cutter, and the part behind it. */
static void list_pieces(struct lim *lim)
{
    struct lim_sorter *sorter = lim->sorter;
    struct lim_newell *newell = sorter->newell;

    for (int i = 0; i < ENTRIES; i++) {
        const lim_index record = i == CUTTER ? 0 : (lim_index)lim_record_words(lim->pass.scene->polygons[0]);
        const uint16_t cut = i == WHOLE ? 0 : i == BEHIND ? 1 : LIM_NONE;
        sorter->list[i] = (struct lim_sorted){.record = record, .next = LIM_NONE};
        newell->polygons[i] = (struct lim_newell_polygon){.cuts = cut};
    }
    newell->cuts[0] = (struct lim_cut){LIM_NONE, CUTTER | LIM_CUT_FRONT};
    newell->cuts[1] = (struct lim_cut){LIM_NONE, CUTTER};
    newell->cuts_used = 2;
    sorter->used = ENTRIES;
}

static void stage_open(struct stage *stage, struct random *random)
{
    stage->lines.pixels = stage->line;
    const struct lim_target target = plain_lines_target(&stage->lines, W_PX, H_PX, LIM_NEWELL);

    while (!make_pair(stage, random)) {
    }
    const size_t mem_b = lim_mem_b(&stage->set.scene, &target);
    stage->mem = malloc(mem_b);
    assert_non_null(stage->mem);
    assert_int_equal(lim_init(&stage->lim, &stage->set.scene, &target, stage->mem, mem_b), LIM_OK);
    assert_int_equal(lim_frame(&stage->lim, &camera), LIM_OK);
    list_pieces(&stage->lim);
}

/* Where the way through a place of the screen, from its upper left corner, meets a plane. */
static void meet(double at[3], const struct surface *plane, double x_px, double y_px)
{
    const double ray[3] = {(2 * x_px - W_PX) / W_PX * TAN_X, (H_PX - 2 * y_px) / H_PX * TAN_Y, -1};
    const double far = plane->d / dot(plane->n, ray);

    for (int i = 0; i < 3; i++)
        at[i] = ray[i] * far;
}

/* Where on the strip that is: in front of the cutter's plane, 1, or behind it, -1. */
static int side_at(const struct stage *stage, double x_px, double y_px)
{
    double at[3];

    meet(at, &stage->planes[WHOLE], x_px, y_px);

    return value_of(&stage->planes[CUTTER], at) >= 0 ? 1 : -1;
}

/* 0: it is too near to call. */
static int certain_side_at(const struct stage *stage, int x_px, int y_px)
{
    const double off_px = 1.0 / 1024;
    const int side = side_at(stage, x_px + 0.5, y_px + 0.5);

    for (int k = 0; k < 4; k++) {
        const double x = x_px + 0.5 + (k & 1 ? off_px : -off_px), y = y_px + 0.5 + (k & 2 ? off_px : -off_px);
        if (side_at(stage, x, y) != side) return 0;
    }
    return side;
}

static const lim_index *record_of_whole(const struct stage *stage)
{
    return &stage->set.polygons[stage->lim.sorter->list[WHOLE].record];
}

static bool has(struct lim_point line, int x_px)
{
    return x_px >= line.x && x_px < line.y;
}

struct found {
    size_t front, back, unsure;
};

static void check_line(struct stage *stage, const struct lim_screen_polygon *whole, int16_t y, struct found *found)
{
    struct lim_newell_polygon *polygons = stage->lim.sorter->newell->polygons;
    const struct lim_point front = lim_piece_line(stage->lim.sorter, WHOLE, whole, y);
    const struct lim_point back = lim_piece_line(stage->lim.sorter, BEHIND, whole, y);

    polygons[WHOLE].cuts = LIM_NONE;
    const struct lim_point all = lim_piece_line(stage->lim.sorter, WHOLE, whole, y);
    polygons[WHOLE].cuts = 0;
    assert_true(all.x >= 0 && all.y <= W_PX);
    for (int x = 0; x < W_PX; x++) {
        assert_int_equal(has(front, x) + has(back, x), has(all, x));
        if (!has(all, x)) continue;
        const int side = certain_side_at(stage, x, y);
        if (side) assert_int_equal(side, has(front, x) ? 1 : -1);
        found->front += side > 0;
        found->back += side < 0;
        found->unsure += side == 0;
    }
}

static void slivers_seen_at_grazing_angles_have_their_pixels_only(void **state)
{
    static struct stage stage;
    struct random random = {511};
    struct found found = {0};

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        const struct lim_rect screen = {0, 0, W_PX, H_PX};
        struct lim_screen_polygon whole;
        stage_open(&stage, &random);
        if (lim_project(&whole, &stage.lim.pass.view, stage.lim.pass.scene, record_of_whole(&stage), &screen, NULL) &&
            !whole.shape.non_monotone)
            for (int16_t y = whole.shape.top > 0 ? whole.shape.top : 0; y < whole.shape.bottom && y < H_PX; y++)
                check_line(&stage, &whole, y, &found);
        free(stage.mem);
    }
    print_message("# %zu in front, %zu behind, %zu unsure\n", found.front, found.back, found.unsure);
    assert_true(found.front > ROUNDS && found.back > ROUNDS);
    assert_true(found.unsure < (found.front + found.back) / 20);
}

/* A wall ahead, cut by a plane that goes through the eye and through the middle of a column, or of a line: that is in
 * front, whichever side is. */
static void pixels_on_a_plane_are_in_front_of_it(void **state)
{
    enum { ODD_PX = 33, MIDDLE_PX = ODD_PX / 2 };
    static const int16_t wall[4][3] = {{-1900, -900, -800}, {1900, -900, -800}, {1900, 900, -800}, {-1900, 900, -800}};
    static const struct lim_rect screen = {0, 0, ODD_PX, ODD_PX};
    static struct stage stage;

    (void)state;
    for (int k = 0; k < 4; k++) {
        const bool is_level = k & 1, is_turned = k & 2; /* in front is what is above or to the right */
        int16_t cutter[3][3] = {{0, 0, -100}, {0, 0, -500}, {0, 70, -100}};
        stage.lines.pixels = stage.line;
        const struct lim_target target = plain_lines_target(&stage.lines, ODD_PX, ODD_PX, LIM_NEWELL);
        struct lim_screen_polygon whole;
        if (is_level) cutter[2][0] = 70, cutter[2][1] = 0;
        if (is_turned) turn_over(cutter, 3);
        set_init(&stage.set);
        set_add(&stage.set, 2, 3, (const int16_t(*)[3])cutter);
        set_add(&stage.set, 1, 4, wall);
        plane_of(&stage.planes[CUTTER], (const int16_t(*)[3])cutter);
        const size_t mem_b = lim_mem_b(&stage.set.scene, &target);
        stage.mem = malloc(mem_b);
        assert_non_null(stage.mem);
        assert_int_equal(lim_init(&stage.lim, &stage.set.scene, &target, stage.mem, mem_b), LIM_OK);
        assert_int_equal(lim_frame(&stage.lim, &camera), LIM_OK);
        list_pieces(&stage.lim);
        assert_true(
            lim_project(&whole, &stage.lim.pass.view, stage.lim.pass.scene, record_of_whole(&stage), &screen, NULL));
        for (int16_t y = 0; y < ODD_PX; y++) {
            const struct lim_point front = lim_piece_line(stage.lim.sorter, WHOLE, &whole, y);
            const struct lim_point back = lim_piece_line(stage.lim.sorter, BEHIND, &whole, y);
            for (int x = 0; x < ODD_PX; x++) {
                const int to = is_level ? MIDDLE_PX - y : x - MIDDLE_PX;
                const double sign = stage.planes[CUTTER].n[is_level];
                assert_int_equal(has(front, x), to * sign >= 0);
                assert_int_equal(has(back, x), to * sign < 0);
            }
        }
        free(stage.mem);
    }
}

/* Samples ------------------------------------------------------------------------------------ */

enum { BARS = 4, BAR_CORNERS = 4, SCENES = 16, SAMPLES = 16 };

struct bars {
    struct set set;
    struct surface planes[BARS];
    double corners[BARS][BAR_CORNERS][3];
};

struct canvas {
    uint16_t pixels[H_PX][W_PX];
};

/* A parallelogram some 2000 units ahead that faces the eye. */
static void make_bar(int16_t corners[BAR_CORNERS][3], struct random *random)
{
    struct surface plane;

    do {
        for (int i = 0; i < 3; i++) {
            const int reach = i == 0 ? 1300 : i == 1 ? 500 : 300;
            const int16_t centre = (int16_t)(random_in(random, -reach / 2, reach / 2) - (i == 2 ? 2000 : 0));
            const int16_t along = (int16_t)random_in(random, -reach, reach);
            const int16_t across = (int16_t)random_in(random, -reach, reach);
            corners[0][i] = (int16_t)(centre - along - across / 2);
            corners[1][i] = (int16_t)(corners[0][i] + along * 2);
            corners[2][i] = (int16_t)(corners[1][i] + across);
            corners[3][i] = (int16_t)(corners[0][i] + across);
        }
        plane_of(&plane, (const int16_t(*)[3])corners);
    } while (fabs(plane.d) < 700 * sqrt(dot(plane.n, plane.n)) || dot(plane.n, plane.n) < 1e10);
    if (plane.d > 0) turn_over(corners, BAR_CORNERS);
}

/* Whether no corner of a bar is so near to another's plane that it counts as on it. */
static bool are_clear(const struct bars *bars)
{
    for (int plane = 0; plane < BARS; plane++) {
        const double *n = bars->planes[plane].n;
        for (int k = 0; k < BARS * BAR_CORNERS; k++) {
            const double value = value_of(&bars->planes[plane], bars->corners[k / BAR_CORNERS][k % BAR_CORNERS]);
            if (k / BAR_CORNERS != plane && fabs(value) < 2 * (fabs(n[0]) + fabs(n[1]) + fabs(n[2]))) return false;
        }
    }
    return true;
}

static void make_bars(struct bars *bars, uint8_t alpha, struct random *random)
{
    static const uint16_t colours[BARS] = {0xF800, 0x07E0, 0x001F, 0xFFFF};

    do {
        set_init(&bars->set);
        bars->set.alpha = alpha;
        for (int b = 0; b < BARS; b++) {
            int16_t corners[BAR_CORNERS][3];
            make_bar(corners, random);
            set_add(&bars->set, colours[b], BAR_CORNERS, (const int16_t(*)[3])corners);
            plane_of(&bars->planes[b], (const int16_t(*)[3])corners);
            for (int k = 0; k < BAR_CORNERS; k++)
                for (int i = 0; i < 3; i++)
                    bars->corners[b][k][i] = corners[k][i];
        }
    } while (!are_clear(bars));
}

/* Counter-clockwise: its normal is the way in from each side, turned by a quarter. */
static bool is_on_bar(const struct bars *bars, int b, const double at[3])
{
    const double *n = bars->planes[b].n;

    for (int k = 0; k < BAR_CORNERS; k++) {
        const double *from = bars->corners[b][k], *to = bars->corners[b][(k + 1) % BAR_CORNERS];
        double volume = 0;
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            volume += n[i] * ((to[j] - from[j]) * (at[l] - from[l]) - (to[l] - from[l]) * (at[j] - from[j]));
        }
        if (volume < 0) return false;
    }
    return true;
}

/* The bar that is seen at a place of the screen; BARS: none. */
static int seen_at(const struct bars *bars, double x_px, double y_px)
{
    double nearest = INFINITY;
    int seen = BARS;

    for (int b = 0; b < BARS; b++) {
        double at[3];
        meet(at, &bars->planes[b], x_px, y_px);
        if (-at[2] >= nearest || !is_on_bar(bars, b, at)) continue;
        nearest = -at[2];
        seen = b;
    }
    return seen;
}

/* The same of all that is a 128th of a pixel around it; -1: they are not all the same. */
static int certainly_seen_at(const struct bars *bars, double x_px, double y_px)
{
    const double off_px = 1.0 / 128;
    const int seen = seen_at(bars, x_px, y_px);

    for (int k = 0; k < 4; k++)
        if (seen_at(bars, x_px + (k & 1 ? off_px : -off_px), y_px + (k & 2 ? off_px : -off_px)) != seen) return -1;
    return seen;
}

/* Of a pixel's samples those of which it is certain what they show, by what that is. */
static int count_samples(const struct bars *bars, int x_px, int y_px, int shown[BARS + 1])
{
    static const int shifts[4] = {1, 3, 0, 2};
    int certain = 0;

    memset(shown, 0, (BARS + 1) * sizeof *shown);
    for (int k = 0; k < SAMPLES; k++) {
        const double x = x_px + (4 * (k & 3) + shifts[k >> 2] + 0.5) / 16, y = y_px + ((k >> 2) + 0.5) / 4;
        const int seen = certainly_seen_at(bars, x, y);
        if (seen < 0) continue;
        shown[seen]++;
        certain++;
    }
    return certain;
}

/* What a channel has of samples that show it at its greatest, and those that are not certain may or may not. */
static void check_channel(unsigned value, unsigned most, int samples, int uncertain)
{
    const double found = (double)value * SAMPLES / most, rounding = 0.51 * SAMPLES / most;

    assert_true(found >= samples - rounding && found <= samples + uncertain + rounding);
}

/* How many pixels show more than one. */
static size_t check_samples(const struct bars *bars, const struct canvas *canvas)
{
    size_t mixed = 0;

    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++) {
            int shown[BARS + 1];
            const uint16_t pixel = lim_memory_colour(canvas->pixels[y][x]);
            const int certain = count_samples(bars, x, y, shown), uncertain = SAMPLES - certain;
            check_channel(pixel >> 11, 31, shown[0] + shown[3], uncertain);
            check_channel(pixel >> 5 & 63, 63, shown[1] + shown[3], uncertain);
            check_channel(pixel & 31, 31, shown[2] + shown[3], uncertain);
            mixed += certain > SAMPLES - 3 && shown[0] < certain && shown[1] < certain && shown[2] < certain &&
                     shown[3] < certain && shown[BARS] < certain;
        }
    return mixed;
}

static struct lim_stats draw(const struct set *set, bool is_smooth, struct canvas *canvas)
{
    static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(W_PX) / 4];
    struct plain_lines lines = {canvas->pixels[0], W_PX};
    const struct lim_target target = plain_lines_target(&lines, W_PX, H_PX, LIM_NEWELL);
    const size_t mem_b = lim_mem_b(&set->scene, &target);
    void *mem = malloc(mem_b);
    static struct lim lim;

    assert_non_null(mem);
    memset(canvas, 0xA5, sizeof *canvas);
    assert_int_equal(lim_init(&lim, &set->scene, &target, mem, mem_b), LIM_OK);
    if (is_smooth) assert_int_equal(lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem), LIM_OK);
    assert_int_equal(lim_frame(&lim, &camera), LIM_OK);
    free(mem);
    return *lim_stats(&lim);
}

/* With all the memory that it wants, and with the least, line by line. */
static void pieces_have_the_samples_on_their_side(void **state)
{
    static struct bars bars;
    struct random random = {512};
    size_t mixed = 0, splits = 0, alone = 0;

    (void)state;
    for (int scene = 0; scene < SCENES; scene++) {
        static struct canvas plenty, least;
        make_bars(&bars, 0, &random);
        const struct lim_stats stats = draw(&bars.set, true, &plenty);
        assert_int_equal(stats.newell.forced, 0);
        mixed += check_samples(&bars, &plenty);
        splits += stats.newell.splits;
        bars.set.scene.limits = (struct lim_limits){1, 4, 0, 0, 0, bars.set.scene.limits.pieces, 0, 0, 0};
        alone += draw(&bars.set, true, &least).bands;
        assert_memory_equal(plenty.pixels, least.pixels, sizeof plenty.pixels);
    }
    print_message("# %zu splits, %zu mixed pixels, %zu bands\n", splits, mixed, alone);
    assert_true(splits > 2 * SCENES && mixed > 100 * SCENES && alone > 10 * SCENES);
}

/* Behind a hole --------------------------------------------------------------------------------- */

enum { WALL_Z = -600, WALL_COLOUR = 0x7BEF };

/* x0 <= x < x1 .. in pixels, a wall's. */
static void add_wall(struct set *set, int x0, int y0, int x1, int y1)
{
    const int x_px[4] = {x0, x1, x1, x0}, y_px[4] = {y1, y1, y0, y0};
    int16_t corners[4][3];

    for (int k = 0; k < 4; k++) {
        corners[k][0] = (int16_t)lround((2.0 * x_px[k] - W_PX) / W_PX * TAN_X * -WALL_Z);
        corners[k][1] = (int16_t)lround((H_PX - 2.0 * y_px[k]) / H_PX * TAN_Y * -WALL_Z);
        corners[k][2] = WALL_Z;
    }
    set_add(set, WALL_COLOUR, 4, (const int16_t(*)[3])corners);
}

/* All that is farther on is hidden but for a hole. */
static void add_wall_with_hole(struct set *set, const struct lim_rect *hole)
{
    set->alpha = 0;
    add_wall(set, -1, -1, hole->x0, H_PX + 1);
    add_wall(set, hole->x1, -1, W_PX + 1, H_PX + 1);
    add_wall(set, hole->x0, -1, hole->x1, hole->y0);
    add_wall(set, hole->x0, hole->y1, hole->x1, H_PX + 1);
}

static struct lim_rect any_hole(struct random *random)
{
    const int x_px = (int)random_in(random, 8, W_PX - 12), y_px = (int)random_in(random, 4, H_PX - 8);
    const int w_px = (int)random_in(random, 1, 4), h_px = (int)random_in(random, 1, 4);

    return (struct lim_rect){(uint16_t)x_px, (uint16_t)y_px, (uint16_t)(x_px + w_px), (uint16_t)(y_px + h_px)};
}

/* Antialiased the hole's edge may show the wall. Returns how many pixels there show glass, certain or not. */
static int check_hole(const struct bars *bars, const struct canvas *canvas, const struct lim_rect *hole, bool is_smooth,
                      size_t *certain)
{
    const int margin_px = is_smooth;
    int glass = 0;

    for (int y = hole->y0; y < hole->y1; y++)
        for (int x = hole->x0; x < hole->x1; x++) {
            const uint16_t pixel = lim_memory_colour(canvas->pixels[y][x]);
            const int seen = certainly_seen_at(bars, x + 0.5, y + 0.5);
            int shown[BARS + 1];
            const bool is_all = count_samples(bars, x, y, shown) == SAMPLES;
            const bool is_clear = is_smooth ? is_all && shown[BARS] == SAMPLES : seen == BARS;
            const bool is_glass = is_smooth ? is_all && !shown[BARS] : seen >= 0 && seen < BARS;
            glass += !is_all || shown[BARS] < SAMPLES;
            if (x < hole->x0 + margin_px || x >= hole->x1 - margin_px) continue;
            if (y < hole->y0 + margin_px || y >= hole->y1 - margin_px) continue;
            if (is_clear) assert_int_equal(pixel, 0);
            if (is_glass) assert_int_not_equal(pixel, 0);
            *certain += is_glass;
        }
    return glass;
}

/* Pieces of glass are there where a wall leaves some of them open, and are no work where it does not. */
static void pieces_of_glass_are_seen_through_a_hole(void **state)
{
    enum { HOLES = 400, WALLS = 4 };
    static struct bars bars;
    struct random random = {513};
    size_t glass = 0, splits = 0, clear = 0;

    (void)state;
    for (int k = 0; k < HOLES; k++) {
        static struct canvas canvas;
        const bool is_smooth = k % 4 == 0;
        const struct lim_rect hole = any_hole(&random);
        make_bars(&bars, 100, &random);
        add_wall_with_hole(&bars.set, &hole);
        bars.set.scene.limits.layers = 200;
        const struct lim_stats stats = draw(&bars.set, is_smooth, &canvas);
        assert_int_equal(stats.bands, 0);
        splits += stats.newell.splits;
        if (check_hole(&bars, &canvas, &hole, is_smooth, &glass)) continue;
        assert_int_equal(stats.polygons_seen, WALLS);
        clear++;
    }
    print_message("# %zu splits, %zu pixels of glass, %zu holes without\n", splits, glass, clear);
    assert_true(splits > HOLES && glass > HOLES / 2 && clear > HOLES / 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slivers_seen_at_grazing_angles_have_their_pixels_only),
        cmocka_unit_test(pixels_on_a_plane_are_in_front_of_it),
        cmocka_unit_test(pieces_have_the_samples_on_their_side),
        cmocka_unit_test(pieces_of_glass_are_seen_through_a_hole),
    };

    return cmocka_run_group_tests_name("trace", tests, NULL, NULL);
}
