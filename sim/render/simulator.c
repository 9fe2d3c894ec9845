/* SPDX-License-Identifier: MIT
 *
 * Owns everything that a frame needs: the renderer's memory, and either the panel board or plain
 * lines. Plain memory serves both methods, as it can lend every line at any time. */
#include "render/simulator.h"

#include "core/core.h"
#include "linux/code_words.h"
#include "render/counted_memory.h"
#include "scene/convexity.h"
#include "scene/method.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Nobody's choice is a panel that stands, unless the picture is turned on it. */
static struct panel_choice choice_of(const struct panel_choice *choice)
{
    const bool is_named = choice && choice->family;
    struct panel_choice usual = {0};

    if (!is_named) (void)panel_choice_parse("st7789", NULL, &usual, &(struct error){0});
    usual.rotation = choice ? choice->rotation : PANEL_UPRIGHT;
    usual.exchanges = usual.rotation != PANEL_UPRIGHT;
    return is_named ? *choice : usual;
}

bool simulator_panel_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct error *err)
{
    const struct panel_choice on = choice_of(choice);

    return panel_board_holds(&on, w_px, h_px, err);
}

/* Plain memory ------------------------------------------------------------------------------- */

static void *memory_lend(void *ctx, uint16_t y_px)
{
    struct simulator *simulator = ctx;
    return simulator->lines + y_px * simulator->line_b;
}

static int memory_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct simulator *simulator = ctx;
    const uint8_t *bytes = simulator->lines + y_px * simulator->line_b;
    uint16_t *pixels = simulator->pixels + (size_t)y_px * simulator->target.w_px;
    for (unsigned x = x_px; x < (unsigned)x_px + n_px; x++)
        pixels[x] = (uint16_t)(bytes[2 * x] << 8 | bytes[2 * x + 1]);
    return 0;
}

static void *unseen_lend(void *ctx, uint16_t y_px)
{
    const struct simulator *simulator = ctx;
    (void)y_px;
    return simulator->lines;
}

static int unseen_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

/* Plain memory takes every piece where it belongs. */
static int memory_window(void *ctx, const struct lim_rect *window)
{
    (void)ctx;
    (void)window;
    return 0;
}

static bool memory_init(struct simulator *simulator, const struct simulator_setup *setup, struct error *err)
{
    const bool seen = setup->panel != SIMULATOR_UNSEEN;
    simulator->line_b = SCREEN_LINE_B(setup->w_px);
    simulator->lines = calloc(seen ? setup->h_px : 1, simulator->line_b);
    simulator->target = (struct lim_target){.w_px = (uint16_t)setup->w_px,
                                            .h_px = (uint16_t)setup->h_px,
                                            .format = LIM_RGB565,
                                            .method = setup->method,
                                            .ctx = simulator,
                                            .lend = seen ? memory_lend : unseen_lend,
                                            .done = seen ? memory_done : unseen_done,
                                            .window = memory_window,
                                            .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
    if (setup->panel == SIMULATOR_FRAMEBUFFER)
        simulator->target.framebuffer =
            (struct lim_framebuffer){simulator->lines, (uint16_t)(simulator->line_b / sizeof(uint16_t))};
    return simulator->lines || error_set(err, "simulator: out of memory");
}

/* Panel -------------------------------------------------------------------------------------- */

static bool board_init(struct simulator *simulator, const struct simulator_setup *setup,
                       const struct panel_choice *choice, struct error *err)
{
    const struct panel_choice on = choice_of(choice);
    struct panel_board *board = calloc(1, sizeof *board);
    if (!board) return error_set(err, "simulator: out of memory");
    if (!panel_board_init(board, &on, setup->method, setup->w_px, setup->h_px, err)) {
        free(board);
        return false;
    }
    simulator->board = board;
    simulator->target = board->screen.target;
    return true;
}

/* Renderer ----------------------------------------------------------------------------------- */

/* Pools run out where they do on a board. */
static void count_pools(struct simulator *simulator)
{
    struct counted_memory memory = counted_memory_of(simulator->core, simulator->scene, &simulator->target,
                                                     simulator->antialias, simulator->instance_count > 0);
    const double more_b = (double)(memory.all_b - memory.least_b) * simulator->part;
    if (!memory.counted.cell_b || simulator->mem_b < simulator->core->mem_b(simulator->roomy, &simulator->target))
        return;
    memory.counted.line_gaps = (uint16_t)(1.0 + simulator->part * (simulator->scene->limits.gaps - 1.0));
    simulator->core->count_as(simulator->lim, &memory.counted, memory.least_b + (size_t)more_b);
}

/* Where something moves there are fewer polygons that cross a line, and more bytes of them. */
static struct lim_limits roomy_limits(const struct simulator *simulator, const struct lim_scene *scene)
{
    const struct lim_target *target = &simulator->target;
    const struct counted_memory still = counted_memory_of(simulator->core, scene, target, true, false);
    const struct counted_memory moving = counted_memory_of(simulator->core, scene, target, true, true);
    struct lim_limits limits = counted_memory_limits(&moving, scene, target);
    const uint16_t active = counted_memory_limits(&still, scene, target).active;

    if (active > limits.active) limits.active = active;
    return limits;
}

static bool make_roomy(struct simulator *simulator, const struct lim_scene *scene)
{
    simulator->scene = scene;
    simulator->part = 1.0;
    simulator->roomy = malloc(sizeof *simulator->roomy);
    if (!simulator->roomy) return false;
    *simulator->roomy = *scene;
    simulator->roomy->limits = roomy_limits(simulator, scene);
    return true;
}

static bool renderer_init(struct simulator *simulator, const struct lim_scene *scene, struct error *err)
{
    const struct core *core = simulator->core;
    size_t pixel_count = (size_t)simulator->target.w_px * simulator->target.h_px;
    if (!make_roomy(simulator, scene)) return error_set(err, "simulator: out of memory");
    simulator->pixels = calloc(pixel_count, sizeof simulator->pixels[0]);
    simulator->mem_b = core->mem_b(simulator->roomy, &simulator->target);
    simulator->mem = malloc(simulator->mem_b);
    simulator->lim = calloc(1, core->lim_b);
    if (!simulator->pixels || !simulator->mem || !simulator->lim) return error_set(err, "simulator: out of memory");
    int code = core->init(simulator->lim, simulator->roomy, &simulator->target, simulator->mem, simulator->mem_b);
    if (code) return error_set(err, "renderer: %s (%d)", code_words(code), code);
    count_pools(simulator);
    return true;
}

bool simulator_set_ram(struct simulator *simulator, const struct simulator_ram *ram, struct error *err)
{
    const struct core *core = simulator->core;
    const struct lim_target *target = &simulator->target;
    const size_t all_b = core->mem_b(simulator->scene, target), least_b = core->mem_min_b(simulator->scene, target);
    const size_t roomy_b = core->mem_b(simulator->roomy, target);
    size_t mem_b = all_b;
    if (ram->percent > 0.0) mem_b = least_b + (size_t)((double)(all_b - least_b) * fmin(ram->percent, 100.0) / 100.0);
    if (ram->bytes && ram->bytes < all_b) mem_b = ram->bytes;
    if (mem_b < least_b)
        return error_set(err, "renderer with %zu bytes of memory: %s; %zu are the least", mem_b,
                         code_words(LIM_ERR_MEMORY), least_b);
    simulator->part = all_b > least_b ? (double)(mem_b - least_b) / (double)(all_b - least_b) : 1.0;
    simulator->mem_b = counted_memory_of(core, simulator->scene, target, false, false).counted.cell_b ? roomy_b : mem_b;
    const int code = core->init(simulator->lim, simulator->roomy, target, simulator->mem, simulator->mem_b);
    if (code) return error_set(err, "renderer: %s (%d)", code_words(code), code);
    count_pools(simulator);
    return true;
}

static bool begin(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                  struct error *err)
{
    memset(simulator, 0, sizeof *simulator);
    simulator->core = setup->core ? setup->core : &core_fast;
    return setup->method != LIM_CONVEX || scene_is_convex(scene) ||
           error_set(err, "--method convex: the scene is not one convex solid");
}

bool simulator_init(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                    struct error *err)
{
    return simulator_init_on(simulator, scene, setup, NULL, err);
}

bool simulator_init_on(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                       const struct panel_choice *choice, struct error *err)
{
    enum simulator_panel panel = setup->panel;
    if (!begin(simulator, scene, setup, err)) return false;
    if (panel == SIMULATOR_ANY)
        panel = simulator_panel_holds(choice, setup->w_px, setup->h_px, &(struct error){0}) ? SIMULATOR_PANEL
                                                                                            : SIMULATOR_MEMORY;
    bool ok = panel == SIMULATOR_PANEL ? board_init(simulator, setup, choice, err) : memory_init(simulator, setup, err);
    ok = ok && renderer_init(simulator, scene, err);
    if (!ok) simulator_free(simulator);
    return ok;
}

bool simulator_init_to(struct simulator *simulator, const struct lim_scene *scene, const struct simulator_setup *setup,
                       const struct lim_target *target, struct error *err)
{
    if (!begin(simulator, scene, setup, err)) return false;
    simulator->target = *target;
    if (renderer_init(simulator, scene, err)) return true;
    simulator_free(simulator);
    return false;
}

void simulator_set_wireframe(struct simulator *simulator, const struct lim_wireframe *wireframe)
{
    simulator->core->set_wireframe(simulator->lim, wireframe);
}

bool simulator_set_antialias(struct simulator *simulator, bool on, struct error *err)
{
    const size_t mem_b = LIM_ANTIALIAS_MEM_B(simulator->target.w_px);
    if (on && !simulator->smooth_mem) simulator->smooth_mem = malloc(mem_b);
    if (on && !simulator->smooth_mem) return error_set(err, "simulator: out of memory");
    const int code = simulator->core->set_antialias(simulator->lim, on ? simulator->smooth_mem : NULL, mem_b);
    if (!code) {
        simulator->antialias = on;
        count_pools(simulator);
    }
    return !code || error_set(err, "--antialias: takes a method that draws nearest first");
}

bool simulator_set_delta(struct simulator *simulator, uint16_t runs, struct error *err)
{
    const size_t mem_b = LIM_DELTA_MEM_B(simulator->target.w_px, simulator->target.h_px, runs);
    void *mem = runs ? malloc(mem_b) : NULL;
    if (runs && !mem) return error_set(err, "simulator: out of memory");
    const int code = simulator->core->set_delta(simulator->lim, mem, mem_b);
    free(simulator->delta_mem);
    simulator->delta_mem = mem;
    return !code || error_set(err, "renderer: %s (%d)", code_words(code), code);
}

void simulator_refresh(struct simulator *simulator)
{
    simulator->core->refresh(simulator->lim);
}

const struct lim_stats *simulator_stats(const struct simulator *simulator)
{
    return simulator->core->stats(simulator->lim);
}

bool simulator_set_movers(struct simulator *simulator, const struct lim_instance *instances, size_t count,
                          const struct lim_movers_limits *limits, struct error *err)
{
    const struct core *core = simulator->core;
    const size_t mem_b = core->movers_mem_b(simulator->scene, limits);
    if (!method_moves(simulator->target.method, err)) return false;
    simulator->mover_mem = malloc(mem_b);
    simulator->instances = instances;
    simulator->instance_count = (uint16_t)count;
    if (!simulator->mover_mem) return error_set(err, "simulator: out of memory");
    count_pools(simulator);
    const int code = core->movers_init(simulator->lim, simulator->mover_mem, mem_b, limits);
    return code == 0 || error_set(err, "renderer: %s (%d)", code_words(code), code);
}

int simulator_draw(struct simulator *simulator, const struct lim_camera *camera)
{
    const struct core *core = simulator->core;
    if (!simulator->mover_mem) return core->frame(simulator->lim, camera);
    return core->movers_frame(simulator->lim, camera, simulator->instances, simulator->instance_count);
}

static int board_frame(struct simulator *simulator, const struct lim_camera *camera)
{
    int err = screen_begin_frame(&simulator->board->screen);
    if (err) return err;
    err = simulator_draw(simulator, camera);
    if (!err) err = screen_end_frame(&simulator->board->screen);
    if (err) simulator_refresh(simulator);
    return err;
}

bool simulator_frame(struct simulator *simulator, const struct lim_camera *camera, struct error *err)
{
    struct panel_board *board = simulator->board;
    uint64_t before_b = board ? panel_board_bus_b(board) : 0;
    int code = board ? board_frame(simulator, camera) : simulator_draw(simulator, camera);
    if (code) return error_set(err, "renderer: %s (%d)", code_words(code), code);
    if (!board) return true;
    simulator->bus_b = (size_t)(panel_board_bus_b(board) - before_b);
    return panel_board_read(board, simulator->pixels, err);
}

struct film simulator_film(const struct simulator *simulator)
{
    return (struct film){simulator->target.w_px, simulator->target.h_px, 1, simulator->pixels};
}

size_t simulator_pixel_count(const struct simulator *simulator)
{
    return (size_t)simulator->target.w_px * simulator->target.h_px;
}

void simulator_free(struct simulator *simulator)
{
    if (simulator->board) panel_board_free(simulator->board);
    free(simulator->board);
    free(simulator->lines);
    free(simulator->pixels);
    free(simulator->mem);
    free(simulator->mover_mem);
    free(simulator->smooth_mem);
    free(simulator->delta_mem);
    free(simulator->lim);
    free(simulator->roomy);
    memset(simulator, 0, sizeof *simulator);
}

bool simulator_add_movers(struct simulator *simulator, const struct compiled *scene, struct error *err)
{
    const struct moving *moving = scene->moving;
    return !moving || simulator_set_movers(simulator, moving->instances, moving->count, &moving->limits, err);
}
