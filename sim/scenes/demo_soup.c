/* SPDX-License-Identifier: MIT
 *
 * The list of polygons, and cutting them: by planes and by prisms. Pieces of a
 * cut share the corners that the cut made, so that no crack opens between them. */
#include "demo_soup.h"

#include <stdio.h>
#include <stdlib.h>

static const double on_plane_m = 0.001;

void *demo_realloc(void *memory, size_t size_b)
{
    void *grown = realloc(memory, size_b);
    if (!grown) {
        fputs("generate_demo: out of memory\n", stderr);
        exit(EXIT_FAILURE);
    }
    return grown;
}

double soup_random(struct soup *soup)
{
    /* xorshift32 (Marsaglia): any seed but 0 */
    uint32_t x = soup->random;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    soup->random = x;
    return x / 4294967296.0;
}

void soup_add_piece(struct soup *soup, const struct polygon *piece)
{
    struct polygon copy = *piece; /* it may live in the array that is about to move */
    if (soup->count == soup->capacity) {
        soup->capacity = soup->capacity ? 2 * soup->capacity : 1024;
        soup->polygons = demo_realloc(soup->polygons, soup->capacity * sizeof *soup->polygons);
    }
    soup->polygons[soup->count++] = copy;
}

void soup_add(struct soup *soup, const struct vec3 *corner, int count, int material)
{
    struct polygon polygon = {.count = count, .material = material};
    struct vec3 normal = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        polygon.corner[i] = corner[i];
        normal = vec_add(normal, vec_cross(vec_sub(corner[i], corner[0]), vec_sub(corner[(i + 1) % count], corner[0])));
    }
    polygon.normal = vec_unit(normal);
    polygon.grain = 2 * soup_random(soup) - 1;
    soup_add_piece(soup, &polygon);
}

void soup_free(struct soup *soup)
{
    free(soup->polygons);
    *soup = (struct soup){0};
}

double polygon_area(const struct polygon *polygon)
{
    double twice = 0;
    for (int i = 2; i < polygon->count; i++) {
        struct vec3 a = vec_sub(polygon->corner[i - 1], polygon->corner[0]);
        struct vec3 b = vec_sub(polygon->corner[i], polygon->corner[0]);
        twice += vec_dot(vec_cross(a, b), polygon->normal);
    }
    return twice / 2;
}

struct vec3 polygon_point(const struct polygon *polygon, double u, double v)
{
    double left = u * polygon_area(polygon);
    int last = polygon->count - 1;
    for (int i = 2;; i++) {
        struct vec3 a = vec_sub(polygon->corner[i - 1], polygon->corner[0]);
        struct vec3 b = vec_sub(polygon->corner[i], polygon->corner[0]);
        double area = vec_dot(vec_cross(a, b), polygon->normal) / 2;
        if (left < area || i == last) {
            /* what u has left over within this triangle, folded to uniform by the square root */
            double s = sqrt(fmin(1, fmax(0, left / area)));
            struct vec3 in = vec_add(vec_scale(a, s * (1 - v)), vec_scale(b, s * v));
            return vec_add(polygon->corner[0], in);
        }
        left -= area;
    }
}

struct polygon polygon_clip(const struct polygon *polygon, struct plane plane)
{
    struct polygon part = *polygon;
    double distance[POLYGON_CORNERS];
    int inside = 0;
    part.count = 0;
    for (int i = 0; i < polygon->count; i++) {
        distance[i] = plane_distance(plane, polygon->corner[i]);
        if (fabs(distance[i]) < on_plane_m) distance[i] = 0;
        inside += distance[i] > 0;
    }
    for (int i = 0; inside && i < polygon->count; i++) {
        int next = (i + 1) % polygon->count;
        double d0 = distance[i], d1 = distance[next];
        if (d0 >= 0) part.corner[part.count++] = polygon->corner[i];
        if (d0 * d1 < 0) {
            /* from the inner end always, so that both pieces of the cut get the same point */
            int from = d0 > 0 ? i : next, to = d0 > 0 ? next : i;
            double t = distance[from] / (distance[from] - distance[to]);
            part.corner[part.count++] = vec_lerp(polygon->corner[from], polygon->corner[to], t);
        }
    }
    return part;
}

static struct plane plane_flip(struct plane plane)
{
    return (struct plane){vec_scale(plane.normal, -1), -plane.offset};
}

struct plane plane_towards(struct vec3 normal, struct vec3 on, struct vec3 inside)
{
    struct plane plane = {vec_unit(normal), 0};
    plane.offset = vec_dot(plane.normal, on);
    return plane_distance(plane, inside) < 0 ? plane_flip(plane) : plane;
}

struct prism prism_sweep(const struct vec3 *outline, int count, struct vec3 axis)
{
    struct prism prism = {.count = count};
    struct vec3 middle = {0, 0, 0};
    for (int i = 0; i < count; i++)
        middle = vec_add(middle, vec_scale(outline[i], 1.0 / count));
    for (int i = 0; i < count; i++) {
        struct vec3 along = vec_sub(outline[(i + 1) % count], outline[i]);
        prism.plane[i] = plane_towards(vec_cross(along, axis), outline[i], middle);
    }
    return prism;
}

struct polygon polygon_clip_prism(const struct polygon *polygon, const struct prism *prism)
{
    struct polygon inside = *polygon;
    if (polygon->count + prism->count > POLYGON_CORNERS) inside.count = 0;
    for (int i = 0; i < prism->count && inside.count; i++)
        inside = polygon_clip(&inside, prism->plane[i]);
    return inside;
}

void soup_cut(struct soup *soup, size_t index, const struct prism *prism)
{
    struct polygon rest = soup->polygons[index], inside = polygon_clip_prism(&rest, prism);
    if (!inside.count) return;
    for (int i = 0; i < prism->count; i++) {
        struct polygon outside = polygon_clip(&rest, plane_flip(prism->plane[i]));
        if (!outside.count) continue;
        soup_add_piece(soup, &outside);
        rest = polygon_clip(&rest, prism->plane[i]);
    }
    soup->polygons[index] = inside;
}
