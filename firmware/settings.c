/* SPDX-License-Identifier: MIT
 *
 * The public functions that say how frames are drawn, and what with. What is said after lim_init() drops a frame that
 * is begun. */
#include "limner.h"

#include "ahead.h"
#include "overlay.h"
#include "pieces/mesh_leaf.h"
#include "pixels/delta.h"
#include "view/pass.h"

int lim_begin(const struct lim_memory *memory, const struct lim_scene *scene, enum lim_method method, lim_send *send,
              void *ctx)
{
    struct lim_target target;

    LIM_ASSERT(memory && scene && send);
    memory->lim->pass.scene = NULL;
    *memory->sender = (struct lim_sender){send, ctx, memory->lines, memory->lines_b, 0};
    const int err = lim_sender_target(memory->sender, memory->w_px, memory->h_px, method, &target);
    return err ? err : lim_init(memory->lim, scene, &target, memory->pools, memory->pools_b);
}

#if LIM_HAS_WIREFRAME
void lim_set_wireframe(struct lim *lim, const struct lim_wireframe *wireframe)
{
    LIM_ASSERT(lim && wireframe);
    lim_drop_ahead(lim);
    *lim->pass.wireframe = *wireframe;
}
#endif

#if LIM_HAS_OVERLAY
void lim_set_overlay(struct lim *lim, const struct lim_overlay *overlay)
{
    LIM_ASSERT(lim && (!overlay || overlay->draw));
    *lim->pass.overlay = overlay;
}
#endif

#if LIM_HAS_ROUND
void lim_set_visible(struct lim *lim, lim_visible *visible)
{
    LIM_ASSERT(lim);
    lim_drop_ahead(lim);
    lim->pass.target.visible = visible;
}
#endif

#if LIM_HAS_ANTIALIAS
int lim_set_antialias(struct lim *lim, void *mem, size_t mem_b)
{
    LIM_ASSERT(lim && (uintptr_t)mem % LIM_ALIGNOF(uint32_t) == 0);
    struct lim_smooth *smooth = lim->nearest->paint.smooth;
    const uint16_t w_px = lim->pass.target.w_px;

    if (!LIM_PAINTS_NEAREST_FIRST(&lim->pass.target)) return mem ? LIM_ERR_TARGET : LIM_OK;
    lim_drop_ahead(lim);
    smooth->sums = NULL;
    if (!mem) return LIM_OK;
    if (mem_b < LIM_ANTIALIAS_MEM_B(w_px)) return LIM_ERR_MEMORY;
    smooth->sums = mem;
    for (uint16_t x = 0; x < w_px; x++)
        smooth->sums[x] = 0;
    smooth->covered = (uint16_t *)(void *)(smooth->sums + w_px);
    return LIM_OK;
}
#endif

#if LIM_HAS_DELTA
static void use_delta(struct lim *lim, struct lim_delta *delta)
{
    *lim->delta = delta;
    if (LIM_HAS_SPANS) *lim->nearest->paint.delta = delta;
}

int lim_set_delta(struct lim *lim, void *mem, size_t mem_b)
{
    LIM_ASSERT((uintptr_t)mem % LIM_ALIGNOF(void *) == 0);
    lim_drop_ahead(lim);
    struct lim_target *target = &lim->pass.target;

    if (*lim->delta) *target = (*lim->delta)->target;
    use_delta(lim, NULL);
    if (!mem) return LIM_OK;
    const int err = lim_delta_init(mem, target, mem_b);
    if (err) return err;
    *target = lim_delta_stage(mem);
    use_delta(lim, mem);
    return LIM_OK;
}

void lim_refresh(struct lim *lim)
{
    LIM_ASSERT(lim);
    if (*lim->delta) (*lim->delta)->known = false;
}
#endif

#if LIM_HAS_NEWELL
void lim_newell_set(struct lim *lim, const struct lim_newell_options *options)
{
    LIM_ASSERT(lim && options);
    lim->sorter->newell->options = *options;
}
#endif

#if LIM_HAS_LIGHT
void lim_light_set(struct lim *lim, const struct lim_light *light)
{
    LIM_ASSERT(lim && light);
    *lim->movers->light = *light;
}
#endif

#if LIM_HAS_MOVERS
static size_t without_leaf_b(const struct lim_scene *scene, const struct lim_movers_limits *limits)
{
    LIM_ASSERT(scene && limits);
    return LIM_MOVERS_MEM_B(scene->limits.depth, limits->instances, limits->depth);
}

size_t lim_movers_mem_b(const struct lim_scene *scene, const struct lim_movers_limits *limits)
{
    return without_leaf_b(scene, limits) +
           (LIM_HAS_MESH_LEAVES ? LIM_MESH_LEAF_MEM_B(limits->leaf_vertices, limits->leaf_polygons) : 0);
}

/* Whether movers are drawn by the target's method: nearest first from a tree, by either way of painting. */
static bool walks(const struct lim_target *target)
{
    return LIM_HAS_WALKED && !LIM_IS_PAINTER(target) && !LIM_IS_SORTED(target) && !LIM_IS_CONVEX(target) &&
           !LIM_IS_MESH(target);
}

/* Of a polygon that can be retained, as a band of one pixel asks for. */
static uint16_t most_mover_corners(const struct lim *lim)
{
    const uint16_t most = LIM_MAX_VERTICES, taken = LIM_RETAINED_HEAD_CELLS + CLIP_PLANES;

    if (!walks(&lim->pass.target)) return most;
    const uint16_t cells = lim->nearest->retained.whole;
    return cells < most + taken ? (uint16_t)(cells - taken) : most;
}

static LIM_IF_CALLED void lend_mesh_leaf(struct lim_movers *movers, void *mem, const struct lim_movers_limits *limits)
{
    const struct lim_limits most = {.leaf_vertices = limits->leaf_vertices, .leaf_polygons = limits->leaf_polygons};

    *movers->leaf_vertices = most.leaf_vertices;
    *movers->leaf_polygons = most.leaf_polygons;
    lim_mesh_leaf_lend(movers->leaf, mem, &most);
}

/* Widest alignment first. */
int lim_movers_init(struct lim *lim, void *mem, size_t mem_b, const struct lim_movers_limits *limits)
{
    LIM_ASSERT(lim && lim->pass.scene && limits && mem && (uintptr_t)mem % LIM_ALIGNOF(void *) == 0);
    struct lim_movers *movers = lim->movers;
    const struct lim_scene *scene = lim->pass.scene;
    uint8_t *at = mem;

    LIM_ASSERT(limits->instances <= LIM_INSTANCES_MAX);
    if (mem_b < lim_movers_mem_b(scene, limits)) return LIM_ERR_MEMORY;
    lim_drop_ahead(lim);
    if (LIM_HAS_LIGHT) movers->light->on = false;
    movers->most = limits->instances;
    movers->object_depth = limits->depth;
    movers->most_corners = most_mover_corners(lim);
    if (!walks(&lim->pass.target)) movers->most = 0;
    if (!movers->most) return LIM_OK;
    movers->movers = lim_mem_cut(&at, limits->instances * sizeof *movers->movers);
    if (LIM_HAS_LONG) *movers->copies = lim_mem_cut(&at, limits->instances * sizeof **movers->copies);
    movers->cache = lim_mem_cut(&at, LIM_VIEW_CACHE_ENTRIES * sizeof *movers->cache);
    movers->stack = lim_mem_cut(&at, scene->limits.depth * sizeof *movers->stack);
    movers->object_stack = lim_mem_cut(&at, limits->depth * sizeof *movers->object_stack);
    if (LIM_HAS_MESH_LEAVES) lend_mesh_leaf(movers, (uint8_t *)mem + without_leaf_b(scene, limits), limits);
    return LIM_OK;
}
#endif
