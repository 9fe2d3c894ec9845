/* SPDX-License-Identifier: MIT
 *
 * Pictures of where a method is wrong: the frame in dim grey; in red what an exact order would not show there, or a
 * hole; in amber what shows another face than the reference and is no worse than that, at edges above all. */
#ifndef SIM_DIFFERENCE_H
#define SIM_DIFFERENCE_H

#include "measure/measurement.h"

#include <gd.h>

/* One frame, and what was counted in it (NULL: not asked for); gdImageDestroy() it. NULL: see err. */
gdImagePtr difference_picture(struct measure_source *source, const struct measure_candidate *candidate,
                              const struct measure_views *views, size_t frame, struct compare_counts *counts,
                              struct error *err);

/* The frame as it is, and what it took (NULL: not asked for). Likewise. */
gdImagePtr frame_picture(const struct measure_candidate *candidate, const struct measure_views *views, size_t frame,
                         struct lim_stats *stats, struct error *err);

/* A cell of a sheet. */
struct difference_cell {
    gdImagePtr picture; /* NULL: there is none */
    char caption[64];
};

/* All cells in a grid, each below its caption. gdImageDestroy() it; NULL: out of memory. */
gdImagePtr difference_sheet(const struct difference_cell *cells, size_t count, unsigned w_px, unsigned h_px);

#endif
