/* SPDX-License-Identifier: MIT
 *
 * Nothing is kept: each line is drawn over whenever it comes, so a frame that failed leaves nothing behind. */
#include "lines/overlaid.h"

#include "lines/framebuffer.h"

#if LIM_HAS_OVERLAY

void lim_overlay_call(const struct lim_pass *pass, const struct lim_overlay_line *line)
{
    const struct lim_overlay *overlay = *pass->overlay;

    if (line->x0_px < line->x1_px) overlay->draw(overlay->ctx, line);
}

void lim_overlay_picture(struct lim_pass *pass)
{
    const struct lim_target *target = &pass->target;
    const struct lim_framebuffer *framebuffer = lim_has_framebuffer(target) ? lim_framebuffer_of(&pass->target) : NULL;

    for (uint16_t y = 0; y < target->h_px; y++) {
        uint16_t x0 = 0, x1 = target->w_px;
        if (!lim_is_overlaid(pass, y)) continue;
        if (lim_target_is_round(target)) lim_target_visible(target, y, &x0, &x1);
        lim_overlay_line(pass, framebuffer ? lim_framebuffer_line(framebuffer, y) : NULL, y, x0, x1);
    }
}

#endif
