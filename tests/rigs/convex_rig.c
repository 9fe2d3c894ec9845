/* SPDX-License-Identifier: MIT
 *
 * Every solid is the hull of its corners: a plane through three of them that leaves all the others behind
 * holds a face, whose corners are those on the plane, in order around it. */
#include "convex_rig.h"

#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS_MAX = 64 };
#define ON_PLANE 1e-9
#define GOLDEN 1.6180339887498949
#define PI 3.14159265358979323846

struct corners {
    double at[CORNERS_MAX][3];
    unsigned count;
};

/* Corners ------------------------------------------------------------------------------------ */

static void add(struct corners *corners, double x, double y, double z)
{
    const double at[3] = {x, y, z};
    memcpy(corners->at[corners->count++], at, sizeof at);
}

/* (+-a, +-b, +-c), each once. */
static void add_signed(struct corners *corners, double a, double b, double c)
{
    for (int signs = 0; signs < 8; signs++)
        if (!((signs & 1 && a == 0) || (signs & 2 && b == 0) || (signs & 4 && c == 0)))
            add(corners, signs & 1 ? -a : a, signs & 2 ? -b : b, signs & 4 ? -c : c);
}

static void add_turned_round(struct corners *corners, double a, double b, double c)
{
    add_signed(corners, a, b, c);
    add_signed(corners, b, c, a);
    add_signed(corners, c, a, b);
}

static void add_tetrahedron(struct corners *corners)
{
    add(corners, 1, 1, 1);
    add(corners, 1, -1, -1);
    add(corners, -1, 1, -1);
    add(corners, -1, -1, 1);
}

static void add_prism(struct corners *corners, struct random *random)
{
    const unsigned sides = (unsigned)random_in(random, 3, CORNERS_MAX / 2);
    const double half_height = 0.05 + random_unit(random);
    for (unsigned i = 0; i < sides; i++)
        for (int end = -1; end <= 1; end += 2)
            add(corners, sin(2 * PI * i / sides), half_height * end, cos(2 * PI * i / sides));
}

/* The eight corners first, so that the first three of a face are not in a line. */
static void add_box(struct corners *corners, struct random *random)
{
    const double half[3] = {0.2 + random_unit(random), 0.2 + random_unit(random), 0.2 + random_unit(random)};
    add_signed(corners, half[0], half[1], half[2]);
    for (int edge = 0; edge < 12; edge++)
        for (int i = 1; i <= 3; i++) {
            const int along = edge / 4, across = (along + 1) % 3, up = (along + 2) % 3;
            double at[3];
            at[along] = half[along] * (0.5 * i - 1 + 0.1 * random_unit(random));
            at[across] = edge & 1 ? half[across] : -half[across];
            at[up] = edge & 2 ? half[up] : -half[up];
            add(corners, at[0], at[1], at[2]);
        }
}

static void add_random(struct corners *corners, struct random *random)
{
    const unsigned count = (unsigned)random_in(random, 5, CORNERS_MAX);
    for (unsigned i = 0; i < count; i++) {
        const double height = 2 * random_unit(random) - 1, turn = 2 * PI * random_unit(random);
        const double across = sqrt(1 - height * height);
        add(corners, across * cos(turn), height, across * sin(turn));
    }
}

static void add_kind(struct corners *corners, struct random *random, unsigned kind)
{
    switch (kind) {
    case 0:
        add_tetrahedron(corners);
        return;
    case 1:
        add_signed(corners, 1, 1, 1);
        return;
    case 2:
        add_turned_round(corners, 1, 0, 0);
        return;
    case 3:
        add_signed(corners, 1, 1, 1);
        add_turned_round(corners, 0, 1 / GOLDEN, GOLDEN);
        return;
    case 4:
        add_turned_round(corners, 0, 1, GOLDEN);
        return;
    case 5:
        add_prism(corners, random);
        return;
    case 6:
        add_box(corners, random);
        return;
    default:
        add_random(corners, random);
    }
}

/* To radius 1 at most; one in three stays upright, with planes on the axes and level edges. */
static void turn(struct corners *corners, struct random *random)
{
    const bool upright = random_in(random, 0, 2) == 0;
    const double yaw = upright ? 0 : 2 * PI * random_unit(random), pitch = upright ? 0 : PI * random_unit(random);
    double longest = 0;
    for (unsigned i = 0; i < corners->count; i++)
        longest = fmax(longest, sqrt(vec3_dot(corners->at[i], corners->at[i])));
    for (unsigned i = 0; i < corners->count; i++) {
        double *p = corners->at[i];
        const double x = p[0] * cos(yaw) + p[2] * sin(yaw), z = p[2] * cos(yaw) - p[0] * sin(yaw);
        const double y = p[1] * cos(pitch) - z * sin(pitch);
        p[2] = (p[1] * sin(pitch) + z * cos(pitch)) / longest;
        p[0] = x / longest;
        p[1] = y / longest;
    }
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Faces -------------------------------------------------------------------------------------- */

/* The unit normal of the plane through three corners. false: they lie in a line. */
static bool normal_of(const struct corners *corners, unsigned i, unsigned j, unsigned k, double n[3])
{
    double a[3], b[3];
    for (int t = 0; t < 3; t++) {
        a[t] = corners->at[j][t] - corners->at[i][t];
        b[t] = corners->at[k][t] - corners->at[i][t];
    }
    cross(a, b, n);
    const double length = sqrt(vec3_dot(n, n));
    for (int t = 0; t < 3; t++)
        n[t] /= length;
    return length > ON_PLANE;
}

/* The corners on the plane; 0 unless i, j, k are the first three of them and all others lie behind. */
static unsigned face_on(const struct corners *corners, unsigned i, unsigned j, unsigned k, const double n[3],
                        unsigned on[CORNERS_MAX])
{
    const double d = vec3_dot(n, corners->at[i]);
    unsigned count = 0;
    for (unsigned v = 0; v < corners->count; v++) {
        const double off = vec3_dot(n, corners->at[v]) - d;
        if (off > ON_PLANE) return 0;
        if (off >= -ON_PLANE) on[count++] = v;
    }
    const unsigned third = j > k ? j : k, second = j < k ? j : k;
    return on[0] == i && on[1] == second && on[2] == third ? count : 0;
}

/* In order around the face's middle, counter-clockwise seen from in front. */
static void add_face(struct mesh *mesh, const struct corners *corners, const double n[3], unsigned *on, unsigned count)
{
    double middle[3] = {0}, face[CORNERS_MAX][3], angles[CORNERS_MAX], side[3], up[3];
    for (unsigned i = 0; i < count; i++)
        for (int t = 0; t < 3; t++)
            middle[t] += corners->at[on[i]][t] / count;
    for (int t = 0; t < 3; t++)
        side[t] = corners->at[on[0]][t] - middle[t];
    cross(n, side, up);
    for (unsigned i = 0; i < count; i++) {
        double from[3];
        for (int t = 0; t < 3; t++)
            from[t] = corners->at[on[i]][t] - middle[t];
        const double angle = atan2(vec3_dot(from, up), vec3_dot(from, side));
        unsigned at = i;
        for (; at > 0 && angles[at - 1] > angle; at--) {
            angles[at] = angles[at - 1];
            memcpy(face[at], face[at - 1], sizeof face[at]);
        }
        angles[at] = angle;
        memcpy(face[at], corners->at[on[i]], sizeof face[at]);
    }
    mesh_rig_add(mesh, (const double(*)[3])face, count);
}

void convex_rig_add(struct mesh *mesh, struct random *random, unsigned kind)
{
    struct corners corners = {.count = 0};
    add_kind(&corners, random, kind);
    turn(&corners, random);
    for (unsigned i = 0; i < corners.count; i++)
        for (unsigned j = i + 1; j < corners.count; j++)
            for (unsigned k = i + 1; k < corners.count; k++) {
                double n[3];
                unsigned on[CORNERS_MAX], count;
                if (k == j || !normal_of(&corners, i, j, k, n)) continue;
                if ((count = face_on(&corners, i, j, k, n, on)) > 0) add_face(mesh, &corners, n, on, count);
            }
}

struct viewpoint convex_rig_viewpoint(struct random *random)
{
    const double distance_m = 6 * random_unit(random), height = 2 * random_unit(random) - 1;
    const double turn = 2 * PI * random_unit(random), across = sqrt(1 - height * height);
    struct viewpoint viewpoint = {
        .eye_m = {distance_m * across * cos(turn), distance_m * height, distance_m * across * sin(turn)}, .line = 1};
    for (int i = 0; i < 3; i++)
        viewpoint.target_m[i] = 1.2 * random_unit(random) - 0.6;
    if (random_in(random, 0, 3) == 0) {
        viewpoint.target_m[0] = viewpoint.eye_m[0] + 1e-3 * random_unit(random);
        viewpoint.target_m[1] = viewpoint.eye_m[1] + 1e-3 * random_unit(random);
    }
    return viewpoint;
}
