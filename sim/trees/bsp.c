/* SPDX-License-Identifier: MIT
 *
 * Pieces are made of the mesh's polygons and of what planes cut; no corner of a piece is ever moved. */
#include "trees/bsp.h"

#include "base/grow.h"
#include "model/inner.h"
#include "trees/parts.h"

#include <math.h>
#include <stdlib.h>

/* Pieces ------------------------------------------------------------------------------------- */

static void corner_add(struct bsp *bsp, uint32_t point, uint32_t edge)
{
    bsp->corners = grow(bsp->corners, bsp->corner_count, &bsp->corner_capacity, sizeof *bsp->corners);
    bsp->corners[bsp->corner_count++] = (struct bsp_corner){point, edge};
}

/* A sphere about the middle of the bounds, a little widened against rounding. */
static void piece_enclose(const struct bsp *bsp, struct bsp_piece *piece)
{
    const double(*approx)[3] = (const double(*)[3])bsp->edges.points->approx;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < piece->count; i++)
        for (int k = 0; k < 3; k++) {
            double at = approx[bsp->corners[piece->first + i].point][k];
            low[k] = fmin(low[k], at);
            high[k] = fmax(high[k], at);
        }
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        piece->centre[k] = (low[k] + high[k]) / 2.0;
        square += (high[k] - low[k]) * (high[k] - low[k]) / 4.0;
    }
    piece->radius = sqrt(square) + 0x1p-20;
}

/* Makes a piece of the corners from `first` on. */
static uint32_t piece_add(struct bsp *bsp, size_t first, uint32_t polygon)
{
    bsp->pieces = grow(bsp->pieces, bsp->piece_count, &bsp->piece_capacity, sizeof *bsp->pieces);
    struct bsp_piece *piece = &bsp->pieces[bsp->piece_count];
    *piece = (struct bsp_piece){.first = first, .count = (uint32_t)(bsp->corner_count - first), .polygon = polygon};
    piece_enclose(bsp, piece);
    return (uint32_t)bsp->piece_count++;
}

uint32_t bsp_piece_of(struct bsp *bsp, uint32_t index)
{
    const struct mesh_polygon *polygon = &bsp->mesh->polygons[index];
    const uint32_t *corners = &bsp->mesh->corners[polygon->first];
    size_t first = bsp->corner_count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        const uint32_t next = corners[(i + 1) % polygon->count];
        const uint32_t edge = edges_between(&bsp->edges, corners[i], next);
        bsp->edges.items[edge].hidden = inner_has(bsp->mesh, corners[i], next);
        corner_add(bsp, corners[i], edge);
    }
    return piece_add(bsp, first, index);
}

/* Planes ------------------------------------------------------------------------------------- */

const struct plane *bsp_plane(const struct bsp *bsp, uint32_t group)
{
    return group < bsp->coplanar->count ? &bsp->coplanar->planes[group] : &bsp->cuts[group - bsp->coplanar->count];
}

uint32_t bsp_cut(struct bsp *bsp, enum plane_kind axis, int32_t d)
{
    const uint32_t index = *map_at(&bsp->cut_of, (uint64_t)axis << 32 | (uint32_t)d, (uint32_t)bsp->cut_count);
    if (index == bsp->cut_count) {
        bsp->cuts = grow(bsp->cuts, bsp->cut_count, &bsp->cut_capacity, sizeof *bsp->cuts);
        bsp->cuts[bsp->cut_count++] =
            (struct plane){.n = {axis == PLANE_X, axis == PLANE_Y, axis == PLANE_Z}, .d = d, .kind = axis, .length = 1};
    }
    return (uint32_t)bsp->coplanar->count + index;
}

/* Sides -------------------------------------------------------------------------------------- */

static int corner_side(const struct bsp *bsp, uint32_t point, const struct plane *plane)
{
    if (bsp->tolerance_units == 0.0) return exact_side(bsp->edges.points, point, plane);
    double distance = plane_distance(plane, bsp->edges.points->approx[point]);
    return (distance > bsp->tolerance_units) - (distance < -bsp->tolerance_units);
}

int bsp_piece_sides(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane)
{
    double distance = plane_distance(plane, piece->centre), reach = piece->radius + bsp->tolerance_units;
    if (fabs(distance) > reach) return distance > 0.0 ? BSP_FRONT : BSP_BACK;
    int sides = BSP_ON;
    for (size_t i = 0; i < piece->count && sides != BSP_BOTH; i++) {
        int side = corner_side(bsp, bsp->corners[piece->first + i].point, plane);
        if (side) sides |= side > 0 ? BSP_FRONT : BSP_BACK;
    }
    return sides;
}

/* Which side of a group's plane a polygon is on that lies over one of the group, or under it; BSP_ON: it does not. */
static int side_by_layers(const struct bsp *bsp, uint32_t polygon, uint32_t group)
{
    const struct coplanar *coplanar = bsp->coplanar;
    size_t count;
    const struct layer *layer = layers_of(&coplanar->layers, polygon, &count);
    for (; count; layer++, count--) {
        if (!layer->height || coplanar->group[layer->other] != group) continue;
        const bool faces_back = coplanar->faces_back[layer->other] != layer->is_turned;
        return (layer->height > 0) == faces_back ? BSP_FRONT : BSP_BACK;
    }
    return BSP_ON;
}

int bsp_piece_filed(const struct bsp *bsp, const struct bsp_piece *piece, uint32_t group)
{
    const struct plane *plane = bsp_plane(bsp, group);
    int sides = bsp_piece_sides(bsp, piece, plane);
    if (sides == BSP_ON) sides = side_by_layers(bsp, piece->polygon, group);
    if (sides != BSP_ON) return sides;
    const uint32_t part = bsp->parts ? bsp->parts->of[piece->polygon] : 0;
    double middle[3];
    for (int k = 0; k < 3; k++)
        middle[k] =
            part ? (bsp->parts->items[part - 1].low[k] + bsp->parts->items[part - 1].high[k]) / 2.0 : piece->centre[k];
    return plane_distance(plane, middle) >= 0.0 ? BSP_FRONT : BSP_BACK;
}

/* Splitting ---------------------------------------------------------------------------------- */

/* Where the outline of a piece leaves one side of a plane: at corner `at`, or just before it. */
struct crossing {
    uint32_t point; /* on the plane */
    uint32_t edge;  /* that leads on from it */
    uint32_t at;    /* the first corner that is not on the side left */
    uint32_t next;  /* the first corner after `point` */
};

/* Follows the outline from corner `from`, which lies on the given side (1 or -1). The outline of a
 * convex polygon leaves a side once; corners that noise brings back to it are not looked at. */
static struct crossing find_crossing(struct bsp *bsp, const struct bsp_piece *piece, uint32_t from, int side,
                                     uint32_t group)
{
    const struct plane *plane = bsp_plane(bsp, group);
    const struct bsp_corner *corners = &bsp->corners[piece->first];
    uint32_t before = from, at;
    int at_side;
    for (;; before = at) {
        at = (before + 1) % piece->count;
        at_side = corner_side(bsp, corners[at].point, plane) * side;
        if (at_side <= 0) break;
    }
    if (at_side == 0) return (struct crossing){corners[at].point, corners[at].edge, at, (at + 1) % piece->count};
    uint32_t edge = corners[before].edge;
    return (struct crossing){edges_cut(&bsp->edges, edge, plane, group), edge, at, at};
}

/* The part of a piece between two crossings, closed by the edge `cut`. */
static uint32_t piece_between(struct bsp *bsp, const struct bsp_piece *piece, struct crossing from, struct crossing to,
                              uint32_t cut)
{
    size_t first = bsp->corner_count;
    corner_add(bsp, from.point, from.edge);
    for (uint32_t i = from.next; i != to.at; i = (i + 1) % piece->count)
        corner_add(bsp, bsp->corners[piece->first + i].point, bsp->corners[piece->first + i].edge);
    corner_add(bsp, to.point, cut);
    return piece_add(bsp, first, piece->polygon);
}

/* The corners farthest in front of and behind the plane. */
static void find_extremes(const struct bsp *bsp, const struct bsp_piece *piece, const struct plane *plane,
                          uint32_t *top, uint32_t *bottom)
{
    double highest = -INFINITY, lowest = INFINITY;
    for (uint32_t i = 0; i < piece->count; i++) {
        const double *at = bsp->edges.points->approx[bsp->corners[piece->first + i].point];
        double distance = plane_distance(plane, at);
        if (distance > highest) *top = i;
        if (distance < lowest) *bottom = i;
        highest = fmax(highest, distance);
        lowest = fmin(lowest, distance);
    }
}

void bsp_piece_split(struct bsp *bsp, uint32_t index, uint32_t group, uint32_t *front, uint32_t *back)
{
    const struct bsp_piece piece = bsp->pieces[index];
    uint32_t top = 0, bottom = 0;
    find_extremes(bsp, &piece, bsp_plane(bsp, group), &top, &bottom);
    struct crossing down = find_crossing(bsp, &piece, top, 1, group);
    struct crossing up = find_crossing(bsp, &piece, bottom, -1, group);
    uint32_t cut = edges_add_cut(&bsp->edges, down.point, up.point);
    *front = piece_between(bsp, &piece, up, down, cut);
    *back = piece_between(bsp, &piece, down, up, cut);
    bsp->splits++;
}

void bsp_free(struct bsp *bsp)
{
    edges_free(&bsp->edges);
    map_free(&bsp->cut_of);
    free(bsp->cuts);
    free(bsp->corners);
    free(bsp->pieces);
    free(bsp->nodes);
    free(bsp->placed);
    *bsp = (struct bsp){0};
}
