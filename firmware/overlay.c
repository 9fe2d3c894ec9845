/* SPDX-License-Identifier: MIT
 *
 * Everything is runs of one colour on the line that is drawn over: into its memory or, where a target keeps pixels in a
 * format of its own, by the target's fill(). */
#include "overlay.h"

#include "colour.h"
#include "pixels/fill.h"

#if LIM_HAS_OVERLAY

void lim_overlay_fill(const struct lim_overlay_line *line, int32_t x0_px, int32_t x1_px, uint16_t rgb565)
{
    if (x0_px < line->x0_px) x0_px = line->x0_px;
    if (x1_px > line->x1_px) x1_px = line->x1_px;
    if (x0_px >= x1_px) return;
    lim_fill_run(line->target, line->pixels, line->y_px, (uint16_t)x0_px, (uint16_t)(x1_px - x0_px),
                 lim_memory_colour(rgb565));
}

/* Whether a box has pixels on the line: how far below its top that is; or negative. */
static int32_t depth_in(const struct lim_overlay_line *line, const struct lim_overlay_box *box)
{
    const int32_t depth_px = (int32_t)line->y_px - box->y_px;

    return depth_px < box->h_px ? depth_px : -1;
}

void lim_overlay_box(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t rgb565)
{
    if (depth_in(line, box) < 0) return;
    lim_overlay_fill(line, box->x_px, (int32_t)box->x_px + box->w_px, rgb565);
}

void lim_overlay_frame(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t rgb565)
{
    const int32_t depth_px = depth_in(line, box), x1_px = (int32_t)box->x_px + box->w_px;

    if (depth_px < 0 || box->w_px <= 0) return;
    if (depth_px == 0 || depth_px == box->h_px - 1 || box->w_px == 1) {
        lim_overlay_fill(line, box->x_px, x1_px, rgb565);
        return;
    }
    lim_overlay_fill(line, box->x_px, (int32_t)box->x_px + 1, rgb565);
    lim_overlay_fill(line, x1_px - 1, x1_px, rgb565);
}

/* w < 2^15 and value < 2^16: the product fits. */
void lim_overlay_bar(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t value,
                     uint16_t full, uint16_t rgb565)
{
    if (depth_in(line, box) < 0 || box->w_px <= 0) return;
    const uint32_t w_px = value < full ? (uint32_t)box->w_px * value / full : (uint32_t)box->w_px;
    lim_overlay_fill(line, box->x_px, box->x_px + (int32_t)w_px, rgb565);
}

#endif
