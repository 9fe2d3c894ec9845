/* SPDX-License-Identifier: MIT
 *
 * Pictures as files: PNG, animated GIF and a contact sheet of many frames, by libgd. */
#ifndef SIM_IMAGE_H
#define SIM_IMAGE_H

#include "base/error.h"

#include <gd.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Frames of one size, one after the other, each row by row from the top left. RGB565 as a number
 * (red in bits 11..15). One frame is a film of one. */
struct film {
    unsigned w_px, h_px;
    size_t count;
    const uint16_t *pixels;
};

/* 0xRRGGBB; full intensity stays full intensity. */
uint32_t image_rgb888_from_565(uint16_t colour);

/* A true-colour picture of one frame; gdImageDestroy() it. NULL: out of memory. */
gdImagePtr image_from_frame(const struct film *film, size_t frame);

/* Up to 24 frames, evenly chosen, in a grid with thin lines between; large frames are shrunk. */
gdImagePtr image_contact_sheet(const struct film *film);

bool image_write_png(gdImagePtr image, FILE *file, const char *name, struct error *err);

/* gdImageDestroy() it; NULL: an error says why it cannot be read. */
gdImagePtr image_read_png(const char *path, struct error *err);

/* Plays for ever; one palette for all frames, so that no colour flickers. */
bool image_write_gif(const struct film *film, double frames_per_s, FILE *file, const char *name, struct error *err);

/* Compares one frame with a PNG file, pixel by pixel; the error names the first difference. */
bool image_check_png(const struct film *frame, const char *path, struct error *err);

#endif
