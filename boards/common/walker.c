/* SPDX-License-Identifier: MIT */
#include "walker.h"

#include "board.h"
#include "camera.h"
#include "eye.h"

#define TURN_STEP (UINT32_C(1) << (BOARD_PLAYER ? 26 : 24))
enum { BOARD_WALK = BOARD_UP | BOARD_DOWN | BOARD_LEFT | BOARD_RIGHT };

/* A step, in quarters of the near plane's distance. */
enum { STRIDE_QUARTERS = BOARD_PLAYER ? 10 : 1 };

/* Of its body, in distances of the near plane: to each side of the eye, and over it; gravity is a fourth part of one.
 */
enum { BODY_NEARS = BOARD_PLAYER ? 5 : 2, HEAD_NEARS = BOARD_PLAYER ? 4 : 2, FLOOR_NEARS = 32, GRAVITY_PARTS = 4 };
#define BODY_NEAR_MAX_Q8 (LIM_HALF_MAX_Q8 / (2 * BODY_NEARS))

/* How high it climbs, in twentieths of the eye's height. */
enum { CLIMB_TWENTIETHS = BOARD_PLAYER ? 12 : 5 };

/* What stops it, if its body is not too large to be stopped. */
static const struct lim_solid *solid_of(const struct walker *walker)
{
    return BOARD_WALLS && walker->camera.near_q8 <= BODY_NEAR_MAX_Q8 ? walker->body->solid : NULL;
}

/* How far below the eye a floor may be: with what is above it a body may not be too high. */
static int32_t floor_below(int32_t near_q8)
{
    const int32_t most_q8 = 2 * LIM_HALF_MAX_Q8 - HEAD_NEARS * near_q8;

    return near_q8 < most_q8 / FLOOR_NEARS ? FLOOR_NEARS * near_q8 : most_q8;
}

/* Where the path left it: on a floor, or floating. */
static void begin_walk(struct walker *walker, const struct lim_camera *camera)
{
    const int32_t near_q8 = camera->near_q8;
    struct lim_hit floor;

    walker->camera = *camera;
    if (!solid_of(walker)) return;
    walker->body->eye_q8 = 0;
    const int32_t below_q8[3] = {camera->eye_q8[0], camera->eye_q8[1] - floor_below(near_q8), camera->eye_q8[2]};
    if (lim_trace(walker->body->solid, camera->eye_q8, below_q8, 0, &floor) != 1) return;
    const int32_t eye_q8 = camera->eye_q8[1] - floor.at_q8[1] - LIM_SKIN_Q8;
    if (eye_q8 <= near_q8) return;
    walker->body->eye_q8 = eye_q8;
    walker->body->feet =
        (struct lim_walker){.at_q8 = {camera->eye_q8[0], camera->eye_q8[1] - eye_q8, camera->eye_q8[2]},
                            .radius_q8 = BODY_NEARS * near_q8,
                            .height_q8 = eye_q8 + HEAD_NEARS * near_q8,
                            .step_q8 = eye_q8 * CLIMB_TWENTIETHS / 20,
                            .gravity_q8 = near_q8 / GRAVITY_PARTS};
}

/* A step that would leave the renderer's range is not made. */
static void go_through_walls(struct lim_camera *camera, int32_t x_q8, int32_t z_q8)
{
    if (abs_s32(camera->eye_q8[0] + x_q8) >= LIM_EYE_MAX_Q8 || abs_s32(camera->eye_q8[2] + z_q8) >= LIM_EYE_MAX_Q8)
        return;
    camera->eye_q8[0] += x_q8;
    camera->eye_q8[2] += z_q8;
}

/* Where no body may be, far outside, nothing stops it. */
static void float_on(struct walker *walker, int32_t x_q8, int32_t z_q8)
{
    const int32_t side_q8 = BODY_NEARS * walker->camera.near_q8;
    const int32_t half_q8[3] = {side_q8, side_q8, side_q8}, way_q8[3] = {x_q8, 0, z_q8};

    if (lim_slide(walker->body->solid, half_q8, walker->camera.eye_q8, way_q8, 0) < 0)
        go_through_walls(&walker->camera, x_q8, z_q8);
}

/* Who leaves the range of bodies, as by falling out of the scene, floats from then on. */
static void go_on_foot(struct walker *walker, int32_t x_q8, int32_t z_q8)
{
    if (lim_walker_move(walker->body->solid, &walker->body->feet, x_q8, z_q8)) {
        walker->body->eye_q8 = 0;
        return;
    }
    for (uint_fast8_t i = 0; i < 3; i++)
        walker->camera.eye_q8[i] = walker->body->feet.at_q8[i] + (i == 1 ? walker->body->eye_q8 : 0);
}

static void go(struct walker *walker, int32_t step_q8)
{
    struct lim_camera *const camera = &walker->camera;
    const int32_t x_q8 = -lim_mul_q30(lim_sin_q30(camera->yaw), step_q8);
    const int32_t z_q8 = -lim_mul_q30(lim_cos_q30(camera->yaw), step_q8);

    if (!solid_of(walker))
        go_through_walls(camera, x_q8, z_q8);
    else if (walker->body->eye_q8)
        go_on_foot(walker, x_q8, z_q8);
    else
        float_on(walker, x_q8, z_q8);
}

/* Without a button it falls. */
static void step(struct walker *walker, uint8_t pressed)
{
    const int32_t step_q8 = walker->camera.near_q8 / 4 * STRIDE_QUARTERS;
    const int32_t steps = ((pressed & BOARD_UP) != 0) - ((pressed & BOARD_DOWN) != 0);

    if (pressed & BOARD_LEFT) walker->camera.yaw += TURN_STEP;
    if (pressed & BOARD_RIGHT) walker->camera.yaw -= TURN_STEP;
    if (steps || (solid_of(walker) && walker->body->eye_q8)) go(walker, steps * step_q8);
}

void walker_frame(struct walker *walker, uint8_t buttons, struct lim_camera *camera)
{
    walker->released = (uint8_t)(walker->released | ~(unsigned)buttons);
    const uint8_t pressed = buttons & walker->released;

    if (pressed & BOARD_SELECT) {
        walker->walking = false;
    } else if (pressed & BOARD_WALK && !walker->walking) {
        begin_walk(walker, camera);
        walker->walking = true;
    }
    if (!walker->walking) return;
    step(walker, pressed);
    *camera = walker->camera;
}
