/* SPDX-License-Identifier: MIT
 *
 * Draws on a display or a sprite of LovyanGFX: a lim_send that fills one window a frame. LovyanGFX makes of the pixels
 * what the panel takes, 16 bits or 18, whatever setSwapBytes() says.
 *
 *     static LGFX lcd;
 *     static struct limner_lovyangfx display = {&lcd, &house_memory, 0, 0, 0};
 *     int err = house_begin(&house_memory, limner_lovyangfx_send, &display);
 *
 * A frame holds the bus from its first pixel to its last one. LIM_ERR_TARGET: the picture is larger than the display,
 * or lim_set_visible() leaves pixels out, which a window cannot do. Written for LovyanGFX 1.2. */
#ifndef LIMNER_LOVYANGFX_H
#define LIMNER_LOVYANGFX_H

#include "limner.h"

#include <LovyanGFX.hpp>

struct limner_lovyangfx {
    lgfx::LovyanGFX *gfx;
    const struct lim_memory *memory; /* the picture's size is its */
    int32_t x_px, y_px;              /* where the picture's corner is on the display, 0 or more */
    uint32_t sent_px;                /* private, 0 at first: of the frame that holds the bus */
};

/* A frame that was abandoned has left the bus taken, which LovyanGFX counts. */
static inline void limner_lovyangfx_end(struct limner_lovyangfx *display)
{
    if (display->sent_px) display->gfx->endWrite();
    display->sent_px = 0;
}

/* A window that is too large would be cut without a word. */
static inline int limner_lovyangfx_start(struct limner_lovyangfx *display)
{
    const int32_t w_px = display->memory->w_px, h_px = display->memory->h_px;

    if (display->x_px + w_px > display->gfx->width() || display->y_px + h_px > display->gfx->height())
        return LIM_ERR_TARGET;
    display->gfx->startWrite();
    display->gfx->setAddrWindow(display->x_px, display->y_px, w_px, h_px);
    return LIM_OK;
}

static inline int limner_lovyangfx_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct limner_lovyangfx *const display = static_cast<struct limner_lovyangfx *>(ctx);
    const uint32_t w_px = display->memory->w_px, at_px = y_px * w_px + x_px;
    if (at_px == 0 || at_px != display->sent_px || n_px == 0) limner_lovyangfx_end(display);
    if (at_px != display->sent_px || n_px == 0) return LIM_ERR_TARGET;
    const int err = at_px == 0 ? limner_lovyangfx_start(display) : LIM_OK;
    if (err) return err;
    display->gfx->writePixels(reinterpret_cast<const lgfx::swap565_t *>(pixels), n_px);
    display->sent_px += n_px;
    if (display->sent_px == w_px * display->memory->h_px) limner_lovyangfx_end(display);
    return LIM_OK;
}

#endif
