/* SPDX-License-Identifier: MIT
 *
 * How far texels are from where the ray through the pixel's centre meets the model's own face, in double precision. */
#ifndef SIM_MEASURE_TEXELS_H
#define SIM_MEASURE_TEXELS_H

#include "accuracy/painted_texels.h"
#include "accuracy/reference.h"
#include "core/core.h"
#include "render/ids.h"

enum { TEXEL_BINS_A_TEXEL = 256, TEXEL_BINS = 256 * TEXEL_BINS_A_TEXEL };

/* Distances of all pixels, in texels. */
struct texel_errors {
    size_t pixels, divisions; /* divisions: of all frames, for the perspective */
    double sum, sum2, max;    /* in texels of the level painted */
    double straight_sum2;     /* of sum2, what is left if each straight piece of a line were the best that there is */
    double sum_finest;        /* in texels of the whole picture */
    uint32_t *bins;           /* of the former; the last one holds what is larger; owned, NULL: none yet */
    /* Of what is painted, by any method: how far true places lie from the texels painted; those that lie farther than
     * the texel next to it; those painted at another level of detail than the nearest. */
    size_t painted, far, other_level;
    double painted_sum2;
};

/* What of a frame is measured. */
struct texel_frame {
    const struct core *core;
    const struct compiled *scene;
    const struct ids *ids;               /* the frame, as record numbers */
    struct simulator *painted;           /* the same frame, with its textures */
    const struct painted_texels *texels; /* the same */
    const struct reference *reference;   /* the same */
    const struct mesh *mesh;             /* whose mappings the reference names */
    const uint32_t *groups;              /* mesh.merged_into */
    const size_t *record_words;
};

/* Adds a frame: pixels where the renderer shows a textured face that the reference shows, too. */
bool texel_errors_add(struct texel_errors *errors, const struct texel_frame *frame, struct error *err);

/* Of places, where they are known, or else of texels painted: root of the mean square, texels of the level painted. */
double texel_errors_rms(const struct texel_errors *errors);

double texel_errors_mean(const struct texel_errors *errors);
double texel_errors_p99(const struct texel_errors *errors);
void texel_errors_free(struct texel_errors *errors);

#endif
