/* SPDX-License-Identifier: MIT */
#include "model/face_mean.h"

#include "model/face_texels.h"

#include <math.h>

enum { CHANNELS = 3 };

struct sums {
    double opaque, clear; /* parts of texels */
    double sum[CHANNELS], squares;
};

static bool add(uint32_t texel, double part, void *user)
{
    struct sums *sums = user;
    if (texel & PICTURE_CLEAR) {
        sums->clear += part;
        return true;
    }
    sums->opaque += part;
    for (int i = 0; i < CHANNELS; i++) {
        const double value = texel >> 8 * i & 0xFF;
        sums->sum[i] += part * value;
        sums->squares += part * value * value;
    }
    return true;
}

static void add_all(const struct picture *picture, struct sums *sums)
{
    for (size_t i = 0; i < (size_t)picture->w_px * picture->h_px; i++)
        add(picture->pixels[i], 1, sums);
}

static bool has_coordinates(const struct model *model, const struct model_face *face)
{
    for (uint32_t k = 0; model->uvs && k < face->count; k++) {
        const double *uv = model->uvs[model->corners[face->first + k]];
        if (!isfinite(uv[0]) || !isfinite(uv[1])) return false;
    }
    return model->uvs != NULL;
}

static void set_mean(const struct sums *sums, struct face_mean *out)
{
    *out = (struct face_mean){.clear_share = sums->clear > 0 ? sums->clear / (sums->clear + sums->opaque) : 0};
    if (!(sums->opaque > 0)) return;
    out->error = sums->squares / sums->opaque;
    for (int i = 0; i < CHANNELS; i++) {
        const double value = sums->sum[i] / sums->opaque;
        out->colour |= (uint32_t)(value + 0.5) << 8 * i;
        out->error -= value * value;
    }
}

bool face_mean_of(const struct model *model, const struct model_face *face, const struct picture *picture,
                  struct face_mean *out)
{
    const bool is_sky = picture->sky.times > 0;
    struct sums sums = {0};
    if (!is_sky && !has_coordinates(model, face)) return false;
    if (is_sky || !face_texels_visit(model, face, picture, TEXELS_SAMPLED, add, &sums)) add_all(picture, &sums);
    set_mean(&sums, out);
    return true;
}
