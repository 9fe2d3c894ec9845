/* SPDX-License-Identifier: MIT
 *
 * What lies over a frame: text, numbers, bars, whatever a program draws. It has no memory of its own: a function of the
 * program draws it anew on each line, when the scene's pixels are there and before they leave.
 *
 *     static void draw(void *ctx, const struct lim_overlay_line *line)
 *     {
 *         lim_overlay_box(line, &(const struct lim_overlay_box){0, 0, 64, 10}, 0x0000);
 *         lim_text(line, 1, 1, ctx, &(const struct lim_text_style){.colour = 0xFFFF});
 *     }
 *
 *     static const struct lim_overlay overlay = {.draw = draw, .ctx = caption, .y0_px = 0, .y1_px = 10};
 *     lim_set_overlay(&lim, &overlay);
 *
 * There if LIM_HAS_OVERLAY, which `limner compile --overlay` sets. Colours are RGB565 as numbers. Coordinates may lie
 * anywhere: what is beside the line is not painted. What is drawn later lies on top. Text is in text.h. */
#ifndef LIM_OVERLAY_H
#define LIM_OVERLAY_H

#include "config.h"

LIM_C_BEGIN

struct lim_target;

/* A line of the frame, or a piece of it: what the functions below paint on. */
struct lim_overlay_line {
    uint16_t y_px;
    uint16_t x0_px, x1_px;           /* pixels x0 <= x < x1 may be painted, no others */
    uint16_t *pixels;                /* private: those of the whole line; NULL: the target fills them */
    const struct lim_target *target; /* private */
};

/* Draws what lies over one line. It is called from within lim_frame(), and lim_frame_paint(), from the top down; more
 * than once for a line that comes in pieces. So what it shows stays the same as long as a frame takes. */
typedef void lim_overlay_draw(void *ctx, const struct lim_overlay_line *line); /* program's */

/* The members may change from frame to frame. */
struct lim_overlay {
    lim_overlay_draw *draw;
    void *ctx;             /* handed to draw() */
    uint16_t y0_px, y1_px; /* called for lines y0 <= y < y1: no others are drawn over, and these alone cost time */
};

/* Pixels x0 <= x < x1 of the line. */
void lim_overlay_fill(const struct lim_overlay_line *line, int32_t x0_px, int32_t x1_px, uint16_t rgb565);

/* A rectangle; where a side is not above 0 it is empty. */
struct lim_overlay_box {
    int16_t x_px, y_px, w_px, h_px;
};

/* All of it; its outline, a pixel wide, inside of it; its left part, by value / full, rounded down: 0 to all of it. */
void lim_overlay_box(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t rgb565);
void lim_overlay_frame(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t rgb565);
void lim_overlay_bar(const struct lim_overlay_line *line, const struct lim_overlay_box *box, uint16_t value,
                     uint16_t full, uint16_t rgb565);

LIM_C_END

#endif
