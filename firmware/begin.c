/* SPDX-License-Identifier: MIT
 *
 * A target of one line, or of all of them, whose pixels are sent as soon as they are final. */
#include "limner.h"

static uint16_t *sender_line(const struct lim_sender *sender, uint16_t y_px)
{
    return sender->lines + (size_t)y_px * sender->stride_px;
}

static void *sender_lend(void *ctx, uint16_t y_px)
{
    return sender_line(ctx, y_px);
}

static int sender_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    const struct lim_sender *sender = ctx;

    return sender->send(sender->ctx, y_px, sender_line(sender, y_px) + x_px, x_px, n_px);
}

int lim_sender_target(struct lim_sender *sender, uint16_t w_px, uint16_t h_px, enum lim_method method,
                      struct lim_target *target)
{
    LIM_ASSERT(sender && target && sender->send && sender->lines);
    LIM_ASSERT((uintptr_t)sender->lines % LIM_ALIGNOF(uint32_t) == 0);
    const uint32_t line_b = LIM_LINE_B((uint32_t)w_px);
    const bool is_whole = sender->lines_b >= line_b * h_px;

    if (sender->lines_b < line_b || (method == LIM_PAINTER && !is_whole)) return LIM_ERR_MEMORY;
    sender->stride_px = (uint16_t)(is_whole ? line_b / 2 : 0);
    *target = (struct lim_target){
        .w_px = w_px, .h_px = h_px, .method = method, .ctx = sender, .lend = sender_lend, .done = sender_done};
#if LIM_HAS_FRAMEBUFFER
    if (is_whole) target->framebuffer = (struct lim_framebuffer){sender->lines, sender->stride_px};
#endif
    return LIM_OK;
}
