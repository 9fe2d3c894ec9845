/* SPDX-License-Identifier: MIT
 *
 * The renderer's state: a stage a member, in the order in which data passes them, and no member for a
 * stage that is not linked. Complete here so that callers can place it; its members are private. */
#ifndef LIM_STATE_H
#define LIM_STATE_H

#include "lines/paint.h"
#include "lines/retain.h"
#include "lines/span.h"
#include "movers/movers.h"
#include "orders/convex.h"
#include "pieces/sorted.h"
#include "pixels/delta.h"
#include "pixels/fill.h"
#include "pixels/texture.h"
#include "stats.h"
#include "target.h"
#include "view/cull.h"
#include "view/eye.h"
#include "view/view.h"
#include "view/walk.h"

/* Bytes that lim_init() cuts up, for each order: constant expressions when their arguments are. A scene's
 * header has its own with the scene's limits filled in: NAME_SCENE_MEM_B(h_px). */
#define LIM_MEM_B(h_px, depth, cell_count, gap_count, active_count)                                                    \
    LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(struct lim_line) +     \
                      (depth) * sizeof(struct lim_walk_pending) + (cell_count) * sizeof(union lim_retained_cell) +     \
                      (gap_count) * sizeof(struct lim_gap) + (active_count) * sizeof(struct lim_active))
/* Beside LIM_MEM_B(), if the scene has transparent polygons. */
#define LIM_LAYERS_MEM_B(layer_count) ((layer_count) * sizeof(struct lim_layer))
#define LIM_PAINTER_MEM_B(depth)                                                                                       \
    LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) +                                        \
                      (depth) * sizeof(struct lim_walk_pending))
#define LIM_CONVEX_MEM_B(h_px, polygon_count, active_count)                                                            \
    LIM_MEM_ALIGNED_B(LIM_MEM_ALIGNED_B(LIM_CONVEX_POOL_AT_B(h_px) + (polygon_count) * sizeof(struct lim_face)) +      \
                      (active_count) * sizeof(struct lim_crossing))
/* Where the crossings begin, whose edges may have 64 bits. */
#define LIM_CONVEX_POOL_AT_B(h_px)                                                                                     \
    ((LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(uint16_t)) +         \
      LIM_ALIGNOF(struct lim_crossing) - 1) &                                                                          \
     ~(LIM_ALIGNOF(struct lim_crossing) - 1))
/* `piece_count`: how often a frame's polygons can be split. */
#define LIM_DEPTH_MEM_B(h_px, polygon_count, cell_count, gap_count, active_count)                                      \
    (LIM_MEM_B(h_px, 0, cell_count, gap_count, active_count) + (polygon_count) * sizeof(struct lim_sorted))
#define LIM_NEWELL_MEM_B(h_px, polygon_count, piece_count, cell_count, gap_count, active_count)                        \
    (LIM_DEPTH_MEM_B(h_px, (polygon_count) + (piece_count), cell_count, gap_count, active_count) +                     \
     ((polygon_count) + (piece_count)) * sizeof(struct lim_newell_polygon) +                                           \
     (piece_count) * (2 * sizeof(struct lim_cut)))
/* For lim_movers_init(): `depth` of the static scene, `object_depth` and the rest as struct lim_movers_limits. */
#define LIM_MOVERS_MEM_B(depth, instance_count, object_depth, entry_count)                                             \
    LIM_MEM_ALIGNED_B((instance_count) * sizeof(struct lim_mover) +                                                    \
                      (entry_count) *                                                                                  \
                          (sizeof(struct lim_sorted) + sizeof(struct lim_newell_polygon) + sizeof(struct lim_cut)) +   \
                      LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) +                                        \
                      ((size_t)(depth) + (object_depth)) * sizeof(struct lim_route_pending))
#define LIM_MEM_ALIGNED_B(size_b) (((size_b) + 3) & ~(size_t)3)

#if LIM_HAS_STREAM
/* How far the frame is that lim_frame_begin() began. */
enum lim_ahead_stage {
    LIM_AHEAD_NONE, /* there is none */
    LIM_AHEAD_BEGUN,
    LIM_AHEAD_BUSY,     /* in pass one */
    LIM_AHEAD_DONE,     /* with pass one */
    LIM_AHEAD_EXHAUSTED /* in pass one: a pool is */
};

/* Pass one between two quanta. */
struct lim_ahead {
    enum lim_ahead_stage stage;
    const LIM_FLASH lim_index *record; /* of a run, the next; NULL: another run is due */
#if LIM_HAS_MOVERS
    struct lim_route route;
#endif
#if LIM_HAS_SORTED
    uint16_t entry; /* of the sorted list, the next */
#endif
    uint8_t since_shrink;
#if LIM_HAS_DELTA
    struct lim_camera camera; /* what was taken in */
#endif
};
#endif

struct lim {
    const struct lim_scene *scene;
    struct lim_target target;
#if LIM_HAS_CONVEX
    struct lim_convex convex;
#endif
    struct lim_view view;
#if LIM_HAS_TEXTURE
    struct lim_texturing texturing;
#endif
#if LIM_HAS_CULL
    struct lim_cull cull;
#endif
#if LIM_HAS_TREE
    struct lim_walk walk;
    struct lim_walk_pending *stack;
#if LIM_HAS_PORTALS
    struct lim_portals portals;
#endif
#else
    struct lim_eye eye;
#endif
#if LIM_HAS_SORTED || LIM_HAS_MOVERS
    struct lim_sorter sorter;
#endif
#if LIM_HAS_MOVERS
    struct lim_movers movers;
#endif
#if LIM_HAS_SPANS
    struct lim_spans spans;
    struct lim_retained retained;
    struct lim_paint paint;
    uint32_t bands; /* lim_bands() */
#endif
#if LIM_HAS_SCANLINE
    bool retains_all; /* in this band */
#endif
#if LIM_HAS_FILLED
    bool fills; /* polygons are painted as they come */
#endif
#if LIM_HAS_WIREFRAME
    struct lim_wireframe wireframe;
#endif
#if LIM_HAS_DELTA
    struct lim_delta *delta; /* NULL: every frame is sent whole */
#endif
#if LIM_HAS_STREAM
    struct lim_ahead ahead;
#endif
#if LIM_HAS_STATS
    struct lim_stats stats;
#endif
};

/* If a frame was begun, it is no more, and has no instances. */
static inline void lim_drop_ahead(struct lim *lim)
{
#if LIM_HAS_STREAM
    if (lim->ahead.stage == LIM_AHEAD_NONE) return;
    lim->ahead.stage = LIM_AHEAD_NONE;
#if LIM_HAS_MOVERS
    lim->movers.count = lim->movers.given = 0;
#endif
#else
    (void)lim;
#endif
}

/* lim_portals_mem_b() bytes, or nothing: then nothing is looked up. */
static inline void lim_lend_portals(struct lim *lim, void *mem)
{
#if LIM_HAS_PORTALS
    uint8_t *bits = lim_portals_mem_b(lim->scene) ? (uint8_t *)mem : NULL;
    lim->portals.bits = bits;
    lim->portals.stack = bits ? (uint16_t *)(void *)(bits + LIM_PORTALS_BITS_B(lim->scene->box_count)) : NULL;
#else
    (void)lim;
    (void)mem;
#endif
}

/* Members that may not be there, NULL then, or elsewhere. */
static inline struct lim_stats *lim_stats_of(struct lim *lim)
{
#if LIM_HAS_STATS
    return &lim->stats;
#else
    (void)lim;
    return NULL;
#endif
}

/* NULL: polygons are filled. */
static inline const struct lim_wireframe *lim_wireframe_of(const struct lim *lim)
{
#if LIM_HAS_WIREFRAME
    return lim->wireframe.on ? &lim->wireframe : NULL;
#else
    (void)lim;
    return NULL;
#endif
}

/* As it lies in memory. */
static inline uint16_t lim_background_of(const struct lim *lim)
{
    const struct lim_wireframe *wireframe = lim_wireframe_of(lim);

    return lim_memory_colour(wireframe && wireframe->one_colour ? wireframe->background : lim->scene->background);
}

/* Whether the frame has movers. */
static inline bool lim_moves(const struct lim *lim)
{
#if LIM_HAS_MOVERS
    return lim->movers.count > 0;
#else
    (void)lim;
    return false;
#endif
}

static inline struct lim_eye *lim_eye_of(struct lim *lim)
{
#if LIM_HAS_TREE
    return &lim->walk.eye;
#else
    return &lim->eye;
#endif
}

static inline struct lim_texturing *lim_texturing_of(struct lim *lim)
{
#if LIM_HAS_TEXTURE
    return &lim->texturing;
#else
    (void)lim;
    return NULL;
#endif
}

static inline struct lim_cull *lim_cull_of(struct lim *lim)
{
#if LIM_HAS_CULL
    return &lim->cull;
#else
    (void)lim;
    return NULL;
#endif
}

#endif
