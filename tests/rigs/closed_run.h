/* SPDX-License-Identifier: MIT
 *
 * Random closed scenes drawn in every profile and judged by one reference picture a frame: what the test of
 * 10^8 pixels and the soak of 10^9 have in common. */
#ifndef TESTS_CLOSED_RUN_H
#define TESTS_CLOSED_RUN_H

#include "holes.h"
#include "profiles.h"

struct closed_run_plan {
    uint64_t seed;
    int scenes, frames; /* frames a scene, in each profile */
    unsigned side_px;
};

struct closed_run_sum {
    const struct core *profile;
    struct holes holes;
    size_t overdrawn;  /* pixels that were painted over, each time */
    size_t miscounted; /* of the background: counted and not shown, or shown and not counted */
    size_t splits, non_monotone, bands;
};

/* Fills a sum for each profile and returns how many there are; shows progress on a terminal. Whatever fails
 * ends the test. */
size_t closed_run(const struct closed_run_plan *plan, struct closed_run_sum sums[PROFILES_MAX]);

/* A line for each. Holes fail, and miscounted pixels, fewer than `pixels` of them in any profile, and more than a tenth
 * as many painted over. (A pixel that nothing was written to fails already in ids_frame().) */
void closed_run_judge(const struct closed_run_sum *sums, size_t count, size_t pixels);

#endif
