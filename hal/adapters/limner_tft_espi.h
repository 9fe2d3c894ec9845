/* SPDX-License-Identifier: MIT
 *
 * Draws on a display of TFT_eSPI: a lim_send that fills one window a frame, in whatever byte order the sketch has set.
 *
 *     static TFT_eSPI tft;
 *     static struct limner_tft_espi display = {&tft, &house_memory, 0, 0, 0};
 *     int err = house_begin(&house_memory, limner_tft_espi_send, &display);
 *
 * A frame holds the bus from its first pixel to its last one. LIM_ERR_TARGET: the picture is larger than the display,
 * or lim_set_visible() leaves pixels out, which a window cannot do. Written for TFT_eSPI 2.5. */
#ifndef LIMNER_TFT_ESPI_H
#define LIMNER_TFT_ESPI_H

#include "limner.h"

#include <TFT_eSPI.h>

struct limner_tft_espi {
    TFT_eSPI *tft;
    const struct lim_memory *memory; /* the picture's size is its */
    int32_t x_px, y_px;              /* where the picture's corner is on the display, 0 or more */
    uint32_t sent_px;                /* private, 0 at first: of the frame that holds the bus */
};

/* A frame that was abandoned has left the bus taken. */
static inline void limner_tft_espi_end(struct limner_tft_espi *display)
{
    if (display->sent_px) display->tft->endWrite();
    display->sent_px = 0;
}

static inline int limner_tft_espi_start(struct limner_tft_espi *display)
{
    const int32_t w_px = display->memory->w_px, h_px = display->memory->h_px;

    if (display->x_px + w_px > display->tft->width() || display->y_px + h_px > display->tft->height())
        return LIM_ERR_TARGET;
    display->tft->startWrite();
    display->tft->setAddrWindow(display->x_px, display->y_px, w_px, h_px);
    return LIM_OK;
}

static inline int limner_tft_espi_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct limner_tft_espi *const display = static_cast<struct limner_tft_espi *>(ctx);
    const uint32_t w_px = display->memory->w_px, at_px = y_px * w_px + x_px;
    const bool swaps = display->tft->getSwapBytes();
    if (at_px == 0 || at_px != display->sent_px || n_px == 0) limner_tft_espi_end(display);
    if (at_px != display->sent_px || n_px == 0) return LIM_ERR_TARGET;
    const int err = at_px == 0 ? limner_tft_espi_start(display) : LIM_OK;
    if (err) return err;
    display->tft->setSwapBytes(false); /* as the bytes lie in memory */
    display->tft->pushPixels(pixels, n_px);
    display->tft->setSwapBytes(swaps);
    display->sent_px += n_px;
    if (display->sent_px == w_px * display->memory->h_px) limner_tft_espi_end(display);
    return LIM_OK;
}

#endif
