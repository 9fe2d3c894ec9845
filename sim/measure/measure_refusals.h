/* SPDX-License-Identifier: MIT
 *
 * Precisions that a model has no scene for, and why: each is judged by itself, and the others are measured. */
#ifndef SIM_MEASURE_REFUSALS_H
#define SIM_MEASURE_REFUSALS_H

#include "base/error.h"
#include "core/core.h"

#include <stddef.h>
#include <stdio.h>

enum { MEASURE_REFUSALS_MAX = 32 };

struct measure_refusals {
    struct measure_refusal {
        const struct core *core;
        struct error reason;
    } rows[MEASURE_REFUSALS_MAX];
    size_t count;
};

void measure_refusals_add(struct measure_refusals *refusals, const struct core *core, const struct error *reason);

/* A line for each reason, with the names of all that it refuses: "BEFOREdraft, fast: refused: ...". Each precision that
 * shares a scene with another has the same reason. */
void measure_refusals_print(const struct measure_refusals *refusals, const char *before, FILE *out);

/* The error of a model that none has a scene for: the reason of the most precise one. Returns false. */
bool measure_refusals_set(const struct measure_refusals *refusals, const char *model_path, struct error *err);

#endif
