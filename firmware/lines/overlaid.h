/* SPDX-License-Identifier: MIT
 *
 * OVERLAY: between PAINT and the target, delta output included. In: a line, or a piece of it, whose pixels are final
 * but for what lies over them. Out: the same, drawn over by the caller's function (overlay.h). No memory. Everyone who
 * says that pixels are done comes here first. */
#ifndef LIM_OVERLAID_H
#define LIM_OVERLAID_H

#include "overlay.h"
#include "stages.h"

/* Whether something may lie over line y: then it has to be painted. */
static inline bool lim_is_overlaid(const struct lim_pass *pass, uint16_t y_px)
{
    if (!LIM_HAS_OVERLAY) return false;
    const struct lim_overlay *overlay = *pass->overlay;
    return overlay && y_px >= overlay->y0_px && y_px < overlay->y1_px;
}

#if LIM_HAS_OVERLAY
/* Calls the caller's function, which there is. */
void lim_overlay_call(const struct lim_pass *pass, const struct lim_overlay_line *line);

/* Draws over all lines of a picture that the target keeps, as far as they are seen. */
void lim_overlay_picture(struct lim_pass *pass);
#else
static inline void lim_overlay_call(const struct lim_pass *pass, const struct lim_overlay_line *line)
{
    (void)pass;
    (void)line;
}

static inline void lim_overlay_picture(struct lim_pass *pass)
{
    (void)pass;
}
#endif

/* Draws over pixels x0 <= x < x1 of line y, which lies at `pixels`; or, if that is NULL, is filled by the target. Most
 * lines have nothing over them. */
static inline void lim_overlay_line(const struct lim_pass *pass, uint16_t *pixels, uint16_t y_px, uint16_t x0_px,
                                    uint16_t x1_px)
{
    if (!lim_is_overlaid(pass, y_px)) return;
    const struct lim_overlay_line line = {y_px, x0_px, x1_px, pixels, &pass->target};
    lim_overlay_call(pass, &line);
}

#endif
