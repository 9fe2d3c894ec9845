/* SPDX-License-Identifier: MIT
 *
 * Exact points, coplanar groups, a tree for each heuristic wanted, the best of them kept. */
#include "compiler/compile_mesh.h"

#include "base/deadline.h"
#include "base/progress.h"
#include "compiler/encode.h"
#include "compiler/encode_mesh.h"
#include "compiler/mesh_order.h"
#include "compiler/order_choice.h"
#include "compiler/pool_sizes.h"
#include "compiler/portal_choice.h"
#include "core/core.h"
#include "scene/convexity.h"
#include "scene/lim_image.h"
#include "scene/width.h"
#include "trees/bsp_build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double FRACTION_UNITS = 1.0 / 256.0;
static const double GRID_END = 32767.5; /* halves round up: 32767.5 would be 32768 */
static const double LONG_GRID_END = LIM_LONG_END - 1;

/* Texture arrays and, in struct lim_scene, four pointers and counts; scenes without textures have neither. */
static size_t texture_flash_b(const struct lim_scene *scene, bool wide)
{
    enum { FIELDS_B = 4 * 4 + 4 * 2 };
    if (!scene->texture_count) return 0;
    return FIELDS_B + (*scene->uvs ? scene->vertex_count * sizeof **scene->uvs + 4 : 0) +
           scene->mapping_count * width_mapping_b(scene, wide) + scene->texture_count * sizeof *scene->textures +
           scene->palette_colours * sizeof *scene->palettes + scene->texel_blocks * (size_t)LIM_TEXEL_BLOCK;
}

/* Bytes of a scene's arrays and its struct lim_scene, as a 32-bit microcontroller holds them. */
static size_t flash_b(const struct lim_scene *scene)
{
    enum { POINTERS = 7, POINTER_B = 4, COUNTS = 7, LIMITS = 9, FIXED_B = POINTERS * POINTER_B + LIMITS * 2 };
    const bool wide = width_is_wide(scene);
    return FIXED_B + COUNTS * width_word_b(wide) + scene->vertex_count * width_vertex_b(scene) +
           scene->node_count * width_node_b(wide) + scene->plane_count * width_plane_b(scene, wide) +
           scene->exact_count * sizeof *scene->exact + scene->box_count * width_box_b(scene) +
           scene->polygon_words * width_word_b(wide) +
           (scene->fractions ? scene->vertex_count * sizeof *scene->fractions : 0) + texture_flash_b(scene, wide);
}

/* The smaller the better: bytes of flash, with splits and depth as bytes on top. A split costs
 * instructions in every frame that shows it; a level of depth costs 4 bytes of stack. */
static size_t badness(const struct compile_report *report)
{
    enum { SPLIT_B = 40, LEVEL_B = 4 };
    return report->flash_b + report->splits * SPLIT_B + report->depth * LEVEL_B;
}

/* Black and white displays have the smallest of microcontrollers: there a convex solid is drawn without a line of
 * memory. Elsewhere its own method is no cheaper than others. */
static enum lim_method draws_with(const struct compile_options *options, bool convex)
{
    const enum lim_method draws = compile_options_draws(options);
    const bool saves_lines =
        convex && options->mono && !options->method && !options->antialias && !options->framebuffer;
    return saves_lines && draws == LIM_NEAREST_FIRST ? LIM_CONVEX : draws;
}

/* What any scene has. */
static void report_set(struct compile_report *report, const struct mesh *mesh, const struct encoding *encoding,
                       const struct lim_scene *scene, enum tree_kind tree)
{
    *report = (struct compile_report){.mesh = mesh->counts,
                                      .polygons_in = mesh->polygon_count,
                                      .polygons_out = encoding->record_count,
                                      .collapsed = encoding->collapsed,
                                      .depth = encoding->depth,
                                      .convex = scene_is_convex(scene),
                                      .tree = tree,
                                      .wrong = {.percent = NAN},
                                      .instructions = NAN,
                                      .flash_b = flash_b(scene)};
}

static void report_tree(struct compile_report *report, const struct bsp *bsp, const struct lim_scene *scene,
                        const struct splitter *splitter)
{
    report->splits = bsp->splits;
    const struct layers *layers = &bsp->coplanar->layers;
    if (report->tree == TREE_NONE)
        report->unordered = layers_polygons(layers, report->polygons_in);
    else
        report->covered = layers->covered;
    report->worst_violation_units = bsp_worst_violation(bsp);
    for (size_t i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].split.plane != LIM_NO_INDEX)
            report->kinds[plane_kind_of(scene, &scene->nodes[i].split)]++;
        else if (lim_is_mesh_leaf(&scene->polygons[scene->nodes[i].front_run]))
            report->mesh_leaves++;
        else
            report->leaves++;
    snprintf(report->splitter, sizeof report->splitter, "%s", splitter->name);
}

/* Profile exact draws vertices with fractions; for the others they would only take flash. */
static bool is_exact(const struct compile_options *options)
{
    return options->core && options->core->profile == LIM_PROFILE_EXACT;
}

static bool has_fractions(const struct compilation *work)
{
    return is_exact(work->options) || work->mesh->grid.has_fractions;
}

/* Where a unit is too much to tell the smallest faces apart, half of one is too much to be off a plane. */
static double tolerance_units(const struct compilation *work)
{
    return work->options->tolerance_units * (work->mesh->grid.has_fractions ? FRACTION_UNITS : 1.0);
}

/* A convex solid is drawn as a whole: bounds of its parts would only take flash. Those of all of it,
 * the root's, tell the camera how far the scene reaches. */
static void image_make(struct encoding *encoding, const struct grid *grid, struct compiled *out)
{
    lim_image_make(encoding, grid, out);
    if (encoding->box_count < 2 || !scene_is_convex(&out->scene)) return;
    for (size_t i = 1; i < encoding->node_count; i++)
        encoding->nodes[i].box = LIM_NO_INDEX;
    encoding->box_count = 1;
    free(out->image);
    lim_image_make(encoding, grid, out);
}

/* Which dense parts it has as leaves. */
static void report_parts(struct leaf_report *report, const struct parts *parts)
{
    *report = (struct leaf_report){.instructions = NAN, .without_instructions = NAN, .wrong_percent = NAN};
    for (size_t i = 0; i < parts->count; i++) {
        if (!parts->items[i].polygons) continue;
        if (report->count < LEAF_PARTS_TOLD)
            report->parts[report->count] = (struct leaf_part){parts->items[i].face, parts->items[i].polygons};
        report->count++;
        report->polygons += parts->items[i].polygons;
    }
}

/* One heuristic, from the list of polygons to the scene. */
static bool compile_with(struct compilation *work, enum tree_kind kind, const struct splitter *splitter,
                         struct compiled *out, struct error *err)
{
    const bool is_divided = kind != TREE_NONE;
    const struct tree_plan plan = {kind, splitter, tolerance_units(work),
                                   is_divided && work->parts.count ? &work->parts : NULL};
    struct bsp bsp;
    struct encoding encoding = {0};
    bool ok = bsp_build(&bsp, work->mesh, &work->coplanar, &plan, &work->points);
    if (!ok && deadline_check(err, "no tree of the %zu polygons", work->mesh->polygon_count))
        error_set(err, "scene too large: split into more than %d pieces", BSP_PIECES_MAX);
    ok = ok && encode_bsp(&bsp, has_fractions(work), work->options->wireframe, &encoding, err);
    if (ok) {
        if (kind == TREE_NONE) encoding.depth = 0; /* for methods that sort */
        encoding.background = work->options->background;
        image_make(&encoding, &work->mesh->grid, out);
        report_set(&out->report, work->mesh, &encoding, &out->scene, kind);
        report_tree(&out->report, &bsp, &out->scene, splitter);
        report_parts(&out->report.leaf_parts, &work->parts);
        out->report.draws = draws_with(work->options, out->report.convex);
    }
    encoding_free(&encoding);
    bsp_free(&bsp);
    exact_truncate(&work->points, work->mesh->point_count);
    return ok;
}

/* What a mesh is chosen for is judged by its pictures; of one that was asked for is said what it does not order. */
static size_t count_unordered(const struct compilation *work)
{
    struct layers layers;
    if (!work->options->method || !work->options->choose_order) return 0; /* or it is a trial */
    layers_find(work->mesh, tolerance_units(work), &layers);
    const size_t count = layers_polygons(&layers, work->mesh->polygon_count);
    layers_free(&layers);
    return count;
}

/* Without a tree. */
static bool compile_triangles(struct compilation *work, struct compiled *out, struct error *err)
{
    struct encoding encoding = {0};
    progress("compiling: %zu polygons as a mesh", work->mesh->polygon_count);
    bool ok = encode_mesh(work->mesh, &work->points, is_exact(work->options), &encoding, err);
    if (ok) {
        encoding.background = work->options->background;
        lim_image_make(&encoding, &work->mesh->grid, out);
        report_set(&out->report, work->mesh, &encoding, &out->scene, TREE_MESH);
        out->report.draws = compile_options_draws(work->options);
        out->report.unordered = count_unordered(work);
        out->original = work->mesh->original; /* lent: its faces are looked at */
        if (out->report.draws == LIM_MESH_DEPTH)
            ok = mesh_order_settle(out, work->options->core,
                                   mesh_order_share(work->options->core, work->options->wrong_percent), err);
        out->original = NULL;
        out->report.near_deep = out->scene.polygon_count - *out->scene.near_deep_from;
        out->report.deep = out->scene.polygon_count - *out->scene.deep_from;
    }
    encoding_free(&encoding);
    return ok;
}

bool compilation_splits_much(const struct compile_report *report)
{
    enum { MUCH = 4 }; /* a quarter of the polygons */
    return MUCH * report->splits >= report->polygons_in;
}

/* The heuristics under way, and the best tree so far. */
struct contest {
    struct compilation *work;
    enum tree_kind kind;
    struct compiled *best;
    const struct splitter *winner; /* NULL: none so far */
    size_t tried;
    bool dense; /* the first tree of several polygons splits much */
};

/* A set has no planes to choose. Of many polygons not every tree is built that might be the smallest, and where the
 * first one splits much, only those of heuristics that are good at that. */
static bool is_wanted(const struct contest *contest, const struct splitter *splitter)
{
    const struct compile_options *options = contest->work->options;
    const size_t polygons = contest->work->mesh->polygon_count;
    if (contest->kind == TREE_NONE) return splitter == &splitters[1];
    if (!splitter_answers(splitter, options->splitter)) return false;
    if (strcmp(options->splitter, "auto") != 0) return true;
    return (polygons <= SPLITTER_MANY || splitter->for_many) && (!contest->dense || splitter->for_dense);
}

/* The first tree may take all of the time, the others half of what it leaves. */
static const double OTHERS_SHARE = 0.5;
static const double MEASURED_SHARE = 0.5;

/* Of equals the first in the list of heuristics, whenever it was tried. */
static bool beats(const struct contest *contest, const struct compiled *candidate, const struct splitter *splitter)
{
    if (!contest->winner) return true;
    const size_t bad = badness(&candidate->report), best = badness(&contest->best->report);
    return bad < best || (bad == best && splitter < contest->winner);
}

static void try_splitter(struct contest *contest, const struct splitter *splitter, struct error *err)
{
    struct compiled candidate = {0};
    if (contest->winner && deadline_passed()) return;
    progress("compiling: %zu polygons, %s, %s", contest->work->mesh->polygon_count, tree_names[contest->kind],
             splitter->name);
    if (!compile_with(contest->work, contest->kind, splitter, &candidate, err)) return;
    if (beats(contest, &candidate, splitter)) {
        const struct compiled worse = *contest->best;
        *contest->best = candidate;
        candidate = worse;
        contest->winner = splitter;
    }
    compiled_free(&candidate);
    if (contest->tried++) return;
    deadline_share(OTHERS_SHARE);
    contest->dense =
        contest->best->report.polygons_in > SPLITTER_SEVERAL && compilation_splits_much(&contest->best->report);
}

/* Keeps the best of all; an error is the last one, and counts only if none succeeds. */
static bool compile_best(struct compilation *work, enum tree_kind kind, struct compiled *out, struct error *err)
{
    struct contest contest = {.work = work, .kind = kind, .best = out};
    if (!splitter_check(work->options->splitter, err)) return false;
    const struct deadline_end whole = deadline_end();
    if (is_wanted(&contest, splitter_scout)) try_splitter(&contest, splitter_scout, err);
    for (size_t i = 0; i < splitter_count; i++)
        if (&splitters[i] != splitter_scout && is_wanted(&contest, &splitters[i]))
            try_splitter(&contest, &splitters[i], err);
    if (contest.winner) deadline_say("the best of %zu trees", contest.tried);
    deadline_restore(whole);
    return contest.winner;
}

/* Corners only: points that no polygon uses may lie anywhere. */
static bool check_grid(const struct compilation *work, struct error *err)
{
    const bool is_long = work->mesh->grid.is_long;
    const double end = is_long ? LONG_GRID_END : GRID_END;
    for (size_t i = 0; i < work->mesh->corner_count; i++)
        for (int k = 0; k < 3; k++)
            if (!(fabs(work->points.approx[work->mesh->corners[i]][k]) < end))
                return error_set(err, "vertex %lu lies beyond the %d-bit grid",
                                 (unsigned long)work->mesh->corners[i] + 1, is_long ? 32 : 16);
    return work->mesh->polygon_count > 0 || error_set(err, "no polygons");
}

/* Splits only add to the polygons: what is too much before is not worth a tree. */
static bool check_size(const struct compilation *work, struct error *err)
{
    return work->mesh->polygon_count <= BSP_PIECES_MAX ||
           error_set(err, "scene too large: %zu polygons, %d are the most", work->mesh->polygon_count, BSP_PIECES_MAX);
}

static unsigned side_or_default(unsigned side_px)
{
    return side_px ? side_px : 240;
}

static bool check_method(const struct compile_options *options, const struct compiled *scene, struct error *err)
{
    if (options->antialias && !method_antialiases(scene->report.draws, options->wireframe, err)) return false;
    if (options->wireframe && !method_draws_wireframe(scene->report.draws, err)) return false;
    if (options->framebuffer && !order_can_fill(options, scene, err)) return false;
    if (!method_scans(scene->report.draws, order_needs_nearest(options, &scene->scene), err)) return false;
    if (method_sorts(scene->report.draws) && scene->scene.polygon_count > LIM_SORTED_MAX)
        return error_set(err, "scene too large to be sorted: %lu pieces of polygons, %u are the most",
                         (unsigned long)scene->scene.polygon_count, LIM_SORTED_MAX);
    return scene->report.draws != LIM_CONVEX || scene->report.convex ||
           error_set(err, "--method %s: the scene is not one convex solid", options->method->name);
}

/* What is measured on sampled cameras leaves half of the time to whoever asked for the scene. */
static bool compile_measured(struct compiled *out, const struct compile_options *options, struct error *err)
{
    const struct deadline_end whole = deadline_share(MEASURED_SHARE);
    const bool ok =
        pools_measure(out, options->core, side_or_default(options->w_px), side_or_default(options->h_px), err) &&
        order_choose(out, options, err);
    deadline_restore(whole);
    return ok;
}

bool compilation_begin(struct compilation *work, const struct mesh *mesh, const struct compile_options *options,
                       struct error *err)
{
    *work = (struct compilation){.mesh = mesh, .options = options};
    for (size_t i = 0; i < mesh->point_count; i++)
        exact_add_m(&work->points, mesh->points[i], &mesh->grid);
    if (!check_grid(work, err) || !check_size(work, err)) return false;
    if (options->tree == TREE_MESH) return true; /* nothing is divided */
    coplanar_find(mesh, work->points.approx, tolerance_units(work), &work->coplanar);
    if (options->mesh_leaves == MESH_LEAVES_ALL && compile_options_may_leaf(options)) {
        parts_find(mesh, work->points.approx, &work->parts);
        if (options->whole_leaf) parts_unite(&work->parts, mesh);
    }
    return deadline_check(err, "planes of %zu polygons were still sought", mesh->polygon_count);
}

bool compilation_tree(struct compilation *work, enum tree_kind kind, struct compiled *out, struct error *err)
{
    const struct compile_options *options = work->options;
    *out = (struct compiled){0};
    if (work->mesh->grid.is_long && (kind == TREE_MESH || kind == TREE_NONE))
        return error_set(err, "coordinates of 32 bits are drawn by methods that walk a tree alone");
    bool ok = kind == TREE_MESH ? compile_triangles(work, out, err)
                                : compile_best(work, kind == TREE_AUTO ? TREE_BSP : kind, out, err);
    ok = ok && check_method(options, out, err);
    out->report.is_interior = work->mesh->is_interior;
    out->report.mono = options->mono && !options->unlit;
    out->report.wireframe = options->wireframe;
    out->report.antialias = options->antialias;
    out->report.overlay = options->overlay;
    out->report.tele =
        lens_fov_is_long(options->fov_deg, side_or_default(options->w_px), side_or_default(options->h_px));
    out->report.round = options->round;
    out->report.fill = options->fill;
    out->report.framebuffer = options->framebuffer;
    out->report.delta_runs = options->delta;
    out->report.path = (struct path_report){options->path.name, options->path.frames, options->path.count};
    out->report.worst.tries = options->worst_tries;
    ok = ok && compile_measured(out, options, err);
    progress_end();
    if (!ok) compiled_free(out);
    return ok;
}

bool compilation_portals(const struct compilation *work, struct compiled *out, struct error *err)
{
    const struct deadline_end whole = deadline_share(MEASURED_SHARE);
    const bool ok = portals_add(out, work->options, err);
    deadline_restore(whole);
    progress_end();
    if (!ok) compiled_free(out);
    return ok;
}

void compilation_end(struct compilation *work)
{
    coplanar_free(&work->coplanar);
    parts_free(&work->parts);
    exact_free(&work->points);
}

bool compile_mesh(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                  struct error *err)
{
    struct compilation work;
    *out = (struct compiled){0};
    const bool ok = compilation_begin(&work, mesh, options, err) && compilation_tree(&work, options->tree, out, err) &&
                    compilation_portals(&work, out, err);
    compilation_end(&work);
    return ok;
}
