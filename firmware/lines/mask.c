/* SPDX-License-Identifier: MIT
 *
 * A gap is first cut to what a run has of it; then that has lost samples, and is unlinked if these were its last. What
 * a run has at the end of a gap, and closes, is taken off without a cut: so the insides of polygons cost what they cost
 * in span.c. */
#include "lines/mask.h"

#include "lines/gaps.h"
#include "screen/samples.h"

#if LIM_HAS_ANTIALIAS

/* Where a line's list is being read: `before` is NULL at its first gap, `gap` at its end. */
struct place {
    struct lim_gap *before, *gap;
};

static void step(const struct lim_spans *spans, struct place *place)
{
    place->before = place->gap;
    place->gap = lim_gap_after(spans, place->gap);
}

/* Closes samples of pixels at one end or all of the place's gap, or cuts them out of it. false: no room. */
static bool close_part(struct lim_spans *spans, struct place *place, const struct lim_run *run)
{
    struct lim_gap *gap = place->gap;
    const uint16_t covered = *gap->covered | run->mask, x0 = (uint16_t)run->x0, x1 = (uint16_t)run->x1;
    const bool closes = covered == LIM_ALL_SAMPLES;

    if (closes && x0 == gap->x0 && x1 < gap->x1) {
        gap->x0 = x1;
        return true;
    }
    if (closes && x0 > gap->x0 && x1 == gap->x1) {
        gap->x1 = x0;
        step(spans, place);
        return true;
    }
    if (x1 < gap->x1 && !lim_gap_split(spans, gap, x1, x1)) return false;
    if (x0 > gap->x0) {
        if (!closes && !lim_gap_split(spans, gap, x0, x0)) return false;
        gap->x1 = x0;
        step(spans, place);
        if (closes) return true;
        gap = place->gap;
    }
    *gap->covered = covered;
    if (closes)
        place->gap = lim_gap_unlink(spans, gap, place->before);
    else
        step(spans, place);
    return true;
}

/* What of a gap's open samples the run has. mask 0: none. */
static inline void set_common(struct lim_run *open, const struct lim_gap *gap, const struct lim_run *run)
{
    const int16_t x0 = (int16_t)gap->x0, x1 = (int16_t)gap->x1;

    open->x0 = run->x0 > x0 ? run->x0 : x0;
    open->x1 = run->x1 < x1 ? run->x1 : x1;
    open->mask = (uint16_t)(run->mask & ~*gap->covered);
}

/* Closes what is open of a run, which begins in the place's gap. Leaves the place behind it. false: no room. */
static bool close_run(struct lim_spans *spans, struct place *place, const struct lim_run *run, lim_mask_sink *sink,
                      void *ctx, bool *any)
{
    while (place->gap && (int16_t)place->gap->x0 < run->x1) {
        struct lim_run open;
        const uint16_t covered = *place->gap->covered;
        set_common(&open, place->gap, run);
        if (!open.mask) {
            if ((int16_t)place->gap->x1 > run->x1) return true;
            step(spans, place);
            continue;
        }
        if (!close_part(spans, place, &open)) return false;
        if (sink) sink(ctx, &open, covered);
        *any = true;
    }
    return true;
}

enum lim_span_result lim_mask_close(struct lim_spans *spans, struct lim_line *line, const struct lim_strip *strip,
                                    lim_mask_sink *sink, void *ctx)
{
    struct place place = {NULL, line->gap.x0 < line->gap.x1 ? &line->gap : NULL};
    int16_t x = strip->x0;
    bool any = false;

    for (;;) {
        while (place.gap && (int16_t)place.gap->x1 <= x)
            step(spans, &place);
        if (!place.gap) break;
        if ((int16_t)place.gap->x0 > x) x = (int16_t)place.gap->x0;
        if (x >= strip->x1) break;
        struct lim_run run;
        lim_strip_run(strip, x, &run);
        if (run.mask && !close_run(spans, &place, &run, sink, ctx, &any)) return LIM_SPAN_EXHAUSTED;
        x = run.x1;
    }
    return any ? LIM_SPAN_SOME : LIM_SPAN_NOTHING;
}

bool lim_mask_see(const struct lim_spans *spans, const struct lim_line *line, const struct lim_strip *strip,
                  lim_mask_sink *sink, void *ctx)
{
    const struct lim_gap *gap = &line->gap;
    bool any = false;

    for (int16_t x = strip->x0; x < strip->x1;) {
        while (gap && ((int16_t)gap->x1 <= x || gap->x0 == gap->x1))
            gap = lim_gap_after(spans, gap);
        if (!gap) break;
        if ((int16_t)gap->x0 > x) x = (int16_t)gap->x0;
        if (x >= strip->x1) break;
        struct lim_run run, open;
        lim_strip_run(strip, x, &run);
        set_common(&open, gap, &run);
        if (open.mask) {
            any = true;
            if (!sink) break;
            sink(ctx, &open, *gap->covered);
        }
        x = open.x1;
    }
    return any;
}

#endif
