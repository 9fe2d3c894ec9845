/* SPDX-License-Identifier: MIT
 *
 * Which textures get smaller, show another one, or become a colour, so that all of them take no more than a budget: the
 * step that loses least a byte, again and again. What is lost is measured: the squared error of all texels seen. */
#ifndef SIM_TEXTURE_PLAN_H
#define SIM_TEXTURE_PLAN_H

#include "accuracy/texels_seen.h"
#include "accuracy/texture_means.h"
#include "model/mesh.h"
#include "scene.h"

/* A side is not cut below so many texels. What is near enough to another texture, or to one colour, by the root of the
 * mean square of a channel's error, of 255, may be shown as that. */
enum { TEXTURE_LEAST_BITS = 3 };
#define TEXTURE_NEAR_RMS 10.0

/* What becomes of one texture of a mesh. */
struct texture_step {
    uint32_t shows; /* this one; itself, unless it is merged */
    uint8_t cut;    /* levels less, of the one that is shown */
    bool is_flat;   /* its mean colour is shown */
    bool has_means; /* each face has the mean colour of what it shows of it */
    double rms;     /* error of a channel, of 255, over the texels seen */
};

struct texture_plan {
    struct texture_step *steps; /* one a texture of the mesh */
    size_t before_b, after_b;   /* an upper bound of what all take */
    double rms;                 /* of all texels seen */
};

/* Bytes of textures in flash: texels, palettes, and their structs. */
size_t texture_plan_bytes(const struct mesh *mesh);

/* Bytes that a colour takes in a mesh, where faces without a texture are among others. */
enum { TEXTURE_COLOUR_B = sizeof(struct lim_texture) + sizeof(uint16_t) };

/* `means`: what it is for faces to have their mean colours, one a texture, which is done where nothing else is left:
 * then any budget can be met. NULL: it is not done. `colour_b`: bytes that each colour of them takes. false: the budget
 * cannot be met, and plan->after_b is the least. texture_plan_free() it either way. */
bool texture_plan_make(const struct mesh *mesh, const struct texels_seen *seen, const struct texture_mean *means,
                       size_t colour_b, size_t budget_b, struct texture_plan *plan);
void texture_plan_free(struct texture_plan *plan);

#endif
