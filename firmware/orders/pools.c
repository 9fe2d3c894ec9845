/* SPDX-License-Identifier: MIT
 *
 * The memory of the nearest-first order: lines and cache as they must be, pools between the least and
 * what the scene's limits ask for. */
#include "orders/nearest.h"

#include "lines/framebuffer.h"
#include "view/view.h"
#include "view/walk.h"

#if LIM_HAS_SPANS

struct shares {
    uint16_t active, retained_cells, gaps, pieces;
    LIM_OPTIONAL(uint16_t, layers, LIM_HAS_TRANSPARENT);
};

/* One polygon, one gap: what a band of one pixel needs. Lines that are transparent need nothing (bands.c). */
static struct shares least_shares(const struct lim_scene *scene)
{
    return (struct shares){.active = 1,
                           .retained_cells = (uint16_t)(LIM_RETAINED_HEAD_CELLS + scene->limits.vertices + CLIP_PLANES),
                           .gaps = 1};
}

static uint16_t greater(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

/* What a list holds beside the scene's own polygons. */
static uint16_t most_pieces(const struct lim_scene *scene)
{
    if (LIM_HAS_WIDE && scene->polygon_count > LIM_SORTED_MAX) return 0;
    return (uint16_t)(LIM_SORTED_MAX - scene->polygon_count);
}

static uint16_t comfortable_pieces(const struct lim_scene *scene, const struct lim_target *target)
{
    const uint16_t most = most_pieces(scene);

    if (!LIM_IS_NEWELL(target)) return 0;
    return scene->limits.pieces < most ? scene->limits.pieces : most;
}

/* What scan lines paint leaves no gaps, but those of a line, antialiased. What they cannot paint makes do with one. */
static uint16_t comfortable_gaps(const struct lim_scene *scene, const struct lim_target *target)
{
    if (!LIM_IS_SCANLINE(target) || (LIM_HAS_TRANSPARENT && scene->limits.layers)) return scene->limits.gaps;
    if (LIM_HAS_ANTIALIAS && LIM_HAS_TEXTURE && lim_texture_count(scene)) return scene->limits.gaps;
    return LIM_HAS_ANTIALIAS ? (uint16_t)(scene->limits.active + 1) : 1;
}

/* Whether all frames are painted polygon by polygon, as far as there are gaps: then nothing waits for its line. */
static bool retains_nothing(const struct lim_target *target)
{
    return LIM_HAS_FILLED && LIM_ALL_FLAT && !LIM_HAS_MOVERS && target->method == LIM_NEAREST_FIRST &&
           lim_fill_of(target);
}

static struct shares comfortable_shares(const struct lim_scene *scene, const struct lim_target *target)
{
    const struct shares least = least_shares(scene);
    const struct lim_limits *limits = &scene->limits;

    struct shares wanted = {.active = greater(limits->active, least.active),
                            .retained_cells = greater(limits->retained_cells, least.retained_cells),
                            .gaps = greater(comfortable_gaps(scene, target), least.gaps),
                            .pieces = comfortable_pieces(scene, target)};
    if (LIM_HAS_TRANSPARENT) *wanted.layers = limits->layers;
    if (retains_nothing(target)) {
        wanted.active = least.active;
        wanted.retained_cells = least.retained_cells;
    }
    return wanted;
}

static size_t total_b(const struct lim_scene *scene, const struct lim_target *target, struct shares shares)
{
    const uint16_t cells = shares.retained_cells, gaps = shares.gaps;
    size_t sum_b = LIM_HAS_TRANSPARENT ? LIM_LAYERS_MEM_B(*shares.layers) : 0;

    if (LIM_IS_NEWELL(target))
        sum_b += LIM_NEWELL_MEM_B(target->h_px, scene->polygon_count, shares.pieces, cells, gaps, shares.active);
    else if (LIM_IS_SORTED(target))
        sum_b += LIM_DEPTH_MEM_B(target->h_px, scene->polygon_count, cells, gaps, shares.active);
    else
        sum_b += LIM_MEM_B(target->h_px, scene->limits.depth, cells, gaps, shares.active);
    return sum_b + (LIM_IS_SORTED(target) ? 0 : lim_portals_mem_b(scene));
}

size_t lim_nearest_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    return total_b(scene, target, least ? least_shares(scene) : comfortable_shares(scene, target));
}

/* from + (to - from) * part; part < 1. */
static uint16_t between(uint16_t from, uint16_t to, uint16_t part_q8)
{
    return (uint16_t)(from + (((uint32_t)(to - from) * part_q8) >> 8));
}

/* What is left over goes to pieces, up to what a list holds. */
static struct shares with_surplus(struct shares wanted, const struct lim_scene *scene, size_t surplus_b)
{
    const size_t more = surplus_b / (LIM_NEWELL_MEM_B(0, 0, 1, 0, 0, 0) - LIM_NEWELL_MEM_B(0, 0, 0, 0, 0, 0));
    const size_t most = (size_t)most_pieces(scene) - wanted.pieces;

    wanted.pieces = (uint16_t)(wanted.pieces + (more < most ? more : most));
    return wanted;
}

/* Scales the comfortable shares down to what there is; never below the least. The pools together are
 * below 2^24 bytes. */
static struct shares pools_divide(const struct lim_scene *scene, const struct lim_target *target, size_t mem_b)
{
    const struct shares least = least_shares(scene), wanted = comfortable_shares(scene, target);
    const size_t least_b = total_b(scene, target, least), wanted_b = total_b(scene, target, wanted);

    if (mem_b >= wanted_b) return LIM_IS_NEWELL(target) ? with_surplus(wanted, scene, mem_b - wanted_b) : wanted;
    const uint16_t part_q8 = (uint16_t)(((uint32_t)(mem_b - least_b) << 8) / (uint32_t)(wanted_b - least_b));
    struct shares shares = {.active = between(least.active, wanted.active, part_q8),
                            .retained_cells = between(least.retained_cells, wanted.retained_cells, part_q8),
                            .gaps = between(least.gaps, wanted.gaps, part_q8),
                            .pieces = between(0, wanted.pieces, part_q8)};
    if (LIM_HAS_TRANSPARENT) *shares.layers = between(0, *wanted.layers, part_q8);
    return shares;
}

static void cut_sorter(struct lim_sorter *sorter, uint8_t **at, const struct shares *shares)
{
    const struct lim_pass *pass = sorter->pass;
    struct lim_newell *newell = sorter->newell;

    sorter->size = (uint16_t)(pass->scene->polygon_count + shares->pieces);
    sorter->list = lim_mem_cut(at, sorter->size * sizeof *sorter->list);
    if (!LIM_IS_NEWELL(&pass->target)) return;
    newell->polygons = lim_mem_cut(at, sorter->size * sizeof *newell->polygons);
    newell->cut_size = (uint16_t)(2 * shares->pieces);
    newell->cuts = lim_mem_cut(at, newell->cut_size * sizeof *newell->cuts);
    newell->options = (struct lim_newell_options){.most = 0};
}

/* Widest alignment first. */
void lim_nearest_init(struct lim_nearest *nearest, void *mem, size_t mem_b)
{
    struct lim_pass *pass = nearest->pass;
    struct lim_spans *spans = &nearest->spans;
    const struct shares shares = pools_divide(pass->scene, &pass->target, mem_b);
    const bool is_sorted = LIM_IS_SORTED(&pass->target);
    struct lim_walk_pending *stack = NULL;
    uint8_t *at = mem;

    nearest->paint.actives.pool = lim_mem_cut(&at, shares.active * sizeof(struct lim_active));
    nearest->paint.actives.pool_size = shares.active;
    if (LIM_IS_SORTED(&pass->target)) cut_sorter(lim_nearest_sorter(nearest), &at, &shares);
    nearest->retained.cells = lim_mem_cut(&at, shares.retained_cells * sizeof(union lim_retained_cell));
    nearest->retained.size = nearest->retained.end = shares.retained_cells;
    struct lim_view_cached *cache = lim_mem_cut(&at, LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached));
    if (!is_sorted) stack = lim_mem_cut(&at, pass->scene->limits.depth * sizeof *stack);
    spans->lines = lim_mem_cut(&at, pass->target.h_px * sizeof(struct lim_line));
    void *const gaps = lim_mem_cut(&at, shares.gaps * LIM_GAP_MEM_B);
    spans->pool = gaps;
    if (LIM_HAS_ANTIALIAS) *spans->strips = gaps;
    spans->pool_size = shares.gaps;
    if (LIM_HAS_TRANSPARENT)
        *nearest->paint.layers =
            (struct lim_layers){lim_mem_cut(&at, LIM_LAYERS_MEM_B(*shares.layers)), *shares.layers, 0, false};
    if (LIM_HAS_WALKED && !is_sorted) lim_walk_lend(pass->walk, pass->scene, stack, at);
    lim_view_init(&pass->view, pass->target.w_px, pass->target.h_px, cache);
}

#endif
