/* SPDX-License-Identifier: MIT
 *
 * A line whose pixels are all open takes no memory of the pool: most of a frame's lines are either that or closed. */
#include "lines/strips.h"

#if LIM_HAS_ANTIALIAS

LIM_ALONE uint16_t *lim_strips_close_crossing(const struct lim_strip *strip, struct lim_spans *spans, uint16_t *link,
                                              lim_strip_sink *sink, void *ctx, enum lim_span_result *result)
{
    struct lim_open_strip *gap = &(*spans->strips)[*link];
    const struct lim_strip common = lim_strip_common(strip, &gap->open);

    *result = LIM_SPAN_NOTHING;
    if (lim_bound_equals(&common.left, &common.right)) return &gap->next;
    const bool leaves_left = !lim_bound_equals(&common.left, &gap->open.left);
    if (lim_bound_equals(&common.right, &gap->open.right)) {
        if (leaves_left) {
            gap->open.right = common.left;
            link = &gap->next;
        } else {
            lim_strip_give_back(spans, link, gap);
        }
    } else if (leaves_left) {
        if (!lim_strip_split(spans, gap, &common.right)) return NULL;
        gap->open.right = common.left;
        link = &(*spans->strips)[gap->next].next;
    } else {
        gap->open.left = common.right;
        link = &gap->next;
    }
    *result = LIM_SPAN_SOME;
    lim_strip_to_sink(sink, ctx, &common.left, &common.right);
    return link;
}

LIM_ALONE uint16_t *lim_strips_divide(const struct lim_strip *strip, struct lim_spans *spans, uint16_t *link,
                                      lim_strip_sink *sink, void *ctx, enum lim_span_result *result)
{
    struct lim_open_strip *gap = &(*spans->strips)[*link];

    if (!lim_bound_is_before(&strip->left, &strip->right))
        return lim_strips_close_crossing(strip, spans, link, sink, ctx, result);
    *result = LIM_SPAN_NOTHING;
    if (lim_bound_equals(&strip->left, &strip->right)) return &gap->next;
    if (!lim_strip_split(spans, gap, &strip->right)) return NULL;
    *result = LIM_SPAN_SOME;
    gap->open.right = strip->left;
    lim_strip_to_sink(sink, ctx, &strip->left, &strip->right);
    return &gap->next;
}

bool lim_strips_begin(struct lim_spans *spans, struct lim_line *line)
{
    const uint16_t self = lim_strip_new(spans);

    if (self == LIM_NONE) return false;
    struct lim_open_strip *gap = &(*spans->strips)[self];
    gap->open.left = lim_bound_at(line->gap.x0 * LIM_SAMPLES_A_ROW);
    gap->open.right = lim_bound_at(line->gap.x1 * LIM_SAMPLES_A_ROW);
    gap->next = LIM_NONE;
    line->gap.next = self;
    return true;
}

void lim_strips_bound(const struct lim_spans *spans, struct lim_line *line)
{
    if (line->gap.next == LIM_NONE) return;
    const struct lim_open_strip *gap = &(*spans->strips)[line->gap.next];

    line->gap.x0 = (uint16_t)(lim_bound_low(&gap->open.left) / LIM_SAMPLES_A_ROW - LIM_STRIP_BIAS_PX);
    while (gap->next != LIM_NONE)
        gap = &(*spans->strips)[gap->next];
    line->gap.x1 =
        (uint16_t)((lim_bound_high(&gap->open.right) + LIM_SAMPLES_A_ROW - 1) / LIM_SAMPLES_A_ROW - LIM_STRIP_BIAS_PX);
}

/* false: nothing of it is open. */
static bool see_in(const struct lim_strip *open, const struct lim_strip *strip, lim_strip_sink *sink, void *ctx)
{
    const struct lim_strip common = lim_strip_common(strip, open);

    if (lim_bound_equals(&common.left, &common.right)) return false;
    lim_strip_to_sink(sink, ctx, &common.left, &common.right);
    return true;
}

bool lim_strips_see(const struct lim_spans *spans, const struct lim_line *line, const struct lim_strip *strip,
                    lim_strip_sink *sink, void *ctx)
{
    bool any = false;

    if (line->gap.next == LIM_NONE) {
        const struct lim_strip open = {lim_bound_at(line->gap.x0 * LIM_SAMPLES_A_ROW),
                                       lim_bound_at(line->gap.x1 * LIM_SAMPLES_A_ROW)};
        return see_in(&open, strip, sink, ctx);
    }
    for (uint16_t at = line->gap.next; at != LIM_NONE && (sink || !any); at = (*spans->strips)[at].next)
        any |= see_in(&(*spans->strips)[at].open, strip, sink, ctx);
    return any;
}

#endif
