/* SPDX-License-Identifier: MIT
 *
 * A frame's cost takes the renderer alone; its errors take the reference as well, some thirty times as long. So there
 * are two searches, and the second has most of the time. */
#include "measure/worst_views.h"

#include "accuracy/moving_reference.h"
#include "base/deadline.h"
#include "base/parse.h"
#include "core/core.h"
#include "render/frame_cost.h"
#include "render/ids.h"
#include "scene/moving.h"

static const double COST_SHARE = 0.3;

struct viewing {
    struct measure_source *source;
    const struct measure_candidate *candidate;
    const struct measure_views *views;
    bool is_predicted;
    struct simulator simulator; /* for the cost */
    struct ids ids;             /* for errors */
};

static bool is_predicted(const struct measure_candidate *candidate)
{
    const struct compiled *scene = candidate->scene;
    return frame_cost_knows(scene->report.draws) && candidate->core == &core_fast && !scene->report.antialias &&
           !scene->report.framebuffer && !scene->moving && frame_cost_is_known(&scene->scene);
}

/* Poses what moves; false: the renderer cannot have its camera there, as too far away. */
static bool take_camera(const struct viewing *viewing, const struct viewpoint *viewpoint, struct lim_camera *camera)
{
    struct viewpoint frame = *viewpoint;
    const struct camera_path path = {"searched cameras", &frame, 1};
    const struct compiled *scene = viewing->candidate->scene;
    struct error ignored;
    if (scene->moving) moving_pose(scene->moving, viewpoint->time_s);
    return camera_path_to_camera(&path, 0, viewing->views->lens, &scene->grid, camera, &ignored);
}

static bool measure_cost_of(void *ctx, const struct viewpoint *viewpoint, double *scores, struct error *err)
{
    struct viewing *viewing = ctx;
    struct lim_camera camera;
    *scores = -1.0;
    if (!take_camera(viewing, viewpoint, &camera)) return true;
    if (!simulator_frame(&viewing->simulator, &camera, err)) return false;
    const struct lim_stats *stats = simulator_stats(&viewing->simulator);
    *scores = (viewing->is_predicted ? frame_cost_m0plus : frame_cost_work)(stats, &viewing->simulator.target);
    return true;
}

static bool measure_errors_of(void *ctx, const struct viewpoint *viewpoint, double *scores, struct error *err)
{
    struct viewing *viewing = ctx;
    struct measure_source *source = viewing->source;
    struct lim_camera camera;
    *scores = -1.0;
    if (!take_camera(viewing, viewpoint, &camera)) return true;
    if (!ids_frame(&viewing->ids, &camera, err)) return false;
    if (source->still.moving) moving_pose_reference(source->still.moving, &source->reference, viewpoint->time_s);
    reference_draw(&source->reference, viewpoint, viewing->views->lens);
    const double unit_m = 1.0 / viewing->candidate->scene->grid.units_per_m;
    *scores = (double)compare_picture(viewing->ids.faces, &source->reference, source->mesh.merged_into, unit_m).wrong;
    return true;
}

static bool prepare(struct viewing *viewing, struct error *err)
{
    const struct compiled *scene = viewing->candidate->scene;
    struct simulator_setup setup = {viewing->views->w_px, viewing->views->h_px, scene->report.draws,
                                    measure_panel(scene), viewing->candidate->core};
    if (!ids_init(&viewing->ids, scene, &setup, err) ||
        (scene->moving && !ids_set_movers(&viewing->ids, scene->moving, err)))
        return false;
    if (setup.panel == SIMULATOR_MEMORY) setup.panel = SIMULATOR_UNSEEN;
    return simulator_init(&viewing->simulator, &scene->scene, &setup, err) &&
           simulator_add_movers(&viewing->simulator, scene, err) &&
           simulator_set_antialias(&viewing->simulator, scene->report.antialias, err);
}

/* Both, each for its part of the time. */
static bool search_both(struct viewing *viewing, const struct worst_options *options, struct worst_views *out,
                        struct error *err)
{
    const struct compiled *scene = viewing->candidate->scene;
    struct camera_search search = {.scene = scene,
                                   .lens = *viewing->views->lens,
                                   .length_s = scene->moving ? moving_length_s(scene->moving) : 0.0,
                                   .seed = options->seed,
                                   .tries = options->tries,
                                   .goals = 1,
                                   .doing = "what costs most",
                                   .measure = measure_cost_of,
                                   .ctx = viewing};
    const struct deadline_end outer = deadline_within(options->seconds), whole = deadline_share(COST_SHARE);
    bool ok = camera_search_run(&search, &out->cost, err);
    deadline_restore(whole);
    search.tries = (options->tries + WORST_ERROR_SHARE - 1) / WORST_ERROR_SHARE;
    search.doing = "what errs most";
    search.hint = &out->cost.goals[0].worst;
    search.measure = measure_errors_of;
    ok = ok && camera_search_run(&search, &out->error, err);
    deadline_restore(outer);
    return ok;
}

bool worst_views_find(struct measure_source *source, const struct measure_candidate *candidate,
                      const struct measure_views *views, const struct worst_options *options, struct worst_views *out,
                      struct error *err)
{
    struct viewing viewing = {
        .source = source, .candidate = candidate, .views = views, .is_predicted = is_predicted(candidate)};
    *out = (struct worst_views){.is_predicted = viewing.is_predicted};
    double score;
    const bool ok = prepare(&viewing, err) && search_both(&viewing, options, out, err) &&
                    measure_cost_of(&viewing, &out->cost.goals[0].worst, &score, err);
    if (ok) out->stats = *simulator_stats(&viewing.simulator);
    simulator_free(&viewing.simulator);
    ids_free(&viewing.ids);
    return ok;
}

bool worst_tries_parse(const char *text, size_t *out, struct error *err)
{
    uint32_t tries = WORST_TRIES;
    if (text && !parse_whole("--worst", text, 1, WORST_TRIES_MAX, &tries, err)) return false;
    *out = tries;
    return true;
}

double worst_seconds_unsaid(void)
{
    return deadline_is_set() ? WORST_SECONDS : 0.0;
}
