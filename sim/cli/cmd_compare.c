/* SPDX-License-Identifier: MIT
 *
 * `limner compare`: every visibility method on one model and its cameras. The table goes to standard output; with
 * -o, it, its CSV and pictures of what is wrong go to a folder, all or none. */
#include "base/progress.h"
#include "base/work_folder.h"
#include "cli/commands.h"
#include "compiler/faithful.h"
#include "core/core.h"
#include "measure/compare_methods.h"
#include "measure/difference.h"
#include "outputs/outputs.h"
#include "pictures/image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_MAX_B = 1024 };

struct comparing {
    struct measure_request request;
    struct measure_source source;
    struct camera_path path, cost_path;
    struct lens lens;
    struct compare_table table;
    struct difference_cell *cells; /* one a row */
    struct work_folder folder;
    struct outputs outputs;
    FILE *markdown, *csv; /* NULL: not open */
    char markdown_path[PATH_MAX_B], csv_path[PATH_MAX_B];
};

/* Files --------------------------------------------------------------------------------------- */

/* DIR/NAMESUFFIX */
static FILE *open_file(struct comparing *comparing, const char *name, const char *suffix, char path[PATH_MAX_B],
                       struct error *err)
{
    const char *folder = comparing->request.folder;
    if (snprintf(path, PATH_MAX_B, "%s/%s%s", folder, name, suffix) < PATH_MAX_B)
        return outputs_open(&comparing->outputs, path, err);
    error_set(err, "-o '%.64s...': the path is too long", folder);
    return NULL;
}

/* Before all work: a folder that cannot be written is not to be noticed after it. */
static bool open_tables(struct comparing *comparing, struct error *err)
{
    if (!comparing->request.folder) return true;
    comparing->markdown = open_file(comparing, "compare", ".md", comparing->markdown_path, err);
    if (comparing->markdown) comparing->csv = open_file(comparing, "compare", ".csv", comparing->csv_path, err);
    return comparing->csv != NULL;
}

static bool close_tables(struct comparing *comparing, struct error *err)
{
    FILE *const files[] = {comparing->markdown, comparing->csv};
    comparing->markdown = comparing->csv = NULL;
    const bool ok = !files[0] || outputs_close(files[0], comparing->markdown_path, err);
    return (!files[1] || outputs_close(files[1], comparing->csv_path, ok ? err : &(struct error){0})) && ok;
}

/* Start -------------------------------------------------------------------------------------- */

static const struct compiled *any_scene(const struct compare_table *table)
{
    size_t i = 0;
    while (!compare_row_draws(&table->rows[i]))
        i++;
    return &table->rows[i].scene;
}

/* As many of the cameras as are wanted. */
static bool choose_cameras(struct comparing *comparing, struct error *err)
{
    const struct measure_request *request = &comparing->request;
    faithful_note(any_scene(&comparing->table));
    return measure_request_cameras(request, any_scene(&comparing->table), &comparing->lens, &comparing->path, err) &&
           camera_path_few(&comparing->path, request->cost_frames, &comparing->cost_path, err);
}

static bool prepare(struct comparing *comparing, struct error *err)
{
    struct measure_request *request = &comparing->request;
    struct compare_table *table = &comparing->table;
    *table = (struct compare_table){.scene = request->name,
                                    .w_px = request->w_px,
                                    .h_px = request->h_px,
                                    .core = request->cores[0],
                                    .cpus = request->cpus,
                                    .cpu_count = request->cpu_count,
                                    .rows = calloc(method_count, sizeof *table->rows)};
    comparing->cells = calloc(method_count, sizeof *comparing->cells);
    if (!table->rows || !comparing->cells) return error_set(err, "compare: out of memory");
    return measure_request_load(request, &comparing->source, &comparing->lens, &comparing->path, err) &&
           (compare_methods_compile(&comparing->source, &request->compile, table, err) ||
            error_prefix(err, request->model)) &&
           choose_cameras(comparing, err);
}

/* Measuring ---------------------------------------------------------------------------------- */

static struct measure_views views_of(const struct comparing *comparing, const struct camera_path *path)
{
    return (struct measure_views){path, &comparing->lens, comparing->request.w_px, comparing->request.h_px, NULL};
}

static bool measure_all(struct comparing *comparing, struct error *err)
{
    const struct measure_views views = views_of(comparing, &comparing->path);
    const struct measure_views cost_views = views_of(comparing, &comparing->cost_path);
    if (!compare_methods_accuracy(&comparing->source, &views, &comparing->table, err)) return false;
    if (comparing->table.cpu_count) compare_methods_cost(&cost_views, comparing->folder.path, &comparing->table);
    return true;
}

/* Pictures ----------------------------------------------------------------------------------- */

static gdImagePtr draw(struct comparing *comparing, const struct compare_row *row, size_t frame, struct error *err)
{
    const struct measure_views views = views_of(comparing, &comparing->path);
    const struct measure_candidate candidate = {comparing->table.core, &row->scene};
    progress("pictures, %s", row->method->name);
    return difference_picture(&comparing->source, &candidate, &views, frame, NULL, err);
}

/* The frame in which some method is at its worst. */
static size_t frame_to_show(const struct compare_table *table)
{
    const struct comparison *shown = &table->rows[0].accuracy.pixels;
    for (size_t i = 1; i < method_count; i++) {
        const struct comparison *pixels = &table->rows[i].accuracy.pixels;
        if (compare_is_faultier(&pixels->faultiest, &shown->faultiest)) shown = pixels;
    }
    return shown->faultiest_frame;
}

/* All methods in one frame. */
static bool draw_cells(struct comparing *comparing, struct error *err)
{
    const struct compare_table *table = &comparing->table;
    const size_t frame = frame_to_show(table);
    for (size_t i = 0; i < method_count; i++) {
        const struct compare_row *row = &table->rows[i];
        struct difference_cell *cell = &comparing->cells[i];
        const bool draws = compare_row_draws(row);
        snprintf(cell->caption, sizeof cell->caption, draws ? "%s" : "%s: does not draw it", row->method->name);
        if (!draws) continue;
        cell->picture = draw(comparing, row, frame, err);
        if (!cell->picture) return false;
    }
    return true;
}

/* Output ------------------------------------------------------------------------------------- */

static bool write_picture(struct comparing *comparing, const char *name, gdImagePtr picture, struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file = open_file(comparing, name, ".png", path, err);
    if (!file) return false;
    const bool ok = image_write_png(picture, file, path, err);
    return outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
}

static bool write_sheet(struct comparing *comparing, struct error *err)
{
    gdImagePtr sheet =
        difference_sheet(comparing->cells, method_count, comparing->request.w_px, comparing->request.h_px);
    const bool ok = sheet ? write_picture(comparing, "sheet", sheet, err) : error_set(err, "sheet: out of memory");
    if (sheet) gdImageDestroy(sheet);
    return ok;
}

/* What a method gets wrong, in the frame that shows most of it: often the sheet has that picture. */
static bool write_worst(struct comparing *comparing, size_t method, struct error *err)
{
    const struct compare_row *row = &comparing->table.rows[method];
    const size_t frame = row->accuracy.pixels.faultiest_frame;
    if (frame == frame_to_show(&comparing->table))
        return write_picture(comparing, row->method->name, comparing->cells[method].picture, err);
    gdImagePtr picture = draw(comparing, row, frame, err);
    if (!picture) return false;
    const bool ok = write_picture(comparing, row->method->name, picture, err);
    gdImageDestroy(picture);
    return ok;
}

static bool write_pictures(struct comparing *comparing, struct error *err)
{
    if (!draw_cells(comparing, err)) return false;
    for (size_t i = 0; i < method_count; i++) {
        const struct compare_row *row = &comparing->table.rows[i];
        if (!compare_row_draws(row) || (row->method->exact && compare_row_is_right(&comparing->table, row))) continue;
        if (!write_worst(comparing, i, err)) return false;
    }
    return write_sheet(comparing, err);
}

static bool write_files(struct comparing *comparing, struct error *err)
{
    if (!comparing->request.folder) return true;
    compare_table_markdown(&comparing->table, comparing->markdown);
    compare_table_csv(&comparing->table, comparing->csv);
    return close_tables(comparing, err) && write_pictures(comparing, err) && outputs_keep(&comparing->outputs, err);
}

static bool run(struct comparing *comparing, struct error *err)
{
    const bool ok = open_tables(comparing, err) && work_folder_make(&comparing->folder, err) &&
                    prepare(comparing, err) && measure_all(comparing, err) && write_files(comparing, err);
    progress_end();
    if (!ok) return false;
    compare_table_markdown(&comparing->table, stdout);
    return true;
}

static void comparing_free(struct comparing *comparing)
{
    close_tables(comparing, &(struct error){0});
    outputs_discard(&comparing->outputs);
    work_folder_remove(&comparing->folder);
    for (size_t i = 0; i < method_count; i++) {
        if (comparing->table.rows) compiled_free(&comparing->table.rows[i].scene);
        if (comparing->cells && comparing->cells[i].picture) gdImageDestroy(comparing->cells[i].picture);
    }
    measure_source_free(&comparing->source);
    camera_path_free(&comparing->path);
    camera_path_free(&comparing->cost_path);
    free(comparing->table.rows);
    free(comparing->cells);
    compile_options_free(&comparing->request.compile);
}

int cmd_compare(int argc, char **argv)
{
    struct comparing comparing = {0};
    struct error err;
    const bool ok =
        measure_request_parse(argc, argv, MEASURE_METHODS, &comparing.request, &err) && run(&comparing, &err);
    comparing_free(&comparing);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
