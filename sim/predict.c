/* SPDX-License-Identifier: MIT
 *
 * The same sampler as for the pools, the same comparison as --compare. */
#include "predict.h"

#include "compare.h"
#include "ids.h"
#include "progress.h"
#include "sample.h"

static bool compare_views(const struct compiled *scene, struct ids *ids, struct reference *reference,
                          const uint32_t *groups, struct comparison *sum, struct error *err)
{
    struct sampler sampler;
    struct lens lens;

    sampler_init(&sampler, scene);
    if (!lens_init(&lens, 60, lens_default_near_m(&scene->grid), PREDICT_SIDE_PX, PREDICT_SIDE_PX, err)) return false;
    for (int i = 0; i < PREDICT_CAMERAS; i++) {
        progress_bar((size_t)i, PREDICT_CAMERAS, "comparing with the reference");
        struct viewpoint viewpoint = sampler_next(&sampler);
        const struct camera_path path = {"sampled cameras", &viewpoint, 1};
        struct lim_camera camera;
        if (!camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, err)) continue;
        if (!ids_frame(ids, &camera, err)) return false;
        reference_draw(reference, &viewpoint, &lens);
        const struct compare_counts counts =
            compare_picture(ids->faces, reference, groups, 1.0 / scene->grid.units_per_m);
        comparison_add(sum, &counts);
    }
    return true;
}

bool predict_wrong_percent(const struct compiled *scene, const struct core *core, struct reference *reference,
                           const uint32_t *groups, double *percent, struct error *err)
{
    const struct simulator_setup setup = {PREDICT_SIDE_PX, PREDICT_SIDE_PX, scene->report.draws, SIMULATOR_MEMORY,
                                          core};
    struct comparison sum = {0};
    struct ids ids;

    if (!ids_init(&ids, scene, &setup, err)) return false;
    const bool ok = compare_views(scene, &ids, reference, groups, &sum, err);
    *percent = compare_wrong_percent(&sum.total);
    ids_free(&ids);
    return ok;
}
