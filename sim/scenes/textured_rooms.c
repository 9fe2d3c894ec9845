/* SPDX-License-Identifier: MIT
 *
 * Quads with a picture each. A room is 8 x 3 x 6 m; a wall with a doorway divides it, and all of it is turned by a
 * few degrees, so that hardly a wall lies on the grid. */
#include "textured_rooms.h"

#include <math.h>

enum paint { BOARDS, BRICKS, WALLPAPER, PAINTING, RUG, PLASTER, WOOD, PAINTS };

static const struct {
    const char *name, *picture;
    double kd;
} paints[PAINTS] = {
    {"boards", "boards.png", 1.0},     {"bricks", "bricks.png", 1.0}, {"wallpaper", "wallpaper.png", 1.0},
    {"painting", "painting.jpg", 1.0}, {"rug", "rug.png", 1.0},       {"plaster", NULL, 0.92},
    {"wood", "boards.png", 0.7}};

/* A parallelogram from a corner along two edges, counter-clockwise; a picture covers across x down metres, or all of it
 * once where these are 0. */
struct quad {
    enum paint paint;
    double corner[3], right[3], up[3];
    double across_m, down_m;
};

static const struct quad quads[] = {
    {BOARDS, {-4, 0, 3}, {8, 0, 0}, {0, 0, -6}, 1.2, 1.2},
    {PLASTER, {-4, 3, -3}, {8, 0, 0}, {0, 0, 6}, 0, 0},
    {WALLPAPER, {-4, 0, -3}, {8, 0, 0}, {0, 3, 0}, 0.8, 0.8},
    {WALLPAPER, {4, 0, 3}, {-8, 0, 0}, {0, 3, 0}, 0.8, 0.8},
    {BRICKS, {-4, 0, 3}, {0, 0, -6}, {0, 3, 0}, 0.8, 0.6},
    {WALLPAPER, {4, 0, -3}, {0, 0, 6}, {0, 3, 0}, 0.8, 0.8},
    /* the dividing wall, 0.2 m thick, with a doorway from z = -0.6 to 0.6, 2.2 m high */
    {WALLPAPER, {0.1, 0, -0.6}, {0, 0, -2.4}, {0, 3, 0}, 0.8, 0.8},
    {WALLPAPER, {0.1, 0, 3}, {0, 0, -2.4}, {0, 3, 0}, 0.8, 0.8},
    {WALLPAPER, {0.1, 2.2, 0.6}, {0, 0, -1.2}, {0, 0.8, 0}, 0.8, 0.8},
    {BRICKS, {-0.1, 0, -3}, {0, 0, 2.4}, {0, 3, 0}, 0.8, 0.6},
    {BRICKS, {-0.1, 0, 0.6}, {0, 0, 2.4}, {0, 3, 0}, 0.8, 0.6},
    {BRICKS, {-0.1, 2.2, -0.6}, {0, 0, 1.2}, {0, 0.8, 0}, 0.8, 0.6},
    {WOOD, {-0.1, 0, -0.6}, {0.2, 0, 0}, {0, 2.2, 0}, 0.6, 0.6},
    {WOOD, {0.1, 0, 0.6}, {-0.2, 0, 0}, {0, 2.2, 0}, 0.6, 0.6},
    {WOOD, {-0.1, 2.2, -0.6}, {0.2, 0, 0}, {0, 0, 1.2}, 0.6, 0.6},
    /* paintings before the walls, a rug, a table */
    {PAINTING, {-3, 1.2, -2.97}, {1.8, 0, 0}, {0, 0.9, 0}, 0, 0},
    {PAINTING, {3.97, 1.3, -0.9}, {0, 0, 1.8}, {0, 0.9, 0}, 0, 0},
    {PAINTING, {0.13, 1.2, -1.2}, {0, 0, -1.4}, {0, 0.7, 0}, 0, 0},
    {RUG, {0.9, 0.02, 1.2}, {2.4, 0, 0}, {0, 0, -1.2}, 0, 0},
    {WOOD, {-3, 0.8, 1.4}, {1.2, 0, 0}, {0, 0, -0.8}, 0.6, 0.6},
    {WOOD, {-3, 0, 1.4}, {1.2, 0, 0}, {0, 0.8, 0}, 0.6, 0.6},
    {WOOD, {-1.8, 0, 0.6}, {-1.2, 0, 0}, {0, 0.8, 0}, 0.6, 0.6},
    {WOOD, {-1.8, 0, 1.4}, {0, 0, -0.8}, {0, 0.8, 0}, 0.6, 0.6},
    {WOOD, {-3, 0, 0.6}, {0, 0, 0.8}, {0, 0.8, 0}, 0.6, 0.6},
};
enum { QUADS = sizeof quads / sizeof *quads };

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void turn(const double at[3], double out[3])
{
    const double angle = 13.7 * 3.141592653589793 / 180;
    out[0] = at[0] * cos(angle) + at[2] * sin(angle);
    out[1] = at[1];
    out[2] = at[2] * cos(angle) - at[0] * sin(angle);
}

/* Whole micrometres, as float32 numbers, all their digits: every program reads the same rooms, whatever its numbers
 * are. */
static double float32_um(double at_m)
{
    return (double)(float)(round(at_m * 1e6) / 1e6);
}

static void write_quad(FILE *file, int index)
{
    const struct quad *quad = &quads[index];
    const double across = quad->across_m > 0 ? length(quad->right) / quad->across_m : 1;
    const double down = quad->down_m > 0 ? length(quad->up) / quad->down_m : 1;
    for (int k = 0; k < 4; k++) {
        const int right = k == 1 || k == 2, up = k >= 2;
        double at[3], turned[3];
        for (int axis = 0; axis < 3; axis++)
            at[axis] = quad->corner[axis] + right * quad->right[axis] + up * quad->up[axis];
        turn(at, turned);
        fprintf(file, "v %.17g %.17g %.17g\nvt %.6f %.6f\n", float32_um(turned[0]), float32_um(turned[1]),
                float32_um(turned[2]), right * across, up * down);
    }
    const int n = 4 * index;
    fprintf(file, "usemtl %s\nf %d/%d %d/%d %d/%d %d/%d\n", paints[quad->paint].name, n + 1, n + 1, n + 2, n + 2, n + 3,
            n + 3, n + 4, n + 4);
}

bool textured_write_obj(FILE *file)
{
    fputs("# Two rooms with textures; written by generate_textured\nmtllib textured.mtl\n", file);
    for (int i = 0; i < QUADS; i++)
        write_quad(file, i);
    return true;
}

bool textured_write_mtl(FILE *file)
{
    for (int i = 0; i < PAINTS; i++) {
        fprintf(file, "newmtl %s\nKd %.2f %.2f %.2f\n", paints[i].name, paints[i].kd, paints[i].kd, paints[i].kd);
        if (paints[i].picture) fprintf(file, "map_Kd %s\n", paints[i].picture);
    }
    return true;
}

/* Along a loop through the doorway and back, looking ahead. */
bool textured_write_cam(FILE *file)
{
    enum { FRAMES = 64 };
    const double turn_rad = 2 * 3.141592653589793 / FRAMES;
    fputs("# ex ey ez tx ty tz: a walk through both rooms\n", file);
    for (int i = 0; i < FRAMES; i++) {
        double eye[3] = {2.6 * cos(turn_rad * i), 1.6, 1.6 * sin(2 * turn_rad * i)}, at[3], eye_turned[3], at_turned[3];
        at[0] = 2.6 * cos(turn_rad * (i + 3));
        at[1] = 1.35 + 0.2 * sin(turn_rad * 3 * i);
        at[2] = 1.6 * sin(2 * turn_rad * (i + 3));
        turn(eye, eye_turned);
        turn(at, at_turned);
        fprintf(file, "%.4f %.4f %.4f %.4f %.4f %.4f\n", eye_turned[0], eye_turned[1], eye_turned[2], at_turned[0],
                at_turned[1], at_turned[2]);
    }
    return true;
}
