/* SPDX-License-Identifier: MIT
 *
 * Lambert's cosine, stretched over the whole half-turn ("half Lambert"), so that no two directions
 * that differ look alike, not even in the shade. */
#include "model/baked_light.h"

#include "base/vec3.h"
#include "model/mono_tones.h"
#include "model/srgb.h"

#include <math.h>

struct lamp {
    double to[3];         /* any length */
    double middle, swing; /* brightness: middle + swing * cosine */
};

static const struct lamp USUAL = {{-0.4, 0.8, 0.45}, 0.62, 0.38};

/* Few of 64 shares of white pixels can be told apart: sides of a box that meet differ by a seventh at least. */
static const struct lamp MONO = {{-0.12, 0.85, 0.5}, 0.54, 0.46};

/* Newell's normal; not of unit length. */
static void normal_of(const struct model *model, const struct model_face *face, double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (uint32_t k = 0; k < face->count; k++) {
        const double *a = model->points[model->corners[face->first + k]];
        const double *b = model->points[model->corners[face->first + (k + 1) % face->count]];
        out[0] += (a[1] - b[1]) * (a[2] + b[2]);
        out[1] += (a[2] - b[2]) * (a[0] + b[0]);
        out[2] += (a[0] - b[0]) * (a[1] + b[1]);
    }
}

static double brightness(const struct lamp *lamp, const double normal[3])
{
    const double length = sqrt(vec3_dot(normal, normal) * vec3_dot(lamp->to, lamp->to));
    return length > 0 ? lamp->middle + lamp->swing * vec3_dot(normal, lamp->to) / length : lamp->middle;
}

static uint32_t dimmed(uint32_t colour, double by)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out = out << 8 | (uint32_t)((colour >> shift & 0xFF) * by + 0.5);
    return out;
}

static void add_emission(struct model_face *face)
{
    face->colour = srgb_sum(face->colour, face->emission);
    face->emission = 0;
}

static void bake(struct model *model, const struct lamp *lamp)
{
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face *face = &model->faces[i];
        double normal[3];
        normal_of(model, face, normal);
        if (!face->unlit) face->colour = dimmed(face->colour, brightness(lamp, normal));
        add_emission(face);
    }
}

void light_none(struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++)
        add_emission(&model->faces[i]);
}

void light_bake(struct model *model)
{
    bake(model, &USUAL);
}

void light_bake_mono(struct model *model)
{
    mono_tones(model);
    bake(model, &MONO);
}

static struct lim_light light_of(const struct lamp *lamp)
{
    const double length = sqrt(vec3_dot(lamp->to, lamp->to));
    struct lim_light light = {
        .on = true, .middle_q8 = (uint8_t)lround(lamp->middle * 256), .swing_q8 = (uint8_t)lround(lamp->swing * 256)};
    for (int i = 0; i < 3; i++)
        light.to_q14[i] = (int16_t)lround(lamp->to[i] / length * 16384);
    return light;
}

struct lim_light light_lamp(void)
{
    return light_of(&USUAL);
}

struct lim_light light_lamp_mono(void)
{
    return light_of(&MONO);
}
