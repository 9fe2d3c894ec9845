/* SPDX-License-Identifier: MIT
 *
 * A triangulation of points with whole coordinates in which given lines are edges: constrained Delaunay, exact. No
 * point is added, so what is built of it meets in the given points and nowhere else. */
#ifndef SIM_LEVEL_TRIANGLES_H
#define SIM_LEVEL_TRIANGLES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TRIANGLES_FRAME = 4 }; /* points 0 to 3, which are round all others */
static const uint32_t TRIANGLES_NONE = UINT32_MAX;

/* Half-edges: 3t, 3t + 1 and 3t + 2 are those of triangle t, counter-clockwise. */
struct triangles {
    int32_t (*points)[2]; /* 16 bits each but for the frame's */
    uint32_t point_count;
    uint32_t *origin;  /* of each half-edge, the point that it begins at */
    uint32_t *twin;    /* the same edge the other way; TRIANGLES_NONE: the frame's */
    bool *is_fixed;    /* a line lies there */
    uint32_t *leaving; /* of each point a half-edge that begins there */
    uint32_t half_count;
    size_t half_capacity;
    uint32_t *stack; /* of edges that may have to turn */
    size_t stack_count, stack_capacity;
};

/* All points are different. */
void triangles_make(struct triangles *out, const int16_t (*points)[2], uint32_t count);
void triangles_free(struct triangles *triangles);

/* The number of a point that was given: behind the frame's. */
static inline uint32_t triangles_point(uint32_t given)
{
    return given + TRIANGLES_FRAME;
}

static inline uint32_t half_next(uint32_t half)
{
    return half % 3 == 2 ? half - 2 : half + 1;
}

static inline uint32_t half_before(uint32_t half)
{
    return half % 3 == 0 ? half + 2 : half - 1;
}

/* Above 0: the point c lies to the left of a -> b. */
int64_t triangles_side(const struct triangles *triangles, uint32_t a, uint32_t b, uint32_t c);

/* Makes a line an edge, or several if it passes through points. false: it crosses a line that is there, and ends before
 * that. */
bool triangles_fix(struct triangles *triangles, uint32_t from, uint32_t to);

/* When all lines are there: the best triangles that they leave. */
void triangles_settle(struct triangles *triangles);

/* The first edge of a line, and what is behind it: to be asked from its end on. TRIANGLES_NONE: no edge lies there. */
uint32_t triangles_along(const struct triangles *triangles, uint32_t from, uint32_t to);

/* The triangle in which a place lies, or on whose edge. */
uint32_t triangles_at(const struct triangles *triangles, int32_t x, int32_t y);

#endif
