/* SPDX-License-Identifier: MIT
 *
 * Limner: solid 3D scenes on small displays, in fixed point, without allocation.
 * A program includes its scene's header, which includes this one.
 *
 *     HALL_MEMORY(240, 240);
 *     err = hall_begin(&hall_memory, send, NULL);
 *     if (!err) err = lim_frame(hall_memory.lim, &camera);
 *
 * send() is the program's own, and sends pixels (lim_send). Who wants a line to be painted while another one is on its
 * way, or to send what changes alone, makes a struct lim_target instead (target.h), and places the renderer:
 *
 *     static struct lim lim;
 *     static uint32_t mem[HALL_SCENE_MEM_B(240) / 4];
 *     int err = lim_init(&lim, &hall_scene, &target, mem, sizeof mem);
 *     if (!err) err = lim_frame(&lim, &camera);
 *
 * The caller owns all memory. Three kinds of trouble are never mixed: a caller's bug asserts (LIM_ASSERT); bad data or
 * hardware returns a negative code; a pool that is too small makes the frame slower, never wrong, and is counted in
 * struct lim_stats. */
#ifndef LIM_LIMNER_H
#define LIM_LIMNER_H

#include "agree.h"
#include "camera.h"
#include "config.h"
#include "meshes.h"
#include "orders.h"
#include "scene.h"
#include "stages.h"
#include "target.h"

#if LIM_HAS_LONG
#include "long.h"
#endif

LIM_C_BEGIN

struct lim;
struct lim_overlay; /* overlay.h */

/* Least and comfortable memory for a scene on a target; comfortable = what the scene's limits ask. */
size_t lim_mem_min_b(const struct lim_scene *scene, const struct lim_target *target) LIM_AGREES(lim_mem_min_b);
size_t lim_mem_b(const struct lim_scene *scene, const struct lim_target *target) LIM_AGREES(lim_mem_b);

/* Prepares *lim. scene, target and mem (aligned to 4 bytes, and for pointers) must outlive it; the target is copied. */
LIM_MUST_CHECK int lim_init(struct lim *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem,
                            size_t mem_b) LIM_AGREES(lim_init);

/* How frames are drawn from now on; lim_init() turns it off. There if LIM_HAS_WIREFRAME. Scenes compiled with
 * --wireframe know which of their edges the compiler made, which are not drawn. LIM_NEWELL: polygons
 * that it splits are filled, not outlined. */
void lim_set_wireframe(struct lim *lim, const struct lim_wireframe *wireframe);

/* Draws something over frames, from the next one that is painted on (overlay.h); lim_init() turns it off. There if
 * LIM_HAS_OVERLAY. *overlay must outlive it; NULL turns it off. It may lie over the frames of several renderers. With
 * delta output it is sent as far as it changed, and what it no longer hides as well; its lines need runs as scenes do.
 */
void lim_set_overlay(struct lim *lim, const struct lim_overlay *overlay);

/* Says which pixels of lines are seen from now on, as on round glass: lim_target.visible, for programs that begin with
 * hall_begin(). It is handed the target's ctx: there a struct lim_sender, whose ctx is the program's. A line of which
 * nothing is seen comes as one piece of 0 pixels. NULL: all is seen. There if LIM_HAS_ROUND. Before lim_set_delta(). */
void lim_set_visible(struct lim *lim, lim_visible *visible);

/* Draws frames with antialiased edges from now on; lim_init() turns it off. There if LIM_HAS_ANTIALIAS. `mem`, 4-byte
 * aligned, LIM_ANTIALIAS_MEM_B(w_px) bytes or more, must outlive it; NULL turns it off. LIM_ERR_MEMORY: too little;
 * LIM_ERR_TARGET: LIM_CONVEX and LIM_PAINTER, which do not paint nearest first, have it not. Renderers that take turns
 * may be lent the same memory. Wireframes are drawn without. */
LIM_MUST_CHECK int lim_set_antialias(struct lim *lim, void *mem, size_t mem_b);

/* Sends only what differs from the last frame, from now on; lim_init() turns it off. There if LIM_HAS_DELTA. `mem`,
 * aligned for pointers, LIM_DELTA_MEM_B(w_px, h_px, run_count) bytes, must outlive it; run_count: how many runs of one
 * colour the lines of a frame have together; lines for which there is no room are sent whole. NULL turns it off.
 * LIM_ERR_MEMORY: too little; LIM_ERR_TARGET: the target has no window(), or does not tell its costs. Renderers that
 * paint into one target in turns are lent the same memory: together they send what changes. */
LIM_MUST_CHECK int lim_set_delta(struct lim *lim, void *mem, size_t mem_b);

/* The next frame is sent whole: to be called when the panel may show something else than the last one. After an error
 * it is so by itself. */
void lim_refresh(struct lim *lim);

/* Renders one frame through the target. 0, an enum lim_error, or what the target returned. */
LIM_MUST_CHECK int lim_frame(struct lim *lim, const struct lim_camera *camera);

/* How often the last frame's pass one was made again because a pool was too small: 0 where memory was enough. Counted
 * even without LIM_HAS_STATS, so that firmware can tell. Of a mesh, how many parts lines were painted in for which its
 * pool was too small. LIM_CONVEX and LIM_PAINTER have neither. */
uint32_t lim_bands(const struct lim *lim);

/* A frame in parts: lim_frame() is lim_frame_begin() and lim_frame_paint(). Between the two, lim_frame_work() does pass
 * one in quanta, without the target's memory. So where there are two renderers, each with memory of its own, one finds
 * out what is seen in its frame in the time that the other's needs to be sent:
 *
 *     err = lim_frame_begin(&next, &camera);
 *     ...lim_frame_paint(&now), in whose target's done(), instead of waiting:
 *         while (line_is_being_sent() && lim_frame_work(&next)) continue;
 *
 * The pictures are those of lim_frame(). */

/* Takes a camera in. 0 or LIM_ERR_CAMERA. A frame that was begun before is dropped, as it is by lim_frame(), and by
 * what changes how frames are drawn or what with: lim_init(), lim_movers_init(), lim_set_...(). */
LIM_MUST_CHECK int lim_frame_begin(struct lim *lim, const struct lim_camera *camera);

/* A quantum: about a polygon's work. It calls lim_target.visible() alone. false: nothing is left to be done ahead. All
 * methods but LIM_CONVEX and LIM_PAINTER have such work, unless the target is filled at once (lim_target.fill);
 * LIM_DEPTH and LIM_NEWELL put the list in order first, in one quantum. Where a pool is exhausted the rest is
 * left to lim_frame_paint(). */
bool lim_frame_work(struct lim *lim);

/* The rest of the frame, through the target. 0, LIM_ERR_BEGIN if there is none, an enum lim_error, or what the target
 * returned; in any case no frame is begun then. */
LIM_MUST_CHECK int lim_frame_paint(struct lim *lim);

/* What the last frame did. */
const struct lim_stats *lim_stats(const struct lim *lim);

/* How LIM_NEWELL compares and splits from the next frame on (struct lim_newell_options); after lim_init(). */
void lim_newell_set(struct lim *lim, const struct lim_newell_options *options);

/* What moves (scene.h) -------------------------------------------------------------------------------------------- */

/* Memory for lim_movers_init(): LIM_MOVERS_MEM_B() (orders.h) as a constant, or this; `scene` is the static one. */
size_t lim_movers_mem_b(const struct lim_scene *scene, const struct lim_movers_limits *limits)
    LIM_AGREES(lim_movers_mem_b);

/* Gives the movers of *lim their memory, after each lim_init(). mem (aligned for pointers) must outlive it.
 * LIM_ERR_MEMORY: it is less than lim_movers_mem_b(). */
LIM_MUST_CHECK int lim_movers_init(struct lim *lim, void *mem, size_t mem_b, const struct lim_movers_limits *limits)
    LIM_AGREES(lim_movers_init);

/* lim_frame() with instances in it, in any order. */
LIM_MUST_CHECK int lim_movers_frame(struct lim *lim, const struct lim_camera *camera,
                                    const struct lim_instance *instances, uint16_t count);

/* lim_frame_begin() with instances, which are read until the frame is painted or dropped. */
LIM_MUST_CHECK int lim_movers_begin(struct lim *lim, const struct lim_camera *camera,
                                    const struct lim_instance *instances, uint16_t count);

/* From the next frame on; after lim_movers_init(). */
void lim_light_set(struct lim *lim, const struct lim_light *light);

/* A short way to begin -------------------------------------------------------------------------------------------- */

/* All of a program's memory in one declaration, and one function of its own, which sends pixels. A scene's header has
 * both fitted to the scene. lim_set_wireframe() and lim_set_antialias() come after hall_begin(), as after lim_init().
 */

/* Sends n_px pixels from (x_px, y_px) to the right, in RGB565, each as the bus wants it: the byte with the red bits
 * first. `pixels` may be written to again as soon as it returns. Lines come from the top down, the pieces of a line
 * from left to right: each pixel of a frame once, all of them unless lim_set_visible() says otherwise. 0; or a code,
 * which ends the frame, and comes back from lim_frame(): a positive one as LIM_ERR_ANSWER. */
typedef int lim_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px); /* program's */

/* Bytes of a line. */
#define LIM_LINE_B(w_px) (((w_px)*2u + 3u) / 4u * 4u)

/* What paints into memory and sends it. */
struct lim_sender {
    lim_send *send;
    void *ctx;          /* handed to send() */
    uint16_t *lines;    /* aligned to 4 bytes */
    size_t lines_b;     /* LIM_LINE_B(w_px) or more */
    uint16_t stride_px; /* private: from a line to the next; 0: there is one for all */
};

/* Makes *target of it; *sender must outlive whoever uses the target. With memory for all h_px lines each has its own,
 * and where LIM_HAS_FRAMEBUFFER is 1 they are the target's framebuffer; else there is one line, whatever lines_b.
 * LIM_ERR_MEMORY: for a line, or for LIM_PAINTER for all of them, lines_b is too little. */
LIM_MUST_CHECK int lim_sender_target(struct lim_sender *sender, uint16_t w_px, uint16_t h_px, enum lim_method method,
                                     struct lim_target *target) LIM_AGREES(lim_sender_target);

/* A renderer's memory, and that of its lines. All of it outlives the renderer. */
struct lim_memory {
    struct lim *lim;
    struct lim_sender *sender;
    void **pools;    /* of lim_init() */
    void **movers;   /* of lim_movers_init() */
    uint16_t *lines; /* aligned to 4 bytes */
    size_t pools_b, movers_b, lines_b;
    uint16_t w_px, h_px; /* of the display */
};

/* Declares a block of static memory, and `name`, a constant struct lim_memory that says where it is. Scenes' headers
 * have it with their own numbers. Arguments are constants. */
#define LIM_MEMORY(name, width_px, height_px, pool_b, mover_b, line_count)                                             \
    LIM_STATIC_ASSERT((width_px) >= 1 && (height_px) >= 1 && (width_px) <= LIM_MAX_SIDE_PX &&                          \
                          (height_px) <= LIM_MAX_SIDE_PX,                                                              \
                      "a side of this display is 0, or longer than what the scene was compiled for: limner compile "   \
                      "--size WxH");                                                                                   \
    LIM_STATIC_ASSERT(UINT64_C(1) * LIM_LINE_B(width_px) * (line_count) <= SIZE_MAX / 2,                               \
                      "all lines of this display together are more than the processor can address");                   \
    LIM_OPTIONAL_BEGIN                                                                                                 \
    static struct name##_block {                                                                                       \
        struct lim lim;                                                                                                \
        struct lim_sender sender;                                                                                      \
        void *pools[LIM_POINTERS(pool_b) + LIM_POINTERS(mover_b)];                                                     \
        LIM_ALIGNAS(4) uint16_t lines[LIM_CAST(size_t, LIM_LINE_B(width_px)) / 2 * (line_count)];                      \
    } name##_block;                                                                                                    \
    LIM_OPTIONAL_END                                                                                                   \
    static const struct lim_memory name = {&name##_block.lim,                                                          \
                                           &name##_block.sender,                                                       \
                                           name##_block.pools,                                                         \
                                           name##_block.pools + LIM_POINTERS(pool_b),                                  \
                                           name##_block.lines,                                                         \
                                           LIM_POINTERS(pool_b) * sizeof(void *),                                      \
                                           LIM_POINTERS(mover_b) * sizeof(void *),                                     \
                                           sizeof name##_block.lines,                                                  \
                                           width_px,                                                                   \
                                           height_px}
#define LIM_POINTERS(size_b) (((size_b) + sizeof(void *) - 1) / sizeof(void *))

/* lim_init() in that memory, on a display that send() sends to. What moves needs lim_movers_init() after it, as
 * hall_begin() does by itself. LIM_ERR_MEMORY, or what lim_init() returns. */
LIM_MUST_CHECK int lim_begin(const struct lim_memory *memory, const struct lim_scene *scene, enum lim_method method,
                             lim_send *send, void *ctx) LIM_AGREES(lim_begin);

/* Private: complete, so that callers can place it ----------------------------------------------------------------- */

LIM_OPTIONAL_BEGIN

/* A frame that lim_frame_begin() began. */
struct lim_ahead {
    enum lim_ahead_stage stage;
    LIM_OPTIONAL(struct lim_camera, camera, LIM_HAS_DELTA); /* what was taken in */
};

struct lim {
    struct lim_pass pass;
    LIM_OPTIONAL(struct lim_sorter, sorter, LIM_HAS_SORTED);
    LIM_OPTIONAL(struct lim_movers, movers, LIM_HAS_MOVERS);
    LIM_OPTIONAL(struct lim_mesh_leaf, leaf, LIM_HAS_MESH_LEAVES);
    LIM_OPTIONAL(struct lim_painter, painter, LIM_HAS_PAINTED);
    LIM_OPTIONAL(struct lim_nearest, nearest, LIM_HAS_SPANS);
    LIM_OPTIONAL(struct lim_convex, convex, LIM_HAS_CONVEX);
    LIM_OPTIONAL(struct lim_mesh, mesh, LIM_HAS_MESHES);
    LIM_OPTIONAL(struct lim_delta *, delta, LIM_HAS_DELTA); /* NULL: every frame is sent whole */
    struct lim_ahead ahead;
};

LIM_OPTIONAL_END

LIM_C_END

#ifdef LIM_CONFIG
#include LIM_CONFIG /* the scenes' declarations */
#endif

#endif
