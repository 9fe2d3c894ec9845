/* SPDX-License-Identifier: MIT
 *
 * The public functions that draw: memory is shared out once, in lim_init(); a frame is a camera taken in, then
 * drawn in the target's order. Orders that are not linked fall out of these functions at compile time. */
#include "limner.h"

#include "ahead.h"
#include "eye.h"
#include "math/orientation.h"
#include "movers/mover.h"
#include "orders/convex.h"
#include "orders/mesh_frame.h"
#include "orders/nearest.h"
#include "orders/painter.h"
#include "pixels/delta.h"
#include "pixels/texture.h"
#include "view/pass.h"
#include "view/rows.h"
#include "view/view.h"
#include "view/walk.h"

static bool method_is_linked(enum lim_method method)
{
    return (LIM_HAS_NEAREST && method == LIM_NEAREST_FIRST) || (LIM_HAS_PAINTER && method == LIM_PAINTER) ||
           (LIM_HAS_CONVEX && method == LIM_CONVEX) || (LIM_HAS_SCANLINE && method == LIM_SCANLINE) ||
           (LIM_HAS_DEPTH && method == LIM_DEPTH) || (LIM_HAS_NEWELL && method == LIM_NEWELL) ||
           (LIM_HAS_MESH && method == LIM_MESH) || (LIM_HAS_MESH_DEPTH && method == LIM_MESH_DEPTH);
}

static size_t asked_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    if (LIM_IS_MESH(target)) return lim_mesh_mem_b(scene, target, least);
    if (LIM_IS_CONVEX(target)) return lim_convex_mem_b(scene, target, least ? 0 : scene->limits.active);
    if (LIM_IS_PAINTER(target)) return lim_painter_mem_b(scene);
    return lim_nearest_mem_b(scene, target, least);
}

size_t lim_mem_min_b(const struct lim_scene *scene, const struct lim_target *target)
{
    LIM_ASSERT(scene && target);
    return asked_b(scene, target, true);
}

size_t lim_mem_b(const struct lim_scene *scene, const struct lim_target *target)
{
    LIM_ASSERT(scene && target);
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
    return LIM_HAS_LEAVES && scene->node_count && lim_node_is_leaf(&scene->nodes[scene->node_count - 1]);
}

/* A tree without forks has as many levels as nodes; a set has none, and is for methods that sort, which want the planes
 * that mesh leaves do not have. A convex solid's faces hide its background. A mesh has no nodes, and what draws one
 * draws nothing else. */
static bool scene_is_usable(const struct lim_scene *scene, const struct lim_target *target)
{
    if (LIM_HAS_LONG && lim_scene_long(scene) &&
        (LIM_IS_MESH(target) || LIM_IS_SORTED(target) || LIM_IS_CONVEX(target) || scene->limits.leaf_polygons))
        return false;
    if (LIM_IS_MESH(target)) return !scene->node_count && scene->box_count;
    return !lim_scene_is_mesh(scene) && (LIM_IS_SORTED(target) || scene->limits.depth) &&
           scene->limits.vertices <= LIM_MAX_VERTICES && (LIM_HAS_SLANTED || !scene->plane_count) &&
           (LIM_HAS_LARGE || !scene->exact_count) &&
           ((LIM_HAS_MESH_LEAVES && !LIM_IS_SORTED(target)) || !scene->limits.leaf_polygons) &&
           !(LIM_IS_CONVEX(target) && (scene->limits.depth != scene->node_count || ends_in_leaf(scene))) &&
           !(LIM_HAS_WIDE && LIM_IS_CONVEX(target) && scene->polygon_count >= LIM_NONE) &&
           !(LIM_HAS_WIDE && LIM_IS_SORTED(target) && scene->polygon_count > LIM_SORTED_MAX) &&
           !(LIM_HAS_TRANSPARENT && LIM_IS_CONVEX(target) && scene->limits.layers);
}

static void connect_painter(struct lim *lim)
{
    struct lim_painter *painter = lim->painter;

    painter->pass = &lim->pass;
    if (LIM_HAS_SORTED) *painter->sorter = lim->sorter;
    if (LIM_HAS_FALLBACK) *painter->lent = NULL;
    if (LIM_HAS_MESH_LEAVES) *painter->leaf = lim->leaf;
}

static void connect_nearest(struct lim *lim)
{
    struct lim_nearest *nearest = lim->nearest;
    struct lim_paint *paint = &nearest->paint;

    nearest->pass = paint->pass = &lim->pass;
    if (LIM_HAS_SORTED) *nearest->sorter = lim->sorter;
    if (LIM_HAS_FALLBACK) *nearest->painter = lim->painter;
    if (LIM_HAS_MESH_LEAVES) *nearest->leaf = lim->leaf;
    if (LIM_HAS_DELTA) *paint->delta = NULL;
    if (LIM_HAS_LENT) *paint->lent = NULL;
    if (LIM_HAS_ANTIALIAS) *paint->smooth = (struct lim_smooth){.sums = NULL};
    if (LIM_HAS_FILLED) nearest->fills = false;
    if (LIM_HAS_MOVERS) {
        *nearest->moves = false;
        *nearest->asked_pixel = LIM_BY_PIXEL_NOT;
        *nearest->movers = lim->movers;
        *paint->actives.movers = lim->movers;
    }
    nearest->bands = 0;
}

/* Each stage gets what it works on; all that may be turned on is off. */
static void connect(struct lim *lim)
{
    struct lim_pass *pass = &lim->pass;

    if (LIM_HAS_PORTALS) lim_portals_lend(pass->walk->portals, pass->scene, NULL);
    if (LIM_HAS_WIREFRAME) *pass->wireframe = (struct lim_wireframe){0};
    if (LIM_HAS_OVERLAY) *pass->overlay = NULL;
    if (LIM_HAS_SORTED) lim->sorter->pass = pass;
    if (LIM_HAS_MOVERS) lim->movers->most = lim->movers->given = lim->movers->count = 0;
    if (LIM_HAS_MOVERS && LIM_HAS_LONG) *lim->movers->far = NULL;
    if (LIM_HAS_PAINTED) connect_painter(lim);
    if (LIM_HAS_SPANS) connect_nearest(lim);
    if (LIM_HAS_CONVEX) lim->convex->pass = pass;
    if (LIM_HAS_MESHES) {
        lim->mesh->pass = pass;
        lim->mesh->parts = 0;
    }
    if (LIM_HAS_DELTA) *lim->delta = NULL;
    lim->ahead.stage = LIM_AHEAD_NONE;
}

int lim_init(struct lim *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b)
{
    LIM_ASSERT(lim && scene && target && mem && (uintptr_t)mem % LIM_ALIGNOF(uint32_t) == 0);
    lim->pass.scene = NULL; /* until all is well */
    if (!target_is_usable(target)) return LIM_ERR_TARGET;
    if (!scene_is_usable(scene, target)) return LIM_ERR_SCENE;
    if (mem_b < asked_b(scene, target, true)) return LIM_ERR_MEMORY;
    lim->pass.scene = scene;
    lim->pass.target = *target;
    connect(lim);
    if (LIM_IS_MESH(target))
        lim_mesh_init(lim->mesh, mem, mem_b);
    else if (LIM_IS_CONVEX(target))
        lim_convex_init(lim->convex, mem, mem_b);
    else if (LIM_IS_PAINTER(target))
        lim_painter_init(lim->painter, mem);
    else
        lim_nearest_init(lim->nearest, mem, mem_b);
    return LIM_OK;
}

static int draw_frame(struct lim *lim)
{
    if (LIM_IS_MESH(&lim->pass.target)) return lim_mesh_frame(lim->mesh);
    if (LIM_IS_CONVEX(&lim->pass.target)) return lim_convex_frame(lim->convex);
    if (LIM_IS_PAINTER(&lim->pass.target)) return lim_painter_frame(lim->painter);
    return lim_nearest_frame(lim->nearest, LIM_AHEAD_BEGUN);
}

/* View, textures and sky ask for the camera's axes: they are found once. */
static LIM_IF_CALLED bool begin_textured(struct lim_pass *pass, const struct lim_camera *camera)
{
    int32_t axes_q30[9];

    lim_orientation_set(axes_q30, camera);
    if (!lim_view_begin_rows(&pass->view, lim_rows_set_turned(&pass->view.rows, pass->scene, camera, axes_q30)))
        return false;
    lim_texture_begin(pass->texturing, pass->scene, &pass->view, camera, axes_q30);
    if (LIM_HAS_SKY) {
        *pass->texturing->sky = pass->sky;
        lim_sky_begin(pass->sky, camera, axes_q30, pass->target.w_px, pass->target.h_px);
    }
    return true;
}

static inline bool begin_view(struct lim_pass *pass, const struct lim_camera *camera)
{
    if (LIM_HAS_TEXTURE && lim_texture_count(pass->scene)) return begin_textured(pass, camera);
    return lim_view_begin(&pass->view, pass->scene, camera);
}

static LIM_IN_EACH_CALLER int set_camera(struct lim *lim, const struct lim_camera *camera)
{
    struct lim_pass *pass = &lim->pass;

    LIM_ASSERT(pass->scene && camera); /* it was prepared */
    if (LIM_HAS_STATS) *lim_stats_of(pass) = (struct lim_stats){0};
    if (LIM_HAS_SPANS) lim->nearest->bands = 0;
    if (!begin_view(pass, camera)) return LIM_ERR_CAMERA;
    if (LIM_HAS_PLANES && !lim_eye_begin(lim_eye_of(pass), pass->scene, camera)) return LIM_ERR_CAMERA;
    if (LIM_HAS_LONG) *pass->view.rows.eye = *lim_eye_of(pass)->far;
    if (LIM_HAS_PORTALS) lim_walk_look_around(pass->walk, camera, pass->view.rows.far_units);
    if (LIM_HAS_MOVERS) lim_movers_pose(lim->movers, pass, camera);
    return LIM_OK;
}

static LIM_IF_CALLED void begin_changes(struct lim *lim, const struct lim_camera *camera)
{
    if (*lim->delta) lim_delta_begin_frame(*lim->delta, camera, lim_stats_of(&lim->pass));
}

/* What is painted may not be begun anew: the target's functions are not to call these. */
static int end_frame(struct lim *lim, int err)
{
    lim->ahead.stage = LIM_AHEAD_NONE;
    if (LIM_HAS_DELTA && *lim->delta) err = lim_delta_end_frame(*lim->delta, err);
    if (LIM_HAS_STATS) lim_stats_of(&lim->pass)->vertices = lim->pass.view.vertices;
    return err > 0 ? LIM_ERR_ANSWER : err;
}

int lim_frame(struct lim *lim, const struct lim_camera *camera)
{
    lim_drop_ahead(lim);
    const int err = set_camera(lim, camera);
    if (err) return err;
    if (LIM_HAS_DELTA) begin_changes(lim, camera);
    lim->ahead.stage = LIM_AHEAD_PAINTING;
    return end_frame(lim, draw_frame(lim));
}

static int begin_frame_ahead(struct lim *lim, const struct lim_camera *camera)
{
    const int err = set_camera(lim, camera);
    if (err) return err;
    if (LIM_HAS_DELTA) *lim->ahead.camera = *camera;
    lim->ahead.stage = LIM_AHEAD_BEGUN;
    return LIM_OK;
}

int lim_frame_begin(struct lim *lim, const struct lim_camera *camera)
{
    lim_drop_ahead(lim);
    return begin_frame_ahead(lim, camera);
}

static bool is_whole_at_once(const struct lim *lim)
{
    return LIM_IS_MESH(&lim->pass.target) || LIM_IS_CONVEX(&lim->pass.target) || LIM_IS_PAINTER(&lim->pass.target);
}

bool lim_frame_work(struct lim *lim)
{
    LIM_ASSERT(lim && lim->ahead.stage != LIM_AHEAD_PAINTING);
    if (!LIM_HAS_SPANS || lim->ahead.stage == LIM_AHEAD_NONE || is_whole_at_once(lim)) return false;
    return lim_nearest_work(lim->nearest, &lim->ahead.stage);
}

int lim_frame_paint(struct lim *lim)
{
    LIM_ASSERT(lim && lim->ahead.stage != LIM_AHEAD_PAINTING);
    enum lim_ahead_stage stage = lim->ahead.stage;
    if (stage == LIM_AHEAD_NONE) return LIM_ERR_BEGIN;
    if (LIM_HAS_DELTA) begin_changes(lim, lim->ahead.camera);
    lim->ahead.stage = LIM_AHEAD_PAINTING;
    const int err = !LIM_HAS_SPANS || is_whole_at_once(lim) ? draw_frame(lim) : lim_nearest_paint(lim->nearest, &stage);
    if (LIM_HAS_MOVERS) lim->movers->count = lim->movers->given = 0;
    return end_frame(lim, err);
}

#if LIM_HAS_MOVERS
static void set_instances(struct lim_movers *movers, const struct lim_instance *instances, uint16_t count)
{
    LIM_ASSERT(instances || !count);
    movers->instances = instances;
    movers->count = count < movers->most ? count : movers->most;
    movers->given = count;
}

int lim_movers_frame(struct lim *lim, const struct lim_camera *camera, const struct lim_instance *instances,
                     uint16_t count)
{
    lim_drop_ahead(lim);
    set_instances(lim->movers, instances, count);
    const int err = lim_frame(lim, camera);
    set_instances(lim->movers, NULL, 0);
    return err;
}

int lim_movers_begin(struct lim *lim, const struct lim_camera *camera, const struct lim_instance *instances,
                     uint16_t count)
{
    lim_drop_ahead(lim);
    set_instances(lim->movers, instances, count);
    const int err = begin_frame_ahead(lim, camera);
    if (err) set_instances(lim->movers, NULL, 0);
    return err;
}
#endif

uint32_t lim_bands(const struct lim *lim)
{
    LIM_ASSERT(lim);
    if (LIM_IS_MESH(&lim->pass.target)) return lim->mesh->parts;
    return LIM_HAS_SPANS ? lim->nearest->bands : 0;
}

const struct lim_stats *lim_stats(const struct lim *lim)
{
    static const struct lim_stats none = {0};

    LIM_ASSERT(lim);
    return LIM_HAS_STATS ? lim->pass.stats : &none;
}
