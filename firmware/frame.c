/* SPDX-License-Identifier: MIT
 *
 * The public functions: memory is shared out once, in lim_init(); a frame is a camera taken in, then
 * drawn in the target's order. Orders that are not linked fall out of these functions at compile time. */
#include "limner.h"

#include "orders/order.h"

static bool method_is_linked(enum lim_method method)
{
    return (LIM_HAS_NEAREST && method == LIM_NEAREST_FIRST) || (LIM_HAS_PAINTER && method == LIM_PAINTER) ||
           (LIM_HAS_CONVEX && method == LIM_CONVEX) || (LIM_HAS_SCANLINE && method == LIM_SCANLINE) ||
           (LIM_HAS_DEPTH && method == LIM_DEPTH) || (LIM_HAS_NEWELL && method == LIM_NEWELL);
}

/* Whether the method, which is linked, is this one: constants where it is the only one. */
#define IS_CONVEX(target) (LIM_HAS_CONVEX && (!LIM_HAS_HIDDEN || (target)->method == LIM_CONVEX))
#define IS_PAINTER(target) (LIM_HAS_PAINTER && (!LIM_HAS_SPANS || (target)->method == LIM_PAINTER))

static size_t asked_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    if (IS_CONVEX(target)) return lim_convex_mem_b(scene, target, least ? 0 : scene->limits.active);
    if (IS_PAINTER(target)) return lim_painter_mem_b(scene);
    return lim_nearest_mem_b(scene, target, least);
}

size_t lim_mem_min_b(const struct lim_scene *scene, const struct lim_target *target)
{
    return asked_b(scene, target, true);
}

size_t lim_mem_b(const struct lim_scene *scene, const struct lim_target *target)
{
    return asked_b(scene, target, false);
}

/* What is not a framebuffer is none; it need not be used. */
static bool framebuffer_is_usable(const struct lim_target *target)
{
#if LIM_HAS_FRAMEBUFFER
    const struct lim_framebuffer *framebuffer = &target->framebuffer;

    return !framebuffer->pixels || (((uintptr_t)framebuffer->pixels & 3) == 0 && framebuffer->stride_px % 2 == 0 &&
                                    framebuffer->stride_px >= target->w_px);
#else
    (void)target;
    return true;
#endif
}

static bool target_is_usable(const struct lim_target *target)
{
    return target->w_px >= 1 && target->w_px <= LIM_MAX_SIDE_PX && target->h_px >= 1 &&
           target->h_px <= LIM_MAX_SIDE_PX && target->format == LIM_RGB565 && target->lend && target->done &&
           framebuffer_is_usable(target) && method_is_linked(target->method);
}

/* A leaf has no children, so where a tree has no forks it can only be the last node. */
static inline bool ends_in_leaf(const struct lim_scene *scene)
{
    return LIM_HAS_LEAVES && scene->node_count && scene->nodes[scene->node_count - 1].split.plane == LIM_NO_INDEX;
}

/* A tree without forks has as many levels as nodes; a set has none, and is for methods that sort. A convex solid's
 * faces hide its background. */
static bool scene_is_usable(const struct lim_scene *scene, const struct lim_target *target)
{
    return (LIM_IS_SORTED(target) || scene->limits.depth) && scene->limits.vertices <= LIM_MAX_VERTICES &&
           (LIM_HAS_SLANTED || !scene->plane_count) && (LIM_HAS_LARGE || !scene->exact_count) &&
           !(IS_CONVEX(target) && (scene->limits.depth != scene->node_count || ends_in_leaf(scene))) &&
           !(LIM_HAS_WIDE && IS_CONVEX(target) && scene->polygon_count >= LIM_NONE) &&
           !(LIM_HAS_WIDE && LIM_IS_SORTED(target) && scene->polygon_count > LIM_SORTED_MAX) &&
           !(LIM_HAS_TRANSPARENT && IS_CONVEX(target) && scene->limits.layers);
}

static inline void init_wireframe(struct lim *lim)
{
#if LIM_HAS_WIREFRAME
    lim->wireframe = (struct lim_wireframe){0};
#endif
    (void)lim;
}

static inline void init_frame(struct lim *lim)
{
#if LIM_HAS_FILLED
    lim->fills = false;
#endif
    (void)lim;
}

static inline void clear_bands(struct lim *lim)
{
#if LIM_HAS_SPANS
    lim->bands = 0;
#endif
    (void)lim;
}

static inline void init_ahead(struct lim *lim)
{
#if LIM_HAS_STREAM
    lim->ahead.stage = LIM_AHEAD_NONE;
#endif
    (void)lim;
}

static inline void init_antialias(struct lim *lim)
{
#if LIM_HAS_ANTIALIAS
    lim->paint.smooth.sums = NULL;
    lim->paint.smooth.line = NULL;
#endif
    (void)lim;
}

static inline void init_delta(struct lim *lim)
{
#if LIM_HAS_DELTA
    lim->delta = NULL;
#endif
    (void)lim;
}

int lim_init(struct lim *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b)
{
    LIM_ASSERT(lim && scene && target && mem && ((uintptr_t)mem & 3) == 0);
    if (!target_is_usable(target)) return LIM_ERR_TARGET;
    if (!scene_is_usable(scene, target)) return LIM_ERR_SCENE;
    if (mem_b < asked_b(scene, target, true)) return LIM_ERR_MEMORY;
    lim->scene = scene;
    lim->target = *target;
    init_wireframe(lim);
    init_antialias(lim);
    init_delta(lim);
    init_frame(lim);
    init_ahead(lim);
    clear_bands(lim);
    lim_lend_portals(lim, NULL);
#if LIM_HAS_MOVERS
    lim->movers.most = lim->movers.given = lim->movers.count = 0;
#endif
    if (IS_CONVEX(target))
        lim_convex_init(lim, mem, mem_b);
    else if (IS_PAINTER(target))
        lim_painter_init(lim, mem);
    else
        lim_nearest_init(lim, mem, mem_b);
    return LIM_OK;
}

static void find_shown(struct lim *lim, const struct lim_camera *camera)
{
#if LIM_HAS_PORTALS
    lim->walk.shown = NULL;
    if (!lim->portals.bits) return;
    const uint32_t ball_units = lim_portals_ball_units(camera, lim->view.rows.far_units);
    if (lim_portals_unpack(&lim->portals, lim_eye_of(lim), ball_units)) lim->walk.shown = lim->portals.bits;
#else
    (void)lim;
    (void)camera;
#endif
}

static int draw(struct lim *lim)
{
    if (IS_CONVEX(&lim->target)) return lim_convex_frame(lim);
    if (IS_PAINTER(&lim->target)) return lim_painter_frame(lim);
    return lim_nearest_frame(lim);
}

static int take_in(struct lim *lim, const struct lim_camera *camera)
{
    if (LIM_HAS_STATS) *lim_stats_of(lim) = (struct lim_stats){0};
    clear_bands(lim);
    if (!lim_view_begin(&lim->view, lim->scene, camera)) return LIM_ERR_CAMERA;
    if (LIM_HAS_TEXTURE && lim_texture_count(lim->scene))
        lim_texture_begin(lim_texturing_of(lim), lim->scene, &lim->view, camera);
    lim_eye_set(lim_eye_of(lim), lim->scene, camera->eye_q8);
    if (LIM_HAS_PORTALS) find_shown(lim, camera);
#if LIM_HAS_MOVERS
    lim_movers_pose(lim, camera);
#endif
    return LIM_OK;
}

static void begin_changes(struct lim *lim, const struct lim_camera *camera)
{
#if LIM_HAS_DELTA
    if (lim->delta) lim_delta_begin_frame(lim->delta, camera, lim_stats_of(lim));
#else
    (void)lim, (void)camera;
#endif
}

static int end(struct lim *lim, int err)
{
#if LIM_HAS_DELTA
    if (lim->delta) err = lim_delta_end_frame(lim->delta, err);
#endif
    if (LIM_HAS_STATS) lim_stats_of(lim)->vertices = lim->view.vertices;
    return err;
}

int lim_frame(struct lim *lim, const struct lim_camera *camera)
{
    lim_drop_ahead(lim);
    const int err = take_in(lim, camera);
    if (err) return err;
    begin_changes(lim, camera);
    return end(lim, draw(lim));
}

#if LIM_HAS_STREAM
int lim_begin_ahead(struct lim *lim, const struct lim_camera *camera)
{
    const int err = take_in(lim, camera);
    if (err) return err;
#if LIM_HAS_DELTA
    lim->ahead.camera = *camera;
#endif
    lim->ahead.stage = LIM_AHEAD_BEGUN;
    return LIM_OK;
}

int lim_frame_begin(struct lim *lim, const struct lim_camera *camera)
{
    lim_drop_ahead(lim);
    return lim_begin_ahead(lim, camera);
}

static bool is_whole_at_once(const struct lim *lim)
{
    return IS_CONVEX(&lim->target) || IS_PAINTER(&lim->target);
}

bool lim_frame_work(struct lim *lim)
{
    if (lim->ahead.stage == LIM_AHEAD_NONE || is_whole_at_once(lim)) return false;
    return lim_nearest_work(lim);
}

int lim_frame_paint(struct lim *lim)
{
    if (lim->ahead.stage == LIM_AHEAD_NONE) return LIM_ERR_BEGIN;
#if LIM_HAS_DELTA
    begin_changes(lim, &lim->ahead.camera);
#endif
    const int err = end(lim, is_whole_at_once(lim) ? draw(lim) : lim_nearest_paint(lim));
    lim_drop_ahead(lim);
    return err;
}
#endif

uint32_t lim_bands(const struct lim *lim)
{
#if LIM_HAS_SPANS
    return lim->bands;
#else
    (void)lim;
    return 0;
#endif
}

const struct lim_stats *lim_stats(const struct lim *lim)
{
#if LIM_HAS_STATS
    return &lim->stats;
#else
    static const struct lim_stats none = {0};

    (void)lim;
    return &none;
#endif
}
