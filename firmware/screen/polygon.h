/* SPDX-License-Identifier: MIT
 *
 * A polygon on the screen, struct lim_screen_polygon: what it may have, asked for without a question of whether that is
 * linked. */
#ifndef LIM_POLYGON_H
#define LIM_POLYGON_H

#include "colour.h"
#include "stages.h"

static inline uint8_t lim_alpha_of(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_TRANSPARENT ? *polygon->alpha : (uint8_t)LIM_OPAQUE;
}

/* NULL: there are none. */
static inline const uint16_t *lim_hidden_of(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_WIREFRAME ? polygon->hidden : NULL;
}

static inline uint16_t lim_screen_texture(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_TEXTURE ? *polygon->texture : (uint16_t)LIM_NONE;
}

static inline void lim_set_antialiased(struct lim_screen_polygon *out, bool antialiased)
{
    if (LIM_HAS_ANTIALIAS) *out->antialiased = antialiased;
}

static inline bool lim_is_polygon_antialiased(const struct lim_screen_polygon *polygon)
{
    return LIM_HAS_ANTIALIAS && *polygon->antialiased;
}

static inline void lim_set_alpha(struct lim_screen_polygon *out, uint8_t alpha)
{
    if (LIM_HAS_TRANSPARENT) *out->alpha = alpha;
}

#endif
