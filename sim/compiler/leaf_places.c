/* SPDX-License-Identifier: MIT
 *
 * Both scenes are drawn from the same cameras, in and round the box of each part, with the pools that they have. */
#include "compiler/leaf_places.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "render/frame_cost.h"
#include "render/simulator.h"

#include <stdlib.h>

/* So near, a tree shows little of a part cheaply: what a leaf costs more there it may earn at a distance.
 * Measured: 1.05 at most round figures and furniture, 1.2 to 2.1 in rooms of which the walls were the part. */
static const double DEARER = 1.1;

enum { CAMERAS_A_PART = 12, CAMERAS_MAX = 1200, CAMERAS_LEAST = 3 };
enum { WITHOUT, WITH, BOTH };

struct places {
    const struct compiled *scenes[BOTH];
    struct simulator simulators[BOTH];
    struct lens lens;
    struct sampler sampler;
};

static bool places_begin(struct places *places, const struct core *core)
{
    struct error ignored;
    size_t begun = 0;
    for (; begun < BOTH; begun++) {
        const struct compile_report *report = &places->scenes[begun]->report;
        const struct simulator_setup setup = {report->w_px, report->h_px, report->draws, SIMULATOR_UNSEEN, core};
        if (!simulator_init(&places->simulators[begun], &places->scenes[begun]->scene, &setup, &ignored)) break;
    }
    const struct compile_report *report = &places->scenes[WITHOUT]->report;
    if (begun == BOTH && lens_for_grid(&places->lens, LENS_USUAL, 0, &places->scenes[WITHOUT]->grid, report->w_px,
                                       report->h_px, &ignored)) {
        sampler_init(&places->sampler, places->scenes[WITHOUT]);
        return true;
    }
    while (begun-- > 0)
        simulator_free(&places->simulators[begun]);
    return false;
}

static void places_end(struct places *places)
{
    for (int i = 0; i < BOTH; i++)
        simulator_free(&places->simulators[i]);
}

/* Adds to what the frame costs in each scene. False: it cannot be drawn. */
static bool add_costs(struct places *places, struct viewpoint viewpoint, double instructions[BOTH])
{
    const struct camera_path path = {"sampled cameras", &viewpoint, 1};
    const struct grid *grid = &places->scenes[WITHOUT]->grid;
    double frame[BOTH];
    struct lim_camera camera;
    struct error ignored;
    if (!camera_path_to_camera(&path, 0, &places->lens, grid, &camera, &ignored)) return false;
    for (int i = 0; i < BOTH; i++) {
        struct simulator *simulator = &places->simulators[i];
        if (!simulator_frame(simulator, &camera, &ignored)) return false;
        frame[i] = frame_cost_of_scene_m0plus(simulator_stats(simulator), &simulator->target, simulator->scene);
    }
    for (int i = 0; i < BOTH; i++)
        instructions[i] += frame[i];
    return true;
}

/* Eyes are in the part's box or round it; they look at something in it. */
static void look_near(struct sampler *sampler, const struct part *part)
{
    const struct grid *grid = &sampler->scene->grid;
    for (int k = 0; k < 3; k++) {
        sampler->low_m[k] = grid->origin_m[k] + part->low[k] / grid->units_per_m;
        sampler->high_m[k] = grid->origin_m[k] + part->high[k] / grid->units_per_m;
    }
}

static bool is_dearer(struct places *places, const struct part *part, size_t cameras)
{
    double instructions[BOTH] = {0};
    size_t seen = 0;
    look_near(&places->sampler, part);
    for (size_t i = 0; i < cameras; i++) {
        struct viewpoint viewpoint = {.line = 1};
        if (sampler_anywhere(&places->sampler, &viewpoint)) seen += add_costs(places, viewpoint, instructions);
    }
    return seen && instructions[WITH] > DEARER * instructions[WITHOUT];
}

size_t leaf_places_leave_out(const struct compiled *without, const struct compiled *with, const struct core *core,
                             const struct mesh *mesh, struct parts *parts)
{
    struct places places = {.scenes = {without, with}};
    const size_t share = CAMERAS_MAX / (parts->count ? parts->count : 1);
    const size_t cameras = share < CAMERAS_LEAST ? CAMERAS_LEAST : share < CAMERAS_A_PART ? share : CAMERAS_A_PART;
    size_t left_out = 0;
    if (!places_begin(&places, core)) return 0;
    bool *dear = grow_zeroed(parts->count, sizeof *dear);
    for (size_t i = 0; i < parts->count && !deadline_passed(); i++) {
        progress_bar(i, parts->count, "mesh leaves from near");
        dear[i] = parts->items[i].polygons && is_dearer(&places, &parts->items[i], cameras);
    }
    for (size_t i = 0; i < parts->count; i++)
        if (dear[i]) parts_leave_out(parts, mesh, i), left_out++;
    places_end(&places);
    free(dear);
    return left_out;
}
