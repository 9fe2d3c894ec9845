/* SPDX-License-Identifier: MIT
 *
 * The stage is a target between the renderer and the caller's: what is done there is compared here. A line is sent in
 * one of three ways. Usually its changes join rectangles, and when these are many, or the frame is complete, they are
 * painted from runs and sent. A line that cannot be painted from runs later, or was not known, is sent at once. And
 * where several lines are sent together as pages, the target gets all of them, and of the last one what has changed in
 * any. */
#include "pixels/delta.h"

#include "pixels/rects.h"
#include "pixels/target_parts.h"

#if LIM_HAS_DELTA

static inline uint16_t width(const struct lim_rect *rect)
{
    return (uint16_t)(rect->x1 - rect->x0);
}

static void note_sent(struct lim_delta *delta, uint32_t pixels, uint32_t windows)
{
    if (!LIM_HAS_STATS) return;
    delta->stats->delta.pixels += pixels;
    delta->stats->delta.windows += windows;
}

static int open_window(struct lim_delta *delta, const struct lim_rect *window)
{
    note_sent(delta, 0, 1);
    return delta->target.window(delta->target.ctx, window);
}

static int send_window(struct lim_delta *delta, uint16_t y, const struct lim_rect *rect)
{
    note_sent(delta, width(rect), 0);
    return delta->target.done(delta->target.ctx, y, rect->x0, width(rect));
}

static uint16_t *lend(struct lim_delta *delta, uint16_t y)
{
    return delta->target.lend(delta->target.ctx, y);
}

static inline void find_visible(const struct lim_delta *delta, uint16_t y, uint16_t *x0, uint16_t *x1)
{
    *x0 = 0;
    *x1 = delta->target.w_px;
    if (lim_target_is_round(&delta->target)) lim_target_visible(&delta->target, y, x0, x1);
}

/* Rectangles ----------------------------------------------------------------------------------------------------- */

static int send_rect(struct lim_delta *delta, const struct lim_rect *rect)
{
    int err = open_window(delta, rect);

    for (uint16_t y = rect->y0; y < rect->y1 && !err; y++) {
        uint16_t *line = lend(delta, y);
        if (!line) return LIM_ERR_TARGET;
        lim_runs_paint(&delta->runs, y, line, rect->x0, rect->x1);
        err = send_window(delta, y, rect);
    }
    return err;
}

static int send_rects(struct lim_delta *delta)
{
    int err = 0;

    if (!delta->rects.count) return 0;
    lim_rects_join(&delta->rects);
    for (uint16_t i = 0; i < delta->rects.count && !err; i++)
        err = send_rect(delta, &delta->rects.rect[i]);
    lim_rects_clear(&delta->rects);
    delta->stream.y0 = delta->target.h_px; /* another window is open */
    return err;
}

/* Pixels that share bytes, or whole lines. */
static void align(const struct lim_delta *delta, struct lim_rect *rect)
{
    const uint16_t step = delta->target.costs.x_align_px, w_px = delta->target.w_px;

    if (step <= 1) return;
    const uint16_t end = (uint16_t)((rect->x1 + step - 1u) / step * step);
    rect->x0 = (uint16_t)(rect->x0 / step * step);
    rect->x1 = end < w_px ? end : w_px;
}

/* The next change of a line, wide enough for the target. */
static bool next_change(const struct lim_delta *delta, struct lim_changes *changes, uint16_t y, struct lim_rect *out)
{
    *out = (struct lim_rect){0, y, 0, (uint16_t)(y + 1)};
    if (!lim_changes_next(changes, &out->x0, &out->x1)) return false;
    align(delta, out);
    if (out->x1 == delta->target.w_px) changes->x = out->x1; /* perhaps more than was compared */
    return true;
}

static int add_changes(struct lim_delta *delta, uint16_t y)
{
    struct lim_changes changes = lim_runs_compare(&delta->runs, y, delta->still);
    struct lim_rect change;
    int err = 0;

    while (!err && next_change(delta, &changes, y, &change)) {
        if (lim_rects_add(&delta->rects, &change)) continue;
        err = send_rects(delta);
        (void)lim_rects_add(&delta->rects, &change);
    }
    return err;
}

/* At once -------------------------------------------------------------------------------------------------------- */

/* A window goes on below its first line, and takes the same stretch of the next one as well. */
static int send_stretch(struct lim_delta *delta, const struct lim_rect *stretch)
{
    struct lim_rect *stream = &delta->stream;

    if (stream->y0 != stretch->y0 || stream->x0 != stretch->x0 || stream->x1 != stretch->x1) {
        *stream = (struct lim_rect){stretch->x0, stretch->y0, stretch->x1, delta->target.h_px};
        const int err = open_window(delta, stream);
        if (err) return err;
    }
    stream->y0++;
    return send_window(delta, stretch->y0, stretch);
}

/* The line first: its memory may be what rectangles are painted in. They must not grow over it, and go as well. */
static int send_line(struct lim_delta *delta, uint16_t y, uint16_t x0, uint16_t x1)
{
    struct lim_rect stretch = {x0, y, x1, (uint16_t)(y + 1)};

    if (!delta->line) {
        delta->line = lend(delta, y);
        if (!delta->line) return LIM_ERR_TARGET;
        lim_runs_paint_noted(&delta->runs, delta->line, x0, x1);
    }
    align(delta, &stretch);
    const int err = x0 < x1 ? send_stretch(delta, &stretch) : 0;
    return err ? err : send_rects(delta);
}

/* Of a line with textures, which is painted: changes whose distance costs less than a window are sent as one. */
static int send_changes(struct lim_delta *delta, uint16_t y)
{
    struct lim_changes changes = lim_runs_compare(&delta->runs, y, delta->still);
    struct lim_rect stretch, next;
    bool more = next_change(delta, &changes, y, &stretch);
    int err = 0;

    while (more && !err) {
        while ((more = next_change(delta, &changes, y, &next)) && next.x0 <= stretch.x1 + delta->rects.window_px)
            stretch.x1 = next.x1;
        err = send_stretch(delta, &stretch);
        stretch = next;
    }
    return err ? err : send_rects(delta);
}

/* Pages ---------------------------------------------------------------------------------------------------------- */

/* A page is one line of rectangles. If there are too many, it is sent whole. */
static void add_to_page(struct lim_delta *delta, uint16_t y, uint16_t x0, uint16_t x1)
{
    const uint16_t page = (uint16_t)(y / delta->target.costs.page_px);
    struct lim_rect change = {x0, page, x1, (uint16_t)(page + 1)};

    if (delta->rects.count && delta->rects.rect[0].y0 != page) lim_rects_clear(&delta->rects);
    if (lim_rects_add(&delta->rects, &change)) return;
    change.x0 = 0;
    change.x1 = delta->target.w_px;
    lim_rects_clear(&delta->rects);
    (void)lim_rects_add(&delta->rects, &change);
}

/* All lines but the last of a page are only taken in. */
static int send_page(struct lim_delta *delta, uint16_t y)
{
    int err = 0;

    if ((y + 1) % delta->target.costs.page_px) return delta->target.done(delta->target.ctx, y, 0, delta->target.w_px);
    lim_rects_join(&delta->rects);
    for (uint16_t i = 0; i < delta->rects.count && !err; i++) {
        note_sent(delta, 0, 1);
        err = send_window(delta, y, &delta->rects.rect[i]);
    }
    lim_rects_clear(&delta->rects);
    return err;
}

static int page_line(struct lim_delta *delta, uint16_t y, bool compares)
{
    struct lim_changes changes = lim_runs_compare(&delta->runs, y, delta->still);
    struct lim_rect change;

    if (!compares) add_to_page(delta, y, 0, delta->target.w_px);
    while (compares && next_change(delta, &changes, y, &change))
        add_to_page(delta, y, change.x0, change.x1);
    return send_page(delta, y);
}

/* Lines ---------------------------------------------------------------------------------------------------------- */

/* What was painted without notes. The painter has lent all lines at once. */
static int look_at_line(struct lim_delta *delta, uint16_t y, uint16_t x0, uint16_t x1)
{
    if (delta->target.method == LIM_PAINTER) delta->line = lend(delta, y);
    if (!delta->line) return LIM_ERR_TARGET;
    lim_runs_scan(&delta->runs, delta->line, x0, x1);
    return 0;
}

static void note_unseen(struct lim_delta *delta, uint16_t x0, uint16_t x1)
{
    if (x0 > 0) lim_runs_note(&delta->runs, 0, x0, LIM_RUN_UNSEEN);
    if (x1 < delta->target.w_px) lim_runs_note(&delta->runs, x1, delta->target.w_px, LIM_RUN_UNSEEN);
}

static void count_line(struct lim_delta *delta, bool compares)
{
    if (!LIM_HAS_STATS) return;
    struct lim_delta_stats *stats = &delta->stats->delta;
    const uint16_t used = lim_runs_used(&delta->runs);

    if (!compares) stats->lines_whole++;
    if (used > stats->runs_max) stats->runs_max = used;
}

/* x0 <= x < x1 is all that is seen of it. */
static int finish_line(struct lim_delta *delta, uint16_t y, uint16_t x0, uint16_t x1)
{
    const bool known = lim_runs_begin(&delta->runs, y);

    if (!delta->noted) {
        const int err = look_at_line(delta, y, x0, x1);
        if (err) return err;
    }
    note_unseen(delta, x0, x1);
    const enum lim_runs_kept kept = lim_runs_keep(&delta->runs, y);
    const bool compares = known && kept != LIM_RUNS_LOST;
    count_line(delta, compares);
    if (lim_delta_wants_lines(delta)) return page_line(delta, y, compares);
    if (!compares) return send_line(delta, y, x0, x1);
    return kept == LIM_RUNS_TEXTURED ? send_changes(delta, y) : add_changes(delta, y);
}

/* Of a line that comes in pieces nothing is kept, and all of its page is sent: by the pieces of its last line, of which
 * the outer ones reach to the edges, for more may be seen of other lines. Pieces may begin between pixels that share
 * bytes: how they are sent is the target's affair, and nothing comes between them. Rectangles follow the last one. */
static int send_piece(struct lim_delta *delta, const struct lim_rect *piece, bool is_first, bool is_last)
{
    (void)lim_runs_begin(&delta->runs, piece->y0);
    lim_runs_lose(&delta->runs, piece->y0);
    if (lim_delta_wants_lines(delta)) {
        const uint16_t x0 = is_first ? 0 : piece->x0, x1 = is_last ? delta->target.w_px : piece->x1;
        add_to_page(delta, piece->y0, 0, delta->target.w_px);
        return delta->target.done(delta->target.ctx, piece->y0, x0, (uint16_t)(x1 - x0));
    }
    delta->stream.y0 = delta->target.h_px;
    int err = open_window(delta, NULL);
    if (!err) err = send_window(delta, piece->y0, piece);
    return err || !is_last ? err : send_rects(delta);
}

/* On round glass a line's pieces may be empty, before and behind what is seen of it: that can be all in one of them.
 * Where nothing is seen the first piece is the line. */
static int delta_done(void *ctx, uint16_t y, uint16_t x_px, uint16_t n_px)
{
    struct lim_delta *delta = ctx;
    const struct lim_rect piece = {x_px, y, (uint16_t)(x_px + n_px), (uint16_t)(y + 1)};
    uint16_t x0, x1;

    find_visible(delta, y, &x0, &x1);
    if (n_px == 0 && (x0 < x1 || y == delta->y)) return 0;
    const bool is_piece = piece.x0 > x0 || piece.x1 < x1;
    const int err =
        is_piece ? send_piece(delta, &piece, piece.x0 <= x0, piece.x1 >= x1) : finish_line(delta, y, x0, x1);
    delta->y = y;
    delta->line = NULL;
    delta->noted = false;
    return err;
}

static void *delta_lend(void *ctx, uint16_t y)
{
    struct lim_delta *delta = ctx;

    delta->line = lend(delta, y);
    return delta->line;
}

#if LIM_HAS_ROUND
static void delta_visible(void *ctx, uint16_t y, uint16_t *x0, uint16_t *x1)
{
    find_visible(ctx, y, x0, x1);
}
#endif

bool lim_delta_wants_lines(const struct lim_delta *delta)
{
    return delta->target.costs.page_px > 1;
}

/* Frames --------------------------------------------------------------------------------------------------------- */

static inline bool has_same_origin(const struct lim_camera *a, const struct lim_camera *b)
{
    return !LIM_HAS_LONG ||
           (a->origin[0] == b->origin[0] && a->origin[1] == b->origin[1] && a->origin[2] == b->origin[2]);
}

static bool is_same(const struct lim_camera *a, const struct lim_camera *b)
{
    return a->eye_q8[0] == b->eye_q8[0] && a->eye_q8[1] == b->eye_q8[1] && a->eye_q8[2] == b->eye_q8[2] &&
           a->yaw == b->yaw && a->pitch == b->pitch && a->roll == b->roll && a->tan_x_q28 == b->tan_x_q28 &&
           a->tan_y_q28 == b->tan_y_q28 && a->near_q8 == b->near_q8 && has_same_origin(a, b);
}

void lim_delta_begin_frame(struct lim_delta *delta, const struct lim_camera *camera, struct lim_stats *stats)
{
    delta->stats = stats;
    if (!delta->known) lim_runs_forget(&delta->runs);
    delta->still = delta->known && is_same(camera, &delta->camera);
    delta->known = false;
    delta->camera = *camera;
    lim_rects_clear(&delta->rects);
    delta->y = delta->stream.y0 = delta->target.h_px;
    delta->line = NULL;
    delta->noted = false;
}

int lim_delta_end_frame(struct lim_delta *delta, int err)
{
    if (!err && !lim_delta_wants_lines(delta)) err = send_rects(delta);
    delta->known = !err;
    return err;
}

/* What the renderer gets for a target. */
struct lim_target lim_delta_stage(struct lim_delta *delta)
{
    struct lim_target target = delta->target;

    target.ctx = delta;
    target.lend = delta_lend; /* never called from this file */
    target.done = delta_done; /* never called from this file */
#if LIM_HAS_ROUND
    if (target.visible) target.visible = delta_visible; /* never called from this file */
#endif
#if LIM_HAS_FILL
    target.fill = NULL;
#endif
#if LIM_HAS_FRAMEBUFFER
    target.framebuffer.pixels = NULL;
#endif
    return target;
}

static uint32_t window_px(const struct lim_target_costs *costs)
{
    return (costs->window_b * UINT32_C(8) + costs->pixel_bits / 2u) / costs->pixel_bits;
}

/* What is lent, widest alignment first. */
static void share_out(struct lim_delta *delta, size_t run_count)
{
    struct lim_runs *runs = &delta->runs;

    runs->w_px = delta->target.w_px;
    runs->h_px = delta->target.h_px;
    runs->size = run_count < UINT16_MAX ? (uint16_t)run_count : UINT16_MAX;
    runs->line = (uint32_t *)(void *)(delta + 1);
    runs->ring = runs->line + runs->w_px;
    runs->first = (uint16_t *)(void *)(runs->ring + runs->size);
}

int lim_delta_init(struct lim_delta *delta, const struct lim_target *target, size_t mem_b)
{
    const size_t fixed_b = LIM_DELTA_MEM_B(target->w_px, target->h_px, 0);

    if (!target->window || !target->costs.page_px || !target->costs.pixel_bits) return LIM_ERR_TARGET;
    if (mem_b < fixed_b + sizeof(uint32_t)) return LIM_ERR_MEMORY;
    *delta = (struct lim_delta){.target = *target};
    delta->rects.window_px = window_px(&target->costs);
    share_out(delta, (mem_b - fixed_b) / sizeof(uint32_t));
    return LIM_OK;
}

#endif
