/* SPDX-License-Identifier: MIT
 *
 * Between the linker and the counting plugin (targets/count_plugin.c): which addresses to count apart,
 * and what the counts mean. Every section of a function is a range. Of the renderer's, the first instruction is
 * one of its own, which counts the calls; and where the plane test is inlined, every instruction is. */
#ifndef SIM_COUNTS_H
#define SIM_COUNTS_H

#include "measure/link_map.h"
#include "measure/measurement.h"

/* Writes what the plugin reads. */
bool counts_write_ranges(const struct link_map *map, const char *path, struct error *err);

/* Files of a run, and what is known of it. */
struct counts_run {
    const char *counts_path;  /* from the plugin */
    const char *inlined_path; /* from `addr2line -a -i -f`: the functions that each range's start is from */
    size_t frames;
    uint64_t sides; /* plane tests in all frames */
};

/* Reads the counts: first the check, a loop of known length, then the frames. Sets in *out all that has to do with
 * instructions. */
bool counts_read(const struct link_map *map, const struct counts_run *run, struct cost *out, struct error *err);

/* Sets in *out what the image takes of RAM and flash. */
void counts_memory(const struct link_map *map, struct cost *out);

#endif
