/* SPDX-License-Identifier: MIT
 *
 * What a target may have (target.h), asked for without a question of whether it is linked: here is the half that does
 * nothing where it is not. */
#ifndef LIM_TARGET_PARTS_H
#define LIM_TARGET_PARTS_H

#include "target.h"

/* Whether a target leaves out pixels of its lines: lim_target_visible() says which it has. */
#if LIM_HAS_ROUND
static inline bool lim_target_is_round(const struct lim_target *target)
{
    return target->visible != NULL;
}

static inline void lim_target_visible(const struct lim_target *target, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    target->visible(target->ctx, y_px, x0_px, x1_px);
}
#else
static inline bool lim_target_is_round(const struct lim_target *target)
{
    (void)target;
    return false;
}

static inline void lim_target_visible(const struct lim_target *target, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    (void)y_px;
    *x0_px = 0;
    *x1_px = target->w_px;
}
#endif

/* What a target keeps is filled by, or NULL: it lends lines. */
static inline lim_piece_fill *lim_target_fill(const struct lim_target *target)
{
#if LIM_HAS_FILL
    return target->fill;
#else
    (void)target;
    return NULL;
#endif
}

/* Whether it keeps the whole picture. */
static inline bool lim_target_keeps_all(const struct lim_target *target)
{
#if LIM_HAS_FILL && LIM_HAS_NEAREST
    return target->show != NULL;
#else
    (void)target;
    return false;
#endif
}

static inline int lim_target_show(const struct lim_target *target)
{
#if LIM_HAS_FILL && LIM_HAS_NEAREST
    return target->show(target->ctx);
#else
    (void)target;
    return LIM_ERR_TARGET;
#endif
}

/* Whether there is a framebuffer: then it is painted, and done() called for each line at the end. */
static inline bool lim_has_framebuffer(const struct lim_target *target)
{
#if LIM_HAS_FRAMEBUFFER
    return target->framebuffer.pixels;
#else
    (void)target;
    return false;
#endif
}

static inline struct lim_framebuffer *lim_framebuffer_of(struct lim_target *target)
{
#if LIM_HAS_FRAMEBUFFER
    return &target->framebuffer;
#else
    (void)target;
    return NULL;
#endif
}

#endif
