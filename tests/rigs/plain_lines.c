/* SPDX-License-Identifier: MIT */
#include "plain_lines.h"

static void *lend(void *ctx, uint16_t y_px)
{
    const struct plain_lines *lines = ctx;

    return lines->pixels + y_px * lines->stride_px;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

struct lim_target plain_lines_target(struct plain_lines *lines, uint16_t w_px, uint16_t h_px, enum lim_method method)
{
    return (struct lim_target){
        .w_px = w_px, .h_px = h_px, .format = LIM_RGB565, .method = method, .ctx = lines, .lend = lend, .done = done};
}
