/* SPDX-License-Identifier: MIT
 *
 * A picture begins at the near plane: what a wall hides from the eye is seen where that plane cuts the wall open. So
 * not one cell is looked up, but all that the near rectangle may reach into: those that a ball about the eye touches.
 * What is seen from each is added up; where the ball touches matter, anything might be. Distances need not be exact,
 * for a ball that is a little too large is right too: |n| is taken for |n[0]| + |n[1]| + |n[2]|.
 *
 * An eye within some units of a plane is left alone as well: vertices are rounded, so polygons of that plane may be
 * culled as backs where by their vertices they close the view. */
#include "view/portals.h"

#include "camera.h"
#include "eye.h"
#include "math/fixed.h"

#if LIM_HAS_PORTALS

enum { ROUNDING_UNITS = 4, BALL_MAX_UNITS = 8192 };
#define LONG_BALL_MAX_UNITS (UINT32_C(1) << 20)

/* The near plane in use is at near_q8, or at 2^-16 / min(1, tan_x, tan_y) of far_units, 2^-15 where the lens is long,
 * or at 1 unit (camera.h). The rectangle's corners are sqrt(1 + t) times as far, t = tan_x^2 + tan_y^2, which is less
 * than 1 + t / 2. */
uint32_t lim_portals_ball_units(const struct lim_camera *camera, uint32_t far_units)
{
    const uint32_t tan_x_q12 = camera->tan_x_q28 >> 16, tan_y_q12 = camera->tan_y_q28 >> 16;
    const uint32_t half_q8 = ((tan_x_q12 * tan_x_q12 + tan_y_q12 * tan_y_q12) >> 17) + 1;
    uint32_t narrow_q12 = tan_x_q12 < tan_y_q12 ? tan_x_q12 : tan_y_q12;
    uint32_t near_units = ((uint32_t)camera->near_q8 >> 8) + 1;

    if (narrow_q12 > 4096) narrow_q12 = 4096;
    if (LIM_HAS_TELE && narrow_q12 < LIM_TAN_TELE_Q28 >> 16) narrow_q12 = 2048; /* z has more bits */
    const uint32_t least_units = ((far_units >> 4) + 1) / narrow_q12 + 1;
    if (near_units < least_units) near_units = least_units;
    return near_units + (near_units * half_q8 >> 8) + 1 + ROUNDING_UNITS;
}

/* A ball and a plane. */
enum side { ALL_BEHIND, TOUCHED, IN_FRONT, TOO_CLOSE };

static enum side side_at(int32_t value, int32_t reach, int32_t too_close)
{
    if (value > reach) return IN_FRONT;
    if (value < -reach) return ALL_BEHIND;
    return value <= too_close && value >= -too_close ? TOO_CLOSE : TOUCHED;
}

/* Of a long scene's plane: sums have 64 bits. */
static LIM_IF_CALLED enum side long_side_of(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref,
                                            uint32_t ball_units)
{
    uint32_t length;
    const int64_t value = lim_eye_long_distance(eye, ref, &length);
    const int64_t reach = (int64_t)length * (ball_units + 1), too_close = (int64_t)length * (ROUNDING_UNITS + 1);

    if (value > reach) return IN_FRONT;
    if (value < -reach) return ALL_BEHIND;
    return value <= too_close && value >= -too_close ? TOO_CLOSE : TOUCHED;
}

static enum side portals_side_of(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref,
                                 int32_t ball_units)
{
    if (LIM_HAS_LONG && eye->far->all) return long_side_of(eye, ref, (uint32_t)ball_units);
    if (!LIM_HAS_SLANTED || ref->plane >= LIM_PLANE_X) {
        const int32_t units = (eye->at_q8[ref->plane & 3] >> 8) - ref->offset;
        return side_at(units, ball_units + 1, ROUNDING_UNITS + 1);
    }
    const LIM_FLASH struct lim_plane *plane = lim_plane_at(eye->planes, ref->plane);
    const int32_t length =
        (int32_t)(abs_s32(lim_plane_x(plane)) + abs_s32(lim_plane_y(plane)) + abs_s32(lim_plane_z(plane)));
    const bool is_large = LIM_HAS_LARGE && lim_plane_exact(plane) != LIM_NO_INDEX;
    const int32_t value = lim_eye_dot(eye, plane) - lim_plane_d(plane);
    const int32_t slack = length + (is_large ? eye->large_slack : 0);
    return side_at(value, length * ball_units + slack, length * ROUNDING_UNITS + slack);
}

/* The visible set of the last place that does not begin behind the cell. */
static uint16_t pvs_of(const struct lim_scene *scene, uint16_t cell)
{
    uint16_t low = 0, end = scene->place_count;

    while (low < end) {
        const uint16_t middle = (uint16_t)(low + (uint16_t)(end - low) / 2);
        if (scene->places[middle].cell <= cell)
            low = (uint16_t)(middle + 1);
        else
            end = middle;
    }
    return low ? scene->places[low - 1].pvs : (uint16_t)LIM_NONE;
}

/* Stops at the end of either side, whatever the bytes say. */
static void add_pvs(const struct lim_scene *scene, uint16_t at, uint8_t *bits)
{
    const uint16_t size_b = (uint16_t)(((uint32_t)scene->box_count + 7) / 8);

    for (uint16_t to = 0; to < size_b && at < scene->pvs_bytes;) {
        const uint8_t byte = scene->pvs[at++];
        if (byte)
            bits[to++] |= byte;
        else if (at < scene->pvs_bytes)
            to = (uint16_t)(to + scene->pvs[at++]);
    }
}

/* What lies on one side of a node: a subtree for later, or a cell. `visible set` is the last one added. */
static bool portals_enter(const struct lim_portals *portals, const struct lim_scene *scene, lim_index index,
                          bool behind, uint16_t *depth, uint16_t *pvs)
{
    const LIM_FLASH struct lim_node *node = &scene->nodes[index];
    const lim_index child = behind ? node->back : node->front, run = behind ? node->back_run : node->front_run;

    if (child != LIM_NO_INDEX) {
        portals->stack[(*depth)++] = (uint16_t)child;
        return true;
    }
    const uint16_t mine = run == LIM_NO_INDEX ? (uint16_t)LIM_NONE : pvs_of(scene, (uint16_t)(2 * index + behind));
    if (mine == LIM_NONE) return false;
    if (mine != *pvs) add_pvs(scene, mine, portals->bits);
    *pvs = mine;
    return true;
}

/* Whether distances to planes can be told. */
static bool portals_may_ask(const struct lim_eye *eye, uint32_t ball_units)
{
    if (LIM_HAS_LONG && eye->far->all) return ball_units <= LONG_BALL_MAX_UNITS;
    return ball_units <= BALL_MAX_UNITS && !(LIM_HAS_FILTER && eye->shift);
}

bool lim_portals_unpack(const struct lim_portals *portals, const struct lim_eye *eye, uint32_t ball_units)
{
    const struct lim_scene *scene = eye->scene;
    uint16_t depth = 0, pvs = LIM_NONE;
    lim_index index = 0;

    if (!portals_may_ask(eye, ball_units)) return false;
    for (uint16_t i = 0; i < (uint16_t)LIM_PORTALS_BITS_B(scene->box_count); i++)
        portals->bits[i] = 0;
    for (;;) {
        const LIM_FLASH struct lim_node *node = &scene->nodes[index];
        const enum side side = portals_side_of(eye, &node->split, (int32_t)ball_units);
        if (side == TOO_CLOSE) return false;
        if (side != ALL_BEHIND && !portals_enter(portals, scene, index, false, &depth, &pvs)) return false;
        if (side != IN_FRONT && !portals_enter(portals, scene, index, true, &depth, &pvs)) return false;
        if (!depth) return true;
        index = portals->stack[--depth];
    }
}

#endif
