/* SPDX-License-Identifier: MIT
 *
 * Pictures of closed scenes against the reference, in compare.h's terms, for every profile. Profile draft
 * rounds corners to whole pixels: whatever is a pixel wide may vanish and show what is behind it, which
 * is no hole in any surface. Of draft only background counts, as none is to be seen in a closed scene. */
#ifndef TESTS_HOLES_H
#define TESTS_HOLES_H

#include "accuracy/reference.h"
#include "core/core.h"

struct holes {
    size_t pixels, frames;
    size_t wrong;     /* another face than the reference's */
    size_t misplaced; /* wrong, and the face is to be seen nowhere within a pixel, between pixels neither */
    size_t holes;     /* misplaced, and background, or, where there are sub-pixels, farther than all around */
};

/* Adds a frame. Farther means by more than 8 grid units and 0.1 %. */
void holes_add(struct holes *holes, const struct core *profile, const uint32_t *rendered,
               const struct reference *reference, double unit_m);

double holes_wrong_percent(const struct holes *holes);

#endif
