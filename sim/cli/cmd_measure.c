/* SPDX-License-Identifier: MIT
 *
 * `limner measure`: every precision profile's accuracy and cost on a model and its cameras. Tables go to
 * standard output; with -o, they and a plot go to a folder, all or none. */
#include "base/child.h"
#include "base/deadline.h"
#include "base/inputs.h"
#include "base/progress.h"
#include "base/work_folder.h"
#include "cli/commands.h"
#include "compiler/faithful.h"
#include "core/core.h"
#include "levels/level_path.h"
#include "measure/measure_request.h"
#include "measure/measure_table.h"
#include "measure/measure_tools.h"
#include "measure/result_file.h"
#include "measure/shimmer.h"
#include "outputs/outputs.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_MAX_B = 1024 };

struct measurement {
    struct measure_request request;
    struct measure_source source;
    struct measure_scenes scenes;
    struct camera_path path;
    struct lens lens;
    struct measure_candidate *candidates; /* one a row */
    struct accuracy *accuracies;
    struct measure_table table;
    struct work_folder folder;
    struct outputs outputs;
};

/* Start -------------------------------------------------------------------------------------- */

/* Rows whose scene takes too long, or is refused, are left out, as long as there are others. */
static bool compile_rows(struct measurement *measurement, struct error *err)
{
    const struct measure_request *request = &measurement->request;
    struct measure_table *table = &measurement->table;
    table->row_count = request->core_count;
    for (size_t i = 0; i < request->core_count; i++)
        measurement->candidates[i].core = request->cores[i];
    const bool ok = measure_compile(&measurement->scenes, &measurement->source, &request->compile,
                                    measurement->candidates, &table->row_count, &table->refused, err);
    for (size_t i = 0; i < table->row_count; i++)
        table->rows[i].core = measurement->candidates[i].core;
    return ok;
}

static bool prepare(struct measurement *measurement, struct error *err)
{
    struct measure_request *request = &measurement->request;
    const size_t count = request->core_count;
    if (!measure_request_load(request, &measurement->source, &measurement->lens, &measurement->path, err)) return false;
    measurement->candidates = calloc(count, sizeof *measurement->candidates);
    measurement->accuracies = calloc(count, sizeof *measurement->accuracies);
    measurement->table.rows = calloc(count, sizeof *measurement->table.rows);
    if (!measurement->candidates || !measurement->accuracies || !measurement->table.rows)
        return error_set(err, "measure: out of memory");
    if (!compile_rows(measurement, err)) return false;
    measure_refusals_print(&measurement->table.refused, "limner: note: ", stderr);
    for (int i = 0; i < MEASURE_PROFILES; i++)
        faithful_note(&measurement->scenes.of[i]);
    return measure_request_cameras(request, measurement->candidates[0].scene, &measurement->lens, &measurement->path,
                                   err);
}

/* Measuring ---------------------------------------------------------------------------------- */

/* Time is over: rows without all figures are left out, or if there is none with them, the figures. */
static void leave_out(struct measure_table *table, size_t runs)
{
    const size_t complete = runs / table->cpu_count;
    char names[256] = "";
    for (size_t row = complete, at = 0; row < table->row_count && at < sizeof names; row++)
        at += (size_t)snprintf(names + at, sizeof names - at, "%s%s", at ? ", " : "", table->rows[row].core->name);
    deadline_say("%s; instructions not counted: %s", complete ? "rows that are complete" : "accuracy alone", names);
    if (complete)
        table->row_count = complete;
    else
        table->cpu_count = 0;
}

static bool measure_shimmer(struct measurement *measurement, const struct measure_views *views, struct error *err)
{
    struct measure_table *table = &measurement->table;
    for (size_t i = 0; i < table->row_count; i++) {
        progress_bar(i, table->row_count, "shimmer, %s", table->rows[i].core->name);
        if (!shimmer_measure(&measurement->candidates[i], views, &table->rows[i].accuracy.shimmer, err)) return false;
    }
    return true;
}

static bool measure_costs(struct measurement *measurement, const struct measure_views *views, struct error *err)
{
    struct measure_table *table = &measurement->table;
    const size_t count = table->row_count * table->cpu_count;
    for (size_t i = 0; i < count; i++) {
        const size_t row = i / table->cpu_count, cpu = i % table->cpu_count;
        progress_bar(i, count, "instructions, run %zu of %zu", i + 1, count);
        const bool ok = deadline_check(err, "instructions") &&
                        measure_cost(&measurement->candidates[row], table->cpus[cpu], views, measurement->folder.path,
                                     &table->rows[row].costs[cpu], err);
        if (!ok && !deadline_passed()) return false;
        if (!ok) leave_out(table, i);
        if (!ok) return true;
    }
    return true;
}

static bool measure_all(struct measurement *measurement, struct error *err)
{
    const struct measure_request *request = &measurement->request;
    const struct measure_views views = {&measurement->path, &measurement->lens, request->w_px, request->h_px,
                                        request->optimise};
    struct measure_table *table = &measurement->table;
    table->scene = request->name;
    table->w_px = request->w_px;
    table->h_px = request->h_px;
    table->scales = measure_scales_of(&measurement->source.mesh);
    table->cpus = request->cpus;
    table->cpu_count = request->cpu_count;
    table->optimise = request->optimise;
    const enum lim_method draws = measurement->candidates[0].scene->report.draws;
    if (!method_is_exact(draws)) table->drawn = method_title(draws);
    if (!measure_accuracy(&measurement->source, &views, measurement->candidates, table->row_count,
                          measurement->accuracies, err))
        return false;
    for (size_t i = 0; i < table->row_count; i++)
        table->rows[i].accuracy = measurement->accuracies[i];
    if (!measure_shimmer(measurement, &views, err)) return false;
    if (!measure_costs(measurement, &views, err)) return false;
    measure_table_judge(table);
    return true;
}

/* Output ------------------------------------------------------------------------------------- */

static bool output_path(const struct measurement *measurement, const char *name, char path[PATH_MAX_B],
                        struct error *err)
{
    return snprintf(path, PATH_MAX_B, "%s/%s", measurement->request.folder, name) < PATH_MAX_B ||
           error_set(err, "-o '%.64s...': the path is too long", measurement->request.folder);
}

static bool write_table(struct measurement *measurement, const char *name,
                        void (*write)(const struct measure_table *, FILE *), struct error *err)
{
    char path[PATH_MAX_B];
    if (!output_path(measurement, name, path, err)) return false;
    FILE *file = outputs_open(&measurement->outputs, path, err);
    if (!file) return false;
    write(&measurement->table, file);
    return outputs_close(file, path, err);
}

static bool copy_file(const char *from_path, FILE *to, struct error *err)
{
    char bytes[4096];
    FILE *from = fopen(from_path, "rb");
    if (!from) return error_set(err, "%s: %s", from_path, strerror(errno));
    for (size_t count; (count = fread(bytes, 1, sizeof bytes, from)) > 0;)
        fwrite(bytes, 1, count, to);
    fclose(from);
    return true;
}

static bool run_gnuplot(const struct measurement *measurement, const char *png_path, struct error *err)
{
    const struct measure_table *table = &measurement->table;
    char csv_path[PATH_MAX_B], log_path[PATH_MAX_B];
    const char *argv[MEASURE_CPUS_MAX + 5] = {"gnuplot", "-c", MEASURE_PLOT, csv_path};
    snprintf(csv_path, sizeof csv_path, "%s/measure.csv", measurement->folder.path);
    snprintf(log_path, sizeof log_path, "%s/log", measurement->folder.path);
    for (size_t cpu = 0; cpu < table->cpu_count; cpu++)
        argv[4 + cpu] = table->cpus[cpu]->name;
    FILE *csv = fopen(csv_path, "w");
    if (!csv) return error_set(err, "%s: cannot be written", csv_path);
    measure_table_csv(table, csv);
    const struct child gnuplot = {.argv = argv, .out_path = png_path, .log_path = log_path};
    return (fclose(csv) == 0 || error_set(err, "%s: cannot be written", csv_path)) &&
           child_run(&gnuplot, "gnuplot", err);
}

static bool write_plot(struct measurement *measurement, struct error *err)
{
    char path[PATH_MAX_B], png_path[PATH_MAX_B];
    snprintf(png_path, sizeof png_path, "%s/measure.png", measurement->folder.path);
    if (!output_path(measurement, "measure.png", path, err) || !run_gnuplot(measurement, png_path, err)) return false;
    FILE *file = outputs_open(&measurement->outputs, path, err);
    if (!file) return false;
    const bool ok = copy_file(png_path, file, err);
    return outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
}

/* What a result says must be all that was asked for. */
static bool write_result(struct measurement *measurement, struct error *err)
{
    const struct measure_request *request = &measurement->request;
    const struct measure_table *table = &measurement->table;
    if (!request->result) return true;
    if (table->row_count < request->core_count || table->cpu_count < request->cpu_count || deadline_cuts())
        return error_set(err, "%s: no result: not all of it was measured in time, or a precision is refused",
                         request->model);
    return result_file_put(table, request->model, request->compile.method ? request->compile.method->name : "auto",
                           request->result, &measurement->outputs, err);
}

static bool write_folder(struct measurement *measurement, struct error *err)
{
    if (!measurement->request.folder) return true;
    const bool with_cost = measurement->table.cpu_count > 0;
    return write_table(measurement, "measure.md", measure_table_markdown, err) &&
           write_table(measurement, "measure.csv", measure_table_csv, err) &&
           (!with_cost || (write_table(measurement, "stages.csv", measure_table_stages_csv, err) &&
                           (measurement->request.no_plot || write_plot(measurement, err))));
}

static bool write_files(struct measurement *measurement, struct error *err)
{
    return write_folder(measurement, err) && write_result(measurement, err) && outputs_keep(&measurement->outputs, err);
}

/* For --result; the importer notes the model's. */
static void note_cameras(const struct camera_choice *cameras)
{
    if (cameras->text && !cameras->random_count && !level_path_parse(cameras->text, NULL)) inputs_note(cameras->text);
}

static bool run(struct measurement *measurement, struct error *err)
{
    note_cameras(&measurement->request.cameras);
    measure_tools_fit(&measurement->request);
    const bool ok = measure_request_check(&measurement->request, err) && work_folder_make(&measurement->folder, err) &&
                    measure_request_load_variants(&measurement->request, measurement->folder.path, err) &&
                    prepare(measurement, err) && measure_all(measurement, err) && write_files(measurement, err);
    progress_end();
    if (!ok) return false;
    measure_table_markdown(&measurement->table, stdout);
    return true;
}

static void measurement_free(struct measurement *measurement)
{
    outputs_discard(&measurement->outputs);
    work_folder_remove(&measurement->folder);
    measure_source_free(&measurement->source);
    camera_path_free(&measurement->path);
    measure_scenes_free(&measurement->scenes);
    free(measurement->candidates);
    free(measurement->accuracies);
    free(measurement->table.rows);
    compile_options_free(&measurement->request.compile);
}

int cmd_measure(int argc, char **argv)
{
    struct measurement measurement = {0};
    struct error err;
    const bool ok =
        measure_request_parse(argc, argv, MEASURE_PRECISIONS, &measurement.request, &err) && run(&measurement, &err);
    measurement_free(&measurement);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
