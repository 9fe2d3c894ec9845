/* SPDX-License-Identifier: MIT
 *
 * Rooms by the numbers of their row and column: what a room has is drawn from a hash of both, so it does not depend on
 * the building's size. Faces are quads, counter-clockwise seen from inside. */
#include "scale_rooms.h"

#include <math.h>
#include <stdint.h>

#define PI 3.14159265358979323846

static const double PITCH_M = 4.0, HALF_M = 1.9, HEIGHT_M = 3.0, DOOR_HALF_M = 0.6, DOOR_HEIGHT_M = 2.2;
static const double EYE_HEIGHT_M = 1.6, LOOK_AHEAD_M = 1.3;

/* The building while it is written: numbers of vertices are those of the file. */
struct building {
    FILE *obj;
    int n;
    long vertices;
};

/* The middle of a room, on its floor. */
struct place {
    double x, z;
};

/* One of a few numbers that look random, `what` telling them apart. */
static uint32_t hash(int column, int row, int what)
{
    uint32_t mixed = (uint32_t)column * 0x9E3779B1u ^ (uint32_t)row * 0x85EBCA77u ^ (uint32_t)what * 0xC2B2AE3Du;
    mixed = (mixed ^ mixed >> 15) * 0x2C1B3C6Du;
    mixed = (mixed ^ mixed >> 12) * 0x297A2D39u;
    return mixed ^ mixed >> 15;
}

/* 0 to below 1. */
static double fraction(int column, int row, int what)
{
    return (double)(hash(column, row, what) >> 8) / (1 << 24);
}

static void quad(struct building *building, const double corners[4][3])
{
    for (int k = 0; k < 4; k++)
        fprintf(building->obj, "v %.6f %.6f %.6f\n", corners[k][0], corners[k][1], corners[k][2]);
    building->vertices += 4;
    fprintf(building->obj, "f %ld %ld %ld %ld\n", building->vertices - 3, building->vertices - 2,
            building->vertices - 1, building->vertices);
}

/* Upright, from a to b along its lower edge; seen from the left of that way. */
static void wall(struct building *building, struct place a, struct place b, double low_m, double high_m)
{
    const double corners[4][3] = {{a.x, low_m, a.z}, {b.x, low_m, b.z}, {b.x, high_m, b.z}, {a.x, high_m, a.z}};
    quad(building, corners);
}

/* Level, `outline` counter-clockwise seen from above. */
static void slab(struct building *building, const struct place outline[4], double y_m, bool faces_up)
{
    double corners[4][3];
    for (int k = 0; k < 4; k++) {
        const struct place at = outline[faces_up ? k : 3 - k];
        corners[k][0] = at.x;
        corners[k][1] = y_m;
        corners[k][2] = at.z;
    }
    quad(building, corners);
}

static void rectangle(struct building *building, double x0, double z0, double x1, double z1, double y_m, bool faces_up)
{
    const struct place outline[4] = {{x0, z0}, {x0, z1}, {x1, z1}, {x1, z0}};
    slab(building, outline, y_m, faces_up);
}

/* The sides of what stands on such an outline, seen from outside. */
static void sides(struct building *building, const struct place outline[4], double low_m, double high_m)
{
    for (int k = 0; k < 4; k++)
        wall(building, outline[k], outline[(k + 1) % 4], low_m, high_m);
}

/* Furniture -------------------------------------------------------------------------------------- */

static void box(struct building *building, struct place centre, double w_m, double d_m, double h_m, double turn)
{
    const double c = cos(turn), s = sin(turn);
    struct place outline[4];
    for (int k = 0; k < 4; k++) {
        const double x = k < 2 ? -w_m / 2 : w_m / 2, z = k == 0 || k == 3 ? -d_m / 2 : d_m / 2;
        outline[k] = (struct place){centre.x + c * x + s * z, centre.z - s * x + c * z};
    }
    sides(building, outline, 0.0, h_m);
    slab(building, outline, h_m, true);
}

static void table(struct building *building, struct place centre)
{
    const double w_m = 1.0, d_m = 0.8, inset_m = 0.04, leg_m = 0.08, low_m = 0.72, high_m = 0.8;
    const double x0 = centre.x - w_m / 2, x1 = centre.x + w_m / 2, z0 = centre.z - d_m / 2, z1 = centre.z + d_m / 2;
    const struct place top[4] = {{x0, z0}, {x0, z1}, {x1, z1}, {x1, z0}};
    sides(building, top, low_m, high_m);
    slab(building, top, high_m, true);
    slab(building, top, low_m, false);
    for (int k = 0; k < 4; k++) {
        const double x = k < 2 ? x0 + inset_m : x1 - inset_m - leg_m;
        const double z = k == 0 || k == 3 ? z0 + inset_m : z1 - inset_m - leg_m;
        const struct place leg[4] = {{x, z}, {x, z + leg_m}, {x + leg_m, z + leg_m}, {x + leg_m, z}};
        sides(building, leg, 0.0, low_m);
    }
}

/* Each in a quarter of its own, so that the ways from door to door are clear. */
static void furnish(struct building *building, int column, int row, struct place centre)
{
    const uint32_t kind = hash(column, row, 2);
    for (unsigned k = 0; k < 1 + (kind & 1); k++) {
        const int what = 10 * (1 + (int)k);
        const struct place at = {centre.x + 1.25, centre.z + (k ? -1.2 : 1.2)};
        box(building, at, 0.45 + 0.35 * fraction(column, row, what), 0.4 + 0.15 * fraction(column, row, what + 1),
            0.4 + 0.7 * fraction(column, row, what + 2), 2 * PI * fraction(column, row, what + 3));
    }
    if (kind >> 1 & 1) {
        const struct place at = {centre.x - 1.15, centre.z + (kind >> 2 & 1 ? -1.15 : 1.15)};
        table(building, at);
    }
}

/* Rooms ------------------------------------------------------------------------------------------ */

static bool in_suite(int column, int row)
{
    return column < SCALE_SUITE && row < SCALE_SUITE;
}

/* The walk's way: from (0, 0) in turns one room along, one down. */
static bool on_way(int column, int row)
{
    return in_suite(column, row) && (column == row || column == row + 1);
}

/* Between a room and the next one of its row, or with `down` of its column. */
static bool has_door(const struct building *building, int column, int row, bool down)
{
    const int next_column = column + !down, next_row = row + down;
    if (column < 0 || row < 0 || next_column >= building->n || next_row >= building->n) return false;
    if (in_suite(column, row) != in_suite(next_column, next_row)) return false;
    if (on_way(column, row) && on_way(next_column, next_row)) return true;
    return hash(column, row, down) % 8 < 5;
}

/* A point of a room's frame turned by quarters: wall 0 is at +x. */
static struct place turned(struct place centre, int quarters, double out_m, double along_m)
{
    static const int COS[4] = {1, 0, -1, 0}, SIN[4] = {0, 1, 0, -1};
    const int c = COS[quarters], s = SIN[quarters];
    return (struct place){centre.x + c * out_m - s * along_m, centre.z + s * out_m + c * along_m};
}

static void room_wall(struct building *building, struct place centre, int quarters, bool has_opening)
{
    const struct place left = turned(centre, quarters, HALF_M, -HALF_M),
                       right = turned(centre, quarters, HALF_M, HALF_M);
    const struct place a = turned(centre, quarters, HALF_M, -DOOR_HALF_M);
    const struct place b = turned(centre, quarters, HALF_M, DOOR_HALF_M);
    if (!has_opening) {
        wall(building, left, right, 0.0, HEIGHT_M);
        return;
    }
    wall(building, left, a, 0.0, HEIGHT_M);
    wall(building, b, right, 0.0, HEIGHT_M);
    wall(building, a, b, DOOR_HEIGHT_M, HEIGHT_M);
}

/* Through the wall between two rooms. */
static void passage(struct building *building, struct place centre, int quarters)
{
    const double out_m = PITCH_M - HALF_M;
    const struct place a = turned(centre, quarters, HALF_M, -DOOR_HALF_M);
    const struct place b = turned(centre, quarters, HALF_M, DOOR_HALF_M);
    const struct place a_out = turned(centre, quarters, out_m, -DOOR_HALF_M);
    const struct place b_out = turned(centre, quarters, out_m, DOOR_HALF_M);
    const struct place outline[4] = {a, b, b_out, a_out};
    wall(building, a, a_out, 0.0, DOOR_HEIGHT_M);
    wall(building, b_out, b, 0.0, DOOR_HEIGHT_M);
    slab(building, outline, DOOR_HEIGHT_M, false);
    slab(building, outline, 0.0, true);
}

static void room(struct building *building, int column, int row)
{
    const struct place centre = {PITCH_M * column, PITCH_M * row};
    for (int k = 0; k < 4; k++) {
        const double x = centre.x + (k & 1 ? 0.0 : -HALF_M), z = centre.z + (k & 2 ? 0.0 : -HALF_M);
        rectangle(building, x, z, x + HALF_M, z + HALF_M, 0.0, true);
        rectangle(building, x, z, x + HALF_M, z + HALF_M, HEIGHT_M, false);
    }
    const bool doors[4] = {has_door(building, column, row, false), has_door(building, column, row, true),
                           has_door(building, column - 1, row, false), has_door(building, column, row - 1, true)};
    for (int quarters = 0; quarters < 4; quarters++)
        room_wall(building, centre, quarters, doors[quarters]);
    for (int quarters = 0; quarters < 2; quarters++)
        if (doors[quarters]) passage(building, centre, quarters);
    furnish(building, column, row, centre);
}

bool scale_rooms_write(FILE *obj, int n)
{
    struct building building = {obj, n, 0};
    fprintf(obj, "# %d x %d rooms; written by generate_scale\n", n, n);
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++)
            room(&building, column, row);
    return !ferror(obj);
}

/* The walk --------------------------------------------------------------------------------------- */

/* Where the way is after some rooms, corners rounded off. */
static struct place way_at(double rooms, double last)
{
    struct place sum = {0.0, 0.0};
    enum { STEPS = 9 };
    for (int i = 0; i < STEPS; i++) {
        double at = rooms + (i - STEPS / 2) * 0.06;
        at = at < 0.0 ? 0.0 : at > last ? last : at;
        const int whole = (int)at;
        const double rest = at - whole;
        sum.x += PITCH_M * ((whole + 1) / 2 + (whole % 2 ? 0.0 : rest)) / STEPS;
        sum.z += PITCH_M * (whole / 2 + (whole % 2 ? rest : 0.0)) / STEPS;
    }
    return sum;
}

bool scale_rooms_walk(FILE *cam, int n)
{
    const int suite = n < SCALE_SUITE ? n : SCALE_SUITE;
    const double last = 2.0 * (suite - 1) + 0.4;
    for (int i = 0; i < SCALE_FRAMES; i++) {
        const double at = 0.1 + (last - 0.5) * i / (SCALE_FRAMES - 1), sway = sin(2 * PI * i / 16);
        const struct place eye = way_at(at, last), ahead = way_at(at + LOOK_AHEAD_M / PITCH_M, last);
        fprintf(cam, "%.6f %.6f %.6f %.6f %.6f %.6f\n", eye.x, EYE_HEIGHT_M + 0.1 * sway, eye.z, ahead.x + 0.15 * sway,
                EYE_HEIGHT_M - 0.1 + 0.2 * sin(2 * PI * i / 23), ahead.z - 0.15 * sway);
    }
    return !ferror(cam);
}
