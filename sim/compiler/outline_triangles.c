/* SPDX-License-Identifier: MIT
 *
 * The best cut of corners i to j is the best triangle on that chord with the best cuts on its other two sides. That is
 * cubic, so large outlines are halved by chords first. */
#include "compiler/outline_triangles.h"

#include "base/grow.h"
#include "base/vec3.h"

#include <float.h>
#include <stdlib.h>

enum { CORNERS_MAX = 48 };

/* How good a cut is: its worst triangle decides, and all of them where that is the same. */
struct quality {
    double least, sum;
    uint32_t apex; /* of the triangle on the chord */
};

struct cutting {
    const struct outline *outline;
    double normal[3];
    uint32_t (*triangles)[3]; /* the next one's place */
};

static void to_vector(struct grid_point point, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (double)point.q8[k];
}

/* Twice the area as a vector. Differences have 25 bits, so this is exact. */
static void area_of(const struct outline *outline, const uint32_t corners[3], double out[3])
{
    double a[3], b[3], c[3];
    to_vector(outline->corners[corners[0]], a);
    to_vector(outline->corners[corners[1]], b);
    to_vector(outline->corners[corners[2]], c);
    vec3_sub(b, b, a);
    vec3_sub(c, c, a);
    for (int k = 0; k < 3; k++)
        out[k] = b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3];
}

/* Half of the outline's own area, as a vector of length 1. */
static void find_normal(struct cutting *cutting)
{
    double sum[3] = {0, 0, 0}, length;
    for (uint32_t i = 1; i + 1 < cutting->outline->count; i++) {
        double area[3];
        area_of(cutting->outline, (const uint32_t[3]){0, i, i + 1}, area);
        for (int k = 0; k < 3; k++)
            sum[k] += area[k];
    }
    length = sqrt(vec3_dot(sum, sum));
    for (int k = 0; k < 3; k++)
        cutting->normal[k] = length > 0 ? sum[k] / length : 0;
}

/* Its height over its longest side, in such sides; negative: it is turned. */
static double thickness(const struct cutting *cutting, const uint32_t corners[3])
{
    double area[3], longest2 = 0;
    area_of(cutting->outline, corners, area);
    for (int k = 0; k < 3; k++) {
        double a[3], b[3];
        to_vector(cutting->outline->corners[corners[k]], a);
        to_vector(cutting->outline->corners[corners[(k + 1) % 3]], b);
        longest2 = fmax(longest2, vec3_distance2(a, b));
    }
    return longest2 > 0 ? vec3_dot(area, cutting->normal) / longest2 : 0;
}

/* The cut of list[i] .. list[j], whose parts are known. */
static struct quality best_cut(const struct cutting *cutting, const uint32_t *list, size_t count,
                               const struct quality *known, size_t i, size_t j)
{
    struct quality best = {.least = -DBL_MAX, .sum = -DBL_MAX};
    for (size_t k = i + 1; k < j; k++) {
        const struct quality *left = &known[i * count + k], *right = &known[k * count + j];
        const double own = thickness(cutting, (const uint32_t[3]){list[i], list[k], list[j]});
        const double least = fmin(own, fmin(left->least, right->least)), sum = own + left->sum + right->sum;
        if (least > best.least || (least == best.least && sum > best.sum))
            best = (struct quality){least, sum, (uint32_t)k};
    }
    return best;
}

static void write_triangle(struct cutting *cutting, uint32_t a, uint32_t b, uint32_t c)
{
    (*cutting->triangles)[0] = a, (*cutting->triangles)[1] = b, (*cutting->triangles)[2] = c;
    cutting->triangles++;
}

/* As deep as the outline has corners: a stack of chords instead of calls. */
static void write_cut(struct cutting *cutting, const uint32_t *list, size_t count, const struct quality *known)
{
    size_t chords[CORNERS_MAX + 1][2] = {{0, count - 1}}, left = 1;
    while (left) {
        const size_t i = chords[--left][0], j = chords[left][1];
        if (j < i + 2) continue;
        const size_t k = known[i * count + j].apex;
        write_triangle(cutting, list[i], list[k], list[j]);
        chords[left][0] = k, chords[left++][1] = j;
        chords[left][0] = i, chords[left++][1] = k;
    }
}

static void cut_best(struct cutting *cutting, const uint32_t *list, size_t count)
{
    struct quality *known = grow_zeroed(count * count, sizeof *known);
    for (size_t i = 0; i + 1 < count; i++)
        known[i * count + i + 1].least = DBL_MAX;
    for (size_t apart = 2; apart < count; apart++)
        for (size_t i = 0; i + apart < count; i++)
            known[i * count + i + apart] = best_cut(cutting, list, count, known, i, i + apart);
    write_cut(cutting, list, count, known);
    free(known);
}

/* Halves of `count` corners have few enough after some six levels at most. */
static void cut(struct cutting *cutting, const uint32_t *list, size_t count)
{
    if (count == 3) {
        write_triangle(cutting, list[0], list[1], list[2]);
        return;
    }
    if (count <= CORNERS_MAX) {
        cut_best(cutting, list, count);
        return;
    }
    struct outline part = {.count = count, .corners = grow_zeroed(count, sizeof *part.corners)};
    uint32_t *half = grow_zeroed(count, sizeof *half);
    for (size_t i = 0; i < count; i++)
        part.corners[i] = cutting->outline->corners[list[i]];
    const size_t from = outline_chord(&part), middle = count / 2;
    const size_t first[2] = {from, from + middle}, counts[2] = {middle + 1, count - middle + 1};
    for (int side = 0; side < 2; side++) {
        for (size_t i = 0; i < counts[side]; i++)
            half[i] = list[(first[side] + i) % count];
        cut(cutting, half, counts[side]);
    }
    free(half);
    outline_free(&part);
}

void outline_triangulate(const struct outline *outline, uint32_t (*triangles)[3])
{
    struct cutting cutting = {.outline = outline, .triangles = triangles};
    uint32_t *list = grow_zeroed(outline->count, sizeof *list);
    for (uint32_t i = 0; i < outline->count; i++)
        list[i] = i;
    find_normal(&cutting);
    cut(&cutting, list, outline->count);
    free(list);
}
