/* SPDX-License-Identifier: MIT */
#include "readers/source.h"

#include "base/grow.h"
#include "base/vec3.h"
#include "files/whole_file.h"
#include "model/model_orientation.h"

#include <stdlib.h>
#include <string.h>

static const double ROUNDING = 1e-12; /* of what a chain of transforms leaves, in parts of the reach */

void source_corner(struct source *source, const double at_m[3])
{
    source->corners = grow(source->corners, source->corner_count, &source->corner_capacity, sizeof *source->corners);
    memcpy(source->corners[source->corner_count++], at_m, sizeof *source->corners);
    for (int axis = 0; axis < 3; axis++)
        source->reach_m = fmax(source->reach_m, fabs(at_m[axis]));
}

void source_face(struct source *source)
{
    const size_t count = source->corner_count - source->ended;
    if (count < 3) {
        source->corner_count = source->ended;
        return;
    }
    source->counts = grow(source->counts, source->face_count, &source->face_capacity, sizeof *source->counts);
    source->counts[source->face_count++] = (uint32_t)count;
    source->ended = source->corner_count;
}

void source_free(struct source *source)
{
    free(source->counts);
    free(source->corners);
    source_motion_free(&source->motion);
    *source = (struct source){0};
}

static enum source_result read_any(const char *path, struct source *source, struct error *err)
{
    static const struct {
        const char *suffix;
        enum source_result (*read)(const char *, struct source *, struct error *);
    } readers[] = {{".obj", source_obj_read},
                   {".ply", source_ply_read},
                   {".stl", source_stl_read},
                   {".gltf", source_gltf_read},
                   {".glb", source_gltf_read}};
    for (size_t i = 0; i < sizeof readers / sizeof *readers; i++)
        if (path_has_suffix(path, readers[i].suffix)) return readers[i].read(path, source, err);
    return SOURCE_UNKNOWN;
}

/* Faces are compared in their order, corners in theirs. */
static bool place_points(const char *path, struct source *source, const struct model *model, double (*points)[3],
                         struct error *err)
{
    double(*corner)[3] = source->corners;
    const size_t face_count = model->face_count - model->made_faces;
    if (source->face_count != face_count)
        return error_set(err, "%s: the importer finds %zu faces in it, the reference's reader %zu", path, face_count,
                         source->face_count);
    for (size_t i = 0; i < face_count; i++) {
        const struct model_face *face = &model->faces[i];
        if (source->counts[i] != face->count)
            return error_set(err, "%s: face %zu: the importer finds %u corners, the reference's reader %u", path, i + 1,
                             face->count, source->counts[i]);
        for (uint32_t k = 0; k < face->count; k++, corner++) {
            const uint32_t at = model->faces_were_reversed ? face->count - 1 - k : k;
            const uint32_t point = model->corners[face->first + at];
            orientation_point(model, *corner);
            const double apart_m = sqrt(vec3_distance2(model->points[point], *corner));
            if (!(apart_m <= ROUNDING * source->reach_m))
                return error_set(
                    err, "%s: face %zu: the importer and the reference's reader have its corner %u %.3g m apart", path,
                    i + 1, k + 1, apart_m);
            memcpy(points[point], *corner, sizeof *points);
        }
    }
    return true;
}

static void take_motion(struct source *source, struct model *model)
{
    if (!source->motion.count || !model->mover_count) return;
    model->source_motion = grow_zeroed(1, sizeof *model->source_motion);
    *model->source_motion = source->motion;
    source->motion = (struct source_motion){0};
}

bool source_find(const char *path, struct model *model, bool *known, struct error *err)
{
    struct source source = {0};
    *known = !model->has_no_source;
    if (model->source_points || model->has_no_source) return true;
    const enum source_result result = read_any(path, &source, err);
    bool ok = result != SOURCE_BAD;
    *known = result != SOURCE_UNKNOWN;
    model->has_no_source = !*known;
    if (result == SOURCE_READ) {
        double(*points)[3] = grow_zeroed(model->point_count, sizeof *points);
        memcpy(points, model->points, model->point_count * sizeof *points);
        ok = place_points(path, &source, model, points, err);
        if (ok)
            model->source_points = points;
        else
            free(points);
        if (ok) take_motion(&source, model);
    }
    source_free(&source);
    return ok;
}

bool source_take(const char *path, struct model *model, struct error *err)
{
    bool known;
    if (!source_find(path, model, &known, err)) return false;
    if (!known)
        model_note(model, "the reference has the importer's vertices: it has no reader of its own for this file");
    return true;
}

struct model source_view(const struct model *model)
{
    struct model view = *model;
    if (model->source_points) view.points = model->source_points;
    return view;
}
