/* SPDX-License-Identifier: MIT
 *
 * Lambert's cosine, stretched over the whole half-turn ("half Lambert"), so that no two directions
 * that differ look alike, not even in the shade. */
#include "model/baked_light.h"

#include "base/vec3.h"

#include <math.h>

static const double TO_LAMP[3] = {-0.4, 0.8, 0.45}; /* any length */
static const double MIDDLE = 0.62, SWING = 0.38;    /* brightness: MIDDLE + SWING * cosine */

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

static double brightness(const double normal[3])
{
    const double length = sqrt(vec3_dot(normal, normal) * vec3_dot(TO_LAMP, TO_LAMP));
    return length > 0 ? MIDDLE + SWING * vec3_dot(normal, TO_LAMP) / length : MIDDLE;
}

static uint32_t dimmed(uint32_t colour, double by)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out = out << 8 | (uint32_t)((colour >> shift & 0xFF) * by + 0.5);
    return out;
}

void light_bake(struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face *face = &model->faces[i];
        double normal[3];
        if (face->unlit) continue;
        normal_of(model, face, normal);
        face->colour = dimmed(face->colour, brightness(normal));
    }
}

struct lim_light light_lamp(void)
{
    const double length = sqrt(vec3_dot(TO_LAMP, TO_LAMP));
    struct lim_light light = {
        .on = true, .middle_q8 = (uint8_t)lround(MIDDLE * 256), .swing_q8 = (uint8_t)lround(SWING * 256)};
    for (int i = 0; i < 3; i++)
        light.to_q14[i] = (int16_t)lround(TO_LAMP[i] / length * 16384);
    return light;
}
