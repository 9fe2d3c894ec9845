/* SPDX-License-Identifier: MIT
 *
 * Each method has a scene of its own, as the kind of tree goes with it; the reference draws each frame once for all.
 * Two methods that come to the same scene drawn the same way are counted once. */
#include "measure/compare_methods.h"

#include "base/deadline.h"
#include "base/progress.h"
#include "compiler/compile.h"
#include "render/simulator.h"

#include <stdlib.h>
#include <string.h>

/* Of the time that the first method's scene leaves; the rest is for pictures and instructions. */
static const double COMPILE_SHARE = 0.5;

/* Compiling ---------------------------------------------------------------------------------- */

/* Whether the renderer takes the scene, before all methods start together. */
static bool try_renderer(const struct compare_table *table, const struct compiled *scene, struct error *err)
{
    const struct simulator_setup setup = {table->w_px, table->h_px, scene->report.draws, SIMULATOR_MEMORY, table->core};
    struct simulator simulator;
    if (!simulator_init(&simulator, &scene->scene, &setup, err)) return false;
    const bool ok = simulator_add_movers(&simulator, scene, err);
    simulator_free(&simulator);
    return ok;
}

static void compile_row(const struct measure_source *source, const struct compile_options *options,
                        const struct compare_table *table, struct compare_row *row)
{
    struct compile_options mine = *options;
    if (compile_method_parse(row->method->name, &mine, &row->why_not) && compile_options_settle(&mine, &row->why_not) &&
        measure_source_compile(source, &mine, &row->scene, &row->why_not) &&
        try_renderer(table, &row->scene, &row->why_not)) {
        row->why_not.text[0] = '\0';
        return;
    }
    compiled_free(&row->scene);
}

bool compare_methods_compile(const struct measure_source *source, const struct compile_options *options,
                             struct compare_table *table, struct error *err)
{
    bool any = false;
    const struct deadline_end whole = deadline_end();
    for (size_t i = 0; i < method_count; i++) {
        progress_bar(i, method_count, "compiling for %s", methods[i].name);
        table->rows[i].method = &methods[i];
        compile_row(source, options, table, &table->rows[i]);
        if (!any && compare_row_draws(&table->rows[i])) deadline_share(COMPILE_SHARE);
        any |= compare_row_draws(&table->rows[i]);
    }
    if (any) deadline_say("methods whose scene was compiled in time; the others' rows say so");
    deadline_restore(whole);
    return any || error_set(err, "%s", table->rows[0].why_not.text);
}

/* Accuracy ----------------------------------------------------------------------------------- */

static struct measure_candidate candidate_of(const struct compare_table *table, const struct compare_row *row)
{
    return (struct measure_candidate){table->core, &row->scene};
}

bool compare_methods_accuracy(struct measure_source *source, const struct measure_views *views,
                              struct compare_table *table, struct error *err)
{
    struct measure_candidate *candidates = calloc(method_count, sizeof *candidates);
    struct accuracy *accuracies = calloc(method_count, sizeof *accuracies);
    bool ok = (candidates && accuracies) || error_set(err, "compare: out of memory");
    size_t count = 0;
    for (size_t i = 0; ok && i < method_count; i++)
        if (compare_row_draws(&table->rows[i])) candidates[count++] = candidate_of(table, &table->rows[i]);
    ok = ok && measure_accuracy(source, views, candidates, count, accuracies, err);
    for (size_t i = 0, done = 0; ok && i < method_count; i++)
        if (compare_row_draws(&table->rows[i])) table->rows[i].accuracy = accuracies[done++];
    table->frames = count ? accuracies[0].pixels.frames : 0;
    free(candidates);
    free(accuracies);
    return ok;
}

/* Cost --------------------------------------------------------------------------------------- */

static bool is_same(const struct compiled *a, const struct compiled *b)
{
    return a->report.draws == b->report.draws && a->image_b == b->image_b &&
           memcmp(a->image, b->image, a->image_b) == 0;
}

/* An earlier row that draws the same scene in the same way, or NULL. */
static const struct compare_row *find_same(const struct compare_table *table, const struct compare_row *row)
{
    for (const struct compare_row *other = table->rows; other < row; other++)
        if (compare_row_draws(other) && is_same(&other->scene, &row->scene)) return other;
    return NULL;
}

/* What fails for one method is said in its row: the others' figures stand. */
static void row_cost(const struct measure_views *views, const char *folder, size_t cpu,
                     const struct compare_table *table, struct compare_row *row)
{
    const struct compare_row *same = find_same(table, row);
    const struct measure_candidate candidate = candidate_of(table, row);
    if (same) {
        row->costs[cpu] = same->costs[cpu];
        row->not_counted[cpu] = same->not_counted[cpu];
        return;
    }
    progress("instructions, %s, %s", table->cpus[cpu]->title, row->method->name);
    if (measure_cost(&candidate, table->cpus[cpu], views, folder, &row->costs[cpu], &row->not_counted[cpu]))
        row->not_counted[cpu].text[0] = '\0';
}

void compare_methods_cost(const struct measure_views *views, const char *folder, struct compare_table *table)
{
    table->cost_frames = views->path->count;
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++) {
        table->not_counted[cpu].text[0] = '\0';
        if (!measure_cpu_check(table->cpus[cpu], &table->not_counted[cpu])) continue;
        for (size_t i = 0; i < method_count; i++)
            if (compare_row_draws(&table->rows[i])) row_cost(views, folder, cpu, table, &table->rows[i]);
    }
}
