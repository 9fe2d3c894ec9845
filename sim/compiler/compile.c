/* SPDX-License-Identifier: MIT
 *
 * A model is read, lit, cleaned and compiled; what comes of it is held against the file's faces. */
#include "compiler/compile.h"

#include "accuracy/predict.h"
#include "accuracy/promise.h"
#include "base/grow.h"
#include "compiler/coordinates.h"
#include "compiler/decision.h"
#include "compiler/faithful.h"
#include "compiler/order_choice.h"
#include "compiler/texture_budget.h"
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
static bool clean_for_reference(const struct model *model, const struct grid *grid, struct mesh *fine,
                                struct error *err)
{
    struct model flat = source_view(model);
    flat.picture_count = 0;
    flat.faces = grow_zeroed(model->face_count, sizeof *flat.faces);
    for (size_t i = 0; i < model->face_count; i++) {
        flat.faces[i] = model->faces[i];
        flat.faces[i].picture = 0;
    }
    const bool ok = mesh_clean_fine(&flat, grid, fine, err);
    free(flat.faces);
    return ok;
}

static bool predict(const struct mesh *mesh, const struct mesh *fine, const struct compile_options *options,
                    struct compiled *out, struct error *err)
{
    struct reference reference = {0};
    const bool ok =
        reference_init(&reference, fine, PREDICT_SIDE_PX, PREDICT_SIDE_PX, err) &&
        predict_wrong(out, options->core, &reference, mesh->merged_into, mesh->counts.faces, &out->report.wrong, err);
    reference_free(&reference);
    return ok;
}

/* Which faces of the file are one polygon, is kept for whoever compares pictures. */
static void keep_groups(struct compiled *out, struct mesh *mesh)
{
    out->groups = mesh->merged_into;
    mesh->merged_into = NULL;
}

static bool compile_cleaned(const struct model *model, struct mesh *mesh, const struct compile_options *options,
                            struct compiled *out, struct error *err)
{
    struct mesh fine = {0};
    const bool is_asked = options->predict || decision_asks_reference(options);
    const bool ok = (options->keep_faces || mesh_merge(mesh, err)) && mesh_insert_t_vertices(mesh, err) &&
                    (!is_asked || clean_for_reference(model, &mesh->grid, &fine, err)) &&
                    decision_make(mesh, is_asked ? &fine : NULL, options, out, err) &&
                    (!options->predict || predict(mesh, &fine, options, out, err));
    mesh_free(&fine);
    if (!ok) return false;
    report_notes(&out->report, mesh);
    promise_note(out);
    keep_groups(out, mesh);
    return true;
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

bool compile_source(const char *path, struct model *model, const struct compile_options *options, struct error *err)
{
    bool known;
    if (!options->predict && !decision_asks_reference(options)) return true;
    return options->predict ? source_take(path, model, err) : source_find(path, model, &known, err);
}

static bool compile_one(const struct model *model, const struct compile_options *options, struct compiled *out,
                        struct error *err)
{
    const struct compile_options own = order_options_for(options, model);
    return compile_part(model, NULL, &own, out, err);
}

bool compile_model(const char *path, const struct compile_options *options, struct compiled *out, struct error *err)
{
    struct model model;
    *out = (struct compiled){0};
    motions_leave_out(true); /* nothing moves in a scene alone */
    if (!model_read(path, &options->orientation, &model, err)) return false;
    bool ok = compile_source(path, &model, options, err);
    compile_options_light(options, &model);
    ok = ok && ((texture_budget_apply(&model, options, err) && compile_one(&model, options, out, err)) ||
                error_prefix(err, path));
    model_free(&model);
    return ok;
}
