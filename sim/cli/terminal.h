/* SPDX-License-Identifier: MIT
 *
 * A picture in a terminal: a character shows two pixels, one above the other, in 24-bit colour. */
#ifndef SIM_TERMINAL_H
#define SIM_TERMINAL_H

#include "pictures/image.h"

/* Shrinks a frame into columns x rows characters, keeping its proportions, and prints it. */
bool terminal_print(const struct film *frame, unsigned columns, unsigned rows, FILE *out, struct error *err);

#endif
