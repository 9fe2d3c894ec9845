/* SPDX-License-Identifier: MIT
 *
 * The candidate has a BSP tree: what other trees are good at, dense parts, it has no planes of. A part errs where a
 * pixel shows one of its polygons, or should, and another is there; as many such pixels as the scene without leaves has
 * are edges. A part that costs more where the eye is near it is left to the tree, whatever the mean of all cameras. */
#include "compiler/mesh_leaf_choice.h"

#include "accuracy/predict.h"
#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "compiler/leaf_places.h"
#include "compiler/mesh_choice.h"
#include "model/original.h"
#include "scene/mcu_mem.h"
#include "trees/splitter.h"

#include <math.h>
#include <stdlib.h>

static const double ENOUGH = 0.95; /* of the instructions without leaves, or of its bytes */
enum { LEFT_OUT_MAX = 4 };

static bool is_open(const struct compile_options *options, const struct compiled *scene)
{
    const bool is_named = options->method || options->tree != TREE_AUTO;
    if (options->mesh_leaves != MESH_LEAVES_AUTO || !options->choose_order) return false;
    if ((is_named && !options->leaves_open) || !compile_options_may_leaf(options) || scene->grid.is_long) return false;
    if (scene->report.left_out || scene->scene.place_count) return false;
    return !isnan(scene->report.instructions);
}

/* In instructions, or, where these are no more, in working memory and in flash. */
static bool is_cheaper(const struct compiled *candidate, const struct compiled *scene)
{
    const double instructions = candidate->report.instructions, before = scene->report.instructions;
    if (instructions <= ENOUGH * before) return true;
    return instructions <= before && mcu_mem_b(candidate) <= mcu_mem_b(scene) &&
           (double)candidate->report.flash_b <= ENOUGH * (double)scene->report.flash_b;
}

/* With the parts that are left. False: there are none, or time is over; then there is no candidate. */
static bool compile_candidate(struct leaf_trial *trial, struct compiled *scene)
{
    struct leaf_report *report = &scene->report.leaf_parts;
    const struct mesh *mesh = trial->work.mesh;
    struct error ignored;
    compiled_free(&trial->candidate);
    if (!parts_taken(&trial->work.parts) || deadline_passed()) return false;
    if (!compilation_tree(&trial->work, TREE_BSP, &trial->candidate, &ignored)) return false;
    trial->candidate.original = mesh->original ? original_share(mesh->original) : NULL;
    trial->candidate.report.near_m = scene->report.near_m;
    report->attempts++;
    report->instructions = trial->candidate.report.instructions;
    return true;
}

/* False: it is no cheaper, and there is no candidate any more. */
static bool keep_if_cheaper(struct leaf_trial *trial, const struct compiled *scene)
{
    if (!deadline_passed() && is_cheaper(&trial->candidate, scene)) return true;
    compiled_free(&trial->candidate);
    return false;
}

static bool compile_leaves(struct leaf_trial *trial, struct compiled *scene)
{
    return compile_candidate(trial, scene) && keep_if_cheaper(trial, scene);
}

/* Parts that are dear from near go first: they may be what makes all of them together dear. On a path its cameras are
 * all that count. */
static bool compile_all_but_dear(struct leaf_trial *trial, struct compiled *scene)
{
    if (!compile_candidate(trial, scene)) return false;
    if (!scene->report.path.count)
        scene->report.leaf_parts.dear_near =
            leaf_places_leave_out(scene, &trial->candidate, trial->options.core, trial->work.mesh, &trial->work.parts);
    return scene->report.leaf_parts.dear_near ? compile_leaves(trial, scene) : keep_if_cheaper(trial, scene);
}

bool leaf_trial_begin(struct leaf_trial *trial, const struct mesh *mesh, const struct compile_options *options,
                      struct compiled *scene)
{
    struct error ignored;
    *trial = (struct leaf_trial){.options = *options};
    if (!is_open(options, scene)) return false;
    trial->options.mesh_leaves = MESH_LEAVES_ALL;
    trial->options.portals = PORTALS_OFF;
    if (scene->report.choice.replaced && scene->report.tree == TREE_BSP) trial->options.splitter = splitter_scout->name;
    if (!compilation_begin(&trial->work, mesh, &trial->options, &ignored) || !parts_taken(&trial->work.parts))
        return false;
    scene->report.leaf_parts = (struct leaf_report){
        .tried = true, .without_instructions = scene->report.instructions, .instructions = NAN, .wrong_percent = NAN};
    return compile_all_but_dear(trial, scene);
}

/* Errors ---------------------------------------------------------------------------------------- */

/* Scenes that are compared: without leaves, and with. */
enum { WITHOUT, WITH, BOTH };

/* How many wrong pixels each face has, by its number. */
struct errors {
    uint32_t *of_face[BOTH];
};

static void errors_begin(struct errors *errors, const struct mesh *mesh)
{
    for (int i = 0; i < BOTH; i++)
        errors->of_face[i] = grow_zeroed(mesh->counts.faces + 1, sizeof(uint32_t));
}

static void errors_end(struct errors *errors)
{
    for (int i = 0; i < BOTH; i++)
        free(errors->of_face[i]);
}

/* The part, from 0, that errs most beyond what it does without leaves. Faces that were cut are several polygons. */
static size_t find_worst(const struct leaf_trial *trial, const struct errors *errors)
{
    const struct parts *parts = &trial->work.parts;
    const struct mesh *mesh = trial->work.mesh;
    int64_t *wrong = grow_zeroed(parts->count, sizeof *wrong);
    struct map seen = {0};
    size_t worst = parts->count;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const uint32_t part = parts->of[i], face = mesh->polygons[i].face;
        const size_t known = seen.count;
        map_at(&seen, face, 0);
        if (part && seen.count > known)
            wrong[part - 1] += (int64_t)errors->of_face[WITH][face] - errors->of_face[WITHOUT][face];
    }
    for (size_t i = 0; i < parts->count; i++)
        if (parts->items[i].polygons && (worst == parts->count || wrong[i] > wrong[worst])) worst = i;
    map_free(&seen);
    free(wrong);
    return worst;
}

static bool look(struct leaf_trial *trial, struct reference *reference, const uint32_t *groups, struct compiled *scene,
                 struct errors *errors, struct error *err)
{
    const struct compiled *const scenes[BOTH] = {scene, &trial->candidate};
    struct leaf_report *report = &scene->report.leaf_parts;
    struct predicted wrong[BOTH];
    if (!predict_held_out_faces(scenes, BOTH, trial->options.core, reference, groups, wrong, errors->of_face, err))
        return false;
    report->wrong_percent = mesh_choice_worst_percent(&wrong[WITH]);
    report->bound_percent = mesh_choice_bound_percent(&trial->options, mesh_choice_worst_percent(&wrong[WITHOUT]));
    return true;
}

/* Choice ---------------------------------------------------------------------------------------- */

static void take(struct leaf_trial *trial, struct compiled *scene)
{
    const struct compiled worse = *scene;
    const struct leaf_report weighed = scene->report.leaf_parts;
    struct leaf_report *report = &trial->candidate.report.leaf_parts;
    report->tried = true;
    report->attempts = weighed.attempts;
    report->dear_near = weighed.dear_near;
    report->instructions = weighed.instructions;
    report->without_instructions = weighed.without_instructions;
    report->wrong_percent = weighed.wrong_percent;
    report->bound_percent = weighed.bound_percent;
    trial->candidate.report.as_mesh = scene->report.as_mesh;
    trial->candidate.report.as_mesh.by_distance.taken = trial->candidate.report.as_mesh.by_depth.taken = false;
    *scene = trial->candidate;
    trial->candidate = worse;
}

/* One look at both. *goes_on: the candidate errs too much, and the part that errs most has left it. */
static bool settle_once(struct leaf_trial *trial, struct reference *reference, const uint32_t *groups,
                        struct compiled *scene, bool may_go_on, bool *goes_on, struct error *err)
{
    struct errors errors;
    errors_begin(&errors, trial->work.mesh);
    const bool ok = look(trial, reference, groups, scene, &errors, err);
    const size_t worst = ok ? find_worst(trial, &errors) : 0;
    const struct leaf_report *report = &scene->report.leaf_parts;
    errors_end(&errors);
    *goes_on = false;
    if (!ok) return false;
    if (report->wrong_percent <= report->bound_percent) /* NaN: out of time */
        take(trial, scene);
    else if (may_go_on && !isnan(report->wrong_percent)) {
        parts_leave_out(&trial->work.parts, trial->work.mesh, worst);
        *goes_on = compile_leaves(trial, scene);
    }
    return true;
}

bool leaf_trial_settle(struct leaf_trial *trial, struct reference *reference, const uint32_t *groups,
                       struct compiled *scene, struct error *err)
{
    bool ok = true, goes_on = true;
    for (int left_out = 0; ok && goes_on; left_out++)
        ok = settle_once(trial, reference, groups, scene, left_out < LEFT_OUT_MAX, &goes_on, err);
    return ok;
}

void leaf_trial_free(struct leaf_trial *trial)
{
    compiled_free(&trial->candidate);
    compilation_end(&trial->work);
}
