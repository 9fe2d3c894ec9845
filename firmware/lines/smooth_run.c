/* SPDX-License-Identifier: MIT
 *
 * An edge is a straight line in whole numbers: where it is on a row is a start and a step. So of two edges that are in
 * the same order on the first row of a run and on its last, each row between has them in that order, and so have their
 * samples, which are rounded alike. Nearest first, each polygon's two edges are compared with those of what is open, at
 * both ends; where an edge crosses another on the way, the run is made shorter. */
#include "lines/smooth_run.h"

#include "lines/active.h"
#include "lines/overlaid.h"
#include "lines/smooth.h"
#include "screen/samples.h"
#include "view/pass.h"

#if LIM_HAS_ANTIALIAS

/* A piece of each line of a run, up to the next one's left side. */
struct piece {
    uint32_t x_q16, step_q16;     /* its left side on the row above the line: as struct lim_sample_edge */
    uint32_t first_q16, last_q16; /* the same on the run's first row and on its last */
    uint32_t share;               /* lim_smooth_share() of its colour */
    uint16_t colour;              /* as it lies in memory */
    uint16_t open;                /* background, so far: not 0. No byte is left over */
};

/* The pieces of a run from left to right, and its right side as one more. */
struct pieces {
    struct piece *at;
    uint_fast16_t count, size;
    uint_fast16_t open;  /* how many are */
    uint16_t lines;      /* of the run */
    uint16_t lines_less; /* where edges cross: of a run that ends above, perhaps */
};

static inline void set_edge(struct piece *piece, const struct lim_sample_edge *edge, uint16_t lines)
{
    piece->x_q16 = edge->x_q16;
    piece->step_q16 = edge->step_q16;
    piece->first_q16 = edge->x_q16 + edge->step_q16;
    piece->last_q16 = edge->x_q16 + (uint32_t)(lines * LIM_SAMPLE_ROWS) * edge->step_q16;
}

/* Of each row the same sample, whatever its shift. */
static inline void set_side(struct piece *piece, uint16_t x_px)
{
    const uint32_t sample = (uint32_t)(x_px + LIM_STRIP_BIAS_PX) * LIM_SAMPLES_A_ROW;

    piece->x_q16 = piece->first_q16 = piece->last_q16 = (sample << 16) + (uint32_t)LIM_COLUMN_Q16;
    piece->step_q16 = 0;
}

/* Compared at both ends. */
enum order { LEFT, RIGHT, CROSSING }; /* LEFT, too, of what is at the same place */

static inline enum order order_of(const struct piece *a, const struct piece *b)
{
    if (a->first_q16 <= b->first_q16 && a->last_q16 <= b->last_q16) return LEFT;
    return a->first_q16 >= b->first_q16 && a->last_q16 >= b->last_q16 ? RIGHT : CROSSING;
}

static uint32_t distance_of(uint32_t a, uint32_t b)
{
    return (a > b ? a - b : b - a) >> 11; /* below 2^18: times rows below 2^32 */
}

/* A guess, which is looked at as the first one is: about the line where they cross. false, always. */
static LIM_RARE bool shorten_run(struct pieces *pieces, const struct piece *a, const struct piece *b)
{
    const uint32_t first = distance_of(a->first_q16, b->first_q16), last = distance_of(a->last_q16, b->last_q16);
    const uint32_t rows = (uint32_t)pieces->lines * LIM_SAMPLE_ROWS;
    const uint32_t lines = first + last ? rows * first / (first + last) / LIM_SAMPLE_ROWS : 0;

    pieces->lines_less = (uint16_t)(lines < pieces->lines ? lines : pieces->lines - 1u);
    return false;
}

/* Divides the piece before `at`. */
static inline void divide_piece(struct pieces *pieces, struct piece *at, const struct piece *side)
{
    for (struct piece *piece = pieces->at + ++pieces->count; piece > at; piece--)
        *piece = piece[-1];
    at->x_q16 = side->x_q16;
    at->step_q16 = side->step_q16;
    at->first_q16 = side->first_q16;
    at->last_q16 = side->last_q16;
    at->share = at[-1].share;
    at->colour = at[-1].colour;
    at->open = true;
    pieces->open++;
}

/* Closes what is open between two edges; `left` has the look. false: edges cross, or there is no room. */
static inline bool close_piece(struct pieces *pieces, const struct piece *left, const struct piece *right)
{
    struct piece *gap = pieces->at;

    for (uint_fast16_t open = pieces->open; open; gap++) {
        if (!gap->open) continue;
        open--;
        const enum order beyond = order_of(&gap[1], left), before = order_of(right, gap);
        if (beyond == LEFT) continue;
        if (beyond == CROSSING) return shorten_run(pieces, &gap[1], left);
        if (before == LEFT) return true;
        if (before == CROSSING) return shorten_run(pieces, right, gap);
        const enum order begins = order_of(left, gap), ends = order_of(&gap[1], right);
        if (begins == CROSSING) return shorten_run(pieces, left, gap);
        if (ends == CROSSING) return shorten_run(pieces, &gap[1], right);
        if (pieces->count + 3 > pieces->size) return false;
        if (begins == RIGHT) divide_piece(pieces, ++gap, left);
        if (ends == RIGHT) divide_piece(pieces, gap + 1, right);
        gap->open = false;
        gap->share = left->share;
        gap->colour = left->colour;
        pieces->open--;
        if (ends == RIGHT) return true;
    }
    return true;
}

/* Nearest first. */
static bool close_all(struct pieces *pieces, const struct lim_active *active)
{
    for (; active && pieces->open; active = active->next) {
        struct piece left, right;
        set_edge(&left, &active->samples->left, pieces->lines);
        set_edge(&right, &active->samples->right, pieces->lines);
        const enum order sides = order_of(&left, &right);
        if (sides == CROSSING) return shorten_run(pieces, &left, &right);
        if (sides == RIGHT) continue;
        left.share = *active->share;
        left.colour = active->colour;
        if (!close_piece(pieces, &left, &right)) return false;
    }
    return true;
}

/* As many lines from y on as no polygon begins or ends on, nor one of its edges. A piece's edges have ended at once. */
static uint16_t run_lines(const struct lim_paint *paint, const struct lim_spans *spans, const struct lim_rect *band,
                          uint16_t y)
{
    if (spans->lines[y].retained != LIM_NONE) return 0; /* these begin on it */
    const int32_t below = (y + 1) * LIM_SAMPLE_ROWS;
    int32_t end_row = band->y1 * LIM_SAMPLE_ROWS;
    uint16_t lines = 1;

    for (const struct lim_active *active = paint->actives.first; active; active = active->next) {
        if (active->samples->left.end < end_row) end_row = active->samples->left.end;
        if (active->samples->right.end < end_row) end_row = active->samples->right.end;
        if ((int16_t)active->bottom < end_row) end_row = (int16_t)active->bottom;
        if (end_row < below) return 0;
    }
    while ((y + lines + 1) * LIM_SAMPLE_ROWS <= end_row && spans->lines[y + lines].retained == LIM_NONE)
        lines++;
    return lines;
}

/* Where gaps would lie, and what polygons on the line have left before them: none begins while a run is drawn. */
static void lend_pieces(struct pieces *pieces, const struct lim_actives *actives, const struct lim_spans *spans)
{
    uint8_t *const pool = (uint8_t *)spans->pool, *const gaps = pool + spans->lowest * LIM_GAP_MEM_B;
    uint8_t *const end = pool + lim_share_gaps_end(spans) * LIM_GAP_MEM_B;
    uint8_t *const at = actives->end == gaps && actives->at < gaps ? actives->at : gaps;

    pieces->at = (void *)at;
    pieces->size = (uint_fast16_t)((size_t)(end - at) / sizeof(struct piece));
}

/* false: line y begins no run. */
static bool find_run(struct pieces *pieces, const struct lim_paint *paint, const struct lim_spans *spans,
                     const struct lim_rect *band, uint16_t y)
{
    pieces->lines_less = run_lines(paint, spans, band, y);
    lend_pieces(pieces, &paint->actives, spans);
    while (pieces->lines_less && pieces->size > 1) {
        pieces->lines = pieces->lines_less;
        pieces->lines_less = 0;
        pieces->count = pieces->open = 1;
        set_side(&pieces->at[0], band->x0);
        set_side(&pieces->at[1], band->x1);
        pieces->at[0].share = lim_smooth_share(paint->background);
        pieces->at[0].colour = paint->background;
        pieces->at[0].open = true;
        if (close_all(pieces, paint->actives.first)) return true;
    }
    return false;
}

/* Of a line, if LIM_HAS_STATS. */
struct counted {
    uint32_t painted, background;
};

static inline void count_pixels(struct counted *counted, bool background, uint32_t n)
{
    if (!LIM_HAS_STATS) return;
    if (background)
        counted->background += n;
    else
        counted->painted += n;
}

/* Pixel x, of which a piece has n samples of 16, and the next one has the others. */
static inline void mix_two(uint16_t *line, uint32_t x, uint32_t n, const struct piece *piece, struct counted *counted)
{
    const uint32_t rest = piece[1].share;

    line[x - LIM_STRIP_BIAS_PX] = lim_smooth_colour(LIM_SAMPLES * rest + n * (piece->share - rest));
    count_pixels(counted, (n && piece->open) || (n < LIM_SAMPLES && piece[1].open), 1);
}

static LIM_INLINE void fill_to(uint16_t *line, uint32_t x0, uint32_t x1, const struct piece *piece,
                               struct counted *counted)
{
    if (x0 >= x1) return;
    lim_fill_inline(line, (int_fast16_t)(x0 - LIM_STRIP_BIAS_PX), (int_fast16_t)(x1 - LIM_STRIP_BIAS_PX),
                    piece->colour);
    count_pixels(counted, piece->open, x1 - x0);
}

/* Pixels x <= .. < end, which an edge that is not steep crosses. */
static inline void mix_slope(uint16_t *line, const struct lim_bound *bound, uint32_t x, uint32_t end,
                             const struct piece *piece, struct counted *counted)
{
    uint32_t before = 0;

    do {
        const uint32_t after = lim_bound_beyond(bound, x + 1);
        mix_two(line, x, LIM_SAMPLES - (after - before), piece, counted);
        before = after;
    } while (++x < end);
}

/* A line of a run, on which each edge has pixels of its own. Returns the piece up to which that is so: all are drawn if
 * it is the last one. */
static LIM_ALONE struct piece *draw_pieces(uint16_t *line, const struct pieces *pieces, struct counted *counted)
{
    struct piece *piece = pieces->at, *const last = piece + pieces->count - 1;
    uint32_t from = (piece->x_q16 >> 16) / LIM_SAMPLES_A_ROW;

    for (; piece < last; piece++) {
        const struct lim_bound bound = lim_bound_step(&piece[1].x_q16, piece[1].step_q16);
        const uint32_t first = pair_low(bound.rows[0]) / LIM_SAMPLES_A_ROW;
        if (lim_bound_is_in_pixel(&bound)) {
            const uint32_t n = lim_bound_sum(&bound) - LIM_SAMPLES * first;
            if (first < from) return piece;
            fill_to(line, from, first, piece, counted);
            from = first;
            if (n) mix_two(line, from++, n, piece, counted);
        } else {
            const uint32_t x0 = lim_bound_low(&bound) / LIM_SAMPLES_A_ROW;
            if (x0 < from) return piece;
            fill_to(line, from, x0, piece, counted);
            from = (lim_bound_high(&bound) + LIM_SAMPLES_A_ROW - 1) / LIM_SAMPLES_A_ROW;
            mix_slope(line, &bound, x0, from, piece, counted);
        }
    }
    fill_to(line, from, (piece[1].x_q16 >> 16) / LIM_SAMPLES_A_ROW, piece, counted);
    return piece;
}

/* The same where more than two pieces have to do with a pixel: each adds its samples to sums. */
static LIM_RARE void mix_line(struct lim_smooth_sink *sink, const struct pieces *pieces, bool background)
{
    struct lim_strip strip;

    strip.left = lim_bound_at(((int32_t)(pieces->at[0].x_q16 >> 16)) - LIM_STRIP_BIAS);
    for (uint_fast16_t i = 0; i < pieces->count; i++) {
        const struct piece *piece = &pieces->at[i];
        uint32_t x_q16 = piece[1].x_q16;
        strip.right = lim_bound_step(&x_q16, piece[1].step_q16);
        sink->colour = piece->colour;
        sink->share = piece->share;
        if (piece->open == background && !lim_bound_equals(&strip.left, &strip.right))
            lim_strip_to_sink(lim_smooth_mix, sink, &strip.left, &strip.right);
        strip.left = strip.right;
    }
}

static void draw_slow(uint16_t *line, const struct lim_paint *paint, const struct pieces *pieces)
{
    struct lim_smooth_sink sink = {.line = line, .sums = paint->smooth->sums};
    struct lim_stats *stats = lim_stats_of(paint->pass);

    mix_line(&sink, pieces, false);
    if (LIM_HAS_STATS) stats->pixels_painted += sink.painted_px;
    sink.painted_px = 0;
    mix_line(&sink, pieces, true);
    if (LIM_HAS_STATS) stats->pixels_background += sink.painted_px;
    for (uint_fast16_t i = 1; i < pieces->count; i++)
        pieces->at[i].x_q16 += LIM_SAMPLE_ROWS * pieces->at[i].step_q16;
}

static int draw_run_line(const struct lim_paint *paint, struct pieces *pieces, const struct lim_rect *band, uint16_t y)
{
    const struct lim_target *target = &paint->pass->target;
    struct lim_stats *stats = lim_stats_of(paint->pass);
    struct counted counted = {0, 0};
    uint16_t *line = target->lend(target->ctx, y);

    if (!line) return LIM_ERR_TARGET;
    struct piece *const piece = draw_pieces(line, pieces, &counted);
    if (piece + 1 < pieces->at + pieces->count) {
        counted = (struct counted){0, 0};
        for (struct piece *side = piece + 1; side > pieces->at; side--)
            side->x_q16 -= LIM_SAMPLE_ROWS * side->step_q16;
        draw_slow(line, paint, pieces);
    }
    if (LIM_HAS_STATS) {
        stats->pixels_painted += counted.painted;
        stats->pixels_background += counted.background;
    }
    lim_overlay_line(paint->pass, line, y, band->x0, band->x1);
    return target->done(target->ctx, y, band->x0, (uint16_t)(band->x1 - band->x0));
}

/* Over the lines of a run; those that end with it are given back. */
static void step_actives(struct lim_actives *actives, uint16_t lines, uint16_t below)
{
    struct lim_active **link = &actives->first, *active;

    while ((active = *link) != NULL) {
        active->samples->left.x_q16 += (uint32_t)(lines * LIM_SAMPLE_ROWS) * active->samples->left.step_q16;
        active->samples->right.x_q16 += (uint32_t)(lines * LIM_SAMPLE_ROWS) * active->samples->right.step_q16;
        if ((int16_t)active->bottom > (int16_t)(below * LIM_SAMPLE_ROWS))
            link = &active->next;
        else
            lim_active_give_back(actives, link);
    }
}

uint16_t lim_smooth_run(struct lim_paint *paint, const struct lim_spans *spans, const struct lim_retained *retained,
                        const struct lim_rect *band, uint16_t y, int *err)
{
    struct lim_stats *stats = lim_stats_of(paint->pass);
    struct pieces pieces;

    if (lim_target_is_round(&paint->pass->target)) return 0;
    if (LIM_HAS_TRANSPARENT && retained->transparent) return 0;
    if (LIM_HAS_TEXTURE && retained->textured) return 0;
    if (LIM_HAS_MOVERS && *paint->actives.moving) return 0;
    if (!find_run(&pieces, paint, spans, band, y)) return 0;
    if (LIM_HAS_STATS && paint->actives.used > stats->active_max) stats->active_max = paint->actives.used;
    for (uint16_t line = 0; line < pieces.lines && !*err; line++)
        *err = draw_run_line(paint, &pieces, band, (uint16_t)(y + line));
    step_actives(&paint->actives, pieces.lines, (uint16_t)(y + pieces.lines));
    return pieces.lines;
}

#endif
