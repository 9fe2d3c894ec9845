/* SPDX-License-Identifier: MIT
 *
 * A histogram of the brightness of all that the model shows, by area, finds what is to be white. A picture counts as
 * often as the faces that show it are large, with all of its texels. */
#include "model/mono_tones.h"

#include "base/vec3.h"
#include "model/srgb.h"

#include <math.h>
#include <string.h>

enum { LEVELS = 256, DARKEST = 85, LEAST_WHITE = 32 };
static const double WHITE_SHARE = 0.05;

struct histogram {
    double area[LEVELS];
};

/* As hal/pixels.c weighs them. */
static unsigned brightness(uint32_t rgb)
{
    return ((rgb >> 16 & 0xFF) * 299 + (rgb >> 8 & 0xFF) * 587 + (rgb & 0xFF) * 114 + 500) / 1000;
}

/* A fan's triangles: of a polygon that is not convex more than its own, which weighs it a little more. */
static double area_of(const struct model *model, const struct model_face *face)
{
    const uint32_t *corners = &model->corners[face->first];
    double sum = 0;
    for (uint32_t k = 2; k < face->count; k++) {
        double a[3], b[3], across[3];
        for (int i = 0; i < 3; i++) {
            a[i] = model->points[corners[k - 1]][i] - model->points[corners[0]][i];
            b[i] = model->points[corners[k]][i] - model->points[corners[0]][i];
        }
        for (int i = 0; i < 3; i++)
            across[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        sum += sqrt(vec3_dot(across, across)) / 2;
    }
    return isfinite(sum) ? sum : 0;
}

static const struct picture *picture_of(const struct model *model, const struct model_face *face)
{
    const struct picture *picture = face->picture ? &model->pictures[face->picture - 1] : NULL;
    return picture && picture->pixels && model->uvs ? picture : NULL;
}

static void count_picture(struct histogram *histogram, const struct picture *picture, double area)
{
    const size_t texels = (size_t)picture->w_px * picture->h_px;
    for (size_t i = 0; i < texels; i++)
        histogram->area[brightness(picture->pixels[i])] += area / (double)texels;
}

static void count_all(struct histogram *histogram, const struct model *model)
{
    for (size_t p = 0; p < model->picture_count; p++) {
        double area = 0;
        for (size_t i = 0; i < model->face_count; i++)
            if (picture_of(model, &model->faces[i]) == &model->pictures[p]) area += area_of(model, &model->faces[i]);
        if (area > 0) count_picture(histogram, &model->pictures[p], area);
    }
    for (size_t i = 0; i < model->face_count; i++)
        if (!picture_of(model, &model->faces[i]))
            histogram->area[brightness(srgb_sum(model->faces[i].colour, model->faces[i].emission))] +=
                area_of(model, &model->faces[i]);
}

/* The level that no more than the share exceeds. Where nearly all is black its noise stays black. */
static unsigned white_level(const struct histogram *histogram)
{
    double all = 0, above = 0;
    for (unsigned level = 0; level < LEVELS; level++)
        all += histogram->area[level];
    for (unsigned level = LEVELS; level-- > 0;) {
        above += histogram->area[level];
        if (level <= LEAST_WHITE || above > WHITE_SHARE * all) return level;
    }
    return LEAST_WHITE;
}

static uint32_t toned(uint32_t rgb, unsigned white)
{
    const unsigned level = brightness(rgb), share = level < white ? level : white;
    const unsigned tone = DARKEST + ((LEVELS - 1 - DARKEST) * share + white / 2) / white;
    return tone << 16 | tone << 8 | tone;
}

/* A face's colour tints its picture, which has the tones then: what is left of it is how dark the tint is. */
static uint32_t tint(uint32_t rgb)
{
    const unsigned level = brightness(rgb);
    return level << 16 | level << 8 | level;
}

void mono_tones(struct model *model)
{
    struct histogram histogram;
    memset(&histogram, 0, sizeof histogram);
    count_all(&histogram, model);
    const unsigned white = white_level(&histogram);
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face *face = &model->faces[i];
        face->unlit |= face->emission != 0; /* what glows has no dark side */
        face->colour = srgb_sum(face->colour, face->emission);
        face->emission = 0;
        face->colour = picture_of(model, face) ? tint(face->colour) : toned(face->colour, white);
    }
    for (size_t p = 0; p < model->picture_count; p++) {
        const struct picture *picture = &model->pictures[p];
        for (size_t i = 0; picture->pixels && i < (size_t)picture->w_px * picture->h_px; i++)
            picture->pixels[i] = toned(picture->pixels[i], white);
    }
}
