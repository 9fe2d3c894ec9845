/* SPDX-License-Identifier: MIT
 *
 * Runs cover a line without a gap, so the next one begins where the last one ends; and the ring's lines follow each
 * other without a gap, so a line ends where the next one begins. It is never quite full: a line would seem to have no
 * runs. */
#include "pixels/runs.h"

#include "pixels/fill.h"

#if LIM_HAS_DELTA

void lim_runs_scan(struct lim_runs *runs, const uint16_t *line, uint16_t x0, uint16_t x1)
{
    for (uint16_t x = x0; x < x1; x0 = x) {
        const uint16_t colour = line[x];
        do
            x++;
        while (x < x1 && line[x] == colour);
        lim_runs_note(runs, x0, x, colour);
    }
}

void lim_runs_forget(struct lim_runs *runs)
{
    runs->head = runs->tail = 0;
    for (uint16_t y = 0; y <= runs->h_px; y++)
        runs->first[y] = 0;
}

bool lim_runs_begin(struct lim_runs *runs, uint16_t y)
{
    runs->tail = runs->first[y];
    return runs->tail != runs->first[y + 1];
}

uint16_t lim_runs_used(const struct lim_runs *runs)
{
    return (uint16_t)(runs->head >= runs->tail ? runs->head - runs->tail : runs->head + runs->size - runs->tail);
}

static inline const uint32_t *after(const struct lim_runs *runs, const uint32_t *run)
{
    return run + 1 == runs->ring + runs->size ? runs->ring : run + 1;
}

/* Behind the last line is the first one of the next frame. */
static void end_line(struct lim_runs *runs, uint16_t y)
{
    if (y + 1 == runs->h_px) runs->first[y + 1] = runs->head;
}

void lim_runs_lose(struct lim_runs *runs, uint16_t y)
{
    runs->first[y] = runs->head;
    end_line(runs, y);
}

/* Neighbours of one look become one run. */
enum lim_runs_kept lim_runs_keep(struct lim_runs *runs, uint16_t y)
{
    uint16_t room = (uint16_t)(runs->size - 1u - lim_runs_used(runs)), head = runs->head;
    uint32_t run = runs->line[0], looks = 0;

    for (;;) {
        const uint16_t x = lim_run_end(run);
        const bool ends = x == runs->w_px;
        const uint32_t next = ends ? ~run : runs->line[x];
        if ((run ^ next) & LIM_RUN_LOOK) {
            if (!room--) {
                lim_runs_lose(runs, y);
                return LIM_RUNS_LOST;
            }
            runs->ring[head] = run;
            head = head + 1u == runs->size ? 0 : (uint16_t)(head + 1u);
            looks |= run;
        }
        if (ends) break;
        run = next;
    }
    runs->first[y] = runs->head;
    runs->head = head;
    end_line(runs, y);
    return looks & LIM_RUN_TEXTURED ? LIM_RUNS_TEXTURED : LIM_RUNS_KEPT;
}

void lim_runs_paint_noted(const struct lim_runs *runs, uint16_t *line, uint16_t x0, uint16_t x1)
{
    for (uint16_t x = 0, end; x < x1; x = end) {
        const uint32_t run = runs->line[x];
        end = lim_run_end(run) < x1 ? lim_run_end(run) : x1;
        if (end <= x0) continue;
        const uint16_t from = x > x0 ? x : x0;
        lim_fill(line, from, (uint16_t)(end - from), (uint16_t)run);
    }
}

void lim_runs_paint(const struct lim_runs *runs, uint16_t y, uint16_t *line, uint16_t x0, uint16_t x1)
{
    const uint32_t *at = runs->ring + runs->first[y];

    while (lim_run_end(*at) <= x0)
        at = after(runs, at);
    for (uint16_t end; x0 < x1; x0 = end) {
        end = lim_run_end(*at) < x1 ? lim_run_end(*at) : x1;
        lim_fill(line, x0, (uint16_t)(end - x0), (uint16_t)*at);
        at = after(runs, at);
    }
}

bool lim_changes_next(struct lim_changes *changes, uint16_t *x0, uint16_t *x1)
{
    const struct lim_runs *runs = changes->runs;
    const uint32_t *now = changes->now, *old = changes->old;
    uint16_t x = changes->x;
    bool differs = false;

    while (x < runs->w_px) {
        const uint32_t is = *now, was = *old;
        if (!(((is ^ was) & LIM_RUN_LOOK) | (is & changes->restless))) {
            if (differs) break;
        } else if (!differs) {
            *x0 = x;
            differs = true;
        }
        const uint16_t is_end = lim_run_end(is), was_end = lim_run_end(was);
        if (is_end <= was_end) now = after(runs, now);
        if (was_end <= is_end) old = after(runs, old);
        x = is_end < was_end ? is_end : was_end;
    }
    *x1 = changes->x = x;
    changes->now = now;
    changes->old = old;
    return differs;
}

#endif
