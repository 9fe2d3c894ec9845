/* SPDX-License-Identifier: MIT
 *
 * The orders in which a frame can be drawn, enum lim_method: what memory each asks for (`least`: with
 * less it is refused), how it cuts the caller's memory up, and a frame. Frames start from a camera that
 * lim_view_begin() and lim_eye_set() have taken in; they return 0, an enum lim_error, or the target's
 * error. An order that is not linked is declared all the same: no call of it is ever reached. */
#ifndef LIM_ORDER_H
#define LIM_ORDER_H

#include "limner.h"

/* Which sorted order the method is, if it is one; constants where there is no choice. */
#define LIM_IS_SORTED(target) (LIM_HAS_SORTED && (!LIM_HAS_WALKED || (target)->method >= LIM_DEPTH))
#define LIM_IS_NEWELL(target)                                                                                          \
    (LIM_HAS_NEWELL && ((!LIM_HAS_WALKED && !LIM_HAS_DEPTH) || (target)->method == LIM_NEWELL))

#define LIM_IS_SCANLINE(target)                                                                                        \
    (LIM_HAS_SCANLINE && ((!LIM_HAS_NEAREST && !LIM_HAS_SORTED) || (target)->method == LIM_SCANLINE))

/* Whether what is drawn nearest first is a line's samples: what antialiasing takes. */
#define LIM_PAINTS_NEAREST_FIRST(target)                                                                               \
    (LIM_HAS_SPANS && (target)->method != LIM_CONVEX && (target)->method != LIM_PAINTER)

/* Whether an entry of the sorted list is a piece of a polygon that was split. */
static inline bool lim_is_piece(const struct lim *lim, uint16_t entry)
{
#if LIM_HAS_NEWELL
    return LIM_IS_NEWELL(&lim->target) && lim->sorter.newell.polygons[entry].cuts != LIM_NONE;
#else
    (void)lim;
    (void)entry;
    return false;
#endif
}

/* Whether lim_set_antialias() has lent what it takes. */
static inline bool lim_wants_antialias(const struct lim *lim)
{
#if LIM_HAS_ANTIALIAS
    return lim->paint.smooth.sums && !lim_wireframe_of(lim);
#else
    (void)lim;
    return false;
#endif
}

/* Whether all of the frame is made of pieces in one opaque colour each, and of no others: a target that keeps the whole
 * picture can have them as they are found. */
static inline bool lim_can_fill(const struct lim *lim)
{
#if LIM_HAS_DELTA
    if (lim->delta) return false;
#endif
    if (LIM_HAS_TRANSPARENT && lim->scene->limits.layers) return false;
    return !lim_wants_antialias(lim) && !(LIM_HAS_TEXTURE && lim_texture_count(lim->scene)) && !lim_wireframe_of(lim) &&
           !lim_moves(lim);
}

/* Nearest first, which needs no framebuffer: bands.c, and its memory in pools.c. From the tree, or from a sorted list.
 * So does the scan-line order. */
size_t lim_nearest_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least);
void lim_nearest_init(struct lim *lim, void *mem, size_t mem_b);
LIM_MUST_CHECK int lim_nearest_frame(struct lim *lim);

/* The same in parts, after lim_frame_begin(), if LIM_HAS_STREAM. */
bool lim_nearest_work(struct lim *lim);
LIM_MUST_CHECK int lim_nearest_paint(struct lim *lim);

/* lim_frame_begin() where none is begun; the frame has the instances that are set. */
LIM_MUST_CHECK int lim_begin_ahead(struct lim *lim, const struct lim_camera *camera);

/* Pass one over a band: nearest.c. false: a pool is exhausted. */
bool lim_collect(struct lim *lim, const struct lim_rect *band);

#if LIM_HAS_STREAM
/* The same over the frame, in quanta: what it returns is LIM_AHEAD_BUSY but for the last. */
void lim_collect_begin(struct lim *lim, const struct lim_rect *frame);
enum lim_ahead_stage lim_collect_some(struct lim *lim);
#endif

/* Back to front, into one: painter.c. */
size_t lim_painter_mem_b(const struct lim_scene *scene);
void lim_painter_init(struct lim *lim, void *mem);
LIM_MUST_CHECK int lim_painter_frame(struct lim *lim);

/* Line y of a frame of nearest first, which is lent already or is lent now, and done: in the painter's order. */
LIM_MUST_CHECK int lim_painter_line(struct lim *lim, uint16_t y);

/* One convex solid: convex.c. `active`: for how many faces on a line; 0 is the least. */
size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, uint16_t active);
void lim_convex_init(struct lim *lim, void *mem, size_t mem_b);
LIM_MUST_CHECK int lim_convex_frame(struct lim *lim);

#endif
