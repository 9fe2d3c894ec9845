/* SPDX-License-Identifier: MIT
 *
 * The ring's lines follow each other without a gap, so a line ends where the next one begins; one that begins where the
 * next one does is not known. A line's runs never fill the ring, or it would seem to have none. */
#include "runs.h"

#include "fill.h"

#if LIM_HAS_DELTA

/* Few come out of order by more than a few places. */
bool lim_line_runs_add(struct lim_line_runs *runs, struct lim_line_run run)
{
    uint16_t at = runs->count;

    if (at == LIM_DELTA_LINE_RUNS) return false;
    runs->count++;
    for (; at && runs->run[at - 1].x0 > run.x0; at--)
        runs->run[at] = runs->run[at - 1];
    runs->run[at] = run;
    return true;
}

bool lim_line_runs_scan(struct lim_line_runs *runs, const uint16_t *line, uint16_t x0, uint16_t x1)
{
    for (uint16_t x = x0; x < x1; x0 = x) {
        const uint16_t value = line[x];
        do
            x++;
        while (x < x1 && line[x] == value);
        if (!lim_line_runs_add(runs, (struct lim_line_run){x0, x, value})) return false;
    }
    return true;
}

static inline void paint_run(uint16_t *line, uint16_t x0, uint16_t x1, uint16_t end, uint16_t value)
{
    lim_fill(line, x0, (uint16_t)((end < x1 ? end : x1) - x0), value);
}

void lim_line_runs_paint(const struct lim_line_runs *runs, uint16_t *line, uint16_t x0, uint16_t x1)
{
    for (const struct lim_line_run *run = runs->run; x0 < x1; run++) {
        const uint16_t end = run->end & LIM_RUN_X;
        if (end <= x0) continue;
        paint_run(line, x0, x1, end, run->value);
        x0 = end;
    }
}

static inline uint16_t after(const struct lim_kept_runs *kept, uint16_t at)
{
    return (uint16_t)(at + 1u == kept->size ? 0 : at + 1u);
}

void lim_kept_runs_paint(const struct lim_kept_runs *kept, uint16_t y, uint16_t *line, uint16_t x0, uint16_t x1)
{
    for (uint16_t at = kept->first[y]; x0 < x1; at = after(kept, at)) {
        const uint16_t end = kept->ring[at].end & LIM_RUN_X;
        if (end <= x0) continue;
        paint_run(line, x0, x1, end, kept->ring[at].value);
        x0 = end;
    }
}

void lim_kept_runs_forget(struct lim_kept_runs *kept)
{
    kept->head = kept->tail = 0;
    for (uint16_t y = 0; y <= kept->h_px; y++)
        kept->first[y] = 0;
}

bool lim_kept_runs_begin(struct lim_kept_runs *kept, uint16_t y)
{
    kept->tail = kept->first[y];
    return kept->tail != kept->first[y + 1];
}

uint16_t lim_kept_runs_used(const struct lim_kept_runs *kept)
{
    return (uint16_t)(kept->head >= kept->tail ? kept->head - kept->tail : kept->head + kept->size - kept->tail);
}

static inline bool continues(const struct lim_line_run *run, const struct lim_line_run *before)
{
    return run->value == before->value && !((run->end ^ before->end) & ~LIM_RUN_X);
}

/* Neighbours of one colour become one run. */
static void push(struct lim_kept_runs *kept, const struct lim_line_runs *runs)
{
    uint16_t self = kept->head;

    for (uint16_t i = 0; i < runs->count; i++) {
        const struct lim_line_run *run = &runs->run[i];
        if (i == 0 || !continues(run, run - 1)) {
            self = kept->head;
            kept->head = after(kept, self);
        }
        kept->ring[self] = (struct lim_kept_run){run->end, run->value};
    }
}

bool lim_kept_runs_keep(struct lim_kept_runs *kept, uint16_t y, const struct lim_line_runs *runs)
{
    kept->first[y] = kept->head;
    const bool fits = runs && runs->count < kept->size - lim_kept_runs_used(kept);
    if (fits) push(kept, runs);
    if (y + 1 == kept->h_px) kept->first[y + 1] = kept->head;
    return fits;
}

bool lim_changes_next(struct lim_changes *changes, uint16_t *x0, uint16_t *x1)
{
    bool differs = false;

    while (changes->x < changes->w_px) {
        const struct lim_line_run *now = &changes->now->run[changes->index];
        const struct lim_kept_run *old = &changes->kept->ring[changes->at];
        const uint16_t now_end = now->end & LIM_RUN_X, old_end = old->end & LIM_RUN_X;
        const uint16_t flags = (uint16_t)((now->end | old->end) & ~LIM_RUN_X);
        const bool same = now->value == old->value && !((now->end ^ old->end) & ~LIM_RUN_X) &&
                          (!(flags & LIM_RUN_TEXTURED) || changes->still);
        if (same && differs) return true;
        if (!same && !differs) *x0 = changes->x;
        differs = !same;
        changes->x = now_end < old_end ? now_end : old_end;
        *x1 = changes->x;
        if (now_end == changes->x) changes->index++;
        if (old_end == changes->x) changes->at = after(changes->kept, changes->at);
    }
    return differs;
}

#endif
