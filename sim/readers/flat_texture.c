/* SPDX-License-Identifier: MIT */
#include "readers/flat_texture.h"

#include "base/rgb888.h"
#include "model/face_mean.h"
#include "model/face_texels.h"

#include <math.h>

enum { INVISIBLE = 255 };

struct only {
    uint32_t texel;
    bool is_set, differs;
};

static bool is_same(uint32_t texel, double part, void *user)
{
    struct only *only = user;
    (void)part;
    only->differs = only->is_set && texel != only->texel;
    only->texel = texel;
    only->is_set = true;
    return !only->differs;
}

/* As picture_transparency() has it. */
static uint8_t transparency_of(double clear_share)
{
    if (clear_share <= 0 || clear_share >= 1) return clear_share > 0 ? INVISIBLE : 0;
    return (uint8_t)fmin(fmax(INVISIBLE * clear_share + 0.5, 1), INVISIBLE - 1);
}

/* A face whose material is glass has another transparency than its picture. */
static void lose_picture(struct model_face *face, struct picture *picture, uint32_t colour, double clear_share)
{
    face->colour = rgb888_times(colour, face->colour);
    if (picture->is_masked && face->transparency == picture_transparency(picture))
        face->transparency = transparency_of(clear_share);
    face->picture = 0;
    picture->faces--;
}

static struct picture *picture_of(struct model *model, const struct model_face *face)
{
    struct picture *picture = face->picture ? &model->pictures[face->picture - 1] : NULL;
    return picture && picture->pixels ? picture : NULL;
}

size_t flat_texture_find(struct model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->face_count && model->uvs; i++) {
        struct model_face *face = &model->faces[i];
        struct picture *picture = picture_of(model, face);
        struct only only = {0};
        if (!picture || picture->sky.times) continue;
        if (!face_texels_visit(model, face, picture, TEXELS_ALL, is_same, &only)) continue;
        if (!only.is_set || only.differs) continue;
        lose_picture(face, picture, only.texel, only.texel & PICTURE_CLEAR ? 1 : 0);
        count++;
    }
    return count;
}

bool flat_texture_take_mean(struct model *model, struct model_face *face)
{
    struct picture *picture = picture_of(model, face);
    struct face_mean mean;
    if (!picture || !face_mean_of(model, face, picture, &mean)) return false;
    lose_picture(face, picture, mean.colour, mean.clear_share);
    return true;
}

size_t flat_texture_take_means(struct model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->face_count; i++)
        count += flat_texture_take_mean(model, &model->faces[i]);
    return count;
}
