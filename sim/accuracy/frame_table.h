/* SPDX-License-Identifier: MIT
 *
 * What `limner render` tells of each frame: the renderer's counters (--stats) and the deviations
 * from the reference picture (--compare), as tables with mean and worst. */
#ifndef SIM_FRAME_TABLE_H
#define SIM_FRAME_TABLE_H

#include "accuracy/compare.h"
#include "accuracy/edge_error.h"
#include "limner.h"

#include <stdio.h>

struct frame_row {
    struct lim_stats stats;
    size_t pixels; /* w_px * h_px */
    size_t bus_b;
    struct compare_counts compare;
    struct edge_error_sum edges;
};

struct frame_rows {
    const struct frame_row *rows;
    size_t count;
    bool is_brief; /* mean and worst, and no line for each */
};

/* Overdraw is how often a pixel of the picture is written, background included; 1 is ideal. */
void frame_table_print_stats(const struct frame_rows *rows, FILE *out);

/* What LIM_NEWELL compared, which test decided how often, what it swapped, split and could not settle. */
void frame_table_print_newell(const struct frame_rows *rows, FILE *out);

/* What became of movers: struct lim_mover_stats, and what it took to sort those that met. */
void frame_table_print_delta(const struct frame_rows *rows, FILE *out);
void frame_table_print_movers(const struct frame_rows *rows, FILE *out);

/* Instructions a frame by frame_cost.h, for methods that it knows. */
void frame_table_print_predicted(const struct frame_rows *rows, const struct lim_target *target, FILE *out);

/* Mean absolute error at edges, without antialiasing and with it. */
void frame_table_print_edges(const struct frame_rows *rows, FILE *out);

void frame_table_print_compare(const struct frame_rows *rows, FILE *out);

#endif
