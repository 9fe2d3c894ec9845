/* SPDX-License-Identifier: MIT
 *
 * Back to front into a framebuffer: the least code, and the reference for the other order. Where the target names its
 * framebuffer polygons are painted there (framebuffer.c); else every line is lent once for the background, once for
 * each polygon that crosses it. All are done at the end. Nearest first comes here with single lines that are too
 * transparent for its pools: this order needs none. */
#include "orders/painter.h"

#include "eye.h"
#include "lines/framebuffer.h"
#include "lines/overlaid.h"
#include "lines/wireframe.h"
#include "pieces/entry.h"
#include "pieces/mesh_leaf.h"
#include "pieces/sorter.h"
#include "pieces/trace.h"
#include "pixels/blend.h"
#include "pixels/fill.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "screen/polygon.h"
#include "screen/project.h"
#include "view/cull.h"
#include "view/view.h"
#include "view/walk.h"

#if LIM_HAS_PAINTED

#if LIM_HAS_PAINTER
size_t lim_painter_mem_b(const struct lim_scene *scene)
{
    return LIM_PAINTER_MEM_B(scene->limits.depth) + lim_portals_mem_b(scene) + lim_mesh_leaf_mem_b(&scene->limits);
}

void lim_painter_init(struct lim_painter *painter, void *mem)
{
    struct lim_pass *pass = painter->pass;
    struct lim_view_cached *cache = mem;
    struct lim_walk_pending *stack = (struct lim_walk_pending *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);

    uint8_t *at = (uint8_t *)mem + LIM_PAINTER_MEM_B(pass->scene->limits.depth);
    if (LIM_HAS_MESH_LEAVES)
        lim_mesh_leaf_lend(*painter->leaf, lim_mem_cut(&at, lim_mesh_leaf_mem_b(&pass->scene->limits)),
                           &pass->scene->limits);
    lim_walk_lend(pass->walk, pass->scene, stack, at);
    lim_view_init(&pass->view, pass->target.w_px, pass->target.h_px, cache);
}
#endif

/* Whether polygons are painted into the target's framebuffer. A line that nearest first could not finish is lent. */
static inline bool fills_framebuffer(const struct lim_painter *painter)
{
    const struct lim_pass *pass = painter->pass;

    return lim_has_framebuffer(&pass->target) && !(LIM_HAS_FALLBACK && *painter->lent) && lim_can_fill(pass);
}

static uint16_t *line_at(struct lim_painter *painter, uint16_t y)
{
    struct lim_target *target = &painter->pass->target;

    if (LIM_HAS_PAINTER && LIM_HAS_FRAMEBUFFER && fills_framebuffer(painter))
        return lim_framebuffer_line(lim_framebuffer_of(target), y);
    return LIM_HAS_FALLBACK && *painter->lent ? *painter->lent : target->lend(target->ctx, y);
}

static int fill_piece(struct lim_painter *painter, const struct lim_textured_span *span, uint16_t x0, uint16_t x1,
                      const struct lim_screen_polygon *polygon)
{
    struct lim_pass *const pass = painter->pass;
    uint16_t *line = line_at(painter, (uint16_t)span->y);

    if (!line) return LIM_ERR_TARGET;
    if (LIM_HAS_WIREFRAME && lim_wireframe_of(pass)) {
        const struct lim_wire wire =
            lim_wire_of(polygon, lim_wireframe_of(pass), lim_background_of(pass), (int16_t)span->y);
        lim_wire_fill(line, &wire, x0, x1);
    } else if (LIM_HAS_TRANSPARENT && lim_alpha_of(polygon) != LIM_OPAQUE &&
               !(LIM_HAS_MASKED && lim_screen_texture(polygon) != LIM_NONE))
        lim_blend(line, x0, (uint16_t)(x1 - x0), polygon->colour, lim_alpha_of(polygon));
    else if (LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE)
        lim_texture_fill(span, line, x0, x1, lim_stats_of(pass));
    else
        lim_fill(line, x0, (uint16_t)(x1 - x0), polygon->colour);
    return 0;
}

/* `span`: the polygon's pixels on the line, before anything is cut off. */
static int fill_clamped(struct lim_painter *painter, const struct lim_textured_span *span,
                        const struct lim_screen_polygon *polygon)
{
    struct lim_pass *const pass = painter->pass;
    const int32_t w_px = pass->target.w_px;
    const int32_t x0 = span->left < 0 ? 0 : span->left, x1 = span->right > w_px ? w_px : span->right;

    if (x0 >= x1) return 0;
    if (LIM_HAS_STATS) lim_stats_of(pass)->pixels_painted += (uint32_t)(x1 - x0);
    return fill_piece(painter, span, (uint16_t)x0, (uint16_t)x1, polygon);
}

/* n: its corners; none of a piece. */
static void begin_texture(struct lim_painter *painter, const struct lim_screen_polygon *polygon, uint8_t n,
                          struct lim_gradients *gradients)
{
    if (LIM_HAS_TEXTURE && lim_screen_texture(polygon) != LIM_NONE)
        lim_texture_set(painter->pass->texturing, lim_screen_texture(polygon), polygon->at, n, gradients);
}

static int paint_plain(struct lim_painter *painter, const struct lim_screen_polygon *polygon,
                       const struct lim_rect *screen)
{
    const int16_t first = (int16_t)screen->y0, end = (int16_t)screen->y1;
    const int16_t bottom = polygon->shape.bottom < end ? polygon->shape.bottom : end;
    int16_t y = polygon->shape.top > first ? polygon->shape.top : first;
    struct lim_edge_pair pair;
    struct lim_gradients gradients;

    if (y >= bottom) return 0;
    if (LIM_HAS_STATS) lim_stats_of(painter->pass)->lines += (uint32_t)(bottom - y);
    begin_texture(painter, polygon, polygon->n, &gradients);
    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    for (;;) {
        lim_edge_advance(&pair, polygon->at, polygon->n, y);
        const struct lim_textured_span span = {painter->pass->texturing, &gradients, y, lim_edge_x(&pair.left),
                                               lim_edge_x(&pair.right)};
        const int err = fill_clamped(painter, &span, polygon);
        if (err) return err;
        if (++y == bottom) return 0;
    }
}

static int paint_any(struct lim_painter *painter, const struct lim_screen_polygon *polygon,
                     const struct lim_rect *screen)
{
    struct lim_screen_polygon triangle;

    if (!polygon->shape.non_monotone) return paint_plain(painter, polygon, screen);
    for (uint8_t k = (uint8_t)(polygon->n - 2); k > 0; k--) { /* the first is on top, as in the other order */
        lim_project_fan(polygon, k, &triangle);
        const int err = paint_plain(painter, &triangle, screen);
        if (err) return err;
    }
    return 0;
}

/* paint_plain() where the target has a framebuffer. */
static inline void paint_into(struct lim_pass *pass, const struct lim_point *at, uint8_t n,
                              const struct lim_edge_shape *shape, uint16_t colour)
{
    const struct lim_rect screen = {0, 0, pass->target.w_px, pass->target.h_px};
    const struct lim_span_extent shown = lim_shape_lines(shape, &screen);

    if (shown.top >= shown.bottom) return;
    if (LIM_HAS_STATS) lim_stats_of(pass)->lines += (uint32_t)(shown.bottom - shown.top);
    lim_framebuffer_paint(&pass->target, at, n, shape->first, shown, colour);
}

/* A record that faces the eye, and is neither clipped nor non-monotone. false: nothing was done. */
static LIM_ALONE LIM_IF_CALLED bool paint_fast(struct lim_pass *pass, const LIM_FLASH lim_index *record)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point at[LIM_MAX_VERTICES];
    struct lim_edge_shape shape;
    uint_fast16_t codes;

    LIM_DEBUG_ASSERT(n <= LIM_MAX_VERTICES);
    if (!lim_project_fast(&shape, at, n, &pass->view, pass->scene, record, &codes)) return false;
    if (LIM_HAS_STATS) lim_stats_of(pass)->polygons++;
    if (!lim_view_all_outside(codes)) paint_into(pass, at, n, &shape, lim_memory_colour((uint16_t)record[1]));
    return true;
}

/* Where polygons come from, far to near: the walk through the tree, or the sorted list. */

/* A record that faces the eye. */
static LIM_ALONE int paint_record(struct lim_painter *painter, const LIM_FLASH lim_index *record,
                                  const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &pass->view, pass->scene, record, screen, lim_stats_of(pass))) return 0;
    return paint_any(painter, &polygon, screen);
}

static LIM_IF_CALLED int paint_mesh_leaf(struct lim_painter *painter, const LIM_FLASH lim_index *run,
                                         const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    const struct lim_mesh_leaf_seen seen = {pass->scene, &pass->view, true};
    struct lim_screen_polygon polygon;
    const LIM_FLASH lim_index *record;
    int err = 0;

    lim_mesh_leaf_sort(*painter->leaf, &seen, run);
    while (!err && (record = lim_mesh_leaf_next(*painter->leaf)) != NULL)
        if (lim_mesh_leaf_project(&polygon, *painter->leaf, record, screen, lim_stats_of(pass)))
            err = paint_any(painter, &polygon, screen);
    return err;
}

enum { NOTED_RECORDS = 24 };

/* Last record first: where rounding makes neighbours in a plane overlap, the first is on top in both
 * orders. Records can only be read forward: those that face the eye are noted, and of a run that has more of them than
 * there is room for, each round paints the last ones that are left. */
static int paint_run(struct lim_painter *painter, lim_index run, const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    const LIM_FLASH lim_index *const first = &pass->scene->polygons[run], *painted = NULL;
    const LIM_FLASH lim_index *noted[NOTED_RECORDS];

    if (LIM_HAS_MESH_LEAVES && lim_is_mesh_leaf(first)) return paint_mesh_leaf(painter, first, screen);
    do {
        const LIM_FLASH lim_index *record = first, *from = first, **to = noted;
        for (;;) {
            const lim_index head = record[0];
            if (lim_record_is_seen(&pass->walk->eye, record)) {
                if (to == noted + NOTED_RECORDS) to = noted, from = record;
                *to++ = record;
            }
            if (head & LIM_POLYGON_LAST) break;
            record += lim_record_words(head);
            if (record == painted) break;
        }
        while (to != noted) {
            record = *--to;
            if (LIM_HAS_PAINTER && LIM_HAS_FRAMEBUFFER && fills_framebuffer(painter) && paint_fast(pass, record))
                continue;
            const int err = paint_record(painter, record, screen);
            if (err) return err;
        }
        painted = from;
    } while (painted != first);
    return 0;
}

static LIM_IF_CALLED int paint_tree(struct lim_painter *painter, const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    lim_index run;

    if (LIM_HAS_CULL) lim_cull_set(lim_cull_of(pass), &pass->view, lim_eye_of(pass)->at_q8, screen);
    lim_walk_begin(pass->walk, true);
    while ((run = lim_walk_next(pass->walk, lim_cull_of(pass), lim_stats_of(pass))) != LIM_NO_INDEX) {
        const int err = paint_run(painter, run, screen);
        if (err) return err;
    }
    return 0;
}

/* A piece of a split polygon, on one line. */
static LIM_IF_CALLED int paint_piece_line(struct lim_painter *painter, uint16_t entry,
                                          const struct lim_screen_polygon *whole, uint16_t y)
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
        const struct lim_point line = lim_piece_line(lim_painter_sorter(painter), entry, polygon, (int16_t)y);
        const struct lim_textured_span span = {painter->pass->texturing, &gradients, (int16_t)y, (int16_t)line.x,
                                               (int16_t)line.y};
        begin_texture(painter, polygon, 0, &gradients);
        const int err = fill_clamped(painter, &span, polygon);
        if (err) return err;
    }
    return 0;
}

static LIM_IF_CALLED int paint_sorted(struct lim_painter *painter, const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    struct lim_sorter *const sorter = lim_painter_sorter(painter);
    struct lim_screen_polygon polygon;
    int err = 0;

    lim_sorted_reverse(sorter);
    for (uint16_t at = sorter->first; at != LIM_NONE && !err; at = sorter->list[at].next) {
        const LIM_FLASH lim_index *record = &pass->scene->polygons[sorter->list[at].record];
        if (!lim_project(&polygon, &pass->view, pass->scene, record, screen, lim_stats_of(pass))) continue;
        err = LIM_HAS_NEWELL && lim_entry_is_split(sorter, at) ? paint_piece_line(painter, at, &polygon, screen->y0)
                                                               : paint_any(painter, &polygon, screen);
    }
    lim_sorted_reverse(sorter);
    return err;
}

static int paint_from_source(struct lim_painter *painter, const struct lim_rect *screen)
{
    if (!LIM_HAS_TREE || LIM_IS_SORTED(&painter->pass->target)) return paint_sorted(painter, screen);
    return paint_tree(painter, screen);
}

static int painter_paint_background(struct lim_painter *painter, const struct lim_rect *screen)
{
    struct lim_pass *const pass = painter->pass;
    const uint16_t background = lim_background_of(pass);

    for (uint16_t y = screen->y0; y < screen->y1; y++) {
        uint16_t *line = line_at(painter, y);
        if (!line) return LIM_ERR_TARGET;
        lim_fill(line, 0, pass->target.w_px, background);
    }
    return 0;
}

static int draw_over(struct lim_painter *painter, const struct lim_rect *screen)
{
    const struct lim_pass *const pass = painter->pass;

    for (uint16_t y = screen->y0; y < screen->y1; y++) {
        if (!lim_is_overlaid(pass, y)) continue;
        uint16_t *line = line_at(painter, y);
        if (!line) return LIM_ERR_TARGET;
        lim_overlay_line(pass, line, y, 0, pass->target.w_px);
    }
    return 0;
}

/* All of some lines. */
static int paint_lines(struct lim_painter *painter, const struct lim_rect *screen)
{
    int err = painter_paint_background(painter, screen);

    if (!err) err = paint_from_source(painter, screen);
    if (LIM_HAS_OVERLAY && !err) err = draw_over(painter, screen);
    return err ? err : lim_target_done(&painter->pass->target, screen);
}

int lim_painter_frame(struct lim_painter *painter)
{
    const struct lim_target *target = &painter->pass->target;
    const struct lim_rect screen = {0, 0, target->w_px, target->h_px};

    return paint_lines(painter, &screen);
}

#if LIM_HAS_FALLBACK
int lim_painter_line(struct lim_painter *painter, uint16_t *lent, uint16_t y)
{
    const struct lim_target *target = &painter->pass->target;
    const struct lim_rect screen = {0, y, target->w_px, (uint16_t)(y + 1)};

    *painter->lent = lent ? lent : target->lend(target->ctx, y);
    const int err = *painter->lent ? paint_lines(painter, &screen) : LIM_ERR_TARGET;
    *painter->lent = NULL;
    return err;
}
#endif

#endif
