/* SPDX-License-Identifier: MIT
 *
 * Static memory for one scene: the linker says if it does not fit. */
#include "app_scene.h"

/* The target's sides: those of the cameras' picture, or exchanged where the camera lies down for a panel that cannot
 * turn it. */
#ifdef SCENE_CAMERA_LIES
#define TARGET_W_PX CAMERAS_H_PX
#define TARGET_H_PX CAMERAS_W_PX
#else
#define TARGET_W_PX CAMERAS_W_PX
#define TARGET_H_PX CAMERAS_H_PX
#endif

/* What the scene asks for. With less, down to lim_mem_min_b(), the same frames take longer. */
#ifndef SCENE_MEM_B
#define SCENE_MEM_B MODEL_SCENE_MEM_B(TARGET_H_PX)
#endif

#define POINTERS(n_b) (((n_b) + sizeof(void *) - 1) / sizeof(void *))

static struct lim lim;
static uint32_t mem[SCENE_MEM_B / 4];
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
#ifdef CAMERAS_LENGTH_MS
#define TIME_MS(frame) ((frame)*UINT32_C(CAMERAS_LENGTH_MS) / CAMERAS_COUNT)
#else
#define TIME_MS(frame) (((frame)*UINT32_C(1000) + SCENE_FRAMES_PER_S / 2) / SCENE_FRAMES_PER_S)
#endif
static struct lim_instance instances[MODEL_MOVERS];
static void *mover_mem[POINTERS(MODEL_MOVERS_MEM_B)];

static int init_movers(void)
{
    const struct lim_movers_limits limits = MODEL_MOVERS_LIMITS;
    const int err = lim_movers_init(&lim, mover_mem, sizeof mover_mem, &limits);

#ifdef MODEL_LIGHT
    const struct lim_light light = MODEL_LIGHT;
    lim_light_set(&lim, &light);
#endif
    return err;
}

void scene_place(uint16_t frame)
{
    lim_moved_at(model_movers, MODEL_MOVERS, TIME_MS(frame), instances);
}

int scene_draw(const struct lim_camera *camera)
{
    return lim_movers_frame(&lim, camera, instances, MODEL_MOVERS);
}
#else
static int init_movers(void)
{
    return 0;
}

void scene_place(uint16_t frame)
{
    (void)frame;
}

int scene_draw(const struct lim_camera *camera)
{
    return lim_frame(&lim, camera);
}
#endif

int scene_init(const struct lim_target *target)
{
    int err = lim_init(&lim, &model_scene, target, mem, sizeof mem);

#if LIM_HAS_DELTA
    if (!err) err = lim_set_delta(&lim, delta_mem, sizeof delta_mem);
#endif
#if LIM_HAS_ANTIALIAS
    if (!err) err = lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem);
#endif
    if (LIM_HAS_WIREFRAME && !err) lim_set_wireframe(&lim, &(const struct lim_wireframe){.on = true});
    return err ? err : init_movers();
}

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
