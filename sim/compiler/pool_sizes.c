/* SPDX-License-Identifier: MIT
 *
 * Frames from sampled cameras, or from the program's own, with pools that cannot run out; what they used, and some
 * more. Who needs even more falls back to bands, or projects a solid's faces again. The greediest is left out: in an
 * open scene it may be a stray, an eye where nobody is meant to be. What stands alone takes most of the pools when it
 * just fills the screen, which few eyes anywhere around it see: so there are portraits as well. */
#include "compiler/pool_sizes.h"

#include "base/deadline.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "limner.h"
#include "render/counted_memory.h"
#include "render/frame_cost.h"
#include "render/pool_search.h"
#include "render/simulator.h"
#include "scene/lim_image.h"
#include "scene/mcu_sizes.h"
#include "scene/moving.h"
#include "scene/needs.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>

enum { SAMPLED = 256, PORTRAITS = 64, CAMERAS = SAMPLED + PORTRAITS };
/* A depth sort that splits so much is asked for by fewer cameras: FEW of either kind. */
enum { ENOUGH_SPLITS = 20000, FEW = 4 };
enum { STRAYS = 1, LEAST_PIECES = 8, PLENTY_OF_PIECES = 30000, PLENTY = 60000 };
enum { CAMERAS_AT_LEAST = STRAYS + 2 }; /* whatever time it takes */
/* What is active is retained, and takes more cells than its head's. */
enum { MOST_RETAINED = PLENTY / MCU_HEAD_CELLS };

/* Memory that polygons, gaps and what crosses a line share is made larger than the greediest camera but strays wants,
 * by as much as it wants more than the greediest FEW_GREEDY-th part of them, and a 32nd at least: where few cameras are
 * far beyond the others, more may be. Where objects move it is 3/8 at least: few of their poses are seen. A frame that
 * wants more loses its lowest lines to a second walk. */
enum { SHARED_UNIT_B = 4, SHARED_MARGIN = 32, FEW_GREEDY = 50 };

/* What each camera used of each pool. */
struct usage {
    size_t cameras, strays; /* of the greediest, as many are left out */
    uint16_t cells[CAMERAS], gaps[CAMERAS], active[CAMERAS], layers[CAMERAS], runs[CAMERAS], leaf_polygons[CAMERAS];
    uint16_t shared[CAMERAS];           /* of the memory that the first three share, in SHARED_UNIT_B */
    struct counted_memory memory;       /* what it is counted by */
    bool closes_none;                   /* by scan lines, not antialiased: no gaps but one */
    double instructions;                /* predicted, of all frames */
    double instructions_most;           /* beyond that no more frames are drawn; 0: whatever it takes */
    uint64_t reached, seen;             /* polygons that face the eye, and those of which something shows */
    uint32_t splits;                    /* of all frames */
    uint32_t splits_max;                /* strays included: without room for a piece the picture may be wrong */
    struct pool_search_result searched; /* what options.worst asks for; else nothing was tried */
};

enum { LEAST_LEAF = 32 }; /* polygons of a mesh leaf: with fewer it is looked through again and again */

static uint16_t with_margin(uint16_t used, uint16_t least)
{
    const unsigned wanted = used + used / 8u + 1;
    return (uint16_t)(wanted < least ? least : wanted > UINT16_MAX ? UINT16_MAX : wanted);
}

static uint16_t with_margin_of_one(double used)
{
    return (uint16_t)(used + 1.0 < UINT16_MAX ? used + 1.0 : UINT16_MAX);
}

static uint16_t within(uint32_t count)
{
    return (uint16_t)(count < UINT16_MAX ? count : UINT16_MAX);
}

static int compare_u16(const void *a, const void *b)
{
    return *(const uint16_t *)a - *(const uint16_t *)b;
}

static uint16_t most(const struct usage *usage, uint16_t *used)
{
    if (usage->cameras <= usage->strays) return 0;
    qsort(used, usage->cameras, sizeof *used, compare_u16);
    return used[usage->cameras - 1 - usage->strays];
}

static void note(struct usage *usage, const struct simulator *simulator)
{
    const struct lim_stats *stats = simulator_stats(simulator);
    const size_t i = usage->cameras++;
    usage->cells[i] = stats->retained_cells_max;
    usage->gaps[i] = stats->gaps_max;
    usage->active[i] = stats->active_max;
    usage->shared[i] = within(pool_search_shared_b(simulator, &usage->memory) / SHARED_UNIT_B + 1);
    usage->runs[i] = stats->delta.runs_max;
    usage->instructions += frame_cost_of_scene_m0plus(stats, &simulator->target, simulator->scene);
    usage->reached += stats->polygons;
    usage->seen += stats->polygons_seen;
    usage->splits += stats->newell.splits;
    if (stats->newell.splits > usage->splits_max) usage->splits_max = stats->newell.splits;
    usage->layers[i] = stats->layers_max;
    usage->leaf_polygons[i] = within(stats->leaf_polygons_max);
}

static bool is_too_much(const struct usage *usage)
{
    return usage->instructions_most > 0.0 && usage->instructions > usage->instructions_most;
}

/* The camera to go on with: this one, or the first portrait, or none. */
static int after_enough(const struct usage *usage, int i)
{
    if (usage->splits < ENOUGH_SPLITS) return i;
    if (i < SAMPLED) return i < FEW ? i : SAMPLED;
    return i < SAMPLED + FEW ? i : CAMERAS;
}

static int camera_count(const struct compiled *scene)
{
    const size_t count = scene->report.path.count;
    return !count ? CAMERAS : count < CAMERAS ? (int)count : CAMERAS;
}

/* The i-th of so many frames of a path, as evenly as can be. */
static const struct viewpoint *frame_of_path(const struct compiled *scene, int i)
{
    const struct path_report *path = &scene->report.path;
    return &path->frames[(size_t)i * path->count / (size_t)camera_count(scene)];
}

/* The i-th sampled camera; false: there is none. Out-of-range ones (a scene of thousands of kilometres) are passed
 * over.
 */
static bool sampled_camera(struct sampler *sampler, int i, const struct lens *lens, struct lim_camera *out)
{
    struct viewpoint viewpoint;
    struct error ignored;

    if (i < SAMPLED)
        viewpoint = sampler_next(sampler);
    else if (!sampler_portrait(sampler, &viewpoint))
        return false;
    const struct camera_path path = {"sampled cameras", &viewpoint, 1};
    return camera_path_to_camera(&path, 0, lens, &sampler->scene->grid, out, &ignored);
}

/* The i-th of a path. */
static bool own_camera(const struct compiled *scene, int i, const struct lens *lens, struct lim_camera *out,
                       struct error *err)
{
    struct viewpoint viewpoint = *frame_of_path(scene, i);
    const struct camera_path path = {scene->report.path.name, &viewpoint, 1};
    return camera_path_to_camera(&path, 0, lens, &scene->grid, out, err);
}

/* What is found from few cameras may be too little, which costs time in frames, and pixels only of methods that sort.
 */
static bool ends_early(const struct usage *usage, int cameras)
{
    if (usage->cameras < CAMERAS_AT_LEAST || !deadline_passed()) return false;
    deadline_say("pools measured on %zu of %d cameras%s", usage->cameras, cameras,
                 usage->splits_max ? "; others may have no room for pieces of polygons" : "");
    return true;
}

/* A path's cameras may have times of their own; else they, or the sampled ones, go through all of the animation. */
static double time_s_of(const struct compiled *scene, const struct moving *moving, int i)
{
    const bool has_path = scene->report.path.count > 0;
    const struct viewpoint *const own = has_path ? frame_of_path(scene, i) : NULL;
    if (own && own->has_time) return own->time_s;
    return moving_length_s(moving) * i / (own ? camera_count(scene) : SAMPLED);
}

static bool sample_frames(const struct compiled *scene, struct moving *moving, struct simulator *simulator,
                          struct usage *usage, struct error *err)
{
    const bool is_sampled = !scene->report.path.count;
    const int cameras = camera_count(scene);
    struct sampler sampler;
    struct lens lens;

    sampler_init(&sampler, scene);
    usage->strays = is_sampled ? STRAYS : 0;
    if (!lens_for_grid(&lens, LENS_USUAL, 0, &scene->grid, simulator->target.w_px, simulator->target.h_px, err))
        return false;
    for (int i = 0; i < cameras && !is_too_much(usage) && !ends_early(usage, cameras); i++) {
        struct lim_camera camera;
        if (is_sampled) i = after_enough(usage, i);
        if (i == CAMERAS) break;
        progress_bar((size_t)i, (size_t)cameras, "%scameras", is_sampled ? "sampled " : "");
        if (!is_sampled && !own_camera(scene, i, &lens, &camera, err)) return false;
        if (is_sampled && !sampled_camera(&sampler, i, &lens, &camera)) continue;
        if (moving) moving_pose(moving, time_s_of(scene, moving, i));
        if (!simulator_frame(simulator, &camera, err)) return false;
        note(usage, simulator);
    }
    return !scene->report.worst.tries || is_too_much(usage) || !usage->cameras ||
           pool_search_run(scene, moving, simulator, &lens, scene->report.worst.tries, &usage->searched, err);
}

/* How frames are drawn. */
enum style { STYLE_PLAIN, STYLE_WIREFRAME, STYLE_ANTIALIAS };

static bool set_memory(struct usage *usage, const struct simulator *simulator, bool antialias)
{
    usage->memory = counted_memory_of(simulator->core, simulator->scene, &simulator->target, antialias,
                                      simulator->instance_count > 0);
    usage->closes_none = simulator->target.method == LIM_SCANLINE && !antialias && !simulator->scene->limits.layers;
    return true;
}

static bool sample_method(const struct compiled *scene, struct moving *moving, const struct simulator_setup *setup,
                          enum style style, struct usage *usage, struct error *err)
{
    struct simulator simulator;
    if (!simulator_init(&simulator, &scene->scene, setup, err)) return false;
    simulator_set_wireframe(&simulator, &(struct lim_wireframe){.on = style == STYLE_WIREFRAME});
    const bool ok =
        simulator_set_antialias(&simulator, style == STYLE_ANTIALIAS, err) &&
        simulator_set_delta(&simulator, scene->report.delta_runs ? PLENTY : 0, err) &&
        (!moving || simulator_set_movers(&simulator, moving->instances, moving->count, &moving->limits, err)) &&
        set_memory(usage, &simulator, style == STYLE_ANTIALIAS) && sample_frames(scene, moving, &simulator, usage, err);
    simulator_free(&simulator);
    return ok;
}

/* A convex solid's own method counts faces that cover no pixel as well, and in a firmware of its own those beside
 * the screen (project.c): a few more cross a line. */
static bool sample_convex(struct compiled *roomy, struct simulator_setup *setup, uint16_t *active, struct error *err)
{
    struct usage usage = {0};
    setup->method = LIM_CONVEX;
    roomy->scene.limits.active = (uint16_t)(roomy->scene.polygon_count < PLENTY ? roomy->scene.polygon_count : PLENTY);
    if (!sample_method(roomy, NULL, setup, STYLE_PLAIN, &usage, err)) return false;
    const uint16_t crossing = with_margin(most(&usage, usage.active), 1);
    *active = crossing > *active ? crossing : *active;
    return true;
}

/* Half as many again: no camera was asked for the worst. */
static uint16_t pieces_for(const struct usage *usage)
{
    const uint32_t wanted = usage->splits_max ? usage->splits_max + usage->splits_max / 2 + LEAST_PIECES : 0;
    return (uint16_t)(wanted < LIM_SORTED_MAX ? wanted : LIM_SORTED_MAX);
}

static uint16_t greater(uint16_t a, uint16_t b)
{
    return a > b ? a : b;
}

static uint32_t most_shared_b(struct usage *usage, bool moves)
{
    const uint32_t greatest = most(usage, usage->shared);
    const size_t few = usage->cameras / FEW_GREEDY + usage->strays;
    const uint32_t spread = few < usage->cameras ? greatest - usage->shared[usage->cameras - 1 - few] : 0;
    const uint32_t least = (moves ? greatest * 3 / 8 : greatest / SHARED_MARGIN) + 1;

    return (greatest + (spread > least ? spread : least)) * SHARED_UNIT_B;
}

/* To what was found by search, with nothing on top. */
static void raise_to_searched(const struct pool_search_result *searched, struct lim_limits *limits)
{
    if (!searched->views.tried) return;
    limits->retained_cells = greater(limits->retained_cells, with_margin_of_one(searched->cells));
    limits->gaps = greater(limits->gaps, with_margin_of_one(searched->gaps));
    limits->active = greater(limits->active, with_margin_of_one(searched->active));
}

/* Each has a pool of its own, or is counted so. */
static void raise_one_by_one(struct usage *usage, struct lim_limits *limits)
{
    raise_to_searched(&usage->searched, limits);
    const uint16_t cells = with_margin(most(usage, usage->cells), needs_least_cells(limits));
    limits->retained_cells = greater(limits->retained_cells, cells);
    limits->gaps = greater(limits->gaps, with_margin(most(usage, usage->gaps), 1));
    limits->active = greater(limits->active, with_margin(most(usage, usage->active), 1));
}

/* What is left between cells and gaps may be too small for any entry: so there is one more of each. */
static uint32_t one_of_each_b(const struct lim_counted *counted)
{
    return counted->cell_b + counted->gap_b + counted->active_b;
}

/* Polygons that cross a line beyond those that idle memory holds, as far as `all_b` has room for them beside the least
 * cells. */
static uint16_t beyond_idle(struct usage *usage, uint32_t all_b, uint32_t others_b)
{
    const struct lim_counted *counted = &usage->memory.counted;
    const uint32_t idle = counted->idle_b / counted->active_b;
    const uint32_t crossing = most(usage, usage->active);
    const uint32_t room = all_b > others_b ? (all_b - others_b) / counted->active_b : 0;
    const uint32_t beyond = crossing > idle ? crossing - idle : 0;

    return greater(within(beyond < room ? beyond : room), 1);
}

/* Of the memory that they share the limits say how much it is in all, in an MCU's bytes. Pictures that are filled as
 * polygons come take gaps alone, and antialiased lines that are painted at once as many as polygons cross them: so
 * those have their number. So has what crosses a line, which is larger in a program of 64 bits. All else is cells. */
static void raise_shared(struct usage *usage, bool moves, struct lim_limits *limits)
{
    const struct lim_counted *counted = &usage->memory.counted;
    const uint32_t sampled_b = most_shared_b(usage, moves);
    const uint32_t searched_b = usage->searched.shared_b + one_of_each_b(counted);
    const uint32_t all_b = sampled_b > searched_b ? sampled_b : searched_b;
    const uint16_t at_once = (uint16_t)(usage->memory.of_a_line ? most(usage, usage->active) + 1 : 0);
    const uint16_t gaps = greater(most(usage, usage->gaps), at_once);

    limits->gaps = greater(limits->gaps, greater((uint16_t)(gaps + gaps / SHARED_MARGIN), 1));
    const uint32_t gaps_b = (usage->closes_none ? 1 : limits->gaps) * counted->gap_b;
    const uint32_t least_b = needs_least_cells(limits) * counted->cell_b;
    limits->active = greater(limits->active, beyond_idle(usage, all_b, gaps_b + least_b));
    const uint32_t rest_b = gaps_b + limits->active * counted->active_b;
    const uint32_t cells = all_b > rest_b ? (all_b - rest_b + counted->cell_b - 1) / counted->cell_b : 0;
    limits->retained_cells = greater(limits->retained_cells, greater(within(cells), needs_least_cells(limits)));
}

/* Raises the limits to what the orders with spans used. */
static void raise_limits(struct compiled *roomy, bool moves, struct usage *usage, struct lim_limits *limits)
{
    if (usage->memory.counted.cell_b)
        raise_shared(usage, moves, limits);
    else
        raise_one_by_one(usage, limits);
    limits->pieces = greater(limits->pieces, pieces_for(usage));
    if (roomy->report.delta_runs)
        roomy->report.delta_runs = greater(roomy->report.delta_runs, with_margin(most(usage, usage->runs), 1));
    if (roomy->scene.limits.layers)
        limits->layers = greater(limits->layers, with_margin(most(usage, usage->layers), 1));
    if (roomy->scene.limits.leaf_polygons)
        limits->leaf_polygons =
            greater(limits->leaf_polygons, with_margin(most(usage, usage->leaf_polygons), LEAST_LEAF));
}

static bool sample_spans(struct compiled *roomy, struct moving *moving, const struct simulator_setup *setup,
                         enum style style, struct lim_limits *limits, struct error *err)
{
    struct usage usage = {0};
    if (!sample_method(roomy, moving, setup, style, &usage, err)) return false;
    raise_limits(roomy, moving != NULL, &usage, limits);
    if (style == STYLE_PLAIN) pool_search_report(&usage.searched, &roomy->grid, &roomy->report.worst);
    if (style == STYLE_PLAIN && usage.splits >= ENOUGH_SPLITS) roomy->report.few_cameras = usage.cameras;
    if (style == STYLE_PLAIN && usage.seen) roomy->report.reached_a_seen = (double)usage.reached / (double)usage.seen;
    if (style == STYLE_PLAIN && usage.cameras && frame_cost_knows(setup->method) && frame_cost_is_known(&roomy->scene))
        roomy->report.instructions = usage.instructions / (double)usage.cameras;
    return true;
}

/* A scene with the same arrays whose pools do not run out. `active`, too, must be enough, and should be no more than
 * that: the renderer links all of them anew for every frame. */
static struct compiled roomy_of(const struct compiled *scene, uint32_t active)
{
    struct compiled roomy = *scene;
    roomy.scene.limits.retained_cells = roomy.scene.limits.gaps = PLENTY;
    roomy.scene.limits.active = (uint16_t)(active < MOST_RETAINED ? active : MOST_RETAINED);
    roomy.scene.limits.pieces = PLENTY_OF_PIECES;
    if (roomy.scene.limits.leaf_polygons) roomy.scene.limits.leaf_polygons = LIM_SORTED_MAX;
    roomy.scene.limits.layers = records_with(&scene->scene, LIM_POLYGON_ALPHA) ? PLENTY : 0;
    return roomy;
}

/* With layers for what is transparent of the objects. */
static struct compiled roomy_of_moving(const struct compiled *scene, const struct moving *moving)
{
    struct compiled roomy = roomy_of(scene, MOST_RETAINED);

    for (size_t i = 0; i < moving->count; i++)
        if (records_with(&moving->objects[i].scene.scene, LIM_POLYGON_ALPHA)) roomy.scene.limits.layers = PLENTY;
    return roomy;
}

/* For one polygon, and what is told of it: before it, and once more behind, of the next one. */
static uint16_t least_cells_moving(const struct compiled *scene, const struct moving *moving)
{
    const size_t told = MCU_TOLD_CELLS + (moving->count + 15) / 16;
    uint16_t least = needs_least_cells(&scene->scene.limits);

    for (size_t i = 0; i < moving->count; i++)
        least = greater(least, needs_least_cells(&moving->objects[i].scene.scene.limits));
    return (uint16_t)(least + 2 * told);
}

bool pools_measure_moving(struct compiled *scene, struct moving *moving, const struct core *core, struct error *err)
{
    struct lim_limits limits = scene->scene.limits;
    struct compiled roomy = roomy_of_moving(scene, moving);
    const enum lim_method method = scene->report.draws == LIM_SCANLINE ? LIM_SCANLINE : LIM_NEAREST_FIRST;
    const struct simulator_setup setup = {scene->report.w_px, scene->report.h_px, method, SIMULATOR_UNSEEN, core};

    limits.retained_cells = greater(limits.retained_cells, least_cells_moving(scene, moving));
    if (!sample_spans(&roomy, moving, &setup, STYLE_PLAIN, &limits, err) ||
        (scene->report.wireframe && !sample_spans(&roomy, moving, &setup, STYLE_WIREFRAME, &limits, err)) ||
        (scene->report.antialias && !sample_spans(&roomy, moving, &setup, STYLE_ANTIALIAS, &limits, err)))
        return false;
    lim_image_set_limits(scene, &limits);
    scene->report.delta_runs = roomy.report.delta_runs;
    scene->report.worst = roomy.report.worst;
    scene->report.instructions = roomy.report.instructions;
    return true;
}

bool pools_scan_moving(struct compiled *scene, struct moving *moving, const struct core *core, double instructions_most,
                       struct error *err)
{
    struct lim_limits limits = scene->scene.limits;
    struct compiled roomy = roomy_of_moving(scene, moving);
    const struct simulator_setup setup = {scene->report.w_px, scene->report.h_px, LIM_SCANLINE, SIMULATOR_UNSEEN, core};
    struct usage usage = {.instructions_most = instructions_most * camera_count(scene)};

    if (!sample_method(&roomy, moving, &setup, STYLE_PLAIN, &usage, err)) return false;
    if (deadline_passed() || !(usage.instructions <= instructions_most * (double)usage.cameras)) return true;
    raise_limits(&roomy, true, &usage, &limits);
    lim_image_set_limits(scene, &limits);
    scene->report.draws = LIM_SCANLINE;
    return true;
}

/* Of a mesh's pools only that of the triangles that cross a line is measured. */
static bool measure_mesh(struct compiled *scene, const struct core *core, struct error *err)
{
    struct lim_limits limits = {.vertices = scene->scene.limits.vertices};
    const struct simulator_setup setup = {scene->report.w_px, scene->report.h_px, scene->report.draws, SIMULATOR_UNSEEN,
                                          core};
    struct compiled roomy = roomy_of(scene, scene->scene.polygon_count);
    struct usage usage = {0};

    if (!sample_method(&roomy, NULL, &setup, STYLE_PLAIN, &usage, err)) return false;
    limits.active = greater(most(&usage, usage.active), MCU_MESH_LEAST_ACTIVE); /* less costs little */
    lim_image_set_limits(scene, &limits);
    if (usage.cameras && frame_cost_knows(setup.method))
        scene->report.instructions = usage.instructions / (double)usage.cameras;
    return true;
}

bool pools_measure(struct compiled *scene, const struct core *core, unsigned w_px, unsigned h_px, struct error *err)
{
    scene->report.w_px = w_px;
    scene->report.h_px = h_px;
    if (lim_scene_is_mesh(&scene->scene)) return measure_mesh(scene, core, err);
    const struct lim_limits *known = &scene->scene.limits;
    struct lim_limits limits = {
        .depth = known->depth, .vertices = known->vertices, .leaf_vertices = known->leaf_vertices};
    const enum lim_method method = method_sorts(scene->report.draws) ? scene->report.draws : LIM_NEAREST_FIRST;
    const uint32_t cut = method == LIM_NEWELL ? PLENTY_OF_PIECES : 0; /* all others are active once at most */
    struct compiled roomy = roomy_of(scene, scene->scene.polygon_count + cut);
    struct simulator_setup setup = {w_px, h_px, method, SIMULATOR_UNSEEN, core};

    if (!sample_spans(&roomy, NULL, &setup, STYLE_PLAIN, &limits, err) ||
        (scene->report.wireframe && !sample_spans(&roomy, NULL, &setup, STYLE_WIREFRAME, &limits, err)) ||
        (scene->report.antialias && !sample_spans(&roomy, NULL, &setup, STYLE_ANTIALIAS, &limits, err)))
        return false;
    if (scene->report.draws == LIM_CONVEX && !sample_convex(&roomy, &setup, &limits.active, err)) return false;
    lim_image_set_limits(scene, &limits);
    const bool is_known = frame_cost_knows(scene->report.draws);
    scene->report.instructions = is_known ? roomy.report.instructions : NAN;
    scene->report.reached_a_seen = roomy.report.reached_a_seen;
    scene->report.delta_runs = roomy.report.delta_runs;
    scene->report.few_cameras = roomy.report.few_cameras;
    scene->report.worst = roomy.report.worst;
    return scene->report.draws != LIM_SCANLINE || pools_measure_scanline(scene, core, 0.0, err);
}

bool pools_measure_scanline(struct compiled *scene, const struct core *core, double instructions_most,
                            struct error *err)
{
    struct lim_limits limits = scene->scene.limits;
    struct compiled roomy = roomy_of(scene, scene->scene.polygon_count);
    const struct simulator_setup setup = {scene->report.w_px, scene->report.h_px, LIM_SCANLINE, SIMULATOR_UNSEEN, core};

    struct usage usage = {.instructions_most = instructions_most * camera_count(scene)};

    if (!sample_method(&roomy, NULL, &setup, STYLE_PLAIN, &usage, err)) return false;
    const double instructions = usage.instructions / (double)usage.cameras;
    if (instructions_most > 0.0 && deadline_passed()) return true; /* of other cameras than those before */
    if (instructions_most > 0.0 && !(instructions <= instructions_most)) return true;
    raise_limits(&roomy, false, &usage, &limits);
    pool_search_report(&usage.searched, &scene->grid, &scene->report.worst);
    if (scene->report.antialias) limits.gaps = 1; /* nearest first left more */
    if (scene->report.antialias && !sample_spans(&roomy, NULL, &setup, STYLE_ANTIALIAS, &limits, err)) return false;
    lim_image_set_limits(scene, &limits);
    scene->report.draws = LIM_SCANLINE;
    scene->report.instructions = frame_cost_is_known(&scene->scene) ? instructions : NAN;
    return true;
}
