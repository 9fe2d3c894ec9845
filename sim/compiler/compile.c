/* SPDX-License-Identifier: MIT
 *
 * A model is read, lit, cleaned and compiled; what comes of it is held against the file's faces. */
#include "compiler/compile.h"

#include "accuracy/predict.h"
#include "base/grow.h"
#include "compiler/coordinates.h"
#include "compiler/faithful.h"
#include "compiler/mesh_choice.h"
#include "compiler/mesh_leaf_choice.h"
#include "compiler/texture_budget.h"
#include "core/core.h"
#include "model/original.h"
#include "readers/import_motion.h"
#include "readers/model_read.h"
#include "readers/source.h"

#include <stdlib.h>
#include <string.h>

static void report_notes(struct compile_report *report, const struct mesh *mesh)
{
    if (!mesh->note_count) return;
    report->notes = grow_zeroed(mesh->note_count, sizeof *report->notes);
    memcpy(report->notes, mesh->notes, mesh->note_count * sizeof *report->notes);
    report->note_count = mesh->note_count;
}

/* The reference sees the file's faces, all of them and unrounded, at the points of its own reader; which picture they
 * show is not asked. */
static bool predict_reference(const struct model *model, const struct grid *grid, struct reference *reference,
                              struct error *err)
{
    struct model flat = source_view(model);
    struct mesh fine;
    flat.picture_count = 0;
    flat.faces = grow_zeroed(model->face_count, sizeof *flat.faces);
    for (size_t i = 0; i < model->face_count; i++) {
        flat.faces[i] = model->faces[i];
        flat.faces[i].picture = 0;
    }
    bool ok = mesh_clean_fine(&flat, grid, &fine, err);
    free(flat.faces);
    if (!ok) return false;
    ok = reference_init(reference, &fine, PREDICT_SIDE_PX, PREDICT_SIDE_PX, err);
    mesh_free(&fine);
    return ok;
}

/* What the reference has a say in. */
static bool compile_held_against(const struct model *model, const struct mesh *mesh,
                                 const struct compile_options *options, struct compiled *out, struct error *err)
{
    struct reference reference = {0};
    struct mesh_trials trials;
    struct leaf_trial leaves = {0};
    const bool may_be_mesh = mesh_choice_try(mesh, options, out, &trials);
    const bool known = may_be_mesh || options->predict;
    bool ok = !known || predict_reference(model, &mesh->grid, &reference, err);
    if (ok && may_be_mesh) ok = mesh_choice_settle(&trials, mesh, options, &reference, mesh->merged_into, out, err);
    if (ok && leaf_trial_begin(&leaves, mesh, options, out))
        ok = (known || predict_reference(model, &mesh->grid, &reference, err)) &&
             leaf_trial_settle(&leaves, &reference, mesh->merged_into, out, err);
    if (ok && options->predict)
        ok = predict_wrong(out, options->core, &reference, mesh->merged_into, &out->report.wrong, err);
    reference_free(&reference);
    mesh_trials_free(&trials);
    leaf_trial_free(&leaves);
    return ok;
}

static bool compile_cleaned(const struct model *model, struct mesh *mesh, const struct compile_options *options,
                            struct compiled *out, struct error *err)
{
    bool ok = (options->keep_faces || mesh_merge(mesh, err)) && mesh_insert_t_vertices(mesh, err) &&
              faithful_compile(mesh, options, out, err);
    out->report.near_m = options->near_m;
    ok = ok && compile_held_against(model, mesh, options, out, err);
    if (ok) report_notes(&out->report, mesh);
    out->report.core = options->core ? options->core : &core_fast;
    return ok;
}

/* What the grid alone did not tell: the tree's planes break the promise of some face. */
static bool compile_long(const struct model *model, const struct compile_options *options, struct compiled *out,
                         struct error *err)
{
    struct compile_options own = *options;
    struct mesh mesh;
    own.coordinates = COORDINATES_32;
    if (!coordinates_clean(model, &own, &mesh, err)) return false;
    const bool ok = compile_cleaned(model, &mesh, &own, out, err);
    mesh_free(&mesh);
    return ok;
}

bool compile_part(const struct model *model, const struct grid *grid, const struct compile_options *options,
                  struct compiled *out, struct error *err)
{
    struct mesh mesh;
    if (!(grid ? mesh_clean_on(model, grid, &mesh, err) : coordinates_clean(model, options, &mesh, err))) return false;
    bool ok = compile_cleaned(model, &mesh, options, out, err);
    const bool may_retry = !ok && !grid && out->report.is_refused && coordinates_may_retry(&mesh, options);
    mesh_free(&mesh);
    return may_retry ? compile_long(model, options, out, err) : ok;
}

bool compile_model(const char *path, const struct compile_options *options, struct compiled *out, struct error *err)
{
    struct model model;
    *out = (struct compiled){0};
    motions_leave_out(true); /* nothing moves in a scene alone */
    if (!model_read(path, &options->orientation, &model, err)) return false;
    bool ok = !options->predict || source_take(path, &model, err);
    compile_options_light(options, &model);
    ok = ok && ((texture_budget_apply(&model, options, err) && compile_part(&model, NULL, options, out, err)) ||
                error_prefix(err, path));
    model_free(&model);
    return ok;
}
