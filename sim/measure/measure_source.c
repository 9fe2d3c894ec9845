/* SPDX-License-Identifier: MIT
 *
 * The same steps as compile_model() takes, with what is known on the way kept: the reference sees the
 * faces before any are merged, and every point of the mesh can be found by its place on the grid. */
#include "measure/measurement.h"

#include "accuracy/moving_reference.h"
#include "accuracy/predict.h"
#include "base/deadline.h"
#include "base/grow.h"
#include "base/vec3.h"
#include "compiler/compile.h"
#include "compiler/coordinates.h"
#include "compiler/decision.h"
#include "compiler/faithful.h"
#include "compiler/moving_compile.h"
#include "compiler/texture_budget.h"
#include "core/core.h"
#include "model/baked_light.h"
#include "model/model_part.h"
#include "readers/model_read.h"
#include "readers/source.h"
#include "scene/moving.h"
#include "scene/vertex_units.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The point of the grid that is nearest to a place, units, as a key; halves go up. Points of a long scene may share
 * one: who looks up compares distances. */
static uint64_t grid_key(const double units[3])
{
    uint64_t key = 0;
    for (int i = 0; i < 3; i++)
        key = (key << 16 | key >> 48) ^ (uint32_t)(int32_t)floor(units[i] + 0.5);
    return key;
}

static uint64_t point_key(const struct mesh *mesh, const double point_m[3])
{
    double units[3];
    for (int i = 0; i < 3; i++)
        units[i] = (point_m[i] - mesh->grid.origin_m[i]) * mesh->grid.units_per_m;
    return grid_key(units);
}

static void index_points(struct measure_source *source)
{
    const struct mesh *mesh = &source->mesh;
    source->next_point = grow_zeroed(mesh->point_count, sizeof *source->next_point);
    for (uint32_t i = 0; i < mesh->point_count; i++) {
        uint32_t *first = map_at(&source->points, point_key(mesh, mesh->points[i]), MEASURE_NO_POINT);
        source->next_point[i] = *first;
        *first = i;
    }
}

/* The mesh of what stands still, and what is asked of all: how faces are grouped, and where the reference has them. */
static bool read_moving(struct measure_source *source, const struct compile_options *options, unsigned w_px,
                        unsigned h_px, struct error *err)
{
    struct moving *moving = source->still.moving;
    struct model part;
    uint32_t *numbers, *groups;
    model_part(&moving->model, 0, true, &part, &numbers);
    bool ok = moving_clean_still(moving, &part, &source->mesh, err) &&
              (options->keep_faces || mesh_merge(&source->mesh, err)) && mesh_insert_t_vertices(&source->mesh, err);
    model_free(&part);
    free(numbers);
    if (!ok || !moving_groups(moving, &groups, err)) return false;
    free(source->mesh.merged_into);
    source->mesh.merged_into = groups;
    if (!moving_reference(moving, &source->reference, w_px, h_px, err)) return false;
    index_points(source);
    return true;
}

static bool read_mesh(struct measure_source *source, const struct model *model, const struct compile_options *options,
                      unsigned w_px, unsigned h_px, struct error *err)
{
    struct mesh *mesh = &source->mesh;
    const struct model view = source_view(model);
    if (!coordinates_clean(model, options, mesh, err)) return false;
    if (!mesh_clean_fine(&view, &mesh->grid, &source->fine, err) ||
        !reference_init(&source->reference, &source->fine, w_px, h_px, err) ||
        !(options->keep_faces || mesh_merge(mesh, err)) || !mesh_insert_t_vertices(mesh, err))
        return false;
    index_points(source);
    return true;
}

/* What is known of movers while frames are compared hangs on no precision; the scene itself is compiled for each. So
 * the one that loses the least does where fast is refused. */
static bool compile_still(struct measure_source *source, const struct compile_options *options, struct error *err)
{
    struct compile_options exact = *options;
    exact.core = &core_exact;
    return moving_compile_own(source->path, options, MOVING_ON, &source->still, err) ||
           (!deadline_passed() && moving_compile_own(source->path, &exact, MOVING_ON, &source->still, err));
}

bool measure_source_read(struct measure_source *source, const char *model_path, const struct compile_options *options,
                         unsigned w_px, unsigned h_px, struct error *err)
{
    struct model model;
    *source = (struct measure_source){.path = strdup(model_path)};
    if (!source->path) return error_set(err, "%s: out of memory", model_path);
    bool ok = model_read(model_path, &options->orientation, &model, err);
    ok = ok && source_take(model_path, &model, err);
    if (ok) model_tell(model_path, &model);
    const bool moves = ok && model.mover_count > 0;
    if (ok) (options->unlit ? light_none : light_bake)(&model);
    if (ok && !moves)
        ok = (texture_budget_apply(&model, options, err) && read_mesh(source, &model, options, w_px, h_px, err)) ||
             error_prefix(err, model_path);
    if (ok && moves)
        ok = compile_still(source, options, err) && source_take(model_path, &source->still.moving->model, err) &&
             (read_moving(source, options, w_px, h_px, err) || error_prefix(err, model_path));
    model_free(&model);
    if (!ok) measure_source_free(source);
    return ok;
}

static void vertex_drawn_units(const struct lim_scene *scene, lim_index vertex, double out[3])
{
    vertex_units(scene, vertex, out);
    if (!scene->fractions) return;
    const struct lim_fraction *fraction = &scene->fractions[vertex];
    out[0] += fraction->x_q8 / 256.0;
    out[1] += fraction->y_q8 / 256.0;
    out[2] += fraction->z_q8 / 256.0;
}

/* Among the mesh's points that round to a place, the one nearest to the vertex, if any is nearer than
 * the best so far. */
static void find_nearer(const struct measure_source *source, const double place[3], const double vertex_m[3],
                        double *best2, double out_m[3])
{
    const uint32_t *first = map_find(&source->points, grid_key(place));
    for (uint32_t i = first ? *first : MEASURE_NO_POINT; i != MEASURE_NO_POINT; i = source->next_point[i]) {
        const double distance2 = vec3_distance2(source->mesh.points[i], vertex_m);
        if (distance2 >= *best2) continue;
        *best2 = distance2;
        memcpy(out_m, source->mesh.points[i], sizeof source->mesh.points[i]);
    }
}

/* A vertex with fractions may have been rounded over the border between two points of the grid: what
 * lies half a fraction's last place to either side of it, along each axis, is looked up. */
bool measure_source_point(const struct measure_source *source, const struct lim_scene *scene, lim_index vertex,
                          double out_m[3])
{
    const struct grid *grid = &source->mesh.grid;
    const double reach = scene->fractions ? 1.0 / 512.0 : 0.0;
    double units[3], vertex_m[3], best2 = INFINITY;
    vertex_drawn_units(scene, vertex, units);
    for (int i = 0; i < 3; i++)
        vertex_m[i] = grid->origin_m[i] + units[i] / grid->units_per_m;
    for (int sides = 0; sides < 8; sides++) {
        double place[3];
        for (int i = 0; i < 3; i++)
            place[i] = units[i] + (sides >> i & 1 ? reach : -reach);
        find_nearer(source, place, vertex_m, &best2, out_m);
    }
    return best2 < INFINITY;
}

void measure_source_free(struct measure_source *source)
{
    reference_free(&source->reference);
    mesh_free(&source->mesh);
    mesh_free(&source->fine);
    map_free(&source->points);
    free(source->next_point);
    compiled_free(&source->still);
    free(source->path);
    *source = (struct measure_source){0};
}

bool measure_source_compile(const struct measure_source *source, const struct compile_options *options,
                            struct compiled *scene, struct error *err)
{
    if (!source->still.moving) return decision_make(&source->mesh, &source->fine, options, scene, err);
    return moving_compile_own(source->path, options, MOVING_ON, scene, err);
}

/* What moves is named with the model's path in front, which whoever asks for a scene knows. */
static void cut_path(char *text, const char *path)
{
    const size_t path_b = strlen(path);
    if (strncmp(text, path, path_b) == 0 && strncmp(text + path_b, ": ", 2) == 0)
        memmove(text, text + path_b + 2, strlen(text + path_b + 2) + 1);
}

bool measure_scene_for(struct measure_scenes *scenes, const struct measure_source *source, const struct core *core,
                       const struct compile_options *options, const struct compiled **out, struct error *err)
{
    struct compiled *scene = &scenes->of[core->profile];
    struct error *refused = &scenes->refused[core->profile];
    struct compile_options mine = *options;
    mine.core = cores[core->profile];
    *out = scene;
    if (scene->image) return true;
    if (!*refused->text && measure_source_compile(source, &mine, scene, refused)) {
        *refused->text = '\0';
        return true;
    }
    cut_path(refused->text, source->path);
    *err = *refused;
    return false;
}

bool measure_compile(struct measure_scenes *scenes, const struct measure_source *source,
                     const struct compile_options *options, struct measure_candidate *candidates, size_t *count,
                     struct measure_refusals *refused, struct error *err)
{
    const double share = 0.5; /* the rest is for pictures and instructions */
    const struct deadline_end whole = deadline_end();
    const size_t wanted = *count;
    *count = 0;
    for (size_t i = 0; i < wanted; i++) {
        struct measure_candidate *candidate = &candidates[*count];
        candidate->core = candidates[i].core;
        if (measure_scene_for(scenes, source, candidate->core, options, &candidate->scene, err)) {
            if (!(*count)++) deadline_share(share);
        } else if (!deadline_passed()) {
            measure_refusals_add(refused, candidate->core, err);
        } else if (*count) {
            deadline_say("precisions without %s", candidate->core->name);
        } else {
            return error_prefix(err, source->path);
        }
    }
    deadline_restore(whole);
    return *count || measure_refusals_set(refused, source->path, err);
}

void measure_scenes_free(struct measure_scenes *scenes)
{
    for (int i = 0; i < MEASURE_PROFILES; i++)
        compiled_free(&scenes->of[i]);
}
