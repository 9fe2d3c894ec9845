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

/* Receives samples of a line that were open: some in one row at least. */
typedef void lim_strip_sink(void *ctx, const struct lim_strip *open);

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

/* Closes the samples that a strip has on a line that is a list. Those that were open go to `sink`, if any. */
static LIM_INLINE enum lim_span_result lim_strips_close(struct lim_spans *spans, struct lim_line *line,
                                                        const struct lim_strip *strip, lim_strip_sink *sink, void *ctx)
{
    struct lim_open_strip *const pool = *spans->strips;
    enum lim_span_result result = LIM_SPAN_NOTHING;
    uint16_t *link = &line->gap.next;

    while (*link != LIM_NONE) {
        const uint16_t self = *link;
        struct lim_open_strip *gap = &pool[self];
        if (lim_bound_is_before(&gap->open.right, &strip->left)) {
            link = &gap->next;
            continue;
        }
        const struct lim_strip common = lim_strip_common(strip, &gap->open);
        const bool ends_here = lim_bound_equals(&common.right, &strip->right);
        if (lim_bound_equals(&common.left, &common.right)) {
            if (ends_here || lim_bound_is_before(&strip->right, &gap->open.left)) break;
            link = &gap->next;
            continue;
        }
        const bool leaves_left = !lim_bound_equals(&common.left, &gap->open.left);
        if (lim_bound_equals(&common.right, &gap->open.right)) {
            if (leaves_left) {
                gap->open.right = common.left;
                link = &gap->next;
            } else {
                *link = gap->next;
                gap->next = spans->free;
                spans->free = self;
            }
        } else {
            if (leaves_left) {
                const uint16_t right = lim_strip_new(spans);
                if (right == LIM_NONE) return LIM_SPAN_EXHAUSTED;
                pool[right].open.right = gap->open.right;
                pool[right].next = gap->next;
                gap->open.right = common.left;
                gap->next = right;
                gap = &pool[right];
            }
            gap->open.left = common.right;
            link = &gap->next;
        }
        result = LIM_SPAN_SOME;
        if (sink) sink(ctx, &common);
        if (ends_here) break;
    }
    if (line->gap.next == LIM_NONE) {
        line->gap.x0 = line->gap.x1 = 0;
        spans->open_lines--;
    }
    return result;
}

#endif
