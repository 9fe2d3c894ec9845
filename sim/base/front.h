/* SPDX-License-Identifier: MIT
 *
 * Choices between two quantities of which less is better each, and those that nobody need take: another
 * is at least as good in both and better in one (Pareto). */
#ifndef SIM_FRONT_H
#define SIM_FRONT_H

#include <stddef.h>
#include <stdint.h>

struct front_choice {
    double error, cost;
};

#define FRONT_NONE SIZE_MAX

/* Sets dominator[i] to a choice that dominates choice i and is not dominated itself, the cheapest of them; or to
 * FRONT_NONE: choice i is on the front. */
void front_find(const struct front_choice *choices, size_t count, size_t *dominator);

#endif
