/* SPDX-License-Identifier: MIT
 *
 * From every camera of a list rays in eight directions, and from the floor below a walker's moves in the same, each
 * between the marks of a frame. Prints a line for each: `ray` or `move`, what the function returned, and a sum of what
 * it found, which is the same on every processor. Compiled for a scene and its cameras, as frames.c is; lengths are
 * metres. Exit status 0, or 1 when something is refused. */
#include "app_scene.h"
#include "collide.h"
#include "console.h"
#include "eye.h"

#ifndef WALKS_EYE_M
#define WALKS_EYE_M 1.6
#define WALKS_RADIUS_M 0.25
#define WALKS_STEP_M 0.4
#endif
#define WALKS_HEIGHT_M 1.75
#define WALKS_STRIDE_M 0.25
#define WALKS_FAR_M 20.0
enum { DIRECTIONS = 8 };

static lim_index way_down[MODEL_SCENE_DEPTH];
static struct lim_solid solid;
static uint16_t counted;

int main(void);

static void put_number(uint32_t number, const char *after)
{
    char digits[11];
    uint8_t at = sizeof digits - 1;

    digits[at] = 0;
    do
        digits[--at] = (char)('0' + number % 10);
    while (number /= 10);
    console_put(&digits[at]);
    console_put(after);
}

static uint32_t sum_of(const int32_t at_q8[3])
{
    return (uint32_t)at_q8[0] + (uint32_t)at_q8[1] * 3u + (uint32_t)at_q8[2] * 7u;
}

static void way_of(uint32_t yaw, int32_t length_q8, int32_t way_q8[3])
{
    way_q8[0] = -lim_mul_q30(lim_sin_q30(yaw), length_q8);
    way_q8[1] = 0;
    way_q8[2] = -lim_mul_q30(lim_cos_q30(yaw), length_q8);
}

static int cast(const struct lim_camera *camera, uint32_t yaw)
{
    struct lim_hit hit = {.record = 0};
    int32_t to_q8[3];

    way_of(yaw, MODEL_M_Q8(WALKS_FAR_M), to_q8);
    for (uint8_t i = 0; i < 3; i++)
        to_q8[i] += camera->eye_q8[i];
    frame_begin(counted);
    const int met = lim_trace(&solid, camera->eye_q8, to_q8, 0, &hit);
    frame_end(counted++);
    console_put("ray ");
    put_number((uint32_t)met, " ");
    put_number(met ? sum_of(hit.at_q8) + hit.part_q30 + hit.record : 0, "\n");
    return met < 0;
}

/* Where the floor below the eye is. */
static bool stand(const struct lim_camera *camera, struct lim_walker *walker)
{
    const int32_t below_q8[3] = {camera->eye_q8[0], camera->eye_q8[1] - 2 * MODEL_M_Q8(WALKS_EYE_M), camera->eye_q8[2]};
    struct lim_hit floor;

    *walker = (struct lim_walker){.radius_q8 = MODEL_M_Q8(WALKS_RADIUS_M),
                                  .height_q8 = MODEL_M_Q8(WALKS_HEIGHT_M),
                                  .step_q8 = MODEL_M_Q8(WALKS_STEP_M),
                                  .gravity_q8 = LIM_SKIN_Q8,
                                  .stands = true};
    if (lim_trace(&solid, camera->eye_q8, below_q8, 0, &floor) != 1) return false;
    for (uint8_t i = 0; i < 3; i++)
        walker->at_q8[i] = floor.at_q8[i] + (i == 1 ? LIM_SKIN_Q8 : 0);
    return true;
}

static int move(const struct lim_walker *from, uint32_t yaw)
{
    struct lim_walker walker = *from;
    int32_t way_q8[3];

    way_of(yaw, MODEL_M_Q8(WALKS_STRIDE_M), way_q8);
    frame_begin(counted);
    const int err = lim_walker_move(&solid, &walker, way_q8[0], way_q8[2]);
    frame_end(counted++);
    console_put("move ");
    put_number((uint32_t)-err, " ");
    put_number(sum_of(walker.at_q8), walker.stands ? " stands\n" : " falls\n");
    return err;
}

static int walk_from(const struct lim_camera *camera)
{
    struct lim_walker walker;
    int err = 0;

    for (uint8_t i = 0; i < DIRECTIONS && !err; i++)
        err = cast(camera, camera->yaw + i * (UINT32_C(1) << 29));
    if (err || !stand(camera, &walker)) return err;
    for (uint8_t i = 0; i < DIRECTIONS && !err; i++)
        err = move(&walker, camera->yaw + i * (UINT32_C(1) << 29));
    return err;
}

int main(void)
{
    int err = lim_solid_init(&solid, &model_scene, way_down, sizeof way_down);

    for (uint16_t frame = 0; frame < CAMERAS_COUNT && !err; frame++) {
        struct lim_camera camera;
        scene_camera(frame, &camera);
        err = walk_from(&camera);
    }
    return err != 0;
}
