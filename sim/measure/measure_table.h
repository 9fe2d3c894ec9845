/* SPDX-License-Identifier: MIT
 *
 * The tables of `limner measure`: Markdown for people, CSV for programs. */
#ifndef SIM_MEASURE_TABLE_H
#define SIM_MEASURE_TABLE_H

#include "measure/measure_refusals.h"
#include "measure/measure_scales.h"
#include "measure/measurement.h"

#include <stdio.h>

enum { MEASURE_CPUS_MAX = 8 };

struct measure_row {
    const struct core *core;
    struct accuracy accuracy;
    struct cost costs[MEASURE_CPUS_MAX];
    /* By wrong pixels against mean instructions; NULL: on the front. */
    const struct core *dominated_by[MEASURE_CPUS_MAX];
};

struct measure_table {
    const char *scene; /* its name */
    unsigned w_px, h_px;
    struct measure_scales scales;
    const struct measure_cpu *const *cpus; /* cpu_count of them; 0: cost was not measured */
    size_t cpu_count;
    const char *optimise; /* what the code is for; NULL: speed, as usual */
    struct measure_row *rows;
    size_t row_count;
    struct measure_refusals refused; /* those that have no row */
    const char *drawn;               /* how, where the order is approximate; NULL: it is exact */
};

/* Sets dominated_by. */
void measure_table_judge(struct measure_table *table);

void measure_table_markdown(const struct measure_table *table, FILE *out);

/* A line for each renderer and processor, or for each renderer if cost was not measured: what is not known is
 * empty. */
void measure_table_csv(const struct measure_table *table, FILE *out);

/* A line for each renderer, processor and stage. */
void measure_table_stages_csv(const struct measure_table *table, FILE *out);

#endif
