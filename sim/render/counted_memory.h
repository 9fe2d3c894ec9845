/* SPDX-License-Identifier: MIT
 *
 * What cells, gaps and polygons that cross a line share, by the sizes that a 32-bit MCU has for them. This host's
 * polygons are four times as large; a simulator lends them more memory, and has it counted so: then pools run out where
 * they do on a board. */
#ifndef SIM_COUNTED_MEMORY_H
#define SIM_COUNTED_MEMORY_H

#include "core/core.h"

struct counted_memory {
    struct lim_counted counted;
    size_t least_b, all_b; /* to share: at the least, and for the scene's limits */
    bool of_a_line;        /* lines are painted at once, antialiased: their gaps are as many as polygons cross them */
};

/* Of a method that draws nearest first or by scan lines from a tree; of others all is 0. */
struct counted_memory counted_memory_of(const struct core *core, const struct lim_scene *scene,
                                        const struct lim_target *target, bool antialias, bool moves);

/* Limits for a memory in which each of the three has room for itself. */
struct lim_limits counted_memory_limits(const struct counted_memory *memory, const struct lim_scene *scene,
                                        const struct lim_target *target);

#endif
