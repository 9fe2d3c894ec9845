/* SPDX-License-Identifier: MIT */
#include "render/counted_memory.h"

#include "scene/mcu_mem.h"
#include "scene/mcu_sizes.h"
#include "scene/needs.h"
#include "scene/width.h"

struct counted_memory counted_memory_of(const struct core *core, const struct lim_scene *scene,
                                        const struct lim_target *target, bool antialias, bool moves)
{
    const struct lim_limits *limits = &scene->limits;
    const bool is_wide = target->w_px > core->narrow_px || target->h_px > core->narrow_px;
    const size_t cell_b = is_wide ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t gap_b = MCU_GAP_B + (antialias ? (size_t)MCU_GAP_SAMPLES_B : 0);
    const size_t cached_b = is_wide ? MCU_CACHED_WIDE_B : MCU_CACHED_B;
    const size_t index_b = width_is_wide(scene) ? (size_t)MCU_INDEX_B : 0;
    const size_t active_b = mcu_active_b(core, scene, antialias, moves);
    const size_t least_cells = needs_least_cells(limits);
    const size_t cells = limits->retained_cells > least_cells ? limits->retained_cells : least_cells;
    const size_t gaps = target->method != LIM_SCANLINE || limits->layers || antialias ? limits->gaps : 1;

    if (target->method != LIM_NEAREST_FIRST && target->method != LIM_SCANLINE) return (struct counted_memory){0};
    return (struct counted_memory){.of_a_line = antialias && target->method == LIM_SCANLINE,
                                   .counted = {.cell_b = (uint32_t)cell_b,
                                               .gap_b = (uint32_t)gap_b,
                                               .active_b = (uint32_t)active_b,
                                               .idle_b = (uint32_t)(MCU_CACHE_ENTRIES * (cached_b + index_b) +
                                                                    limits->depth * (MCU_PENDING_B + index_b)),
                                               .is_apart = true},
                                   .least_b = least_cells * cell_b + gap_b + active_b,
                                   .all_b = cells * cell_b + (gaps ? gaps : 1) * gap_b +
                                            (limits->active ? limits->active : 1) * active_b};
}

static uint16_t within(size_t count)
{
    return (uint16_t)(count < UINT16_MAX ? count : UINT16_MAX);
}

struct lim_limits counted_memory_limits(const struct counted_memory *memory, const struct lim_scene *scene,
                                        const struct lim_target *target)
{
    const struct lim_counted *counted = &memory->counted;
    struct lim_limits limits = scene->limits;

    if (!counted->cell_b) return limits;
    const size_t idle_b = counted->idle_b + target->h_px * (size_t)MCU_LINE_B;
    limits.retained_cells = within(memory->all_b / counted->cell_b + 1);
    limits.gaps = within(memory->all_b / MCU_GAP_B + 1);
    limits.active = within((memory->all_b + idle_b) / counted->active_b + 2);
    return limits;
}
