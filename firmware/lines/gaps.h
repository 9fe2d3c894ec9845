/* SPDX-License-Identifier: MIT
 *
 * The list of a line's gaps, and the pool that all but its first are from. */
#ifndef LIM_GAPS_H
#define LIM_GAPS_H

#include "stages.h"

/* What became of pixels, or samples, that were to be closed. */
enum lim_span_result {
    LIM_SPAN_NOTHING = 0,  /* all of it was closed before */
    LIM_SPAN_SOME = 1,     /* some of it was open, and is closed now */
    LIM_SPAN_EXHAUSTED = 2 /* no gap was left in the pool; the lines are as they were found or further */
};

/* NULL behind the last one. */
static inline struct lim_gap *lim_gap_after(const struct lim_spans *spans, const struct lim_gap *gap)
{
    return gap->next == LIM_NONE ? NULL : &spans->pool[gap->next];
}

/* LIM_NONE: there is none left. */
static inline uint_fast16_t lim_gap_new(struct lim_spans *spans)
{
    const uint_fast16_t taken = spans->free;

    if (taken == LIM_NONE) {
        const uint_fast16_t fresh = spans->fresh;
        if (fresh <= spans->lowest) return LIM_NONE;
        spans->fresh = (uint16_t)(fresh - 1);
        return fresh - 1;
    }
    spans->free = spans->pool[taken].next;
    return taken;
}

static inline void lim_gap_give_back(struct lim_spans *spans, uint16_t gap)
{
    spans->pool[gap].next = spans->free;
    spans->free = gap;
}

/* Member by member: a struct of 16 bits each would be copied by memcpy(). */
static inline void lim_gap_copy(struct lim_gap *to, const struct lim_gap *from)
{
    to->x0 = from->x0;
    to->x1 = from->x1;
    to->next = from->next;
}

/* A line's only gap, of which nothing is left. */
static inline void lim_gap_close_last(struct lim_spans *spans, struct lim_gap *gap)
{
    gap->x0 = gap->x1 = 0;
    spans->open_lines--;
}

/* Unlinks a gap whose predecessor is `before` (NULL: it is the line's first). Returns the gap that follows, now
 * in its place, or NULL. */
static inline struct lim_gap *lim_gap_unlink(struct lim_spans *spans, struct lim_gap *gap, struct lim_gap *before)
{
    const uint16_t next = gap->next;

    if (before) {
        const uint16_t self = before->next;
        before->next = next;
        lim_gap_give_back(spans, self);
        return lim_gap_after(spans, before);
    }
    if (next == LIM_NONE) {
        lim_gap_close_last(spans, gap);
        return NULL;
    }
    lim_gap_copy(gap, &spans->pool[next]);
    lim_gap_give_back(spans, next);
    return gap;
}

/* The gap ends at x0, and a new one that follows it has its pixels from x1 on: all within the gap, x0 <= x1. false: no
 * room. */
static inline bool lim_gap_split(struct lim_spans *spans, struct lim_gap *gap, uint16_t x0, uint16_t x1)
{
    const uint_fast16_t right = lim_gap_new(spans);

    if (right == LIM_NONE) return false;
    struct lim_gap *rest = &spans->pool[right];
    rest->x0 = x1;
    rest->x1 = gap->x1;
    rest->next = gap->next;
    gap->x1 = x0;
    gap->next = (uint16_t)right;
    return true;
}

/* Of what closing a line's pixels comes to where it has one gap, or none. [*x0, *x1) becomes the piece that was open:
 * a caller that does not look at it pays nothing for it. A closed line's gap is anywhere. */
static LIM_HOT_INLINE enum lim_span_result lim_gap_close_only(struct lim_spans *spans, struct lim_gap *gap, int32_t *x0,
                                                              int32_t *x1)
{
    const int32_t open0 = gap->x0, open1 = gap->x1;

    if (*x0 <= open0) {
        if (*x1 <= open0) return LIM_SPAN_NOTHING;
        *x0 = open0;
        if (*x1 < open1) {
            gap->x0 = (uint16_t)*x1;
            return LIM_SPAN_SOME;
        }
        if (open0 == open1) return LIM_SPAN_NOTHING;
        *x1 = open1;
        lim_gap_close_last(spans, gap);
        return LIM_SPAN_SOME;
    }
    if (*x1 >= open1) {
        if (*x0 >= open1) return LIM_SPAN_NOTHING;
        *x1 = open1;
        gap->x1 = (uint16_t)*x0;
        return LIM_SPAN_SOME;
    }
    if (*x0 >= *x1) return LIM_SPAN_NOTHING;
    return lim_gap_split(spans, gap, (uint16_t)*x0, (uint16_t)*x1) ? LIM_SPAN_SOME : LIM_SPAN_EXHAUSTED;
}

#endif
