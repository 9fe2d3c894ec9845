/* SPDX-License-Identifier: MIT
 *
 * `limner compare`: every visibility method on one model and its cameras. The table goes to standard output; with
 * -o, it, its CSV and pictures of what is wrong go to a folder, all or none. */
#include "commands.h"
#include "compare_methods.h"
#include "difference.h"
#include "image.h"
#include "interrupt.h"
#include "outputs.h"
#include "progress.h"
#include "work_folder.h"

#include <errno.h>
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
};

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
    struct camera_path all = comparing->path;
    if (!comparing->request.camera && !camera_path_orbit(any_scene(&comparing->table), &comparing->lens,
                                                         MEASURE_ORBIT_FRAMES, &all, err))
        return false;
    comparing->path = (struct camera_path){0};
    const bool ok = camera_path_few(&all, comparing->request.frames, &comparing->path, err) &&
                    camera_path_few(&comparing->path, comparing->request.cost_frames, &comparing->cost_path, err);
    camera_path_free(&all);
    return ok;
}

static bool prepare(struct comparing *comparing, struct error *err)
{
    const struct measure_request *request = &comparing->request;
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
    return (struct measure_views){path, &comparing->lens, comparing->request.w_px, comparing->request.h_px};
}

static bool measure_all(struct comparing *comparing, struct error *err)
{
    const struct measure_views views = views_of(comparing, &comparing->path);
    const struct measure_views cost_views = views_of(comparing, &comparing->cost_path);
    return compare_methods_accuracy(&comparing->source, &views, &comparing->table, err) &&
           (!comparing->table.cpu_count ||
            compare_methods_cost(&cost_views, comparing->folder.path, &comparing->table, err));
}

/* Pictures ----------------------------------------------------------------------------------- */

/* What a method got wrong in the frame that shows most of it. */
static bool draw_cell(struct comparing *comparing, const struct compare_row *row, struct difference_cell *cell,
                      struct error *err)
{
    if (!compare_row_draws(row)) {
        snprintf(cell->caption, sizeof cell->caption, "%s: does not draw it", row->method->name);
        return true;
    }
    const struct measure_views views = views_of(comparing, &comparing->path);
    const struct measure_candidate candidate = {comparing->table.core, &row->scene};
    const struct comparison *pixels = &row->accuracy.pixels;
    snprintf(cell->caption, sizeof cell->caption, "%s: %.2f %%, frame %zu", row->method->name,
             compare_wrong_percent(&pixels->faultiest), pixels->faultiest_frame);
    progress("pictures, %s", row->method->name);
    cell->picture = difference_picture(&comparing->source, &candidate, &views, pixels->faultiest_frame, err);
    return cell->picture != NULL;
}

static bool draw_cells(struct comparing *comparing, struct error *err)
{
    for (size_t i = 0; i < method_count; i++)
        if (!interrupt_check(err) || !draw_cell(comparing, &comparing->table.rows[i], &comparing->cells[i], err))
            return false;
    return true;
}

/* Output ------------------------------------------------------------------------------------- */

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

static bool write_table(struct comparing *comparing, const char *name,
                        void (*write)(const struct compare_table *, FILE *), struct error *err)
{
    char path[PATH_MAX_B];
    FILE *file = open_file(comparing, name, "", path, err);
    if (!file) return false;
    write(&comparing->table, file);
    return outputs_close(file, path, err);
}

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

static bool write_pictures(struct comparing *comparing, struct error *err)
{
    if (!draw_cells(comparing, err)) return false;
    for (size_t i = 0; i < method_count; i++) {
        const struct compare_row *row = &comparing->table.rows[i];
        if (!compare_row_draws(row) || (row->method->exact && compare_row_is_right(row))) continue;
        if (!write_picture(comparing, row->method->name, comparing->cells[i].picture, err)) return false;
    }
    return write_sheet(comparing, err);
}

static bool write_files(struct comparing *comparing, struct error *err)
{
    if (!comparing->request.folder) return true;
    return write_table(comparing, "compare.md", compare_table_markdown, err) &&
           write_table(comparing, "compare.csv", compare_table_csv, err) && write_pictures(comparing, err) &&
           interrupt_check(err) && outputs_keep(&comparing->outputs, err);
}

static bool run(struct comparing *comparing, struct error *err)
{
    interrupt_watch();
    const bool ok = work_folder_make(&comparing->folder, err) && prepare(comparing, err) &&
                    measure_all(comparing, err) && write_files(comparing, err);
    progress_end();
    if (!ok) return false;
    compare_table_markdown(&comparing->table, stdout);
    return (fflush(stdout) == 0 && !ferror(stdout)) || error_set(err, "standard output: %s", strerror(errno));
}

static void comparing_free(struct comparing *comparing)
{
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
