/* SPDX-License-Identifier: MIT
 *
 * Accuracy comes first, of all at once, because the reference is what takes time; instructions are
 * counted only for those that meet the bound. */
#include "measure/choose.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "base/work_folder.h"
#include "cameras/sample.h"
#include "compiler/compile.h"
#include "core/core.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CHOICE_SHARE = 0.5; /* of the time: then the scene is compiled for what was chosen */

/* What is measured: the model, its scene without and with fractions, the views. */
struct trial {
    struct measure_source source;
    struct measure_scenes scenes;
    struct camera_path path;
    struct lens lens;
    struct measure_candidate candidates[CHOICE_CORES_MAX];
};

static int by_bits(const void *left, const void *right)
{
    const struct core *a = ((const struct choice_row *)left)->core, *b = ((const struct choice_row *)right)->core;
    return a->profile != b->profile ? a->profile - b->profile : a->sub_bits - b->sub_bits;
}

static void list_cores(struct choice *choice)
{
    for (size_t i = 0; cores[i] && i < CHOICE_CORES_MAX; i++)
        choice->rows[choice->count++] = (struct choice_row){.core = cores[i], .instructions = NAN};
    qsort(choice->rows, choice->count, sizeof *choice->rows, by_bits);
}

/* Viewpoints that the renderer cannot take are passed over, as when pools are measured. */
static bool sample_path(struct trial *trial, const struct compiled *scene, struct error *err)
{
    struct sampler sampler;
    struct lim_camera camera;
    static const char NAME[] = "sampled cameras";
    trial->path.name = grow_zeroed(sizeof NAME, 1);
    memcpy(trial->path.name, NAME, sizeof NAME);
    trial->path.frames = grow_zeroed(CHOICE_SAMPLES, sizeof *trial->path.frames);
    sampler_init(&sampler, scene);
    for (int i = 0; i < CHOICE_SAMPLES; i++) {
        trial->path.frames[trial->path.count] = sampler_next(&sampler);
        trial->path.count +=
            camera_path_to_camera(&trial->path, trial->path.count, &trial->lens, &scene->grid, &camera, err);
    }
    return trial->path.count > 0;
}

/* Those whose scenes take too long are left out, and those that are refused leave the rows. */
static bool compile_rows(struct trial *trial, const struct compile_options *options, struct choice *choice,
                         struct error *err)
{
    for (size_t i = 0; i < choice->count; i++)
        trial->candidates[i].core = choice->rows[i].core;
    const bool ok = measure_compile(&trial->scenes, &trial->source, options, trial->candidates, &choice->count,
                                    &choice->refused, err);
    for (size_t i = 0; i < choice->count; i++)
        choice->rows[i].core = trial->candidates[i].core;
    return ok;
}

static bool prepare(struct trial *trial, const char *model_path, struct compile_options *options,
                    const struct choice_bound *bound, struct choice *choice, struct error *err)
{
    if (!compile_options_cameras(options, &bound->cameras, &trial->path, err)) return false;
    if (!measure_source_read(&trial->source, model_path, options, options->w_px, options->h_px, err)) return false;
    if (!compile_rows(trial, options, choice, err)) return false;
    const struct compiled *scene = trial->candidates[0].scene;
    return lens_for_grid(&trial->lens, options->fov_deg, options->near_m, &scene->grid, options->w_px, options->h_px,
                         err) &&
           (bound->cameras.text ? camera_choice_plan(&bound->cameras, scene, &trial->lens, 0, &trial->path, err)
                                : sample_path(trial, scene, err));
}

static bool meets(const struct accuracy *accuracy, const struct choice_bound *bound)
{
    return (bound->wrong_percent < 0.0 || compare_wrong_percent(&accuracy->pixels.total) <= bound->wrong_percent) &&
           (bound->vertex_px < 0.0 || accuracy->vertex_max_px <= bound->vertex_px);
}

static bool measure_rows(struct trial *trial, const struct measure_views *views, const struct choice_bound *bound,
                         struct choice *choice, struct error *err)
{
    struct accuracy accuracies[CHOICE_CORES_MAX];
    if (!measure_accuracy(&trial->source, views, trial->candidates, choice->count, accuracies, err)) return false;
    choice->frames = accuracies[0].pixels.frames;
    for (size_t i = 0; i < choice->count; i++) {
        choice->rows[i].accuracy = accuracies[i];
        choice->rows[i].meets = meets(&accuracies[i], bound);
    }
    return true;
}

static bool count_rows(struct trial *trial, const struct measure_views *views, const struct choice_bound *bound,
                       struct choice *choice, struct error *err)
{
    struct work_folder folder = {0};
    bool ok = work_folder_make(&folder, err);
    for (size_t i = 0; ok && i < choice->count; i++) {
        struct cost cost;
        if (!choice->rows[i].meets) continue;
        progress_bar(i, choice->count, "instructions of %s", choice->rows[i].core->name);
        ok = deadline_check(err, "instructions") &&
             measure_cost(&trial->candidates[i], bound->cpu, views, folder.path, &cost, err);
        if (ok) choice->rows[i].instructions = cost.mean;
        if (ok || !deadline_passed()) continue;
        deadline_say("instructions of the precisions before %s", choice->rows[i].core->name);
        ok = true;
        break;
    }
    work_folder_remove(&folder);
    return ok;
}

/* What was not counted in time is worse than what was. */
static bool is_cheaper(const struct choice_row *a, const struct choice_row *b)
{
    return a->instructions < b->instructions || (isnan(b->instructions) && !isnan(a->instructions));
}

/* Rows that meet the bound stay in order of bits, so that the first of equals wins. */
static const struct choice_row *cheapest(const struct choice *choice)
{
    const struct choice_row *best = NULL;
    for (size_t i = 0; i < choice->count; i++) {
        const struct choice_row *row = &choice->rows[i];
        if (row->meets && (!best || is_cheaper(row, best))) best = row;
    }
    return best;
}

static bool refuse(const struct choice *choice, const char *model_path, struct error *err)
{
    const struct choice_row *best = &choice->rows[0];
    for (size_t i = 1; i < choice->count; i++)
        if (compare_wrong_percent(&choice->rows[i].accuracy.pixels.total) <
            compare_wrong_percent(&best->accuracy.pixels.total))
            best = &choice->rows[i];
    return error_set(err,
                     "%s: %sno precision meets the bound; %s comes nearest: %.4f %% wrong pixels, vertices %.3f px",
                     model_path, deadline_passed() ? "time ended (--time-limit): so far " : "", best->core->name,
                     compare_wrong_percent(&best->accuracy.pixels.total), best->accuracy.vertex_max_px);
}

bool choose_core(const char *model_path, struct compile_options *options, const struct choice_bound *bound,
                 struct choice *out, struct error *err)
{
    struct trial trial = {0};
    *out = (struct choice){0};
    list_cores(out);
    const struct deadline_end whole = deadline_share(CHOICE_SHARE);
    bool ok =
        (!bound->cpu || measure_cpu_check(bound->cpu, err)) && prepare(&trial, model_path, options, bound, out, err);
    const struct measure_views views = {&trial.path, &trial.lens, options->w_px, options->h_px, NULL};
    ok = ok && measure_rows(&trial, &views, bound, out, err) &&
         (!bound->cpu || count_rows(&trial, &views, bound, out, err));
    progress_end();
    const struct choice_row *best = ok ? cheapest(out) : NULL;
    if (best) out->core = best->core;
    if (ok && !best) ok = refuse(out, model_path, err);
    deadline_restore(whole);
    measure_source_free(&trial.source);
    camera_path_free(&trial.path);
    measure_scenes_free(&trial.scenes);
    return ok;
}

void choice_print(const struct choice *choice, const struct choice_bound *bound, FILE *out)
{
    fprintf(out, "%-10s %9s %12s %12s %10s %12s  %s\n", "precision", "wrong_%", "worst_frame_%", "vertex_rms_px",
            "vertex_px", "instructions", "");
    for (size_t i = 0; i < choice->count; i++) {
        const struct choice_row *row = &choice->rows[i];
        fprintf(out, "%-10s %9.4f %13.4f %13.4f %10.4f ", row->core->name,
                compare_wrong_percent(&row->accuracy.pixels.total), compare_wrong_percent(&row->accuracy.pixels.worst),
                accuracy_vertex_rms_px(&row->accuracy), row->accuracy.vertex_max_px);
        if (isnan(row->instructions))
            fprintf(out, "%12s", "-");
        else
            fprintf(out, "%12.0f", row->instructions);
        fprintf(out, "  %s\n", row->core == choice->core ? "chosen" : row->meets ? "meets the bound" : "misses it");
    }
    measure_refusals_print(&choice->refused, "", out);
    fprintf(out, "%zu frames, %s; instructions a frame: %s\n", choice->frames,
            bound->cameras.text ? bound->cameras.text : "cameras sampled in the scene's free space",
            bound->cpu ? bound->cpu->title : "not counted (--core), the fewest bits win");
}
