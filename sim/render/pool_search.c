/* SPDX-License-Identifier: MIT */
#include "render/pool_search.h"

#include "render/frame_cost.h"
#include "scene/mcu_mem.h"
#include "scene/mcu_sizes.h"

#include <string.h>

struct looking {
    const struct compiled *scene;
    struct moving *moving;
    struct simulator *simulator;
    const struct lens *lens;
    struct counted_memory memory;
    struct pool_search_result *out;
};

uint32_t pool_search_shared_b(const struct simulator *simulator, const struct counted_memory *memory)
{
    const struct lim_counted *counted = &memory->counted;
    const struct lim_stats *stats = simulator_stats(simulator);
    const bool at_once = memory->of_a_line && !stats->gaps_max;
    const uint32_t gaps = at_once ? stats->active_max + 1u : stats->gaps_max;

    return stats->retained_cells_max * counted->cell_b + gaps * counted->gap_b + stats->active_max_b;
}

static uint16_t search_greater(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

static void note_most(struct pool_search_result *out, const struct lim_stats *stats, uint32_t shared_b)
{
    if (shared_b > out->shared_b) out->shared_b = shared_b;
    out->cells = search_greater(out->cells, (uint16_t)stats->retained_cells_max);
    out->gaps = search_greater(out->gaps, (uint16_t)stats->gaps_max);
    out->active = search_greater(out->active, (uint16_t)stats->active_max);
}

/* Where each has a pool of its own, they are weighed as what they take on a small screen. */
static double memory_of(const struct looking *looking, uint32_t shared_b)
{
    const struct simulator *simulator = looking->simulator;
    const struct lim_stats *stats = simulator_stats(simulator);

    if (looking->memory.counted.cell_b) return shared_b;
    return stats->retained_cells_max * (double)MCU_CELL_B + stats->gaps_max * (double)MCU_GAP_B +
           stats->active_max * (double)mcu_active_b(simulator->core, simulator->scene, false, looking->moving != NULL);
}

static bool measure(void *ctx, const struct viewpoint *viewpoint, double *scores, struct error *err)
{
    struct looking *looking = ctx;
    struct viewpoint frame = *viewpoint;
    const struct camera_path path = {"searched cameras", &frame, 1};
    struct lim_camera camera;
    struct error ignored;

    for (int goal = 0; goal < POOL_SEARCH_GOALS; goal++)
        scores[goal] = -1.0;
    if (!camera_path_to_camera(&path, 0, looking->lens, &looking->scene->grid, &camera, &ignored)) return true;
    if (looking->moving) moving_pose(looking->moving, viewpoint->time_s);
    if (!simulator_frame(looking->simulator, &camera, err)) return false;
    const struct lim_stats *stats = simulator_stats(looking->simulator);
    scores[POOL_SEARCH_COST] = frame_cost_work(stats, &looking->simulator->target);
    const uint32_t shared_b = pool_search_shared_b(looking->simulator, &looking->memory);
    scores[POOL_SEARCH_MEMORY] = memory_of(looking, shared_b);
    note_most(looking->out, stats, shared_b);
    return true;
}

bool pool_search_run(const struct compiled *scene, struct moving *moving, struct simulator *simulator,
                     const struct lens *lens, size_t tries, struct pool_search_result *out, struct error *err)
{
    struct looking looking = {
        .scene = scene,
        .moving = moving,
        .simulator = simulator,
        .lens = lens,
        .memory = counted_memory_of(simulator->core, &scene->scene, &simulator->target, false, moving != NULL),
        .out = out};
    const struct camera_search search = {.scene = scene,
                                         .lens = *lens,
                                         .length_s = moving ? moving_length_s(moving) : 0.0,
                                         .tries = tries,
                                         .goals = POOL_SEARCH_GOALS,
                                         .doing = "worst views",
                                         .measure = measure,
                                         .ctx = &looking};
    return camera_search_run(&search, &out->views, err);
}

void pool_search_report(const struct pool_search_result *result, const struct grid *grid, struct worst_report *out)
{
    const struct search_goal *cost = &result->views.goals[POOL_SEARCH_COST];
    struct viewpoint viewpoint = cost->worst;
    const struct camera_path path = {"the worst view", &viewpoint, 1};
    const struct lens any = {.tan_x = 1.0, .tan_y = 1.0, .near_m = 1.0 / grid->units_per_m};
    struct lim_camera camera;
    struct error ignored;

    if (!result->views.tried || !camera_path_to_camera(&path, 0, &any, grid, &camera, &ignored)) return;
    *out = (struct worst_report){.tries = out->tries,
                                 .tried = result->views.tried,
                                 .work = cost->score,
                                 .work_mean = cost->mean,
                                 .work_random = cost->most,
                                 .time_s = viewpoint.time_s,
                                 .yaw = camera.yaw,
                                 .pitch = camera.pitch,
                                 .cells = result->cells,
                                 .gaps = result->gaps,
                                 .active = result->active};
    memcpy(out->eye_m, viewpoint.eye_m, sizeof out->eye_m);
    memcpy(out->target_m, viewpoint.target_m, sizeof out->target_m);
    memcpy(out->eye_q8, camera.eye_q8, sizeof out->eye_q8);
    memcpy(out->origin, camera.origin, sizeof out->origin);
}
