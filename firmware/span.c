/* SPDX-License-Identifier: MIT
 *
 * A piece that covers a gap's left end, right end, middle or all of it: the gap loses its left
 * end, its right end, splits in two (the only case that takes memory), or is unlinked. An emptied
 * gap must be unlinked at once: a later polygon would find its neighbour through it. */
#include "gaps.h"

#if LIM_HAS_SPANS

void lim_spans_reset_pool(struct lim_spans *spans)
{
    spans->free = LIM_NONE;
    spans->fresh = 0;
}

static bool is_closed(const struct lim_line *line)
{
    return line->gap.x0 == line->gap.x1;
}

void lim_spans_open(struct lim_spans *spans, const struct lim_target *target, const struct lim_rect *open)
{
    spans->open = *open;
    spans->open_lines = (uint16_t)(open->y1 - open->y0);
    for (uint16_t y = open->y0; y < open->y1; y++) {
        lim_line_open(&spans->lines[y], target, open, y);
        if (LIM_HAS_ROUND && is_closed(&spans->lines[y])) spans->open_lines--;
    }
    lim_spans_reset_pool(spans);
}

enum lim_span_result lim_span_close(struct lim_spans *spans, struct lim_line *line, int16_t x0, int16_t x1,
                                    lim_span_sink *sink, void *ctx)
{
    enum lim_span_result result = LIM_SPAN_NOTHING;
    struct lim_gap *gap = &line->gap, *before = NULL;

    while (gap) {
        const int16_t open0 = (int16_t)gap->x0, open1 = (int16_t)gap->x1;
        if (open0 >= x1) break;
        struct lim_gap *next = lim_gap_after(spans, gap);
        if (open1 <= x0 || open0 == open1) {
            before = gap;
            gap = next;
            continue;
        }
        const uint16_t from = (uint16_t)(x0 > open0 ? x0 : open0), to = (uint16_t)(x1 < open1 ? x1 : open1);
        if (x0 > open0 && x1 < open1 && !lim_gap_split(spans, gap, from, to)) return LIM_SPAN_EXHAUSTED;
        if (sink) sink(ctx, from, to);
        result = LIM_SPAN_SOME;
        if (x0 <= open0 && x1 >= open1) {
            gap = lim_gap_unlink(spans, gap, before);
            continue;
        }
        if (x0 <= open0)
            gap->x0 = to;
        else
            gap->x1 = from;
        if (x1 < open1) break;
        before = gap;
        gap = next;
    }
    return result;
}

static uint16_t last_open(const struct lim_spans *spans, const struct lim_line *line)
{
    const struct lim_gap *gap = &line->gap;

    while (gap->next != LIM_NONE)
        gap = &spans->pool[gap->next];
    return gap->x1;
}

bool lim_spans_shrink(struct lim_spans *spans)
{
    struct lim_rect open = spans->open;
    uint16_t x0 = open.x1, x1 = open.x0;

    while (open.y0 < open.y1 && is_closed(&spans->lines[open.y0]))
        open.y0++;
    while (open.y0 < open.y1 && is_closed(&spans->lines[open.y1 - 1]))
        open.y1--;
    for (uint16_t y = open.y0; y < open.y1; y++) {
        const struct lim_line *line = &spans->lines[y];
        if (is_closed(line)) continue;
        const uint16_t end = last_open(spans, line);
        if (line->gap.x0 < x0) x0 = line->gap.x0;
        if (end > x1) x1 = end;
    }
    const bool smaller = x0 > open.x0 || x1 < open.x1 || open.y0 > spans->open.y0 || open.y1 < spans->open.y1;
    spans->open = (struct lim_rect){x0, open.y0, x1, open.y1};
    return smaller;
}

#endif
