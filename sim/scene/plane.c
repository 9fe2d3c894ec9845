/* SPDX-License-Identifier: MIT
 *
 * The choice of a stored plane. Candidates, cheapest first: an axis plane, an upright plane
 * (n[1] = 0), a small integer normal, and at last a LARGE one, which is always good enough.
 *
 * A small normal is a simultaneous approximation of the ideal direction by fractions with one
 * denominator m; the best m up to 2^14 or so is off by about m^-1.5, which moves the plane by a
 * few hundredths of a unit at the far end of the grid. */
#include "scene/plane.h"

#include "long.h"

#include <float.h>
#include <math.h>

enum { FILTER_MAX = 8191, LARGE_MAX = 1 << 30 };

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int longest_axis(const double v[3])
{
    int axis = fabs(v[1]) > fabs(v[0]) ? 1 : 0;
    return fabs(v[2]) > fabs(v[axis]) ? 2 : axis;
}

/* Half way between the extreme corners along n, which halves the largest error. */
static double middle(const struct plane_fit *fit, const double n[3])
{
    double low = DBL_MAX, high = -DBL_MAX;
    for (size_t i = 0; i < fit->corner_count; i++) {
        double along = dot(n, fit->corners[i]);
        low = fmin(low, along);
        high = fmax(high, along);
    }
    return low + (high - low) / 2.0;
}

static void plane_place(const struct plane_fit *fit, const double n[3], enum plane_kind kind, struct plane *out)
{
    for (int i = 0; i < 3; i++)
        out->n[i] = (int64_t)n[i];
    out->d = (int64_t)floor(middle(fit, n) + 0.5);
    out->kind = kind;
    out->length = sqrt(dot(n, n));
}

static int side_of(double distance, double tolerance)
{
    return (distance > tolerance) - (distance < -tolerance);
}

/* The plane that the stored one stands for, its normal turned to that one's side. */
struct ideal {
    const struct plane_fit *fit;
    double d, sign;
};

static double ideal_distance(const struct ideal *ideal, const double point[3])
{
    return (dot(ideal->fit->normal, point) - ideal->d) * ideal->sign;
}

/* No point leaves the ideal plane, and none changes sides. Where the whole block is far from both planes, its middle
 * tells. */
static bool block_keeps_sides(const struct ideal *ideal, const struct plane *plane, const struct point_block *block)
{
    const double tolerance = ideal->fit->tolerance_units, far = block->radius + tolerance;
    const double here = ideal_distance(ideal, block->centre), there = plane_distance(plane, block->centre);
    if ((here > far && there > far) || (here < -far && there < -far)) return true;
    for (size_t i = 0; i < block->count; i++) {
        const int wanted = side_of(ideal_distance(ideal, block->points[i]), tolerance);
        const int stored = side_of(plane_distance(plane, block->points[i]), tolerance);
        if (stored != wanted && stored != 0) return false;
    }
    return true;
}

static bool plane_good_enough(const struct plane_fit *fit, const struct plane *plane)
{
    for (size_t i = 0; i < fit->corner_count; i++)
        if (fabs(plane_distance(plane, fit->corners[i])) > fit->tolerance_units) return false;
    if (fit->tolerance_units == 0.0) return true; /* through all corners: it is the ideal plane */
    const double n[3] = {(double)plane->n[0], (double)plane->n[1], (double)plane->n[2]};
    double ideal_d = middle(fit, fit->normal), sign = dot(n, fit->normal) < 0.0 ? -1.0 : 1.0;
    const struct ideal ideal = {fit, ideal_d, sign};
    for (size_t i = 0; i < fit->blocks->count; i++)
        if (!block_keeps_sides(&ideal, plane, &fit->blocks->blocks[i])) return false;
    return true;
}

static bool try_axis(const struct plane_fit *fit, struct plane *out)
{
    int axis = longest_axis(fit->normal);
    double n[3] = {0.0, 0.0, 0.0};
    n[axis] = 1.0;
    plane_place(fit, n, (enum plane_kind)(PLANE_X + axis), out);
    return plane_good_enough(fit, out);
}

/* Whether a component times m is farther from a whole number than `most`; when in doubt, it is not. */
static bool is_far_from_whole(double component, double most)
{
    const double size = fabs(component);
    return fabs(size - (double)(int64_t)(size + 0.5)) > most + 1e-9;
}

/* How far normal * m is from its rounding n, relative to m. */
static double rounding_error(const double normal[3], double m, double n[3])
{
    double worst = 0.0;
    for (int i = 0; i < 3; i++) {
        n[i] = floor(normal[i] * m + 0.5);
        worst = fmax(worst, fabs(normal[i] * m - n[i]));
    }
    return worst / m;
}

/* The integer normal within SMALL's bound that is nearest to a direction whose longest component
 * is 1. Only a halved error is worth longer integers: that keeps (1, 0, 1) from becoming
 * (5000, 0, 5000) by the noise of doubles. Rounding adds less than 2 to the sum: with it |d| <= 32766 * 32767.5, which
 * is within LIM_PLANE_D_MAX. */
static void small_normal(const double direction[3], double best[3])
{
    double best_error = DBL_MAX, n[3];
    double sum = fabs(direction[0]) + fabs(direction[1]) + fabs(direction[2]);
    for (double m = 1.0; m * sum <= PLANE_SUM_MAX - 2.0 && best_error > DBL_EPSILON; m += 1.0) {
        const double most = best_error * m / 2.0;
        if (is_far_from_whole(direction[0] * m, most) || is_far_from_whole(direction[1] * m, most) ||
            is_far_from_whole(direction[2] * m, most))
            continue;
        double error = rounding_error(direction, m, n);
        if (error >= best_error / 2.0) continue;
        best_error = error;
        for (int i = 0; i < 3; i++)
            best[i] = n[i];
    }
}

/* small_normal() ends within 1 / SHORTEST of its direction, in each component: where corners spread too far along that
 * for any such normal, there is no need to search. */
static bool may_hold_corners(const struct plane_fit *fit, const double direction[3])
{
    const double SHORTEST = (PLANE_SUM_MAX - 2) / 3.0 - 1.0;
    double low = DBL_MAX, high = -DBL_MAX, extent = 0.0;
    for (size_t i = 0; i < fit->corner_count; i++) {
        const double along = dot(direction, fit->corners[i]);
        low = fmin(low, along);
        high = fmax(high, along);
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, fabs(fit->corners[i][k] - fit->corners[0][k]));
    }
    const double length = sqrt(dot(direction, direction));
    return high - low <= 2.0 * fit->tolerance_units * (length + 0.01) + 6.0 * extent / SHORTEST + 1e-6;
}

static bool try_small(const struct plane_fit *fit, bool upright, struct plane *out)
{
    double direction[3] = {fit->normal[0], upright ? 0.0 : fit->normal[1], fit->normal[2]};
    double longest = fabs(direction[longest_axis(direction)]);
    if (longest < 0.5) return false; /* not upright at all */
    for (int i = 0; i < 3; i++)
        direction[i] /= longest;
    if (!may_hold_corners(fit, direction)) return false;
    double n[3] = {0.0, 0.0, 0.0};
    small_normal(direction, n);
    plane_place(fit, n, upright ? PLANE_XZ : PLANE_SMALL, out);
    return plane_good_enough(fit, out);
}

static void place_large(const struct plane_fit *fit, struct plane *out)
{
    double n[3], scale = LARGE_MAX / fabs(fit->normal[longest_axis(fit->normal)]);
    for (int i = 0; i < 3; i++)
        n[i] = floor(fit->normal[i] * scale + 0.5);
    plane_place(fit, n, PLANE_LARGE, out);
}

void plane_store(const struct plane_fit *fit, struct plane *out)
{
    if (try_axis(fit, out)) return;
    if (!fit->is_long && (try_small(fit, true, out) || try_small(fit, false, out))) return;
    place_large(fit, out);
}

/* value * FILTER_MAX / longest to nearest, halves away from zero: |value| < 2^48 keeps the
 * product within 2^61. */
static int64_t filter_scale(int64_t value, int64_t longest)
{
    int64_t half = value < 0 ? -(longest / 2) : longest / 2;
    return (value * FILTER_MAX + half) / longest;
}

static struct lim_plane record(const int64_t n[3], int64_t d, lim_index exact)
{
    return (struct lim_plane)LIM_PLANE((int16_t)n[0], (int16_t)n[1], (int16_t)n[2], exact, (int32_t)d);
}

struct lim_plane plane_record(const int64_t n[3], int64_t d)
{
    return record(n, d, LIM_NO_INDEX);
}

struct lim_plane plane_filter(const int64_t n[3], int64_t d, lim_index exact)
{
    int64_t longest = 1, filter[3];
    for (int i = 0; i < 3; i++) {
        int64_t size = n[i] < 0 ? -n[i] : n[i];
        longest = size > longest ? size : longest;
    }
    for (int i = 0; i < 3; i++)
        filter[i] = filter_scale(n[i], longest);
    return record(filter, filter_scale(d, longest), exact);
}

enum plane_kind plane_kind_of(const struct lim_scene *scene, const struct lim_plane_ref *ref)
{
    if (ref->plane >= LIM_PLANE_X) return (enum plane_kind)(ref->plane - LIM_PLANE_X);
    if (lim_scene_long(scene)) return PLANE_LARGE;
    const struct lim_plane *plane = lim_plane_at(scene->planes, ref->plane);
    if (lim_plane_exact(plane) != LIM_NO_INDEX) return PLANE_LARGE;
    return lim_plane_y(plane) == 0 ? PLANE_XZ : PLANE_SMALL;
}

/* n . p = n . v + rest */
static void exact_of_long(const struct lim_long *of_32_bits, const struct lim_plane_ref *ref, int64_t n[3], int64_t *d)
{
    if (ref->plane >= LIM_PLANE_X) {
        for (int i = 0; i < 3; i++)
            n[i] = LIM_PLANE_X + (lim_index)i == ref->plane;
        *d = of_32_bits->vertices[(lim_index)ref->offset].at[ref->plane - LIM_PLANE_X];
        return;
    }
    const struct lim_long_plane *plane = &of_32_bits->planes[ref->plane];
    *d = plane->rest;
    for (int i = 0; i < 3; i++) {
        n[i] = plane->n[i];
        *d += n[i] * of_32_bits->vertices[plane->vertex].at[i];
    }
}

void plane_exact(const struct lim_scene *scene, const struct lim_plane_ref *ref, int64_t n[3], int64_t *d)
{
    if (lim_scene_long(scene)) {
        exact_of_long(lim_scene_long(scene), ref, n, d);
        return;
    }
    if (ref->plane >= LIM_PLANE_X) {
        for (int i = 0; i < 3; i++)
            n[i] = LIM_PLANE_X + (lim_index)i == ref->plane;
        *d = ref->offset;
        return;
    }
    const struct lim_plane *plane = lim_plane_at(scene->planes, ref->plane);
    if (lim_plane_exact(plane) == LIM_NO_INDEX) {
        n[0] = lim_plane_x(plane);
        n[1] = lim_plane_y(plane);
        n[2] = lim_plane_z(plane);
        *d = lim_plane_d(plane);
        return;
    }
    const struct lim_plane_exact *exact = &scene->exact[lim_plane_exact(plane)];
    for (int i = 0; i < 3; i++)
        n[i] = exact->n[i];
    *d = (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo;
}
