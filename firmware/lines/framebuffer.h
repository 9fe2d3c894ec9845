/* SPDX-License-Identifier: MIT
 *
 * Targets that keep the whole picture: what paints a piece of a line there, or all of a polygon. In: pieces that SPAN
 * found open, or a polygon on the screen. Memory: the target's. */
#ifndef LIM_FRAMEBUFFER_H
#define LIM_FRAMEBUFFER_H

#include "pixels/fill.h"
#include "pixels/target_parts.h"
#include "stages.h"

/* Says that whole lines are there. 0 or the target's error. */
static inline int lim_target_done(const struct lim_target *target, const struct lim_rect *lines)
{
    int err = 0;

    for (uint16_t y = lines->y0; y < lines->y1 && !err; y++)
        err = target->done(target->ctx, y, 0, target->w_px);
    return err;
}

static inline uint16_t *lim_framebuffer_line(const struct lim_framebuffer *framebuffer, uint16_t y_px)
{
    return (uint16_t *)framebuffer->pixels + (size_t)y_px * framebuffer->stride_px;
}

/* Its context is a struct lim_piece_look, and the ctx of that the framebuffer. */
lim_piece_fill lim_framebuffer_fill;

/* The same where calls are many. */
static lim_piece_fill lim_framebuffer_fill_inline;
static LIM_INLINE void lim_framebuffer_fill_inline(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    uint16_t *const line = lim_framebuffer_line(look->ctx, look->y_px);

    lim_fill_inline(line, (int_fast16_t)x0_px, (int_fast16_t)x1_px, look->colour);
}

/* Paints a polygon that is not non-monotone on the lines `shown`, top < bottom, which it has and the target too. */
void lim_framebuffer_paint(const struct lim_target *target, const struct lim_point *at, uint8_t n, uint8_t first,
                           struct lim_span_extent shown, uint16_t colour);

/* What paints pieces as they are found, and the ctx of its looks. NULL: lines are lent. */
static inline lim_piece_fill *lim_fill_of(const struct lim_target *target)
{
    if (LIM_HAS_FRAMEBUFFER && lim_has_framebuffer(target)) return lim_framebuffer_fill;
    return lim_target_keeps_all(target) ? lim_target_fill(target) : NULL;
}

static inline void *lim_fill_ctx_of(struct lim_target *target)
{
    return lim_has_framebuffer(target) ? lim_framebuffer_of(target) : target->ctx;
}

#endif
