/* SPDX-License-Identifier: MIT
 *
 * Two points of a face: one to stand over, one to look towards. */
#include "cameras/grazing.h"

#include "base/vec3.h"
#include "model/original.h"

#include <math.h>

enum { TRIES = 1000, APART_UNITS = 16 };
static const double HIGHEST = 0.5, LOWEST = 0.02; /* in widths of the face */
static const double BESIDE = 0.65;                /* the share of eyes that stand beside the face, not over it */

static const double *corner_m(const struct original *original, const struct original_face *face, size_t i)
{
    return original->corners_m[face->first + i];
}

/* Of triangle i of the face's fan, twice its area; seen against the face's normal, for corners that turn inwards. */
static double fan_area(const struct original *original, const struct original_face *face, size_t i)
{
    const double *a = corner_m(original, face, 0), *b = corner_m(original, face, i + 1),
                 *c = corner_m(original, face, i + 2);
    double ab[3], ac[3], across[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = b[k] - a[k];
        ac[k] = c[k] - a[k];
    }
    for (int k = 0; k < 3; k++) {
        const int p = (k + 1) % 3, q = (k + 2) % 3;
        across[k] = ab[p] * ac[q] - ab[q] * ac[p];
    }
    return fabs(vec3_dot(across, face->normal));
}

static double face_area(const struct original *original, const struct original_face *face)
{
    double area = 0.0;
    for (size_t i = 0; i + 2 < face->count; i++)
        area += fan_area(original, face, i);
    return area;
}

static const struct original_face *face_by_area(struct sampler *sampler, const struct original *original)
{
    const struct original_face *last = NULL;
    double all = 0.0;
    for (size_t i = 0; i < original->face_count; i++)
        all += face_area(original, &original->faces[i]);
    double left = sampler_unit(sampler) * all;
    for (size_t i = 0; i < original->face_count; i++) {
        const struct original_face *face = &original->faces[i];
        if (!face->count) continue;
        last = face;
        left -= face_area(original, face);
        if (left < 0.0) break;
    }
    return last;
}

static void point_of(struct sampler *sampler, const struct original *original, const struct original_face *face,
                     double out_m[3])
{
    double left = sampler_unit(sampler) * face_area(original, face);
    size_t i = 0;
    while (i + 3 < face->count && (left -= fan_area(original, face, i)) >= 0.0)
        i++;
    double u = sampler_unit(sampler), v = sampler_unit(sampler);
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    const double *a = corner_m(original, face, 0), *b = corner_m(original, face, i + 1),
                 *c = corner_m(original, face, i + 2);
    for (int k = 0; k < 3; k++)
        out_m[k] = a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]);
}

/* As far from the scene as eyes of sampler_anywhere() are, at most. */
static bool is_around(const struct sampler *sampler, const double eye_m[3])
{
    double longest_m = 0.0;
    for (int i = 0; i < 3; i++)
        longest_m = fmax(longest_m, sampler->high_m[i] - sampler->low_m[i]);
    for (int i = 0; i < 3; i++)
        if (fabs(eye_m[i] - (sampler->low_m[i] + sampler->high_m[i]) / 2.0) > sampler_reach_m(sampler, longest_m))
            return false;
    return true;
}

/* An eye over one point, or beyond it, and a target between what is level and the other point. */
static double look_along(struct sampler *sampler, const struct original *original, const struct original_face *face,
                         struct viewpoint *out)
{
    const double least_m = fmax(2.0 * sampler->near_m, APART_UNITS / 256.0 / sampler->scene->grid.units_per_m);
    const double most_m = fmax(HIGHEST * face->width_m, least_m), low_m = fmax(LOWEST * face->width_m, least_m);
    const double height_m = low_m * pow(most_m / low_m, sampler_unit(sampler));
    const double beyond = sampler_unit(sampler) < BESIDE ? 1.5 * sampler_unit(sampler) : 0.0;
    const double down = sampler_unit(sampler);
    double from_m[3], to_m[3], square = 0.0;

    point_of(sampler, original, face, from_m);
    point_of(sampler, original, face, to_m);
    *out = (struct viewpoint){.line = 1};
    for (int k = 0; k < 3; k++) {
        out->eye_m[k] = from_m[k] + beyond * (from_m[k] - to_m[k]) + height_m * face->normal[k];
        out->target_m[k] = to_m[k] + (1.0 - down) * height_m * face->normal[k];
        square += (out->target_m[k] - out->eye_m[k]) * (out->target_m[k] - out->eye_m[k]);
    }
    return sqrt(square);
}

bool sampler_grazing(struct sampler *sampler, struct viewpoint *out)
{
    const struct original *original = sampler->scene->original;
    if (!original || !original->seen_count) return false;
    for (int i = 0; i < TRIES; i++) {
        const struct original_face *face = face_by_area(sampler, original);
        const double away_m = look_along(sampler, original, face, out);
        if (away_m * sampler->scene->grid.units_per_m >= APART_UNITS && is_around(sampler, out->eye_m) &&
            sampler_may_be_at(sampler, out->eye_m))
            return true;
    }
    return false;
}
