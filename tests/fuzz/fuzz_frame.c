/* SPDX-License-Identifier: MIT
 *
 * Memory is taken from the heap to the byte, so that a sanitizer sees every step beyond it. */
#include "fuzz_frame.h"

#include "colour.h"
#include "core/core.h"
#include "rigs/unpainted.h"

#include <stdlib.h>
#include <string.h>

enum { RUNS = 2 * FUZZ_SIDE_MAX_PX };

struct canvas {
    const struct lim_scene *scene;
    uint16_t unpainted; /* of this colour nothing is, unless colours are mixed */
    uint16_t w_px, h_px;
    _Alignas(4) uint16_t pixels[FUZZ_SIDE_MAX_PX][FUZZ_SIDE_MAX_PX];
    uint8_t done[FUZZ_SIDE_MAX_PX][FUZZ_SIDE_MAX_PX]; /* how often each pixel was final */
    bool strayed;                                     /* a line or a pixel that the target has not */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    if (y_px < canvas->h_px) return canvas->pixels[y_px];
    canvas->strayed = true;
    return NULL;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    if (y_px >= canvas->h_px || n_px == 0 || x_px + n_px > canvas->w_px) {
        canvas->strayed = true;
        return 0;
    }
    for (uint16_t x = x_px; x < x_px + n_px; x++)
        canvas->done[y_px][x]++;
    return 0;
}

struct lim_camera fuzz_camera_from(struct fuzz_bytes *bytes)
{
    struct lim_camera camera = {.origin = {0}};

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)fuzz_u32(bytes);
    camera.yaw = fuzz_u32(bytes);
    camera.pitch = fuzz_u32(bytes);
    camera.roll = fuzz_u32(bytes);
    camera.tan_x_q28 = fuzz_u32(bytes);
    camera.tan_y_q28 = fuzz_u32(bytes);
    camera.near_q8 = (int32_t)fuzz_u32(bytes);
    return camera;
}

bool fuzz_camera_is_legal(const struct lim_camera *camera)
{
    for (int i = 0; i < 3; i++)
        if (llabs((long long)camera->eye_q8[i]) >= 1 << 28) return false;
    return camera->tan_x_q28 >= 1u << 17 && camera->tan_x_q28 <= 1u << 30 && camera->tan_y_q28 >= 1u << 17 &&
           camera->tan_y_q28 <= 1u << 30 && camera->near_q8 >= 1 && camera->near_q8 <= 1 << 24;
}

static int window(void *ctx, const struct lim_rect *window)
{
    (void)ctx;
    (void)window;
    return 0;
}

static const char *check_canvas(const struct canvas *canvas)
{
    const uint16_t unpainted = lim_memory_colour(canvas->unpainted);
    const bool has_any_colour = canvas->scene->limits.layers || canvas->scene->texture_count;

    if (canvas->strayed) return "a pixel beside the picture";
    for (int y = 0; y < FUZZ_SIDE_MAX_PX; y++) {
        for (int x = 0; x < FUZZ_SIDE_MAX_PX; x++) {
            const bool inside = x < canvas->w_px && y < canvas->h_px;
            if (canvas->done[y][x] != inside) return inside ? "a pixel not final once" : "a pixel beside the picture";
            if (!has_any_colour && (canvas->pixels[y][x] == unpainted) == inside)
                return "a pixel not painted, or beside the picture";
        }
    }
    return NULL;
}

/* What a frame is drawn with beside its picture. `by_gaps`: as whatever changes, no pixel painted twice. */
struct way {
    enum lim_method method;
    bool least_memory, by_gaps;
};

/* Where layers run out, lines are painted back to front, and counted so. */
static bool adds_up(const struct lim_stats *stats, uint32_t px, struct way way)
{
    const uint32_t sum = stats->pixels_painted + stats->pixels_background;

    return way.by_gaps ? sum == px : way.method != LIM_NEAREST_FIRST || sum >= px;
}

static const char *check_outcome(const struct fuzz_frame *frame, struct way way, int err, const struct lim_stats *stats,
                                 const struct canvas *canvas)
{
    if (!fuzz_camera_is_legal(&frame->camera))
        return err == LIM_ERR_CAMERA ? NULL : "an illegal camera was not refused";
    if (err != LIM_OK) return "a legal camera was refused";
    if (!frame->scene->limits.layers && !adds_up(stats, (uint32_t)frame->w_px * frame->h_px, way))
        return "pixels painted do not add up";
    return check_canvas(canvas);
}

static bool is_refused_rightly(const struct lim_scene *scene, enum lim_method method, int refused)
{
    const bool is_set = !scene->limits.depth && method != LIM_DEPTH && method != LIM_NEWELL;

    const bool walks_no_tree =
        method == LIM_DEPTH || method == LIM_NEWELL || method == LIM_CONVEX || method >= LIM_MESH;

    return refused == LIM_ERR_SCENE &&
           (scene->limits.vertices > LIM_MAX_VERTICES || is_set || (lim_scene_long(scene) && walks_no_tree));
}

static const char *draw_one(const struct fuzz_frame *frame, const struct core *core, const struct lim_scene *scene,
                            struct way way, struct canvas *canvas)
{
    const struct lim_target target = {.w_px = frame->w_px,
                                      .h_px = frame->h_px,
                                      .format = LIM_RGB565,
                                      .method = way.method,
                                      .ctx = canvas,
                                      .lend = lend,
                                      .done = done,
                                      .window = window,
                                      .costs = {.window_b = 11, .pixel_bits = 16, .page_px = 1, .x_align_px = 1}};
    const size_t mem_b = core->mem_b(scene, &target), delta_b = LIM_DELTA_MEM_B(frame->w_px, frame->h_px, RUNS);
    void *lim = malloc(core->lim_b), *mem = malloc(mem_b), *delta_mem = malloc(delta_b);

    memset(canvas, 0, sizeof *canvas);
    canvas->scene = frame->scene;
    canvas->unpainted = unused_colour(scene);
    canvas->w_px = frame->w_px;
    canvas->h_px = frame->h_px;
    wipe_pixels(&canvas->pixels[0][0], FUZZ_SIDE_MAX_PX * FUZZ_SIDE_MAX_PX, canvas->unpainted);
    const char *broken = NULL;
    const int refused = core->init(lim, scene, &target, mem, mem_b);
    if (refused)
        broken = is_refused_rightly(scene, way.method, refused) ? NULL : "a scene was refused";
    else if (way.by_gaps && core->set_delta(lim, delta_mem, delta_b))
        broken = "memory for changes was refused";
    else
        broken = check_outcome(frame, way, core->frame(lim, &frame->camera), core->stats(lim), canvas);
    free(lim);
    free(mem);
    free(delta_mem);
    return broken;
}

static const char *draw_way(const struct fuzz_frame *frame, const struct core *core, struct way way,
                            struct canvas *canvas)
{
    struct lim_scene scene = *frame->scene;

    if (way.least_memory) scene.limits.retained_cells = scene.limits.gaps = scene.limits.active = 0;
    return draw_one(frame, core, &scene, way, canvas);
}

static size_t count_cores(void)
{
    size_t count = 0;

    while (cores[count])
        count++;
    return count;
}

static const struct way tree_ways[] = {{.method = LIM_PAINTER},
                                       {.method = LIM_NEAREST_FIRST, .least_memory = true},
                                       {.method = LIM_SCANLINE},
                                       {.method = LIM_NEAREST_FIRST},
                                       {.method = LIM_SCANLINE, .least_memory = true},
                                       {.method = LIM_NEAREST_FIRST, .by_gaps = true}};
static const struct way mesh_ways[] = {{.method = LIM_MESH},
                                       {.method = LIM_MESH_DEPTH},
                                       {.method = LIM_MESH, .least_memory = true},
                                       {.method = LIM_MESH_DEPTH, .least_memory = true}};

const char *fuzz_draw(const struct fuzz_frame *frame, uint8_t choice)
{
    const bool is_mesh = lim_scene_is_mesh(frame->scene);
    const struct way *const ways = is_mesh ? mesh_ways : tree_ways;
    const size_t way_count = is_mesh ? sizeof mesh_ways / sizeof *mesh_ways : sizeof tree_ways / sizeof *tree_ways;
    const size_t core_count = count_cores();
    const struct core *core = cores[choice % core_count];
    struct canvas one, other;

    const char *broken = draw_way(frame, core, ways[choice / core_count % way_count], &one);
    if (broken || !frame->is_ordered) return broken;
    broken = draw_way(frame, core, ways[(choice / core_count + 1) % way_count], &other);
    if (broken) return broken;
    return memcmp(&one, &other, sizeof one) ? "another picture by another method or with less memory" : NULL;
}
