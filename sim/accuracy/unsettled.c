/* SPDX-License-Identifier: MIT */
#include "accuracy/unsettled.h"

void unsettled_add(struct unsettled *sum, const struct lim_newell_stats *stats)
{
    sum->frames += stats->forced > 0;
    sum->entries += stats->forced;
    for (int i = 0; i < LIM_FORCED_REASONS; i++)
        sum->by[i] += stats->forced_by[i];
}

void unsettled_print(const struct unsettled *sum, const char *who, FILE *out)
{
    static const char *const reasons[LIM_FORCED_REASONS] = {[LIM_FORCED_ROOM] = "for want of memory for pieces",
                                                            [LIM_FORCED_CORNERS] =
                                                                "as a piece would have too many corners",
                                                            [LIM_FORCED_EFFORT] = "when no comparisons were left"};
    const char *before = ": ";

    fprintf(out, "%s: the order of %zu polygons and pieces in %zu frame%s could not be settled", who, sum->entries,
            sum->frames, sum->frames == 1 ? "" : "s");
    for (int i = 0; i < LIM_FORCED_REASONS; i++) {
        if (!sum->by[i]) continue;
        fprintf(out, "%s%zu %s", before, sum->by[i], reasons[i]);
        before = ", ";
    }
    fputc('\n', out);
}
