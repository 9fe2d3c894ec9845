/* SPDX-License-Identifier: MIT
 *
 * The camera is kept as the renderer has it, so that an hour of turning does not drift. */
#include "cli/fly.h"

#include "long.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

const char FLY_HELP[] = "w s a d: move, r f: up and down, arrows: turn and look, x: through walls or not, q: quit";

static const double EYE_END_Q8 = 268435456.0;      /* 2^28, exclusive */
static const uint32_t TURN_STEP = 1u << 25;        /* 1/128 of a full turn */
static const int32_t PITCH_MAX = INT32_C(1) << 30; /* a quarter turn */
static const double RADIANS = 6.283185307179586476925 / 4294967296.0;

/* A box that the near plane's corners are in, and more. */
static void set_body(struct flight *flight)
{
    const int32_t near_q8 = flight->camera.near_q8;
    for (int i = 0; i < 3; i++)
        flight->half_q8[i] = near_q8 < LIM_HALF_MAX_Q8 / 2 ? 2 * near_q8 : LIM_HALF_MAX_Q8;
}

/* Without a tree there is nothing to be stopped by. */
static bool set_walls(struct flight *flight, const struct lim_scene *scene, struct error *err)
{
    const size_t mem_b = scene->limits.depth * sizeof *flight->stack;
    if (lim_scene_is_mesh(scene) || lim_scene_long(scene)) return true;
    flight->stack = malloc(mem_b + 1);
    return (flight->stack && !lim_solid_init(&flight->solid, scene, flight->stack, mem_b)) ||
           error_set(err, "out of memory");
}

bool flight_init(struct flight *flight, struct simulator *simulator, const struct lim_scene *scene,
                 const struct lim_camera *camera, const struct grid *grid, struct moving *moving, struct error *err)
{
    const double longest_side_units = grid->is_long ? 2.0 * LIM_LONG_END : 65534.0;
    double step_units = fmin(0.1 * grid->units_per_m, longest_side_units / 100.0);
    *flight = (struct flight){.simulator = simulator,
                              .camera = *camera,
                              .step_q8 = fmax(1.0, round(step_units * 256.0)),
                              .is_long = grid->is_long,
                              .moving = moving};
    set_body(flight);
    return set_walls(flight, scene, err);
}

void flight_free(struct flight *flight)
{
    free(flight->stack);
}

static double now_s(void)
{
    struct timespec now = {0};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

bool flight_frame(struct flight *flight, struct error *err)
{
    if (!flight->began) flight->began_s = now_s();
    if (flight->moving) moving_pose(flight->moving, flight->began ? now_s() - flight->began_s : 0.0);
    flight->began = true;
    return simulator_frame(flight->simulator, &flight->camera, err);
}

static void move(struct flight *flight, const double direction[3])
{
    double eye_q8[3];
    int32_t way_q8[3];
    for (int i = 0; i < 3; i++) {
        eye_q8[i] = round(flight->camera.eye_q8[i] + flight->step_q8 * direction[i]);
        if (!(fabs(eye_q8[i]) < EYE_END_Q8)) return;
        way_q8[i] = (int32_t)eye_q8[i] - flight->camera.eye_q8[i];
    }
    if (flight->stack && !flight->through_walls &&
        lim_slide(&flight->solid, flight->half_q8, flight->camera.eye_q8, way_q8, 0) >= 0)
        return;
    for (int i = 0; i < 3; i++)
        flight->camera.eye_q8[i] = (int32_t)eye_q8[i];
    if (flight->is_long) lim_camera_carry(&flight->camera);
}

static void look(struct flight *flight, int32_t step)
{
    int64_t pitch = (int64_t)(int32_t)flight->camera.pitch + step;
    if (pitch >= -PITCH_MAX && pitch <= PITCH_MAX) flight->camera.pitch = (uint32_t)pitch;
}

void flight_key(struct flight *flight, enum fly_key key)
{
    const double yaw = flight->camera.yaw * RADIANS, pitch = (int32_t)flight->camera.pitch * RADIANS;
    const double forward[3] = {-sin(yaw) * cos(pitch), sin(pitch), -cos(yaw) * cos(pitch)};
    const double right[3] = {cos(yaw), 0.0, -sin(yaw)};
    switch (key) {
    case FLY_FORWARD:
        move(flight, forward);
        break;
    case FLY_BACK:
        move(flight, (double[3]){-forward[0], -forward[1], -forward[2]});
        break;
    case FLY_LEFT:
        move(flight, (double[3]){-right[0], 0.0, -right[2]});
        break;
    case FLY_RIGHT:
        move(flight, right);
        break;
    case FLY_UP:
        move(flight, (double[3]){0.0, 1.0, 0.0});
        break;
    case FLY_DOWN:
        move(flight, (double[3]){0.0, -1.0, 0.0});
        break;
    case FLY_TURN_LEFT:
        flight->camera.yaw += TURN_STEP;
        break;
    case FLY_TURN_RIGHT:
        flight->camera.yaw -= TURN_STEP;
        break;
    case FLY_LOOK_UP:
        look(flight, (int32_t)TURN_STEP);
        break;
    case FLY_LOOK_DOWN:
        look(flight, -(int32_t)TURN_STEP);
        break;
    case FLY_WALLS:
        flight->through_walls = !flight->through_walls;
        break;
    case FLY_KEYS:
        break;
    }
}
