/* SPDX-License-Identifier: MIT
 *
 * Renders a list of cameras by every method that this build has, in every way that it has, into a framebuffer. Prints
 * `METHOD WAY`, and each frame's number and hash as `limner render --write-hashes` does; where the renderer refuses,
 * `refused`. Compiled for a scene (model.h), its cameras (cameras.h) and a choice of features. */
#include "limner.h"

#include "cameras.h"
#include "model.h"
#include "text.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { LINE_PX = (CAMERAS_W_PX + 1) / 2 * 2, RUNS = 64 * CAMERAS_H_PX };

enum way { PLAIN, FILL, FRAMEBUFFER, PARTS, WIREFRAME, ANTIALIAS, DELTA, OVERLAY, WAYS };

static const struct {
    const char *name;
    bool linked;
} WAY[WAYS] = {{"plain", LIM_HAS_LINES}, {"fill", LIM_HAS_FILL},           {"framebuffer", LIM_HAS_FRAMEBUFFER},
               {"parts", LIM_HAS_LINES}, {"wireframe", LIM_HAS_WIREFRAME}, {"antialias", LIM_HAS_ANTIALIAS},
               {"delta", LIM_HAS_DELTA}, {"overlay", LIM_HAS_OVERLAY}};

static const struct {
    const char *name;
    enum lim_method method;
    bool linked;
} METHOD[] = {{"nearest", LIM_NEAREST_FIRST, LIM_HAS_NEAREST},
              {"painter", LIM_PAINTER, LIM_HAS_PAINTER},
              {"convex", LIM_CONVEX, LIM_HAS_CONVEX},
              {"scanline", LIM_SCANLINE, LIM_HAS_SCANLINE},
              {"depth", LIM_DEPTH, LIM_HAS_DEPTH},
              {"newell", LIM_NEWELL, LIM_HAS_NEWELL},
              {"mesh", LIM_MESH, LIM_HAS_MESH},
              {"mesh-depth", LIM_MESH_DEPTH, LIM_HAS_MESH_DEPTH}};

static uint32_t frame[CAMERAS_H_PX * LINE_PX / 2];

static uint16_t *line(uint16_t y_px)
{
    return (uint16_t *)frame + (size_t)y_px * LINE_PX;
}

static void *lend(void *ctx, uint16_t y_px)
{
    (void)ctx;
    return line(y_px);
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    return y_px < CAMERAS_H_PX && x_px + n_px <= CAMERAS_W_PX ? 0 : -1;
}

#if LIM_HAS_FILL
static void fill(void *look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *piece = look;

    for (uint16_t x = x0_px; x < x1_px; x++)
        line(piece->y_px)[x] = piece->colour;
}

#if LIM_HAS_NEAREST
static int show(void *ctx)
{
    (void)ctx;
    return 0;
}
#endif
#endif

#if LIM_HAS_DELTA
static int window(void *ctx, const struct lim_rect *opened)
{
    (void)ctx;
    return opened && (opened->x1 > CAMERAS_W_PX || opened->y1 > CAMERAS_H_PX) ? -1 : 0;
}
#endif

/* FNV-1a, 64 bits, of the bytes as the bus gets them. */
static uint64_t hash_of_frame(void)
{
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (uint16_t y = 0; y < CAMERAS_H_PX; y++) {
        const uint8_t *bytes = (const uint8_t *)line(y);
        for (size_t i = 0; i < 2 * CAMERAS_W_PX; i++)
            hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

static struct lim_target target_for(enum lim_method method, enum way way)
{
    struct lim_target target = {
        .w_px = CAMERAS_W_PX, .h_px = CAMERAS_H_PX, .format = LIM_RGB565, .method = method, .lend = lend, .done = done};
    (void)way;
#if LIM_HAS_FILL
    if (way == FILL || !LIM_HAS_LINES) target.fill = fill;
#if LIM_HAS_NEAREST
    if (way == FILL) target.show = show;
#endif
#endif
#if LIM_HAS_FRAMEBUFFER
    if (way == FRAMEBUFFER) target.framebuffer = (struct lim_framebuffer){frame, LINE_PX};
#endif
#if LIM_HAS_DELTA
    target.window = window;
    target.costs = (struct lim_target_costs){.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1};
#endif
    return target;
}

#if LIM_HAS_OVERLAY
/* `limner render --overlay "over it"`. */
static lim_overlay_draw draw_over;

enum { OVER_W_PX = 7 * LIM_TEXT_W_PX + 3, OVER_H_PX = LIM_TEXT_H_PX + 3 };
enum { OVER_X_PX = (CAMERAS_W_PX - OVER_W_PX) / 2, OVER_Y_PX = CAMERAS_H_PX / 8 };

static void draw_over(void *ctx, const struct lim_overlay_line *over)
{
    const struct lim_overlay_box box = {OVER_X_PX, OVER_Y_PX, OVER_W_PX, OVER_H_PX};

    (void)ctx;
    lim_overlay_box(over, &box, 0);
    lim_text(over, OVER_X_PX + 2, OVER_Y_PX + 2, "over it", &(const struct lim_text_style){.colour = 0xFFFF});
}
#endif

/* What is asked for beside the method. */
static int set_way(struct lim *lim, enum way way)
{
    (void)lim;
#if LIM_HAS_WIREFRAME
    if (way == WIREFRAME) lim_set_wireframe(lim, &(const struct lim_wireframe){.on = true});
#endif
#if LIM_HAS_OVERLAY
    static const struct lim_overlay overlay = {.draw = draw_over, .y0_px = 0, .y1_px = CAMERAS_H_PX};
    if (way == OVERLAY) lim_set_overlay(lim, &overlay);
#endif
#if LIM_HAS_ANTIALIAS
    static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(CAMERAS_W_PX) / 4];
    if (way == ANTIALIAS) return lim_set_antialias(lim, smooth_mem, sizeof smooth_mem);
#endif
#if LIM_HAS_DELTA
    static void *delta_mem[LIM_DELTA_MEM_B(CAMERAS_W_PX, CAMERAS_H_PX, RUNS) / sizeof(void *) + 1];
    if (way == DELTA) return lim_set_delta(lim, delta_mem, sizeof delta_mem);
#endif
    return way >= WAYS;
}

#ifdef MODEL_MOVERS
static int set_movers(struct lim *lim)
{
    static void *mover_mem[MODEL_MOVERS_MEM_B / sizeof(void *) + 1];
    const struct lim_movers_limits limits = MODEL_MOVERS_LIMITS;
    const int err = lim_movers_init(lim, mover_mem, sizeof mover_mem, &limits);

#ifdef MODEL_LIGHT
    const struct lim_light light = MODEL_LIGHT;
    lim_light_set(lim, &light);
#endif
    return err;
}

/* Three frames a second. */
static const struct lim_instance *placed(size_t at)
{
    static struct lim_instance instances[MODEL_MOVERS];

    lim_moved_at(model_movers, MODEL_MOVERS, ((uint32_t)at * 1000 + 1) / 3, instances);
    return instances;
}

static int draw_at_once(struct lim *lim, size_t at)
{
    return lim_movers_frame(lim, &cameras[at], placed(at), MODEL_MOVERS);
}

static int begin(struct lim *lim, size_t at)
{
    return lim_movers_begin(lim, &cameras[at], placed(at), MODEL_MOVERS);
}
#else
static int set_movers(struct lim *lim)
{
    (void)lim;
    return 0;
}

static int draw_at_once(struct lim *lim, size_t at)
{
    return lim_frame(lim, &cameras[at]);
}

static int begin(struct lim *lim, size_t at)
{
    return lim_frame_begin(lim, &cameras[at]);
}
#endif

static int draw(struct lim *lim, size_t at, enum way way)
{
    if (way != PARTS) return draw_at_once(lim, at);
    const int err = begin(lim, at);
    while (!err && lim_frame_work(lim))
        continue;
    return err ? err : lim_frame_paint(lim);
}

static void render(enum lim_method method, enum way way)
{
    static struct lim lim;
    const struct lim_target target = target_for(method, way);
    const size_t mem_b = lim_mem_b(&model_scene, &target);
    void *mem = malloc(mem_b);
    int err = mem ? lim_init(&lim, &model_scene, &target, mem, mem_b) : LIM_ERR_MEMORY;

    if (!err) err = set_way(&lim, way);
    if (!err) err = set_movers(&lim);
    for (size_t at = 0; at < CAMERAS_COUNT && !err; at++) {
        err = draw(&lim, at, way);
        if (!err) printf("%zu %016" PRIx64 "\n", at, hash_of_frame());
        if (!LIM_HAS_STATS && !err && lim_stats(&lim)->pixels_painted) err = -1;
    }
    if (err) printf("refused\n");
    free(mem);
}

int main(void)
{
    for (size_t i = 0; i < sizeof METHOD / sizeof *METHOD; i++) {
        for (unsigned way = PLAIN; way < WAYS; way++) {
            if (!METHOD[i].linked || !WAY[way].linked) continue;
            printf("%s %s\n", METHOD[i].name, WAY[way].name);
            render(METHOD[i].method, (enum way)way);
        }
    }
    return EXIT_SUCCESS;
}
