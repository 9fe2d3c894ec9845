/* SPDX-License-Identifier: MIT
 *
 * Points are put in one by one, each into the triangle where it lies, and edges turned until no point is within a
 * triangle's circle (Lawson 1977). A line is made an edge by turning those that it crosses (Sloan 1993). Signs are of
 * whole numbers: 17 bits a difference, 37 a side, 75 a circle. */
#include "levels/level_triangles.h"

#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

__extension__ typedef __int128 wide;

enum { FRAME_REACH = 1 << 17 };

int64_t triangles_side(const struct triangles *triangles, uint32_t a, uint32_t b, uint32_t c)
{
    const int32_t *p = triangles->points[a], *q = triangles->points[b], *r = triangles->points[c];
    return (int64_t)(q[0] - p[0]) * (r[1] - p[1]) - (int64_t)(q[1] - p[1]) * (r[0] - p[0]);
}

/* Whether d lies within the circle through a, b and c, which run counter-clockwise. */
static bool is_in_circle(const struct triangles *triangles, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    const int32_t *centre = triangles->points[d],
                  *corners[3] = {triangles->points[a], triangles->points[b], triangles->points[c]};
    int64_t x[3], y[3], square[3];
    for (int i = 0; i < 3; i++) {
        x[i] = corners[i][0] - centre[0];
        y[i] = corners[i][1] - centre[1];
        square[i] = x[i] * x[i] + y[i] * y[i];
    }
    return (wide)(x[1] * y[2] - x[2] * y[1]) * square[0] + (wide)(x[2] * y[0] - x[0] * y[2]) * square[1] +
               (wide)(x[0] * y[1] - x[1] * y[0]) * square[2] >
           0;
}

/* Half-edges --------------------------------------------------------------------------------- */

static uint32_t apex(const struct triangles *triangles, uint32_t half)
{
    return triangles->origin[half_before(half)];
}

static uint32_t end_of(const struct triangles *triangles, uint32_t half)
{
    return triangles->origin[half_next(half)];
}

static void join(struct triangles *triangles, uint32_t half, uint32_t twin, bool is_fixed)
{
    triangles->twin[half] = twin;
    triangles->is_fixed[half] = is_fixed;
    if (twin == TRIANGLES_NONE) return;
    triangles->twin[twin] = half;
    triangles->is_fixed[twin] = is_fixed;
}

static void set_origin(struct triangles *triangles, uint32_t half, uint32_t point)
{
    triangles->origin[half] = point;
    triangles->leaving[point] = half;
}

static uint32_t add_triangle(struct triangles *triangles, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t first = triangles->half_count;
    const uint32_t corners[3] = {a, b, c};
    triangles->half_count += 3;
    for (uint32_t i = 0; i < 3; i++)
        set_origin(triangles, first + i, corners[i]);
    return first;
}

static void push(struct triangles *triangles, uint32_t half)
{
    triangles->stack =
        grow(triangles->stack, triangles->stack_count, &triangles->stack_capacity, sizeof *triangles->stack);
    triangles->stack[triangles->stack_count++] = half;
}

/* The edge of two triangles becomes the other diagonal of their four corners: from the far corner to the apex. */
static void turn(struct triangles *triangles, uint32_t half)
{
    const uint32_t next = half_next(half), before = half_before(half), twin = triangles->twin[half];
    const uint32_t twin_next = half_next(twin), twin_before = half_before(twin);
    const uint32_t a = triangles->origin[half], b = triangles->origin[twin], c = triangles->origin[before],
                   d = triangles->origin[twin_before];
    const uint32_t outer[4] = {triangles->twin[before], triangles->twin[twin_next], triangles->twin[twin_before],
                               triangles->twin[next]};
    const bool fixed[4] = {triangles->is_fixed[before], triangles->is_fixed[twin_next],
                           triangles->is_fixed[twin_before], triangles->is_fixed[next]};
    set_origin(triangles, half, d);
    set_origin(triangles, next, c);
    set_origin(triangles, before, a);
    set_origin(triangles, twin, c);
    set_origin(triangles, twin_next, d);
    set_origin(triangles, twin_before, b);
    join(triangles, next, outer[0], fixed[0]);
    join(triangles, before, outer[1], fixed[1]);
    join(triangles, twin_next, outer[2], fixed[2]);
    join(triangles, twin_before, outer[3], fixed[3]);
}

/* Turns what is on the stack as long as a far corner lies within a circle; each turn asks for the edges round it. */
static void settle(struct triangles *triangles)
{
    while (triangles->stack_count) {
        const uint32_t half = triangles->stack[--triangles->stack_count], twin = triangles->twin[half];
        if (twin == TRIANGLES_NONE || triangles->is_fixed[half]) continue;
        if (!is_in_circle(triangles, triangles->origin[half], triangles->origin[twin], apex(triangles, half),
                          apex(triangles, twin)))
            continue;
        turn(triangles, half);
        push(triangles, half_next(half));
        push(triangles, half_before(half));
        push(triangles, half_next(twin));
        push(triangles, half_before(twin));
    }
}

/* Points ------------------------------------------------------------------------------------- */

/* From triangle to triangle towards the point: among Delaunay's that ends. */
static uint32_t walk_to(const struct triangles *triangles, uint32_t half, uint32_t point)
{
    for (int agreed = 0; agreed < 3; agreed++) {
        if (triangles_side(triangles, triangles->origin[half], end_of(triangles, half), point) < 0) {
            half = triangles->twin[half];
            agreed = 0;
        }
        half = half_next(half);
    }
    return half;
}

static void put_in(struct triangles *triangles, uint32_t point)
{
    const uint32_t first = walk_to(triangles, triangles->half_count - 3, point);
    const uint32_t halves[3] = {first, half_next(first), half_before(first)};
    const uint32_t corners[3] = {triangles->origin[halves[0]], triangles->origin[halves[1]],
                                 triangles->origin[halves[2]]};
    const uint32_t twins[3] = {triangles->twin[halves[0]], triangles->twin[halves[1]], triangles->twin[halves[2]]};
    const uint32_t second = add_triangle(triangles, corners[1], corners[2], point);
    const uint32_t third = add_triangle(triangles, corners[2], corners[0], point);
    set_origin(triangles, halves[0], corners[0]);
    set_origin(triangles, halves[1], corners[1]);
    set_origin(triangles, halves[2], point);
    join(triangles, halves[0], twins[0], false);
    join(triangles, second, twins[1], false);
    join(triangles, third, twins[2], false);
    join(triangles, halves[1], half_before(second), false);
    join(triangles, second + 1, third + 2, false);
    join(triangles, third + 1, halves[2], false);
    const uint32_t outer[3] = {halves[0], second, third};
    for (int i = 0; i < 3; i++) {
        const bool is_flat = triangles_side(triangles, corners[i], corners[(i + 1) % 3], point) == 0;
        if (is_flat) { /* the point lies on that edge */
            const uint32_t twin = triangles->twin[outer[i]];
            turn(triangles, outer[i]);
            push(triangles, half_before(outer[i]));
            push(triangles, half_next(twin));
        } else {
            push(triangles, outer[i]);
        }
    }
    settle(triangles);
}

void triangles_make(struct triangles *out, const int16_t (*points)[2], uint32_t count)
{
    static const int32_t frame[TRIANGLES_FRAME][2] = {{-FRAME_REACH, -FRAME_REACH},
                                                      {FRAME_REACH, -FRAME_REACH},
                                                      {FRAME_REACH, FRAME_REACH},
                                                      {-FRAME_REACH, FRAME_REACH}};
    const size_t halves = 6 * ((size_t)count + 1);
    *out = (struct triangles){.point_count = count + TRIANGLES_FRAME};
    out->points = grow_zeroed(out->point_count, sizeof *out->points);
    out->leaving = grow_zeroed(out->point_count, sizeof *out->leaving);
    out->origin = grow_zeroed(halves, sizeof *out->origin);
    out->twin = grow_zeroed(halves, sizeof *out->twin);
    out->is_fixed = grow_zeroed(halves, sizeof *out->is_fixed);
    memcpy(out->points, frame, sizeof frame);
    for (uint32_t i = 0; i < count; i++) {
        out->points[triangles_point(i)][0] = points[i][0];
        out->points[triangles_point(i)][1] = points[i][1];
    }
    add_triangle(out, 0, 1, 2);
    add_triangle(out, 0, 2, 3);
    for (uint32_t half = 0; half < 6; half++)
        join(out, half, TRIANGLES_NONE, false);
    join(out, 2, 3, false);
    for (uint32_t i = 0; i < count; i++)
        put_in(out, triangles_point(i));
}

void triangles_free(struct triangles *triangles)
{
    free(triangles->points);
    free(triangles->origin);
    free(triangles->twin);
    free(triangles->is_fixed);
    free(triangles->leaving);
    free(triangles->stack);
    *triangles = (struct triangles){0};
}

/* Lines -------------------------------------------------------------------------------------- */

/* Round a point, counter-clockwise: no point but the frame's is on the border. */
static uint32_t around(const struct triangles *triangles, uint32_t half)
{
    return triangles->twin[half_before(half)];
}

static bool is_ahead(const struct triangles *triangles, uint32_t from, uint32_t to, uint32_t point)
{
    const int32_t *p = triangles->points[from], *q = triangles->points[to], *r = triangles->points[point];
    return (int64_t)(q[0] - p[0]) * (r[0] - p[0]) + (int64_t)(q[1] - p[1]) * (r[1] - p[1]) > 0;
}

uint32_t triangles_along(const struct triangles *triangles, uint32_t from, uint32_t to)
{
    const uint32_t first = triangles->leaving[from];
    uint32_t half = first;
    do {
        const uint32_t point = end_of(triangles, half);
        if (triangles_side(triangles, from, to, point) == 0 && is_ahead(triangles, from, to, point)) return half;
        half = around(triangles, half);
    } while (half != first);
    return TRIANGLES_NONE;
}

/* The edge that a line crosses first: from its right to its left. */
static uint32_t first_crossed(const struct triangles *triangles, uint32_t from, uint32_t to)
{
    uint32_t half = triangles->leaving[from];
    while (triangles_side(triangles, from, to, end_of(triangles, half)) >= 0 ||
           triangles_side(triangles, from, to, apex(triangles, half)) <= 0)
        half = around(triangles, half);
    return half_next(half);
}

/* Round the frame's points there is a border: then the other way round. */
static uint32_t edge_between(const struct triangles *triangles, uint32_t from, uint32_t to)
{
    uint32_t half = triangles->leaving[from];
    while (end_of(triangles, half) != to && triangles->twin[half_before(half)] != TRIANGLES_NONE)
        half = around(triangles, half);
    while (end_of(triangles, half) != to)
        half = half_next(triangles->twin[half]);
    return half;
}

/* Edges by their ends, as those that turn get other half-edges. */
struct crossing {
    uint32_t (*edges)[2];
    size_t first, count, capacity;
};

static void cross(struct crossing *crossing, uint32_t right, uint32_t left)
{
    crossing->edges = grow(crossing->edges, crossing->count, &crossing->capacity, sizeof *crossing->edges);
    crossing->edges[crossing->count][0] = right;
    crossing->edges[crossing->count++][1] = left;
}

/* From one edge to the next until a point lies on the line, which is returned; TRIANGLES_NONE: another line is in the
 * way. */
static uint32_t find_crossed(const struct triangles *triangles, uint32_t from, uint32_t to, struct crossing *crossing)
{
    uint32_t half = first_crossed(triangles, from, to);
    for (;;) {
        if (triangles->is_fixed[half]) return TRIANGLES_NONE;
        cross(crossing, triangles->origin[half], end_of(triangles, half));
        const uint32_t twin = triangles->twin[half], point = apex(triangles, twin);
        const int64_t side = triangles_side(triangles, from, to, point);
        if (side == 0) return point;
        half = side > 0 ? half_next(twin) : half_before(twin);
    }
}

static bool are_apart(int64_t a, int64_t b)
{
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

/* Turns each edge that can; one whose four corners are not convex waits for others. */
static void turn_crossed(struct triangles *triangles, uint32_t from, uint32_t to, struct crossing *crossing)
{
    while (crossing->first < crossing->count) {
        const uint32_t p = crossing->edges[crossing->first][0], q = crossing->edges[crossing->first][1];
        const uint32_t half = edge_between(triangles, p, q);
        const uint32_t c = apex(triangles, half), d = apex(triangles, triangles->twin[half]);
        crossing->first++;
        if (!are_apart(triangles_side(triangles, d, c, p), triangles_side(triangles, d, c, q))) {
            cross(crossing, p, q);
            continue;
        }
        turn(triangles, half);
        if (are_apart(triangles_side(triangles, from, to, c), triangles_side(triangles, from, to, d)))
            cross(crossing, d, c);
    }
}

static void fix(struct triangles *triangles, uint32_t half)
{
    triangles->is_fixed[half] = triangles->is_fixed[triangles->twin[half]] = true;
}

bool triangles_fix(struct triangles *triangles, uint32_t from, uint32_t to)
{
    while (from != to) {
        uint32_t half = triangles_along(triangles, from, to);
        if (half == TRIANGLES_NONE) {
            struct crossing crossing = {0};
            const uint32_t end = find_crossed(triangles, from, to, &crossing);
            if (end != TRIANGLES_NONE) turn_crossed(triangles, from, end, &crossing);
            free(crossing.edges);
            if (end == TRIANGLES_NONE) return false;
            half = edge_between(triangles, from, end);
        }
        fix(triangles, half);
        from = end_of(triangles, half);
    }
    return true;
}

void triangles_settle(struct triangles *triangles)
{
    for (uint32_t half = 0; half < triangles->half_count; half++)
        if (half < triangles->twin[half]) push(triangles, half);
    settle(triangles);
}

uint32_t triangles_at(const struct triangles *triangles, int32_t x, int32_t y)
{
    for (uint32_t half = 0; half < triangles->half_count; half += 3) {
        bool is_in = true;
        for (uint32_t i = 0; i < 3 && is_in; i++) {
            const int32_t *p = triangles->points[triangles->origin[half + i]],
                          *q = triangles->points[end_of(triangles, half + i)];
            is_in = (int64_t)(q[0] - p[0]) * (y - p[1]) - (int64_t)(q[1] - p[1]) * (x - p[0]) >= 0;
        }
        if (is_in) return half / 3;
    }
    return TRIANGLES_NONE;
}
