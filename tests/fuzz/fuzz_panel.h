/* SPDX-License-Identifier: MIT
 *
 * A display for the fuzz targets, which takes pixels in each way that a target may: lines, a framebuffer, pieces as
 * they are found, runs of colour, changes in windows or pages. Its memory is from the heap to the byte. Whatever is
 * sent where nothing may be, or in no order, is noted. */
#ifndef TESTS_FUZZ_PANEL_H
#define TESTS_FUZZ_PANEL_H

#include "limner.h"

enum { FUZZ_PANEL_SIDE_PX = 32, FUZZ_PANEL_ERROR = -77 };

enum fuzz_sink { FUZZ_SINK_LINES, FUZZ_SINK_FRAMEBUFFER, FUZZ_SINK_PIECES, FUZZ_SINK_RUNS, FUZZ_SINKS };

struct fuzz_panel {
    struct lim_target target;
    uint16_t unpainted;                      /* what lines are before a frame */
    uint16_t *lines[FUZZ_PANEL_SIDE_PX + 1]; /* of the framebuffer, or each on its own */
    uint16_t *kept;                          /* what pieces are painted into */
    uint16_t shown[FUZZ_PANEL_SIDE_PX][FUZZ_PANEL_SIDE_PX];
    uint8_t done[FUZZ_PANEL_SIDE_PX][FUZZ_PANEL_SIDE_PX]; /* how often each pixel was final in this frame */
    uint16_t page[8][FUZZ_PANEL_SIDE_PX];
    struct lim_rect window;
    uint16_t x, y; /* the window's next pixel */
    bool in_window, is_round;
    uint32_t calls, fails_at; /* of lend(), done(), window() and show() in this frame; from 1 on, 0: never */
    bool failed;
    const char *broken; /* NULL: nothing so far */
};

/* `page_px`: 0: every frame is sent whole; else changes alone are, line by line (1) or in pages (8). With pages, h_px
 * is a multiple of 8. */
void fuzz_panel_init(struct fuzz_panel *panel, uint16_t w_px, uint16_t h_px, enum fuzz_sink sink, bool is_round,
                     uint8_t page_px);

/* Before each frame: nothing is painted. */
void fuzz_panel_begin(struct fuzz_panel *panel, uint16_t unpainted, uint32_t fails_at);

/* What of a line the glass shows. */
void fuzz_panel_visible(const struct fuzz_panel *panel, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px);

/* After each frame that did not fail: each pixel that can be seen was sent, once if frames are sent whole; and none is
 * unpainted, if `is_painted`. The broken promise, or NULL. */
const char *fuzz_panel_check(const struct fuzz_panel *panel, bool is_painted);

/* Whether both show the same where both can be seen. */
bool fuzz_panel_is_same(const struct fuzz_panel *a, const struct fuzz_panel *b);

void fuzz_panel_free(struct fuzz_panel *panel);

#endif
