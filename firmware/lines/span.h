/* SPDX-License-Identifier: MIT
 *
 * SPAN: per line, which pixels are still open. A line's open pixels are a list of gaps, left to
 * right, the first one inside the line's own record: most lines never need a second. Memory: one
 * record a line and a pool of further gaps, lent by the caller. */
#ifndef LIM_SPAN_H
#define LIM_SPAN_H

#include "lines/gaps.h"
#include "pixels/target_parts.h"

/* Line y with the pixels of `band` open that the target shows, in one gap. */
static inline void lim_line_open(struct lim_line *line, const struct lim_target *target, const struct lim_rect *band,
                                 uint16_t y)
{
    struct lim_gap *gap = &line->gap; /* set member by member: a copy would be a call of memcpy() */

    gap->x0 = band->x0;
    gap->x1 = band->x1;
    gap->next = LIM_NONE;
    line->retained = LIM_NONE;
    if (lim_target_is_round(target)) {
        uint16_t x0, x1;
        lim_target_visible(target, y, &x0, &x1);
        if (x0 > gap->x0) gap->x0 = x0 < gap->x1 ? x0 : gap->x1;
        if (x1 < gap->x1) gap->x1 = x1 > gap->x0 ? x1 : gap->x0;
    }
}

/* Opens the pixels of `open` that the target shows, and no others. */
void lim_spans_open(struct lim_spans *spans, const struct lim_target *target, const struct lim_rect *open);

/* Gives all gaps back; only single lines are used from now on. */
void lim_spans_reset_pool(struct lim_spans *spans);

/* Closes [x0, x1) of a line; x0 < x1, any values. Pieces that were open go to `sink`, if any. */
enum lim_span_result lim_span_close(struct lim_spans *spans, struct lim_line *line, int16_t x0, int16_t x1,
                                    lim_piece_fill *sink, void *ctx);

/* Whether any of the pixels x0 <= x < x1 of a line is open; or of a polygon of n points that is not non-monotone, on
 * lines `shown`, which it has. */
bool lim_spans_see_line(const struct lim_spans *spans, uint16_t y, int16_t x0, int16_t x1);
bool lim_spans_see(const struct lim_spans *spans, const struct lim_point *at, uint8_t n, uint8_t first,
                   struct lim_span_extent shown);

/* A polygon that is being closed: its boundaries, and the first and the last line of which something was open; NULL:
 * none so far. All that the loop over lines does not need lies behind one pointer, so its registers are its own. */
struct lim_closing {
    struct lim_edge_pair pair;
    struct lim_line *top, *last;
};

/* Closes what lies between the boundaries on the lines y <= line < end, to the end of which both go on, and moves them
 * there; no line above may follow. false: a pool is exhausted; some may be closed. The second form gives the pieces
 * that were open to `sink` instead, with `look` for a context, whose line it sets. */
LIM_MUST_CHECK bool lim_spans_close(struct lim_spans *spans, int16_t y, int16_t end, struct lim_closing *closing);
LIM_MUST_CHECK bool lim_spans_close_filling(struct lim_spans *spans, int16_t y, int16_t end,
                                            struct lim_closing *closing, lim_piece_fill *sink,
                                            struct lim_piece_look *look);

/* Draws `open` together around what is open. true: it became smaller than it was at the last call. */
bool lim_spans_shrink(struct lim_spans *spans);

static inline bool lim_line_is_closed(const struct lim_line *line)
{
    return line->gap.x0 == line->gap.x1;
}

/* Leaves the closed lines at its top and bottom out of `open`. One must be open. */
static inline void lim_spans_trim(struct lim_spans *spans)
{
    struct lim_rect *open = &spans->open;
    const uint16_t y0 = open->y0, y1 = open->y1;

    while (lim_line_is_closed(&spans->lines[open->y0]))
        open->y0++;
    while (lim_line_is_closed(&spans->lines[open->y1 - 1]))
        open->y1--;
    spans->trimmed |= open->y0 != y0 || open->y1 != y1;
}

#endif
