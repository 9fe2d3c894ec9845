/* SPDX-License-Identifier: MIT
 *
 * A directional light for movers: each polygon has one brightness, middle + swing * cosine of the angle between its
 * normal and the light. What stands still has its light baked into its colours. */
#ifndef LIM_LIGHT_H
#define LIM_LIGHT_H

#include "config.h"

LIM_C_BEGIN

struct lim;

struct lim_light {
    bool on;                     /* else movers show the colours that they were compiled with */
    int16_t to_q14[3];           /* towards the light, in the static scene's axes, of length 1 */
    uint8_t middle_q8, swing_q8; /* middle + swing is 256 at most, so that nothing gets brighter than its colour */
};

/* From the next frame on; after lim_movers_init(). */
void lim_light_set(struct lim *lim, const struct lim_light *light);

/* The colour (RGB565 as a number) of a face with this normal, of any length but 0, in the axes that `to_q14` is in. */
uint16_t lim_light_shade(const struct lim_light *light, const int16_t to_q14[3], const int32_t normal[3],
                         uint16_t rgb565);

LIM_C_END

#endif
