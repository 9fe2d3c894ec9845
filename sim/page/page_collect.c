/* SPDX-License-Identifier: MIT
 *
 * The scene is compiled as `limner compile` would, once for each precision; then by other methods and trees, and with
 * --worst, as far as that does not take long. The reference draws each view once for all of them. */
#include "page/page.h"

#include "base/deadline.h"
#include "base/front.h"
#include "base/progress.h"
#include "base/work_folder.h"
#include "cameras/random_path.h"
#include "cameras/sample.h"
#include "compiler/faithful.h"
#include "measure/difference.h"
#include "render/frame_cost.h"
#include "scene/mcu_mem.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MANY_POLYGONS = 2500, WORST_TRIES_OF_MANY = 300, PORTRAITS = 8 };
static const double ROWS_SHARE = 0.4; /* of the time, for other methods */

/* Rows --------------------------------------------------------------------------------------- */

static struct page_row *add_row(struct page *page, const struct core *core, const struct compiled *scene,
                                const char *label)
{
    struct page_row *row = &page->rows[page->row_count++];
    *row = (struct page_row){.core = core, .scene = *scene};
    row->scene.report.core = core;
    snprintf(row->label, sizeof row->label, "%s", label);
    const bool is_fast = core == &core_fast;
    row->instructions = is_fast && !page->request.compile.antialias ? scene->report.instructions : NAN;
    return row;
}

/* Refused ones are told; the one that the page is about must be there. */
static bool add_precisions(struct page *page, struct error *err)
{
    const struct measure_request *request = &page->request;
    for (size_t i = 0; cores[i]; i++) {
        const struct compiled *scene;
        const bool is_this = cores[i] == request->cores[0];
        if (measure_scene_for(&page->scenes, &page->source, cores[i], &request->compile, &scene, err)) {
            struct page_row *row = add_row(page, cores[i], scene, cores[i]->name);
            snprintf(row->option, sizeof row->option, "--precision %s", cores[i]->name);
            row->is_this = is_this;
            if (is_this) page->this_row = page->row_count - 1;
        } else if (is_this || deadline_passed()) {
            return error_prefix(err, request->model);
        } else {
            measure_refusals_add(&page->refused, cores[i], err);
        }
    }
    page->scene = page->rows[page->this_row].scene;
    return true;
}

static bool is_known_already(const struct page *page, const struct compiled *scene)
{
    for (size_t i = 0; i < page->row_count; i++) {
        const struct page_row *row = &page->rows[i];
        if (row->core == page->request.cores[0] && row->scene.report.draws == scene->report.draws &&
            row->scene.image_b == scene->image_b && memcmp(row->scene.image, scene->image, scene->image_b) == 0)
            return true;
    }
    return false;
}

/* What cannot draw the scene is no row. */
static void add_compiled(struct page *page, const struct compile_options *options, const char *label,
                         const char *option)
{
    struct compiled scene = {0};
    struct error ignored;
    progress("compiling for %s", label);
    if (page->row_count == PAGE_ROWS_MAX || deadline_passed() ||
        !measure_source_compile(&page->source, options, &scene, &ignored))
        return;
    if (is_known_already(page, &scene)) {
        compiled_free(&scene);
        return;
    }
    struct page_row *row = add_row(page, page->request.cores[0], &scene, label);
    row->own = scene;
    row->has_worst = options->worst_tries > 0;
    snprintf(row->option, sizeof row->option, "%s", option);
}

/* In the precision that the page is about; by what is left where nothing else was asked for. */
static void add_methods(struct page *page)
{
    static const struct {
        const char *name, *label;
    } others[] = {{"bsp", "nearest first, BSP tree"},   {"clusters", "nearest first, clusters"},
                  {"axis", "nearest first, axis cuts"}, {"scanline", "scan lines"},
                  {"mesh", "a mesh, by distance"},      {"mesh-depth", "a mesh, by depth"}};
    const struct measure_request *request = &page->request;
    const struct deadline_end whole = deadline_share(ROWS_SHARE);
    const bool is_open = !request->compile.method && request->compile.tree == TREE_AUTO && !page->scene.moving;
    if (is_open && page->source.mesh.polygon_count > MANY_POLYGONS)
        snprintf(page->too_long, sizeof page->too_long, "Other methods were not tried on more than %d polygons.",
                 MANY_POLYGONS);
    for (size_t i = 0; is_open && !*page->too_long && i < sizeof others / sizeof *others; i++) {
        struct compile_options options = request->compile;
        struct error ignored;
        char option[PAGE_LABEL_B];
        snprintf(option, sizeof option, "--method %s", others[i].name);
        if (compile_method_parse(others[i].name, &options, &ignored) && compile_options_settle(&options, &ignored))
            add_compiled(page, &options, others[i].label, option);
    }
    deadline_restore(whole);
}

/* The same tree, without looking for it once more. */
static void add_worst(struct page *page)
{
    struct compile_options options = page->request.compile;
    const enum lim_method draws = page->scene.report.draws;
    if (options.worst_tries || (draws != LIM_NEAREST_FIRST && draws != LIM_SCANLINE)) return;
    if (!options.method) options.tree = page->scene.report.tree;
    options.splitter = page->scene.report.splitter;
    options.worst_tries = page->source.mesh.polygon_count > MANY_POLYGONS ? WORST_TRIES_OF_MANY : WORST_TRIES;
    add_compiled(page, &options, "with pools for the worst views", "--worst");
}

/* Views -------------------------------------------------------------------------------------- */

/* Whether eyes can be all around it. */
static bool is_seen_from_outside(const struct compiled *scene)
{
    struct sampler sampler;
    sampler_init(&sampler, scene);
    for (int i = 0; i < PORTRAITS; i++) {
        struct viewpoint viewpoint;
        if (!sampler_portrait(&sampler, &viewpoint)) return false;
    }
    return true;
}

/* An orbit, where that sees the scene; else, and as many again, at random. */
static bool plan_views(struct page *page, struct error *err)
{
    const struct measure_request *request = &page->request;
    const bool is_outside = is_seen_from_outside(&page->scene);
    struct camera_path orbit = {0};
    if (!random_path(&page->scene, "random cameras", 1, PAGE_VIEWS, &page->path, err)) return false;
    page->path_words = is_outside ? "24 views: an orbit of 12, and 12 random cameras (random:1)"
                                  : "24 random cameras in free space (random:1)";
    if (!is_outside) return true;
    if (!camera_path_orbit(&page->scene, &page->lens, PAGE_SHOWN, &orbit, err)) return false;
    memcpy(page->path.frames, orbit.frames, PAGE_SHOWN * sizeof *orbit.frames);
    camera_path_free(&orbit);
    if (request->compile.near_m <= 0.0) lens_note_near(request->model, &page->scene.grid);
    return true;
}

static bool choose_views(struct page *page, struct error *err)
{
    struct measure_request few = page->request;
    if (!few.cameras.text) return plan_views(page, err);
    few.frames = PAGE_VIEWS;
    page->path_words = few.cameras.text;
    return measure_request_cameras(&few, &page->scene, &page->lens, &page->path, err);
}

/* A wrong pixel is hard to see in a small picture: it becomes a square. */
static void enlarge_wrong(gdImagePtr image)
{
    const int reach_px = 1 + gdImageSX(image) / 160;
    gdImagePtr whole = gdImageClone(image);
    for (int y = 0; whole && y < gdImageSY(whole); y++) {
        for (int x = 0; x < gdImageSX(whole); x++) {
            const int colour = gdImageGetTrueColorPixel(whole, x, y);
            if (gdTrueColorGetRed(colour) == gdTrueColorGetBlue(colour)) continue;
            gdImageFilledRectangle(image, x - reach_px, y - reach_px, x + reach_px, y + reach_px, colour);
        }
    }
    if (whole) gdImageDestroy(whole);
}

static bool draw_view(struct page *page, const struct measure_views *views, size_t frame, struct page_view *out,
                      struct error *err)
{
    const struct measure_candidate candidate = {page->request.cores[0], &page->scene};
    out->picture = frame_picture(&candidate, views, frame, &out->stats, err);
    if (out->picture) out->difference = difference_picture(&page->source, &candidate, views, frame, &out->wrong, err);
    if (out->difference) enlarge_wrong(out->difference);
    return out->picture && out->difference;
}

static void forget_pictures(struct page_view *view)
{
    if (view->picture) gdImageDestroy(view->picture);
    if (view->difference) gdImageDestroy(view->difference);
    view->picture = view->difference = NULL;
}

/* All are counted, the first ones or evenly chosen ones shown. */
static bool draw_views(struct page *page, struct error *err)
{
    const struct measure_views views = {&page->path, &page->lens, page->request.w_px, page->request.h_px, NULL};
    const size_t count = page->path.count;
    for (size_t i = 0; i < count && !(i && deadline_passed()); i++, page->view_count++) {
        progress_bar(i, count, "view %zu of %zu", i + 1, count);
        if (!draw_view(page, &views, i, &page->views[i], err)) return false;
        if (i < PAGE_SHOWN)
            page->shown_count++;
        else
            forget_pictures(&page->views[i]);
    }
    if (page->view_count < count) deadline_say("%zu of %zu views", page->view_count, count);
    return true;
}

/* Figures ------------------------------------------------------------------------------------ */

static bool measure_rows(struct page *page, const struct measure_views *views, struct error *err)
{
    struct measure_candidate candidates[PAGE_ROWS_MAX];
    struct accuracy accuracies[PAGE_ROWS_MAX];
    for (size_t i = 0; i < page->row_count; i++)
        candidates[i] = (struct measure_candidate){page->rows[i].core, &page->rows[i].scene};
    if (!measure_accuracy(&page->source, views, candidates, page->row_count, accuracies, err)) return false;
    for (size_t i = 0; i < page->row_count; i++)
        page->rows[i].accuracy = accuracies[i];
    return true;
}

/* Rows that there is no time for have no instructions. */
static bool count_rows(struct page *page, const struct measure_views *views, struct error *err)
{
    const struct measure_request *request = &page->request;
    struct work_folder folder = {0};
    bool ok = !request->cpu_count || work_folder_make(&folder, err);
    for (size_t i = 0; ok && i < page->row_count * request->cpu_count; i++) {
        struct page_row *row = &page->rows[i / request->cpu_count];
        const size_t cpu = i % request->cpu_count;
        const struct measure_candidate candidate = {row->core, &row->scene};
        progress_bar(i, page->row_count * request->cpu_count, "instructions of %s", row->label);
        if (cpu == 0) row->instructions = NAN;
        if (deadline_passed()) continue;
        ok = measure_cost(&candidate, request->cpus[cpu], views, folder.path, &row->costs[cpu], err);
        if (ok && cpu == 0) row->instructions = row->costs[cpu].mean;
    }
    if (request->cpu_count) deadline_say("instructions of some rows");
    work_folder_remove(&folder);
    return ok;
}

/* By wrong pixels and instructions, or RAM where these are not known of all. */
static void find_front(struct page *page)
{
    struct front_choice choices[PAGE_ROWS_MAX];
    size_t dominators[PAGE_ROWS_MAX];
    for (size_t i = 0; i < page->row_count; i++) {
        const struct page_row *row = &page->rows[i];
        const double ram_b = (double)page_ram_b(page, &row->scene);
        choices[i] = (struct front_choice){compare_wrong_percent(&row->accuracy.pixels.total),
                                           page->request.cpu_count ? row->instructions : ram_b};
    }
    front_find(choices, page->row_count, dominators);
    for (size_t i = 0; i < page->row_count; i++)
        page->rows[i].is_on_front = dominators[i] == FRONT_NONE;
}

static bool search_worst(struct page *page, struct error *err)
{
    const struct measure_request *request = &page->request;
    const struct measure_candidate candidate = {request->cores[0], &page->scene};
    const struct measure_views lens = {NULL, &page->lens, request->w_px, request->h_px, NULL};
    if (!worst_views_find(&page->source, &candidate, &lens, &request->worst, &page->worst, err))
        return error_prefix(err, request->model);
    struct viewpoint found[2] = {page->worst.cost.goals[0].worst, page->worst.error.goals[0].worst};
    const struct camera_path path = {"searched cameras", found, 2};
    const struct measure_views views = {&path, &page->lens, request->w_px, request->h_px, NULL};
    return draw_view(page, &views, 0, &page->worst_cost, err) && draw_view(page, &views, 1, &page->worst_error, err);
}

bool page_collect(struct page *page, struct error *err)
{
    struct measure_request *request = &page->request;
    const struct measure_views views = {&page->path, &page->lens, request->w_px, request->h_px, NULL};
    if (!measure_request_check(request, err) ||
        !measure_request_load(request, &page->source, &page->lens, &page->path, err) || !add_precisions(page, err))
        return false;
    faithful_note(&page->scene);
    if (!choose_views(page, err)) return false;
    add_methods(page);
    add_worst(page);
    const bool ok = draw_views(page, err) && measure_rows(page, &views, err) && search_worst(page, err) &&
                    count_rows(page, &views, err);
    progress_end();
    if (ok) find_front(page);
    return ok;
}

size_t page_pixels_b(const struct page *page, const struct compiled *scene)
{
    const bool all = scene->report.framebuffer || scene->report.draws == LIM_PAINTER;
    return (size_t)(page->request.w_px + 1) / 2 * 4 * (all ? page->request.h_px : 1);
}

size_t page_ram_b(const struct page *page, const struct compiled *scene)
{
    const size_t movers_b = scene->moving ? mcu_movers_mem_b(scene, scene->moving) : 0;
    return mcu_mem_b(scene) + movers_b + page_pixels_b(page, scene);
}

bool page_is_predicted(const struct page *page)
{
    return page->worst.is_predicted;
}

void page_free(struct page *page)
{
    for (size_t i = 0; i < PAGE_VIEWS; i++)
        forget_pictures(&page->views[i]);
    forget_pictures(&page->worst_cost);
    forget_pictures(&page->worst_error);
    for (size_t i = 0; i < page->row_count; i++)
        compiled_free(&page->rows[i].own);
    measure_scenes_free(&page->scenes);
    measure_source_free(&page->source);
    camera_path_free(&page->path);
    compile_options_free(&page->request.compile);
}
