/* SPDX-License-Identifier: MIT
 *
 * Carving: the coordinates of all boxes make an uneven lattice; each of its cells is solid or
 * belongs to the last box that covers it. A face is wherever solid and air meet. The faces of one
 * box in one plane are cut by the edges of their openings, by tiles and into even panels. */
#include "demo_carve.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum {
    LINES = 256, /* far more than two for every box and the panels between them */
    SOLID = -1,
};

struct lattice {
    int *line[3]; /* mm, ascending */
    int lines[3];
    int16_t *owner; /* of cell [x][y][z] */
};

/* Cut positions along one axis. */
struct cuts {
    int at_mm[LINES];
    int count;
};

static int compare_int(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static int sort_unique(int *value, int count)
{
    int kept = 0;
    qsort(value, (size_t)count, sizeof *value, compare_int);
    for (int i = 0; i < count; i++)
        if (i == 0 || value[i] != value[kept - 1]) value[kept++] = value[i];
    return kept;
}

static int line_index(const struct lattice *lattice, int axis, int at_mm)
{
    const int *line = lattice->line[axis];
    const int *found = bsearch(&at_mm, line, (size_t)lattice->lines[axis], sizeof at_mm, compare_int);
    return (int)(found - line);
}

static int16_t *cell(const struct lattice *lattice, const int at[3])
{
    return &lattice->owner[((size_t)at[0] * (size_t)lattice->lines[1] + (size_t)at[1]) * (size_t)lattice->lines[2] +
                           (size_t)at[2]];
}

static int owner_at(const struct lattice *lattice, const int at[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (at[axis] < 0 || at[axis] >= lattice->lines[axis]) return SOLID;
    return *cell(lattice, at);
}

static void lattice_dig(struct lattice *lattice, const struct space *space, int number)
{
    int lo[3], hi[3], at[3];
    for (int axis = 0; axis < 3; axis++) {
        lo[axis] = line_index(lattice, axis, space->lo_mm[axis]);
        hi[axis] = line_index(lattice, axis, space->hi_mm[axis]);
    }
    for (at[0] = lo[0]; at[0] < hi[0]; at[0]++)
        for (at[1] = lo[1]; at[1] < hi[1]; at[1]++)
            for (at[2] = lo[2]; at[2] < hi[2]; at[2]++)
                *cell(lattice, at) = (int16_t)number;
}

static struct lattice lattice_build(const struct space *spaces, size_t count)
{
    struct lattice lattice = {0};
    size_t cells = 1;
    for (int axis = 0; axis < 3; axis++) {
        lattice.line[axis] = demo_realloc(NULL, 2 * count * sizeof *lattice.line[axis]);
        for (size_t i = 0; i < count; i++) {
            lattice.line[axis][2 * i] = spaces[i].lo_mm[axis];
            lattice.line[axis][2 * i + 1] = spaces[i].hi_mm[axis];
        }
        lattice.lines[axis] = sort_unique(lattice.line[axis], (int)(2 * count));
        cells *= (size_t)lattice.lines[axis];
    }
    lattice.owner = demo_realloc(NULL, cells * sizeof *lattice.owner);
    memset(lattice.owner, 0xff, cells * sizeof *lattice.owner);
    for (size_t i = 0; i < count; i++)
        lattice_dig(&lattice, &spaces[i], (int)i);
    return lattice;
}

static void lattice_free(struct lattice *lattice)
{
    for (int axis = 0; axis < 3; axis++)
        free(lattice->line[axis]);
    free(lattice->owner);
}

/* One plane of the lattice, looked at from one side: which box's air lies before solid there. */
struct view {
    const struct lattice *lattice;
    int axis, u, v; /* u and v follow axis cyclically, so that u x v points along it */
    int plane;      /* index of the line on axis */
    int facing;     /* +1: air on the upper side of the plane, -1: on the lower */
};

static int air_before_solid(const struct view *view, int iu, int iv)
{
    int above[3], below[3];
    above[view->axis] = view->plane;
    below[view->axis] = view->plane - 1;
    above[view->u] = below[view->u] = iu;
    above[view->v] = below[view->v] = iv;
    int air = owner_at(view->lattice, view->facing > 0 ? above : below);
    int solid = owner_at(view->lattice, view->facing > 0 ? below : above);
    return solid == SOLID ? air : SOLID;
}

/* Does the box's surface begin or end anywhere along the lattice line number i of axis `along`? */
static bool surface_edge(const struct view *view, int owner, int along, int i)
{
    int across = along == view->u ? view->v : view->u;
    for (int j = 0; j < view->lattice->lines[across]; j++) {
        bool here = along == view->u ? air_before_solid(view, i, j) == owner : air_before_solid(view, j, i) == owner;
        bool before =
            along == view->u ? air_before_solid(view, i - 1, j) == owner : air_before_solid(view, j, i - 1) == owner;
        if (here != before) return true;
    }
    return false;
}

static void cuts_divide(struct cuts *cuts, int panel_mm)
{
    int edges = cuts->count;
    for (int i = 0; panel_mm && i + 1 < edges; i++) {
        int gap_mm = cuts->at_mm[i + 1] - cuts->at_mm[i];
        int parts = (gap_mm + panel_mm / 2) / panel_mm;
        for (int part = 1; part < parts; part++)
            cuts->at_mm[cuts->count++] = cuts->at_mm[i] + gap_mm * part / parts;
    }
}

/* A rest narrower than a quarter of a tile makes the last one wider, rather than be a sliver. */
static void cuts_tile(struct cuts *cuts, int from_mm, int tile_mm)
{
    int end_mm = cuts->at_mm[cuts->count - 1] - tile_mm / 4;
    for (int at_mm = from_mm + tile_mm; at_mm < end_mm; at_mm += tile_mm)
        if (at_mm > cuts->at_mm[0]) cuts->at_mm[cuts->count++] = at_mm;
}

static struct cuts cuts_find(const struct view *view, const struct space *space, int owner, int along)
{
    struct cuts cuts = {.count = 0};
    for (int i = 0; i < view->lattice->lines[along]; i++)
        if (surface_edge(view, owner, along, i)) cuts.at_mm[cuts.count++] = view->lattice->line[along][i];
    if (!cuts.count) return cuts;
    int dado_mm = space->lo_mm[1] + space->dado_mm;
    if (along == 1 && space->dado_mm && cuts.at_mm[0] < dado_mm) {
        cuts.at_mm[cuts.count++] = dado_mm;
        cuts.count = sort_unique(cuts.at_mm, cuts.count);
    }
    int tile_mm = view->axis == 1 && view->facing > 0 ? space->tile_mm[along / 2] : 0;
    if (tile_mm)
        cuts_tile(&cuts, space->lo_mm[along], tile_mm);
    else
        cuts_divide(&cuts, view->axis == 1 ? 3 * space->panel_mm / 2 : space->panel_mm);
    cuts.count = sort_unique(cuts.at_mm, cuts.count);
    return cuts;
}

static int panel_material(const struct view *view, const struct space *space, const int mid_mm[3])
{
    if (view->axis != 1) return mid_mm[1] < space->lo_mm[1] + space->dado_mm ? space->dado : space->wall;
    if (view->facing < 0) return space->ceiling;
    if (!space->tile_mm[0]) return space->floor;
    int column = (mid_mm[0] - space->lo_mm[0]) / space->tile_mm[0];
    int row = (mid_mm[2] - space->lo_mm[2]) / space->tile_mm[1];
    return (column + row) % 2 ? space->floor2 : space->floor;
}

static void add_panel(struct soup *soup, const struct view *view, const struct space *space, const int u_mm[2],
                      const int v_mm[2])
{
    struct vec3 corner[4];
    int mid_mm[3];
    for (int i = 0; i < 4; i++) {
        int turn = view->facing > 0 ? i : 3 - i;
        double at_m[3];
        at_m[view->axis] = view->lattice->line[view->axis][view->plane] / 1000.0;
        at_m[view->u] = u_mm[turn == 1 || turn == 2] / 1000.0;
        at_m[view->v] = v_mm[turn >= 2] / 1000.0;
        corner[i] = (struct vec3){at_m[0], at_m[1], at_m[2]};
    }
    mid_mm[view->axis] = 0;
    mid_mm[view->u] = (u_mm[0] + u_mm[1]) / 2;
    mid_mm[view->v] = (v_mm[0] + v_mm[1]) / 2;
    int material = panel_material(view, space, mid_mm);
    if (material != LEFT_OUT) soup_add(soup, corner, 4, material);
}

/* The lattice interval that holds a position. */
static int interval(const struct lattice *lattice, int axis, int at_mm)
{
    int i = 0;
    while (i + 1 < lattice->lines[axis] && lattice->line[axis][i + 1] <= at_mm)
        i++;
    return i;
}

static void add_surface(struct soup *soup, const struct view *view, const struct space *space, int owner)
{
    struct cuts u = cuts_find(view, space, owner, view->u);
    struct cuts v = cuts_find(view, space, owner, view->v);
    for (int j = 0; j + 1 < v.count; j++) {
        int iv = interval(view->lattice, view->v, v.at_mm[j]);
        for (int i = 0; i + 1 < u.count; i++) {
            int u_mm[2] = {u.at_mm[i], u.at_mm[i + 1]};
            if (air_before_solid(view, interval(view->lattice, view->u, u_mm[0]), iv) != owner) continue;
            /* where panels do not matter, the whole row up to the next opening is one */
            while (!space->panel_mm && i + 2 < u.count &&
                   air_before_solid(view, interval(view->lattice, view->u, u_mm[1]), iv) == owner)
                u_mm[1] = u.at_mm[++i + 1];
            add_panel(soup, view, space, u_mm, &v.at_mm[j]);
        }
    }
}

void carve(struct soup *soup, const struct space *spaces, size_t count)
{
    struct lattice lattice = lattice_build(spaces, count);
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++)
            for (int facing = -1; facing <= 1; facing += 2) {
                int at_mm = facing > 0 ? spaces[i].lo_mm[axis] : spaces[i].hi_mm[axis];
                int plane = line_index(&lattice, axis, at_mm);
                struct view view = {&lattice, axis, (axis + 1) % 3, (axis + 2) % 3, plane, facing};
                add_surface(soup, &view, &spaces[i], (int)i);
            }
    lattice_free(&lattice);
}
