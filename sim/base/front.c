/* SPDX-License-Identifier: MIT
 *
 * Every pair is compared: there are a dozen choices at most. */
#include "base/front.h"

#include <stdbool.h>

static bool dominates(const struct front_choice *a, const struct front_choice *b)
{
    return a->error <= b->error && a->cost <= b->cost && (a->error < b->error || a->cost < b->cost);
}

/* The cheapest dominator of all, and of equal cost the most accurate, cannot be dominated itself:
 * whatever dominates it dominates i too, and would have been taken. */
static size_t cheapest_dominator(const struct front_choice *choices, size_t count, size_t i)
{
    size_t best = FRONT_NONE;
    for (size_t k = 0; k < count; k++) {
        if (!dominates(&choices[k], &choices[i])) continue;
        if (best == FRONT_NONE || choices[k].cost < choices[best].cost || dominates(&choices[k], &choices[best]))
            best = k;
    }
    return best;
}

void front_find(const struct front_choice *choices, size_t count, size_t *dominator)
{
    for (size_t i = 0; i < count; i++)
        dominator[i] = cheapest_dominator(choices, count, i);
}
