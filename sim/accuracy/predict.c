/* SPDX-License-Identifier: MIT
 *
 * The same samplers as for random cameras, the same comparison as --compare. */
#include "accuracy/predict.h"

#include "accuracy/compare.h"
#include "accuracy/moving_reference.h"
#include "base/deadline.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "render/ids.h"
#include "scene/moving.h"

#include <math.h>

static const double SHARE = 0.5; /* of the time that is left */

struct predicting {
    const struct compiled *scene;
    struct ids ids;
    struct reference *reference;
    const uint32_t *groups;
    struct lens lens;
    size_t done; /* cameras */
};

/* Frame by frame through all of the animation. */
static double pose_movers(struct predicting *predicting)
{
    struct moving *moving = predicting->scene->moving;
    if (!moving) return 0.0;
    const double time_s = moving_time_s(moving, predicting->done, PREDICT_CAMERAS);
    moving_pose(moving, time_s);
    moving_pose_reference(moving, predicting->reference, time_s);
    return time_s;
}

static bool compare_views(struct predicting *predicting, bool near, int count, struct comparison *sum,
                          struct error *err)
{
    const struct grid *grid = &predicting->scene->grid;
    struct sampler sampler;
    sampler_init(&sampler, predicting->scene);
    sampler.near_m = predicting->lens.near_m;
    for (int i = 0; i < count && !deadline_passed(); i++) {
        struct viewpoint viewpoint;
        struct lim_camera camera;
        const struct camera_path path = {"sampled cameras", &viewpoint, 1};
        progress_bar(predicting->done++, PREDICT_CAMERAS, "comparing with the reference");
        sampler.time_s = pose_movers(predicting);
        if (!(near ? sampler_near(&sampler, &viewpoint) : sampler_anywhere(&sampler, &viewpoint))) return true;
        if (!camera_path_to_camera(&path, 0, &predicting->lens, grid, &camera, err)) continue;
        if (!ids_frame(&predicting->ids, &camera, err)) return false;
        reference_draw(predicting->reference, &viewpoint, &predicting->lens);
        const struct compare_counts counts =
            compare_picture(predicting->ids.faces, predicting->reference, predicting->groups, 1.0 / grid->units_per_m);
        comparison_add(sum, &counts);
    }
    return true;
}

bool predict_wrong(const struct compiled *scene, const struct core *core, struct reference *reference,
                   const uint32_t *groups, struct predicted *out, struct error *err)
{
    const struct simulator_setup setup = {PREDICT_SIDE_PX, PREDICT_SIDE_PX, scene->report.draws, SIMULATOR_MEMORY,
                                          core};
    struct predicting predicting = {.scene = scene, .reference = reference, .groups = groups};
    struct comparison anywhere = {0}, near = {0};
    const int near_count = scene->original ? PREDICT_CAMERAS / 2 : 0;

    if (!lens_for_grid(&predicting.lens, 60, scene->report.near_m, &scene->grid, PREDICT_SIDE_PX, PREDICT_SIDE_PX,
                       err) ||
        !ids_init(&predicting.ids, scene, &setup, err) ||
        (scene->moving && !ids_set_movers(&predicting.ids, scene->moving, err)))
        return false;
    const struct deadline_end whole = deadline_share(SHARE);
    const bool ok = compare_views(&predicting, false, PREDICT_CAMERAS - near_count, &anywhere, err) &&
                    compare_views(&predicting, true, near_count, &near, err);
    const struct compare_counts all = {.pixels = anywhere.total.pixels + near.total.pixels,
                                       .wrong = anywhere.total.wrong + near.total.wrong};
    *out = (struct predicted){.percent = deadline_passed() ? NAN : compare_wrong_percent(&all),
                              .near_percent = compare_wrong_percent(&near.total),
                              .cameras = anywhere.frames + near.frames,
                              .near_cameras = near.frames};
    deadline_say("a report without predicted wrong pixels");
    deadline_restore(whole);
    ids_free(&predicting.ids);
    return ok;
}
