/* SPDX-License-Identifier: MIT
 *
 * The stage is a target between the renderer and the caller's: what is done there is compared here. A line is sent in
 * one of three ways. Usually its changes join rectangles, and when these are many, or the frame is complete, they are
 * painted from runs and sent. A line that has no runs to be painted from later (textures, no room in the ring) is sent
 * at once, after the rectangles. And where several lines are sent together as pages, the target gets all of them, and
 * of the last one what has changed in any. */
#include "limner.h"

#include "fill.h"

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

static int send(struct lim_delta *delta, uint16_t y, const struct lim_rect *rect)
{
    note_sent(delta, width(rect), 0);
    return delta->target.done(delta->target.ctx, y, rect->x0, width(rect));
}

static uint16_t *lend(struct lim_delta *delta, uint16_t y)
{
    return delta->target.lend(delta->target.ctx, y);
}

static int send_rect(struct lim_delta *delta, const struct lim_rect *rect)
{
    int err = open_window(delta, rect);

    for (uint16_t y = rect->y0; y < rect->y1 && !err; y++) {
        uint16_t *line = lend(delta, y);
        if (!line) return LIM_ERR_TARGET;
        lim_kept_runs_paint(&delta->kept, y, line, rect->x0, rect->x1);
        err = send(delta, y, rect);
    }
    return err;
}

static int send_rects(struct lim_delta *delta)
{
    int err = 0;

    if (!delta->rects.count) return 0;
    lim_rects_join(&delta->rects, &delta->target.costs);
    for (uint16_t i = 0; i < delta->rects.count && !err; i++)
        err = send_rect(delta, &delta->rects.rect[i]);
    delta->rects.count = 0;
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

/* A change joins the rectangles. A page that has too many is sent whole. */
static int add(struct lim_delta *delta, const struct lim_rect *change)
{
    int err = 0;

    if (lim_rects_add(&delta->rects, &delta->target.costs, change)) return 0;
    if (lim_delta_wants_lines(delta)) {
        delta->rects.count = 1;
        delta->rects.rect[0] = (struct lim_rect){0, change->y0, delta->target.w_px, change->y1};
        return 0;
    }
    err = send_rects(delta);
    (void)lim_rects_add(&delta->rects, &delta->target.costs, change);
    return err;
}

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
    return send(delta, stretch->y0, stretch);
}

static inline void set_visible(const struct lim_delta *delta, uint16_t y, uint16_t *x0, uint16_t *x1)
{
    *x0 = 0;
    *x1 = delta->target.w_px;
#if LIM_HAS_ROUND
    if (delta->target.visible) delta->target.visible(delta->target.ctx, y, x0, x1);
#else
    (void)y;
#endif
}

/* The next change of the line, wide enough for the target. A line that cannot be compared has one, which is all of it.
 */
static bool next_change(struct lim_delta *delta, struct lim_changes *changes, struct lim_rect *out)
{
    const uint16_t w_px = delta->target.w_px;

    *out = (struct lim_rect){0, delta->y, 0, (uint16_t)(delta->y + 1)};
    if (changes->kept) {
        if (!lim_changes_next(changes, &out->x0, &out->x1)) return false;
    } else {
        if (changes->x == w_px) return false;
        changes->x = w_px;
        set_visible(delta, delta->y, &out->x0, &out->x1);
    }
    align(delta, out);
    return out->x0 < out->x1;
}

static bool is_dearer_apart(const struct lim_delta *delta, const struct lim_rect *a, const struct lim_rect *b)
{
    const struct lim_target_costs *costs = &delta->target.costs;

    return b->x0 <= a->x1 || (uint32_t)(b->x0 - a->x1) * costs->pixel_bits <= costs->window_b * UINT32_C(8);
}

static int paint_now(struct lim_delta *delta)
{
    if (delta->line) return 0;
    delta->line = lend(delta, delta->y);
    if (!delta->line) return LIM_ERR_TARGET;
    lim_line_runs_paint(&delta->runs, delta->line, 0, delta->target.w_px);
    return 0;
}

/* The line first: its memory may be what rectangles are painted in. */
static int send_line(struct lim_delta *delta, struct lim_changes *changes)
{
    struct lim_rect stretch, next;
    bool more = next_change(delta, changes, &stretch);
    int err = more ? paint_now(delta) : 0;

    while (more && !err) {
        while ((more = next_change(delta, changes, &next)) && is_dearer_apart(delta, &stretch, &next))
            stretch.x1 = next.x1;
        err = send_stretch(delta, &stretch);
        stretch = next;
    }
    return err ? err : send_rects(delta);
}

static int add_line(struct lim_delta *delta, struct lim_changes *changes)
{
    struct lim_rect change;

    while (next_change(delta, changes, &change)) {
        const int err = add(delta, &change);
        if (err) return err;
    }
    return 0;
}

/* All lines but the last of a page are only taken in. */
static int send_page(struct lim_delta *delta, struct lim_changes *changes)
{
    const uint16_t page_px = delta->target.costs.page_px;
    struct lim_rect change;
    int err = 0;

    if (delta->y % page_px == 0) delta->rects.count = 0;
    while (next_change(delta, changes, &change)) {
        change.y0 = (uint16_t)(delta->y / page_px);
        change.y1 = (uint16_t)(change.y0 + 1);
        (void)add(delta, &change);
    }
    if ((delta->y + 1) % page_px) return delta->target.done(delta->target.ctx, delta->y, 0, delta->target.w_px);
    lim_rects_join(&delta->rects, &delta->target.costs);
    for (uint16_t i = 0; i < delta->rects.count && !err; i++) {
        note_sent(delta, 0, 1);
        err = send(delta, delta->y, &delta->rects.rect[i]);
    }
    delta->rects.count = 0;
    return err;
}

static void note_unseen(struct lim_delta *delta, uint16_t x0, uint16_t x1)
{
    const uint16_t w_px = delta->target.w_px;

    if (x0 > 0) lim_delta_note(delta, 0, (uint16_t)(x0 | LIM_RUN_UNSEEN), 0);
    if (x1 < w_px) lim_delta_note(delta, x1, (uint16_t)(w_px | LIM_RUN_UNSEEN), 0);
}

/* What was painted without notes. The painter has lent all lines at once. */
static int look_at_line(struct lim_delta *delta, uint16_t x0, uint16_t x1)
{
    if (delta->target.method == LIM_PAINTER) delta->line = lend(delta, delta->y);
    if (!delta->line) return LIM_ERR_TARGET;
    delta->exhausted = !lim_line_runs_scan(&delta->runs, delta->line, x0, x1);
    return 0;
}

static void note_kept(struct lim_delta *delta, bool compares)
{
    if (!LIM_HAS_STATS) return;
    struct lim_delta_stats *stats = &delta->stats->delta;
    const uint16_t used = lim_kept_runs_used(&delta->kept);

    if (!compares) stats->lines_whole++;
    if (used > stats->runs_max) stats->runs_max = used;
}

static int finish_line(struct lim_delta *delta, uint16_t x0, uint16_t x1)
{
    const bool known = lim_kept_runs_begin(&delta->kept, delta->y);

    if (!delta->noting) {
        const int err = look_at_line(delta, x0, x1);
        if (err) return err;
    }
    note_unseen(delta, x0, x1);
    if (delta->exhausted && !delta->line) return LIM_ERR_TARGET;
    const bool kept = lim_kept_runs_keep(&delta->kept, delta->y, delta->exhausted ? NULL : &delta->runs);
    const bool compares = known && !delta->exhausted;
    struct lim_changes changes = {.now = &delta->runs,
                                  .kept = compares ? &delta->kept : NULL,
                                  .still = delta->still,
                                  .w_px = delta->target.w_px,
                                  .at = delta->kept.tail};

    note_kept(delta, compares);
    if (lim_delta_wants_lines(delta)) return send_page(delta, &changes);
    return kept && compares && !delta->textured ? add_line(delta, &changes) : send_line(delta, &changes);
}

/* Of a line that comes in pieces nothing is kept, and all of its page is sent. */
static int send_piece(struct lim_delta *delta, uint16_t x_px, uint16_t n_px)
{
    const struct lim_rect piece = {x_px, delta->y, (uint16_t)(x_px + n_px), (uint16_t)(delta->y + 1)};
    const uint16_t page = (uint16_t)(delta->y / delta->target.costs.page_px);

    (void)lim_kept_runs_begin(&delta->kept, delta->y);
    (void)lim_kept_runs_keep(&delta->kept, delta->y, NULL);
    if (lim_delta_wants_lines(delta)) {
        delta->rects.count = 1;
        delta->rects.rect[0] = (struct lim_rect){0, page, delta->target.w_px, (uint16_t)(page + 1)};
        return delta->target.done(delta->target.ctx, delta->y, x_px, n_px);
    }
    const int err = n_px ? send_stretch(delta, &piece) : 0;
    return err ? err : send_rects(delta);
}

static void clear_line(struct lim_delta *delta)
{
    delta->line = NULL;
    delta->noting = delta->textured = delta->exhausted = delta->spilled = false;
    delta->runs.count = 0;
}

static int delta_done(void *ctx, uint16_t y, uint16_t x_px, uint16_t n_px)
{
    struct lim_delta *delta = ctx;
    uint16_t x0, x1;

    delta->y = y;
    set_visible(delta, y, &x0, &x1);
    const int err = x_px > x0 || x_px + n_px < x1 ? send_piece(delta, x_px, n_px) : finish_line(delta, x0, x1);
    clear_line(delta);
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
    set_visible(ctx, y, x0, x1);
}
#endif

void lim_delta_begin_line(struct lim_delta *delta, uint16_t y, uint16_t *line)
{
    clear_line(delta);
    delta->y = y;
    delta->line = line;
    delta->noting = true;
}

/* A line that was not to be painted is, from here on. */
static LIM_RARE void spill(struct lim_delta *delta)
{
    delta->exhausted = true;
    if (delta->line) return;
    delta->line = lend(delta, delta->y);
    delta->spilled = delta->line != NULL;
    for (uint16_t i = 0; i < delta->runs.count && delta->spilled; i++) {
        const struct lim_line_run *run = &delta->runs.run[i];
        lim_fill(delta->line, run->x0, (uint16_t)((run->end & LIM_RUN_X) - run->x0), run->value);
    }
}

void lim_delta_note(struct lim_delta *delta, uint16_t x0, uint16_t end, uint16_t value)
{
    if (end & LIM_RUN_TEXTURED) delta->textured = true;
    if (!delta->exhausted) {
        if (lim_line_runs_add(&delta->runs, (struct lim_line_run){x0, end, value})) return;
        spill(delta);
    }
    if (delta->spilled) lim_fill(delta->line, x0, (uint16_t)((end & LIM_RUN_X) - x0), value);
}

static bool is_same(const struct lim_camera *a, const struct lim_camera *b)
{
    return a->eye_q8[0] == b->eye_q8[0] && a->eye_q8[1] == b->eye_q8[1] && a->eye_q8[2] == b->eye_q8[2] &&
           a->yaw == b->yaw && a->pitch == b->pitch && a->roll == b->roll && a->tan_x_q28 == b->tan_x_q28 &&
           a->tan_y_q28 == b->tan_y_q28 && a->near_q8 == b->near_q8;
}

void lim_delta_begin_frame(struct lim_delta *delta, const struct lim_camera *camera)
{
    if (!delta->known) lim_kept_runs_forget(&delta->kept);
    delta->still = delta->known && is_same(camera, &delta->camera);
    delta->known = false;
    delta->camera = *camera;
    delta->rects.count = 0;
    delta->stream.y0 = delta->target.h_px;
    clear_line(delta);
}

int lim_delta_end_frame(struct lim_delta *delta, int err)
{
    if (!err && !lim_delta_wants_lines(delta)) err = send_rects(delta);
    delta->known = !err;
    return err;
}

static void join(struct lim *lim, struct lim_delta *delta)
{
    lim->delta = delta;
#if LIM_HAS_SPANS
    lim->paint.delta = delta;
#endif
}

static void leave(struct lim *lim)
{
    if (lim->delta) lim->target = lim->delta->target;
    join(lim, NULL);
}

int lim_set_delta(struct lim *lim, void *mem, size_t mem_b)
{
    struct lim_delta *delta = mem;
    const size_t none_b = LIM_DELTA_MEM_B(lim->target.h_px, 0);

    LIM_ASSERT(((uintptr_t)mem & 3) == 0);
    leave(lim);
    if (!mem) return LIM_OK;
    if (!lim->target.window || !lim->target.costs.page_px) return LIM_ERR_TARGET;
    if (mem_b < LIM_DELTA_MEM_B(lim->target.h_px, 1)) return LIM_ERR_MEMORY;
    const size_t size = (mem_b - none_b) / sizeof(struct lim_kept_run);
    *delta = (struct lim_delta){.target = lim->target, .stats = lim_stats_of(lim)};
    delta->kept.ring = (struct lim_kept_run *)(void *)(delta + 1);
    delta->kept.size = size < UINT16_MAX ? (uint16_t)size : UINT16_MAX;
    delta->kept.first = (uint16_t *)(void *)(delta->kept.ring + delta->kept.size);
    delta->kept.h_px = lim->target.h_px;
    lim->target.ctx = delta;
    lim->target.lend = delta_lend;
    lim->target.done = delta_done;
#if LIM_HAS_ROUND
    if (lim->target.visible) lim->target.visible = delta_visible;
#endif
    join(lim, delta);
    return LIM_OK;
}

void lim_refresh(struct lim *lim)
{
    if (lim->delta) lim->delta->known = false;
}

#endif
