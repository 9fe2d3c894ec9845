/* SPDX-License-Identifier: MIT
 *
 * The share of wrong pixels to expect of a scene, found by trying: sampled cameras, drawn by the
 * renderer and by the reference. */
#ifndef SIM_PREDICT_H
#define SIM_PREDICT_H

#include "compiled.h"
#include "core.h"
#include "reference.h"

enum { PREDICT_SIDE_PX = 240, PREDICT_CAMERAS = 24 };

/* `reference` holds the source polygons for pictures of PREDICT_SIDE_PX; `groups` as in compare.h. */
bool predict_wrong_percent(const struct compiled *scene, const struct core *core, struct reference *reference,
                           const uint32_t *groups, double *percent, struct error *err);

#endif
