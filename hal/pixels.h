/* SPDX-License-Identifier: MIT
 *
 * From the renderer's pixels to a panel's. The renderer paints RGB565 as a bus has it, the byte with the red bits first
 * (LIM_RGB565); here it becomes what the chip was told to expect. Colours of fewer bits are dithered by a 4x4 matrix
 * that is fixed on the glass, so a still picture stands still; black and white stay what they are. */
#ifndef HAL_PIXELS_H
#define HAL_PIXELS_H

#include "bus.h"

enum panel_format {
    PANEL_USUAL,      /* in a configuration: the chip's own choice */
    PANEL_RGB565,     /* 2 bytes */
    PANEL_RGB444,     /* 12 bits, two pixels in 3 bytes; dithered */
    PANEL_RGB666,     /* 3 bytes, a colour in the upper six bits of each */
    PANEL_MONO_PAGES, /* a byte for eight pixels one above the other, the lowest bit on top; dithered */
    PANEL_FORMATS
};

/* Bytes of n_px pixels that follow each other, below 2^16 of them; of pages n_px is a multiple of 8. */
static inline size_t pixels_b(enum panel_format format, size_t n_px)
{
    if (format == PANEL_MONO_PAGES) return n_px / 8;
    return format == PANEL_RGB666 ? 3 * n_px : format == PANEL_RGB444 ? (3 * n_px + 1) / 2 : 2 * n_px;
}

/* How many bytes before the renderer's pixels a line has to begin, to be packed into its own memory. */
static inline size_t pixels_head_b(enum panel_format format, size_t n_px)
{
    return format == PANEL_RGB666 ? n_px : 0;
}

/* Packs n_px of the renderer's pixels, in any format but pages, that belong at x_px, y_px of the picture. `to` may be
 * memory of its own; or begin where `from` does, or as far before it as pixels_head_b() says. An odd pixel at the end
 * of RGB444 is filled up with 0. */
void pixels_pack(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                 uint16_t n_px);

/* Puts n_px of the renderer's pixels into a page, whose byte 0 is column 0: bit y_px % 8 of columns x_px and on, set
 * where a pixel is bright. Brightness is ITU-R BT.601's, dithered by an 8x8 matrix. */
void pixels_to_page(uint8_t *page, const uint8_t *from, uint16_t x_px, uint16_t y_px, uint16_t n_px);

#endif
