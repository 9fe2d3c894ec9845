/* SPDX-License-Identifier: MIT
 *
 * Portals pay if they spare a tenth of the instructions that are predicted, on sampled cameras that stand in closed
 * cells mostly, and take at most a tenth of the scene's flash; where no instructions are predicted, if they spare a
 * quarter of the polygons that are reached. The walk from near to far ends as soon as the picture is full, so what is
 * left to spare is little, for bytes that are always there. */
#include "compiler/portal_choice.h"

#include "base/deadline.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "core/core.h"
#include "portals/pvs.h"
#include "render/frame_cost.h"
#include "render/portal_best.h"
#include "render/simulator.h"
#include "scene/lim_image.h"

#include <math.h>
#include <string.h>

enum { CAMERAS = 64, FOV_DEG = 60, LEAST_SAVED_PERCENT = 25, LEAST_COST_PERCENT = 10, MOST_FLASH_PERCENT = 10 };
enum { LOOK_UP_INSTRUCTIONS = 2700 }; /* a frame, on a Cortex-M0+ (firmware/DESIGN.md) */

/* What the renderer's rounding may shift: never less than this, so that a scene may be drawn smaller and less
 * precisely than it was compiled for. */
static const double LEAST_ANGLE_RAD = 1.0 / 128.0;
static const double VERTEX_ERROR_PX = 4.0; /* in sub-pixels: rounding, and what the matrix errs; in draft, pixels */

static double angle_of(const struct compiled *scene, const struct compile_options *options)
{
    const struct core *core = options->core ? options->core : &core_fast;
    const unsigned w_px = scene->report.w_px, h_px = scene->report.h_px, side_px = w_px < h_px ? w_px : h_px;
    const double pixel_rad = 2.0 * tan(FOV_DEG / 2.0 / 180.0 * acos(-1.0)) / side_px;
    return fmax(LEAST_ANGLE_RAD, pixel_rad * VERTEX_ERROR_PX / (1 << core->sub_bits));
}

/* Trying ------------------------------------------------------------------------------------- */

/* Sampled cameras, drawn with what the portals show, or with the best that they could, and without. */
struct trial {
    const struct compiled *scene;
    struct lim_scene plain;   /* the scene without places */
    struct portal_best *best; /* or NULL */
    struct simulator with, without;
    struct portal_report *report;
};

static struct simulator_setup trial_setup(const struct compiled *scene, const struct core *core)
{
    const bool is_draft = core && core->profile == LIM_PROFILE_DRAFT; /* has stray pixels of its own */
    return (struct simulator_setup){scene->report.w_px, scene->report.h_px, scene->report.draws, SIMULATOR_MEMORY,
                                    is_draft ? &core_fast : core};
}

static bool trial_begin(struct trial *trial, const struct simulator_setup *setup, struct error *err)
{
    const struct compiled *scene = trial->scene;
    struct portal_report *report = trial->report;
    report->cost_before = report->cost_after = frame_cost_knows(scene->report.draws) ? 0.0 : NAN;
    trial->plain = scene->scene;
    trial->plain.place_count = 0;
    if (!simulator_init(&trial->with, trial->best ? &trial->best->scene : &scene->scene, setup, err)) return false;
    if (simulator_init(&trial->without, &trial->plain, setup, err)) return true;
    simulator_free(&trial->with);
    return false;
}

static bool trial_frame(struct trial *trial, const struct lim_camera *camera, struct error *err)
{
    if (!simulator_frame(&trial->with, camera, err) || !simulator_frame(&trial->without, camera, err)) return false;
    struct portal_report *report = trial->report;
    report->cameras++;
    report->polygons_before += simulator_stats(&trial->without)->polygons;
    report->polygons_after += simulator_stats(&trial->with)->polygons;
    report->vertices_before += simulator_stats(&trial->without)->vertices;
    report->vertices_after += simulator_stats(&trial->with)->vertices;
    report->cost_before += frame_cost_work(simulator_stats(&trial->without), &trial->without.target);
    report->cost_after += frame_cost_work(simulator_stats(&trial->with), &trial->with.target) + LOOK_UP_INSTRUCTIONS;
    report->different += memcmp(trial->with.pixels, trial->without.pixels,
                                simulator_pixel_count(&trial->with) * sizeof *trial->with.pixels) != 0;
    return true;
}

static bool trial_run(struct trial *trial, struct error *err)
{
    struct sampler sampler;
    struct lens lens;
    sampler_init(&sampler, trial->scene);
    if (!lens_for_grid(&lens, LENS_USUAL, 0, &trial->scene->grid, trial->scene->report.w_px, trial->scene->report.h_px,
                       err))
        return false;
    for (int i = 0; i < CAMERAS && deadline_check(err, "portals were still tried out"); i++) {
        progress_bar((size_t)i, CAMERAS, "portals");
        struct viewpoint viewpoint = sampler_next(&sampler);
        const struct camera_path path = {"sampled cameras", &viewpoint, 1};
        struct lim_camera camera;
        if (!camera_path_to_camera(&path, 0, &lens, &trial->scene->grid, &camera, err)) continue; /* out of range */
        if (trial->best && !portal_best_see(trial->best, &camera, err)) return false;
        if (!trial_frame(trial, &camera, err)) return false;
    }
    return deadline_check(err, "portals were still tried out");
}

static bool try_out(const struct compiled *scene, const struct core *core, struct portal_best *best,
                    struct portal_report *report, struct error *err)
{
    const struct simulator_setup setup = trial_setup(scene, core);
    struct trial trial = {.scene = scene, .best = best, .report = report};
    if (!trial_begin(&trial, &setup, err)) return false;
    const bool ok = trial_run(&trial, err);
    simulator_free(&trial.with);
    simulator_free(&trial.without);
    return ok;
}

/* Deciding ----------------------------------------------------------------------------------- */

static bool spares_enough(const struct portal_report *portals)
{
    const double before = (double)portals->polygons_before, saved = before - (double)portals->polygons_after;
    if (isnan(portals->cost_before)) return saved * 100.0 >= before * LEAST_SAVED_PERCENT && saved >= 0.0;
    return (portals->cost_before - portals->cost_after) * 100.0 >= portals->cost_before * LEAST_COST_PERCENT;
}

static bool pays(const struct compile_report *report)
{
    return spares_enough(&report->portals) && report->portals.bytes * 100 <= report->flash_b * MOST_FLASH_PERCENT;
}

/* Whether portals could pay: the best that they could show is tried in far less time than what they do show is found.
 * False, with the reason: they cannot. */
static bool could_pay(const struct compiled *scene, const struct core *core, struct error *reason)
{
    const struct simulator_setup setup = trial_setup(scene, core);
    struct portal_report tried = {0};
    struct portal_best best;
    if (!portal_best_init(&best, scene, &setup, reason)) return false;
    const bool ok = try_out(scene, core, &best, &tried, reason);
    portal_best_free(&best);
    if (!ok || spares_enough(&tried)) return ok;
    const bool by_cost = !isnan(tried.cost_before);
    const double before = by_cost ? tried.cost_before : (double)tried.polygons_before;
    const double after = by_cost ? tried.cost_after : (double)tried.polygons_after;
    return error_set(reason, "at best they would spare %.1f %% of %s; they pay from %d %% on",
                     fmax(0.0, 100.0 * (1.0 - after / before)), by_cost ? "the instructions" : "the polygons reached",
                     by_cost ? LEAST_COST_PERCENT : LEAST_SAVED_PERCENT);
}

/* Keeps them or takes them out again. */
static bool decide(struct compiled *scene, const struct compile_options *options, struct error *err)
{
    struct portal_report *report = &scene->report.portals;
    const bool wanted = options->portals == PORTALS_ON;
    if (wanted && report->different)
        return error_set(err, "portals: %zu of %zu sampled pictures differ; the model has openings finer than its grid",
                         report->different, report->cameras);
    report->kept = !report->different && (wanted || pays(&scene->report));
    if (report->kept)
        scene->report.flash_b += report->bytes;
    else
        lim_image_set_pvs(scene, NULL, 0, NULL, 0);
    return true;
}

static void attach(struct compiled *scene, const struct pvs *pvs)
{
    enum { FIELDS_B = 2 * 4 + 2 * 2 }; /* of struct lim_scene */
    struct portal_report *report = &scene->report.portals;
    report->tried = true;
    report->zones = pvs->zones;
    report->pvs = pvs->kept;
    report->given_up = pvs->given_up;
    report->mean_polygons = pvs->mean_polygons;
    report->bytes = pvs->place_count * sizeof *pvs->places + pvs->byte_count + FIELDS_B;
    lim_image_set_pvs(scene, pvs->places, pvs->place_count, pvs->bytes, pvs->byte_count);
}

static bool find(const struct compiled *scene, const struct compile_options *options, struct pvs *out,
                 struct error *reason)
{
    const bool wanted = options->portals == PORTALS_ON;
    struct pvs_effort effort = pvs_usual_effort;
    if (wanted) effort.hidden = 0.0;
    return pvs_may_be(&scene->scene, reason) && (wanted || could_pay(scene, options->core, reason)) &&
           pvs_find(&scene->scene, angle_of(scene, options), &effort, out, reason);
}

bool portals_add(struct compiled *scene, const struct compile_options *options, struct error *err)
{
    struct portal_report *report = &scene->report.portals;
    struct pvs pvs;
    struct error reason;
    const bool wanted = options->portals == PORTALS_ON;
    const bool is_mesh = lim_scene_is_mesh(&scene->scene), has_none = is_mesh || scene->report.convex;
    if (options->portals == PORTALS_OFF || (!wanted && has_none)) return true;
    progress("portals");
    if (has_none)
        return error_set(err, "portals: %s has no cells to look from", is_mesh ? "a mesh" : "one convex solid");
    if (!find(scene, options, &pvs, &reason)) {
        if (!wanted) deadline_say("a scene without portals");
        snprintf(report->refused, sizeof report->refused, "%.95s", reason.text);
        return !wanted || error_set(err, "portals: %s", reason.text);
    }
    attach(scene, &pvs);
    pvs_free(&pvs);
    if (try_out(scene, options->core, NULL, report, err)) return decide(scene, options, err);
    if (wanted || !deadline_passed()) return false;
    *report = (struct portal_report){0}; /* they are not needed, and nothing is known of them */
    lim_image_set_pvs(scene, NULL, 0, NULL, 0);
    deadline_say("a scene without portals");
    return true;
}
