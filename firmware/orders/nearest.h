/* SPDX-License-Identifier: MIT
 *
 * Nearest first, which needs no framebuffer: polygons from the walk through the tree, or from a sorted list, close gaps
 * and are painted line by line. The scan-line order is the same without gaps. Its memory is shared out in pools.c, pass
 * one is in nearest.c, a frame and its bands are in bands.c. */
#ifndef LIM_NEAREST_H
#define LIM_NEAREST_H

#include "lines/paint.h"
#include "lines/retain.h"
#include "lines/span.h"
#include "orders/painter.h"
#include "pieces/sorter.h"
#include "routes/mover_route.h"

/* Bytes that lim_init() cuts up, for each order: constant expressions when their arguments are. A scene's header has
 * its own with the scene's limits filled in: NAME_SCENE_MEM_B(h_px). */
#define LIM_MEM_B(h_px, depth, cell_count, gap_count, active_count)                                                    \
    LIM_MEM_ALIGNED_B(LIM_VIEW_CACHE_ENTRIES * sizeof(struct lim_view_cached) + (h_px) * sizeof(struct lim_line) +     \
                      (depth) * sizeof(struct lim_walk_pending) + (cell_count) * sizeof(union lim_retained_cell) +     \
                      (gap_count) * sizeof(struct lim_gap) + (active_count) * sizeof(struct lim_active))
/* Beside LIM_MEM_B(), if the scene has transparent polygons. */
#define LIM_LAYERS_MEM_B(layer_count) ((layer_count) * sizeof(struct lim_layer))
/* `piece_count`: how often a frame's polygons can be split. */
#define LIM_DEPTH_MEM_B(h_px, polygon_count, cell_count, gap_count, active_count)                                      \
    (LIM_MEM_B(h_px, 0, cell_count, gap_count, active_count) + (polygon_count) * sizeof(struct lim_sorted))
#define LIM_NEWELL_MEM_B(h_px, polygon_count, piece_count, cell_count, gap_count, active_count)                        \
    (LIM_DEPTH_MEM_B(h_px, (polygon_count) + (piece_count), cell_count, gap_count, active_count) +                     \
     ((polygon_count) + (piece_count)) * sizeof(struct lim_newell_polygon) +                                           \
     (piece_count) * (2 * sizeof(struct lim_cut)))

/* How far a frame is that lim_frame_begin() began. */
enum lim_ahead_stage {
    LIM_AHEAD_NONE, /* there is none */
    LIM_AHEAD_BEGUN,
    LIM_AHEAD_BUSY,     /* in pass one */
    LIM_AHEAD_DONE,     /* with pass one */
    LIM_AHEAD_EXHAUSTED /* in pass one: a pool is */
};

/* Pass one between two quanta. */
struct lim_progress {
    const LIM_FLASH lim_index *record; /* of a run, the next; NULL: another run is due */
    LIM_OPTIONAL(struct lim_route, route, LIM_HAS_MOVERS);
    uint16_t entry; /* of the sorted list, the next */
};

struct lim_nearest {
    struct lim_pass *pass;
    struct lim_sorter *sorter;   /* of a sorted method's polygons, or of movers */
    struct lim_painter *painter; /* for lines for which a pool is too small */
    struct lim_spans spans;
    struct lim_retained retained;
    struct lim_paint paint;
    uint32_t bands;       /* lim_bands() */
    uint8_t since_shrink; /* polygons since the open view was drawn together */
    bool retains_all;     /* by scan lines, in this band */
    bool fills;           /* polygons are painted as they come */
    struct lim_progress progress;
};

/* What memory it asks for (`least`: with less it is refused), and how it cuts that up. */
size_t lim_nearest_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least);
void lim_nearest_init(struct lim_nearest *nearest, void *mem, size_t mem_b);

/* A frame, of a camera that is taken in. 0, an enum lim_error, or the target's error. */
LIM_MUST_CHECK int lim_nearest_frame(struct lim_nearest *nearest);

/* The same in parts, after lim_frame_begin(). */
bool lim_nearest_work(struct lim_nearest *nearest, enum lim_ahead_stage *stage);
LIM_MUST_CHECK int lim_nearest_paint(struct lim_nearest *nearest, enum lim_ahead_stage *stage);

/* Pass one over a band. false: a pool is exhausted. */
bool lim_collect(struct lim_nearest *nearest, const struct lim_rect *band);

/* The same over the frame, in quanta: what it returns is LIM_AHEAD_BUSY but for the last. */
void lim_collect_begin(struct lim_nearest *nearest, const struct lim_rect *frame);
enum lim_ahead_stage lim_collect_some(struct lim_nearest *nearest);

/* Pass one for a piece of a projected polygon. false: a pool is exhausted. */
bool lim_collect_piece(struct lim_nearest *nearest, uint16_t entry, const struct lim_screen_polygon *whole);

/* Whether lim_set_antialias() has lent what it takes. */
static inline bool lim_wants_antialias(const struct lim_nearest *nearest)
{
    return LIM_HAS_ANTIALIAS && nearest->paint.smooth->sums && !lim_wireframe_of(nearest->pass);
}

/* Whether frames, but for changes, are as lim_can_fill() says. */
static inline bool lim_nearest_can_fill(const struct lim_nearest *nearest)
{
    return !(LIM_HAS_DELTA && nearest->paint.delta) && !lim_wants_antialias(nearest) &&
           lim_can_fill(nearest->sorter, nearest->pass);
}

#endif
