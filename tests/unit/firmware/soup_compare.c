/* SPDX-License-Identifier: MIT
 *
 * A picture by brute force: each triangle, each pixel. Where the renderer does not clip, its corners on the screen are
 * taken as they are, and which pixels they cover is decided by 64-bit integers; what it clips is clipped in doubles,
 * and pixels within one of its outline may go either way. */
#include "rigs/cmocka_ready.h"
#include "soup_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

struct eye {
    double at[3], right[3], up[3], ahead[3], tan[2], near, unit; /* unit: what a nearness of 1 stands for, or less */
    double w_px, h_px;
};

/* A triangle as it is seen. */
struct seen {
    bool exact;                                     /* nothing of it is clipped */
    int64_t sub[3][2];                              /* then, its corners in sub-pixels from the first pixel's centre */
    double px[SOUP_CORNERS][2], near[SOUP_CORNERS]; /* corners, and 1 / z there */
    int n;
    double turned; /* 1; -1: clipped, and thin enough to be seen all the same */
    double mean, tolerance;
    double gradient[3]; /* 1 / z = g0 + g1 x + g2 y */
};

/* Where a point is seen: right and up as parts of the screen's half times z, and z. */
static void view_of(const struct eye *eye, const double at[3], double out[3])
{
    const double *const axes[3] = {eye->right, eye->up, eye->ahead};

    for (int k = 0; k < 3; k++) {
        out[k] = 0;
        for (int i = 0; i < 3; i++)
            out[k] += axes[k][i] * (at[i] - eye->at[i]);
    }
    out[0] /= eye->tan[0];
    out[1] /= eye->tan[1];
}

static void set_axes(struct eye *eye, const struct lim_camera *camera)
{
    const double turn = ldexp(camera->yaw, -31) * PI, lift = ldexp(camera->pitch, -31) * PI;
    const double roll = ldexp(camera->roll, -31) * PI;
    const double right[3] = {cos(turn), 0, -sin(turn)};
    const double up[3] = {sin(turn) * sin(lift), cos(lift), cos(turn) * sin(lift)};
    const double ahead[3] = {-sin(turn) * cos(lift), sin(lift), -cos(turn) * cos(lift)};

    for (int i = 0; i < 3; i++) {
        eye->at[i] = camera->eye_q8[i] / 256.0;
        eye->ahead[i] = ahead[i];
        eye->right[i] = cos(roll) * right[i] - sin(roll) * up[i];
        eye->up[i] = sin(roll) * right[i] + cos(roll) * up[i];
    }
}

static struct eye eye_of(const struct soup *soup, const struct soup_view *view, const struct lim_camera *camera)
{
    struct eye eye = {.tan = {ldexp(camera->tan_x_q28, -28), ldexp(camera->tan_y_q28, -28)},
                      .near = camera->near_q8 / 256.0,
                      .w_px = view->w_px,
                      .h_px = view->h_px};
    double least = 1e9;

    set_axes(&eye, camera);
    for (int corner = 0; corner < 8; corner++) {
        double at[3], seen[3];
        for (int i = 0; i < 3; i++)
            at[i] = soup->box.centre[i] + (corner >> i & 1 ? 1.0 : -1.0) * soup->box.half[i];
        view_of(&eye, at, seen);
        least = fmin(least, seen[2]);
    }
    eye.unit = 1 / (16384 * fmax(eye.near, 0.75 * least));
    return eye;
}

/* Keeps what is at or beyond a plane: z >= near, or 2 z >= sign * x[axis]. */
static int clip(const struct eye *eye, const double (*from)[3], int n, double (*to)[3], int plane)
{
    double far[SOUP_CORNERS];
    int count = 0;

    for (int k = 0; k < n; k++)
        far[k] = plane ? 2 * from[k][2] - (plane & 1 ? 1 : -1) * from[k][(plane - 1) / 2] : from[k][2] - eye->near;
    for (int k = 0; k < n; k++) {
        const int next = (k + 1) % n;
        if (far[k] >= 0) memcpy(to[count++], from[k], sizeof *to);
        if ((far[k] < 0) == (far[next] < 0)) continue;
        const double t = far[k] / (far[k] - far[next]);
        for (int i = 0; i < 3; i++)
            to[count][i] = from[k][i] + t * (from[next][i] - from[k][i]);
        count++;
    }
    return count;
}

static double area_of(double (*at)[2], int n)
{
    double area = 0;

    for (int k = 2; k < n; k++)
        area += (at[k - 1][0] - at[0][0]) * (at[k][1] - at[0][1]) - (at[k - 1][1] - at[0][1]) * (at[k][0] - at[0][0]);
    return area;
}

/* 1 / z is n . (x, y, 1) of the triangle's plane n . p = 1 in view space. false: the eye is in that plane. */
static bool set_gradient(struct seen *seen, const struct eye *eye, double (*p)[3])
{
    double n[3];

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
    }
    const double d = n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2];
    if (d == 0) return false;
    seen->gradient[1] = n[0] / d * 2 / eye->w_px;
    seen->gradient[2] = -n[1] / d * 2 / eye->h_px;
    seen->gradient[0] = n[2] / d - seen->gradient[1] * (eye->w_px - 1) / 2 - seen->gradient[2] * (eye->h_px - 1) / 2;
    return true;
}

/* Over corners that the renderer has on the screen. */
static void set_exact_gradient(struct seen *seen, double sub_px)
{
    const double ux = (double)(seen->sub[1][0] - seen->sub[0][0]), uy = (double)(seen->sub[1][1] - seen->sub[0][1]);
    const double vx = (double)(seen->sub[2][0] - seen->sub[0][0]), vy = (double)(seen->sub[2][1] - seen->sub[0][1]);
    const double p = seen->near[1] - seen->near[0], q = seen->near[2] - seen->near[0], area = ux * vy - uy * vx;

    seen->gradient[1] = (p * vy - q * uy) / area * sub_px;
    seen->gradient[2] = (q * ux - p * vx) / area * sub_px;
    seen->gradient[0] =
        seen->near[0] -
        (seen->gradient[1] * (double)seen->sub[0][0] + seen->gradient[2] * (double)seen->sub[0][1]) / sub_px;
}

static bool all_on_screen(const struct soup *soup, struct soup_view *view, int triangle, struct seen *seen)
{
    for (int k = 0; k < 3; k++) {
        double at_px[2];
        if (!view->core->project(view->lim, soup->words[triangle * LIM_TRIANGLE_WORDS + k], at_px)) return false;
        for (int i = 0; i < 2; i++)
            seen->sub[k][i] = llrint(ldexp(at_px[i], view->core->sub_bits));
    }
    return true;
}

/* The renderer's z has an error that grows with the distance from the eye across. */
static void set_distance(struct seen *seen, const struct eye *eye, double (*at)[3], int n, bool by_depth)
{
    double sum = 0, off = 0, least = 1e9, most = 0;

    for (int k = 0; k < n; k++) {
        const double z = at[k][2];
        seen->near[k] = 1 / z;
        sum += 1 / z;
        least = fmin(least, 1 / z);
        most = fmax(most, 1 / z);
        off = fmax(off, hypot(hypot(at[k][0] * eye->tan[0], at[k][1] * eye->tan[1]), z) / 24000 / z / z);
    }
    seen->mean = sum / n;
    seen->tolerance = 3 * eye->unit + off + (by_depth ? (most - least) / 4096 : 0);
}

/* Whether all corners lie within 1.5 pixels of a line through two of them: rounding may have turned it. */
static bool is_thin(const struct seen *seen)
{
    double longest = 0, widest = 0;
    int from = 0, to = 0;

    for (int i = 0; i < seen->n; i++)
        for (int k = 0; k < i; k++) {
            const double length = hypot(seen->px[i][0] - seen->px[k][0], seen->px[i][1] - seen->px[k][1]);
            if (length <= longest) continue;
            longest = length;
            from = i;
            to = k;
        }
    const double dx = seen->px[to][0] - seen->px[from][0], dy = seen->px[to][1] - seen->px[from][1];
    for (int i = 0; i < seen->n && longest > 0; i++)
        widest =
            fmax(widest,
                 fabs((seen->px[i][0] - seen->px[from][0]) * dy - (seen->px[i][1] - seen->px[from][1]) * dx) / longest);
    return widest < 1.5;
}

/* false: it is not seen. */
static bool look_at(const struct soup *soup, struct soup_view *view, const struct eye *eye, int triangle, bool by_depth,
                    struct seen *seen)
{
    double a[SOUP_CORNERS][3], b[SOUP_CORNERS][3], (*at)[3] = a, (*other)[3] = b;

    for (int k = 0; k < 3; k++) {
        const struct lim_vertex *v = &soup->vertices[soup->words[triangle * LIM_TRIANGLE_WORDS + k]];
        view_of(eye, (const double[3]){v->x, v->y, v->z}, at[k]);
    }
    seen->n = 3;
    if ((seen->exact = all_on_screen(soup, view, triangle, seen))) {
        const int64_t ux = seen->sub[1][0] - seen->sub[0][0], uy = seen->sub[1][1] - seen->sub[0][1];
        const int64_t vx = seen->sub[2][0] - seen->sub[0][0], vy = seen->sub[2][1] - seen->sub[0][1];
        if (ux * vy >= uy * vx) return false;
        set_distance(seen, eye, at, 3, by_depth);
        set_exact_gradient(seen, ldexp(1, view->core->sub_bits));
        return true;
    }
    if (!set_gradient(seen, eye, at)) return false;
    for (int plane = 0; plane < 5 && seen->n; plane++) {
        double(*const clipped)[3] = other;
        seen->n = clip(eye, (const double(*)[3])at, seen->n, clipped, plane);
        other = at;
        at = clipped;
    }
    if (seen->n < 3) return false;
    for (int k = 0; k < seen->n; k++) {
        seen->px[k][0] = (at[k][0] / at[k][2] * eye->w_px + eye->w_px - 1) / 2;
        seen->px[k][1] = (-at[k][1] / at[k][2] * eye->h_px + eye->h_px - 1) / 2;
    }
    set_distance(seen, eye, at, seen->n, by_depth);
    if (by_depth) seen->tolerance += 2 * (fabs(seen->gradient[1]) + fabs(seen->gradient[2]));
    const double area = area_of(seen->px, seen->n);
    seen->turned = area < 0 ? 1 : -1;
    return area < 0 || is_thin(seen);
}

/* Right of or on the left boundary, left of the right one. */
static bool covers(const struct seen *seen, int64_t x, int64_t y)
{
    bool left = false, right = false;

    for (int k = 0; k < 3; k++) {
        const int64_t *a = seen->sub[k], *b = seen->sub[(k + 1) % 3];
        if (a[1] <= y && y < b[1])
            left = (x - a[0]) * (b[1] - a[1]) >= (b[0] - a[0]) * (y - a[1]);
        else if (b[1] <= y && y < a[1])
            right = (x - b[0]) * (a[1] - b[1]) < (a[0] - b[0]) * (y - b[1]);
    }
    return left && right;
}

/* How far inside of what is left of a clipped triangle, in pixels; negative: outside. */
static double inside_px(const struct seen *seen, double x, double y)
{
    double least = 1e9;

    for (int k = 0; k < seen->n; k++) {
        const double *a = seen->px[k], *b = seen->px[(k + 1) % seen->n];
        const double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
        if (length > 1e-9) least = fmin(least, seen->turned * ((x - a[0]) * dy - (y - a[1]) * dx) / length);
    }
    return least;
}

struct pixel {
    double best, second,
        slack;  /* nearness of what is there for sure, less what is not known of it, and how much that is */
    double own; /* the most that may be that of what is shown */
    bool shown; /* the triangle that is shown may be there */
};

static void look_at_pixel(struct soup_counts *counts, struct pixel *pixel, const struct seen *seen, bool is_shown,
                          double nearness, double inside)
{
    if (inside < -1.5) return;
    if (is_shown) {
        pixel->shown = true;
        pixel->own = nearness + seen->tolerance;
    }
    if (inside < 1.5) return;
    if (seen->exact) counts->painted++;
    const double sure = nearness - seen->tolerance;
    if (sure > pixel->best) {
        pixel->second = pixel->best;
        pixel->best = sure;
        pixel->slack = seen->tolerance;
    } else if (sure > pixel->second) {
        pixel->second = sure;
    }
}

static void look_at_triangle(struct soup_counts *counts, struct pixel *pixels, const struct soup_view *view,
                             const struct seen *seen, int triangle, int ordered_by)
{
    const int64_t sub = INT64_C(1) << view->core->sub_bits;

    for (uint16_t y = 0; y < view->h_px; y++)
        for (uint16_t x = 0; x < view->w_px; x++) {
            const double inside = !seen->exact ? inside_px(seen, x, y) : covers(seen, x * sub, y * sub) ? 2 : -2;
            const double nearness = ordered_by == 0 ? seen->mean
                                    : ordered_by == 1
                                        ? seen->gradient[0] + seen->gradient[1] * x + seen->gradient[2] * y
                                        : 0;
            look_at_pixel(counts, &pixels[y * view->w_px + x], seen, soup_view_at(view, x, y) == triangle, nearness,
                          inside);
        }
}

struct soup_counts soup_compare(const struct soup *soup, struct soup_view *view, enum lim_method method,
                                const struct lim_camera *camera)
{
    const struct eye eye = eye_of(soup, view, camera);
    const uint32_t count = (uint32_t)view->w_px * view->h_px;
    const int ordered_by = method == LIM_MESH || *soup->scene.deep_from >= soup->scene.polygon_count ? 0
                           : *soup->scene.deep_from                                                  ? 2
                                                                                                     : 1;
    struct pixel *pixels = malloc(count * sizeof *pixels);
    struct soup_counts counts = {.pixels = count};

    assert_non_null(pixels);
    for (uint32_t i = 0; i < count; i++)
        pixels[i] = (struct pixel){.best = -1, .second = -1};
    for (lim_index triangle = 0; triangle < soup->scene.polygon_count; triangle++) {
        struct seen seen;
        if (!look_at(soup, view, &eye, (int)triangle, ordered_by == 1, &seen)) continue;
        counts.clipped += !seen.exact;
        look_at_triangle(&counts, pixels, view, &seen, (int)triangle, ordered_by);
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct pixel *pixel = &pixels[i];
        const int shown = soup_view_at(view, (uint16_t)(i % view->w_px), (uint16_t)(i / view->w_px));
        counts.covered += shown >= 0;
        counts.ambiguous += ordered_by < 2 && pixel->second > 0 && pixel->best - pixel->second < 2 * pixel->slack;
        if (shown < 0 ? pixel->best < 0 : pixel->shown && (ordered_by == 2 || pixel->own >= pixel->best)) continue;
        counts.wrong++;
        counts.at_x = i % view->w_px;
        counts.at_y = i / view->w_px;
    }
    free(pixels);
    return counts;
}
