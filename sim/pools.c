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

static uint16_t least_cells(const struct lim_limits *limits)
{
    return (uint16_t)(MCU_HEAD_CELLS + limits->vertices + MCU_CLIP_PLANES);
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
        note(usage, simulator_stats(simulator));
    }
    return true;
}

bool pools_measure(struct compiled *scene, unsigned w_px, unsigned h_px, struct error *err)
{
    struct lim_limits limits = scene->scene.limits;
    struct usage usage = {0};
    struct compiled roomy = *scene; /* shares the arrays */
    const struct simulator_setup setup = {w_px, h_px, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, NULL};
    struct simulator simulator;

    roomy.scene.limits.retained_cells = roomy.scene.limits.gaps = roomy.scene.limits.active = PLENTY;
    if (!simulator_init(&simulator, &roomy.scene, &setup, err)) return false;
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

/* Whether a firmware for this panel needs wide screen coordinates in this profile. */
static bool is_wide(const struct compile_report *report)
{
    const unsigned narrow_px = report->core == &core_fine ? 85 : 341;
    return report->w_px > narrow_px || report->h_px > narrow_px;
}

static size_t mem_b(const struct compiled *scene, size_t cells, size_t gaps, size_t active)
{
    const bool wide = is_wide(&scene->report);
    const size_t cached_b = wide ? MCU_CACHED_WIDE_B : MCU_CACHED_B, cell_b = wide ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t fixed_b = MCU_CACHE_ENTRIES * cached_b + scene->report.h_px * (size_t)MCU_LINE_B +
                           scene->scene.limits.depth * (size_t)MCU_PENDING_B;
    return (fixed_b + cells * cell_b + gaps * MCU_GAP_B + active * MCU_ACTIVE_B + 3) & ~(size_t)3;
}

size_t pools_mcu_mem_b(const struct compiled *scene)
{
    const struct lim_limits *limits = &scene->scene.limits;
    return mem_b(scene, limits->retained_cells, limits->gaps, limits->active);
}

size_t pools_mcu_mem_min_b(const struct compiled *scene)
{
    return mem_b(scene, least_cells(&scene->scene.limits), 1, 1);
}
