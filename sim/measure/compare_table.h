/* SPDX-License-Identifier: MIT
 *
 * The table of `limner compare`: a row for each visibility method, also for those that cannot draw the scene.
 * Markdown for people, CSV for programs. */
#ifndef SIM_COMPARE_TABLE_H
#define SIM_COMPARE_TABLE_H

#include "measure/measure_request.h"

#include <stdio.h>

struct compare_row {
    const struct method *method;
    struct error why_not;  /* it cannot draw the scene because ...; empty: it can */
    struct compiled scene; /* its own; empty if it cannot */
    struct accuracy accuracy;
    struct cost costs[MEASURE_REQUEST_CPUS_MAX];        /* of compare_table.cpus */
    struct error not_counted[MEASURE_REQUEST_CPUS_MAX]; /* why there are none; empty: there are */
};

struct compare_table {
    const char *scene; /* its name */
    unsigned w_px, h_px;
    const struct core *core;
    const struct measure_cpu *const *cpus;              /* those that were asked for, cpu_count of them */
    struct error not_counted[MEASURE_REQUEST_CPUS_MAX]; /* why there are no instructions; empty: there are */
    size_t cpu_count, frames, cost_frames;
    struct compare_row *rows; /* of methods[], in that order; method_count of them */
};

bool compare_row_draws(const struct compare_row *row);

/* Bytes of the lines that the target must be able to lend at any time: all of them for the painter. */
size_t compare_row_lines_b(const struct compare_table *table, const struct compare_row *row);

/* No exact method has order errors or holes, or leaves the order of a pair open; but profile draft may have some, as
 * whole pixels shift edges by more than one. */
bool compare_row_is_right(const struct compare_table *table, const struct compare_row *row);

void compare_table_markdown(const struct compare_table *table, FILE *out);

/* A line for each method; what is not known is empty. */
void compare_table_csv(const struct compare_table *table, FILE *out);

#endif
