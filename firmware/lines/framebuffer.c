/* SPDX-License-Identifier: MIT
 *
 * Nearest first gives pieces that were open, the painter's order whole polygons, of which nothing is asked but where
 * the screen ends. */
#include "lines/framebuffer.h"

#include "screen/edge.h"

#if LIM_HAS_FRAMEBUFFER

void lim_framebuffer_fill(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    lim_framebuffer_fill_inline(of_look, x0_px, x1_px);
}

#if LIM_HAS_PAINTER

void lim_framebuffer_paint(const struct lim_target *target, const struct lim_point *at, uint8_t n, uint8_t first,
                           struct lim_span_extent shown, uint16_t colour)
{
    const int32_t w_px = target->w_px;
    const uint16_t stride_px = target->framebuffer.stride_px;
    uint16_t *line = lim_framebuffer_line(&target->framebuffer, (uint16_t)shown.top);
    struct lim_edge_pair pair;
    int16_t y = shown.top, turn = lim_edge_start(&pair, at, n, first, y);

    for (;;) {
        int32_t x0 = lim_edge_next_x(&pair.left), x1 = lim_edge_next_x(&pair.right);
        if (x0 < 0) x0 = 0;
        if (x1 > w_px) x1 = w_px;
        if (x0 < x1) lim_fill_inline(line, (int_fast16_t)x0, (int_fast16_t)x1, colour);
        if (++y == shown.bottom) return;
        line += stride_px;
        if (y == turn) turn = lim_edge_turn(&pair, at, n, y);
    }
}

#endif

#endif
