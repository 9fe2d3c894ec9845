/* SPDX-License-Identifier: MIT */
#include "accuracy/texture_means.h"

#include "base/grow.h"
#include "base/map.h"
#include "base/rgb565.h"
#include "base/rgb888.h"
#include "model/face_mean.h"

static struct texture_mean mean_of_picture(const struct model *model, uint32_t number)
{
    const struct picture *picture = &model->pictures[number - 1];
    struct texture_mean out = {0};
    struct map colours = {0};
    double faces = 0;
    for (size_t i = 0; i < model->face_count && picture->pixels; i++) {
        const struct model_face *face = &model->faces[i];
        struct face_mean mean;
        if (face->picture != number || !face_mean_of(model, face, picture, &mean)) continue;
        map_at(&colours, rgb565_nearest(rgb888_times(mean.colour, face->colour)), 0);
        out.error += mean.error;
        faces++;
    }
    if (faces > 0) out.error /= faces;
    out.colours = colours.count;
    map_free(&colours);
    return out;
}

struct texture_mean *texture_means_make(const struct model *model)
{
    struct texture_mean *const means = grow_zeroed(model->picture_count, sizeof *means);
    for (uint32_t i = 0; i < model->picture_count; i++)
        means[i] = mean_of_picture(model, i + 1);
    return means;
}
