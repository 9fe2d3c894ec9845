/* SPDX-License-Identifier: MIT
 *
 * The memory of the nearest-first order: lines and cache as they must be, pools between the least and
 * what the scene's limits ask for. */
#include "orders/nearest.h"

#include "lines/framebuffer.h"
#include "pieces/mesh_leaf.h"
#include "view/view.h"
#include "view/walk.h"

#if LIM_HAS_SPANS

/* Cells, gaps and polygons that cross a line share their memory. */
struct shares {
    size_t shared_b;
    uint16_t gaps, pieces; /* gaps: of these; only what is antialiased by scan lines asks how many */
    LIM_OPTIONAL(uint16_t, layers, LIM_HAS_TRANSPARENT);
};

static size_t shared_b(size_t cells, size_t gaps, size_t active)
{
    return LIM_MEM_B(0, 0, cells, gaps, active) - LIM_MEM_B(0, 0, 0, 0, 0);
}

static uint16_t least_cells(const struct lim_scene *scene)
{
    return (uint16_t)(LIM_RETAINED_HEAD_CELLS + scene->limits.vertices + CLIP_PLANES);
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

/* One polygon, one gap: what a band of one pixel needs. Lines that are transparent need nothing (bands.c). Bands do not
 * make up for pieces: with fewer than are counted on, other polygons would be nearest. */
static struct shares least_shares(const struct lim_scene *scene, const struct lim_target *target)
{
    return (struct shares){
        .shared_b = shared_b(least_cells(scene), 1, 1), .gaps = 1, .pieces = comfortable_pieces(scene, target)};
}

/* What scan lines paint leaves no gaps, but those of a line, antialiased. What they cannot paint makes do with one. */
static uint16_t comfortable_gaps(const struct lim_scene *scene, const struct lim_target *target)
{
    const bool leaves_none = LIM_IS_SCANLINE(target) && !(LIM_HAS_TRANSPARENT && scene->limits.layers);

    return leaves_none && !LIM_HAS_ANTIALIAS ? 1 : scene->limits.gaps;
}

/* Whether all frames are painted polygon by polygon, as far as there are gaps: then nothing waits for its line. */
static bool retains_nothing(const struct lim_target *target)
{
    return LIM_HAS_FILLED && LIM_ALL_FLAT && !LIM_HAS_MOVERS && target->method == LIM_NEAREST_FIRST &&
           lim_fill_of(target);
}

static struct shares comfortable_shares(const struct lim_scene *scene, const struct lim_target *target)
{
    const struct lim_limits *limits = &scene->limits;
    const bool none = retains_nothing(target);
    struct shares wanted = {.gaps = greater(comfortable_gaps(scene, target), 1),
                            .pieces = comfortable_pieces(scene, target)};

    wanted.shared_b = shared_b(none ? least_cells(scene) : greater(limits->retained_cells, least_cells(scene)),
                               wanted.gaps, none ? 1 : greater(limits->active, 1));
    if (LIM_HAS_TRANSPARENT) *wanted.layers = limits->layers;
    return wanted;
}

static size_t total_b(const struct lim_scene *scene, const struct lim_target *target, struct shares shares)
{
    size_t sum_b = shares.shared_b + (LIM_HAS_TRANSPARENT ? LIM_LAYERS_MEM_B(*shares.layers) : 0);

    if (LIM_IS_NEWELL(target))
        sum_b += LIM_NEWELL_MEM_B(target->h_px, scene->polygon_count, shares.pieces, 0, 0, 0);
    else if (LIM_IS_SORTED(target))
        sum_b += LIM_DEPTH_MEM_B(target->h_px, scene->polygon_count, 0, 0, 0);
    else
        sum_b += LIM_MEM_B(target->h_px, scene->limits.depth, 0, 0, 0);
    return sum_b + (LIM_IS_SORTED(target) ? 0 : lim_portals_mem_b(scene) + lim_mesh_leaf_mem_b(&scene->limits));
}

size_t lim_nearest_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    return total_b(scene, target, least ? least_shares(scene, target) : comfortable_shares(scene, target));
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

/* Scales what is comfortable down to what there is; never below the least. The pools together are below 2^24 bytes. */
static void scale(struct shares *shares, const struct lim_scene *scene, const struct lim_target *target, size_t mem_b)
{
    const struct shares least = least_shares(scene, target);
    const size_t least_b = total_b(scene, target, least), wanted_b = total_b(scene, target, *shares);

    if (mem_b >= wanted_b) {
        if (LIM_IS_NEWELL(target)) *shares = with_surplus(*shares, scene, mem_b - wanted_b);
        return;
    }
    const uint16_t part_q8 = (uint16_t)(((uint32_t)(mem_b - least_b) << 8) / (uint32_t)(wanted_b - least_b));
    shares->gaps = between(1, shares->gaps, part_q8);
    if (LIM_HAS_TRANSPARENT) *shares->layers = between(0, *shares->layers, part_q8);
}

static struct shares pools_divide(const struct lim_scene *scene, const struct lim_target *target, size_t mem_b)
{
    struct shares shares = comfortable_shares(scene, target);

    if (LIM_HAS_NEWELL || LIM_HAS_TRANSPARENT || LIM_HAS_ANTIALIAS) scale(&shares, scene, target, mem_b);
    shares.shared_b = 0;
    shares.shared_b = (mem_b - total_b(scene, target, shares)) & ~(size_t)(LIM_ALIGNOF(union lim_retained_cell) - 1);
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

/* As many elements as have a number. */
static uint16_t numbered(size_t count)
{
    return (uint16_t)(count < LIM_NONE ? count : LIM_NONE - 1u);
}

/* Cells, and gaps that come down from the end (share.h). */
static void set_shared(struct lim_nearest *nearest, size_t size_b)
{
    struct lim_retained *retained = &nearest->retained;
    struct lim_spans *spans = &nearest->spans;

    spans->retained = retained;
    retained->whole = numbered(size_b / sizeof(union lim_retained_cell));
    spans->pool = (void *)retained->cells;
    spans->pool_size = numbered(size_b / sizeof(struct lim_gap));
    if (!LIM_HAS_ANTIALIAS) return;
    *spans->strips = (void *)retained->cells;
    *spans->strips_size = numbered(size_b / LIM_GAP_MEM_B);
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

    if (LIM_IS_SORTED(&pass->target)) cut_sorter(lim_nearest_sorter(nearest), &at, &shares);
    nearest->retained.cells = lim_mem_cut(&at, shares.shared_b);
    nearest->retained.pending = (uint16_t)(LIM_RETAINED_HEAD_CELLS + pass->scene->limits.vertices);
    set_shared(nearest, shares.shared_b);
    nearest->paint.actives.pool = at;
    if (LIM_HAS_ANTIALIAS) {
        *spans->kept = 0;
        *nearest->line_gaps = shares.gaps;
    }
    struct lim_view_cached *cache = lim_mem_cut(&at, LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached));
    if (!is_sorted) stack = lim_mem_cut(&at, pass->scene->limits.depth * sizeof *stack);
    spans->lines = lim_mem_cut(&at, pass->target.h_px * sizeof(struct lim_line));
    if (LIM_HAS_TRANSPARENT) {
        nearest->paint.layers->own = lim_mem_cut(&at, LIM_LAYERS_MEM_B(*shares.layers));
        nearest->paint.layers->own_size = *shares.layers;
        nearest->paint.layers->used = 0;
        nearest->paint.layers->exhausted = nearest->paint.layers->in_idle = false;
    }
    if (LIM_HAS_MESH_LEAVES && !is_sorted)
        lim_mesh_leaf_lend(*nearest->leaf, lim_mem_cut(&at, lim_mesh_leaf_mem_b(&pass->scene->limits)),
                           &pass->scene->limits);
    if (LIM_HAS_WALKED && !is_sorted) lim_walk_lend(pass->walk, pass->scene, stack, at);
    lim_view_init(&pass->view, pass->target.w_px, pass->target.h_px, cache);
    if (LIM_HAS_STATS)
        *spans->counted = (struct lim_counted){.cell_b = sizeof(union lim_retained_cell),
                                               .active_b = sizeof(struct lim_active),
                                               .idle_b = (uint32_t)((uint8_t *)spans->lines - (uint8_t *)cache)};
}

void lim_nearest_count_as(struct lim_nearest *nearest, const struct lim_counted *counted, size_t counted_b)
{
    struct lim_retained *retained = &nearest->retained;
    struct lim_spans *spans = &nearest->spans;

    if (!LIM_HAS_STATS) return;
    *spans->counted = *counted;
    retained->whole = numbered(counted_b / (size_t)counted->cell_b);
    spans->pool = (void *)(retained->cells + retained->whole);
    spans->pool_size = numbered(counted_b / (size_t)counted->gap_b);
    nearest->paint.actives.pool = (uint8_t *)spans->pool + spans->pool_size * LIM_GAP_MEM_B;
    if (!LIM_HAS_ANTIALIAS) return;
    *spans->strips = (void *)spans->pool;
    *spans->strips_size = spans->pool_size;
    *nearest->line_gaps = counted->line_gaps;
}

#endif
