/* SPDX-License-Identifier: MIT
 *
 * DELTA: only what differs from the last frame is sent. Between SPAN and PAINT: a line's pieces become runs of one
 * colour, which are compared with the runs that the line had in the last frame; changes are put together to rectangles,
 * which are painted from the runs of this frame. No framebuffer: a run takes four bytes. In: pieces of lines, or
 * painted lines. Out: windows and pixels, to the target. What is sent makes the panel's memory equal to the whole
 * frame. */
#ifndef LIM_DELTA_H
#define LIM_DELTA_H

#include "pixels/runs.h"

/* Prepares the memory, whose size is known, for changes of a target. LIM_ERR_MEMORY: it is too small; LIM_ERR_TARGET:
 * the target has no window(), or does not tell its costs. */
int lim_delta_init(struct lim_delta *delta, const struct lim_target *target, size_t mem_b);

/* What the renderer gets for a target: lines are compared there, so nothing else is offered. */
struct lim_target lim_delta_stage(struct lim_delta *delta);

/* PAINT notes every piece of a line that it has begun, in any order; `line` is NULL if it does not paint them. A line
 * that it has not begun is painted, and looked at when it is done. */
static inline void lim_delta_begin_line(struct lim_delta *delta, uint16_t *line)
{
    delta->line = line;
    delta->noted = true;
}

static inline void lim_delta_note(struct lim_delta *delta, uint16_t x0, uint16_t x1, uint32_t look)
{
    lim_runs_note(&delta->runs, x0, x1, look);
}

/* Whether lines are painted even if all that they hold is noted. */
bool lim_delta_wants_lines(const struct lim_delta *delta);

/* Round a frame, of which `err` is the outcome, counted in `stats`. After an error the next frame is whole. */
void lim_delta_begin_frame(struct lim_delta *delta, const struct lim_camera *camera, struct lim_stats *stats);
LIM_MUST_CHECK int lim_delta_end_frame(struct lim_delta *delta, int err);

#endif
