/* SPDX-License-Identifier: MIT
 *
 * Compiled once for each profile, together with the renderer's sources; CORE is the table's name. So is a profile with
 * other sub-pixel bits, by targets/core.sh. */
#include "core/core.h"

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

static void light(void *lim, const struct lim_light *lamp)
{
    lim_light_set(lim, lamp);
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
    struct lim *const state = lim;
    const struct lim_view_cached *seen = lim_view_vertex(&state->pass.view, state->pass.scene, vertex);

    if (seen->codes & LIM_VIEW_GUARD) return false;
    at_px[0] = (double)seen->at.x / LIM_SUB + LIM_ORIGIN_PX;
    at_px[1] = (double)seen->at.y / LIM_SUB + LIM_ORIGIN_PX;
    return true;
}

static int8_t eye_side(const struct lim_scene *scene, const struct lim_plane_ref *ref, const int32_t eye_q8[3])
{
    struct lim_eye eye;

    lim_eye_set(&eye, scene, eye_q8);
    const int32_t side = lim_eye_side(&eye, ref);
    return (int8_t)((side > 0) - (side < 0));
}

static void line_texels(const struct lim *lim, const struct lim_textured_span *span, core_texel *take, void *ctx)
{
    const int16_t w_px = (int16_t)lim->pass.target.w_px, end = span->right < w_px ? span->right : w_px;
    struct lim_texture_line line;

    if (span->left >= end || end <= 0) return;
    lim_texture_line_begin(&line, span, span->left > 0 ? span->left : 0);
    for (int16_t x = span->left > 0 ? span->left : 0; x < end; x++) {
        if (x == line.end) lim_texture_line_next(&line);
        const uint32_t place = lim_texture_at(&line, x).at;
        const struct core_texel_at at = {(uint16_t)x,
                                         (uint16_t)span->y,
                                         {(place & 0xFFFF) / 65536.0, (place >> 16) / 65536.0},
                                         line.level,
                                         x == line.x};
        take(ctx, &at);
    }
}

static void polygon_texels(struct lim *lim, const struct lim_screen_polygon *polygon, core_texel *take, void *ctx)
{
    const int16_t h_px = (int16_t)lim->pass.target.h_px;
    const int16_t bottom = polygon->shape.bottom < h_px ? polygon->shape.bottom : h_px;
    struct lim_gradients gradients;
    struct lim_edge_pair pair;

    lim_texture_set(lim->texturing, lim_screen_texture(polygon), &gradients);
    lim_edge_begin(&pair, polygon->n, polygon->shape.first);
    for (int16_t y = polygon->shape.top > 0 ? polygon->shape.top : 0; y < bottom; y++) {
        lim_edge_advance(&pair, polygon->at, polygon->n, y);
        const struct lim_textured_span span = {lim->texturing, &gradients, y, lim_edge_x(&pair.left),
                                               lim_edge_x(&pair.right)};
        line_texels(lim, &span, take, ctx);
    }
}

static void texels(void *state, lim_index record, core_texel *take, void *ctx)
{
    struct lim *const lim = state;
    const struct lim_rect screen = {0, 0, lim->pass.target.w_px, lim->pass.target.h_px};
    struct lim_screen_polygon polygon, triangle;

    if (!lim_project(&polygon, &lim->pass.view, lim->pass.scene, &lim->pass.scene->polygons[record], &screen, NULL))
        return;
    if (lim_screen_texture(&polygon) == LIM_NONE) return;
    if (!polygon.shape.non_monotone) polygon_texels(lim, &polygon, take, ctx);
    for (uint8_t k = 1; polygon.shape.non_monotone && k + 1 < polygon.n; k++) {
        lim_project_fan(&polygon, k, &triangle);
        polygon_texels(lim, &triangle, take, ctx);
    }
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
                          .stats = stats,
                          .set_wireframe = set_wireframe,
                          .set_antialias = set_antialias,
                          .set_delta = set_delta,
                          .refresh = refresh,
                          .project = project,
                          .eye_side = eye_side,
                          .texels = texels};
