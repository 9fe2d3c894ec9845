/* SPDX-License-Identifier: MIT
 *
 * Back to front into a framebuffer: the least code, and the reference for the other order. Where the target names its
 * framebuffer polygons are painted there (framebuffer.c); else every line is lent once for the background, once for
 * each polygon that crosses it. All are done at the end. Nearest first comes here with single lines that are too
 * transparent for its pools: this order needs none. */
#include "orders/order.h"

#include "lines/framebuffer.h"
#include "lines/wireframe.h"
#include "pieces/piece.h"
#include "pixels/fill.h"
#include "screen/project.h"

#if LIM_HAS_PAINTER || LIM_HAS_FALLBACK

/* The line that nearest first could not finish, or NULL. */
static uint16_t *lent_of(const struct lim *lim)
{
#if LIM_HAS_FALLBACK
    return lim->paint.lent;
#else
    (void)lim;
    return NULL;
#endif
}

static void set_lent(struct lim *lim, uint16_t *line)
{
#if LIM_HAS_FALLBACK
    lim->paint.lent = line;
#else
    (void)lim, (void)line;
#endif
}

#if LIM_HAS_PAINTER
size_t lim_painter_mem_b(const struct lim_scene *scene)
{
    return LIM_PAINTER_MEM_B(scene->limits.depth) + lim_portals_mem_b(scene);
}

void lim_painter_init(struct lim *lim, void *mem)
{
    struct lim_view_cached *cache = mem;

    lim->stack = (struct lim_walk_pending *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);
    set_lent(lim, NULL);
    lim_lend_portals(lim, lim->stack + lim->scene->limits.depth);
    lim_view_init(&lim->view, lim->target.w_px, lim->target.h_px, cache);
}
#endif

static uint16_t *line_at(struct lim *lim, uint16_t y)
{
    uint16_t *const lent = lent_of(lim);

#if LIM_HAS_FRAMEBUFFER
    if (lim->fills) return lim_framebuffer_line(&lim->target.framebuffer, y);
#endif
    return lent ? lent : lim->target.lend(lim->target.ctx, y);
}

static int fill_piece(struct lim *lim, const struct lim_textured_span *span, uint16_t x0, uint16_t x1,
                      const struct lim_screen_polygon *polygon)
{
    uint16_t *line = line_at(lim, (uint16_t)span->y);

    if (!line) return LIM_ERR_TARGET;
    if (LIM_HAS_WIREFRAME && lim_wireframe_of(lim)) {
        const struct lim_wire wire = lim_wire_of(polygon, lim_wireframe_of(lim), lim_background_of(lim), span->y);
        lim_wire_fill(line, &wire, x0, x1);
    } else if (LIM_HAS_TRANSPARENT && lim_alpha_of(polygon) != LIM_OPAQUE)
        lim_blend(line, x0, (uint16_t)(x1 - x0), polygon->colour, lim_alpha_of(polygon));
    else if (LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE)
        lim_texture_fill(span, line, x0, x1, lim_stats_of(lim));
    else
        lim_fill(line, x0, (uint16_t)(x1 - x0), polygon->colour);
    return 0;
}

/* `span`: the polygon's pixels on the line, before anything is cut off. */
static int fill_clamped(struct lim *lim, const struct lim_textured_span *span, const struct lim_screen_polygon *polygon)
{
    const int16_t w_px = (int16_t)lim->target.w_px;
    const int16_t x0 = span->left < 0 ? 0 : span->left, x1 = span->right > w_px ? w_px : span->right;

    if (x0 >= x1) return 0;
    if (LIM_HAS_STATS) lim_stats_of(lim)->pixels_painted += (uint32_t)(x1 - x0);
    return fill_piece(lim, span, (uint16_t)x0, (uint16_t)x1, polygon);
}

static void begin_texture(struct lim *lim, const struct lim_screen_polygon *polygon, struct lim_gradients *gradients)
{
    if (LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE)
        lim_texture_set(lim_texturing_of(lim), lim_screen_texture(polygon), gradients);
}

static int paint_plain(struct lim *lim, const struct lim_screen_polygon *polygon, const struct lim_rect *screen)
{
    const int16_t first = (int16_t)screen->y0, end = (int16_t)screen->y1;
    const int16_t bottom = polygon->shape.bottom < end ? polygon->shape.bottom : end;
    int16_t y = polygon->shape.top > first ? polygon->shape.top : first;
    struct lim_edge_pair pair;
    struct lim_gradients gradients;

    if (y >= bottom) return 0;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(bottom - y);
    begin_texture(lim, polygon, &gradients);
    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    for (;;) {
        lim_edge_advance(&pair, polygon->at, polygon->n, y);
        const struct lim_textured_span span = {lim_texturing_of(lim), &gradients, y, lim_edge_x(&pair.left),
                                               lim_edge_x(&pair.right)};
        const int err = fill_clamped(lim, &span, polygon);
        if (err) return err;
        if (++y == bottom) return 0;
    }
}

static int paint_any(struct lim *lim, const struct lim_screen_polygon *polygon, const struct lim_rect *screen)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.non_monotone) return paint_plain(lim, polygon, screen);
    for (uint8_t k = (uint8_t)(polygon->n - 2); k > 0; k--) { /* the first is on top, as in the other order */
        lim_project_fan(polygon, k, &triangle);
        const int err = paint_plain(lim, &triangle, screen);
        if (err) return err;
    }
    return 0;
}

#if LIM_HAS_PAINTER && LIM_HAS_FRAMEBUFFER
/* paint_plain() where the target has a framebuffer. */
static inline void paint_into(struct lim *lim, const struct lim_point *at, uint8_t n,
                              const struct lim_edge_shape *shape, uint16_t colour)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};
    const struct lim_span_extent shown = lim_shape_lines(shape, &screen);

    if (shown.top >= shown.bottom) return;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(shown.bottom - shown.top);
    lim_framebuffer_paint(&lim->target, at, n, shape->first, shown, colour);
}

/* A record that faces the eye, and is neither clipped nor non-monotone; `at` is for its points. false: nothing was
 * done. */
static inline bool paint_fast(struct lim *lim, const LIM_FLASH lim_index *record, struct lim_point *at)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_edge_shape shape;
    uint_fast16_t codes;

    LIM_ASSERT(n <= LIM_MAX_VERTICES);
    if (!lim_project_fast(&shape, at, n, &lim->view, lim->scene, record, &codes)) return false;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons++;
    if (!lim_view_all_outside(codes)) paint_into(lim, at, n, &shape, lim_memory_colour((uint16_t)record[1]));
    return true;
}
#endif

/* Where polygons come from, far to near: the walk through the tree, or the sorted list. */
#if LIM_HAS_TREE
/* A record that faces the eye. */
static LIM_ALONE int paint_record(struct lim *lim, const LIM_FLASH lim_index *record, const struct lim_rect *screen)
{
    struct lim_screen_polygon polygon;

#if LIM_HAS_PAINTER && LIM_HAS_FRAMEBUFFER
    if (lim->fills && paint_fast(lim, record, polygon.at)) return 0;
#endif
    if (!lim_project(&polygon, &lim->view, lim->scene, record, screen, lim_stats_of(lim))) return 0;
    return paint_any(lim, &polygon, screen);
}

enum { NOTED_RECORDS = 24 };

/* Last record first: where rounding makes neighbours in a plane overlap, the first is on top in both
 * orders. Records can only be read forward: those that face the eye are noted, and of a run that has more of them than
 * there is room for, each round paints the last ones that are left. */
static int paint_run(struct lim *lim, lim_index run, const struct lim_rect *screen)
{
    const LIM_FLASH lim_index *const first = &lim->scene->polygons[run], *painted = NULL;
    const LIM_FLASH lim_index *noted[NOTED_RECORDS];

    do {
        const LIM_FLASH lim_index *record = first, *from = first, **to = noted;
        for (;;) {
            const lim_index head = record[0];
            if (lim_record_is_seen(&lim->walk.eye, record)) {
                if (to == noted + NOTED_RECORDS) to = noted, from = record;
                *to++ = record;
            }
            if (head & LIM_POLYGON_LAST) break;
            record += lim_record_words(head);
            if (record == painted) break;
        }
        while (to != noted) {
            const int err = paint_record(lim, *--to, screen);
            if (err) return err;
        }
        painted = from;
    } while (painted != first);
    return 0;
}

static int paint_tree(struct lim *lim, const struct lim_rect *screen)
{
    lim_index run;

    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, screen);
    lim_walk_begin(&lim->walk, lim->stack, true);
    while ((run = lim_walk_next(&lim->walk, lim_cull_of(lim), lim_stats_of(lim))) != LIM_NO_INDEX) {
        const int err = paint_run(lim, run, screen);
        if (err) return err;
    }
    return 0;
}
#endif

#if (LIM_HAS_SORTED && LIM_HAS_FALLBACK) || LIM_HAS_MOVERS
/* A piece of a split polygon, on one line. */
static int paint_piece_line(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *whole, uint16_t y)
{
    const uint8_t fans = whole->shape.non_monotone ? (uint8_t)(whole->n - 2) : 1;
    struct lim_screen_polygon triangle;
    struct lim_gradients gradients;

    for (uint8_t k = fans; k > 0; k--) {
        const struct lim_screen_polygon *polygon = whole;
        if (whole->shape.non_monotone) {
            lim_project_fan(whole, k, &triangle);
            polygon = &triangle;
        }
        if (polygon->shape.top > (int16_t)y || polygon->shape.bottom <= (int16_t)y) continue;
        const struct lim_point line = lim_piece_line(lim, entry, polygon, (int16_t)y);
        const struct lim_textured_span span = {lim_texturing_of(lim), &gradients, (int16_t)y, (int16_t)line.x,
                                               (int16_t)line.y};
        begin_texture(lim, polygon, &gradients);
        const int err = fill_clamped(lim, &span, polygon);
        if (err) return err;
    }
    return 0;
}

#endif

#if LIM_HAS_MOVERS
/* The part of the screen that is painted is all of it, or a line. */
static int paint_mover(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *polygon,
                       const struct lim_rect *screen)
{
    const int16_t bottom = polygon->shape.bottom < (int16_t)screen->y1 ? polygon->shape.bottom : (int16_t)screen->y1;

    if (entry == LIM_NONE) return paint_any(lim, polygon, screen);
    for (int16_t y = polygon->shape.top > (int16_t)screen->y0 ? polygon->shape.top : (int16_t)screen->y0; y < bottom;
         y++) {
        const int err = paint_piece_line(lim, entry, polygon, (uint16_t)y);
        if (err) return err;
    }
    return 0;
}

static int paint_with_movers(struct lim *lim, const struct lim_rect *screen)
{
    struct lim_route route = lim_route_static(lim, true);
    lim_index what;

    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, screen);
    lim_route_begin(&route, lim_movers_list(lim, lim_cull_of(lim)));
    for (;;) {
        const enum lim_route_event event = lim_route_next(lim, &route, &what);
        if (event == LIM_ROUTE_END) return 0;
        const int err = event == LIM_ROUTE_RUN ? paint_run(lim, what, screen)
                                               : lim_movers_draw(lim, lim_movers_order(lim, (uint16_t)what, true),
                                                                 screen, true, paint_mover);
        if (err) return err;
    }
}
#endif

#if LIM_HAS_SORTED && LIM_HAS_FALLBACK
static int paint_list(struct lim *lim, const struct lim_rect *screen)
{
    struct lim_screen_polygon polygon;
    int err = 0;

    lim_sorted_reverse(&lim->sorter);
    for (uint16_t at = lim->sorter.first; at != LIM_NONE && !err; at = lim->sorter.list[at].next) {
        const LIM_FLASH lim_index *record = &lim->scene->polygons[lim->sorter.list[at].record];
        if (!lim_project(&polygon, &lim->view, lim->scene, record, screen, lim_stats_of(lim))) continue;
        err = LIM_HAS_NEWELL && lim_is_piece(lim, at) ? paint_piece_line(lim, at, &polygon, screen->y0)
                                                      : paint_any(lim, &polygon, screen);
    }
    lim_sorted_reverse(&lim->sorter);
    return err;
}
#endif

static int paint_from_source(struct lim *lim, const struct lim_rect *screen)
{
#if LIM_HAS_SORTED && LIM_HAS_FALLBACK
    if (LIM_IS_SORTED(&lim->target)) return paint_list(lim, screen);
#endif
#if LIM_HAS_MOVERS
    if (lim->movers.count) return paint_with_movers(lim, screen);
#endif
#if LIM_HAS_TREE
    return paint_tree(lim, screen);
#else
    (void)screen;
    return 0;
#endif
}

static int painter_paint_background(struct lim *lim, const struct lim_rect *screen)
{
    const uint16_t background = lim_background_of(lim);

    for (uint16_t y = screen->y0; y < screen->y1; y++) {
        uint16_t *line = line_at(lim, y);
        if (!line) return LIM_ERR_TARGET;
        lim_fill(line, 0, lim->target.w_px, background);
    }
    return 0;
}

/* All of some lines. */
static int paint_lines(struct lim *lim, const struct lim_rect *screen)
{
    int err = painter_paint_background(lim, screen);

    if (!err) err = paint_from_source(lim, screen);
    return err ? err : lim_target_done(&lim->target, screen);
}

int lim_painter_frame(struct lim *lim)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};

#if LIM_HAS_PAINTER && LIM_HAS_FRAMEBUFFER
    lim->fills = lim_has_framebuffer(&lim->target) && lim_can_fill(lim);
    const int err = paint_lines(lim, &screen);
    lim->fills = false;
    return err;
#else
    return paint_lines(lim, &screen);
#endif
}

int lim_painter_line(struct lim *lim, uint16_t y)
{
    const struct lim_rect screen = {0, y, lim->target.w_px, (uint16_t)(y + 1)};

    if (!lent_of(lim)) set_lent(lim, lim->target.lend(lim->target.ctx, y));
    const int err = lent_of(lim) ? paint_lines(lim, &screen) : LIM_ERR_TARGET;
    set_lent(lim, NULL);
    return err;
}

#endif
