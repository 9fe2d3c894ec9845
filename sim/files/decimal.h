/* SPDX-License-Identifier: MIT
 *
 * Decimal numbers of model files, to the nearest double. */
#ifndef SIM_DECIMAL_H
#define SIM_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>

/* Parses text[0 .. length), all of it: digits with a sign, a point and an exponent, as far as these are there. The
 * text must go on after it with something that no number goes on with, a blank, a line's end or a 0. Refused: nan,
 * inf, hexadecimal digits, a comma, and what is beyond float32's 3.4e38. What is nearer to 0 than any float32 is 0.
 *
 * The bounds are float32's because squares of what lies between them are still double. */
bool decimal_parse(const char *text, size_t length, double *value);

#endif
