/* SPDX-License-Identifier: MIT
 *
 * A piece that covers a gap's left end, right end, middle or all of it: the gap loses its left
 * end, its right end, splits in two (the only case that takes memory), or is unlinked. An emptied
 * gap must be unlinked at once: a later polygon would find its neighbour through it. */
#include "lines/span.h"

#include "lines/framebuffer.h"
#include "lines/share.h"
#include "lines/strips.h"
#include "screen/edge.h"

#if LIM_HAS_SPANS

void lim_spans_reset_pool(struct lim_spans *spans)
{
    spans->free = LIM_NONE;
    spans->fresh = lim_share_gaps_end(spans);
}

void lim_spans_open(struct lim_spans *spans, const struct lim_target *target, const struct lim_rect *open)
{
    const struct lim_rect band = *open;
    struct lim_line *line = &spans->lines[band.y0];

    spans->open = band;
    spans->trimmed = false;
    spans->open_lines = (uint16_t)(band.y1 - band.y0);
    for (uint16_t y = band.y0; y < band.y1; y++, line++) {
        lim_line_open(line, target, &band, y);
        if (LIM_HAS_ROUND && lim_line_is_closed(line)) spans->open_lines--;
    }
    lim_spans_reset_pool(spans);
}

/* lim_span_close() without a sink, for a line that is not closed; any values. Not where code is to be smallest. */
static LIM_ALONE enum lim_span_result close_several(struct lim_spans *spans, struct lim_line *line, int32_t x0,
                                                    int32_t x1)
{
    struct lim_gap *gap = &line->gap, *before = NULL;

    while (gap->x1 <= x0) {
        if (gap->next == LIM_NONE) return LIM_SPAN_NOTHING;
        before = gap;
        gap = &spans->pool[gap->next];
    }
    if (gap->x0 >= x1 || x0 >= x1) return LIM_SPAN_NOTHING;
    if (x0 > gap->x0) {
        if (x1 < gap->x1)
            return lim_gap_split(spans, gap, (uint16_t)x0, (uint16_t)x1) ? LIM_SPAN_SOME : LIM_SPAN_EXHAUSTED;
        gap->x1 = (uint16_t)x0;
        before = gap;
        gap = lim_gap_after(spans, gap);
    }
    while (gap && gap->x1 <= x1)
        gap = lim_gap_unlink(spans, gap, before);
    if (gap && gap->x0 < x1) gap->x0 = (uint16_t)x1;
    return LIM_SPAN_SOME;
}

enum lim_span_result lim_span_close(struct lim_spans *spans, struct lim_line *line, int16_t x0, int16_t x1,
                                    lim_piece_fill *sink, void *ctx)
{
    enum lim_span_result result = LIM_SPAN_NOTHING;
    struct lim_gap *gap = &line->gap, *before = NULL;

    if (lim_line_is_closed(line)) return LIM_SPAN_NOTHING;
    if (LIM_HOT && !(LIM_HAS_SINKS && sink)) return close_several(spans, line, x0, x1);
    do {
        const int32_t open0 = gap->x0, open1 = gap->x1;
        if (open1 <= x0) {
            before = gap;
            gap = lim_gap_after(spans, gap);
            continue;
        }
        if (open0 >= x1) break;
        const uint16_t from = (uint16_t)(x0 > open0 ? x0 : open0), to = (uint16_t)(x1 < open1 ? x1 : open1);
        if (from > open0 && to < open1 && !lim_gap_split(spans, gap, from, to)) return LIM_SPAN_EXHAUSTED;
        if (LIM_HAS_SINKS && sink) sink(ctx, from, to);
        result = LIM_SPAN_SOME;
        if (from > open0) {
            gap->x1 = from;
            before = gap;
            gap = lim_gap_after(spans, gap);
        } else if (to < open1) {
            gap->x0 = to;
            break;
        } else {
            gap = lim_gap_unlink(spans, gap, before);
        }
    } while (gap);
    return result;
}

/* Most lines have one gap, or none. `sink` is for what is painted at once; NULL: it is retained, and asks which lines
 * were open. `many`: the sink of lines that have several. */
static LIM_HOT_INLINE bool close_between(struct lim_spans *spans, int16_t y, int16_t end, struct lim_closing *closing,
                                         lim_piece_fill *sink, lim_piece_fill *many, struct lim_piece_look *look)
{
    struct lim_edge left, right;
    struct lim_line *line = &spans->lines[y], *const after = &spans->lines[end];

    lim_edge_copy(&left, &closing->pair.left);
    lim_edge_copy(&right, &closing->pair.right);
    do {
        int32_t x0 = lim_edge_x(&left), x1 = lim_edge_x(&right);
        enum lim_span_result result;
        lim_edge_step(&left);
        lim_edge_step(&right);
        if (sink) look->y_px = (uint16_t)(line - spans->lines);
        if (LIM_HOT && line->gap.next == LIM_NONE) {
            result = lim_gap_close_only(spans, &line->gap, &x0, &x1);
            if (sink && result == LIM_SPAN_SOME) sink(look, (uint16_t)x0, (uint16_t)x1);
        } else if (sink || !LIM_HOT) {
            result = x0 < x1 ? lim_span_close(spans, line, (int16_t)x0, (int16_t)x1, many, look) : LIM_SPAN_NOTHING;
        } else {
            result = close_several(spans, line, x0, x1);
        }
        if (result == LIM_SPAN_NOTHING) continue;
        if (sink && result == LIM_SPAN_EXHAUSTED) return false;
        if (sink) continue;
        if (!closing->top) closing->top = line;
        closing->last = line;
        if (result == LIM_SPAN_EXHAUSTED) break;
    } while (++line < after);
    lim_edge_follow(&closing->pair.left, &left);
    lim_edge_follow(&closing->pair.right, &right);
    return line == after; /* else there was no gap: what is closed above is seen all the same */
}

bool lim_spans_close(struct lim_spans *spans, int16_t y, int16_t end, struct lim_closing *closing)
{
    return close_between(spans, y, end, closing, NULL, NULL, NULL);
}

#if LIM_HAS_FILLED
bool lim_spans_close_filling(struct lim_spans *spans, int16_t y, int16_t end, struct lim_closing *closing,
                             lim_piece_fill *sink, struct lim_piece_look *look)
{
    if (LIM_HAS_FRAMEBUFFER && LIM_HOT && (!LIM_HAS_FILL || sink == lim_framebuffer_fill))
        return close_between(spans, y, end, closing, lim_framebuffer_fill_inline, sink, look);
    return close_between(spans, y, end, closing, sink, sink, look);
}
#endif

static uint16_t last_open(const struct lim_spans *spans, const struct lim_line *line)
{
    const struct lim_gap *gap = &line->gap;

    if (lim_spans_have_strips(spans)) return gap->x1;
    while (gap->next != LIM_NONE)
        gap = &spans->pool[gap->next];
    return gap->x1;
}

bool lim_spans_shrink(struct lim_spans *spans)
{
    struct lim_rect open = spans->open;
    uint16_t x0 = open.x1, x1 = open.x0;

    while (open.y0 < open.y1 && lim_line_is_closed(&spans->lines[open.y0]))
        open.y0++;
    while (open.y0 < open.y1 && lim_line_is_closed(&spans->lines[open.y1 - 1]))
        open.y1--;
    struct lim_line *const after = &spans->lines[open.y1];
    for (struct lim_line *line = &spans->lines[open.y0]; line < after; line++) {
        if (lim_line_is_closed(line)) continue;
        if (x0 == open.x0 && x1 == open.x1 && !(LIM_HAS_ANTIALIAS && lim_spans_have_strips(spans))) break;
        if (LIM_HAS_ANTIALIAS && lim_spans_have_strips(spans)) lim_strips_bound(spans, line);
        const uint16_t end = last_open(spans, line);
        if (line->gap.x0 < x0) x0 = line->gap.x0;
        if (end > x1) x1 = end;
    }
    const bool smaller =
        spans->trimmed || x0 > open.x0 || x1 < open.x1 || open.y0 > spans->open.y0 || open.y1 < spans->open.y1;
    spans->open = (struct lim_rect){x0, open.y0, x1, open.y1};
    spans->trimmed = false;
    return smaller;
}

bool lim_spans_see_line(const struct lim_spans *spans, uint16_t y, int16_t x0, int16_t x1)
{
    const struct lim_gap *gap = &spans->lines[y].gap;

    for (; gap && x0 < x1; gap = lim_gap_after(spans, gap))
        if ((int16_t)gap->x1 > x0) return gap->x0 < gap->x1 && (int16_t)gap->x0 < x1;
    return false;
}

bool lim_spans_see(const struct lim_spans *spans, const struct lim_point *at, uint8_t n, uint8_t first,
                   struct lim_span_extent shown)
{
    struct lim_edge_pair pair;

    lim_edge_begin(&pair, n, first);
    for (int16_t y = shown.top; y < shown.bottom; y++) {
        lim_edge_advance(&pair, at, n, y);
        if (lim_spans_see_line(spans, (uint16_t)y, lim_edge_x(&pair.left), lim_edge_x(&pair.right))) return true;
    }
    return false;
}

#endif
