/* SPDX-License-Identifier: MIT
 *
 * What the renderer lays out in the memory that it is given: firmware/orders/pools.c, counted for 32-bit MCUs. */
#include "scene/mcu_mem.h"

#include "core/core.h"
#include "limner.h"
#include "scene/mcu_sizes.h"
#include "scene/moving.h"
#include "scene/needs.h"
#include "scene/width.h"

/* Whether a firmware for this panel needs wide screen coordinates in this profile. */
static bool is_wide(const struct compile_report *report)
{
    const unsigned narrow_px = report->core ? report->core->narrow_px : core_fast.narrow_px;
    return report->w_px > narrow_px || report->h_px > narrow_px;
}

static bool has_long_edges(const struct compile_report *report)
{
    return report->core && report->core->sub_bits >= MCU_LONG_EDGES_MIN_SUB_BITS;
}

size_t mcu_active_b(const struct core *core, const struct lim_scene *scene, bool antialias, bool moves)
{
    const size_t moves_b = MCU_ACTIVE_MOVES_B + (lim_scene_long(scene) ? (size_t)MCU_ACTIVE_MOVES_LONG_B : 0);
    const size_t flat_b = MCU_ACTIVE_B + (antialias ? (size_t)MCU_ACTIVE_SAMPLES_B : 0) +
                          (scene->texture_count ? (size_t)MCU_ACTIVE_TEXTURE_B : 0) + (moves ? moves_b : 0);

    if (core->sub_bits < MCU_LONG_EDGES_MIN_SUB_BITS) return flat_b;
    const size_t long_b = flat_b + MCU_LONG_EDGES_B + MCU_LONG_EDGES_ALIGN_B - 1;
    return long_b - long_b % MCU_LONG_EDGES_ALIGN_B;
}

static size_t active_b(const struct compiled *scene)
{
    const struct compile_report *report = &scene->report;
    return mcu_active_b(report->core ? report->core : &core_fast, &scene->scene, report->antialias, report->moves);
}

/* An entry of the cache, a pending node: each has an index. */
static size_t index_b(const struct compiled *scene)
{
    return width_is_wide(&scene->scene) ? (size_t)MCU_INDEX_B : 0;
}

static size_t cached_b(const struct compiled *scene)
{
    return (is_wide(&scene->report) ? (size_t)MCU_CACHED_WIDE_B : (size_t)MCU_CACHED_B) + index_b(scene);
}

static size_t pending_b(const struct compiled *scene)
{
    return MCU_PENDING_B + index_b(scene);
}

static size_t aligned_b(size_t size_b)
{
    return (size_b + 3) & ~(size_t)3;
}

/* A mesh leaf that is being drawn: of the scene's, or of what moves in it. */
static size_t leaf_b(const struct compiled *scene, size_t vertices, size_t polygons)
{
    const size_t point_b = is_wide(&scene->report) ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t entry_b = width_is_wide(&scene->scene) ? MCU_MESH_ENTRY_WIDE_B : MCU_MESH_ENTRY_B;
    const size_t lists = polygons ? polygons / 8 + 16 : 0;
    return aligned_b(vertices * (point_b + MCU_MESH_NEARNESS_B) + polygons * entry_b + lists * sizeof(uint16_t));
}

static size_t leaves_b(const struct compiled *scene)
{
    const struct lim_limits *limits = &scene->scene.limits;
    return leaf_b(scene, limits->leaf_vertices, limits->leaf_polygons);
}

static size_t sorted_b(const struct compiled *scene, size_t pieces)
{
    const size_t count = scene->scene.polygon_count;
    if (scene->report.draws == LIM_DEPTH) return count * (MCU_SORTED_B + index_b(scene));
    return (count + pieces) * (MCU_SORTED_B + MCU_NEWELL_B + index_b(scene)) + pieces * 2 * MCU_CUT_B;
}

static size_t nearest_b(const struct compiled *scene, size_t cells, size_t gaps, size_t active, size_t pieces)
{
    const bool wide = is_wide(&scene->report), sorts = method_sorts(scene->report.draws);
    const size_t cell_b = wide ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t gap_b = MCU_GAP_B + (scene->report.antialias ? (size_t)MCU_GAP_SAMPLES_B : 0);
    const size_t fixed_b = MCU_CACHE_ENTRIES * cached_b(scene) + scene->report.h_px * MCU_LINE_B +
                           (sorts ? 0 : scene->scene.limits.depth * pending_b(scene));
    return (sorts ? sorted_b(scene, pieces) : 0) +
           aligned_b(fixed_b + cells * cell_b + gaps * gap_b + active * active_b(scene)) +
           (sorts ? 0 : lim_portals_mem_b(&scene->scene) + leaves_b(scene));
}

static size_t layers_b(const struct lim_limits *limits, bool is_masked)
{
    return limits->layers * ((size_t)MCU_LAYER_B + (is_masked ? (size_t)MCU_LAYER_MASKED_B : 0));
}

static size_t convex_b(const struct compiled *scene, size_t active)
{
    const bool wide = is_wide(&scene->report);
    const size_t point_b = wide ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t face_b = MCU_FACE_B + index_b(scene) / 2;
    const size_t points = scene->scene.limits.vertices + (size_t)MCU_CLIP_PLANES;
    const size_t flags_b = scene->report.wireframe ? (points + 15) / 16 * 2 : 0;
    const size_t texture_b = scene->scene.texture_count ? (size_t)MCU_CROSSING_TEXTURE_B : 0;
    const size_t long_b = has_long_edges(&scene->report) ? (size_t)MCU_CROSSING_LONG_EDGES_B : 0;
    const size_t crossing_b = MCU_CROSSING_B + long_b + texture_b + points * point_b + aligned_b(flags_b);
    return aligned_b(MCU_CACHE_ENTRIES * cached_b(scene) + scene->report.h_px * (size_t)MCU_TOP_B +
                     scene->scene.polygon_count * face_b + active * crossing_b);
}

static size_t mesh_active_b(const struct compiled *scene)
{
    return (size_t)MCU_MESH_ACTIVE_B(has_long_edges(&scene->report), width_is_wide(&scene->scene),
                                     scene->report.draws == LIM_MESH_DEPTH, scene->scene.texture_count > 0);
}

static size_t mesh_b(const struct compiled *scene, size_t active)
{
    const size_t point_b = is_wide(&scene->report) ? MCU_CELL_WIDE_B : MCU_CELL_B;
    const size_t depth_b = scene->report.draws == LIM_MESH_DEPTH ? MCU_MESH_DEPTH_B * scene->report.w_px : 0;
    return aligned_b(active * mesh_active_b(scene) + scene->scene.vertex_count * (point_b + MCU_MESH_NEARNESS_B) +
                     (scene->scene.polygon_count + scene->report.h_px) * width_word_b(width_is_wide(&scene->scene))) +
           aligned_b(depth_b);
}

static size_t painter_b(const struct compiled *scene)
{
    return aligned_b(MCU_CACHE_ENTRIES * cached_b(scene) + scene->scene.limits.depth * pending_b(scene)) +
           lim_portals_mem_b(&scene->scene) + leaves_b(scene);
}

size_t mcu_mem_b(const struct compiled *scene)
{
    const struct needs needs = needs_of(scene, scene->moving);
    const struct lim_limits limits = needs_limits(scene, &needs);
    if (scene->report.draws == LIM_CONVEX) return convex_b(scene, limits.active);
    if (scene->report.draws == LIM_PAINTER) return painter_b(scene);
    if (method_draws_meshes(scene->report.draws))
        return mesh_b(scene, limits.active < MCU_MESH_LEAST_ACTIVE ? MCU_MESH_LEAST_ACTIVE : limits.active);
    return nearest_b(scene, limits.retained_cells, limits.gaps, limits.active, limits.pieces) +
           layers_b(&limits, needs.masked);
}

size_t mcu_mem_min_b(const struct compiled *scene)
{
    if (scene->report.draws == LIM_CONVEX) return convex_b(scene, 0);
    if (scene->report.draws == LIM_PAINTER) return painter_b(scene);
    if (method_draws_meshes(scene->report.draws)) return mesh_b(scene, MCU_MESH_LEAST_ACTIVE);
    return nearest_b(scene, needs_least_cells(&scene->scene.limits), 1, 1, scene->scene.limits.pieces);
}

static size_t mover_b(const struct compiled *scene, const struct moving *moving)
{
    const struct core *core = scene->report.core ? scene->report.core : &core_fast;
    const bool fine = core->profile >= LIM_PROFILE_FINE;
    return MCU_MOVER_B + 2 * index_b(scene) + (fine ? (size_t)MCU_MOVER_FINE_B : 0) +
           (scene->report.antialias ? (size_t)MCU_MOVER_ANTIALIAS_B : 0) +
           (moving->light.on ? (size_t)MCU_MOVER_LIGHT_B : 0) +
           (scene->scene.texture_count ? (size_t)MCU_MOVER_TEXTURE_B : 0) +
           (needs_of(scene, moving).sky ? (size_t)MCU_MOVER_SKY_B : 0) +
           (scene->report.tele && !fine ? (size_t)MCU_MOVER_TELE_B : 0) +
           (lim_scene_long(&scene->scene) ? (size_t)MCU_MOVER_LONG_B + MCU_INSTANCE_LONG_B : 0);
}

size_t mcu_movers_mem_b(const struct compiled *scene, const struct moving *moving)
{
    const struct lim_movers_limits *limits = &moving->limits;
    const size_t route_b = MCU_ROUTE_B + index_b(scene);
    return aligned_b(limits->instances * mover_b(scene, moving) + MCU_CACHE_ENTRIES * cached_b(scene) +
                     ((size_t)scene->scene.limits.depth + limits->depth) * route_b) +
           leaf_b(scene, limits->leaf_vertices, limits->leaf_polygons);
}
