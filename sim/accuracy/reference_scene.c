/* SPDX-License-Identifier: MIT
 *
 * The polygons of a reference picture: from a mesh, or from a model's file by a reader of its own; and where movers
 * take them. */
#include "accuracy/reference.h"
#include "accuracy/reference_polygon.h"
#include "model/pose.h"
#include "readers/model_read.h"
#include "readers/source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double LEVEL_SHARE = 0x1p-40;

/* Newell's normal: the sum over all edges, so that no three corners are singled out. */
static void polygon_plane(struct reference_polygon *polygon, double (*points)[3])
{
    double centre[3] = {0};
    memset(polygon->normal, 0, sizeof polygon->normal);
    for (uint32_t i = 0; i < polygon->count; i++)
        for (int axis = 0; axis < 3; axis++)
            centre[axis] += points[i][axis] / polygon->count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        double a[3], b[3], term[3];
        subtract(points[i], centre, a);
        subtract(points[(i + 1) % polygon->count], centre, b);
        cross(a, b, term);
        for (int axis = 0; axis < 3; axis++)
            polygon->normal[axis] += term[axis];
    }
    polygon->offset_m = dot(polygon->normal, centre);
}

static void copy_polygons(struct reference *reference, const struct mesh *mesh, size_t mover)
{
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        const struct mesh_polygon *from = &mesh->polygons[p];
        struct reference_polygon *to = &reference->polygons[reference->polygon_count++];
        const uint32_t first = (uint32_t)reference->point_count;
        *to = (struct reference_polygon){.first = first,
                                         .count = from->count,
                                         .face = from->face,
                                         .mapping = from->mapping,
                                         .mover = mover,
                                         .two_sided = from->two_sided};
        for (uint32_t i = 0; i < from->count; i++) {
            const double *point = mesh->points[mesh->corners[from->first + i]];
            memcpy(reference->points[first + i], point, sizeof reference->points[0]);
            memcpy(reference->own_points[first + i], point, sizeof reference->own_points[0]);
            for (int axis = 0; axis < 3; axis++)
                reference->level_m = fmax(reference->level_m, fabs(point[axis]) * LEVEL_SHARE);
        }
        polygon_plane(to, &reference->points[first]);
        reference->point_count += from->count;
    }
}

static void *larger(void *items, size_t count, size_t item_b, bool *ok)
{
    void *moved = realloc(items, (count ? count : 1) * item_b);
    if (!moved) *ok = false;
    return moved ? moved : items;
}

bool reference_add(struct reference *reference, const struct mesh *mesh, size_t mover, struct error *err)
{
    size_t points = reference->point_count;
    bool ok = true;
    for (size_t p = 0; p < mesh->polygon_count; p++) {
        points += mesh->polygons[p].count;
        if (mesh->polygons[p].count > reference->corners_max) reference->corners_max = mesh->polygons[p].count;
    }
    const size_t polygons = reference->polygon_count + mesh->polygon_count;
    reference->points = larger(reference->points, points, sizeof reference->points[0], &ok);
    reference->own_points = larger(reference->own_points, points, sizeof reference->own_points[0], &ok);
    reference->polygons = larger(reference->polygons, polygons, sizeof reference->polygons[0], &ok);
    reference->bounds = larger(reference->bounds, polygons, sizeof reference->bounds[0], &ok);
    reference->edges = larger(reference->edges, reference->corners_max, sizeof reference->edges[0], &ok);
    if (!ok) return error_set(err, "reference picture: out of memory");
    copy_polygons(reference, mesh, mover);
    return true;
}

void reference_bend(struct reference *reference, size_t mover, void (*bend)(double at_m[3], double how), double how)
{
    for (size_t p = 0; p < reference->polygon_count; p++) {
        const struct reference_polygon *polygon = &reference->polygons[p];
        for (uint32_t i = polygon->first; polygon->mover == mover && i < polygon->first + polygon->count; i++)
            bend(reference->own_points[i], how);
    }
}

void reference_pose(struct reference *reference, size_t mover, const struct model_pose *pose)
{
    for (size_t p = 0; p < reference->polygon_count; p++) {
        struct reference_polygon *polygon = &reference->polygons[p];
        if (polygon->mover != mover) continue;
        for (uint32_t i = polygon->first; i < polygon->first + polygon->count; i++)
            pose_leave(pose, reference->own_points[i], reference->points[i]);
        polygon_plane(polygon, &reference->points[polygon->first]);
    }
}

bool reference_init(struct reference *reference, const struct mesh *mesh, unsigned w_px, unsigned h_px,
                    struct error *err)
{
    const size_t pixel_count = (size_t)w_px * h_px;
    *reference = (struct reference){.w_px = w_px, .h_px = h_px};
    reference->faces = calloc(pixel_count, sizeof reference->faces[0]);
    reference->mappings = calloc(pixel_count, sizeof reference->mappings[0]);
    reference->depths_m = calloc(pixel_count, sizeof reference->depths_m[0]);
    bool ok = (reference->faces && reference->mappings && reference->depths_m) ||
              error_set(err, "reference picture: out of memory");
    ok = ok && reference_add(reference, mesh, 0, err);
    if (!ok) reference_free(reference);
    return ok;
}

bool reference_read(struct reference *reference, const char *model_path, const struct orientation *orientation,
                    const struct grid *grid, unsigned w_px, unsigned h_px, struct error *err)
{
    struct model model;
    struct mesh mesh;
    if (!model_read(model_path, orientation, &model, err)) return false;
    bool ok = source_take(model_path, &model, err);
    const struct model view = source_view(&model);
    const bool shares_importer = !model.source_points;
    ok = ok && (mesh_clean_fine(&view, grid, &mesh, err) || error_prefix(err, model_path));
    model_free(&model);
    if (!ok) return false;
    ok = reference_init(reference, &mesh, w_px, h_px, err);
    reference->shares_importer = shares_importer;
    mesh_free(&mesh);
    return ok;
}

void reference_free(struct reference *reference)
{
    free(reference->points);
    free(reference->own_points);
    free(reference->polygons);
    free(reference->bounds);
    near_tiles_free(&reference->tiles);
    free(reference->edges);
    free(reference->faces);
    free(reference->mappings);
    free(reference->depths_m);
    memset(reference, 0, sizeof *reference);
}
