/* SPDX-License-Identifier: MIT
 *
 * Lines as runs of one colour: what delta output knows of a frame. The line that is drawn is an array in which each run
 * stands where it begins, so that runs may come in any order; the lines of a frame follow each other in a ring, where
 * this frame's take the place of the last one's. In: pieces as SPAN finds them, or a painted line. Out: where two
 * frames differ. Memory: array and ring, lent. */
#ifndef LIM_RUNS_H
#define LIM_RUNS_H

#include "orders.h"

/* A run: the x after its last pixel from bit 20 on; below, its look: a colour as it lies in memory, or one of these. */
#define LIM_RUN_END_BIT 20
#define LIM_RUN_LOOK ((UINT32_C(1) << LIM_RUN_END_BIT) - 1u)
#define LIM_RUN_TEXTURED (UINT32_C(1) << 16) /* with which texture */
#define LIM_RUN_UNSEEN (UINT32_C(1) << 17)   /* behind the rim of round glass */
#define LIM_RUN_MOVES (UINT32_C(1) << 18)    /* the texture of what moves: never the same as before */

static inline uint16_t lim_run_end(uint32_t run)
{
    return (uint16_t)(run >> LIM_RUN_END_BIT);
}

/* Pixels x0 <= x < x1, x0 < x1, of the line that is drawn. Each is noted once. */
static inline void lim_runs_note(struct lim_runs *runs, uint16_t x0, uint16_t x1, uint32_t look)
{
    runs->line[x0] = (uint32_t)x1 << LIM_RUN_END_BIT | look;
}

/* Notes x0 <= x < x1 of a line that is painted. */
void lim_runs_scan(struct lim_runs *runs, const uint16_t *line, uint16_t x0, uint16_t x1);

/* Nothing is known of the last frame. */
void lim_runs_forget(struct lim_runs *runs);

/* Lines are begun from the top down. false: the last frame's is not known. */
bool lim_runs_begin(struct lim_runs *runs, uint16_t y);

/* What becomes of line y, which has been begun. The last frame's runs are there until the next line is. */
enum lim_runs_kept { LIM_RUNS_LOST, LIM_RUNS_KEPT, LIM_RUNS_TEXTURED };

/* Keeps what was noted. LIM_RUNS_LOST: there is no room for it. */
enum lim_runs_kept lim_runs_keep(struct lim_runs *runs, uint16_t y);

/* Leaves it unknown. */
void lim_runs_lose(struct lim_runs *runs, uint16_t y);

/* Paints x0 <= x < x1 of a line: of the one that is drawn, or of one that was kept. No texture may be there. */
void lim_runs_paint_noted(const struct lim_runs *runs, uint16_t *line, uint16_t x0, uint16_t x1);
void lim_runs_paint(const struct lim_runs *runs, uint16_t y, uint16_t *line, uint16_t x0, uint16_t x1);

/* How much of the ring is in use. */
uint16_t lim_runs_used(const struct lim_runs *runs);

/* Where a line that was kept differs from the last frame's, which is known: changes from left to right. */
struct lim_changes {
    const struct lim_runs *runs;
    const uint32_t *now, *old; /* in the ring */
    uint32_t restless; /* looks that are never the same: LIM_RUN_TEXTURED, if the camera has moved, LIM_RUN_MOVES */
    uint16_t x;
};

static inline struct lim_changes lim_runs_compare(const struct lim_runs *runs, uint16_t y, bool still)
{
    const struct lim_changes changes = {runs, runs->ring + runs->first[y], runs->ring + runs->tail,
                                        (still ? 0 : LIM_RUN_TEXTURED) | (LIM_HAS_MOVERS ? LIM_RUN_MOVES : 0), 0};
    return changes;
}

/* Pixels *x0 <= x < *x1 may differ. false: no others do. */
bool lim_changes_next(struct lim_changes *changes, uint16_t *x0, uint16_t *x1);

#endif
