/* SPDX-License-Identifier: MIT
 *
 * Bounds decide all of an axis plane; of others spheres decide most, and corners the rest. What lies within rounding of
 * the tolerance goes the long way, so every piece is filed as when it is placed. */
#include "trees/sides.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

/* Far more than products and sums of doubles are off, relative to the sum's largest term: coordinates have 16 bits
 * before the point. */
static const double SPHERE_SLACK = 0x1p-24, CORNER_SLACK = 0x1p-30;

/* A plane in doubles; its normal is of length 1. */
struct side_plane {
    double n[3], d;
};

static void find_bounds(const double *corners, size_t count, double bounds[6])
{
    for (int k = 0; k < 3; k++) {
        bounds[2 * k] = INFINITY;
        bounds[2 * k + 1] = -INFINITY;
        for (size_t c = 0; c < count; c++) {
            bounds[2 * k] = fmin(bounds[2 * k], corners[3 * c + (size_t)k]);
            bounds[2 * k + 1] = fmax(bounds[2 * k + 1], corners[3 * c + (size_t)k]);
        }
    }
}

void sides_begin(struct sides *sides, const struct bsp *bsp, const uint32_t *list, size_t count)
{
    size_t corners = 0;
    for (size_t i = 0; i < count; i++)
        corners += bsp->pieces[list[i]].count;
    *sides = (struct sides){.bsp = bsp,
                            .list = list,
                            .count = count,
                            .spheres = grow_zeroed(4 * count, sizeof(double)),
                            .bounds = grow_zeroed(6 * count, sizeof(double)),
                            .corners = grow_zeroed(3 * corners, sizeof(double)),
                            .firsts = grow_zeroed(count + 1, sizeof(uint32_t)),
                            .groups = grow_zeroed(count, sizeof(uint32_t))};
    double *corner = sides->corners;
    for (size_t i = 0; i < count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[list[i]];
        for (int k = 0; k < 3; k++)
            sides->spheres[4 * i + (size_t)k] = piece->centre[k];
        sides->spheres[4 * i + 3] = piece->radius + bsp->tolerance_units + SPHERE_SLACK;
        sides->groups[i] = bsp->coplanar->group[piece->polygon];
        sides->firsts[i + 1] = sides->firsts[i] + piece->count;
        for (size_t c = 0; c < piece->count; c++)
            for (int k = 0; k < 3; k++)
                *corner++ = bsp->edges.points->approx[bsp->corners[piece->first + c].point][k];
        find_bounds(corner - 3 * piece->count, piece->count, sides->bounds + 6 * i);
    }
}

void sides_end(struct sides *sides)
{
    free(sides->spheres);
    free(sides->bounds);
    free(sides->corners);
    free(sides->firsts);
    free(sides->groups);
}

static double distance(const struct side_plane *plane, const double at[3])
{
    return plane->n[0] * at[0] + plane->n[1] * at[1] + plane->n[2] * at[2] - plane->d;
}

/* BSP_ON: they do not tell. */
static int sides_by_corners(const struct sides *sides, size_t i, const struct side_plane *plane)
{
    const double sure = sides->bsp->tolerance_units + CORNER_SLACK, unsure = sides->bsp->tolerance_units - CORNER_SLACK;
    int found = BSP_ON;
    for (size_t c = sides->firsts[i]; c < sides->firsts[i + 1]; c++) {
        const double away = distance(plane, sides->corners + 3 * c);
        if (away > sure)
            found |= BSP_FRONT;
        else if (away < -sure)
            found |= BSP_BACK;
        else if (fabs(away) > unsure)
            return BSP_ON;
    }
    return found;
}

/* BSP_ON: they do not tell. */
static int sides_by_bounds(const double bounds[2], double d, double tolerance_units)
{
    const double up = bounds[1] - d, down = d - bounds[0];
    if (fabs(up - tolerance_units) <= CORNER_SLACK || fabs(down - tolerance_units) <= CORNER_SLACK) return BSP_ON;
    return (up > tolerance_units ? BSP_FRONT : 0) | (down > tolerance_units ? BSP_BACK : 0);
}

static void find_by_bounds(const struct sides *sides, int axis, double d, uint8_t *out)
{
    for (size_t i = 0; i < sides->count; i++)
        out[i] = (uint8_t)sides_by_bounds(sides->bounds + 6 * i + 2 * axis, d, sides->bsp->tolerance_units);
}

static void find_by_spheres(const struct sides *sides, const struct plane *stored, uint8_t *out)
{
    struct side_plane plane = {.d = (double)stored->d / stored->length};
    for (int k = 0; k < 3; k++)
        plane.n[k] = (double)stored->n[k] / stored->length;
    for (size_t i = 0; i < sides->count; i++) {
        const double *sphere = sides->spheres + 4 * i, away = distance(&plane, sphere);
        out[i] = (uint8_t)((away > sphere[3] ? BSP_FRONT : 0) | (away < -sphere[3] ? BSP_BACK : 0));
        if (out[i] == BSP_ON) out[i] = (uint8_t)sides_by_corners(sides, i, &plane);
    }
}

void sides_find(const struct sides *sides, uint32_t group, uint8_t *out)
{
    const struct plane *plane = bsp_plane(sides->bsp, group);
    if (plane->kind <= PLANE_Z)
        find_by_bounds(sides, (int)plane->kind, (double)plane->d, out);
    else
        find_by_spheres(sides, plane, out);
    for (size_t i = 0; i < sides->count; i++)
        if (sides->groups[i] == group)
            out[i] = BSP_ON;
        else if (out[i] == BSP_ON)
            out[i] = (uint8_t)bsp_piece_filed(sides->bsp, &sides->bsp->pieces[sides->list[i]], group);
}
