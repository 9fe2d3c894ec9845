/* SPDX-License-Identifier: MIT
 *
 * `limner sweep --merge DIR`: what the jobs of a sweep have written becomes one table and the common front. */
#ifndef SIM_SWEEP_RESULTS_H
#define SIM_SWEEP_RESULTS_H

#include "base/error.h"

#include <stdbool.h>

/* Writes DIR/sweep.csv and, where instructions were counted, DIR/front.csv and DIR/front.png. Nothing, if a result is
 * missing or cannot be joined with others. */
bool sweep_results_join(const char *folder, struct error *err);

#endif
