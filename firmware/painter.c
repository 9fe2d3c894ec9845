/* SPDX-License-Identifier: MIT
 *
 * Back to front into a framebuffer: the least code, and the reference for the other order. Every
 * line is lent once for the background, once for each polygon that crosses it, and is done at the
 * end. */
#include "order.h"

#include "fill.h"
#include "project.h"

#if LIM_HAS_PAINTER

size_t lim_painter_mem_b(const struct lim_scene *scene)
{
    return LIM_PAINTER_MEM_B(scene->limits.depth);
}

void lim_painter_init(struct lim *lim, void *mem)
{
    struct lim_view_cached *cache = mem;

    lim->stack = (struct lim_walk_pending *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);
    lim_view_init(&lim->view, lim->target.w_px, lim->target.h_px, cache);
}

static int fill_piece(struct lim *lim, uint16_t y, uint16_t x0, uint16_t x1, uint16_t colour)
{
    uint16_t *line = lim->target.lend(lim->target.ctx, y);

    if (!line) return LIM_ERR_TARGET;
    lim_fill(line, x0, (uint16_t)(x1 - x0), colour);
    return 0;
}

static int fill_clamped(struct lim *lim, int16_t y, int16_t x0, int16_t x1, uint16_t colour)
{
    const int16_t w_px = (int16_t)lim->target.w_px;

    if (x0 < 0) x0 = 0;
    if (x1 > w_px) x1 = w_px;
    if (x0 >= x1) return 0;
    if (LIM_HAS_STATS) lim_stats_of(lim)->pixels_painted += (uint32_t)(x1 - x0);
    return fill_piece(lim, (uint16_t)y, (uint16_t)x0, (uint16_t)x1, colour);
}

static int paint_plain(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    const int16_t h_px = (int16_t)lim->target.h_px;
    const int16_t bottom = polygon->shape.bottom < h_px ? polygon->shape.bottom : h_px;
    int16_t y = polygon->shape.top > 0 ? polygon->shape.top : 0;
    struct lim_edge_pair pair;

    if (y >= bottom) return 0;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(bottom - y);
    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    for (;;) {
        lim_edge_advance(&pair, polygon->at, polygon->n, y);
        const int err = fill_clamped(lim, y, pair.left.x, pair.right.x, polygon->colour);
        if (err) return err;
        if (++y == bottom) return 0;
    }
}

static int paint_any(struct lim *lim, const struct lim_screen_polygon *polygon)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.folded) return paint_plain(lim, polygon);
    for (uint8_t k = 1; k + 1 < polygon->n; k++) {
        lim_project_fan(polygon, k, &triangle);
        const int err = paint_plain(lim, &triangle);
        if (err) return err;
    }
    return 0;
}

static const LIM_FLASH uint16_t *record_after(const LIM_FLASH uint16_t *record)
{
    return record + lim_record_words(record[0]);
}

/* Last record first: where rounding makes neighbours in a plane overlap, the first is on top in both
 * orders. Records can only be read forward, so each is found anew. */
static int paint_run(struct lim *lim, uint16_t run, const struct lim_rect *screen)
{
    const LIM_FLASH uint16_t *const first = &lim->scene->polygons[run];
    const LIM_FLASH uint16_t *record = first, *end;
    struct lim_screen_polygon polygon;

    while (!(record[0] & LIM_POLYGON_LAST))
        record = record_after(record);
    for (;;) {
        if (lim_record_is_seen(&lim->walk.eye, record) &&
            lim_project(&polygon, &lim->view, lim->scene, record, screen, lim_stats_of(lim))) {
            const int err = paint_any(lim, &polygon);
            if (err) return err;
        }
        if (record == first) return 0;
        end = record;
        for (record = first; record_after(record) != end;)
            record = record_after(record);
    }
}

static int paint_background(struct lim *lim)
{
    const uint16_t background = lim_memory_colour(lim->scene->background);

    for (uint16_t y = 0; y < lim->target.h_px; y++) {
        const int err = fill_piece(lim, y, 0, lim->target.w_px, background);
        if (err) return err;
    }
    return 0;
}

static int finish(struct lim *lim)
{
    for (uint16_t y = 0; y < lim->target.h_px; y++) {
        const int err = lim->target.done(lim->target.ctx, y, 0, lim->target.w_px);
        if (err) return err;
    }
    return 0;
}

int lim_painter_frame(struct lim *lim)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};
    uint16_t run;
    int err = paint_background(lim);

    if (err) return err;
    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(lim), &lim->view, lim_eye_of(lim)->at_q8, &screen);
    lim_walk_begin(&lim->walk, lim->stack, true);
    while ((run = lim_walk_next(&lim->walk, lim_cull_of(lim), lim_stats_of(lim))) != LIM_NONE) {
        err = paint_run(lim, run, &screen);
        if (err) return err;
    }
    return finish(lim);
}

#endif
