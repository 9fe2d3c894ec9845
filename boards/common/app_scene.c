/* SPDX-License-Identifier: MIT
 *
 * Static memory for one scene: the linker says if it does not fit. */
#include "app_scene.h"

#include "text.h"
#include "walker.h"

/* The target's sides: those of the cameras' picture, or exchanged where the camera lies down for a panel that cannot
 * turn it. */
#ifdef SCENE_CAMERA_LIES
#define TARGET_W_PX CAMERAS_H_PX
#define TARGET_H_PX CAMERAS_W_PX
#else
#define TARGET_W_PX CAMERAS_W_PX
#define TARGET_H_PX CAMERAS_H_PX
#endif

/* Outlines, where the scene has some: those that its module shows best, or in the polygons' own colours. */
#ifdef SCENE_MODULE
#include "module.h"
#define SCENE_OUTLINES MODULE_OUTLINES
#else
#define SCENE_OUTLINES                                                                                                 \
    {                                                                                                                  \
        .on = true                                                                                                     \
    }
#endif

/* What the scene asks for. With less, down to lim_mem_min_b(), the same frames take longer. */
#ifndef SCENE_MEM_B
#define SCENE_MEM_B MODEL_SCENE_MEM_B(TARGET_H_PX)
#endif

#define RENDERERS (1 + SCENE_AHEAD)
#define POINTERS(n_b) (((n_b) + sizeof(void *) - 1) / sizeof(void *))

/* Of each renderer. */
static struct lim lim[RENDERERS];
static void *mem[RENDERERS][POINTERS(SCENE_MEM_B)];
static const struct lim_camera *camera_of[RENDERERS]; /* of the frame that was announced */
#if LIM_HAS_DELTA
static void *delta_mem[POINTERS(MODEL_SCENE_DELTA_MEM_B(TARGET_W_PX, TARGET_H_PX))];
#endif
#if LIM_HAS_ANTIALIAS
static uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(TARGET_W_PX) / 4];
#endif

#ifdef MODEL_MOVERS
#ifndef SCENE_FRAMES_PER_S
#define SCENE_FRAMES_PER_S 15
#endif
#ifdef CAMERAS_TIME_MS
#define TIME_MS(frame) CAMERAS_TIME_MS(frame)
#else
#define TIME_MS(frame) (((frame)*UINT32_C(1000) + SCENE_FRAMES_PER_S / 2) / SCENE_FRAMES_PER_S)
#endif
static struct lim_instance instances[RENDERERS][MODEL_MOVERS];
static void *mover_mem[RENDERERS][POINTERS(MODEL_MOVERS_MEM_B)];

static int init_movers(uint8_t which)
{
    const struct lim_movers_limits limits = MODEL_MOVERS_LIMITS;
    const int err = lim_movers_init(&lim[which], mover_mem[which], sizeof mover_mem[which], &limits);

#ifdef MODEL_LIGHT
    const struct lim_light light = MODEL_LIGHT;
    lim_light_set(&lim[which], &light);
#endif
    return err;
}

static void place(uint8_t which, uint16_t frame)
{
    lim_moved_at(model_movers, MODEL_MOVERS, TIME_MS(frame), instances[which]);
}

static int draw_at_once(uint8_t which)
{
    return lim_movers_frame(&lim[which], camera_of[which], instances[which], MODEL_MOVERS);
}

#if SCENE_AHEAD
static int begin(uint8_t which)
{
    return lim_movers_begin(&lim[which], camera_of[which], instances[which], MODEL_MOVERS);
}
#endif
#else
static int init_movers(uint8_t which)
{
    (void)which;
    return 0;
}

static void place(uint8_t which, uint16_t frame)
{
    (void)which, (void)frame;
}

static int draw_at_once(uint8_t which)
{
    return lim_frame(&lim[which], camera_of[which]);
}

#if SCENE_AHEAD
static int begin(uint8_t which)
{
    return lim_frame_begin(&lim[which], camera_of[which]);
}
#endif
#endif

#if LIM_HAS_OVERLAY
/* What `limner render --overlay 'frame #'` shows: white on black, in the middle, an eighth of the height below the
 * upper edge. */
enum { CAPTION_BORDER_PX = 2, CAPTION_H_PX = LIM_TEXT_H_PX - 1 + 2 * CAPTION_BORDER_PX };
enum { CAPTION_Y_PX = TARGET_H_PX / 8 };

static char caption[6 + LIM_TEXT_INTEGER_B] = "frame ";
static uint16_t caption_w_px;

static void draw_caption(void *ctx, const struct lim_overlay_line *line)
{
    const int16_t x_px = (int16_t)((TARGET_W_PX - caption_w_px) / 2);
    const struct lim_overlay_box box = {x_px, CAPTION_Y_PX, (int16_t)caption_w_px, CAPTION_H_PX};
    const struct lim_text_style style = {.colour = 0xFFFF};

    lim_overlay_box(line, &box, 0);
    lim_text(line, (int16_t)(x_px + CAPTION_BORDER_PX), CAPTION_Y_PX + CAPTION_BORDER_PX, ctx, &style);
}

static const struct lim_overlay overlay = {
    .draw = draw_caption, .ctx = caption, .y0_px = CAPTION_Y_PX, .y1_px = CAPTION_Y_PX + CAPTION_H_PX};

static uint16_t frame_of[RENDERERS]; /* that was announced */

static void note_frame(uint8_t which, uint16_t frame)
{
    frame_of[which] = frame;
}

static void set_caption(uint8_t which)
{
    const char *const end = lim_text_integer(caption + 6, frame_of[which]);

    caption_w_px = (uint16_t)((end - caption) * LIM_TEXT_W_PX - 1 + 2 * CAPTION_BORDER_PX);
}
#else
static void note_frame(uint8_t which, uint16_t frame)
{
    (void)which, (void)frame;
}

static void set_caption(uint8_t which)
{
    (void)which;
}
#endif

static int init_renderer(uint8_t which, const struct lim_target *target)
{
    struct lim *const self = &lim[which];
    int err = lim_init(self, &model_scene, target, mem[which], sizeof mem[which]);

#if LIM_HAS_DELTA
    if (!err) err = lim_set_delta(self, delta_mem, sizeof delta_mem);
#endif
#if LIM_HAS_ANTIALIAS
    if (!err) err = lim_set_antialias(self, smooth_mem, sizeof smooth_mem);
#endif
#if LIM_HAS_OVERLAY
    if (!err) lim_set_overlay(self, &overlay);
#endif
    if (LIM_HAS_WIREFRAME && !err) lim_set_wireframe(self, &(const struct lim_wireframe)SCENE_OUTLINES);
    return err ? err : init_movers(which);
}

#if SCENE_AHEAD
/* How far their frames are. */
static enum { DRAWN, ANNOUNCED, BEGUN } phase_of[RENDERERS];
static uint8_t announced, drawn; /* which is next to be announced, to be drawn */

int scene_init(const struct lim_target *target)
{
    announced = drawn = 0;
    phase_of[0] = phase_of[1] = DRAWN;
    const int err = init_renderer(0, target);
    return err ? err : init_renderer(1, target);
}

void scene_announce(uint16_t frame, const struct lim_camera *camera)
{
    camera_of[announced] = camera;
    note_frame(announced, frame);
    phase_of[announced] = ANNOUNCED;
    place(announced, frame);
    announced = !announced;
}

/* A camera out of range is told when the frame is drawn. */
bool scene_work(void *ctx)
{
    const uint8_t next = !drawn;

    (void)ctx;
    if (phase_of[next] == BEGUN) return lim_frame_work(&lim[next]);
    if (phase_of[next] == DRAWN || begin(next)) return false;
    phase_of[next] = BEGUN;
    return true;
}

int scene_draw(void)
{
    set_caption(drawn);
    const int err = phase_of[drawn] == BEGUN ? lim_frame_paint(&lim[drawn]) : draw_at_once(drawn);

    phase_of[drawn] = DRAWN;
    drawn = !drawn;
    return err;
}
#else
int scene_init(const struct lim_target *target)
{
    return init_renderer(0, target);
}

void scene_announce(uint16_t frame, const struct lim_camera *camera)
{
    camera_of[0] = camera;
    note_frame(0, frame);
    place(0, frame);
}

bool scene_work(void *ctx)
{
    (void)ctx;
    return false;
}

int scene_draw(void)
{
    set_caption(0);
    return draw_at_once(0);
}
#endif

#if LIM_HAS_DELTA
void scene_refresh(void)
{
    for (uint8_t which = 0; which < RENDERERS; which++)
        lim_refresh(&lim[which]);
}
#else
void scene_refresh(void) {}
#endif

#if BOARD_WALLS && defined(MODEL_SCENE_DEPTH)
static lim_index way_down[MODEL_SCENE_DEPTH];
static struct lim_solid solid;

const struct lim_solid *scene_solid(void)
{
    return lim_solid_init(&solid, &model_scene, way_down, sizeof way_down) ? NULL : &solid;
}
#else
const struct lim_solid *scene_solid(void)
{
    return NULL;
}
#endif

void scene_camera(uint16_t frame, struct lim_camera *camera)
{
    *camera = cameras[frame];
}

__attribute__((noinline)) void frame_begin(uint16_t frame)
{
    __asm__ volatile("" ::"r"(frame));
}

__attribute__((noinline)) void frame_end(uint16_t frame)
{
    __asm__ volatile("" ::"r"(frame));
}
