/* SPDX-License-Identifier: MIT
 *
 * A ball of rings, each vertex as far from the middle as its direction says: lobes in six directions, and ripples. */
#include "bench_solid.h"

#include "demo_vec.h"

enum { SIDES = 48, RINGS = 38, LOBES = 6 }; /* 2 * 48 * 38 triangles, those at both poles included */

static const struct lobe {
    struct vec3 to;
    double length_m, sharpness;
} lobes[LOBES] = {
    {{0.9, 0.5, 0.0}, 0.9, 12.0},     {{-1.0, 0.2, 0.1}, 0.7, 30.0},  {{0.55, -0.9, 0.35}, 0.8, 25.0},
    {{0.55, -0.9, -0.35}, 0.8, 25.0}, {{-0.6, -0.9, 0.4}, 0.8, 25.0}, {{-0.6, -0.9, -0.4}, 0.8, 25.0},
};
static const double BODY_M = 0.55, RIPPLE_M = 0.015;

/* Ring 0 and ring RINGS + 1 are the poles, before and behind. */
static struct vec3 vertex(int ring, int side)
{
    const double away = DEMO_PI * ring / (RINGS + 1), around = 2 * DEMO_PI * side / SIDES;
    const struct vec3 to = {cos(away), sin(away) * cos(around), sin(away) * sin(around)};
    double radius_m = BODY_M + RIPPLE_M * sin(13 * away) * cos(9 * around);
    for (int i = 0; i < LOBES; i++)
        radius_m += lobes[i].length_m * exp(lobes[i].sharpness * (vec_dot(to, vec_unit(lobes[i].to)) - 1.0));
    return vec_scale(to, radius_m);
}

static long index_of(int ring, int side)
{
    if (ring == 0) return 1;
    if (ring > RINGS) return 2 + RINGS * SIDES;
    return 2 + (ring - 1) * SIDES + side % SIDES;
}

/* Corners are pairs of ring and side; texture coordinates are a grid with a side more, where the picture's ends meet.
 */
static void write_triangle(FILE *obj, bool is_mapped, const int corners[3][2])
{
    fputc('f', obj);
    for (int i = 0; i < 3; i++) {
        fprintf(obj, " %ld", index_of(corners[i][0], corners[i][1]));
        if (is_mapped) fprintf(obj, "/%d", corners[i][0] * (SIDES + 1) + corners[i][1] + 1);
    }
    fputc('\n', obj);
}

static void write_band(FILE *obj, bool is_mapped, int ring)
{
    for (int side = 0; side < SIDES; side++) {
        if (ring < RINGS)
            write_triangle(obj, is_mapped, (const int[3][2]){{ring, side}, {ring + 1, side}, {ring + 1, side + 1}});
        if (ring > 0)
            write_triangle(obj, is_mapped, (const int[3][2]){{ring, side}, {ring + 1, side + 1}, {ring, side + 1}});
    }
}

static void write_vertices(FILE *obj)
{
    for (int ring = 0; ring <= RINGS + 1; ring++)
        for (int side = 0; side < (ring == 0 || ring > RINGS ? 1 : SIDES); side++) {
            const struct vec3 at = vertex(ring, side);
            fprintf(obj, "v %.6f %.6f %.6f\n", at.x, at.y, at.z);
        }
}

static void write_mapping(FILE *obj, const char *materials_name)
{
    fprintf(obj, "mtllib %s\nusemtl 0\n", materials_name);
    for (int ring = 0; ring <= RINGS + 1; ring++)
        for (int side = 0; side <= SIDES; side++)
            fprintf(obj, "vt %.6f %.6f\n", 4.0 * side / SIDES, 2.0 * ring / (RINGS + 1));
}

bool bench_solid_write(FILE *obj, const char *materials_name)
{
    fprintf(obj, "# A closed mesh of %d triangles; written by generate_bench\n", 2 * SIDES * RINGS);
    write_vertices(obj);
    if (materials_name) write_mapping(obj, materials_name);
    for (int ring = 0; ring <= RINGS; ring++)
        write_band(obj, materials_name != NULL, ring);
    return !ferror(obj);
}
