/* SPDX-License-Identifier: MIT
 *
 * The results of a sweep, joined: every row of all jobs, in the order of these, and which settings nobody need take. */
#ifndef SIM_SWEEP_MERGE_H
#define SIM_SWEEP_MERGE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* A row of a table: a model with a setting on a processor. */
struct sweep_row {
    char *model, *method, *precision, *core; /* core: "" where no instructions were counted */
    double wrong_percent, instructions;      /* instructions: NaN likewise */
    char *line;                              /* of the result's CSV */
};

struct sweep {
    char *header;  /* the columns of results, which all have in common */
    char *version; /* of the program that measured them */
    struct sweep_row *rows;
    size_t count, capacity;
};

/* Adds what a job found. Refuses what another program has measured than the first, and files that have changed since.
 */
bool sweep_add(struct sweep *sweep, const char *path, struct error *err);

/* All rows, with the model's path, the method that was asked for, and whether the setting is on its model's front on
 * that processor. */
void sweep_write(const struct sweep *sweep, FILE *out);

/* The common front: of each processor and setting the means over all models, in columns that measure.gp knows. False:
 * no instructions were counted. */
bool sweep_write_front(const struct sweep *sweep, FILE *out);

/* The processors that rows have, each once; how many. */
size_t sweep_cores(const struct sweep *sweep, const char **found, size_t most);

void sweep_free(struct sweep *sweep);

#endif
