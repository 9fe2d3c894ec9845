/* SPDX-License-Identifier: MIT
 *
 * Limner: solid 3D scenes on small displays, in fixed point, without allocation.
 *
 *     static struct lim lim;
 *     static uint32_t mem[HALL_SCENE_MEM_B(240) / 4];
 *     int err = lim_init(&lim, &hall_scene, &target, mem, sizeof mem);
 *     if (!err) err = lim_frame(&lim, &camera);
 *
 * A shorter way for displays that take pixels from a function: begin.h.
 *
 * The caller owns all memory. Three kinds of trouble are never mixed: a caller's bug asserts
 * (LIM_ASSERT); bad data or hardware returns a negative code; a pool that is too small makes the
 * frame slower, never wrong, and is counted in struct lim_stats. */
#ifndef LIM_LIMNER_H
#define LIM_LIMNER_H

#include "agree.h"
#include "angle.h"
#include "begin.h"
#include "camera.h"
#include "config.h"
#include "errors.h"
#include "instance.h"
#include "light.h"
#include "motion.h"
#include "scene.h"
#include "stats.h"
#include "target.h"
#include "version.h"

LIM_C_BEGIN

struct lim;

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
 * even without LIM_HAS_STATS, so that firmware can tell. LIM_CONVEX and LIM_PAINTER have no such passes. */
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

const struct lim_stats *lim_stats(const struct lim *lim);

struct lim_newell_options;

/* How LIM_NEWELL compares and splits from the next frame on (newell.h); after lim_init(). */
void lim_newell_set(struct lim *lim, const struct lim_newell_options *options);

#include "state.h" /* struct lim: complete, so that callers can place it; its fields are private */

LIM_C_END

#ifdef LIM_CONFIG
#include LIM_CONFIG /* the scenes' declarations */
#endif

#endif
