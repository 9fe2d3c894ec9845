/* SPDX-License-Identifier: MIT
 *
 * A target for tests of what happens before its pixels are sent: lines in RGB565 that never fail and go nowhere. */
#ifndef TESTS_PLAIN_LINES_H
#define TESTS_PLAIN_LINES_H

#include "limner.h"

#include <stddef.h>

struct plain_lines {
    uint16_t *pixels;
    size_t stride_px; /* from a line to the next; 0: there is one, for all */
};

/* Points to the lines, which must outlive it. */
struct lim_target plain_lines_target(struct plain_lines *lines, uint16_t w_px, uint16_t h_px, enum lim_method method);

#endif
