/* SPDX-License-Identifier: MIT
 *
 * Geometry of single polygons. Tolerances are distances, never angles or areas: those depend on
 * how finely a model is divided. */
#include "model/loop.h"

#include "base/grow.h"
#include "base/vec3.h"

#include <stdlib.h>
#include <string.h>

static const double *corner_at(const struct loop *loop, size_t i)
{
    return loop->points[loop->corners[i]];
}

static bool is_near(double (*points)[3], uint32_t a, uint32_t b, uint32_t p, double near_m)
{
    return vec3_segment_distance2(points[a], points[b], points[p]) < near_m * near_m;
}

size_t loop_tidy(double (*points)[3], uint32_t *corners, size_t count, double near_m)
{
    size_t kept_in_a_row = 0;
    for (size_t i = 0; count >= 3 && kept_in_a_row < count;) {
        uint32_t before = corners[(i + count - 1) % count], here = corners[i], after = corners[(i + 1) % count];
        bool useless = is_near(points, before, here, after, near_m) || is_near(points, here, after, before, near_m);
        if (!useless) {
            kept_in_a_row++;
            i = (i + 1) % count;
            continue;
        }
        memmove(&corners[i], &corners[i + 1], (count - i - 1) * sizeof *corners);
        count--;
        kept_in_a_row = 0;
        i = count ? (i + count - 1) % count : 0; /* its neighbour may be useless now */
    }
    return count < 3 ? 0 : count;
}

static size_t farthest_from(const struct loop *loop, size_t from)
{
    size_t farthest = from;
    double largest2 = 0;
    for (size_t i = 0; i < loop->count; i++) {
        double distance2 = vec3_distance2(corner_at(loop, from), corner_at(loop, i));
        if (distance2 > largest2) largest2 = distance2, farthest = i;
    }
    return farthest;
}

bool loop_has_area(const struct loop *loop, double near_m)
{
    if (loop->count < 3) return false;
    size_t one = farthest_from(loop, 0), other = farthest_from(loop, one);
    for (size_t i = 0; i < loop->count; i++)
        if (!is_near(loop->points, loop->corners[one], loop->corners[other], loop->corners[i], near_m)) return true;
    return false;
}

static void cross_from(double out[3], const double origin[3], const double a[3], const double b[3])
{
    double u[3], v[3];
    vec3_sub(u, a, origin);
    vec3_sub(v, b, origin);
    for (int axis = 0; axis < 3; axis++) {
        int next = (axis + 1) % 3, last = (axis + 2) % 3;
        out[axis] = u[next] * v[last] - u[last] * v[next];
    }
}

/* Where a loop like a bow tie has equal areas to the left and right: the normal at its widest bend. */
static void widest_bend(const struct loop *loop, double normal[3])
{
    double largest2 = 0;
    for (size_t i = 0; i < loop->count; i++) {
        double bend[3];
        cross_from(bend, corner_at(loop, i), corner_at(loop, (i + 1) % loop->count),
                   corner_at(loop, (i + loop->count - 1) % loop->count));
        if (vec3_dot(bend, bend) <= largest2) continue;
        largest2 = vec3_dot(bend, bend);
        memcpy(normal, bend, sizeof bend);
    }
}

struct loop_plane loop_plane_of(const struct loop *loop)
{
    struct loop_plane plane = {{0, 0, 0}, {0, 0, 0}};
    double all_areas = 0;
    for (size_t i = 0; i < loop->count; i++) {
        double part[3];
        cross_from(part, corner_at(loop, 0), corner_at(loop, i), corner_at(loop, (i + 1) % loop->count));
        for (int axis = 0; axis < 3; axis++) {
            plane.normal[axis] += part[axis];
            plane.centre[axis] += corner_at(loop, i)[axis] / (double)loop->count;
        }
        all_areas += sqrt(vec3_dot(part, part));
    }
    double length = sqrt(vec3_dot(plane.normal, plane.normal));
    if (length <= 1e-9 * all_areas) widest_bend(loop, plane.normal); /* no more than rounding errors */
    length = sqrt(vec3_dot(plane.normal, plane.normal));
    for (int axis = 0; axis < 3; axis++)
        plane.normal[axis] /= length;
    return plane;
}

double loop_off_plane_m(const struct loop *loop, const struct loop_plane *plane)
{
    double farthest = 0;
    for (size_t i = 0; i < loop->count; i++) {
        double from_centre[3];
        vec3_sub(from_centre, corner_at(loop, i), plane->centre);
        farthest = fmax(farthest, fabs(vec3_dot(from_centre, plane->normal)));
    }
    return farthest;
}

struct loop_view loop_view_along(const double normal[3])
{
    int along = 0;
    for (int axis = 1; axis < 3; axis++)
        if (fabs(normal[axis]) > fabs(normal[along])) along = axis;
    int next = (along + 1) % 3, last = (along + 2) % 3;
    return normal[along] > 0 ? (struct loop_view){next, last} : (struct loop_view){last, next};
}

double loop_turn(double (*points)[3], const struct loop_view *view, uint32_t a, uint32_t b, uint32_t c)
{
    const double *p = points[a], *q = points[b], *r = points[c];
    int u = view->u, v = view->v;
    return (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
}

/* The leftmost corner, the lowest of them: certainly one of the convex hull. */
static size_t leftmost(const struct loop *loop, const struct loop_view *view)
{
    size_t best = 0;
    for (size_t i = 1; i < loop->count; i++) {
        const double *p = corner_at(loop, i), *q = corner_at(loop, best);
        if (p[view->u] < q[view->u] || (p[view->u] == q[view->u] && p[view->v] < q[view->v])) best = i;
    }
    return best;
}

/* Graham's scan along the loop itself, from `start` back to it: how many steps the corners are off
 * that turn left. For a convex loop they are its hull. */
static size_t left_turns(const struct loop *loop, const struct loop_view *view, size_t start, size_t *steps)
{
    size_t depth = 1;
    steps[0] = 0;
    for (size_t step = 1; step <= loop->count; step++) {
        uint32_t here = loop->corners[(start + step) % loop->count];
        while (depth >= 2 && loop_turn(loop->points, view, loop->corners[(start + steps[depth - 2]) % loop->count],
                                       loop->corners[(start + steps[depth - 1]) % loop->count], here) <= 0)
            depth--;
        steps[depth++] = step;
    }
    return depth;
}

/* is_near(), but along the plane only: a corner off the plane is another matter. */
static bool is_near_in_plane(const struct loop *loop, const struct loop_plane *plane, uint32_t a, uint32_t b,
                             uint32_t p, double near_m)
{
    const double *from = loop->points[a];
    double flat[2][3];
    for (int i = 0; i < 2; i++) {
        const double *point = loop->points[i ? p : b];
        vec3_sub(flat[i], point, from);
        double off = vec3_dot(flat[i], plane->normal);
        for (int axis = 0; axis < 3; axis++)
            flat[i][axis] = point[axis] - off * plane->normal[axis];
    }
    return vec3_segment_distance2(from, flat[0], flat[1]) < near_m * near_m;
}

bool loop_is_convex(const struct loop *loop, const struct loop_plane *plane, double near_m)
{
    const struct loop_view view = loop_view_along(plane->normal);
    size_t start = leftmost(loop, &view);
    size_t *steps = grow_zeroed(loop->count + 1, sizeof *steps);
    size_t sides = left_turns(loop, &view, start, steps) - 1;
    bool convex = sides >= 3, came_back = false;
    for (size_t side = 0; convex && side < sides; side++) {
        uint32_t from = loop->corners[(start + steps[side]) % loop->count];
        uint32_t to = loop->corners[(start + steps[side + 1]) % loop->count];
        double along = loop->points[to][view.u] - loop->points[from][view.u];
        if (along < 0) came_back = true;
        if (along > 0 && came_back) convex = false; /* a second time round, like a star */
        for (size_t step = steps[side] + 1; convex && step < steps[side + 1]; step++)
            convex = is_near_in_plane(loop, plane, from, to, loop->corners[(start + step) % loop->count], near_m);
    }
    free(steps);
    return convex;
}
