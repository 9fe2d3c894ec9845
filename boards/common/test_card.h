/* SPDX-License-Identifier: MIT
 *
 * The picture that shows at a glance whether a display is set up right: a corner each of red, green, blue and grey,
 * clockwise from the top left, so that turns, mirrors, exchanged colours and exchanged bytes all look different. */
#ifndef BOARDS_TEST_CARD_H
#define BOARDS_TEST_CARD_H

#include <stdbool.h>
#include <stdint.h>

enum { TEST_CARD_RED = 0xF800, TEST_CARD_GREEN = 0x07E0, TEST_CARD_BLUE = 0x001F, TEST_CARD_GREY = 0x8410 };

/* Whether a pixel of a card of w_px x h_px belongs to a corner, and its colour there: RGB565, as a number. */
bool test_card_corner(unsigned x_px, unsigned y_px, unsigned w_px, unsigned h_px, uint16_t *rgb565);

/* The card for people: the grey corner is a ramp from black to white, and a white line goes round the edge, of which a
 * side is missing if the picture is shifted. */
uint16_t test_card_px(unsigned x_px, unsigned y_px, unsigned w_px, unsigned h_px);

#endif
