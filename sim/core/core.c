/* SPDX-License-Identifier: MIT
 *
 * Compiled once for each profile, together with the renderer's sources; CORE is the table's name. So is a profile with
 * other sub-pixel bits, by targets/core.sh. */
#include "core/core.h"

#include "inspect.h"
#include "limner.h"

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

static void light(void *lim, const struct lim_light *to)
{
    lim_light_set(lim, to);
}

static int movers_init(void *lim, void *mem, size_t mem_b, const struct lim_movers_limits *limits)
{
    return lim_movers_init(lim, mem, mem_b, limits);
}

static int movers_frame(void *lim, const struct lim_camera *camera, const struct lim_instance *instances,
                        uint16_t count)
{
    return lim_movers_frame(lim, camera, instances, count);
}

static int begin(void *lim, const struct lim_camera *camera, const struct lim_instance *instances, uint16_t count)
{
    return count ? lim_movers_begin(lim, camera, instances, count) : lim_frame_begin(lim, camera);
}

static bool work(void *lim)
{
    return lim_frame_work(lim);
}

static int paint(void *lim)
{
    return lim_frame_paint(lim);
}

static uint32_t bands(const void *lim)
{
    return lim_bands(lim);
}

static const struct lim_stats *stats(const void *lim)
{
    return lim_stats(lim);
}

static void set_wireframe(void *lim, const struct lim_wireframe *wireframe)
{
    lim_set_wireframe(lim, wireframe);
}

static int set_antialias(void *lim, void *mem, size_t mem_b)
{
    return lim_set_antialias(lim, mem, mem_b);
}

static void set_overlay(void *lim, const struct lim_overlay *overlay)
{
    lim_set_overlay(lim, overlay);
}

static int set_delta(void *lim, void *mem, size_t mem_b)
{
    return lim_set_delta(lim, mem, mem_b);
}

static void refresh(void *lim)
{
    lim_refresh(lim);
}

static bool project(void *lim, lim_index vertex, double at_px[2])
{
    struct lim_point at;

    if (!lim_inspect_vertex(lim, vertex, &at)) return false;
    at_px[0] = (double)at.x / LIM_SUB + LIM_ORIGIN_PX;
    at_px[1] = (double)at.y / LIM_SUB + LIM_ORIGIN_PX;
    return true;
}

static void count_as(void *lim, const struct lim_counted *counted, size_t counted_b)
{
    lim_inspect_count_as(lim, counted, counted_b);
}

/* Who asked for texels. */
struct asker {
    core_texel *take;
    void *ctx;
};

static void take_texel(void *ctx, const struct lim_inspected_texel *texel)
{
    const struct asker *asker = ctx;
    const struct core_texel_at at = {texel->x_px,
                                     texel->y_px,
                                     {(texel->place >> 16) / 65536.0, (texel->place & 0xFFFF) / 65536.0},
                                     texel->level,
                                     texel->divided};
    asker->take(asker->ctx, &at);
}

static void texels(void *lim, lim_index record, core_texel *take, void *ctx)
{
    struct asker asker = {take, ctx};

    lim_inspect_texels(lim, record, take_texel, &asker);
}

const struct core CORE = {.shared_b = CORE_SHARED_B,
                          .name = CORE_NAME(CORE),
                          .profile = LIM_PROFILE,
                          .sub_bits = LIM_SUB_BITS,
                          .is_profile = LIM_SUB_BITS == LIM_PROFILE_SUB_BITS,
                          .narrow_px = LIM_NARROW_SIDE_PX,
                          .lim_b = sizeof(struct lim),
                          .mem_b = lim_mem_b,
                          .mem_min_b = lim_mem_min_b,
                          .init = init,
                          .newell = newell,
                          .frame = frame,
                          .light = light,
                          .movers_mem_b = lim_movers_mem_b,
                          .movers_init = movers_init,
                          .movers_frame = movers_frame,
                          .begin = begin,
                          .work = work,
                          .paint = paint,
                          .bands = bands,
                          .stats = stats,
                          .set_wireframe = set_wireframe,
                          .set_antialias = set_antialias,
                          .set_delta = set_delta,
                          .set_overlay = set_overlay,
                          .refresh = refresh,
                          .project = project,
                          .eye_side = lim_inspect_side,
                          .count_as = count_as,
                          .texels = texels};
