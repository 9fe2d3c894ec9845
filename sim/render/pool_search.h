/* SPDX-License-Identifier: MIT
 *
 * The cameras that take most: found by search (camera_search.h), for pools that sampled cameras alone would make too
 * small. */
#ifndef SIM_POOL_SEARCH_H
#define SIM_POOL_SEARCH_H

#include "cameras/camera_search.h"
#include "render/counted_memory.h"
#include "render/simulator.h"
#include "scene/moving.h"

/* What is searched: the most of the predicted instructions, or of work where nothing predicts them (frame_cost.h), and
 * of what the renderer's three largest pools take together. */
enum { POOL_SEARCH_COST, POOL_SEARCH_MEMORY, POOL_SEARCH_GOALS };

struct pool_search_result {
    struct search_result views;   /* nothing tried: nothing was asked for */
    uint32_t shared_b;            /* the most that any camera took of the memory which the three pools share */
    uint16_t cells, gaps, active; /* the most that any took of each */
};

/* Bytes that the last frame took of the memory which the three pools share, as they are counted. */
uint32_t pool_search_shared_b(const struct simulator *simulator, const struct counted_memory *memory);

/* Searches on `simulator`, whose pools must not run out, with so many cameras at most. Result: what takes most of each
 * goal. `moving`: NULL, nothing moves. */
bool pool_search_run(const struct compiled *scene, struct moving *moving, struct simulator *simulator,
                     const struct lens *lens, size_t tries, struct pool_search_result *out, struct error *err);

/* What the report and NAME.h say of it; nothing, if nothing was tried. */
void pool_search_report(const struct pool_search_result *result, const struct grid *grid, struct worst_report *out);

#endif
