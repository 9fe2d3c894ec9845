/* SPDX-License-Identifier: MIT
 *
 * A board: a microcontroller whose clocks run, and what of it a display is wired to. Its folder implements
 * board_init(); all that is above knows nothing else of it. */
#ifndef BOARDS_BOARD_H
#define BOARDS_BOARD_H

#include "bus.h"
#include "spi_modes.h"

enum board_button { BOARD_UP = 1, BOARD_DOWN = 2, BOARD_LEFT = 4, BOARD_RIGHT = 8, BOARD_SELECT = 16 };

/* The board's own state is in its folder, and its alone. */
struct board {
    struct bus bus;
    struct pin dc, reset, backlight, select; /* those that are not wired are zero */
    struct edge tearing;
    struct clock clock;
    struct pin led;           /* high: lit, whatever its wiring; or zero */
    uint8_t (*buttons)(void); /* enum board_button, those that are down; NULL: there are none */
};

/* Starts the clocks, takes the pins and sets the bus to spi_hz, or the next slower rate that it has, and to the mode of
 * spi_modes (a set of spi_modes.h) that the board likes best. *board is zero before. May be called again when something
 * failed: all begins anew then. What could be set up is in *board even if it returns a negative code: enum mcu_error,
 * or the port's own. */
HAL_MUST_CHECK int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes);

/* A board on which the firmware is a program, which ends, says -DBOARD_ENDS=1 in its board.mk, and has these as well.
 */
#ifndef BOARD_ENDS
#define BOARD_ENDS 0
#endif

/* Asked before each frame: whether it was the last. */
bool board_is_over(void);

/* Releases all, after the panel was darkened or something failed: 0 or its negative code. Returns the program's exit
 * status. */
int board_end(int err);

#endif
