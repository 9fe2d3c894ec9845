/* SPDX-License-Identifier: MIT
 *
 * Equal reasons are told once. */
#include "measure/measure_refusals.h"

#include "core/core.h"

#include <string.h>

void measure_refusals_add(struct measure_refusals *refusals, const struct core *core, const struct error *reason)
{
    if (refusals->count < MEASURE_REFUSALS_MAX)
        refusals->rows[refusals->count++] = (struct measure_refusal){core, *reason};
}

static bool is_same(const struct measure_refusals *refusals, size_t a, size_t b)
{
    return strcmp(refusals->rows[a].reason.text, refusals->rows[b].reason.text) == 0;
}

void measure_refusals_print(const struct measure_refusals *refusals, const char *before, FILE *out)
{
    for (size_t i = 0; i < refusals->count; i++) {
        bool is_told = false;
        for (size_t k = 0; k < i; k++)
            is_told |= is_same(refusals, k, i);
        if (is_told) continue;
        fprintf(out, "%s%s", before, refusals->rows[i].core->name);
        for (size_t k = i + 1; k < refusals->count; k++)
            if (is_same(refusals, i, k)) fprintf(out, ", %s", refusals->rows[k].core->name);
        fprintf(out, ": refused: %s\n", refusals->rows[i].reason.text);
    }
}

bool measure_refusals_set(const struct measure_refusals *refusals, const char *model_path, struct error *err)
{
    size_t best = 0;
    bool is_one = true;
    for (size_t i = 1; i < refusals->count; i++) {
        is_one &= is_same(refusals, 0, i);
        if (refusals->rows[i].core->profile > refusals->rows[best].core->profile) best = i;
    }
    const struct measure_refusal *told = &refusals->rows[best];
    if (is_one) return error_set(err, "%.200s: %s", model_path, told->reason.text);
    return error_set(err, "%.200s: all precisions are refused, %s: %s", model_path, told->core->name,
                     told->reason.text);
}
