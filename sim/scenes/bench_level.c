/* SPDX-License-Identifier: MIT
 *
 * Floors and ceilings are subsectors: the plane, clipped by the partition lines on the way down the map's tree and then
 * by the subsector's own segments. Walls are sidedefs. Indices are checked when the map is opened. */
#include "bench_level.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum lump { THINGS, LINEDEFS, SIDEDEFS, VERTEXES, SEGS, SSECTORS, NODES, SECTORS, LUMPS };

static const struct {
    const char *name;
    size_t record_b;
} kinds[LUMPS] = {{"THINGS", 10}, {"LINEDEFS", 14}, {"SIDEDEFS", 30}, {"VERTEXES", 4},
                  {"SEGS", 12},   {"SSECTORS", 4},  {"NODES", 28},    {"SECTORS", 26}};

enum { CORNERS_MAX = 64, DEPTH_MAX = 128, IS_SUBSECTOR = 0x8000, NO_SIDE = 0xffff };
enum { ENTRY_B = 16, MAP_LUMPS = 10, EYE_UNITS = 41, WORLD_UNITS = 1 << 16 };
static const double UNITS_A_M = 64.0, SAME_UNITS = 0.02;

struct bench_level {
    const uint8_t *lumps[LUMPS];
    size_t counts[LUMPS];
};

struct point {
    double x, y;
};

struct ring {
    struct point corners[CORNERS_MAX];
    int count;
};

/* Of a line, what lies to its right is inside. */
struct line {
    double x, y, dx, dy;
};

static int u16_at(const uint8_t *at)
{
    return at[0] | at[1] << 8;
}

static int s16_at(const uint8_t *at)
{
    return (int16_t)u16_at(at);
}

static size_t u32_at(const uint8_t *at)
{
    return (size_t)u16_at(at) | (size_t)u16_at(at + 2) << 16;
}

static const uint8_t *record(const struct bench_level *level, enum lump lump, size_t i)
{
    return level->lumps[lump] + i * kinds[lump].record_b;
}

static bool is_in(const struct bench_level *level, enum lump lump, int i)
{
    return (size_t)i < level->counts[lump];
}

/* Opening ------------------------------------------------------------------------------------ */

static bool find_lump(struct bench_level *level, const uint8_t *wad, size_t size_b, const uint8_t *entry)
{
    for (int i = 0; i < LUMPS; i++) {
        if (strncmp((const char *)entry + 8, kinds[i].name, 8) != 0) continue;
        const size_t at = u32_at(entry), lump_b = u32_at(entry + 4);
        if (at > size_b || lump_b > size_b - at) return false;
        level->lumps[i] = wad + at;
        level->counts[i] = lump_b / kinds[i].record_b;
    }
    return true;
}

static bool find_lumps(struct bench_level *level, const uint8_t *wad, size_t size_b, const char *map)
{
    if (size_b < 12 || memcmp(wad + 1, "WAD", 3) != 0) return false;
    const size_t count = u32_at(wad + 4), directory = u32_at(wad + 8);
    if (directory > size_b || count > (size_b - directory) / ENTRY_B) return false;
    size_t i = 0;
    while (i < count && strncmp((const char *)wad + directory + i * ENTRY_B + 8, map, 8) != 0)
        i++;
    for (size_t k = 1; k <= MAP_LUMPS && i + k < count; k++)
        if (!find_lump(level, wad, size_b, wad + directory + (i + k) * ENTRY_B)) return false;
    for (int k = 0; k < LUMPS; k++)
        if (!level->counts[k]) return false;
    return true;
}

static bool sides_are_good(const struct bench_level *level)
{
    for (size_t i = 0; i < level->counts[SIDEDEFS]; i++)
        if (!is_in(level, SECTORS, u16_at(record(level, SIDEDEFS, i) + 28))) return false;
    for (size_t i = 0; i < level->counts[LINEDEFS]; i++) {
        const uint8_t *line = record(level, LINEDEFS, i);
        for (int side = 10; side <= 12; side += 2)
            if (u16_at(line + side) != NO_SIDE && !is_in(level, SIDEDEFS, u16_at(line + side))) return false;
        if (!is_in(level, VERTEXES, u16_at(line)) || !is_in(level, VERTEXES, u16_at(line + 2))) return false;
    }
    return true;
}

static int side_of_seg(const struct bench_level *level, const uint8_t *seg)
{
    return u16_at(record(level, LINEDEFS, (size_t)u16_at(seg + 6)) + (u16_at(seg + 8) ? 12 : 10));
}

/* A child has a smaller index than its node, as builders of nodes number them: so walks end. */
static bool tree_is_good(const struct bench_level *level)
{
    for (size_t i = 0; i < level->counts[SEGS]; i++) {
        const uint8_t *seg = record(level, SEGS, i);
        if (!is_in(level, VERTEXES, u16_at(seg)) || !is_in(level, VERTEXES, u16_at(seg + 2))) return false;
        if (!is_in(level, LINEDEFS, u16_at(seg + 6)) || !is_in(level, SIDEDEFS, side_of_seg(level, seg))) return false;
    }
    for (size_t i = 0; i < level->counts[SSECTORS]; i++) {
        const uint8_t *subsector = record(level, SSECTORS, i);
        if (!u16_at(subsector) || !is_in(level, SEGS, u16_at(subsector) + u16_at(subsector + 2) - 1)) return false;
    }
    for (size_t i = 0; i < level->counts[NODES]; i++)
        for (int side = 24; side <= 26; side += 2) {
            const int child = u16_at(record(level, NODES, i) + side);
            if (child & IS_SUBSECTOR ? !is_in(level, SSECTORS, child & ~IS_SUBSECTOR) : (size_t)child >= i)
                return false;
        }
    return true;
}

struct bench_level *bench_level_open(const uint8_t *wad, size_t size_b, const char *map, const char **why)
{
    struct bench_level *level = calloc(1, sizeof *level);
    *why = "no memory";
    if (!level) return NULL;
    *why = "no such map in this file";
    if (find_lumps(level, wad, size_b, map)) {
        *why = "the map is broken";
        if (sides_are_good(level) && tree_is_good(level)) return level;
    }
    free(level);
    return NULL;
}

void bench_level_close(struct bench_level *level)
{
    free(level);
}

/* Floors and ceilings ------------------------------------------------------------------------ */

static void push(struct ring *ring, struct point point)
{
    if (ring->count < CORNERS_MAX) ring->corners[ring->count++] = point;
}

static struct ring clip(const struct ring *ring, const struct line *line, bool right)
{
    struct ring out = {.count = 0};
    for (int i = 0; i < ring->count; i++) {
        const struct point a = ring->corners[i], b = ring->corners[(i + 1) % ring->count];
        const double at_a = (a.x - line->x) * line->dy - (a.y - line->y) * line->dx;
        const double at_b = (b.x - line->x) * line->dy - (b.y - line->y) * line->dx;
        if (right ? at_a >= 0 : at_a <= 0) push(&out, a);
        if (at_a * at_b >= 0) continue;
        const double part = at_a / (at_a - at_b);
        push(&out, (struct point){a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
    }
    return out;
}

static bool is_apart(struct point a, struct point b)
{
    return hypot(a.x - b.x, a.y - b.y) > SAME_UNITS;
}

static struct ring without_twins(const struct ring *ring)
{
    struct ring out = {.count = 0};
    for (int i = 0; i < ring->count; i++)
        if (!out.count || is_apart(ring->corners[i], out.corners[out.count - 1])) push(&out, ring->corners[i]);
    while (out.count > 1 && !is_apart(out.corners[0], out.corners[out.count - 1]))
        out.count--;
    return out;
}

static double area(const struct ring *ring)
{
    double sum = 0;
    for (int i = 0; i < ring->count; i++) {
        const struct point a = ring->corners[i], b = ring->corners[(i + 1) % ring->count];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum / 2;
}

/* The map's x is x, its y is -z. */
static struct bench_corner corner_at(double x, double height, double y, double u, double v)
{
    return (struct bench_corner){x / UNITS_A_M, height / UNITS_A_M, -y / UNITS_A_M, u / UNITS_A_M, v / UNITS_A_M};
}

struct faces {
    const struct bench_level *level;
    bench_face_sink *sink;
    void *context;
};

/* A ring that runs counter-clockwise on the map is seen from above. */
static void give_flat(const struct faces *faces, const struct ring *ring, const uint8_t *sector, bool is_floor)
{
    struct bench_corner corners[CORNERS_MAX];
    const int height = s16_at(sector + (is_floor ? 0 : 2));
    const bool keeps = (area(ring) > 0) == is_floor;
    for (int i = 0; i < ring->count; i++) {
        const struct point at = ring->corners[keeps ? i : ring->count - 1 - i];
        corners[i] = corner_at(at.x, height, at.y, at.x, at.y);
    }
    const struct bench_surface surface = {(const char *)sector + (is_floor ? 4 : 12), u16_at(sector + 20)};
    faces->sink(faces->context, corners, ring->count, &surface);
}

static const uint8_t *sector_of_side(const struct bench_level *level, int side)
{
    return side == NO_SIDE ? NULL : record(level, SECTORS, (size_t)u16_at(record(level, SIDEDEFS, (size_t)side) + 28));
}

static const uint8_t *sector_of_subsector(const struct bench_level *level, int i)
{
    const uint8_t *subsector = record(level, SSECTORS, (size_t)i);
    return sector_of_side(level, side_of_seg(level, record(level, SEGS, (size_t)u16_at(subsector + 2))));
}

static struct line seg_line(const struct bench_level *level, const uint8_t *seg)
{
    const uint8_t *a = record(level, VERTEXES, (size_t)u16_at(seg)),
                  *b = record(level, VERTEXES, (size_t)u16_at(seg + 2));
    return (struct line){s16_at(a), s16_at(a + 2), s16_at(b) - s16_at(a), s16_at(b + 2) - s16_at(a + 2)};
}

static struct line node_line(const struct bench_level *level, size_t i)
{
    const uint8_t *node = record(level, NODES, i);
    return (struct line){s16_at(node), s16_at(node + 2), s16_at(node + 4), s16_at(node + 6)};
}

static void give_subsector(const struct faces *faces, int i, struct ring ring)
{
    const uint8_t *subsector = record(faces->level, SSECTORS, (size_t)i);
    for (int k = 0; k < u16_at(subsector); k++) {
        const struct line line =
            seg_line(faces->level, record(faces->level, SEGS, (size_t)(u16_at(subsector + 2) + k)));
        ring = clip(&ring, &line, true);
    }
    ring = without_twins(&ring);
    if (ring.count < 3) return;
    const uint8_t *sector = sector_of_subsector(faces->level, i);
    give_flat(faces, &ring, sector, true);
    give_flat(faces, &ring, sector, false);
}

struct pending {
    int child;
    struct ring ring;
};

static void give_flats(const struct faces *faces)
{
    struct pending *stack = malloc(DEPTH_MAX * sizeof *stack);
    if (!stack) return;
    const double far = WORLD_UNITS;
    stack[0] = (struct pending){(int)faces->level->counts[NODES] - 1,
                                {{{-far, -far}, {-far, far}, {far, far}, {far, -far}}, 4}};
    for (int depth = 1; depth;) {
        const struct pending now = stack[--depth];
        if (now.child & IS_SUBSECTOR) {
            give_subsector(faces, now.child & ~IS_SUBSECTOR, now.ring);
            continue;
        }
        if (depth + 2 > DEPTH_MAX) break;
        const struct line line = node_line(faces->level, (size_t)now.child);
        const uint8_t *node = record(faces->level, NODES, (size_t)now.child);
        stack[depth++] = (struct pending){u16_at(node + 24), clip(&now.ring, &line, true)};
        stack[depth++] = (struct pending){u16_at(node + 26), clip(&now.ring, &line, false)};
    }
    free(stack);
}

/* Walls -------------------------------------------------------------------------------------- */

/* From a to b, seen from the right of that way. */
struct wall {
    struct line line;
    const uint8_t *here, *beyond; /* sectors; beyond: NULL where the wall is whole */
    const uint8_t *side;
};

static void give_wall(const struct faces *faces, const struct wall *wall, int low, int high, int texture_at)
{
    if (high <= low) return;
    const struct line *line = &wall->line;
    const double length = hypot(line->dx, line->dy), x1 = line->x + line->dx, y1 = line->y + line->dy;
    const struct bench_corner corners[4] = {
        corner_at(line->x, low, line->y, 0, low),
        corner_at(x1, low, y1, length, low),
        corner_at(x1, high, y1, length, high),
        corner_at(line->x, high, line->y, 0, high),
    };
    const struct bench_surface surface = {(const char *)wall->side + texture_at, u16_at(wall->here + 20)};
    faces->sink(faces->context, corners, 4, &surface);
}

static int lower_of(int a, int b)
{
    return a < b ? a : b;
}

static int higher_of(int a, int b)
{
    return a > b ? a : b;
}

static bool is_sky(const uint8_t *sector)
{
    return strncmp((const char *)sector + 12, "F_SKY", 5) == 0;
}

enum { UPPER_AT = 4, LOWER_AT = 12, MIDDLE_AT = 20 };

static void give_side(const struct faces *faces, const struct wall *wall)
{
    const int floor = s16_at(wall->here), ceiling = s16_at(wall->here + 2);
    if (!wall->beyond) {
        give_wall(faces, wall, floor, ceiling, MIDDLE_AT);
        return;
    }
    give_wall(faces, wall, floor, lower_of(s16_at(wall->beyond), ceiling), LOWER_AT);
    if (is_sky(wall->here) && is_sky(wall->beyond)) return;
    give_wall(faces, wall, higher_of(s16_at(wall->beyond + 2), floor), ceiling, UPPER_AT);
}

static void give_walls(const struct faces *faces)
{
    const struct bench_level *level = faces->level;
    for (size_t i = 0; i < level->counts[LINEDEFS]; i++) {
        const uint8_t *linedef = record(level, LINEDEFS, i);
        const int sides[2] = {u16_at(linedef + 10), u16_at(linedef + 12)};
        const struct line ahead = seg_line(level, linedef);
        const struct line back = {ahead.x + ahead.dx, ahead.y + ahead.dy, -ahead.dx, -ahead.dy};
        for (int k = 0; k < 2; k++) {
            if (sides[k] == NO_SIDE) continue;
            const struct wall wall = {k ? back : ahead, sector_of_side(level, sides[k]),
                                      sector_of_side(level, sides[1 - k]), record(level, SIDEDEFS, (size_t)sides[k])};
            give_side(faces, &wall);
        }
    }
}

void bench_level_faces(const struct bench_level *level, bench_face_sink *sink, void *context)
{
    const struct faces faces = {level, sink, context};
    give_flats(&faces);
    give_walls(&faces);
}

/* Cameras ------------------------------------------------------------------------------------ */

static int floor_at(const struct bench_level *level, double x, double y)
{
    int child = (int)level->counts[NODES] - 1;
    while (!(child & IS_SUBSECTOR)) {
        const struct line line = node_line(level, (size_t)child);
        const bool right = (x - line.x) * line.dy - (y - line.y) * line.dx >= 0;
        child = u16_at(record(level, NODES, (size_t)child) + (right ? 24 : 26));
    }
    return s16_at(sector_of_subsector(level, child & ~IS_SUBSECTOR));
}

bool bench_level_cameras(const struct bench_level *level, FILE *cam, int frames)
{
    for (int i = 0; i < frames; i++) {
        const uint8_t *thing = record(level, THINGS, (size_t)i * level->counts[THINGS] / (size_t)frames);
        const double x = s16_at(thing), y = s16_at(thing + 2), turn = u16_at(thing + 4) * acos(-1.0) / 180;
        const struct bench_corner eye = corner_at(x, floor_at(level, x, y) + EYE_UNITS, y, 0, 0);
        fprintf(cam, "%.6f %.6f %.6f %.6f %.6f %.6f\n", eye.x_m, eye.y_m, eye.z_m, eye.x_m + cos(turn), eye.y_m,
                eye.z_m - sin(turn));
    }
    return !ferror(cam);
}
