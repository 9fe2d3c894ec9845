/* SPDX-License-Identifier: MIT
 *
 * Brute force, and formulas other than the ones under test. */
#include "mesh_checks.h"
#include "model/grid.h"

#include "base/vec3.h"
#include "cmocka_ready.h"
#include "readers/model_import.h"

#include <stdlib.h>
#include <string.h>

struct mesh cleaned(struct model *model)
{
    struct mesh mesh;
    struct error err = {""};
    bool ok = mesh_clean(model, &mesh, &err);
    model_free(model);
    if (!ok) fail_msg("%s", err.text);
    return mesh;
}

struct mesh cleaned_file(const char *path)
{
    struct model model;
    struct error err = {""};
    if (!model_import(path, &model, &err)) fail_msg("%s", err.text);
    return cleaned(&model);
}

static const double *corner(const struct mesh *mesh, size_t polygon, size_t k)
{
    const struct mesh_polygon *p = &mesh->polygons[polygon];
    return mesh->points[mesh->corners[p->first + k % p->count]];
}

/* Twice the area times the normal: the sum of the corners' cross products. */
static void double_area(const struct mesh *mesh, size_t polygon, double out[3])
{
    memset(out, 0, 3 * sizeof *out);
    const double *origin = corner(mesh, polygon, 0);
    for (size_t k = 1; k + 1 < mesh->polygons[polygon].count; k++) {
        double u[3], v[3];
        vec3_sub(u, corner(mesh, polygon, k), origin);
        vec3_sub(v, corner(mesh, polygon, k + 1), origin);
        out[0] += u[1] * v[2] - u[2] * v[1];
        out[1] += u[2] * v[0] - u[0] * v[2];
        out[2] += u[0] * v[1] - u[1] * v[0];
    }
}

double mesh_area_m2(const struct mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        double area[3];
        double_area(mesh, i, area);
        sum += sqrt(vec3_dot(area, area)) / 2;
    }
    return sum;
}

struct directed {
    uint32_t low, high;
    int way; /* +1: from low to high */
};

static int by_edge(const void *left, const void *right)
{
    const struct directed *a = left, *b = right;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    if (a->high != b->high) return a->high < b->high ? -1 : 1;
    return a->way - b->way;
}

size_t mesh_open_edges(const struct mesh *mesh)
{
    struct directed *edges = calloc(mesh->corner_count, sizeof *edges);
    size_t count = 0, open = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *p = &mesh->polygons[i];
        for (uint32_t k = 0; k < p->count; k++) {
            uint32_t a = mesh->corners[p->first + k], b = mesh->corners[p->first + (k + 1) % p->count];
            edges[count++] = a < b ? (struct directed){a, b, 1} : (struct directed){b, a, -1};
        }
    }
    qsort(edges, count, sizeof *edges, by_edge);
    for (size_t i = 0, end; i < count; i = end) {
        int sum = 0;
        for (end = i; end < count && edges[end].low == edges[i].low && edges[end].high == edges[i].high; end++)
            sum += edges[end].way;
        if (end - i != 2 || sum != 0) open += end - i;
    }
    free(edges);
    return open;
}

static size_t points_inside(const struct mesh *mesh, const bool *is_corner, uint32_t a, uint32_t b)
{
    double near_m = grid_near_m(&mesh->grid);
    const double *from = mesh->points[a], *to = mesh->points[b];
    size_t count = 0;
    for (uint32_t i = 0; i < mesh->point_count; i++) {
        const double *p = mesh->points[i];
        if (!is_corner[i] || i == a || i == b) continue;
        double at = vec3_foot(from, to, p);
        count += at > 0 && at < 1 && vec3_segment_distance2(from, to, p) < near_m * near_m;
    }
    return count;
}

size_t mesh_t_vertices_left(const struct mesh *mesh)
{
    bool *is_corner = calloc(mesh->point_count, sizeof *is_corner);
    size_t left = 0;
    for (size_t i = 0; i < mesh->corner_count; i++)
        is_corner[mesh->corners[i]] = true;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *p = &mesh->polygons[i];
        for (uint32_t k = 0; k < p->count; k++)
            left += points_inside(mesh, is_corner, mesh->corners[p->first + k],
                                  mesh->corners[p->first + (k + 1) % p->count]);
    }
    free(is_corner);
    return left;
}

/* Does the corner turn to the right, by more than lies near the line between its neighbours? */
static bool turns_right(const struct mesh *mesh, size_t polygon, size_t k, const double normal[3])
{
    const double *before = corner(mesh, polygon, k + mesh->polygons[polygon].count - 1);
    const double *here = corner(mesh, polygon, k), *after = corner(mesh, polygon, k + 1);
    double u[3], v[3], near_m = grid_near_m(&mesh->grid);
    vec3_sub(u, here, before);
    vec3_sub(v, after, here);
    double turn = (u[1] * v[2] - u[2] * v[1]) * normal[0] + (u[2] * v[0] - u[0] * v[2]) * normal[1] +
                  (u[0] * v[1] - u[1] * v[0]) * normal[2];
    return turn < 0 && vec3_segment_distance2(before, after, here) > near_m * near_m;
}

size_t mesh_bad_corners(const struct mesh *mesh, double units)
{
    size_t bad = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        double normal[3], middle[3] = {0, 0, 0};
        size_t count = mesh->polygons[i].count;
        double_area(mesh, i, normal);
        for (size_t k = 0; k < count; k++)
            for (int axis = 0; axis < 3; axis++)
                middle[axis] += corner(mesh, i, k)[axis] / (double)count;
        for (size_t k = 0; k < count; k++) {
            double from_middle[3];
            vec3_sub(from_middle, corner(mesh, i, k), middle);
            double off_m = fabs(vec3_dot(from_middle, normal)) / sqrt(vec3_dot(normal, normal));
            bad += off_m * mesh->grid.units_per_m > units || turns_right(mesh, i, k, normal);
        }
    }
    return bad;
}
