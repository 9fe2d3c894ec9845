/* SPDX-License-Identifier: MIT
 *
 * Nearest first, which needs no framebuffer: polygons from the walk through the tree, or from a sorted list, close gaps
 * and are painted line by line. The scan-line order is the same without gaps. Its memory is shared out in pools.c, pass
 * one is in nearest.c, a frame and its bands are in bands.c. */
#ifndef LIM_NEAREST_H
#define LIM_NEAREST_H

#include "eye.h"
#include "lines/gaps.h"
#include "lines/span.h"
#include "orders/painter.h"
#include "view/cull.h"

/* Of a sorted method; NULL where none is linked. */
static inline struct lim_sorter *lim_nearest_sorter(const struct lim_nearest *nearest)
{
    return LIM_HAS_SORTED ? *nearest->sorter : NULL;
}

/* Whether the frame has movers. */
static inline bool lim_nearest_moves(const struct lim_nearest *nearest)
{
    return LIM_HAS_MOVERS && lim_moves(*nearest->movers);
}

/* What memory it asks for (`least`: with less it is refused), and how it cuts that up. */
size_t lim_nearest_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least);
void lim_nearest_init(struct lim_nearest *nearest, void *mem, size_t mem_b);

/* For measurements: as if cells, gaps and polygons on a line had counted_b bytes to share, by other sizes than this
 * processor's. Each of them has memory of its own; there must be enough. */
void lim_nearest_count_as(struct lim_nearest *nearest, const struct lim_counted *counted, size_t counted_b);

/* A frame, of a camera that is taken in. 0, an enum lim_error, or the target's error. stage: LIM_AHEAD_BEGUN,
 * pass one is still to be made; else how it has ended. */
LIM_MUST_CHECK int lim_nearest_frame(struct lim_nearest *nearest, enum lim_ahead_stage stage);

/* The same in parts, after lim_frame_begin(). */
bool lim_nearest_work(struct lim_nearest *nearest, enum lim_ahead_stage *stage);
LIM_MUST_CHECK int lim_nearest_paint(struct lim_nearest *nearest, enum lim_ahead_stage *stage);

/* Pass one over a band. false: a pool is exhausted. */
bool lim_collect(struct lim_nearest *nearest, const struct lim_rect *band);

/* A band, before its first polygon; and what its pools took, after the last one. */
void lim_nearest_open(struct lim_nearest *nearest, const struct lim_rect *band);
void lim_nearest_note_pools(struct lim_nearest *nearest);

/* Pass one over the frame, in quanta: what it returns is LIM_AHEAD_BUSY but for the last. */
void lim_collect_begin(struct lim_nearest *nearest, const struct lim_rect *frame);
enum lim_ahead_stage lim_collect_some(struct lim_nearest *nearest);

/* Pass one for a record that faces the eye, or for a projected polygon. false: a pool is exhausted. */
typedef bool lim_collect_one(struct lim_nearest *nearest, const LIM_FLASH lim_index *record);
lim_collect_one lim_collect_record;
bool lim_collect_polygon(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon);

/* For a record of what moves, if it is as most are; else nothing is done, and it has to be projected and drawn. */
enum lim_collected { LIM_COLLECTED, LIM_COLLECT_EXHAUSTED, LIM_COLLECT_SLOWLY };
enum lim_collected lim_collect_moving(struct lim_nearest *nearest, struct lim_view *view,
                                      const struct lim_scene *object, const LIM_FLASH lim_index *record,
                                      uint16_t first_texture);

/* For all polygons of a mesh leaf whose run begins with this record. */
bool lim_collect_mesh_leaf(struct lim_nearest *nearest, const LIM_FLASH lim_index *run);

/* Where the walk has come to a mover: what of it is open is retained, and closes nothing. false: a pool is exhausted.
 */
bool lim_collect_mover(struct lim_nearest *nearest, uint16_t mover);

/* A record that faces the eye, by `collect`; movers come first that it may be behind, and what it is to others is told
 * with it. of_corners: as lim_meet_before(). false: a pool is exhausted. */
bool lim_collect_met(struct lim_nearest *nearest, const LIM_FLASH lim_index *record, bool of_corners,
                     lim_collect_one *collect);

/* A band of one pixel of what moves (one_pixel.c): how it is collected. */
void lim_open_pixel(struct lim_nearest *nearest, const struct lim_rect *band);

/* Of LIM_BY_PIXEL_RETAINED: whether a polygon that comes, and has the pixel, is to be retained: all that was is gone
 * then. In other bands all are. */
bool lim_wins_pixel(struct lim_nearest *nearest, const struct lim_point *at, uint8_t n, uint8_t first);

/* Of others: a polygon that comes. */
void lim_collect_samples_of_pixel(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon);
void lim_collect_look_of_pixel(struct lim_nearest *nearest, const struct lim_screen_polygon *polygon);

/* All of it, where the pools do not hold what is mixed there, or added. */
LIM_MUST_CHECK int lim_draw_pixel(struct lim_nearest *nearest, const struct lim_rect *band);

/* In all views of the frame. */
void lim_nearest_set_antialiased(struct lim_nearest *nearest, bool antialiased);

/* Draws the open view together, and CULL's planes with it. */
static inline void lim_nearest_shrink(struct lim_nearest *nearest)
{
    const bool smaller = lim_spans_shrink(&nearest->spans);

    if (LIM_HAS_CULL && smaller)
        lim_cull_set(lim_cull_of(nearest->pass), &nearest->pass->view, lim_eye_of(nearest->pass)->at_q8,
                     &nearest->spans.open);
}

/* Pass one for a piece of a projected polygon. false: a pool is exhausted. */
bool lim_collect_piece(struct lim_nearest *nearest, uint16_t entry, const struct lim_screen_polygon *whole);

/* Whether lim_set_antialias() has lent what it takes. */
static inline bool lim_wants_antialias(const struct lim_nearest *nearest)
{
    return LIM_HAS_ANTIALIAS && nearest->paint.smooth->sums && !lim_wireframe_of(nearest->pass);
}

/* Whether frames are whole ones of pixels that are one polygon's each. */
static inline bool lim_nearest_is_plain(const struct lim_nearest *nearest)
{
    return !(LIM_HAS_DELTA && *nearest->paint.delta) && !lim_wants_antialias(nearest);
}

/* Whether these are also as lim_can_fill() says. */
static inline bool lim_nearest_can_fill(const struct lim_nearest *nearest)
{
    return lim_nearest_is_plain(nearest) && !lim_nearest_moves(nearest) && lim_can_fill(nearest->pass);
}

/* Whether lines can be painted of all that is in view: antialiased, in one colour a polygon; with textures, where
 * nothing moves. */
static inline bool lim_nearest_may_retain_all(const struct lim_nearest *nearest)
{
    const struct lim_pass *pass = nearest->pass;
    const bool mixed = LIM_HAS_TEXTURE && lim_texture_count(pass->scene) && lim_nearest_moves(nearest);

    if (lim_wants_antialias(nearest)) return !lim_nearest_moves(nearest) && lim_can_fill(pass);
    return lim_nearest_is_plain(nearest) && lim_is_opaque(pass) && !mixed;
}

/* Scan lines: all that is in view is retained. A constant where there is no choice. */
static inline bool lim_nearest_retains_all(const struct lim_nearest *nearest)
{
    return LIM_HAS_SCANLINE && nearest->retains_all;
}

#endif
