/* SPDX-License-Identifier: MIT
 *
 * Counted by frame_cost.h, which also chooses trees. Where scan lines would cost several times as much, as in large
 * closed scenes, a few cameras spend what all may, and end it. */
#include "compiler/order_choice.h"

#include "compiler/pool_sizes.h"
#include "scene/mcu_mem.h"
#include "scene/method.h"
#include "scene/moving.h"
#include "scene/records.h"

#include <math.h>

static const double ENOUGH = 0.95; /* of the instructions of nearest first: less of a gain is no better than a guess */

const char *order_needs_nearest(const struct compile_options *options, const struct lim_scene *scene)
{
    if (options->wireframe) return "--wireframe is";
    if (options->delta) return "--delta is";
    if (options->fill) return "--fill is";
    return records_blended(scene) ? "glass is" : NULL; /* holes are painted as any texture is */
}

bool order_can_fill(const struct compile_options *options, const struct compiled *scene, struct error *err)
{
    const enum lim_method draws = scene->report.draws;
    const char *by_lines = options->antialias           ? "--antialias is"
                           : scene->scene.texture_count ? "textures are"
                                                        : order_needs_nearest(options, &scene->scene);

    if (options->fill) return error_set(err, "--framebuffer --fill: the picture is kept once; take one of the two");
    if (by_lines) return error_set(err, "--framebuffer: %s drawn line by line", by_lines);
    return draws == LIM_NEAREST_FIRST || draws == LIM_PAINTER ||
           error_set(err, "--framebuffer --method %s: it draws line by line; nearest and painter paint into one",
                     method_name(draws));
}

static bool is_painted(const struct compile_options *options, const struct model *model)
{
    const enum lim_method draws = compile_options_draws(options);
    if (options->antialias || options->wireframe || options->delta || options->fill || model->mover_count) return false;
    if (draws != LIM_NEAREST_FIRST && draws != LIM_PAINTER) return false;
    for (size_t i = 0; i < model->face_count; i++)
        if (model->faces[i].picture || model->faces[i].transparency) return false;
    return true;
}

struct compile_options order_options_for(const struct compile_options *options, const struct model *model)
{
    struct compile_options own = *options;
    if (own.framebuffer_by_lines && !is_painted(options, model)) own.framebuffer = false;
    return own;
}

void order_settle_framebuffer(struct compile_report *report)
{
    if (report->draws == LIM_SCANLINE) report->draws = LIM_PAINTER;
    report->instructions = NAN;
}

bool order_choose(struct compiled *scene, const struct compile_options *options, struct error *err)
{
    struct compile_report *report = &scene->report;
    const double nearest = report->instructions;

    if (!options->choose_order || options->method || report->draws != LIM_NEAREST_FIRST) return true;
    if (isnan(nearest) || order_needs_nearest(options, &scene->scene)) return true;
    const size_t nearest_mem_b = mcu_mem_b(scene);
    if (!pools_measure_scanline(scene, options->core, ENOUGH * nearest, err)) return false;
    report->order = (struct order_choice){true, nearest, ENOUGH * nearest, nearest_mem_b};
    return true;
}

/* What comparing objects costs, it costs by either. */
bool order_choose_moving(struct compiled *scene, struct moving *moving, const struct compile_options *options,
                         struct error *err)
{
    if (!pools_measure_moving(scene, moving, options->core, err)) return false;
    const double nearest = scene->report.instructions;
    scene->report.instructions = NAN; /* what moves costs, too */
    if (!options->choose_order || options->method || scene->report.draws != LIM_NEAREST_FIRST) return true;
    if (isnan(nearest) || order_needs_nearest(options, &scene->scene)) return true;
    for (size_t i = 0; i < moving->count; i++)
        if (order_needs_nearest(options, &moving->objects[i].scene.scene)) return true;
    return pools_scan_moving(scene, moving, options->core, ENOUGH * nearest, err);
}
