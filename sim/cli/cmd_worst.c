/* SPDX-License-Identifier: MIT
 *
 * `limner worst MODEL`: the camera that costs most and the one that errs most, searched in the scene's free space; by
 * how much they are worse than random cameras. With -o PATH: PATH.cam, and pictures. All files or none. */
#include "base/work_folder.h"
#include "cameras/random_path.h"
#include "cli/commands.h"
#include "compiler/faithful.h"
#include "core/core.h"
#include "levels/level_path.h"
#include "measure/difference.h"
#include "measure/measure_request.h"
#include "measure/worst_views.h"
#include "outputs/outputs.h"
#include "pictures/image.h"
#include "scene/moving.h"

#include <stdio.h>
#include <stdlib.h>

enum { PATH_MAX_B = 1024, COUNTED_RANDOM = 16, FOUND = 2 };

struct worst {
    struct measure_request request;
    struct measure_source source;
    struct compiled scene;
    struct lens lens;
    struct camera_path none; /* no cameras are given */
    struct worst_views found;
    struct outputs outputs;
    struct work_folder folder;
};

static struct measure_candidate candidate_of(const struct worst *worst)
{
    return (struct measure_candidate){worst->request.cores[0], &worst->scene};
}

static bool search(struct worst *worst, struct error *err)
{
    struct measure_request *request = &worst->request;
    if (!measure_request_check(request, err) ||
        !measure_request_load(request, &worst->source, &worst->lens, &worst->none, err))
        return false;
    if (!measure_source_compile(&worst->source, &request->compile, &worst->scene, err))
        return error_prefix(err, request->model);
    faithful_note(&worst->scene);
    if (request->compile.near_m <= 0.0) lens_note_near(request->model, &worst->scene.grid);
    const struct measure_candidate candidate = candidate_of(worst);
    const struct measure_views views = {NULL, &worst->lens, request->w_px, request->h_px, NULL};
    return worst_views_find(&worst->source, &candidate, &views, &request->worst, &worst->found, err) ||
           error_prefix(err, request->model);
}

/* Words -------------------------------------------------------------------------------------- */

static void print_times(double score, double than)
{
    if (than > 0.0)
        printf("%.2f", score / than);
    else
        printf(score > 0.0 ? "infinitely many" : "0");
}

static void print_search(const struct search_result *result, const char *score)
{
    const struct search_goal *goal = &result->goals[0];
    printf("%s\n    ", score);
    print_times(goal->score, goal->mean);
    printf(" times the mean and ");
    print_times(goal->score, goal->most);
    printf(" times the worst of %zu random cameras; %zu cameras tried%s\n    ", result->plain, result->tried,
           result->is_cut ? " in the time that there was" : "");
    viewpoint_write(&goal->worst, stdout);
}

static void print_found(const struct worst *worst)
{
    const struct measure_request *request = &worst->request;
    const double errors = worst->found.error.goals[0].score;
    char score[160];
    printf("%s: %ux%u pixels, profile %s, %s\n", request->name, request->w_px, request->h_px, request->cores[0]->name,
           method_title(worst->scene.report.draws));
    printf("cameras in free space, ex ey ez tx ty tz in metres; searched, not proved\n");
    snprintf(score, sizeof score,
             worst->found.is_predicted ? "costs most: %.0f instructions on Cortex-M0+, predicted"
                                       : "costs most: %.0f of work; nothing predicts instructions "
                                         "of such frames (--core counts them)",
             worst->found.cost.goals[0].score);
    print_search(&worst->found.cost, score);
    if (worst->found.stats.bands)
        printf("    pools are short there: %lu walks more than one; compile --worst makes them larger\n",
               (unsigned long)worst->found.stats.bands);
    snprintf(score, sizeof score, "errs most: %.0f wrong pixels, %.4f %%", errors,
             100.0 * errors / ((double)request->w_px * request->h_px));
    print_search(&worst->found.error, score);
}

/* Instructions ------------------------------------------------------------------------------- */

static bool count_path(struct worst *worst, const struct measure_cpu *cpu, struct camera_path *path, struct cost *cost,
                       struct error *err)
{
    const struct measure_views views = {path, &worst->lens, worst->request.w_px, worst->request.h_px, NULL};
    const struct measure_candidate candidate = candidate_of(worst);
    return measure_cost(&candidate, cpu, &views, worst->folder.path, cost, err);
}

/* What was found, and random cameras, on emulated processors. */
static bool count(struct worst *worst, struct error *err)
{
    const struct measure_request *request = &worst->request;
    struct camera_path random = {0}, found = {"the camera that costs most", &worst->found.cost.goals[0].worst, 1};
    if (!request->cpu_count) return true;
    if (worst->scene.moving) return error_set(err, "%s: --core counts no moment of an animation", request->model);
    bool ok = work_folder_make(&worst->folder, err) &&
              random_path(&worst->scene, "random cameras", request->worst.seed, COUNTED_RANDOM, &random, err);
    for (size_t i = 0; ok && i < request->cpu_count; i++) {
        struct cost most, usual;
        ok = count_path(worst, request->cpus[i], &found, &most, err) &&
             count_path(worst, request->cpus[i], &random, &usual, err);
        if (!ok) break;
        printf("%s: %.0f instructions where it costs most, counted; %.0f in the mean of %d random cameras, %llu at "
               "most\n",
               request->cpus[i]->title, most.mean, usual.mean, COUNTED_RANDOM, (unsigned long long)usual.worst);
    }
    camera_path_free(&random);
    return ok;
}

/* Files -------------------------------------------------------------------------------------- */

static FILE *open_output(struct worst *worst, const char *suffix, char path[PATH_MAX_B], struct error *err)
{
    if (snprintf(path, PATH_MAX_B, "%s%s", worst->request.folder, suffix) >= PATH_MAX_B) {
        error_set(err, "-o '%.64s...': the path is too long", worst->request.folder);
        return NULL;
    }
    return outputs_open(&worst->outputs, path, err);
}

static bool write_picture(struct worst *worst, gdImagePtr image, const char *suffix, struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file = image ? open_output(worst, suffix, path, err) : NULL;
    const bool ok = file && image_write_png(image, file, path, err);
    if (image) gdImageDestroy(image);
    return file && outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
}

/* What cannot be written is told before all the work. */
static bool open_cameras(struct worst *worst, FILE **file, char path[PATH_MAX_B], struct error *err)
{
    *file = NULL;
    if (!worst->request.folder) return true;
    level_path_note(worst->request.model);
    *file = open_output(worst, ".cam", path, err);
    return *file != NULL;
}

static void write_cameras(const struct worst *worst, FILE *file)
{
    const struct search_result *const results[FOUND] = {&worst->found.cost, &worst->found.error};
    static const char *const whats[FOUND] = {"costs most", "errs most"};
    fputs("# limner worst: searched, not proved\n", file);
    for (int i = 0; i < FOUND; i++) {
        fprintf(file, "# %s, of %zu cameras\n", whats[i], results[i]->tried);
        viewpoint_write(&results[i]->goals[0].worst, file);
    }
}

static bool write_pictures(struct worst *worst, struct error *err)
{
    const struct measure_request *request = &worst->request;
    struct viewpoint found[FOUND] = {worst->found.cost.goals[0].worst, worst->found.error.goals[0].worst};
    const struct camera_path path = {"searched cameras", found, FOUND};
    const struct measure_views views = {&path, &worst->lens, request->w_px, request->h_px, NULL};
    const struct measure_candidate candidate = candidate_of(worst);
    return write_picture(worst, frame_picture(&candidate, &views, 0, NULL, err), "-cost.png", err) &&
           write_picture(worst, frame_picture(&candidate, &views, 1, NULL, err), "-error.png", err) &&
           write_picture(worst, difference_picture(&worst->source, &candidate, &views, 1, NULL, err), "-difference.png",
                         err);
}

static bool run(struct worst *worst, struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file;
    if (!open_cameras(worst, &file, path, err)) return false;
    bool ok = search(worst, err);
    if (ok && file) write_cameras(worst, file);
    if (file) ok = outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
    if (ok) print_found(worst);
    return ok && count(worst, err) && (!file || write_pictures(worst, err)) && outputs_keep(&worst->outputs, err);
}

int cmd_worst(int argc, char **argv)
{
    struct worst worst = {0};
    struct error err;
    const bool ok = measure_request_parse(argc, argv, MEASURE_WORST, &worst.request, &err) && run(&worst, &err);
    outputs_discard(&worst.outputs);
    work_folder_remove(&worst.folder);
    measure_source_free(&worst.source);
    compiled_free(&worst.scene);
    compile_options_free(&worst.request.compile);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
