/* SPDX-License-Identifier: MIT
 *
 * Which texel each pixel of a frame shows, of whichever method: the frame is drawn with textures whose texels say where
 * they are, three times, as a texel has 8 bits. */
#ifndef SIM_PAINTED_TEXELS_H
#define SIM_PAINTED_TEXELS_H

#include "render/simulator.h"
#include "scene/compiled.h"

enum { PAINTED_PASSES = 3 };

struct painted_texel {
    uint16_t x, y; /* texels of the level, from the picture's corner */
    uint8_t level;
};

struct painted_texels {
    struct lim_scene scene; /* the same with other texels */
    struct lim_texture *textures;
    uint8_t *texels[PAINTED_PASSES];
    uint16_t palette[256]; /* colour k is the number k */
    struct simulator simulator;
    struct painted_texel *pixels; /* of the last frame; of a pixel without a texture it means nothing */
};

/* The scene has textures, and must outlive it. painted_texels_free() it either way. */
bool painted_texels_init(struct painted_texels *painted, const struct compiled *scene,
                         const struct simulator_setup *setup, struct error *err);
bool painted_texels_frame(struct painted_texels *painted, const struct lim_camera *camera, struct error *err);
void painted_texels_free(struct painted_texels *painted);

#endif
