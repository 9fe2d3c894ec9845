/* SPDX-License-Identifier: MIT
 *
 * Two renderers of one scene on targets of two kinds, for tests that find the same picture on both. */
#ifndef TESTS_RENDERER_PAIR_H
#define TESTS_RENDERER_PAIR_H

#include "limner.h"

struct renderer_pair {
    struct lim lim[2];
    void *mem[2];
};

/* Starts the i-th with what its target asks for, or the least. What the renderer does not set itself is no use to it.
 * A failure ends the test. */
void renderer_pair_start(struct renderer_pair *pair, int i, const struct lim_scene *scene,
                         const struct lim_target *target, bool least);
void renderer_pair_end(struct renderer_pair *pair);

/* What round glass shows of a line: less, the farther it is from the middle. */
void renderer_pair_round(uint16_t w_px, uint16_t h_px, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px);

#endif
