/* SPDX-License-Identifier: MIT
 *
 * The public functions: memory is shared out once, in lim_init(); a frame is a camera taken in,
 * then drawn in the target's order. */
#include "limner.h"

#include "clip.h"
#include "fill.h"
#include "order.h"

/* The caller's memory, cut in this order: widest alignment first. */
struct shares {
    uint16_t active, retained_cells, gaps;
};

/* One polygon, one gap: what a band of one pixel needs. */
static struct shares least(const struct lim_scene *scene)
{
    return (struct shares){1, (uint16_t)(LIM_RETAINED_HEAD_CELLS + scene->limits.vertices + CLIP_PLANES), 1};
}

static struct shares comfortable(const struct lim_scene *scene)
{
    const struct shares floor = least(scene);
    const struct lim_limits *limits = &scene->limits;

    return (struct shares){limits->active > floor.active ? limits->active : floor.active,
                           limits->retained_cells > floor.retained_cells ? limits->retained_cells
                                                                         : floor.retained_cells,
                           limits->gaps > floor.gaps ? limits->gaps : floor.gaps};
}

static size_t total_b(const struct lim_scene *scene, const struct lim_target *target, struct shares shares)
{
    return LIM_MEM_B(target->h_px, scene->limits.depth, shares.retained_cells, shares.gaps, shares.active);
}

size_t lim_mem_min_b(const struct lim_scene *scene, const struct lim_target *target)
{
    return total_b(scene, target, least(scene));
}

size_t lim_mem_b(const struct lim_scene *scene, const struct lim_target *target)
{
    return total_b(scene, target, comfortable(scene));
}

/* Scales the comfortable shares down to what there is; never below the least. */
static struct shares divide(const struct lim_scene *scene, const struct lim_target *target, size_t mem_b)
{
    const struct shares least_shares = least(scene), wanted = comfortable(scene);
    const size_t floor_b = total_b(scene, target, least_shares), wanted_b = total_b(scene, target, wanted);

    if (mem_b >= wanted_b) return wanted;
    const uint32_t part_q16 = (uint32_t)(((uint64_t)(mem_b - floor_b) << 16) / (wanted_b - floor_b));
    struct shares shares = least_shares;
    shares.active = (uint16_t)(shares.active + (((wanted.active - shares.active) * (uint64_t)part_q16) >> 16));
    shares.retained_cells = (uint16_t)(shares.retained_cells +
                                       (((wanted.retained_cells - shares.retained_cells) * (uint64_t)part_q16) >> 16));
    shares.gaps = (uint16_t)(shares.gaps + (((wanted.gaps - shares.gaps) * (uint64_t)part_q16) >> 16));
    return shares;
}

static void *cut(uint8_t **mem, size_t size_b)
{
    void *piece = *mem;

    *mem += size_b;
    return piece;
}

static void share_out(struct lim *lim, void *mem, struct shares shares)
{
    uint8_t *at = mem;

    lim->paint.pool = cut(&at, shares.active * sizeof(struct lim_active));
    lim->paint.pool_size = shares.active;
    lim->retained.cells = cut(&at, shares.retained_cells * sizeof(union lim_retained_cell));
    lim->retained.size = shares.retained_cells;
    struct lim_view_cached *cache = cut(&at, LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached));
    lim->spans.lines = cut(&at, lim->target.h_px * sizeof(struct lim_line));
    lim->spans.pool = cut(&at, shares.gaps * sizeof(struct lim_gap));
    lim->spans.pool_size = shares.gaps;
    lim->stack = cut(&at, lim->scene->limits.depth * sizeof(struct lim_walk_pending));
    lim_view_init(&lim->view, lim->target.w_px, lim->target.h_px, cache);
}

static bool target_is_usable(const struct lim_target *target)
{
    return target->w_px >= 1 && target->w_px <= LIM_MAX_SIDE_PX && target->h_px >= 1 &&
           target->h_px <= LIM_MAX_SIDE_PX && target->format == LIM_RGB565 && target->lend && target->done &&
           (target->method == LIM_NEAREST_FIRST || (LIM_HAS_PAINTER && target->method == LIM_PAINTER));
}

int lim_init(struct lim *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b)
{
    LIM_ASSERT(lim && scene && target && mem && ((uintptr_t)mem & 3) == 0);
    if (scene->limits.vertices > LIM_MAX_VERTICES) return LIM_ERR_SCENE;
    if (!target_is_usable(target)) return LIM_ERR_TARGET;
    if (mem_b < lim_mem_min_b(scene, target)) return LIM_ERR_MEMORY;
    lim->scene = scene;
    lim->target = *target;
    lim->paint.target = &lim->target;
    lim->paint.background = lim_memory_colour(scene->background);
    share_out(lim, mem, divide(scene, target, mem_b));
    return LIM_OK;
}

int lim_frame(struct lim *lim, const struct lim_camera *camera)
{
    lim->stats = (struct lim_stats){0};
    if (!lim_view_begin(&lim->view, camera)) return LIM_ERR_CAMERA;
    lim_eye_set(&lim->eye, camera->eye_q8);
    const int err = lim->target.method == LIM_PAINTER ? lim_painter_frame(lim) : lim_nearest_frame(lim);
    lim->stats.vertices = lim->view.vertices;
    return err;
}

const struct lim_stats *lim_stats(const struct lim *lim)
{
    return &lim->stats;
}
