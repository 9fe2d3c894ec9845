/* SPDX-License-Identifier: MIT
 *
 * By distance is tried before by depth, as it is cheaper; each has to be cheaper than the tree by enough to be no mere
 * guess. What is wrong in whichever is worse, all cameras or those that have all in view, counts: large triangles err
 * in some views and dense ones in others. */
#include "compiler/mesh_choice.h"

#include "accuracy/predict.h"
#include "base/deadline.h"
#include "compiler/compile_mesh.h"
#include "compiler/order_choice.h"
#include "core/core.h"
#include "model/original.h"
#include "scene/mcu_mem.h"

#include <math.h>

static const double ENOUGH = 0.95; /* of the instructions of the tree */

/* Wrong pixels in percent that profiles promise: sim/README.md. Draft promises none: it is held against the tree. */
double mesh_choice_promised_percent(const struct core *core)
{
    switch (core ? core->profile : LIM_PROFILE_FAST) {
    case LIM_PROFILE_FAST:
        return 0.05;
    case LIM_PROFILE_FINE:
        return 0.03;
    default:
        return 0.0;
    }
}

static bool is_open(const struct compile_options *options, const struct compiled *scene)
{
    const struct compile_report *report = &scene->report;
    if (!options->choose_order || options->method || options->tree != TREE_AUTO) return false;
    if (options->core && options->core->profile == LIM_PROFILE_EXACT) return false;
    if (options->framebuffer || report->left_out) return false;
    if (order_needs_nearest(options, &scene->scene) || options->portals == PORTALS_ON || scene->scene.place_count)
        return false;
    return !isnan(report->instructions) && !report->convex;
}

static bool try_one(const struct mesh *mesh, const struct compile_options *options, const char *name,
                    const struct compiled *scene, struct mesh_trial *trial, struct compiled *out)
{
    struct compile_options own = *options;
    struct error ignored;
    *trial = (struct mesh_trial){.instructions = NAN, .wrong_percent = NAN};
    own.choose_order = false;
    if (!compile_method_parse(name, &own, &ignored) || !compile_options_settle(&own, &ignored) ||
        !compile_mesh(mesh, &own, out, &ignored))
        return false;
    out->original = mesh->original ? original_share(mesh->original) : NULL;
    out->report.near_m = scene->report.near_m;
    trial->instructions = out->report.instructions;
    if (!deadline_passed() && trial->instructions <= ENOUGH * scene->report.instructions) return true;
    compiled_free(out);
    return false;
}

bool mesh_choice_try(const struct mesh *mesh, const struct compile_options *options, struct compiled *scene,
                     struct mesh_trials *trials)
{
    *trials = (struct mesh_trials){0};
    if (!is_open(options, scene)) return false;
    struct mesh_choice *choice = &scene->report.as_mesh;
    *choice = (struct mesh_choice){.tried = true,
                                   .tree_instructions = scene->report.instructions,
                                   .tree_wrong_percent = NAN,
                                   .tree_mem_b = mcu_mem_b(scene),
                                   .tree_flash_b = scene->report.flash_b};
    const bool by_distance = try_one(mesh, options, "mesh", scene, &choice->by_distance, &trials->by_distance);
    const bool by_depth = try_one(mesh, options, "mesh-depth", scene, &choice->by_depth, &trials->by_depth);
    return by_distance || by_depth;
}

/* The worse of all and of portraits. */
static double worst_percent(const struct predicted *wrong)
{
    return wrong->portrait_cameras ? fmax(wrong->percent, wrong->portrait_percent) : wrong->percent;
}

static void take(struct compiled *scene, struct compiled *candidate, struct mesh_trial *trial)
{
    const struct compiled worse = *scene;
    trial->taken = true;
    candidate->report.as_mesh = scene->report.as_mesh;
    *scene = *candidate;
    *candidate = worse;
}

/* A scene that even the tree draws with more wrong pixels than promised is not drawn as right by anything. */
static double bound_percent(const struct compile_options *options, double tree_percent)
{
    const double promised =
        options->wrong_percent > 0 ? options->wrong_percent : mesh_choice_promised_percent(options->core);
    return fmax(promised, tree_percent);
}

bool mesh_choice_settle(struct mesh_trials *trials, const struct compile_options *options, struct reference *reference,
                        const uint32_t *groups, struct compiled *scene, struct error *err)
{
    struct mesh_choice *choice = &scene->report.as_mesh;
    struct compiled *const candidates[2] = {&trials->by_distance, &trials->by_depth};
    struct mesh_trial *const rows[2] = {&choice->by_distance, &choice->by_depth};
    const struct compiled *scenes[3] = {scene};
    struct predicted wrong[3];
    size_t count = 1;
    for (int i = 0; i < 2; i++)
        if (candidates[i]->scene.polygon_count) scenes[count++] = candidates[i];
    if (!predict_held_out(scenes, count, options->core, reference, groups, wrong, err)) return false;
    choice->cameras = wrong[0].cameras;
    choice->tree_wrong_percent = worst_percent(&wrong[0]);
    choice->bound_percent = bound_percent(options, choice->tree_wrong_percent);
    for (size_t i = 0, k = 1; i < 2; i++)
        if (candidates[i]->scene.polygon_count) rows[i]->wrong_percent = worst_percent(&wrong[k++]);
    struct compiled *best = NULL;
    struct mesh_trial *taken = NULL;
    for (int i = 0; i < 2; i++) {
        if (!(rows[i]->wrong_percent <= choice->bound_percent)) continue; /* NaN: not looked at, or out of time */
        if (best && rows[i]->instructions >= taken->instructions) continue;
        best = candidates[i];
        taken = rows[i];
    }
    if (best) take(scene, best, taken);
    return true;
}

void mesh_trials_free(struct mesh_trials *trials)
{
    compiled_free(&trials->by_distance);
    compiled_free(&trials->by_depth);
}
