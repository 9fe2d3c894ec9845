/* SPDX-License-Identifier: MIT
 *
 * A scan-line algorithm. The faces of a convex solid that the eye sees lie side by side, but for a pixel here
 * and there that rounding gives to two of them: so each line is painted back to front, over its background,
 * and hardly a pixel twice. Such a pixel stays with the face that nearest first would have met first: both orders
 * paint the same, on slivers as well.
 *
 * A face for which the pool has no room is projected anew for each of its lines. */
#include "orders/order.h"

#include "lines/wireframe.h"

#if LIM_HAS_CONVEX

size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, uint16_t active)
{
    return LIM_CONVEX_MEM_B(target->h_px, scene->polygon_count, active);
}

void lim_convex_init(struct lim *lim, void *mem, size_t mem_b)
{
    struct lim_convex *convex = &lim->convex;
    const lim_index polygon_count = lim->scene->polygon_count;
    struct lim_view_cached *cache = mem;

    convex->tops = (uint16_t *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);
    convex->pool = (struct lim_crossing *)(void *)((uint8_t *)mem + LIM_CONVEX_POOL_AT_B(lim->target.h_px));
    convex->faces = (struct lim_face *)(void *)((uint8_t *)mem + (mem_b & ~(size_t)3)) - polygon_count;
    lim_view_init(&lim->view, lim->target.w_px, lim->target.h_px, cache);
}

static bool convex_project(struct lim *lim, struct lim_screen_polygon *polygon, lim_index record,
                           struct lim_stats *stats)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};

    return lim_project(polygon, &lim->view, lim->scene, &lim->scene->polygons[record], &screen, stats);
}

/* Pass one: which faces there are, and where they start ------------------------------------------- */

/* Faces come from near to far: each is put before those that start on the same line. */
static void note_face(struct lim_convex *convex, lim_index record, int16_t top)
{
    uint16_t *start = &convex->tops[top > 0 ? top : 0];

    convex->faces[--convex->farthest] = (struct lim_face){.record = record, .next = *start, .crossing = LIM_NONE};
    *start = convex->farthest;
}

static void note_run(struct lim *lim, struct lim_screen_polygon *polygon, lim_index record)
{
    for (;;) {
        const lim_index head = lim->scene->polygons[record];
        if (convex_project(lim, polygon, record, lim_stats_of(lim)))
            note_face(&lim->convex, record, polygon->shape.top);
        if (head & LIM_POLYGON_LAST) return;
        record = (lim_index)(record + lim_record_words(head));
    }
}

static void note_faces(struct lim *lim, struct lim_screen_polygon *polygon)
{
    for (uint_fast16_t i = 0; i < lim->scene->node_count; i++) {
        const LIM_FLASH struct lim_node *node = &lim->scene->nodes[i];
        const int32_t side = lim_eye_side(lim_eye_of(lim), &node->split);
        const lim_index run = side > 0 ? node->front_run : node->back_run;
        if (LIM_HAS_STATS) lim_stats_of(lim)->nodes++;
        if (side && run != LIM_NO_INDEX) note_run(lim, polygon, run);
    }
}

/* Pass two: the faces that cross a line ----------------------------------------------------------- */

static LIM_RARE void begin(struct lim *lim, struct lim_crossing *crossing)
{
#if LIM_HAS_TEXTURE
    if (crossing->polygon.texture != LIM_NONE)
        lim_texture_set(&lim->texturing, crossing->polygon.texture, &crossing->gradients);
#else
    (void)lim;
#endif
    lim_edge_begin(&crossing->pair, crossing->polygon.n, crossing->polygon.shape.first);
}

/* false: it is of one colour. */
static bool fill_textured(struct lim *lim, uint16_t *line, const struct lim_crossing *crossing, int16_t y, int16_t x0,
                          int16_t x1)
{
#if LIM_HAS_TEXTURE
    const struct lim_textured_span span = {&lim->texturing, &crossing->gradients, y, lim_edge_x(&crossing->pair.left),
                                           lim_edge_x(&crossing->pair.right)};

    if (crossing->polygon.texture == LIM_NONE) return false;
    lim_texture_fill(&span, line, (uint16_t)x0, (uint16_t)x1, lim_stats_of(lim));
    return true;
#else
    (void)lim, (void)line, (void)crossing, (void)y, (void)x0, (void)x1;
    return false;
#endif
}

/* The polygon's pixels on line y: its first one, or that below the last. */
static void fill_next(struct lim *lim, uint16_t *line, struct lim_crossing *crossing, int16_t y)
{
    lim_edge_advance(&crossing->pair, crossing->polygon.at, crossing->polygon.n, y);
    const int16_t w_px = (int16_t)lim->target.w_px, left = lim_edge_x(&crossing->pair.left);
    const int16_t right = lim_edge_x(&crossing->pair.right);
    const int16_t x0 = left > 0 ? left : 0, x1 = right < w_px ? right : w_px;
    if (x0 >= x1) return;
    if (LIM_HAS_WIREFRAME && lim_wireframe_of(lim)) {
        struct lim_wire wire = lim_wire_of(&crossing->polygon, lim_wireframe_of(lim), lim_background_of(lim), y);
#if LIM_HAS_RUNS
        wire.target = &lim->target;
#endif
        lim_wire_fill(line, &wire, (uint16_t)x0, (uint16_t)x1);
    } else if (!fill_textured(lim, line, crossing, y, x0, x1)) {
        lim_fill_run(&lim->target, line, (uint16_t)y, (uint16_t)x0, (uint16_t)(x1 - x0), crossing->polygon.colour);
    }
    if (LIM_HAS_STATS) lim_stats_of(lim)->pixels_painted += (uint32_t)(x1 - x0);
}

/* A non-monotone face: its triangles begin anew on each line. */
static LIM_RARE void fill_fan(struct lim *lim, uint16_t *line, const struct lim_crossing *face, int16_t y)
{
    const struct lim_screen_polygon *non_monotone = &face->polygon;
    struct lim_crossing triangle;

    for (uint_fast8_t k = 1; k + 1u < non_monotone->n; k++) {
        lim_project_fan(non_monotone, (uint8_t)(LIM_HAS_WIREFRAME ? non_monotone->n - 1u - k : k), &triangle.polygon);
        if (y < triangle.polygon.shape.top || y >= triangle.polygon.shape.bottom) continue;
        begin(lim, &triangle);
        fill_next(lim, line, &triangle, y);
    }
}

/* The pool has the room that the frame's faces leave. */
static bool has_room(const struct lim_convex *convex)
{
    const uint8_t *const end = (const uint8_t *)&convex->faces[convex->farthest];

    return (size_t)(end - (const uint8_t *)&convex->pool[convex->pool_used]) >= sizeof(struct lim_crossing);
}

/* Projects a face that has no entry: into a free one, which is then its own, or else into `spare`. */
static struct lim_crossing *convex_enter(struct lim *lim, struct lim_face *face, struct lim_crossing *spare, int16_t y)
{
    struct lim_convex *convex = &lim->convex;
    struct lim_crossing *crossing = spare;
    uint_fast16_t i = 0;

    while (i < convex->pool_used && convex->pool[i].polygon.shape.bottom > y)
        i++;
    if (i < convex->pool_used || has_room(convex)) {
        if (i == convex->pool_used) convex->pool_used++;
        crossing = &convex->pool[i];
        face->crossing = (uint16_t)i;
    }
    if (LIM_HAS_STATS && crossing == spare) lim_stats_of(lim)->bands++;
    (void)convex_project(lim, &crossing->polygon, face->record, NULL);
    begin(lim, crossing);
    return crossing;
}

static void note_seen(struct lim *lim, struct lim_face *face, uint32_t painted_before)
{
#if LIM_HAS_STATS
    if (face->seen || lim->stats.pixels_painted == painted_before) return;
    face->seen = true;
    lim->stats.polygons_seen++;
#else
    (void)lim, (void)face, (void)painted_before;
#endif
}

/* false: line y is its last. */
static bool paint_face(struct lim *lim, uint16_t *line, struct lim_face *face, struct lim_crossing *spare, int16_t y)
{
    const uint32_t painted_before = LIM_HAS_STATS ? lim_stats_of(lim)->pixels_painted : 0;
    const bool has_entry = face->crossing != LIM_NONE;
    struct lim_crossing *crossing = has_entry ? &lim->convex.pool[face->crossing] : convex_enter(lim, face, spare, y);
    const struct lim_edge_shape *shape = &crossing->polygon.shape;

    if (shape->non_monotone)
        fill_fan(lim, line, crossing, y);
    else
        fill_next(lim, line, crossing, y);
    note_seen(lim, face, painted_before);
    return shape->bottom > y + 1;
}

/* The faces that cross the line, and among them those that start on it, from far to near: by their indices.
 * Returns how many there are. */
static uint16_t paint_faces(struct lim *lim, uint16_t *line, struct lim_crossing *spare, uint16_t y)
{
    struct lim_convex *convex = &lim->convex;
    uint16_t *link = &convex->first, start = convex->tops[y], count = 0;

    for (;; count++) {
        if (start < *link) {
            const uint16_t next = convex->faces[start].next;
            convex->faces[start].next = *link;
            *link = start;
            start = next;
        }
        if (*link == LIM_NONE) return count;
        struct lim_face *face = &convex->faces[*link];
        if (paint_face(lim, line, face, spare, (int16_t)y))
            link = &face->next;
        else
            *link = face->next;
    }
}

/* What no face has painted is background, as long as no two have painted the same. */
static void note_line(struct lim *lim, uint16_t count, uint32_t painted_before)
{
    struct lim_stats *stats = lim_stats_of(lim);
    const uint32_t painted = stats->pixels_painted - painted_before, w_px = lim->target.w_px;

    stats->pixels_background += painted < w_px ? w_px - painted : 0;
    stats->lines += count;
    if (count > stats->active_max) stats->active_max = count;
}

/* Whether the target has no memory for lines, and needs none. */
static bool takes_runs(const struct lim *lim)
{
#if LIM_HAS_RUNS
    return !LIM_HAS_LINES || (lim->target.put_run && !lim_texture_count(lim->scene));
#else
    (void)lim;
    return false;
#endif
}

static int draw_line(struct lim *lim, struct lim_crossing *spare, uint16_t y)
{
    const uint32_t painted_before = LIM_HAS_STATS ? lim_stats_of(lim)->pixels_painted : 0;
    const uint16_t w_px = lim->target.w_px;
    uint16_t *line = takes_runs(lim) ? NULL : lim->target.lend(lim->target.ctx, y);

    if (!line && !takes_runs(lim)) return LIM_ERR_TARGET;
    lim_fill_run(&lim->target, line, y, 0, w_px, lim_background_of(lim));
    const uint16_t count = paint_faces(lim, line, spare, y);
    if (LIM_HAS_STATS) note_line(lim, count, painted_before);
    return lim->target.done(lim->target.ctx, y, 0, w_px);
}

static void convex_start(struct lim_convex *convex, const struct lim *lim)
{
    for (uint_fast16_t y = 0; y < lim->target.h_px; y++)
        convex->tops[y] = LIM_NONE;
    convex->farthest = (uint16_t)lim->scene->polygon_count;
    convex->first = LIM_NONE;
    convex->pool_used = 0;
}

int lim_convex_frame(struct lim *lim)
{
    struct lim_crossing spare;

    convex_start(&lim->convex, lim);
    note_faces(lim, &spare.polygon);
    for (uint_fast16_t y = 0; y < lim->target.h_px; y++) {
        const int err = draw_line(lim, &spare, (uint16_t)y);
        if (err) return err;
    }
    return 0;
}

#endif
