/* SPDX-License-Identifier: MIT
 *
 * Frames from sampled cameras with pools that cannot run out; what they used, and some more. Who needs
 * even more falls back to bands. The greediest is left out: in an open scene it may be a stray, an
 * eye where nobody is meant to be. */
#include "pools.h"

#include "lim_image.h"
#include "sample.h"
#include "simulator.h"

#include <stdlib.h>

enum { CAMERAS = 256, STRAYS = 1, PLENTY = 60000, FOV_DEG = 60 };

/* What each camera used of each pool. */
struct usage {
    size_t cameras;
    uint16_t cells[CAMERAS], gaps[CAMERAS], active[CAMERAS];
};

/* Sizes of the structs in caller's memory on a 32-bit MCU; tests/arm/sizes.c asserts them. */
enum { CACHE_B = 64 * 8, LINE_B = 8, PENDING_B = 4, CELL_B = 4, GAP_B = 6, ACTIVE_B = 48, HEAD_CELLS = 2, CLIPPED = 5 };

static uint16_t least_cells(const struct lim_limits *limits)
{
    return (uint16_t)(HEAD_CELLS + limits->vertices + CLIPPED);
}

static uint16_t with_margin(uint16_t used, uint16_t least)
{
    const unsigned wanted = used + used / 8u + 1;
    return (uint16_t)(wanted < least ? least : wanted > UINT16_MAX ? UINT16_MAX : wanted);
}

static int compare_u16(const void *a, const void *b)
{
    return *(const uint16_t *)a - *(const uint16_t *)b;
}

static uint16_t most(uint16_t *used, size_t cameras)
{
    if (cameras <= STRAYS) return 0;
    qsort(used, cameras, sizeof *used, compare_u16);
    return used[cameras - 1 - STRAYS];
}

static void note(struct usage *usage, const struct lim_stats *stats)
{
    const size_t i = usage->cameras++;
    usage->cells[i] = stats->retained_cells_max;
    usage->gaps[i] = stats->gaps_max;
    usage->active[i] = stats->active_max;
}

/* Out-of-range cameras (a scene of thousands of kilometres) are passed over. */
static bool sample_frames(const struct compiled *scene, struct simulator *simulator, struct usage *usage,
                          struct error *err)
{
    struct sampler sampler;
    struct lens lens;

    sampler_init(&sampler, scene);
    if (!lens_init(&lens, FOV_DEG, lens_default_near_m(&scene->grid), simulator->target.w_px, simulator->target.h_px,
                   err))
        return false;
    for (int i = 0; i < CAMERAS; i++) {
        struct viewpoint viewpoint = sampler_next(&sampler);
        const struct camera_path path = {"sampled cameras", &viewpoint, 1};
        struct lim_camera camera;
        if (!camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, err)) continue;
        if (!simulator_frame(simulator, &camera, err)) return false;
        note(usage, lim_stats(&simulator->lim));
    }
    return true;
}

bool pools_measure(struct compiled *scene, unsigned w_px, unsigned h_px, struct error *err)
{
    struct lim_limits limits = scene->scene.limits;
    struct usage usage = {0};
    struct compiled roomy = *scene; /* shares the arrays */
    struct simulator simulator;

    roomy.scene.limits.retained_cells = roomy.scene.limits.gaps = roomy.scene.limits.active = PLENTY;
    if (!simulator_init(&simulator, &roomy.scene, SIMULATOR_MEMORY, LIM_NEAREST_FIRST, w_px, h_px, err)) return false;
    const bool ok = sample_frames(&roomy, &simulator, &usage, err);
    simulator_free(&simulator);
    limits.retained_cells = with_margin(most(usage.cells, usage.cameras), least_cells(&limits));
    limits.gaps = with_margin(most(usage.gaps, usage.cameras), 1);
    limits.active = with_margin(most(usage.active, usage.cameras), 1);
    lim_image_set_limits(scene, &limits);
    scene->report.w_px = w_px;
    scene->report.h_px = h_px;
    return ok;
}

static size_t mem_b(const struct lim_limits *limits, unsigned h_px, size_t cells, size_t gaps, size_t active)
{
    const size_t fixed_b = CACHE_B + h_px * (size_t)LINE_B + limits->depth * (size_t)PENDING_B;
    return (fixed_b + cells * CELL_B + gaps * GAP_B + active * ACTIVE_B + 3) & ~(size_t)3;
}

size_t pools_mcu_mem_b(const struct lim_limits *limits, unsigned h_px)
{
    return mem_b(limits, h_px, limits->retained_cells, limits->gaps, limits->active);
}

size_t pools_mcu_mem_min_b(const struct lim_limits *limits, unsigned h_px)
{
    return mem_b(limits, h_px, least_cells(limits), 1, 1);
}
