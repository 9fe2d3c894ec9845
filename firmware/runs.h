/* SPDX-License-Identifier: MIT
 *
 * Lines as runs of one colour: what delta output knows of a frame. Of the line that is being drawn an array, sorted
 * from left to right; of all lines a ring, in which a line's runs of this frame take the place of those of the last.
 * In: pieces as SPAN finds them, nearest first, or a painted line. Out: where two frames differ. Memory: the ring,
 * lent. */
#ifndef LIM_RUNS_H
#define LIM_RUNS_H

#include "config.h"

/* Most runs of a line that are told apart; a line with more is sent whole. */
#ifndef LIM_DELTA_LINE_RUNS
#define LIM_DELTA_LINE_RUNS 64
#endif

/* Beside a run's end. Its value is a colour as it lies in memory, or which texture it has. */
#define LIM_RUN_TEXTURED 0x8000u
#define LIM_RUN_UNSEEN 0x4000u /* behind the rim of round glass */
#define LIM_RUN_X 0x07FFu

/* Pixels x0 <= x < end. */
struct lim_line_run {
    uint16_t x0, end; /* end with LIM_RUN_... */
    uint16_t value;
};

struct lim_line_runs {
    uint16_t count;
    struct lim_line_run run[LIM_DELTA_LINE_RUNS];
};

/* From where the run before it ended. */
struct lim_kept_run {
    uint16_t end, value;
};

struct lim_kept_runs {
    struct lim_kept_run *ring;
    uint16_t size; /* of the ring; one less can be in use */
    uint16_t head; /* where the next run goes */
    uint16_t tail; /* the oldest run: that of the line that is drawn, in the last frame */
    uint16_t *
        first; /* of each line and of one more: this frame's before the line that is drawn, the last frame's after it */
    uint16_t h_px;
};

/* Adds a piece of the line in whatever order they come. false: there are too many. */
bool lim_line_runs_add(struct lim_line_runs *runs, struct lim_line_run run);

/* A line that is painted: x0 <= x < x1 of it. false: too many runs. */
bool lim_line_runs_scan(struct lim_line_runs *runs, const uint16_t *line, uint16_t x0, uint16_t x1);

/* Paints x0 <= x < x1 of a line from its runs, none of which may have a texture there. */
void lim_line_runs_paint(const struct lim_line_runs *runs, uint16_t *line, uint16_t x0, uint16_t x1);
void lim_kept_runs_paint(const struct lim_kept_runs *kept, uint16_t y, uint16_t *line, uint16_t x0, uint16_t x1);

/* Nothing is known of the last frame. */
void lim_kept_runs_forget(struct lim_kept_runs *kept);

/* Lines are begun from the top down. false: the last frame's is not known. */
bool lim_kept_runs_begin(struct lim_kept_runs *kept, uint16_t y);

/* Adds line y's runs of this frame; those of the last one stay until the next line is begun. false: there is no room,
 * or `runs` is NULL: this frame's line is not known. */
bool lim_kept_runs_keep(struct lim_kept_runs *kept, uint16_t y, const struct lim_line_runs *runs);

/* Of the ring, the last frame's line that is drawn included. */
uint16_t lim_kept_runs_used(const struct lim_kept_runs *kept);

/* From begin to the next begin: the next change of the line. */
struct lim_changes {
    const struct lim_line_runs *now;
    const struct lim_kept_runs *kept;
    bool still; /* what has the same texture looks the same */
    uint16_t w_px;
    uint16_t at, index, x; /* all three begin with tail, 0, 0 */
};

/* Pixels *x0 <= x < *x1 may differ. false: no others do. */
bool lim_changes_next(struct lim_changes *changes, uint16_t *x0, uint16_t *x1);

#endif
