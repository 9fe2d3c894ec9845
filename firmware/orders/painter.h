/* SPDX-License-Identifier: MIT
 *
 * Back to front, into a framebuffer. Nearest first comes here with single lines for which a pool is too small. */
#ifndef LIM_PAINTER_H
#define LIM_PAINTER_H

#include "orders.h"
#include "view/pass.h"

/* Whether all of a frame is opaque and filled. */
static inline bool lim_is_opaque(const struct lim_pass *pass)
{
    return !(LIM_HAS_TRANSPARENT && pass->scene->limits.layers) && !lim_wireframe_of(pass);
}

/* Whether all of a frame in which nothing moves is made of pieces in one opaque colour each, and of no others: a target
 * that keeps the whole picture can have them as they are found. */
static inline bool lim_can_fill(const struct lim_pass *pass)
{
    return lim_is_opaque(pass) && !(LIM_HAS_TEXTURE && lim_texture_count(pass->scene));
}

/* Of a sorted method; NULL where none is linked. */
static inline struct lim_sorter *lim_painter_sorter(const struct lim_painter *painter)
{
    return LIM_HAS_SORTED ? *painter->sorter : NULL;
}

size_t lim_painter_mem_b(const struct lim_scene *scene);
void lim_painter_init(struct lim_painter *painter, void *mem);

/* A frame, of a camera that is taken in. 0, an enum lim_error, or the target's error. */
LIM_MUST_CHECK int lim_painter_frame(struct lim_painter *painter);

/* Line y of a frame of nearest first, and done. `lent`: it is lent already; NULL: it is lent now. */
LIM_MUST_CHECK int lim_painter_line(struct lim_painter *painter, uint16_t *lent, uint16_t y);

#endif
