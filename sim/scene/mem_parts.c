/* SPDX-License-Identifier: MIT
 *
 * Flash by the arrays' own sizes; RAM by what a pool of one more would take. */
#include "scene/mem_parts.h"

#include "scene/mcu_mem.h"
#include "scene/needs.h"
#include "scene/width.h"

static void add(struct mem_part *parts, size_t *count, const char *name, size_t size_b, size_t held)
{
    parts[(*count)++] = (struct mem_part){name, size_b, held};
}

size_t flash_parts(const struct compiled *scene, struct mem_part parts[FLASH_PARTS_MAX])
{
    const struct lim_scene *arrays = &scene->scene;
    const bool wide = width_is_wide(arrays);
    size_t count = 0;
    add(parts, &count, "vertices", arrays->vertex_count * width_vertex_b(arrays), arrays->vertex_count);
    add(parts, &count, "nodes", arrays->node_count * width_node_b(wide), arrays->node_count);
    add(parts, &count, "planes", arrays->plane_count * width_plane_b(arrays, wide), arrays->plane_count);
    add(parts, &count, "exact planes", arrays->exact_count * sizeof *arrays->exact, arrays->exact_count);
    add(parts, &count, "boxes", arrays->box_count * width_box_b(arrays), arrays->box_count);
    add(parts, &count, "polygons", arrays->polygon_words * width_word_b(wide), arrays->polygon_count);
    if (!arrays->texture_count) return count;
    add(parts, &count, "texels", arrays->texel_blocks * (size_t)LIM_TEXEL_BLOCK, 0);
    add(parts, &count, "palettes", arrays->palette_colours * sizeof *arrays->palettes, arrays->palette_colours);
    if (*arrays->uvs)
        add(parts, &count, "places in textures", arrays->vertex_count * sizeof **arrays->uvs, arrays->vertex_count);
    add(parts, &count, "mappings and textures",
        arrays->mapping_count * width_mapping_b(arrays, wide) + arrays->texture_count * sizeof *arrays->textures,
        arrays->mapping_count);
    return count;
}

size_t texture_memory_b(const struct lim_scene *scene)
{
    return scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK + scene->palette_colours * sizeof *scene->palettes +
           scene->texture_count * sizeof *scene->textures;
}

/* A pool's part: the working memory, less what it is with that pool empty. */
static void add_pool(struct mem_part *parts, size_t *count, const char *name, const struct compiled *scene,
                     const struct lim_limits *without, size_t held)
{
    struct compiled other = *scene;
    other.scene.limits = *without;
    const size_t all_b = mcu_mem_b(scene), rest_b = mcu_mem_b(&other);
    if (all_b > rest_b) add(parts, count, name, all_b - rest_b, held);
}

size_t ram_parts(const struct compiled *scene, struct mem_part parts[RAM_PARTS_MAX])
{
    const struct lim_limits all = scene->scene.limits;
    struct lim_limits less = all;
    size_t count = 0, sum_b = 0;
    const bool shares = scene->report.draws != LIM_CONVEX && !method_draws_meshes(scene->report.draws);
    less.retained_cells = less.gaps = less.active = 0;
    add_pool(parts, &count,
             shares ? "gaps, polygons that wait for their lines, and those that cross one"
                    : "polygons that cross a line",
             scene, &less, shares ? 0 : all.active);
    less = all, less.pieces = 0;
    add_pool(parts, &count, "pieces that sorting cuts", scene, &less, all.pieces);
    less = all, less.layers = 0;
    add_pool(parts, &count, "transparent layers of a line", scene, &less, all.layers);
    less = all, less.leaf_vertices = less.leaf_polygons = 0;
    add_pool(parts, &count, "a mesh leaf's vertices and polygons", scene, &less, all.leaf_polygons);
    less = all, less.depth = 0;
    add_pool(parts, &count, "the way back up the tree", scene, &less, all.depth);
    struct compiled lower = *scene;
    if (lower.report.w_px < lower.report.h_px) lower.report.w_px = lower.report.h_px; /* coordinates stay as wide */
    lower.report.h_px = 0;
    const size_t lines_b = mcu_mem_b(scene) - mcu_mem_b(&lower);
    add(parts, &count, "heads of the screen's lines", lines_b, scene->report.h_px);
    for (size_t i = 0; i < count; i++)
        sum_b += parts[i].size_b;
    if (mcu_mem_b(scene) > sum_b) add(parts, &count, "projected vertices, and the rest", mcu_mem_b(scene) - sum_b, 0);
    return count;
}
