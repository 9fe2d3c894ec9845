/* SPDX-License-Identifier: MIT
 *
 * By distance is tried before by depth, as it is cheaper; each has to be cheaper than the tree by enough to be no mere
 * guess, or as cheap and smaller. What is wrong in whichever is worse, all cameras or those that have all in view,
 * counts: large triangles err in some views and dense ones in others. */
#include "compiler/mesh_choice.h"

#include "accuracy/predict.h"
#include "accuracy/promise.h"
#include "base/deadline.h"
#include "compiler/compile_mesh.h"
#include "compiler/order_choice.h"
#include "core/core.h"
#include "model/original.h"
#include "render/frame_cost.h"
#include "scene/mcu_mem.h"

#include <math.h>
#include <stdlib.h>

static const double ENOUGH = 0.95;     /* of the instructions of the tree, or of its bytes */
static const double NO_WRONGER = 1.25; /* times the tree's wrong pixels, where it has more than promised itself */
static const double DEEPER_SHARE = 0.2;
enum { DEEPER = 2 }; /* times: wrong orders are looked for in a sample of views */

static bool has_sky(const struct lim_scene *scene)
{
    for (size_t i = 0; i < scene->texture_count; i++)
        if (lim_texture_is_sky(&scene->textures[i])) return true;
    return false;
}

static bool is_open(const struct compile_options *options, const struct compiled *scene)
{
    const struct compile_report *report = &scene->report;
    if (!options->choose_order || options->method || options->tree != TREE_AUTO) return false;
    if (options->core && options->core->profile == LIM_PROFILE_EXACT) return false;
    if (options->framebuffer || report->left_out || has_sky(&scene->scene) || scene->grid.is_long) return false;
    if (order_needs_nearest(options, &scene->scene) || options->portals == PORTALS_ON || scene->scene.place_count)
        return false;
    return !isnan(report->instructions);
}

/* In instructions, or, where these are no more, in working memory and in flash. */
static bool is_cheaper(const struct mesh_choice *choice, const struct compiled *trial)
{
    const double instructions = trial->report.instructions;
    if (instructions <= ENOUGH * choice->tree_instructions) return true;
    return instructions <= choice->tree_instructions &&
           (double)mcu_mem_b(trial) <= ENOUGH * (double)choice->tree_mem_b &&
           (double)trial->report.flash_b <= ENOUGH * (double)choice->tree_flash_b;
}

/* Out of time, or no cheaper than the tree: it is none. */
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
    if (!deadline_passed() && is_cheaper(&scene->report.as_mesh, out)) return true;
    compiled_free(out);
    return false;
}

/* How many points faces have: as a mesh the scene has as many vertices, or more where textures part them. 0, which
 * excludes nothing, without memory to count them. */
static size_t points_used(const struct mesh *mesh)
{
    bool *is_used = calloc(mesh->point_count + 1, sizeof *is_used);
    size_t count = 0;
    for (size_t i = 0; is_used && i < mesh->corner_count; i++) {
        count += !is_used[mesh->corners[i]];
        is_used[mesh->corners[i]] = true;
    }
    free(is_used);
    return count;
}

/* By depth is never cheaper than by distance. */
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
    choice->by_depth.instructions = choice->by_depth.wrong_percent = NAN;
    choice->by_distance.instructions = choice->by_distance.wrong_percent = NAN;
    choice->vertices_instructions = frame_cost_of_mesh_vertices_m0plus(points_used(mesh));
    if (choice->vertices_instructions > choice->tree_instructions) return false;
    if (!try_one(mesh, options, "mesh", scene, &choice->by_distance, &trials->by_distance)) return false;
    (void)try_one(mesh, options, "mesh-depth", scene, &choice->by_depth, &trials->by_depth);
    return true;
}

double mesh_choice_worst_percent(const struct predicted *wrong)
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
double mesh_choice_bound_percent(const struct compile_options *options, double tree_percent)
{
    const double promised = options->wrong_percent > 0 ? options->wrong_percent : promise_wrong_percent(options->core);
    return fmax(promised, NO_WRONGER * tree_percent);
}

struct settling {
    const struct mesh *mesh;
    const struct compile_options *options;
    struct reference *reference;
    const uint32_t *groups;
    struct compiled *scene;
};

/* Holds the scene, and those trials that there are, against the reference. */
static bool look(const struct settling *work, struct mesh_trials *trials, struct error *err)
{
    struct mesh_choice *choice = &work->scene->report.as_mesh;
    const struct compiled *const candidates[2] = {&trials->by_distance, &trials->by_depth};
    struct mesh_trial *const rows[2] = {&choice->by_distance, &choice->by_depth};
    const struct compiled *scenes[3] = {work->scene};
    struct predicted wrong[3];
    size_t count = 1;
    for (int i = 0; i < 2; i++)
        if (candidates[i]->scene.polygon_count) scenes[count++] = candidates[i];
    if (!predict_held_out(scenes, count, work->options->core, work->reference, work->groups, wrong, err)) return false;
    choice->cameras = wrong[0].cameras;
    choice->tree_wrong_percent = mesh_choice_worst_percent(&wrong[0]);
    choice->bound_percent = mesh_choice_bound_percent(work->options, choice->tree_wrong_percent);
    for (size_t i = 0, k = 1; i < 2; i++)
        if (candidates[i]->scene.polygon_count) rows[i]->wrong_percent = mesh_choice_worst_percent(&wrong[k++]);
    return true;
}

static bool is_right(const struct mesh_choice *choice, const struct mesh_trial *trial)
{
    return trial->wrong_percent <= choice->bound_percent; /* NaN: not looked at, or out of time */
}

/* What is too wrong by depth gets more triangles with depth, until it is too dear. */
static bool deepen(const struct settling *work, struct mesh_trials *trials, struct error *err)
{
    struct mesh_choice *choice = &work->scene->report.as_mesh;
    struct compile_options own = *work->options;
    own.wrong_percent = choice->bound_percent;
    for (int i = 0; i < DEEPER && trials->by_depth.scene.polygon_count && !is_right(choice, &choice->by_depth) &&
                    !is_right(choice, &choice->by_distance) && !deadline_passed();
         i++) {
        own.wrong_percent *= DEEPER_SHARE;
        compiled_free(&trials->by_depth);
        if (try_one(work->mesh, &own, "mesh-depth", work->scene, &choice->by_depth, &trials->by_depth) &&
            !look(work, trials, err))
            return false;
    }
    return true;
}

bool mesh_choice_settle(struct mesh_trials *trials, const struct mesh *mesh, const struct compile_options *options,
                        struct reference *reference, const uint32_t *groups, struct compiled *scene, struct error *err)
{
    const struct settling work = {mesh, options, reference, groups, scene};
    struct mesh_choice *choice = &scene->report.as_mesh;
    if (!look(&work, trials, err) || !deepen(&work, trials, err)) return false;
    if (is_right(choice, &choice->by_distance))
        take(scene, &trials->by_distance, &choice->by_distance);
    else if (is_right(choice, &choice->by_depth))
        take(scene, &trials->by_depth, &choice->by_depth);
    return true;
}

void mesh_trials_free(struct mesh_trials *trials)
{
    compiled_free(&trials->by_distance);
    compiled_free(&trials->by_depth);
}
