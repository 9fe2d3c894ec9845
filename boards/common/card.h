/* SPDX-License-Identifier: MIT
 *
 * The test card on a screen, as its viewer is to see it. */
#ifndef BOARDS_CARD_H
#define BOARDS_CARD_H

#include "screen.h"

/* A whole frame of it. turn: what the panel's chip cannot turn, and the camera does for a scene; the card stands so
 * many quarters clockwise on the glass. 0, or the panel's negative code; LIM_ERR_TARGET: the screen lends no line. */
LIM_MUST_CHECK int card_draw(struct screen *screen, enum panel_rotation turn);

#endif
