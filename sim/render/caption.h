/* SPDX-License-Identifier: MIT
 *
 * `limner render --overlay`: a line of text over the frames of a simulator, as firmware has it. White on black, in the
 * middle, an eighth of the height below the upper edge, where round glass shows something as well. */
#ifndef SIM_CAPTION_H
#define SIM_CAPTION_H

#include "overlay.h"
#include "render/simulator.h"

enum { CAPTION_MOST = 170, CAPTION_SHOWN_MOST = 8 * CAPTION_MOST };

/* Must not move while it is in use. */
struct caption {
    char text[CAPTION_SHOWN_MOST + 1]; /* of the frame to come */
    struct lim_overlay_box box;        /* text and a border */
    struct lim_overlay overlay;
};

/* Whether the text can be shown: of 1 to CAPTION_MOST characters, all of ASCII 32 to 126. */
bool caption_check(const char *text, struct error *err);

/* Lays a text over the frame to come, and those that follow; each # in it becomes `frame`. */
void caption_set(struct caption *caption, const char *text, size_t frame, struct simulator *simulator);

#endif
