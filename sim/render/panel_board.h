/* SPDX-License-Identifier: MIT
 *
 * The simulator's board: an emulated module, the real driver for it and the screen that
 * every board uses, wired together as a board's pins would be. */
#ifndef SIM_PANEL_BOARD_H
#define SIM_PANEL_BOARD_H

#include "glass/emulated_display.h"
#include "screen.h"

struct panel_board {
    const char *name;
    struct emulated_display module;
    struct display_module glass; /* of it */
    struct display display;      /* the driver */
    struct screen screen;        /* screen.target is what the renderer paints into */
    void *lines;
    uint8_t *seen; /* 3 bytes a pixel: what is on the glass */
};

/* An error says why not. */
bool panel_board_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct error *err);

/* Switches the panel on. Large, and must not move: place it on the heap. */
bool panel_board_init(struct panel_board *board, const struct panel_choice *choice, enum lim_method method,
                      unsigned w_px, unsigned h_px, struct error *err);

/* Bytes sent so far. */
uint64_t panel_board_bus_b(const struct panel_board *board);

/* What the eye sees on the glass, as RGB565 numbers; an error if the chip had anything to
 * complain about since it was switched on. */
bool panel_board_read(struct panel_board *board, uint16_t *pixels, struct error *err);

void panel_board_free(struct panel_board *board);

#endif
