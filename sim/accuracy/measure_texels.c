/* SPDX-License-Identifier: MIT
 *
 * The renderer says which texel it shows at each pixel of a record; where that pixel really is the record's, it
 * counts. Textures repeat, so a distance is never more than half a side. */
#include "accuracy/measure_texels.h"

#include "core/core.h"
#include "model/mapping.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>

struct taking {
    struct texel_errors *errors;
    const struct texel_frame *frame;
    size_t number; /* of the record, from 1: what its pixels hold */
};

static double apart(double a, double b)
{
    return a - b - floor(a - b + 0.5);
}

static void note(struct texel_errors *errors, double texels, unsigned level)
{
    const double bin = floor(texels * TEXEL_BINS_A_TEXEL);
    errors->pixels++;
    errors->sum += texels;
    errors->sum_finest += ldexp(texels, (int)level);
    errors->max = fmax(errors->max, texels);
    errors->bins[bin < TEXEL_BINS - 1 ? (size_t)bin : TEXEL_BINS - 1]++;
}

static void take(void *ctx, const struct core_texel_at *at)
{
    const struct taking *taking = ctx;
    const struct texel_frame *frame = taking->frame;
    const struct reference *reference = frame->reference;
    const size_t pixel = (size_t)at->y_px * reference->w_px + at->x_px;
    const uint32_t number = reference->mappings[pixel], seen = reference->faces[pixel];
    if (frame->ids->numbers[pixel] != taking->number || !number) return;
    if (frame->groups[seen] != frame->groups[frame->scene->faces[taking->number - 1]]) return;
    const struct mapping *mapping = &frame->mesh->mappings[number];
    const struct texture *texture = &frame->mesh->textures[mapping->texture];
    double point_m[3], uv[2], way[2];
    reference_point(reference, pixel, point_m);
    mapping_at(mapping, point_m, uv);
    for (int i = 0; i < 2; i++) {
        const double side = ldexp(1, (i ? texture->h_bits : texture->w_bits) - (int)at->level);
        way[i] = side * apart(at->uv[i], uv[i]);
    }
    note(taking->errors, hypot(way[0], way[1]), at->level);
}

bool texel_errors_add(struct texel_errors *errors, const struct texel_frame *frame, struct error *err)
{
    const struct lim_scene *scene = &frame->scene->scene;
    if (!errors->bins) errors->bins = calloc(TEXEL_BINS, sizeof *errors->bins);
    if (!errors->bins) return error_set(err, "texels: out of memory");
    errors->divisions += simulator_stats(frame->painted)->divisions;
    for (size_t i = 0; i < scene->polygon_count; i++) {
        struct taking taking = {errors, frame, i + 1};
        const lim_index word = (lim_index)frame->record_words[i];
        if (record_at(scene, word).flags & LIM_POLYGON_TEXTURE)
            frame->core->texels(frame->painted->lim, word, take, &taking);
    }
    return true;
}

double texel_errors_mean(const struct texel_errors *errors)
{
    return errors->pixels ? errors->sum / (double)errors->pixels : 0;
}

double texel_errors_p99(const struct texel_errors *errors)
{
    size_t left = errors->pixels - errors->pixels / 100, bin = 0;
    while (errors->bins && bin + 1 < TEXEL_BINS && errors->bins[bin] < left)
        left -= errors->bins[bin++];
    return (double)(bin + 1) / TEXEL_BINS_A_TEXEL;
}

void texel_errors_free(struct texel_errors *errors)
{
    free(errors->bins);
    *errors = (struct texel_errors){0};
}
