/* SPDX-License-Identifier: MIT
 *
 * Draws on a display of TFT_eSPI: a lim_send that fills one window a frame, in whatever byte order the sketch has set.
 *
 *     static TFT_eSPI tft;
 *     static struct limner_tft_espi display = {&tft, &house_memory, 0, 0, false};
 *     int err = house_begin(&house_memory, limner_tft_espi_send, &display);
 *
 * A frame holds the bus from its first pixel to its last one. LIM_ERR_TARGET: the picture is larger than the display.
 * Written for TFT_eSPI 2.5. */
#ifndef LIMNER_TFT_ESPI_H
#define LIMNER_TFT_ESPI_H

#include "limner.h"

#include <TFT_eSPI.h>

struct limner_tft_espi {
    TFT_eSPI *tft;
    const struct lim_memory *memory; /* the picture's size is its */
    int32_t x_px, y_px;              /* where the picture's corner is on the display, 0 or more */
    bool is_open;                    /* private, false at first: a frame holds the bus */
};

/* A frame that was abandoned has left the bus taken. */
static inline void limner_tft_espi_end(struct limner_tft_espi *display)
{
    if (display->is_open) display->tft->endWrite();
    display->is_open = false;
}

static inline int limner_tft_espi_start(struct limner_tft_espi *display)
{
    const int32_t w_px = display->memory->w_px, h_px = display->memory->h_px;

    limner_tft_espi_end(display);
    if (display->x_px + w_px > display->tft->width() || display->y_px + h_px > display->tft->height())
        return LIM_ERR_TARGET;
    display->tft->startWrite();
    display->is_open = true;
    display->tft->setAddrWindow(display->x_px, display->y_px, w_px, h_px);
    return LIM_OK;
}

static inline int limner_tft_espi_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct limner_tft_espi *const display = static_cast<struct limner_tft_espi *>(ctx);
    const int err = x_px == 0 && y_px == 0 ? limner_tft_espi_start(display) : LIM_OK;
    const bool swaps = display->tft->getSwapBytes();

    if (err) return err;
    display->tft->setSwapBytes(false); /* as the bytes lie in memory */
    display->tft->pushPixels(pixels, n_px);
    display->tft->setSwapBytes(swaps);
    if (y_px + 1 == display->memory->h_px && x_px + n_px == display->memory->w_px) limner_tft_espi_end(display);
    return LIM_OK;
}

#endif
