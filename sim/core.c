/* SPDX-License-Identifier: MIT
 *
 * Compiled once for each profile, together with the renderer's sources; CORE is the table's name. */
#include "core.h"

#ifndef CORE
#error "CORE and LIM_PROFILE are set by the Makefile"
#endif

#define QUOTE(text) #text
#define CORE_NAME(core) (&QUOTE(core)[sizeof "core_" - 1])

static int init(void *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b)
{
    return lim_init(lim, scene, target, mem, mem_b);
}

static void newell(void *lim, const struct lim_newell_options *options)
{
    lim_newell_set(lim, options);
}

static int frame(void *lim, const struct lim_camera *camera)
{
    return lim_frame(lim, camera);
}

static const struct lim_stats *stats(const void *lim)
{
    return lim_stats(lim);
}

static void set_wireframe(void *lim, const struct lim_wireframe *wireframe)
{
    lim_set_wireframe(lim, wireframe);
}

static bool project(void *lim, uint16_t vertex, double at_px[2])
{
    struct lim *const state = lim;
    struct lim_point at;

    if (lim_view_polygon(&state->view, state->scene, &vertex, 1, &at) & LIM_VIEW_GUARD) return false;
    at_px[0] = (double)at.x / LIM_SUB + LIM_ORIGIN_PX;
    at_px[1] = (double)at.y / LIM_SUB + LIM_ORIGIN_PX;
    return true;
}

static int8_t eye_side(const struct lim_scene *scene, const struct lim_plane_ref *ref, const int32_t eye_q8[3])
{
    struct lim_eye eye;

    lim_eye_set(&eye, scene, eye_q8);
    const int32_t side = lim_eye_side(&eye, ref);
    return (int8_t)((side > 0) - (side < 0));
}

const struct core CORE = {.name = CORE_NAME(CORE),
                          .profile = LIM_PROFILE,
                          .sub_bits = LIM_SUB_BITS,
                          .is_profile = LIM_SUB_BITS == LIM_PROFILE_SUB_BITS,
                          .narrow_px = LIM_NARROW_SIDE_PX,
                          .lim_b = sizeof(struct lim),
                          .mem_b = lim_mem_b,
                          .init = init,
                          .newell = newell,
                          .frame = frame,
                          .stats = stats,
                          .set_wireframe = set_wireframe,
                          .project = project,
                          .eye_side = eye_side};
