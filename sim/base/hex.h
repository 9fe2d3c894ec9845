/* SPDX-License-Identifier: MIT
 *
 * Hexadecimal numbers out of long texts, quickly. */
#ifndef SIM_HEX_H
#define SIM_HEX_H

#include <stdint.h>

/* A digit's value; -1: it is none. */
static inline int hex_digit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* Behind the number's last digit, at most 16 of them; `text` itself: there is none. */
static inline const char *hex_number(const char *text, uint64_t *number)
{
    *number = 0;
    for (int i = 0; i < 16 && hex_digit(*text) >= 0; i++)
        *number = *number << 4 | (uint64_t)hex_digit(*text++);
    return text;
}

#endif
