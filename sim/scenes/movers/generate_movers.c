/* SPDX-License-Identifier: MIT
 *
 * Writes movers.gltf and movers.cam: two rooms joined by a doorway, and five things that move in them. A ball flies
 * through the doorway and back; two bars turn through each other; a block slides through the wall between the rooms; a
 * crystal turns inside a pillar, of which it is the larger part. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { BYTES_MAX = 1 << 17, FRAMES = 48, KEYS_MAX = 16, MESHES_MAX = 16 };
static const float LENGTH_S = 4;

/* A stretch of the buffer. */
struct view {
    size_t at_b, size_b, count;
    float low[3], high[3];
};

struct mesh {
    struct view corners, indices;
    const char *colour;
};

static unsigned char bytes[BYTES_MAX];
static size_t used_b;
static struct mesh meshes[MESHES_MAX];
static size_t mesh_count;

static void put(const void *from, size_t size_b)
{
    if (used_b + size_b > BYTES_MAX) exit(EXIT_FAILURE);
    memcpy(bytes + used_b, from, size_b);
    used_b += size_b;
}

/* -- Meshes -------------------------------------------------------------------------------------------------------- */

static float corners[4096][3];
static uint16_t indices[8192];
static size_t corner_count, index_count;

static uint16_t corner(float x, float y, float z)
{
    const float at[3] = {x, y, z};
    memcpy(corners[corner_count], at, sizeof at);
    return (uint16_t)corner_count++;
}

static void triangle(uint16_t a, uint16_t b, uint16_t c)
{
    indices[index_count++] = a;
    indices[index_count++] = b;
    indices[index_count++] = c;
}

/* A rectangle of the plane across `axis`, seen from its positive side or from the other. */
static void rectangle(int axis, float at, float u0, float v0, float u1, float v1, bool from_positive)
{
    const float u[4] = {u0, u1, u1, u0}, v[4] = {v0, v0, v1, v1};
    uint16_t n[4];
    for (int i = 0; i < 4; i++) {
        float p[3];
        p[axis] = at;
        p[(axis + 1) % 3] = u[i];
        p[(axis + 2) % 3] = v[i];
        n[i] = corner(p[0], p[1], p[2]);
    }
    triangle(n[0], n[from_positive ? 1 : 2], n[from_positive ? 2 : 1]);
    triangle(n[0], n[from_positive ? 2 : 3], n[from_positive ? 3 : 2]);
}

static void box(float x0, float y0, float z0, float x1, float y1, float z1)
{
    rectangle(0, x0, y0, z0, y1, z1, false);
    rectangle(0, x1, y0, z0, y1, z1, true);
    rectangle(1, y0, z0, x0, z1, x1, false);
    rectangle(1, y1, z0, x0, z1, x1, true);
    rectangle(2, z0, x0, y0, x1, y1, false);
    rectangle(2, z1, x0, y0, x1, y1, true);
}

/* An octahedron whose triangles are divided `levels` times, on a ball. */
static void round_part(const float a[3], const float b[3], const float c[3], int levels, float radius)
{
    if (!levels) {
        triangle(corner(a[0] * radius, a[1] * radius, a[2] * radius),
                 corner(b[0] * radius, b[1] * radius, b[2] * radius),
                 corner(c[0] * radius, c[1] * radius, c[2] * radius));
        return;
    }
    const float *from[3] = {a, b, c};
    float middle[3][3];
    for (int i = 0; i < 3; i++) {
        float length = 0;
        for (int k = 0; k < 3; k++)
            middle[i][k] = from[i][k] + from[(i + 1) % 3][k];
        for (int k = 0; k < 3; k++)
            length += middle[i][k] * middle[i][k];
        for (int k = 0; k < 3; k++)
            middle[i][k] /= sqrtf(length);
    }
    round_part(a, middle[0], middle[2], levels - 1, radius);
    round_part(middle[0], b, middle[1], levels - 1, radius);
    round_part(middle[2], middle[1], c, levels - 1, radius);
    round_part(middle[0], middle[1], middle[2], levels - 1, radius);
}

static void ball(int levels, float radius)
{
    for (int i = 0; i < 8; i++) {
        const float x[3] = {i & 1 ? -1 : 1, 0, 0}, y[3] = {0, i & 2 ? -1 : 1, 0}, z[3] = {0, 0, i & 4 ? -1 : 1};
        const bool mirrored = (i & 1) ^ (i >> 1 & 1) ^ (i >> 2 & 1);
        if (mirrored)
            round_part(x, z, y, levels, radius);
        else
            round_part(x, y, z, levels, radius);
    }
}

static struct view view_of(const void *from, size_t count, size_t item_b)
{
    while (used_b % 4)
        bytes[used_b++] = 0;
    const struct view view = {.at_b = used_b, .size_b = count * item_b, .count = count};
    put(from, view.size_b);
    return view;
}

static void end_mesh(const char *colour)
{
    struct mesh *mesh = &meshes[mesh_count++];
    mesh->colour = colour;
    mesh->corners = view_of(corners, corner_count, sizeof corners[0]);
    mesh->indices = view_of(indices, index_count, sizeof indices[0]);
    for (int k = 0; k < 3; k++) {
        mesh->corners.low[k] = mesh->corners.high[k] = corners[0][k];
        for (size_t i = 1; i < corner_count; i++) {
            mesh->corners.low[k] = fminf(mesh->corners.low[k], corners[i][k]);
            mesh->corners.high[k] = fmaxf(mesh->corners.high[k], corners[i][k]);
        }
    }
    corner_count = index_count = 0;
}

/* The inside of a room from x0 to x1, with a doorway in the wall at `door`. */
static void add_room(float x0, float x1, bool door_at_x1, const char *walls, const char *floor)
{
    const float door = door_at_x1 ? x1 : x0, other = door_at_x1 ? x0 : x1;
    rectangle(0, other, 0, -2, 2.6f, 2, !door_at_x1 ? false : true);
    rectangle(0, door, 0, -2, 2.6f, -0.5f, !door_at_x1);
    rectangle(0, door, 0, 0.5f, 2.6f, 2, !door_at_x1);
    rectangle(0, door, 2, -0.5f, 2.6f, 0.5f, !door_at_x1);
    rectangle(2, -2, x0, 0, x1, 2.6f, true);
    rectangle(2, 2, x0, 0, x1, 2.6f, false);
    end_mesh(walls);
    rectangle(1, 0, -2, x0, 2, x1, true);
    end_mesh(floor);
    rectangle(1, 2.6f, -2, x0, 2, x1, false);
    end_mesh("0.8, 0.8, 0.75");
}

enum { STATIC_NODES = 9, MOVERS = 5 };

static void add_meshes(void)
{
    add_room(-4, -0.1f, true, "0.75, 0.6, 0.4", "0.35, 0.2, 0.12");
    add_room(0.1f, 4, false, "0.35, 0.5, 0.65", "0.3, 0.3, 0.3");
    rectangle(1, 0, -0.5f, -0.1f, 0.5f, 0.1f, true);
    rectangle(1, 2, -0.5f, -0.1f, 0.5f, 0.1f, false);
    rectangle(2, -0.5f, -0.1f, 0, 0.1f, 2, true);
    rectangle(2, 0.5f, -0.1f, 0, 0.1f, 2, false);
    end_mesh("0.5, 0.5, 0.4");
    box(-3.4f, 0, -1.7f, -2.4f, 0.7f, -0.9f);
    end_mesh("0.45, 0.25, 0.1");
    box(2.2f, 0, -0.3f, 2.8f, 2.6f, 0.3f);
    end_mesh("0.6, 0.55, 0.5");
    ball(2, 0.35f);
    end_mesh("0.8, 0.1, 0.05");
    box(-0.8f, -0.15f, -0.15f, 0.8f, 0.15f, 0.15f);
    end_mesh("0.1, 0.5, 0.1");
    box(-0.2f, -0.7f, -0.2f, 0.2f, 0.7f, 0.2f);
    end_mesh("0.8, 0.6, 0.05");
    box(-0.3f, -0.3f, -0.3f, 0.3f, 0.3f, 0.3f);
    end_mesh("0.1, 0.15, 0.7");
    ball(0, 0.55f);
    end_mesh("0.6, 0.1, 0.6");
}

/* -- Motion -------------------------------------------------------------------------------------------------------- */

struct motion {
    const char *name;
    struct view times, places, turns;
};

static struct motion motions[MOVERS];

/* Turns evenly about an axis, `turns` times, while it goes from one place to the other and back. */
static struct motion motion(const char *name, const float from[3], const float to[3], const float axis[3], int turns)
{
    const float length = sqrtf(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const int keys = 4 * turns + 1;
    float times[KEYS_MAX], places[KEYS_MAX][3], quaternions[KEYS_MAX][4];
    for (int i = 0; i < keys; i++) {
        const float t = (float)i / (float)(keys - 1), there = 1 - fabsf(2 * t - 1), half = (float)PI * t * (float)turns;
        times[i] = LENGTH_S * t;
        for (int k = 0; k < 3; k++) {
            places[i][k] = from[k] + there * (to[k] - from[k]);
            quaternions[i][k] = sinf(half) * axis[k] / length;
        }
        quaternions[i][3] = cosf(half);
    }
    struct motion out = {.name = name};
    out.times = view_of(times, (size_t)keys, sizeof times[0]);
    out.times.high[0] = LENGTH_S;
    out.places = view_of(places, (size_t)keys, sizeof places[0]);
    out.turns = view_of(quaternions, (size_t)keys, sizeof quaternions[0]);
    return out;
}

static void add_motions(void)
{
    motions[0] =
        motion("ball", (float[3]){-3, 1.2f, 0.1f}, (float[3]){1.8f, 0.9f, -0.05f}, (float[3]){0.2f, 0.3f, 1}, 2);
    motions[1] = motion("bar", (float[3]){-2, 1.4f, 1}, (float[3]){-2, 1.4f, 1}, (float[3]){0.1f, 1, 0.2f}, 1);
    motions[2] = motion("post", (float[3]){-2, 1.4f, 1}, (float[3]){-2, 1.5f, 1}, (float[3]){1, 0.1f, 0.4f}, 1);
    motions[3] = motion("block", (float[3]){-0.6f, 1, -1.2f}, (float[3]){0.6f, 1, -1.2f}, (float[3]){0, 1, 0.3f}, 1);
    motions[4] = motion("crystal", (float[3]){2.5f, 1.2f, 0}, (float[3]){2.5f, 1.6f, 0}, (float[3]){0.3f, 1, 0}, 1);
}

/* -- Files --------------------------------------------------------------------------------------------------------- */

static void write_base64(FILE *file)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (used_b % 3)
        bytes[used_b++] = 0;
    for (size_t i = 0; i < used_b; i += 3) {
        const unsigned three = (unsigned)bytes[i] << 16 | (unsigned)bytes[i + 1] << 8 | bytes[i + 2];
        for (int shift = 18; shift >= 0; shift -= 6)
            fputc(digits[three >> shift & 63], file);
    }
}

/* The sampler's accessors follow those of the meshes: times, places, turns. */
static void write_animation(FILE *file)
{
    fputs("  \"animations\": [{\"channels\": [", file);
    for (int i = 0; i < 2 * MOVERS; i++)
        fprintf(file, "%s\n    {\"sampler\": %d, \"target\": {\"node\": %d, \"path\": \"%s\"}}", i ? "," : "", i,
                STATIC_NODES + i / 2, i % 2 ? "rotation" : "translation");
    fputs("],\n   \"samplers\": [", file);
    for (int i = 0; i < 2 * MOVERS; i++) {
        const size_t first = 2 * mesh_count + 3 * (size_t)(i / 2);
        fprintf(file, "%s\n    {\"input\": %zu, \"output\": %zu}", i ? "," : "", first, first + 1 + (size_t)(i % 2));
    }
    fputs("]}],\n", file);
}

static void write_nodes(FILE *file)
{
    fputs("  \"nodes\": [", file);
    for (size_t i = 0; i < mesh_count; i++) {
        fprintf(file, "%s\n    {\"mesh\": %zu", i ? "," : "", i);
        if (i >= STATIC_NODES) {
            float at[3], turn[4];
            const struct motion *of = &motions[i - STATIC_NODES];
            memcpy(at, bytes + of->places.at_b, sizeof at);
            memcpy(turn, bytes + of->turns.at_b, sizeof turn);
            fprintf(file, ", \"name\": \"%s\", \"translation\": [%g, %g, %g]", of->name, (double)at[0], (double)at[1],
                    (double)at[2]);
        }
        fputs("}", file);
    }
    fputs("],\n  \"meshes\": [", file);
    for (size_t i = 0; i < mesh_count; i++)
        fprintf(
            file,
            "%s\n    {\"primitives\": [{\"attributes\": {\"POSITION\": %zu}, \"indices\": %zu, \"material\": %zu}]}",
            i ? "," : "", 2 * i, 2 * i + 1, i);
    fputs("],\n  \"materials\": [", file);
    for (size_t i = 0; i < mesh_count; i++)
        fprintf(file, "%s\n    {\"name\": \"%zu\", \"pbrMetallicRoughness\": {\"baseColorFactor\": [%s, 1]}}",
                i ? "," : "", i, meshes[i].colour);
    fputs("],\n", file);
}

static void write_accessor(FILE *file, const struct view *view, size_t index, int component, const char *type,
                           int bounds)
{
    fprintf(file, "%s\n    {\"bufferView\": %zu, \"componentType\": %d, \"count\": %zu, \"type\": \"%s\"",
            index ? "," : "", index, component, view->count, type);
    for (int end = 0; bounds && end < 2; end++) {
        fprintf(file, ", \"%s\": [", end ? "max" : "min");
        for (int k = 0; k < bounds; k++)
            fprintf(file, "%s%.9g", k ? ", " : "", (double)(end ? view->high[k] : view->low[k]));
        fputs("]", file);
    }
    fputs("}", file);
}

static void write_accessors(FILE *file)
{
    enum { FLOAT = 5126, SHORT = 5123 };
    size_t index = 0;
    fputs("  \"accessors\": [", file);
    for (size_t i = 0; i < mesh_count; i++) {
        write_accessor(file, &meshes[i].corners, index++, FLOAT, "VEC3", 3);
        write_accessor(file, &meshes[i].indices, index++, SHORT, "SCALAR", 0);
    }
    for (int i = 0; i < MOVERS; i++) {
        write_accessor(file, &motions[i].times, index++, FLOAT, "SCALAR", 1);
        write_accessor(file, &motions[i].places, index++, FLOAT, "VEC3", 0);
        write_accessor(file, &motions[i].turns, index++, FLOAT, "VEC4", 0);
    }
    fputs("],\n  \"bufferViews\": [", file);
    index = 0;
    for (size_t i = 0; i < mesh_count; i++)
        for (int k = 0; k < 2; k++) {
            const struct view *view = k ? &meshes[i].indices : &meshes[i].corners;
            fprintf(file, "%s\n    {\"buffer\": 0, \"byteOffset\": %zu, \"byteLength\": %zu}", index++ ? "," : "",
                    view->at_b, view->size_b);
        }
    for (int i = 0; i < 3 * MOVERS; i++) {
        const struct motion *of = &motions[i / 3];
        const struct view *view = i % 3 == 0 ? &of->times : i % 3 == 1 ? &of->places : &of->turns;
        fprintf(file, ",\n    {\"buffer\": 0, \"byteOffset\": %zu, \"byteLength\": %zu}", view->at_b, view->size_b);
    }
    fputs("],\n", file);
}

static void write_gltf(FILE *file)
{
    fputs("{\n  \"asset\": {\"version\": \"2.0\", \"generator\": \"generate_movers\"},\n  \"scene\": 0,\n"
          "  \"scenes\": [{\"nodes\": [",
          file);
    for (size_t i = 0; i < mesh_count; i++)
        fprintf(file, "%s%zu", i ? ", " : "", i);
    fputs("]}],\n", file);
    write_nodes(file);
    write_animation(file);
    write_accessors(file);
    fputs("  \"buffers\": [{\"uri\": \"data:application/octet-stream;base64,", file);
    write_base64(file);
    fprintf(file, "\", \"byteLength\": %zu}]\n}\n", used_b);
}

/* From the far corner of the first room through the doorway, and a look back from the second. */
static void write_cameras(FILE *file)
{
    static const double stops[][6] = {{-3.7, 1.5, 1.6, 0, 1.1, -0.4},   {-3.2, 1.7, -0.4, -1.5, 1.3, 0.8},
                                      {-2.2, 1.6, -0.6, 0, 1, -0.9},    {-0.9, 1.5, 0.1, 2, 1.2, -0.1},
                                      {0.6, 1.5, 0.25, 2.6, 1.3, -0.1}, {1.6, 1.6, 1.5, 1, 1, -1.4},
                                      {3.6, 1.5, 1.5, 0, 1.1, -0.3},    {3.5, 1.7, -1.5, -2, 1.1, 0.6}};
    const int legs = (int)(sizeof stops / sizeof *stops) - 1;
    fputs("# through both rooms of movers.gltf; 12 frames a second are one round of its animation\n", file);
    for (int i = 0; i < FRAMES; i++) {
        const double at = (double)i * legs / (FRAMES - 1);
        const int leg = at < legs ? (int)at : legs - 1;
        for (int k = 0; k < 6; k++)
            fprintf(file, "%s%.4f", k ? " " : "", stops[leg][k] + (at - leg) * (stops[leg + 1][k] - stops[leg][k]));
        fputc('\n', file);
    }
}

static bool write_file(const char *folder, const char *name, void (*write)(FILE *file))
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (!file) return false;
    write(file);
    return fclose(file) == 0;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fputs("usage: generate_movers FOLDER\n", stderr);
        return EXIT_FAILURE;
    }
    add_meshes();
    add_motions();
    if (write_file(argv[1], "movers.gltf", write_gltf) && write_file(argv[1], "movers.cam", write_cameras))
        return EXIT_SUCCESS;
    fprintf(stderr, "generate_movers: cannot write into %s\n", argv[1]);
    return EXIT_FAILURE;
}
