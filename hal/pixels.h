/* SPDX-License-Identifier: MIT
 *
 * From the renderer's pixels to a panel's. The renderer paints RGB565 as a bus has it, the byte with the red bits first
 * (LIM_RGB565); here it becomes what the chip was told to expect. Colours of fewer bits are dithered by a matrix
 * that is fixed on the glass, so a still picture stands still; black and white stay what they are. */
#ifndef HAL_PIXELS_H
#define HAL_PIXELS_H

#include "bus.h"

HAL_C_BEGIN

/* 1: of the formats whose pixels share bytes there are pages alone, which saves half a kilobyte of code. */
#ifndef PIXELS_ONLY_PAGES
#define PIXELS_ONLY_PAGES 0
#endif

enum panel_format {
    PANEL_USUAL,      /* in a configuration: the chip's own choice */
    PANEL_RGB565,     /* 2 bytes */
    PANEL_RGB444,     /* 12 bits, two pixels in 3 bytes; dithered */
    PANEL_RGB666,     /* 3 bytes, a colour in the upper six bits of each */
    PANEL_RGB666_LOW, /* 3 bytes, a colour in the lower six bits of each */
    PANEL_MONO_PAGES, /* a byte for eight pixels one above the other, the lowest bit on top; dithered */
    PANEL_MONO_LINES, /* a byte for eight pixels side by side, the highest bit on the left; dithered */
    PANEL_GREY4,      /* a byte for two pixels side by side, the upper four bits on the left; dithered */
    PANEL_FORMATS
};

/* Bytes of n_px pixels that follow each other, below 2^16 of them, whole bytes but for RGB444. */
static inline size_t pixels_b(enum panel_format format, size_t n_px)
{
    switch (format) {
    case PANEL_RGB444:
        return (3 * n_px + 1) / 2;
    case PANEL_RGB666:
    case PANEL_RGB666_LOW:
        return 3 * n_px;
    case PANEL_MONO_PAGES:
    case PANEL_MONO_LINES:
        return n_px / 8;
    case PANEL_GREY4:
        return n_px / 2;
    case PANEL_USUAL:
    case PANEL_RGB565:
    case PANEL_FORMATS:
    default:
        return 2 * n_px;
    }
}

/* How many bytes before the renderer's pixels a line has to begin, to be packed into its own memory. */
static inline size_t pixels_head_b(enum panel_format format, size_t n_px)
{
    return format == PANEL_RGB666 || format == PANEL_RGB666_LOW ? n_px : 0;
}

/* Packs n_px of the renderer's pixels, in a format whose pixels do not share bytes, that belong at x_px, y_px of the
 * picture. `to` may be memory of its own; or begin where `from` does, or as far before it as pixels_head_b() says. An
 * odd pixel at the end of RGB444 is filled up with 0. */
void pixels_pack(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                 uint16_t n_px);

/* Puts n_px of the renderer's pixels, which belong at x_px, y_px of the picture, into the bytes of a whole line, or of
 * eight for pages, that are gathered at `to`: for formats whose pixels share bytes that nobody can write in part. The
 * bits of pixels that are not put yet are 0.
 * Brightness is ITU-R BT.601's: 0.299 red, 0.587 green and 0.114 blue. */
void pixels_gather(enum panel_format format, uint8_t *to, const uint8_t *from, uint16_t x_px, uint16_t y_px,
                   uint16_t n_px);

/* What that makes of one colour in PANEL_GREY4: the bytes of four pixels from a multiple of 4 on, for the lines
 * y_px % 4. */
void pixels_greys(uint8_t bytes[4][2], uint16_t rgb565);

/* The same of n_px pixels of one colour, whatever was put there before. */
void pixels_fill(enum panel_format format, uint8_t *to, uint16_t rgb565, uint16_t x_px, uint16_t y_px, uint16_t n_px);

HAL_C_END

#endif
