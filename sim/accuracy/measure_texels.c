/* SPDX-License-Identifier: MIT
 *
 * Of trees the renderer says which place it shows at each pixel of a record, and of any method the frame which texel;
 * where that pixel really is the record's, it counts. Textures repeat, so a distance is never more than half a side. */
#include "accuracy/measure_texels.h"

#include "accuracy/straight_run.h"
#include "accuracy/texels_seen.h"
#include "base/vec3.h"
#include "core/core.h"
#include "model/mapping.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>

struct taking {
    struct texel_errors *errors;
    const struct texel_frame *frame;
    size_t number; /* of the record, from 1: what its pixels hold */
    struct straight_run *run;
};

/* What the reference sees at a pixel of a record's face; NULL: another face, no texture, or a sky, which lies on no
 * face. */
static const struct mapping *mapping_at_pixel(const struct texel_frame *frame, size_t number, size_t pixel)
{
    const struct reference *reference = frame->reference;
    const uint32_t mapping = reference->mappings ? reference->mappings[pixel] : 0, seen = reference->faces[pixel];
    if (!number || frame->ids->numbers[pixel] != number || !mapping) return NULL;
    if (number > frame->scene->scene.polygon_count) return NULL; /* something that moves */
    if (frame->groups[seen] != frame->groups[frame->scene->faces[number - 1]]) return NULL;
    const struct mapping *shown = &frame->mesh->mappings[mapping];
    return frame->mesh->textures[shown->texture].sky.times ? NULL : shown;
}

static void true_place(const struct texel_frame *frame, const struct mapping *mapping, size_t pixel, double uv[2])
{
    double point_m[3];
    reference_point(frame->reference, pixel, point_m);
    mapping_at(mapping, point_m, uv);
}

static double side_of(const struct texture *texture, int axis, unsigned level)
{
    return ldexp(1, (axis ? texture->h_bits : texture->w_bits) - (int)level);
}

static double apart(double a, double b)
{
    return a - b - floor(a - b + 0.5);
}

static void note(struct texel_errors *errors, double texels, unsigned level)
{
    const double bin = floor(texels * TEXEL_BINS_A_TEXEL);
    errors->pixels++;
    errors->sum += texels;
    errors->sum2 += texels * texels;
    errors->sum_finest += ldexp(texels, (int)level);
    errors->max = fmax(errors->max, texels);
    errors->bins[bin < TEXEL_BINS - 1 ? (size_t)bin : TEXEL_BINS - 1]++;
}

static void take(void *ctx, const struct core_texel_at *at)
{
    const struct taking *taking = ctx;
    const struct texel_frame *frame = taking->frame;
    const size_t pixel = (size_t)at->y_px * frame->reference->w_px + at->x_px;
    const struct mapping *mapping = mapping_at_pixel(frame, taking->number, pixel);
    if (!mapping) return;
    const struct texture *texture = &frame->mesh->textures[mapping->texture];
    double uv[2], way[2], texels[2];
    true_place(frame, mapping, pixel, uv);
    for (int i = 0; i < 2; i++) {
        const double side = side_of(texture, i, at->level);
        way[i] = side * apart(at->uv[i], uv[i]);
        texels[i] = side * at->uv[i];
    }
    note(taking->errors, hypot(way[0], way[1]), at->level);
    const struct straight_pixel here = {.x_px = at->x_px,
                                        .y_px = at->y_px,
                                        .level = at->level,
                                        .begins = at->divided,
                                        .texels = {texels[0], texels[1]},
                                        .way = {way[0], way[1]},
                                        .sides = {side_of(texture, 0, at->level), side_of(texture, 1, at->level)}};
    taking->errors->straight_sum2 += straight_run_add(taking->run, &here);
}

/* Of a frame's texels -------------------------------------------------------------------------- */

static void add_painted(struct texel_errors *errors, const struct texel_frame *frame, size_t pixel, double pixel_area)
{
    const struct mapping *mapping = mapping_at_pixel(frame, frame->ids->numbers[pixel], pixel);
    if (!mapping) return;
    const struct texture *texture = &frame->mesh->textures[mapping->texture];
    const struct painted_texel *shown = &frame->texels->pixels[pixel];
    const double level = floor(texel_level_at(frame->reference, pixel, mapping, texture, pixel_area) + 0.5);
    double uv[2], out[2];
    if (texture->is_masked || shown->level >= texture->levels) return; /* texels 0 say nothing: they are holes */
    true_place(frame, mapping, pixel, uv);
    for (int i = 0; i < 2; i++) {
        const double side = side_of(texture, i, shown->level), middle = ((i ? shown->y : shown->x) + 0.5) / side;
        out[i] = fmax(0, side * fabs(apart(uv[i], middle)) - 0.5);
    }
    errors->painted++;
    errors->painted_sum2 += out[0] * out[0] + out[1] * out[1];
    errors->far += fmax(out[0], out[1]) > 1;
    errors->other_level += shown->level != fmax(0, fmin(level, texture->levels - 1));
}

static double pixel_area_of(const struct reference_view *view)
{
    return 4 * sqrt(vec3_dot(view->right, view->right) * vec3_dot(view->up, view->up)) / view->w_px / view->h_px;
}

bool texel_errors_add(struct texel_errors *errors, const struct texel_frame *frame, struct error *err)
{
    const struct lim_scene *scene = &frame->scene->scene;
    if (!errors->bins) errors->bins = calloc(TEXEL_BINS, sizeof *errors->bins);
    if (!errors->bins) return error_set(err, "texels: out of memory");
    errors->divisions += simulator_stats(frame->painted)->divisions;
    struct straight_run run = {.count = 0};
    for (size_t i = 0; i < scene->polygon_count; i++) {
        struct taking taking = {errors, frame, i + 1, &run};
        const lim_index word = (lim_index)frame->record_words[i];
        if (!(record_at(scene, word).flags & LIM_POLYGON_TEXTURE)) continue;
        frame->core->texels(frame->painted->lim, word, take, &taking);
        errors->straight_sum2 += straight_run_end(&run);
    }
    const double pixel_area = pixel_area_of(&frame->reference->view);
    for (size_t i = 0; i < (size_t)frame->reference->w_px * frame->reference->h_px; i++)
        add_painted(errors, frame, i, pixel_area);
    return true;
}

double texel_errors_rms(const struct texel_errors *errors)
{
    if (errors->pixels) return sqrt(errors->sum2 / (double)errors->pixels);
    return errors->painted ? sqrt(errors->painted_sum2 / (double)errors->painted) : 0;
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
