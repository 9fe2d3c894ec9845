/* SPDX-License-Identifier: MIT
 *
 * The list says which results there have to be, and in which order they are joined. */
#include "measure/sweep_results.h"

#include "base/child.h"
#include "base/input_file.h"
#include "base/work_folder.h"
#include "measure/measure_request.h"
#include "measure/sweep_merge.h"
#include "outputs/outputs.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PATH_MAX_B = 1024, CORES_MAX = 8, NAME_MOST_B = 64, LIST_MOST_B = 1 << 24 };

/* What is asked for once all the list is read: how many results are missing, and the first of them. */
struct missing {
    size_t count, all;
    char first[PATH_MAX_B + NAME_MOST_B];
};

static bool add_result(struct sweep *sweep, const char *path, struct missing *missing, struct error *err)
{
    missing->all++;
    if (access(path, F_OK) == 0) return sweep_add(sweep, path, err);
    if (!missing->count++) snprintf(missing->first, sizeof missing->first, "%s", path);
    return true;
}

static bool add_listed(struct sweep *sweep, const char *folder, struct missing *missing, struct error *err)
{
    char path[PATH_MAX_B], result[PATH_MAX_B + NAME_MOST_B];
    if (snprintf(path, sizeof path, "%s/results.list", folder) >= PATH_MAX_B)
        return error_set(err, "--merge '%.64s...': the path is too long", folder);
    struct input_lines lines = {
        .file = input_open(path, LIST_MOST_B, NULL, err), .path = path, .line_most_b = NAME_MOST_B};
    if (!lines.file) return false;
    bool ok = true;
    err->text[0] = '\0';
    while (ok && input_line(&lines, err)) {
        snprintf(result, sizeof result, "%s/%s", folder, lines.line);
        ok = add_result(sweep, result, missing, err);
    }
    ok = ok && !err->text[0];
    input_lines_free(&lines);
    fclose(lines.file);
    return ok;
}

static bool add_results(struct sweep *sweep, const char *folder, struct error *err)
{
    struct missing missing = {0};
    if (!add_listed(sweep, folder, &missing, err)) return false;
    if (missing.count)
        return error_set(err, "%s: %zu of %zu results are missing, the first is %s; run the jobs that are left", folder,
                         missing.count, missing.all, missing.first);
    return sweep->count || error_set(err, "%s: there are no results", folder);
}

/* Outputs ---------------------------------------------------------------------------------------- */

static FILE *open_in(struct outputs *outputs, const char *folder, const char *name, char path[PATH_MAX_B],
                     struct error *err)
{
    if (snprintf(path, PATH_MAX_B, "%s/%s", folder, name) < PATH_MAX_B) return outputs_open(outputs, path, err);
    error_set(err, "--merge '%.64s...': the path is too long", folder);
    return NULL;
}

static bool copy_bytes(const char *from_path, FILE *to, struct error *err)
{
    char bytes[4096];
    FILE *from = fopen(from_path, "rb");
    if (!from) return error_set(err, "%s: cannot be read", from_path);
    for (size_t count; (count = fread(bytes, 1, sizeof bytes, from)) > 0;)
        fwrite(bytes, 1, count, to);
    fclose(from);
    return true;
}

/* A file of the work folder becomes one of the outputs. */
static bool put_copy(const char *from_path, const char *folder, const char *name, struct outputs *outputs,
                     struct error *err)
{
    char path[PATH_MAX_B];
    FILE *to = open_in(outputs, folder, name, path, err);
    if (!to) return false;
    const bool ok = copy_bytes(from_path, to, err);
    return outputs_close(to, path, ok ? err : &(struct error){0}) && ok;
}

static bool draw(const struct sweep *sweep, const char *csv_path, const char *png_path, const char *log_path,
                 struct error *err)
{
    const char *argv[CORES_MAX + 5] = {"gnuplot", "-c", MEASURE_PLOT, csv_path};
    FILE *csv = fopen(csv_path, "w");
    if (!csv) return error_set(err, "%s: cannot be written", csv_path);
    sweep_write_front(sweep, csv);
    sweep_cores(sweep, argv + 4, CORES_MAX);
    const struct child gnuplot = {.argv = argv, .out_path = png_path, .log_path = log_path};
    return (fclose(csv) == 0 || error_set(err, "%s: cannot be written", csv_path)) &&
           child_run(&gnuplot, "gnuplot", err);
}

static bool put_front(const struct sweep *sweep, const char *folder, struct outputs *outputs, struct error *err)
{
    struct work_folder work = {0};
    char csv[PATH_MAX_B], png[PATH_MAX_B], log[PATH_MAX_B];
    const char *counted[CORES_MAX];
    if (!sweep_cores(sweep, counted, CORES_MAX)) return true; /* nothing was counted */
    if (!child_exists("gnuplot"))
        return error_set(err, "gnuplot: not found; the plot needs Debian's package gnuplot-nox");
    const bool ok = work_folder_make(&work, err) && work_folder_place(&work, "front.csv", csv, sizeof csv, err) &&
                    work_folder_place(&work, "front.png", png, sizeof png, err) &&
                    work_folder_place(&work, "log", log, sizeof log, err) && draw(sweep, csv, png, log, err) &&
                    put_copy(csv, folder, "front.csv", outputs, err) &&
                    put_copy(png, folder, "front.png", outputs, err);
    work_folder_remove(&work);
    return ok;
}

static bool put_table(const struct sweep *sweep, const char *folder, struct outputs *outputs, struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file = open_in(outputs, folder, "sweep.csv", path, err);
    if (!file) return false;
    sweep_write(sweep, file);
    return outputs_close(file, path, err);
}

bool sweep_results_join(const char *folder, struct error *err)
{
    struct sweep sweep = {0};
    struct outputs outputs = {0};
    const bool ok = add_results(&sweep, folder, err) && put_table(&sweep, folder, &outputs, err) &&
                    put_front(&sweep, folder, &outputs, err) && outputs_keep(&outputs, err);
    outputs_discard(&outputs);
    sweep_free(&sweep);
    return ok;
}
