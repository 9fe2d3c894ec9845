/* SPDX-License-Identifier: MIT
 *
 * Rings of vertices along the knot, each in the frame of the knot's direction and the torus's axis, which closes
 * without a twist. */
#include "scale_mesh.h"

#include "demo_vec.h"

/* Rings to a ring's vertices: what makes triangles of the tube, whose way is so much longer than it is around, even. */
static const double RINGS_PER_SIDE = 9.0;
static const double TORUS_M = 1.0, HOLE_M = 0.45, TUBE_M = 0.23, RIB_M = 0.02;
enum { ALONG = 2, ROUND = 3, RIBS = 40, TWISTS = 6, COLOURS = 8 };

static struct vec3 knot_at(double turn)
{
    const double radius_m = TORUS_M + HOLE_M * cos(ROUND * turn);
    return (struct vec3){radius_m * cos(ALONG * turn), HOLE_M * sin(ROUND * turn), radius_m * sin(ALONG * turn)};
}

/* On the tube: `turn` of 2 pi along the knot, `angle` of 2 pi around. */
static struct vec3 tube_at(double turn, double angle)
{
    const struct vec3 centre = knot_at(turn), axis = {TORUS_M * cos(ALONG * turn), 0.0, TORUS_M * sin(ALONG * turn)};
    const struct vec3 ahead = vec_unit(vec_sub(knot_at(turn + 1e-4), knot_at(turn - 1e-4)));
    const struct vec3 side = vec_unit(vec_cross(ahead, vec_sub(centre, axis))), out = vec_cross(side, ahead);
    const double radius_m = TUBE_M + RIB_M * cos(RIBS * turn) * cos(TWISTS * angle);
    return vec_add(centre, vec_add(vec_scale(out, radius_m * cos(angle)), vec_scale(side, radius_m * sin(angle))));
}

static void write_triangle(FILE *obj, long a, long b, long c)
{
    fprintf(obj, "f %ld %ld %ld\n", a + 1, b + 1, c + 1);
}

bool scale_mesh_write(FILE *obj, long triangles, const char *materials_name)
{
    const long sides = lround(sqrt((double)triangles / 2 / RINGS_PER_SIDE)), rings = triangles / 2 / sides;
    fprintf(obj, "# A knotted tube of %ld triangles; written by generate_scale\nmtllib %s\n", 2 * rings * sides,
            materials_name);
    for (long i = 0; i < rings; i++)
        for (long k = 0; k < sides; k++) {
            const struct vec3 at =
                tube_at(2 * DEMO_PI * (double)i / (double)rings, 2 * DEMO_PI * (double)k / (double)sides);
            fprintf(obj, "v %.6f %.6f %.6f\n", at.x, at.y, at.z);
        }
    for (long i = 0, colour = -1; i < rings; i++) {
        if (colour != i * RIBS / rings % COLOURS) fprintf(obj, "usemtl c%ld\n", colour = i * RIBS / rings % COLOURS);
        const long here = i * sides, next = (i + 1) % rings * sides;
        for (long k = 0; k < sides; k++) {
            const long beside = (k + 1) % sides;
            write_triangle(obj, here + k, next + beside, next + k);
            write_triangle(obj, here + k, here + beside, next + beside);
        }
    }
    return !ferror(obj);
}

bool scale_mesh_materials(FILE *mtl)
{
    for (int i = 0; i < COLOURS; i++) {
        const double hue = 2 * DEMO_PI * i / COLOURS;
        fprintf(mtl, "newmtl c%d\nKd %.3f %.3f %.3f\n", i, 0.6 + 0.3 * cos(hue), 0.6 + 0.3 * cos(hue - 2.1),
                0.6 + 0.3 * cos(hue + 2.1));
    }
    return !ferror(mtl);
}

bool scale_mesh_flight(FILE *cam, int frames)
{
    for (int i = 0; i < frames; i++) {
        const double turn = 2 * DEMO_PI * i / frames, away_m = 2.9 + 0.5 * cos(2 * turn);
        fprintf(cam, "%.6f %.6f %.6f 0.000000 0.000000 0.000000\n", away_m * cos(turn), 1.4 * sin(2 * turn),
                away_m * sin(turn));
    }
    return !ferror(cam);
}
