/* SPDX-License-Identifier: MIT
 *
 * Clipping is Sutherland and Hodgman's, the hull Andrew's monotone chain in the plane's two longest axes. */
#include "portals/patch.h"

#include "base/grow.h"
#include "base/vec3.h"

#include <stdlib.h>
#include <string.h>

static const double ON_UNITS = 0x1p-24;   /* doubles err by less than 2^-30 here */
static const double THIN_UNITS = 0x1p-20; /* no area */

double flat_distance(const struct flat *flat, const double point[3])
{
    return vec3_dot(flat->n, point) - flat->d;
}

struct flat flat_turned(const struct flat *flat)
{
    return (struct flat){{-flat->n[0], -flat->n[1], -flat->n[2]}, -flat->d};
}

static void cross(double out[3], const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static double normalise(double v[3])
{
    const double length = sqrt(vec3_dot(v, v));
    for (int i = 0; length > 0 && i < 3; i++)
        v[i] /= length;
    return length;
}

static int longest_axis(const double n[3])
{
    const double x = fabs(n[0]), y = fabs(n[1]), z = fabs(n[2]);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* Two axes in the plane, such that u x v = n. */
static void plane_axes(const struct flat *flat, double u[3], double v[3])
{
    double helper[3] = {0, 0, 0};
    helper[(longest_axis(flat->n) + 1) % 3] = 1;
    cross(u, helper, flat->n);
    normalise(u);
    cross(v, flat->n, u);
}

void patch_square(struct patch *patch, const struct flat *flat, double reach_units)
{
    static const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double u[3], v[3];
    plane_axes(flat, u, v);
    patch->count = 4;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < 3; i++)
            patch->at[c][i] = flat->n[i] * flat->d + 2 * reach_units * (signs[c][0] * u[i] + signs[c][1] * v[i]);
}

void patch_turn(struct patch *patch)
{
    for (size_t i = 0, j = patch->count; i + 1 < j; i++) {
        double corner[3];
        j--;
        memcpy(corner, patch->at[i], sizeof corner);
        memcpy(patch->at[i], patch->at[j], sizeof corner);
        memcpy(patch->at[j], corner, sizeof corner);
    }
}

void patch_range(const struct patch *patch, const struct flat *flat, double *low, double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (size_t i = 0; i < patch->count; i++) {
        const double distance = flat_distance(flat, patch->at[i]);
        *low = fmin(*low, distance);
        *high = fmax(*high, distance);
    }
}

static void between(double out[3], const double a[3], const double b[3], double t)
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] + t * (b[i] - a[i]);
}

bool patch_clip(struct patch *patch, const struct flat *flat)
{
    double low, high;
    patch_range(patch, flat, &low, &high);
    if (!(high > ON_UNITS)) patch->count = 0;
    if (patch->count == 0 || low >= -ON_UNITS || patch->count == PATCH_CORNERS_MAX) return patch->count > 0;
    const struct patch whole = *patch;
    patch->count = 0;
    for (size_t i = 0; i < whole.count; i++) {
        const double *here = whole.at[i], *next = whole.at[(i + 1) % whole.count];
        const double from = flat_distance(flat, here), to = flat_distance(flat, next);
        if (from >= 0) memcpy(patch->at[patch->count++], here, sizeof whole.at[0]);
        if ((from < 0) != (to < 0) && patch->count < PATCH_CORNERS_MAX)
            between(patch->at[patch->count++], here, next, from / (from - to));
        if (patch->count == PATCH_CORNERS_MAX) { /* noise made it cross more than twice */
            *patch = whole;
            return true;
        }
    }
    if (patch->count < 3) patch->count = 0;
    return patch->count > 0;
}

/* Hull --------------------------------------------------------------------------------------- */

struct flat_point {
    double u, v;
};

static int compare_points(const void *a, const void *b)
{
    const struct flat_point *p = a, *q = b;
    if (p->u != q->u) return p->u < q->u ? -1 : 1;
    return (p->v > q->v) - (p->v < q->v);
}

static bool turns_left(const struct flat_point *a, const struct flat_point *b, const struct flat_point *c)
{
    return (b->u - a->u) * (c->v - a->v) - (b->v - a->v) * (c->u - a->u) > 0;
}

/* Sorted points to their hull, counter-clockwise; `hull` has room for twice as many. */
static size_t chain(const struct flat_point *points, size_t count, struct flat_point *hull)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++) {
        while (n >= 2 && !turns_left(&hull[n - 2], &hull[n - 1], &points[i]))
            n--;
        hull[n++] = points[i];
    }
    const size_t lower = n + 1;
    for (size_t i = count - 1; i-- > 0;) {
        while (n >= lower && !turns_left(&hull[n - 2], &hull[n - 1], &points[i]))
            n--;
        hull[n++] = points[i];
    }
    return n - 1;
}

static size_t rectangle(const struct flat_point *points, size_t count, struct flat_point out[4])
{
    struct flat_point low = points[0], high = points[0];
    for (size_t i = 0; i < count; i++) {
        low = (struct flat_point){fmin(low.u, points[i].u), fmin(low.v, points[i].v)};
        high = (struct flat_point){fmax(high.u, points[i].u), fmax(high.v, points[i].v)};
    }
    out[0] = low;
    out[1] = (struct flat_point){high.u, low.v};
    out[2] = high;
    out[3] = (struct flat_point){low.u, high.v};
    return 4;
}

bool patch_hull(struct patch *patch, const struct flat *flat, const double (*points)[3], size_t count)
{
    double u[3], v[3];
    struct flat_point *flattened = grow_zeroed(count, sizeof *flattened);
    struct flat_point *hull = grow_zeroed(2 * count, sizeof *hull);
    plane_axes(flat, u, v);
    for (size_t i = 0; i < count; i++)
        flattened[i] = (struct flat_point){vec3_dot(u, points[i]), vec3_dot(v, points[i])};
    qsort(flattened, count, sizeof *flattened, compare_points);
    size_t corners = count > 2 ? chain(flattened, count, hull) : 0;
    const bool fits = corners <= PATCH_CORNERS_MAX / 2;
    if (!fits) corners = rectangle(flattened, count, hull);
    patch->count = corners < 3 ? 0 : corners;
    for (size_t i = 0; i < patch->count; i++)
        for (int k = 0; k < 3; k++)
            patch->at[i][k] = flat->n[k] * flat->d + hull[i].u * u[k] + hull[i].v * v[k];
    free(flattened);
    free(hull);
    return fits;
}

/* Measures ----------------------------------------------------------------------------------- */

bool patch_side(const struct patch *patch, const struct flat *flat, size_t i, struct flat *side)
{
    double along[3];
    vec3_sub(along, patch->at[(i + 1) % patch->count], patch->at[i]);
    if (normalise(along) < THIN_UNITS) return false;
    cross(side->n, flat->n, along);
    side->d = vec3_dot(side->n, patch->at[i]);
    return true;
}

void patch_grow(const struct patch *patch, const struct flat *flat, double margin_units, struct patch *out)
{
    static const int signs[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    double axes[2][3], ends[2][2];
    plane_axes(flat, axes[0], axes[1]);
    for (int k = 0; k < 2; k++) {
        ends[k][0] = INFINITY;
        ends[k][1] = -INFINITY;
        for (size_t i = 0; i < patch->count; i++) {
            const double at = vec3_dot(axes[k], patch->at[i]);
            ends[k][0] = fmin(ends[k][0], at - margin_units);
            ends[k][1] = fmax(ends[k][1], at + margin_units);
        }
    }
    out->count = 4;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < 3; i++)
            out->at[c][i] =
                flat->n[i] * flat->d + ends[0][signs[c][0]] * axes[0][i] + ends[1][signs[c][1]] * axes[1][i];
    for (size_t i = 0; i < patch->count; i++) {
        struct flat side;
        if (!patch_side(patch, flat, i, &side)) continue;
        side.d -= margin_units;
        patch_clip(out, &side);
    }
}

double patch_width(const struct patch *patch, const struct flat *flat)
{
    double width = INFINITY;
    for (size_t i = 0; i < patch->count; i++) {
        struct flat side;
        double low, high;
        if (!patch_side(patch, flat, i, &side)) continue;
        patch_range(patch, &side, &low, &high);
        width = fmin(width, high);
    }
    return width < INFINITY ? width : 0;
}

double patch_area(const struct patch *patch, const struct flat *flat)
{
    double twice = 0;
    for (size_t i = 1; i + 1 < patch->count; i++) {
        double a[3], b[3], c[3];
        vec3_sub(a, patch->at[i], patch->at[0]);
        vec3_sub(b, patch->at[i + 1], patch->at[0]);
        cross(c, a, b);
        twice += vec3_dot(c, flat->n);
    }
    return fabs(twice) / 2;
}

bool patch_holds(const struct patch *patch, const struct flat *flat, const struct patch *other, double slack_units)
{
    for (size_t i = 0; i < patch->count; i++) {
        struct flat side;
        double low, high;
        if (!patch_side(patch, flat, i, &side)) continue;
        patch_range(other, &side, &low, &high);
        if (low < -slack_units) return false;
    }
    return patch->count > 0;
}

/* Lists -------------------------------------------------------------------------------------- */

void patches_add(struct patches *patches, const struct patch *patch)
{
    patches->items = grow(patches->items, patches->count, &patches->capacity, sizeof *patches->items);
    patches->items[patches->count++] = *patch;
}

void patches_free(struct patches *patches)
{
    free(patches->items);
    *patches = (struct patches){0};
}

static bool overlap(const struct patch *patch, const struct flat *flat, const struct patch *hole)
{
    struct patch common = *patch;
    for (size_t i = 0; i < hole->count; i++) {
        struct flat side;
        if (patch_side(hole, flat, i, &side) && !patch_clip(&common, &side)) return false;
    }
    return patch_width(&common, flat) > THIN_UNITS;
}

/* One patch to the parts of it beyond each side of the hole. */
static void cut_up(const struct patch *patch, const struct flat *flat, const struct patch *hole, struct patches *out)
{
    struct patch rest = *patch;
    for (size_t i = 0; i < hole->count; i++) {
        struct flat side;
        if (!patch_side(hole, flat, i, &side)) continue;
        const struct flat outside = flat_turned(&side);
        struct patch beyond = rest;
        if (patch_clip(&beyond, &outside) && patch_width(&beyond, flat) > THIN_UNITS) patches_add(out, &beyond);
        if (!patch_clip(&rest, &side)) return;
    }
}

bool patches_subtract(struct patches *patches, const struct flat *flat, const struct patch *hole)
{
    struct patches out = {0};
    bool met = false;
    for (size_t i = 0; i < patches->count; i++) {
        const bool meets = overlap(&patches->items[i], flat, hole);
        met = met || meets;
        if (meets)
            cut_up(&patches->items[i], flat, hole, &out);
        else
            patches_add(&out, &patches->items[i]);
    }
    patches_free(patches);
    *patches = out;
    return met;
}
