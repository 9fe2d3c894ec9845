/* SPDX-License-Identifier: MIT
 *
 * A model made fit for the tree: mesh_clean() welds its points, and mends or drops its faces, each
 * on its own, in the file's order. */
#include "model/mesh.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "base/rgb888.h"
#include "model/grid.h"
#include "model/inner.h"
#include "model/loop.h"
#include "model/mapping.h"
#include "model/original.h"
#include "model/polygon_list.h"
#include "model/triangulate.h"
#include "model/weld.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { INVISIBLE = 255 /* as a transparency */, FINER = 256 /* than the grid */, UNWELDED = 4096 /* than that */ };

struct cleaning {
    const struct model *model;
    struct mesh *mesh;
    struct polygon_list list;
    const uint32_t *welded; /* for each point of the model that of the mesh */
    double near_m, flat_m;
    size_t first_too_small; /* index of the face */
};

/* The longest side of a face's bounds in the model. */
static double face_size_m(const struct model *model, const struct model_face *face)
{
    double size_m = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double low_m = DBL_MAX, high_m = -DBL_MAX;
        for (uint32_t k = 0; k < face->count; k++) {
            const double at_m = model->points[model->corners[face->first + k]][axis];
            low_m = fmin(low_m, at_m);
            high_m = fmax(high_m, at_m);
        }
        size_m = fmax(size_m, high_m - low_m);
    }
    return size_m;
}

/* A face without area on the grid: had it one in the model? */
static void note_dropped(struct cleaning *cleaning, size_t index)
{
    const struct model_face *face = &cleaning->model->faces[index];
    const struct loop loop = {cleaning->model->points, &cleaning->model->corners[face->first], face->count};
    if (face->count < 3 || !loop_has_area(&loop, face_size_m(cleaning->model, face) * 1e-6)) {
        cleaning->mesh->counts.zero_area++;
        return;
    }
    if (cleaning->mesh->counts.too_small++ == 0) cleaning->first_too_small = index;
}

static bool refuse_nothing_left(const struct cleaning *cleaning, struct error *err)
{
    const struct mesh_counts *counts = &cleaning->mesh->counts;
    if (counts->invisible == counts->faces)
        return error_set(err, "every face is invisible: the opacity of all materials is 0");
    if (!counts->too_small) return error_set(err, "no face has an area: the corners of each are on one line");
    const size_t face = cleaning->first_too_small;
    return error_set(err, "face %u is %.3g m wide and a unit of the grid %.3g m: nothing would be left",
                     model_face_number(cleaning->model, face),
                     face_size_m(cleaning->model, &cleaning->model->faces[face]),
                     1.0 / cleaning->mesh->grid.units_per_m);
}

static bool add_if_area(struct cleaning *cleaning, const struct loop *loop, const struct mesh_polygon *like)
{
    if (!loop_has_area(loop, cleaning->near_m)) return false;
    polygon_list_add(&cleaning->list, loop->corners, loop->count, like);
    return true;
}

/* false: the texture is bent over the polygon. */
static bool set_mapping(struct cleaning *cleaning, const struct loop *loop, struct mesh_polygon *polygon)
{
    bool is_affine;
    const struct model_face *face = &cleaning->model->faces[polygon->face - 1];
    polygon->mapping = mapping_add(cleaning->mesh, cleaning->model, face, cleaning->welded, loop, &is_affine);
    const struct texture *texture = face->picture ? &cleaning->mesh->textures[face->picture - 1] : NULL;
    if (!polygon->mapping && texture && texture->texel_count)
        polygon->colour = rgb888_times(texture->mean, face->colour);
    return is_affine;
}

static bool add_triangles(struct cleaning *cleaning, const struct loop *loop, const struct loop_plane *plane,
                          const struct mesh_polygon *like)
{
    bool any = false;
    const struct loop_view view = loop_view_along(plane->normal);
    uint32_t(*triangles)[3] = grow_zeroed(loop->count - 2, sizeof *triangles);
    triangulate(loop, &view, triangles);
    for (size_t i = 0; i < loop->count - 2; i++) {
        const struct loop triangle = {loop->points, triangles[i], 3};
        for (int k = 0; k < 3; k++)
            inner_add(cleaning->mesh, triangles[i][k], triangles[i][(k + 1) % 3]);
        struct mesh_polygon piece = *like;
        if (loop_has_area(&triangle, cleaning->near_m)) set_mapping(cleaning, &triangle, &piece);
        any |= add_if_area(cleaning, &triangle, &piece);
    }
    free(triangles);
    return any;
}

/* `corners` are the face's, welded; they are tidied in place. */
static void clean_face(struct cleaning *cleaning, uint32_t *corners, size_t count, const struct mesh_polygon *like)
{
    struct mesh *mesh = cleaning->mesh;
    const struct loop loop = {mesh->points, corners, loop_tidy(mesh->points, corners, count, cleaning->near_m)};
    if (!loop_has_area(&loop, cleaning->near_m)) {
        note_dropped(cleaning, like->face - 1);
        return;
    }
    const struct loop_plane plane = loop_plane_of(&loop);
    bool flat = loop_off_plane_m(&loop, &plane) <= cleaning->flat_m;
    bool whole = flat && loop_is_convex(&loop, &plane, cleaning->near_m);
    if (!flat)
        mesh->counts.non_planar++;
    else if (!whole)
        mesh->counts.concave++;
    struct mesh_polygon polygon = *like;
    if (whole && !set_mapping(cleaning, &loop, &polygon)) {
        whole = false;
        mesh->counts.bent++;
    }
    bool any = whole ? add_if_area(cleaning, &loop, &polygon) : add_triangles(cleaning, &loop, &plane, like);
    mesh->merged_into[like->face] = any ? like->face : 0;
}

/* All edges of triangles were added: those of faces, of this one or another, are none. */
static void remove_outlines(struct mesh *mesh, const struct model *model, const uint32_t *welded)
{
    for (size_t i = 0; i < model->face_count && mesh->inner.count; i++) {
        const uint32_t *corners = &model->corners[model->faces[i].first];
        const uint32_t count = model->faces[i].count;
        for (uint32_t k = 0; k < count; k++)
            inner_remove(mesh, welded[corners[k]], welded[corners[k + 1 < count ? k + 1 : 0]]);
    }
}

static void clean_faces(struct cleaning *cleaning, const struct model *model, const uint32_t *welded)
{
    uint32_t *corners = NULL;
    size_t capacity = 0;
    for (size_t i = 0; i < model->face_count && !deadline_passed(); i++) {
        const struct model_face *face = &model->faces[i];
        progress_bar(i, model->face_count, "faces");
        if (face->transparency == INVISIBLE) {
            cleaning->mesh->counts.invisible++;
            continue;
        }
        for (uint32_t k = 0; k < face->count; k++) {
            corners = grow(corners, k, &capacity, sizeof *corners);
            corners[k] = welded[model->corners[face->first + k]];
        }
        const struct mesh_polygon like = {.face = (uint32_t)i + 1,
                                          .colour = face->colour,
                                          .transparency = face->transparency,
                                          .two_sided = face->two_sided};
        clean_face(cleaning, corners, face->count, &like);
    }
    progress_end();
    free(corners);
}

/* fine: for the reference, which knows no other original, and to which what is near is not welded. */
static bool clean_on(const struct model *model, const struct grid *grid, struct mesh *mesh, bool fine,
                     struct error *err)
{
    *mesh = (struct mesh){.counts = {.faces = model->face_count, .clamped = model->alpha_clamped},
                          .is_interior = model->is_interior,
                          .grid = *grid};
    if (!mesh_textures_make(model, mesh, err)) {
        mesh_free(mesh);
        return false;
    }
    struct cleaning cleaning = {
        .model = model, .mesh = mesh, .near_m = grid_near_m(&mesh->grid), .flat_m = grid_flat_m(&mesh->grid)};
    mesh->merged_into = grow_zeroed(model->face_count + 1, sizeof *mesh->merged_into);
    uint32_t *welded = weld_points(model, grid_weld_m(&mesh->grid) / (fine ? UNWELDED : 1), mesh);
    cleaning.welded = welded;
    bool ok = deadline_check(err, "points were still welded");
    if (ok) clean_faces(&cleaning, model, welded);
    if (ok) remove_outlines(mesh, model, welded);
    if (ok && !fine) mesh->original = original_make(model, grid, welded);
    free(welded);
    ok = polygon_list_move(&cleaning.list, mesh, ok ? err : &(struct error){0}) && ok;
    ok = ok && deadline_check(err, "faces were still triangulated") &&
         (mesh->polygon_count > 0 || refuse_nothing_left(&cleaning, err));
    if (!ok) mesh_free(mesh);
    return ok;
}

bool mesh_clean(const struct model *model, struct mesh *mesh, struct error *err)
{
    struct grid grid;
    *mesh = (struct mesh){0};
    return grid_choose(model, &grid, err) && mesh_clean_on(model, &grid, mesh, err);
}

bool mesh_clean_on(const struct model *model, const struct grid *grid, struct mesh *mesh, struct error *err)
{
    return clean_on(model, grid, mesh, false, err);
}

bool mesh_clean_fine(const struct model *model, const struct grid *grid, struct mesh *mesh, struct error *err)
{
    struct grid fine;
    *mesh = (struct mesh){0};
    if (grid)
        fine = *grid;
    else if (!grid_choose(model, &fine, err))
        return false;
    fine.units_per_m *= FINER;
    return clean_on(model, &fine, mesh, true, err);
}

void mesh_free(struct mesh *mesh)
{
    free(mesh->points);
    free(mesh->corners);
    free(mesh->polygons);
    free(mesh->merged_into);
    free(mesh->pieces);
    map_free(&mesh->inner);
    original_free(mesh->original);
    free(mesh->mappings);
    free(mesh->notes);
    for (size_t i = 0; i < mesh->texture_count; i++)
        texture_free(&mesh->textures[i]);
    free(mesh->textures);
    *mesh = (struct mesh){0};
}
