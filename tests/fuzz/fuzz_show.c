/* SPDX-License-Identifier: MIT */
#include "fuzz_show.h"

#include "colour.h"
#include "core/core.h"
#include "overlay.h"
#include "rigs/unpainted.h"
#include "text.h"

#include <stdlib.h>
#include <string.h>

enum { METHODS = LIM_NEWELL + 1, PAGE_PX = 8, EFFORT_MOST = 64 };

static unsigned count_profiles(void)
{
    unsigned count = 0;

    while (cores[count])
        count++;
    return count;
}

struct fuzz_look fuzz_look_from(struct fuzz_bytes *bytes)
{
    struct fuzz_look look = {.core = cores[fuzz_below(bytes, count_profiles())], .method = fuzz_below(bytes, METHODS)};
    const uint8_t flags = fuzz_u8(bytes);

    look.wireframe = (struct lim_wireframe){flags & 1, flags & 2, fuzz_u16(bytes), fuzz_u16(bytes)};
    look.antialias = flags & 4;
    look.is_round = flags & 8;
    look.newell = (struct lim_newell_options){.planes_first = flags & 16, .split_one = flags & 32};
    if (flags & 64) look.newell.most = 1 + look.wireframe.colour % EFFORT_MOST;
    look.refreshes = flags & 128;
    if (!look.wireframe.on) look.overlay = look.wireframe.background;
    if (look.method == LIM_CONVEX || look.method == LIM_PAINTER) look.antialias = look.is_round = false;
    return look;
}

static struct fuzz_means fuzz_means_from(struct fuzz_bytes *bytes)
{
    static const uint8_t pages_px[] = {0, 1, PAGE_PX};
    struct fuzz_means means = {.sink = fuzz_below(bytes, FUZZ_SINKS), .memory = fuzz_u8(bytes)};

    means.quanta = fuzz_u8(bytes);
    means.page_px = pages_px[fuzz_below(bytes, sizeof pages_px)];
    means.runs = fuzz_u8(bytes);
    means.fails_at = fuzz_u8(bytes);
    if (means.sink == FUZZ_SINK_RUNS) means.page_px = 0;
    return means;
}

void fuzz_means_both_from(struct fuzz_bytes *bytes, struct fuzz_means means[2])
{
    for (int i = 0; i < 2; i++)
        means[i] = fuzz_means_from(bytes);
}

static bool sorts(enum lim_method method)
{
    return method == LIM_DEPTH || method == LIM_NEWELL;
}

/* What lies over frames: a box and a text, anywhere and elsewhere in the second one. */
struct over {
    struct lim_overlay overlay;
    int16_t x_px, y_px;
    uint8_t scale;
};

static lim_overlay_draw draw_over;

static void draw_over(void *ctx, const struct lim_overlay_line *line)
{
    const struct over *over = ctx;
    const struct lim_text_style style = {.colour = 0xFFFF, .solid = over->scale & 1, .scale = over->scale};

    lim_overlay_box(line, &(const struct lim_overlay_box){over->y_px, over->x_px, 9, 7}, 0);
    lim_text(line, over->x_px, over->y_px, "Fuzz", &style);
}

static void place_over(struct over *over, uint16_t seed, uint16_t h_px, int frame)
{
    over->x_px = (int16_t)((seed & 63) - 20 + 3 * frame);
    over->y_px = (int16_t)((seed >> 6 & 63) - 10 + (seed >> 15) * frame);
    over->scale = (uint8_t)(seed >> 12 & 3);
    over->overlay = (struct lim_overlay){.draw = draw_over, .ctx = over, .y0_px = seed >> 14, .y1_px = h_px};
    if (seed & 1) over->overlay.y1_px = (uint16_t)(h_px / 2 + frame);
}

/* A renderer in a show, and its memory: to the byte, so that a sanitizer sees every step beyond it. */
struct stage {
    const struct fuzz_subject *subject;
    const struct fuzz_look *look;
    const struct fuzz_means *means;
    const struct core *core;
    struct fuzz_panel panel;
    struct lim_scene scene;
    void *lim, *mem, *delta_mem, *smooth_mem, *mover_mem;
    struct over over;
    uint16_t unpainted;
};

static bool is_refused_rightly(const struct stage *stage)
{
    const struct lim_scene *scene = &stage->scene;
    const enum lim_method method = stage->look->method;
    if (lim_scene_is_mesh(scene)) return method != LIM_MESH && method != LIM_MESH_DEPTH;
    const bool has_leaf = scene->nodes[scene->node_count - 1].split.plane == LIM_NO_INDEX;
    const bool is_chain = scene->limits.depth == scene->node_count && !has_leaf && !scene->limits.layers;

    return scene->limits.vertices > LIM_MAX_VERTICES || (!scene->limits.depth && !sorts(method)) ||
           (method == LIM_CONVEX && (!is_chain || lim_scene_long(scene)));
}

static const char *start_options(struct stage *stage)
{
    const struct fuzz_look *look = stage->look;
    const uint16_t w_px = stage->panel.target.w_px, h_px = stage->panel.target.h_px;
    const size_t delta_b = LIM_DELTA_MEM_B(w_px, h_px, stage->means->runs + 1u), smooth_b = LIM_ANTIALIAS_MEM_B(w_px);

    if (look->wireframe.on) stage->core->set_wireframe(stage->lim, &look->wireframe);
    if (look->method == LIM_NEWELL) stage->core->newell(stage->lim, &look->newell);
    if (look->antialias) {
        stage->smooth_mem = malloc(smooth_b);
        if (stage->core->set_antialias(stage->lim, stage->smooth_mem, smooth_b)) return "antialiasing was refused";
    }
    if (stage->means->page_px) {
        stage->delta_mem = malloc(delta_b);
        if (stage->core->set_delta(stage->lim, stage->delta_mem, delta_b)) return "memory for changes was refused";
    }
    return NULL;
}

static const char *start_movers(struct stage *stage)
{
    const struct fuzz_subject *subject = stage->subject;

    if (!subject->instances[0]) return NULL;
    const size_t mem_b = stage->core->movers_mem_b(&stage->scene, &subject->limits);
    stage->mover_mem = malloc(mem_b);
    if (stage->core->movers_init(stage->lim, stage->mover_mem, mem_b, &subject->limits))
        return "memory for movers was refused";
    stage->core->light(stage->lim, &subject->light);
    return NULL;
}

static const char *start(struct stage *stage, bool *is_refused)
{
    const struct lim_target *target = &stage->panel.target;
    const size_t least_b = stage->core->mem_min_b(&stage->scene, target);
    const size_t most_b = stage->core->mem_b(&stage->scene, target);

    if (most_b < least_b) return "a scene asks for less than the least";
    const size_t mem_b = least_b + (most_b - least_b) * stage->means->memory / 255;
    stage->lim = malloc(stage->core->lim_b);
    stage->mem = malloc(mem_b);
    const int err = stage->core->init(stage->lim, &stage->scene, target, stage->mem, mem_b);
    *is_refused = err != LIM_OK;
    if (err) return err == LIM_ERR_SCENE && is_refused_rightly(stage) ? NULL : "a scene was refused";
    if (is_refused_rightly(stage)) return "a scene was taken that the method cannot draw";
    const char *broken = start_movers(stage);
    return broken ? broken : start_options(stage);
}

static int draw(struct stage *stage, int frame)
{
    const struct fuzz_subject *subject = stage->subject;
    const struct lim_camera *camera = &subject->cameras[frame];
    const struct lim_instance *instances = subject->instances[frame];
    const uint16_t count = instances ? subject->instance_count : 0;

    if (!stage->means->quanta)
        return count ? stage->core->movers_frame(stage->lim, camera, instances, count)
                     : stage->core->frame(stage->lim, camera);
    const int err = stage->core->begin(stage->lim, camera, instances, count);
    if (err) return err;
    for (unsigned i = 0; i < stage->means->quanta && stage->core->work(stage->lim); i++)
        continue;
    return stage->core->paint(stage->lim);
}

/* Mixed colours, and those of textures, may be the one that stands for unpainted. */
static bool shows_what_is_painted(const struct stage *stage)
{
    return !stage->scene.limits.layers && !stage->scene.texture_count && !stage->look->antialias &&
           !stage->subject->light.on;
}

static const char *draw_frame(struct stage *stage, int frame)
{
    fuzz_panel_begin(&stage->panel, lim_memory_colour(stage->unpainted), frame == 0 ? stage->means->fails_at : 0);
    if (stage->look->overlay) {
        place_over(&stage->over, stage->look->overlay, stage->panel.target.h_px, frame);
        stage->core->set_overlay(stage->lim, &stage->over.overlay);
    }
    if (frame && stage->look->refreshes) stage->core->refresh(stage->lim);
    const int err = draw(stage, frame);
    if (stage->panel.broken) return stage->panel.broken;
    if (stage->panel.failed)
        return err == FUZZ_PANEL_ERROR || err == LIM_ERR_TARGET ? NULL : "a target's error did not come through";
    if (err) return "a frame was refused";
    return fuzz_panel_check(&stage->panel, shows_what_is_painted(stage));
}

/* Of no polygon, of no object's, and of no outline. */
static uint16_t unused_colour_of(const struct stage *stage)
{
    const struct fuzz_subject *subject = stage->subject;
    const struct lim_wireframe *wireframe = &stage->look->wireframe;
    uint16_t colour = 0x5A5A;

    for (bool is_used = true; is_used; colour++) {
        is_used =
            colour_is_used(&stage->scene, colour) || wireframe->colour == colour || wireframe->background == colour;
        for (int frame = 0; frame < FUZZ_FRAMES && subject->instances[frame]; frame++)
            for (uint16_t i = 0; i < subject->instance_count; i++) {
                const struct lim_scene *object = subject->instances[frame][i].object;
                is_used = is_used || (object && colour_is_used(object, colour));
            }
    }
    return (uint16_t)(colour - 1);
}

const char *fuzz_show(const struct fuzz_subject *subject, const struct fuzz_look *look, const struct fuzz_means *means,
                      struct fuzz_pictures *pictures, bool *is_refused)
{
    struct stage stage = {
        .subject = subject, .look = look, .means = means, .core = look->core, .scene = *subject->scene};
    const bool takes_runs = look->method == LIM_CONVEX && !subject->scene->texture_count;
    const enum fuzz_sink sink = means->sink == FUZZ_SINK_RUNS && !takes_runs ? FUZZ_SINK_LINES : means->sink;
    const char *broken;

    fuzz_panel_init(&stage.panel, subject->w_px, subject->h_px, sink, look->is_round, means->page_px);
    stage.panel.target.method = look->method;
    stage.unpainted = unused_colour_of(&stage);
    broken = start(&stage, is_refused);
    for (int frame = 0; !broken && !*is_refused && frame < FUZZ_FRAMES; frame++) {
        broken = draw_frame(&stage, frame);
        pictures->panels[frame] = stage.panel;
        pictures->is_shown[frame] = !stage.panel.failed;
    }
    fuzz_panel_free(&stage.panel);
    free(stage.lim);
    free(stage.mem);
    free(stage.delta_mem);
    free(stage.smooth_mem);
    free(stage.mover_mem);
    return broken;
}

const char *fuzz_show_both(const struct fuzz_subject *of, const struct fuzz_look *look,
                           const struct fuzz_means means[2])
{
    static struct fuzz_pictures pictures[2];
    struct fuzz_subject subject = *of;
    bool is_refused = false;

    if (means[0].page_px == PAGE_PX || means[1].page_px == PAGE_PX)
        subject.h_px = (uint16_t)((subject.h_px + PAGE_PX - 1) / PAGE_PX * PAGE_PX);
    for (int i = 0; i < 2; i++) {
        const char *broken = fuzz_show(&subject, look, &means[i], &pictures[i], &is_refused);
        if (broken || is_refused) return broken;
    }
    for (int frame = 0; frame < FUZZ_FRAMES; frame++)
        if (pictures[0].is_shown[frame] && pictures[1].is_shown[frame] &&
            !fuzz_panel_is_same(&pictures[0].panels[frame], &pictures[1].panels[frame]))
            return "another picture by other means";
    return NULL;
}
