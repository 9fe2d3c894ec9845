/* SPDX-License-Identifier: MIT
 *
 * The test card on any screen. */
#ifndef TESTS_KERNEL_CARD_H
#define TESTS_KERNEL_CARD_H

#include "screen.h"

/* 0 or the panel's code. */
int card_draw(struct screen *screen);

#endif
