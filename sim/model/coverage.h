/* SPDX-License-Identifier: MIT
 *
 * Which texels of a masked texture's level are clear: as many as are in the picture, so that bars get neither thicker
 * nor thinner with distance. */
#ifndef SIM_COVERAGE_H
#define SIM_COVERAGE_H

#include <stdbool.h>

/* Opacities 0..1, a row after the other, of which each takes row_px. */
struct coverage {
    double *opacity;
    int w_px, h_px, row_px;
};

/* Opacities become 1 for the share of texels, rounded, that are the most opaque, else 0. Of equal ones those of a fixed
 * pattern, which is as even as an ordered dither. false: out of memory. */
bool coverage_keep(const struct coverage *coverage, double share);

#endif
