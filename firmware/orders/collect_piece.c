/* SPDX-License-Identifier: MIT
 *
 * SPAN and retaining for pieces of split polygons: of each line, or of each row of samples, what TRACE leaves. The
 * place where a piece would be retained holds its lines meanwhile. */
#include "lines/layers.h"
#include "lines/retain.h"
#include "lines/smooth.h"
#include "lines/smooth_line.h"
#include "lines/span.h"
#include "lines/strips.h"
#include "orders/nearest.h"
#include "pieces/trace.h"
#include "screen/polygon.h"
#include "screen/project.h"
#include "view/view.h"

#if LIM_HAS_SPANS && LIM_HAS_NEWELL

static enum lim_span_result close_piece_lines(struct lim_spans *spans, const struct lim_point *last, int16_t top,
                                              int16_t bottom)
{
    uint8_t result = LIM_SPAN_NOTHING;

    for (int16_t y = top; y < bottom; y++) {
        const struct lim_point *line = &last[bottom - 1 - y];
        if (line->x < line->y)
            result |= (uint8_t)lim_span_close(spans, &spans->lines[y], (int16_t)line->x, (int16_t)line->y, NULL, NULL);
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}

static LIM_IF_CALLED bool see_lines(const struct lim_spans *spans, const struct lim_point *last, int16_t top,
                                    int16_t bottom)
{
    for (int16_t y = top; y < bottom; y++) {
        const struct lim_point *line = &last[bottom - 1 - y];
        if (lim_spans_see_line(spans, (uint16_t)y, (int16_t)line->x, (int16_t)line->y)) return true;
    }
    return false;
}

/* A transparent piece leaves its pixels open. */
static enum lim_span_result pass(struct lim_nearest *nearest, uint8_t alpha, const struct lim_point *last, int16_t top,
                                 int16_t bottom)
{
    if (lim_nearest_retains_all(nearest)) return top < bottom ? LIM_SPAN_SOME : LIM_SPAN_NOTHING;
    if (!LIM_HAS_TRANSPARENT || alpha == LIM_OPAQUE) return close_piece_lines(&nearest->spans, last, top, bottom);
    return see_lines(&nearest->spans, last, top, bottom) ? LIM_SPAN_SOME : LIM_SPAN_NOTHING;
}

static bool is_empty(const struct lim_point *line)
{
    return line->x >= line->y;
}

/* Lines of the whole above and below the piece need not be retained. */
static void trim(struct lim_point *last, int16_t *top, int16_t *bottom)
{
    int16_t below = 0;

    while (*top < *bottom && is_empty(&last[*bottom - 1 - *top]))
        ++*top;
    while (*top < *bottom - below && is_empty(&last[below]))
        below++;
    *bottom = (int16_t)(*bottom - below);
    for (int16_t i = 0; below && i < *bottom - *top; i++)
        last[i] = last[i + below];
}

/* lim_trace_lines() for rows of samples. */
static LIM_IF_CALLED void fill_rows(struct lim_point *last, const struct lim_screen_polygon *whole,
                                    const struct lim_rect *open, int16_t top, int16_t bottom)
{
    const int16_t x0 = (int16_t)(open->x0 * LIM_SAMPLES_A_ROW), x1 = (int16_t)(open->x1 * LIM_SAMPLES_A_ROW);
    struct lim_sample_edges edges;

    lim_strip_begin(&edges, whole->n, whole->shape.first);
    for (int16_t y = top; y < bottom; y++) {
        const struct lim_strip strip =
            lim_strip_next(&edges, whole->at, whole->n, whole->shape.first, y, *whole->shape.end_row);
        for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
            struct lim_point *row = &last[(bottom - y) * LIM_SAMPLE_ROWS - 1 - (int16_t)s];
            const int16_t left = lim_bound_sample(&strip.left, s), right = lim_bound_sample(&strip.right, s);
            row->x = left > x0 ? left : x0;
            row->y = right < x1 ? right : x1;
        }
    }
}

/* pass() for them; a line that is drawn alone takes them at once. */
static LIM_IF_CALLED enum lim_span_result pass_rows(struct lim_nearest *nearest, const struct lim_screen_polygon *whole,
                                                    const struct lim_point *last, int16_t top, int16_t bottom)
{
    const int16_t end_row = (int16_t)(bottom * LIM_SAMPLE_ROWS);
    uint8_t result = LIM_SPAN_NOTHING;
    struct lim_strip strip;

    for (int16_t y = top; y < bottom; y++) {
        lim_strip_of_rows(&strip, last, end_row, y);
        if (nearest->paint.smooth->line)
            lim_smooth_add(&nearest->paint, &nearest->spans, &strip, whole);
        else if (!LIM_HAS_TRANSPARENT || lim_alpha_of(whole) == LIM_OPAQUE)
            result |= (uint8_t)lim_smooth_close_line(&nearest->spans, y, &strip);
        else if (lim_strips_see(&nearest->spans, &nearest->spans.lines[y], &strip, NULL, NULL))
            return LIM_SPAN_SOME;
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}

/* Rows of a line that are retained one by one, for pixels or for samples. */
static inline int16_t rows_of(const struct lim_nearest *nearest)
{
    return lim_is_antialiased(&nearest->pass->view) ? LIM_SAMPLE_ROWS : 1;
}

/* Which pixels or samples of lines top <= y < bottom the piece has, and whether any is open. */
static inline enum lim_span_result see_piece(struct lim_nearest *nearest, uint16_t entry,
                                             const struct lim_screen_polygon *whole, struct lim_point *last,
                                             int16_t *top, int16_t *bottom)
{
    if (LIM_HAS_ANTIALIAS && lim_is_antialiased(&nearest->pass->view)) {
        fill_rows(last, whole, &nearest->spans.open, *top, *bottom);
        lim_trace_cut(lim_nearest_sorter(nearest), entry, whole, last, (int16_t)(*top * LIM_SAMPLE_ROWS),
                      (int16_t)(*bottom * LIM_SAMPLE_ROWS));
        return pass_rows(nearest, whole, last, *top, *bottom);
    }
    lim_trace_lines(lim_nearest_sorter(nearest), entry, whole, &nearest->spans.open, last, top, bottom);
    trim(last, top, bottom);
    const uint8_t alpha = lim_wireframe_of(nearest->pass) ? (uint8_t)LIM_OPAQUE : lim_alpha_of(whole);
    return pass(nearest, alpha, last, *top, *bottom);
}

static uint32_t piece_cells(const struct lim_nearest *nearest, int16_t top, int16_t bottom)
{
    return (uint32_t)(bottom - top) * (uint32_t)rows_of(nearest);
}

static bool collect_plain_piece(struct lim_nearest *nearest, uint16_t entry, const struct lim_screen_polygon *whole)
{
    const struct lim_rect *open = &nearest->spans.open;
    int16_t top = whole->shape.top > (int16_t)open->y0 ? whole->shape.top : (int16_t)open->y0;
    int16_t bottom = whole->shape.bottom < (int16_t)open->y1 ? whole->shape.bottom : (int16_t)open->y1;
    struct lim_retained *retained = &nearest->retained;
    struct lim_point *last = &retained->cells[retained->used].at + LIM_RETAINED_HEAD_CELLS;

    if (top >= bottom) return true;
    const uint32_t needed = LIM_RETAINED_HEAD_CELLS + piece_cells(nearest, top, bottom);
    if (!lim_share_has_cells(&nearest->spans, retained, needed)) return false;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->lines += (uint32_t)(bottom - top);
    const uint16_t pending = retained->pending;
    retained->pending = (uint16_t)needed;
    lim_share_set_lowest(&nearest->spans);
    const enum lim_span_result result = see_piece(nearest, entry, whole, last, &top, &bottom);
    retained->pending = pending;
    lim_share_set_lowest(&nearest->spans);
    if (result != LIM_SPAN_SOME) return result == LIM_SPAN_NOTHING;
    if (LIM_HAS_STATS) lim_stats_of(nearest->pass)->polygons_seen++;
    struct lim_retained_polygon seen =
        lim_retained_of(whole, top, (int16_t)(bottom * rows_of(nearest)), lim_wireframe_of(nearest->pass));
    seen.at = last;
    seen.n = seen.first = 0;
    if (!lim_retain(&nearest->spans, &seen)) return false;
    retained->used = (uint16_t)(retained->used + piece_cells(nearest, top, bottom)); /* what is left of them */
    lim_share_set_lowest(&nearest->spans);
    return true;
}

bool lim_collect_piece(struct lim_nearest *nearest, uint16_t entry, const struct lim_screen_polygon *whole)
{
    struct lim_screen_polygon triangle;

    if (!whole->shape.non_monotone) return collect_plain_piece(nearest, entry, whole);
    for (uint8_t k = 1; k + 1 < whole->n; k++) {
        lim_project_fan(whole, k, &triangle);
        if (!collect_plain_piece(nearest, entry, &triangle)) return false;
    }
    return true;
}

#endif
