/* SPDX-License-Identifier: MIT
 *
 * Memory is taken from the heap to the byte, so that a sanitizer sees every step beyond it. */
#include "fuzz_frame.h"

#include "core.h"

#include <stdlib.h>
#include <string.h>

/* No colour of an ordered scene, in either byte order; a file's may be any. */
enum { UNPAINTED = 0x5A5A };

struct canvas {
    uint16_t w_px, h_px;
    uint16_t pixels[FUZZ_SIDE_MAX_PX][FUZZ_SIDE_MAX_PX];
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
    struct lim_camera camera;

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
    return camera->tan_x_q28 >= 1u << 22 && camera->tan_x_q28 <= 1u << 30 && camera->tan_y_q28 >= 1u << 22 &&
           camera->tan_y_q28 <= 1u << 30 && camera->near_q8 >= 1 && camera->near_q8 <= 1 << 24;
}

static const char *check_canvas(const struct canvas *canvas, bool has_any_colour)
{
    if (canvas->strayed) return "a pixel beside the picture";
    for (int y = 0; y < FUZZ_SIDE_MAX_PX; y++) {
        for (int x = 0; x < FUZZ_SIDE_MAX_PX; x++) {
            const bool inside = x < canvas->w_px && y < canvas->h_px;
            if (canvas->done[y][x] != inside) return inside ? "a pixel not final once" : "a pixel beside the picture";
            if (!has_any_colour && (canvas->pixels[y][x] == UNPAINTED) == inside)
                return "a pixel not painted, or beside the picture";
        }
    }
    return NULL;
}

static const char *check_outcome(const struct fuzz_frame *frame, enum lim_method method, int err,
                                 const struct lim_stats *stats, const struct canvas *canvas)
{
    if (!fuzz_camera_is_legal(&frame->camera))
        return err == LIM_ERR_CAMERA ? NULL : "an illegal camera was not refused";
    if (err != LIM_OK) return "a legal camera was refused";
    /* Where layers run out, lines are painted back to front, and counted so. */
    if (method == LIM_NEAREST_FIRST && !frame->scene->limits.layers &&
        stats->pixels_painted + stats->pixels_background < (uint32_t)frame->w_px * frame->h_px)
        return "pixels painted do not add up";
    return check_canvas(canvas, !frame->is_ordered);
}

static bool is_refused_rightly(const struct lim_scene *scene, enum lim_method method, int refused)
{
    const bool is_set = !scene->limits.depth && method != LIM_DEPTH && method != LIM_NEWELL;

    return refused == LIM_ERR_SCENE && (scene->limits.vertices > LIM_MAX_VERTICES || is_set);
}

static const char *draw_one(const struct fuzz_frame *frame, const struct core *core, const struct lim_scene *scene,
                            enum lim_method method, struct canvas *canvas)
{
    const struct lim_target target = {.w_px = frame->w_px,
                                      .h_px = frame->h_px,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = canvas,
                                      .lend = lend,
                                      .done = done};
    const size_t mem_b = core->mem_b(scene, &target);
    void *lim = malloc(core->lim_b), *mem = malloc(mem_b);

    memset(canvas, 0, sizeof *canvas);
    memset(canvas->pixels, UNPAINTED & 0xFF, sizeof canvas->pixels);
    canvas->w_px = frame->w_px;
    canvas->h_px = frame->h_px;
    const char *broken = NULL;
    const int refused = core->init(lim, scene, &target, mem, mem_b);
    if (refused)
        broken = is_refused_rightly(scene, method, refused) ? NULL : "a scene was refused";
    else
        broken = check_outcome(frame, method, core->frame(lim, &frame->camera), core->stats(lim), canvas);
    free(lim);
    free(mem);
    return broken;
}

/* What a frame is drawn with beside its picture. */
struct way {
    enum lim_method method;
    bool least_memory;
};

static const char *draw_way(const struct fuzz_frame *frame, const struct core *core, struct way way,
                            struct canvas *canvas)
{
    struct lim_scene scene = *frame->scene;

    if (way.least_memory) scene.limits.retained_cells = scene.limits.gaps = scene.limits.active = 0;
    return draw_one(frame, core, &scene, way.method, canvas);
}

static size_t count_cores(void)
{
    size_t count = 0;

    while (cores[count])
        count++;
    return count;
}

const char *fuzz_draw(const struct fuzz_frame *frame, uint8_t choice)
{
    static const struct way ways[] = {{LIM_PAINTER, false},
                                      {LIM_NEAREST_FIRST, true},
                                      {LIM_SCANLINE, false},
                                      {LIM_NEAREST_FIRST, false},
                                      {LIM_SCANLINE, true}};
    const size_t core_count = count_cores(), way_count = sizeof ways / sizeof *ways;
    const struct core *core = cores[choice % core_count];
    struct canvas one, other;

    const char *broken = draw_way(frame, core, ways[choice / core_count % way_count], &one);
    if (broken || !frame->is_ordered) return broken;
    broken = draw_way(frame, core, ways[(choice / core_count + 1) % way_count], &other);
    if (broken) return broken;
    return memcmp(&one, &other, sizeof one) ? "another picture by another method or with less memory" : NULL;
}
