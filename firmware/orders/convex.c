/* SPDX-License-Identifier: MIT
 *
 * A scan-line algorithm. The faces of a convex solid that the eye sees lie side by side, but for a pixel here
 * and there that rounding gives to two of them: so each line is painted back to front, over its background,
 * and hardly a pixel twice. Such a pixel stays with the face that nearest first would have met first: both orders
 * paint the same, on slivers as well.
 *
 * A face for which the pool has no room is projected anew for each of its lines. */
#include "orders/convex.h"

#include "eye.h"
#include "lines/overlaid.h"
#include "lines/wireframe.h"
#include "pixels/fill.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "screen/polygon.h"
#include "screen/project.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_CONVEX

size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, uint16_t active)
{
    return LIM_CONVEX_MEM_B(target->h_px, scene->polygon_count, active);
}

void lim_convex_init(struct lim_convex *convex, void *mem, size_t mem_b)
{
    struct lim_pass *const pass = convex->pass;
    const lim_index polygon_count = pass->scene->polygon_count;
    struct lim_view_cached *cache = mem;

    convex->tops = (uint16_t *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);
    convex->pool = (struct lim_crossing *)(void *)((uint8_t *)mem + LIM_CONVEX_POOL_AT_B(pass->target.h_px));
    convex->faces = (struct lim_face *)(void *)((uint8_t *)mem + (mem_b & ~(size_t)3)) - polygon_count;
    lim_view_init(&pass->view, pass->target.w_px, pass->target.h_px, cache);
}

static bool convex_project(struct lim_pass *pass, struct lim_screen_polygon *polygon, lim_index record,
                           struct lim_stats *stats)
{
    const struct lim_rect screen = {0, 0, pass->target.w_px, pass->target.h_px};

    return lim_project(polygon, &pass->view, pass->scene, &pass->scene->polygons[record], &screen, stats);
}

/* Pass one: which faces there are, and where they start ------------------------------------------- */

/* Faces come from near to far: each is put before those that start on the same line. */
static void note_face(struct lim_convex *convex, lim_index record, int16_t top)
{
    uint16_t *start = convex->tops;

    if (top > 0) start += top;
    convex->faces[--convex->farthest] = (struct lim_face){.record = record, .next = *start, .crossing = LIM_NONE};
    *start = convex->farthest;
}

static void note_run(struct lim_convex *convex, struct lim_pass *pass, struct lim_screen_polygon *polygon,
                     lim_index record)
{
    for (;;) {
        const lim_index head = pass->scene->polygons[record];
        if (convex_project(pass, polygon, record, lim_stats_of(pass))) note_face(convex, record, polygon->shape.top);
        if (head & LIM_POLYGON_LAST) return;
        record = (lim_index)(record + lim_record_words(head));
    }
}

static void note_faces(struct lim_convex *convex, struct lim_screen_polygon *polygon)
{
    struct lim_pass *const pass = convex->pass;

    for (uint_fast16_t i = 0; i < pass->scene->node_count; i++) {
        const LIM_FLASH struct lim_node *node = &pass->scene->nodes[i];
        const int32_t side = lim_eye_side(lim_eye_of(pass), &node->split);
        const lim_index run = side > 0 ? node->front_run : node->back_run;
        if (LIM_HAS_STATS) lim_stats_of(pass)->nodes++;
        if (side && run != LIM_NO_INDEX) note_run(convex, pass, polygon, run);
    }
}

/* Pass two: the faces that cross a line ----------------------------------------------------------- */

static LIM_RARE void begin(struct lim_convex *convex, struct lim_crossing *crossing)
{
    const uint16_t texture = lim_screen_texture(&crossing->polygon);

    if (LIM_HAS_TEXTURE && texture != LIM_NONE)
        lim_texture_set(convex->pass->texturing, texture, crossing->polygon.at, crossing->polygon.n,
                        crossing->gradients);
    lim_edge_begin(&crossing->pair, crossing->polygon.n, crossing->polygon.shape.first);
}

static LIM_IF_CALLED void fill_textured(struct lim_convex *convex, uint16_t *line, struct lim_crossing *crossing,
                                        int16_t y, int16_t x0, int16_t x1)
{
    const struct lim_textured_span span = {convex->pass->texturing, crossing->gradients, y,
                                           lim_edge_x(&crossing->pair.left), lim_edge_x(&crossing->pair.right)};

    lim_texture_fill(&span, line, (uint16_t)x0, (uint16_t)x1, lim_stats_of(convex->pass));
}

/* Pixels of the line that is painted, which may be the target's. */
static LIM_ALONE void fill_pixels(struct lim_convex *convex, uint16_t *line, int16_t x0, int16_t x1, uint16_t colour)
{
    if (LIM_HAS_FILL && (!LIM_HAS_LINES || !line)) {
        lim_piece_fill *const fill = lim_target_fill(&convex->pass->target);
        convex->look->colour = colour;
        fill(convex->look, (uint16_t)x0, (uint16_t)x1);
    } else {
        lim_fill(line, (uint16_t)x0, (uint16_t)(x1 - x0), colour);
    }
}

/* The polygon's pixels on line y: its first one, or that below the last. */
static void fill_next(struct lim_convex *convex, uint16_t *line, struct lim_crossing *crossing, int16_t y)
{
    struct lim_pass *const pass = convex->pass;
    lim_edge_advance(&crossing->pair, crossing->polygon.at, crossing->polygon.n, y);
    const int16_t w_px = (int16_t)pass->target.w_px, left = lim_edge_x(&crossing->pair.left);
    const int16_t right = lim_edge_x(&crossing->pair.right);
    const int16_t x0 = left > 0 ? left : 0, x1 = right < w_px ? right : w_px;
    if (x0 >= x1) return;
    if (LIM_HAS_WIREFRAME && lim_wireframe_of(pass)) {
        struct lim_wire wire = lim_wire_of(&crossing->polygon, lim_wireframe_of(pass), lim_background_of(pass), y);
        wire.target = &pass->target;
        lim_wire_fill(line, &wire, (uint16_t)x0, (uint16_t)x1);
    } else if (LIM_HAS_TEXTURE && lim_screen_texture(&crossing->polygon) != LIM_NONE) {
        fill_textured(convex, line, crossing, y, x0, x1);
    } else {
        fill_pixels(convex, line, x0, x1, crossing->polygon.colour);
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->pixels_painted += (uint32_t)(x1 - x0);
}

/* A non-monotone face: its triangles begin anew on each line. */
static LIM_RARE void fill_fan(struct lim_convex *convex, uint16_t *line, const struct lim_crossing *face, int16_t y)
{
    const struct lim_screen_polygon *non_monotone = &face->polygon;
    struct lim_crossing triangle;

    for (uint_fast8_t k = 1; k + 1u < non_monotone->n; k++) {
        lim_project_fan(non_monotone, (uint8_t)(LIM_HAS_WIREFRAME ? non_monotone->n - 1u - k : k), &triangle.polygon);
        if (y < triangle.polygon.shape.top || y >= triangle.polygon.shape.bottom) continue;
        begin(convex, &triangle);
        fill_next(convex, line, &triangle, y);
    }
}

/* The pool has the room that the frame's faces leave. */
static bool has_room(const struct lim_convex *convex)
{
    const uint8_t *const end = (const uint8_t *)&convex->faces[convex->farthest];

    return (size_t)(end - (const uint8_t *)&convex->pool[convex->pool_used]) >= sizeof(struct lim_crossing);
}

/* Projects a face that has no entry: into a free one, which is then its own, or else into `spare`. */
static struct lim_crossing *convex_enter(struct lim_convex *convex, struct lim_face *face, struct lim_crossing *spare,
                                         int16_t y)
{
    struct lim_crossing *crossing = spare;
    uint_fast16_t i = 0;

    while (i < convex->pool_used && convex->pool[i].polygon.shape.bottom > y)
        i++;
    if (i < convex->pool_used || has_room(convex)) {
        if (i == convex->pool_used) convex->pool_used++;
        crossing = &convex->pool[i];
        face->crossing = (uint16_t)i;
    }
    if (LIM_HAS_STATS && crossing == spare) lim_stats_of(convex->pass)->bands++;
    (void)convex_project(convex->pass, &crossing->polygon, face->record, NULL);
    begin(convex, crossing);
    return crossing;
}

static void note_seen(struct lim_stats *stats, struct lim_face *face, uint32_t painted_before)
{
    if (*face->seen || stats->pixels_painted == painted_before) return;
    *face->seen = true;
    stats->polygons_seen++;
}

/* false: line y is its last. */
static bool paint_face(struct lim_convex *convex, uint16_t *line, struct lim_face *face, struct lim_crossing *spare,
                       int16_t y)
{
    struct lim_pass *const pass = convex->pass;
    const uint32_t painted_before = LIM_HAS_STATS ? lim_stats_of(pass)->pixels_painted : 0;
    const bool has_entry = face->crossing != LIM_NONE;
    struct lim_crossing *crossing = has_entry ? &convex->pool[face->crossing] : convex_enter(convex, face, spare, y);
    const struct lim_edge_shape *shape = &crossing->polygon.shape;

    if (shape->non_monotone)
        fill_fan(convex, line, crossing, y);
    else
        fill_next(convex, line, crossing, y);
    if (LIM_HAS_STATS) note_seen(lim_stats_of(pass), face, painted_before);
    return shape->bottom > y + 1;
}

/* The faces that cross the line, and among them those that start on it, from far to near: by their indices.
 * Returns how many there are. */
static uint16_t paint_faces(struct lim_convex *convex, uint16_t *line, struct lim_crossing *spare, uint16_t y)
{
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
        if (paint_face(convex, line, face, spare, (int16_t)y))
            link = &face->next;
        else
            *link = face->next;
    }
}

/* What no face has painted is background, as long as no two have painted the same. */
static void note_line(struct lim_convex *convex, uint16_t count, uint32_t painted_before)
{
    struct lim_pass *const pass = convex->pass;
    struct lim_stats *stats = lim_stats_of(pass);
    const uint32_t painted = stats->pixels_painted - painted_before, w_px = pass->target.w_px;

    stats->pixels_background += painted < w_px ? w_px - painted : 0;
    stats->lines += count;
    if (count > stats->active_max) stats->active_max = count;
}

/* Whether the target keeps its pixels itself. Round glass would get some that it has not. */
static bool takes_fill(const struct lim_pass *pass)
{
    if (!LIM_HAS_FILL || !LIM_HAS_LINES) return LIM_HAS_FILL;
    return lim_target_fill(&pass->target) && !lim_texture_count(pass->scene) && !lim_target_is_round(&pass->target);
}

/* Looks for the target anew, so that no register keeps it while faces are painted. */
static int line_done(const struct lim_convex *convex, const uint16_t *line, uint16_t y)
{
    const struct lim_target *target = &convex->pass->target;

    if (LIM_HAS_FILL && !line && lim_target_keeps_all(target)) return 0;
    return target->done(target->ctx, y, 0, target->w_px);
}

static int draw_line(struct lim_convex *convex, struct lim_crossing *spare, uint16_t y)
{
    struct lim_pass *pass = convex->pass;
    const struct lim_target *target = &pass->target;
    const uint32_t painted_before = LIM_HAS_STATS ? lim_stats_of(pass)->pixels_painted : 0;
    const bool fills = takes_fill(pass);
    uint16_t *line = fills ? NULL : target->lend(target->ctx, y);

    if (!line && !fills) return LIM_ERR_TARGET;
    if (LIM_HAS_FILL) *convex->look = (struct lim_piece_look){.ctx = target->ctx, .y_px = y};
    fill_pixels(convex, line, 0, (int16_t)target->w_px, lim_background_of(pass));
    const uint16_t count = paint_faces(convex, line, spare, y);
    if (LIM_HAS_STATS) note_line(convex, count, painted_before);
    lim_overlay_line(pass, line, y, 0, target->w_px);
    return line_done(convex, line, y);
}

static void convex_start(struct lim_convex *convex)
{
    struct lim_pass *const pass = convex->pass;

    for (uint_fast16_t y = pass->target.h_px; y-- > 0;)
        convex->tops[y] = LIM_NONE;
    convex->farthest = (uint16_t)pass->scene->polygon_count;
    convex->first = LIM_NONE;
    convex->pool_used = 0;
}

static int show_all(const struct lim_pass *pass)
{
    return takes_fill(pass) && lim_target_keeps_all(&pass->target) ? lim_target_show(&pass->target) : 0;
}

int lim_convex_frame(struct lim_convex *convex)
{
    struct lim_crossing spare;

    convex_start(convex);
    note_faces(convex, &spare.polygon);
    for (uint_fast16_t y = 0; y < convex->pass->target.h_px; y++) {
        const int err = draw_line(convex, &spare, (uint16_t)y);
        if (err) return err;
    }
    return show_all(convex->pass);
}

#endif
