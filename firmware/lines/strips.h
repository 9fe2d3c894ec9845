/* SPDX-License-Identifier: MIT
 *
 * SPAN for antialiasing: per line, which samples are still open. A gap has four rows, each with a beginning and an end
 * of its own: what an edge leaves of it is a gap again, however level the edge. Memory: the pool of gaps. */
#ifndef LIM_STRIPS_H
#define LIM_STRIPS_H

#include "lines/gaps.h"
#include "lines/share.h"
#include "screen/samples.h"

/* A gap, antialiased: samples that are open, some at least, left <= right in all rows. In a line's list, for each row,
 * one ends before the next begins. */
struct lim_open_strip {
    struct lim_strip open;
    uint16_t next; /* in the pool, or LIM_NONE */
};

LIM_STATIC_ASSERT(!LIM_HAS_ANTIALIAS || sizeof(struct lim_open_strip) <= LIM_GAP_MEM_B, "a gap has its room");

/* Receives samples of a line that were open, some in one row at least: the rows of a left and of a right bound. Words,
 * because compilers keep them in registers. */
typedef void lim_strip_sink(void *ctx, uint32_t left0, uint32_t left1, uint32_t right0, uint32_t right1);

static LIM_INLINE void lim_strip_to_sink(lim_strip_sink *sink, void *ctx, const struct lim_bound *left,
                                         const struct lim_bound *right)
{
    if (sink) sink(ctx, left->rows[0], left->rows[1], right->rows[0], right->rows[1]);
}

/* LIM_NONE: there is none left. */
static inline uint16_t lim_strip_new(struct lim_spans *spans)
{
    const uint16_t taken = spans->free;

    if (taken == LIM_NONE) return spans->fresh > spans->lowest ? --spans->fresh : LIM_NONE;
    spans->free = (*spans->strips)[taken].next;
    return taken;
}

/* A line's pixels, all of which are open, as a list. false: there is no room. */
bool lim_strips_begin(struct lim_spans *spans, struct lim_line *line);

/* Makes a line's gap hold all that is open on it. */
void lim_strips_bound(const struct lim_spans *spans, struct lim_line *line);

/* What of a strip's samples is open, to `sink`; it stays open. true: something is. Without a sink the answer is all
 * there is. */
bool lim_strips_see(const struct lim_spans *spans, const struct lim_line *line, const struct lim_strip *strip,
                    lim_strip_sink *sink, void *ctx);

/* Where edges cross within the line: lim_strips_close() of the one gap which `link` leads to. Returns the link from
 * which to go on, or NULL: there is no room. */
uint16_t *lim_strips_close_crossing(const struct lim_strip *strip, struct lim_spans *spans, uint16_t *link,
                                    lim_strip_sink *sink, void *ctx, enum lim_span_result *result);

/* Unlinks the gap that `link` leads to. */
static inline void lim_strip_give_back(struct lim_spans *spans, uint16_t *link, struct lim_open_strip *gap)
{
    const uint16_t self = *link;

    *link = gap->next;
    gap->next = spans->free;
    spans->free = self;
}

/* Puts a new gap behind one, from a bound up to where that ends. false: there is no room. */
static inline bool lim_strip_split(struct lim_spans *spans, struct lim_open_strip *gap, const struct lim_bound *from)
{
    const uint16_t right = lim_strip_new(spans);

    if (right == LIM_NONE) return false;
    struct lim_open_strip *rest = &(*spans->strips)[right];
    rest->open.left = *from;
    rest->open.right = gap->open.right;
    rest->next = gap->next;
    gap->next = right;
    return true;
}

/* The same where both bounds of a strip are within the gap. */
uint16_t *lim_strips_divide(const struct lim_strip *strip, struct lim_spans *spans, uint16_t *link,
                            lim_strip_sink *sink, void *ctx, enum lim_span_result *result);

static inline void lim_strips_note_closed(struct lim_spans *spans, struct lim_line *line)
{
    if (line->gap.next != LIM_NONE) return;
    line->gap.x0 = line->gap.x1 = 0;
    spans->open_lines--;
}

/* Closes the samples that a strip has on a line that is a list. Those that were open go to `sink`, if any. Most edges
 * are in the same order in all rows. */
static LIM_INLINE enum lim_span_result lim_strips_close(struct lim_spans *spans, struct lim_line *line,
                                                        struct lim_bound left, struct lim_bound right,
                                                        lim_strip_sink *sink, void *ctx)
{
    struct lim_open_strip *const pool = *spans->strips;
    enum lim_span_result result = LIM_SPAN_NOTHING;
    uint16_t *link = &line->gap.next;

    while (*link != LIM_NONE) {
        struct lim_open_strip *gap = &pool[*link];
        const struct lim_bound open_left = gap->open.left, open_right = gap->open.right;
        if (lim_bound_is_seldom_before(&open_right, &left)) {
            link = &gap->next;
            continue;
        }
        if (lim_bound_is_seldom_before(&right, &open_left)) break;
        const bool to_end = lim_bound_is_before(&open_right, &right);
        enum lim_span_result some;
        if (lim_bound_is_before(&left, &open_left)) {
            if (to_end) {
                lim_strip_to_sink(sink, ctx, &open_left, &open_right);
                lim_strip_give_back(spans, link, gap);
                lim_strips_note_closed(spans, line);
                result = LIM_SPAN_SOME;
                continue;
            }
            if (lim_bound_is_before(&open_left, &right) && lim_bound_is_before(&right, &open_right)) {
                lim_strip_to_sink(sink, ctx, &open_left, &right);
                gap->open.left = right;
                return LIM_SPAN_SOME;
            }
        } else if (to_end && lim_bound_is_before(&open_left, &left) && lim_bound_is_before(&left, &open_right)) {
            lim_strip_to_sink(sink, ctx, &left, &open_right);
            gap->open.right = left;
            result = LIM_SPAN_SOME;
            link = &gap->next;
            continue;
        } else if (!to_end && lim_bound_is_before(&open_left, &left) && lim_bound_is_before(&right, &open_right)) {
            if (!lim_strips_divide(&(struct lim_strip){left, right}, spans, link, sink, ctx, &some))
                return LIM_SPAN_EXHAUSTED;
            lim_strips_note_closed(spans, line);
            return some == LIM_SPAN_SOME ? some : result;
        }
        link = lim_strips_close_crossing(&(struct lim_strip){left, right}, spans, link, sink, ctx, &some);
        if (!link) return LIM_SPAN_EXHAUSTED;
        if (some == LIM_SPAN_SOME) result = some;
        lim_strips_note_closed(spans, line);
    }
    return result;
}

#endif
