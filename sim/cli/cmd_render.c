/* SPDX-License-Identifier: MIT
 *
 * `limner render`: options -> scene and camera path -> frames -> files and tables. Either all files
 * that were asked for are there at the end, or none. */
#include "accuracy/edge_error.h"
#include "accuracy/frame_table.h"
#include "accuracy/moving_reference.h"
#include "accuracy/unsettled.h"
#include "base/deadline.h"
#include "base/grow.h"
#include "base/inputs.h"
#include "base/notice.h"
#include "base/progress.h"
#include "cameras/cameras_c.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "compiler/faithful.h"
#include "core/core.h"
#include "levels/level_path.h"
#include "model/mapping.h"
#include "outputs/outputs.h"
#include "pictures/dump.h"
#include "pictures/frame_file.h"
#include "pictures/hashes.h"
#include "readers/source.h"
#include "render/caption.h"
#include "render/frame_cost.h"
#include "render/ids.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 1 GB. */
static const size_t FILM_MOST_PX = (size_t)1 << 29;

struct render {
    struct options options;
    struct compiled scene;
    struct moving moving;
    struct lens lens;
    struct camera_path path;
    double frames_per_s;
    struct simulator simulator;
    struct ids ids;             /* --ids, --compare */
    struct reference reference; /* --compare */
    uint32_t *groups;           /* faces of one polygon, for what compares; NULL: each is for itself */
    struct edge_error edges;    /* --antialias --compare */
    struct caption caption;     /* --overlay */
    struct outputs outputs;
    FILE *gif_file, *sheet_file, *ids_file, *hashes_file, *cameras_file; /* NULL: not asked for */
    struct frame_row *rows;                                              /* one a frame */
    uint64_t *hashes;                                                    /* one a frame */
    uint16_t *film_pixels;                                               /* all frames, for --gif and --sheet */
};

/* Begin -------------------------------------------------------------------------------------- */

static bool open_output(struct render *render, const char *path, FILE **file, struct error *err)
{
    if (!path) return true;
    *file = outputs_open(&render->outputs, path, err);
    return *file != NULL;
}

/* What can be refused without the scene is refused before it is compiled. */
static bool open_outputs(struct render *render, struct error *err)
{
    const struct options *options = &render->options;
    if (options->compare && options_scene_is_compiled(options))
        return error_set(err, "--compare: %s holds no source polygons; give the model", options->scene_path);
    const char *cameras_path = options->cameras.random_count ? NULL : options->cameras.text;
    level_path_note(options->scene_path);
    if (cameras_path) inputs_note_name(cameras_path);
    if (options->check_path) inputs_note_name(options->check_path);
    return open_output(render, options->gif_path, &render->gif_file, err) &&
           open_output(render, options->sheet_path, &render->sheet_file, err) &&
           open_output(render, options->ids_path, &render->ids_file, err) &&
           open_output(render, options->hashes_path, &render->hashes_file, err) &&
           open_output(render, options->cameras_path, &render->cameras_file, err);
}

static bool allocate(struct render *render, struct error *err)
{
    const struct options *options = &render->options;
    const size_t frame_count = render->path.count, pixel_count = (size_t)options->setup.w_px * options->setup.h_px;
    render->rows = calloc(frame_count, sizeof render->rows[0]);
    render->hashes = calloc(frame_count, sizeof render->hashes[0]);
    bool want_film = render->gif_file || render->sheet_file;
    if (want_film && frame_count > FILM_MOST_PX / pixel_count)
        return error_set(err, "%zu frames of %ux%u pixels: --gif and --sheet take %zu such frames at most", frame_count,
                         options->setup.w_px, options->setup.h_px, FILM_MOST_PX / pixel_count);
    if (want_film) render->film_pixels = calloc(frame_count, pixel_count * sizeof render->film_pixels[0]);
    return (render->rows && render->hashes && (!want_film || render->film_pixels)) ||
           error_set(err, "%zu frames of %ux%u pixels: out of memory", frame_count, options->setup.w_px,
                     options->setup.h_px);
}

/* What was merged is one face for whoever compares; with --ids nothing is. */
static bool take_groups(struct render *render, struct error *err)
{
    if (render->options.compile.keep_faces) return true;
    if (render->moving.count) return moving_groups(&render->moving, &render->groups, err);
    render->groups = render->scene.groups;
    render->scene.groups = NULL;
    return true;
}

/* The reference's faces have colours if none of them moves. */
static bool measures_edges(const struct render *render)
{
    return render->options.compare && render->options.compile.antialias && !render->moving.count;
}

static bool read_reference(struct render *render, unsigned w_px, unsigned h_px, struct error *err)
{
    const char *path = render->options.scene_path;
    struct moving *moving = &render->moving;
    const bool ok = moving->count ? source_take(path, &moving->model, err) &&
                                        moving_reference(moving, &render->reference, w_px, h_px, err)
                                  : reference_read(&render->reference, path, &render->options.compile.orientation,
                                                   &render->scene.grid, w_px, h_px, err);
    const bool shares = moving->count ? !moving->model.source_points : render->reference.shares_importer;
    if (ok && shares)
        notice("%s: the reference has no reader of its own for it, and has the importer's vertices", path);
    return ok;
}

static bool start(struct render *render, struct error *err)
{
    const struct options *options = &render->options;
    render->frames_per_s = options_rate(options, &render->moving, render->path.count);
    const unsigned w_px = options->setup.w_px, h_px = options->setup.h_px;
    if (!simulator_init_on(&render->simulator, &render->scene.scene, &options->setup, &options->panel, err))
        return false;
    if (!simulator_set_ram(&render->simulator, &options->ram, err)) return false;
    render->simulator.core->newell(render->simulator.lim, &options->newell);
    simulator_set_wireframe(&render->simulator, &options->wireframe);
    struct moving *moving = &render->moving;
    if (moving->count &&
        !simulator_set_movers(&render->simulator, moving->instances, moving->count, &moving->limits, err))
        return false;
    if (moving->count) render->simulator.core->light(render->simulator.lim, &moving->light);
    if (!simulator_set_antialias(&render->simulator, options->compile.antialias, err) ||
        !simulator_set_delta(&render->simulator, options->delta_runs, err))
        return false;
    bool want_ids = options->ids_path || options->compare;
    if (want_ids && !ids_init(&render->ids, &render->scene, &options->setup, err)) return false;
    if (want_ids) render->ids.simulator.core->newell(render->ids.simulator.lim, &options->newell);
    if (want_ids && moving->count && !ids_set_movers(&render->ids, moving, err)) return false;
    compile_report_tell(&render->scene.report, true);
    faithful_note(&render->scene);
    if (!options->compare) return true;
    if (measures_edges(render) && !edge_error_init(&render->edges, &render->scene, &options->setup, err)) return false;
    return take_groups(render, err) && read_reference(render, w_px, h_px, err);
}

/* Frames ------------------------------------------------------------------------------------- */

static bool write_frame(struct render *render, size_t frame, struct error *err)
{
    const struct film film = simulator_film(&render->simulator);
    return frame_file_write(&film, render->options.frame_pattern, frame, &render->outputs, err);
}

/* Firmware counts milliseconds. */
static double frame_time_s(const struct render *render, size_t frame)
{
    const struct viewpoint *viewpoint = &render->path.frames[frame];
    const double time_s = viewpoint->has_time ? viewpoint->time_s : (double)frame / render->frames_per_s;
    return round(1000.0 * time_s) / 1000.0;
}

static bool identify_frame(struct render *render, size_t frame, const struct lim_camera *camera, struct error *err)
{
    if (!ids_frame(&render->ids, camera, err)) return false;
    if (render->ids_file && !ids_write(&render->ids, render->ids_file))
        return error_set(err, "%s: cannot be written", render->options.ids_path);
    if (!render->options.compare) return true;
    moving_pose_reference(&render->moving, &render->reference, frame_time_s(render, frame));
    reference_draw(&render->reference, &render->path.frames[frame], &render->lens);
    render->rows[frame].compare =
        compare_picture(render->ids.faces, &render->reference, render->groups, 1.0 / render->scene.grid.units_per_m);
    return !measures_edges(render) || edge_error_frame(&render->edges, &render->reference, &render->path.frames[frame],
                                                       &render->lens, camera, &render->rows[frame].edges, err);
}

static bool render_frame(struct render *render, size_t frame, struct error *err)
{
    const size_t pixel_count = simulator_pixel_count(&render->simulator);
    struct lim_camera camera;
    moving_pose(&render->moving, frame_time_s(render, frame));
    const char *text = render->options.overlay_text;
    if (text) caption_set(&render->caption, text, frame, &render->simulator);
    if (!camera_path_to_camera(&render->path, frame, &render->lens, &render->scene.grid, &camera, err) ||
        !simulator_frame(&render->simulator, &camera, err))
        return false;
    struct frame_row *row = &render->rows[frame];
    row->stats = *simulator_stats(&render->simulator);
    row->pixels = pixel_count;
    row->bus_b = render->simulator.bus_b;
    render->hashes[frame] = hash_pixels(render->simulator.pixels, pixel_count);
    if (render->film_pixels)
        memcpy(render->film_pixels + frame * pixel_count, render->simulator.pixels,
               pixel_count * sizeof render->film_pixels[0]);
    if (render->options.frame_pattern && !write_frame(render, frame, err)) return false;
    bool want_ids = render->options.ids_path || render->options.compare;
    return !want_ids || identify_frame(render, frame, &camera, err);
}

/* The film, the sheet and the lists end there. */
static void keep_frames(struct render *render, size_t count)
{
    deadline_say("%zu of %zu frames", count, render->path.count);
    render->path.count = count;
}

static bool render_frames(struct render *render, struct error *err)
{
    bool ok = true;
    for (size_t frame = 0; ok && frame < render->path.count; frame++) {
        progress_bar(frame, render->path.count, "frame %zu of %zu", frame + 1, render->path.count);
        ok = render_frame(render, frame, err);
        if (ok && frame + 1 < render->path.count && deadline_passed()) keep_frames(render, frame + 1);
    }
    progress_end();
    return ok;
}

/* End ---------------------------------------------------------------------------------------- */

static bool write_sheet(struct render *render, const struct film *film, struct error *err)
{
    gdImagePtr sheet = image_contact_sheet(film);
    bool ok = image_write_png(sheet, render->sheet_file, render->options.sheet_path, err);
    if (sheet) gdImageDestroy(sheet);
    return ok;
}

static bool write_films(struct render *render, struct error *err)
{
    const struct options *options = &render->options;
    const struct film film = {options->setup.w_px, options->setup.h_px, render->path.count, render->film_pixels};
    if (render->gif_file && !image_write_gif(&film, render->frames_per_s, render->gif_file, options->gif_path, err))
        return false;
    if (render->sheet_file && !write_sheet(render, &film, err)) return false;
    if (render->hashes_file && !hashes_write(render->hashes, render->path.count, render->hashes_file))
        return error_set(err, "%s: cannot be written", options->hashes_path);
    return true;
}

static bool close_output(FILE **file, const char *path, struct error *err)
{
    FILE *closing = *file;
    *file = NULL;
    return !closing || outputs_close(closing, path, err);
}

static bool close_outputs(struct render *render, struct error *err)
{
    const struct options *options = &render->options;
    return close_output(&render->gif_file, options->gif_path, err) &&
           close_output(&render->sheet_file, options->sheet_path, err) &&
           close_output(&render->ids_file, options->ids_path, err) &&
           close_output(&render->hashes_file, options->hashes_path, err) &&
           close_output(&render->cameras_file, options->cameras_path, err) && outputs_keep(&render->outputs, err);
}

/* Whether --stats is asked for or not: the picture may be wrong. */
static void note_unsettled(const struct render *render)
{
    struct unsettled sum = {0};

    for (size_t i = 0; i < render->path.count; i++)
        unsettled_add(&sum, &render->rows[i].stats.newell);
    if (sum.entries) unsettled_print(&sum, "limner: note", stderr);
}

/* What frame_cost.h knows: opaque, flat, filled, aliased and still, in profile fast. */
static bool is_predictable(const struct render *render)
{
    const struct options *options = &render->options;
    return frame_cost_knows(options->setup.method) && options->setup.core == &core_fast && !options->wireframe.on &&
           !options->compile.antialias && !options->overlay_text && !render->moving.count &&
           frame_cost_is_known(&render->scene.scene) && !render->scene.scene.texture_count;
}

static void print_tables(const struct render *render)
{
    const struct frame_rows rows = {render->rows, render->path.count, render->options.brief};
    if (render->options.stats) {
        printf("%ux%u pixels, ", render->options.setup.w_px, render->options.setup.h_px);
        if (render->simulator.board)
            printf("through the emulated %s\n", render->simulator.board->name);
        else
            puts("into plain memory: no emulated panel, nothing sent on a bus");
        frame_table_print_stats(&rows, stdout);
        if (is_predictable(render)) frame_table_print_predicted(&rows, &render->simulator.target, stdout);
        if (render->options.setup.method == LIM_NEWELL) frame_table_print_newell(&rows, stdout);
    }
    if (render->options.stats && render->moving.count) frame_table_print_movers(&rows, stdout);
    if (render->options.stats && render->options.delta_runs) frame_table_print_delta(&rows, stdout);
    if (render->options.compare) frame_table_print_compare(&rows, stdout);
    if (render->options.compare && render->options.compile.antialias && render->moving.count)
        puts("edges: not compared where objects move");
    if (measures_edges(render)) frame_table_print_edges(&rows, stdout);
}

/* Checks come last: a frame that differs is worth looking at, so the files stay. */
static bool check(const struct render *render, struct error *err)
{
    if (render->options.check_path &&
        !hashes_check(render->hashes, render->path.count, render->options.check_path, err))
        return false;
    struct film last = simulator_film(&render->simulator);
    return dump_last_frame(&last, err);
}

static bool write_cameras(const struct render *render, struct error *err)
{
    const struct simulator_setup *setup = &render->options.setup;
    double *times_s = NULL;
    if (!render->cameras_file) return true;
    if (camera_path_has_times(&render->path)) times_s = grow_zeroed(render->path.count, sizeof *times_s);
    for (size_t frame = 0; times_s && frame < render->path.count; frame++)
        times_s[frame] = frame_time_s(render, frame);
    const bool ok = cameras_c_write(&render->path, times_s, &render->lens, &render->scene.grid, setup->w_px,
                                    setup->h_px, render->cameras_file, err);
    free(times_s);
    return ok;
}

static bool render_run(struct render *render, struct error *err)
{
    if (!open_outputs(render, err) ||
        !options_load(&render->options, &render->scene, &render->moving, &render->lens, &render->path, err) ||
        !outputs_check(&render->outputs, err) || !allocate(render, err) || !start(render, err) ||
        !render_frames(render, err) || !write_films(render, err) || !write_cameras(render, err) ||
        !close_outputs(render, err))
        return false;
    note_unsettled(render);
    print_tables(render);
    return check(render, err);
}

static void render_free(struct render *render)
{
    struct error ignored; /* the first one counts */
    close_output(&render->gif_file, "", &ignored);
    close_output(&render->sheet_file, "", &ignored);
    close_output(&render->ids_file, "", &ignored);
    close_output(&render->hashes_file, "", &ignored);
    close_output(&render->cameras_file, "", &ignored);
    outputs_discard(&render->outputs);
    simulator_free(&render->simulator);
    ids_free(&render->ids);
    edge_error_free(&render->edges);
    reference_free(&render->reference);
    free(render->groups);
    camera_path_free(&render->path);
    compiled_free(&render->scene);
    compile_options_free(&render->options.compile);
    moving_free(&render->moving);
    free(render->rows);
    free(render->hashes);
    free(render->film_pixels);
}

int cmd_render(int argc, char **argv)
{
    struct render render = {0};
    struct error err;
    bool ok = options_parse(argc, argv, OPTIONS_RENDER, &render.options, &err) && render_run(&render, &err);
    render_free(&render);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
