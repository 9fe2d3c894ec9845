/* SPDX-License-Identifier: MIT
 *
 * Moving objects: meshes with compiled scenes of their own, placed anew in each frame.
 *
 *     struct lim_instance instances[2] = {{.object = &ball_scene}, {.object = &door_scene}};
 *     err = lim_movers_init(&lim, mover_mem, sizeof mover_mem, &(struct lim_movers_limits){2, 12, 300});
 *     lim_instance_turn(&instances[1], yaw, 0, 0);
 *     err = lim_movers_frame(&lim, &camera, instances, 2);
 *
 * They are drawn by the methods that walk a tree, LIM_NEAREST_FIRST and LIM_PAINTER. The array is the caller's and is
 * read while a frame is drawn; nothing of it is kept. */
#ifndef LIM_INSTANCE_H
#define LIM_INSTANCE_H

#include "agree.h"
#include "camera.h"
#include "scene.h"

LIM_C_BEGIN

struct lim;

/* An object in its place. */
struct lim_instance {
    const struct lim_scene *object; /* NULL, or without polygons: it is left out, and counted */
    int32_t at_q8[3];               /* its origin, units of the scene that it moves in, |at_q8| < 2^24 */
    int32_t
        axes_q30[9]; /* its x, y and z axis in that scene's axes, one after the other: of length 1, at right angles */
    uint8_t finer_bits; /* a unit of its own is 2^-finer_bits of that scene's, 0..3 */
    /* The corners of the object are its owner's, who changes them: *object is a copy whose `vertices` are in RAM (not
     * on AVR, whose flash is elsewhere). Tree, planes and boxes mean nothing then: each polygon's plane is that of its
     * first three corners, so triangles are best, and all are sorted anew. */
    bool deforms;
    bool by_centre; /* it enters the walk whole, at its centre: fast, and wrong where it reaches through a plane */
};

/* What the movers of a frame may take. All of an object has to lie within 2^16 units of the scene's origin, and the
 * eye within 2^20 of the object's own units of it. Instances that do not, and those beyond the declared number, are
 * left out. Where entries run out, objects enter by their centres. All of it is counted in struct lim_mover_stats. */
struct lim_movers_limits {
    uint16_t instances; /* the most, 0..LIM_INSTANCES_MAX */
    uint16_t depth;     /* the greatest limits.depth of any object */
    uint16_t entries;   /* polygons of objects that reach through planes, pieces, planes that cut them; >= instances */
};
#define LIM_INSTANCES_MAX 1024

/* Memory for lim_movers_init(): LIM_MOVERS_MEM_B() in state.h as a constant, or this; `scene` is the static one. */
size_t lim_movers_mem_b(const struct lim_scene *scene, const struct lim_movers_limits *limits)
    LIM_AGREES(lim_movers_mem_b);

/* Gives the movers of *lim their memory, after each lim_init(). mem (aligned for pointers) must outlive it.
 * LIM_ERR_MEMORY: it is less than lim_movers_mem_b(). */
LIM_MUST_CHECK int lim_movers_init(struct lim *lim, void *mem, size_t mem_b, const struct lim_movers_limits *limits)
    LIM_AGREES(lim_movers_init);

/* lim_frame() with instances in it, in any order. */
LIM_MUST_CHECK int lim_movers_frame(struct lim *lim, const struct lim_camera *camera,
                                    const struct lim_instance *instances, uint16_t count);

/* lim_frame_begin() with instances (limner.h), which are read until the frame is painted or dropped. */
LIM_MUST_CHECK int lim_movers_begin(struct lim *lim, const struct lim_camera *camera,
                                    const struct lim_instance *instances, uint16_t count);

/* Sets the axes from angles, as a camera takes them: at 0, 0, 0 they are the scene's. */
void lim_instance_turn(struct lim_instance *instance, uint32_t yaw, uint32_t pitch, uint32_t roll);

LIM_C_END

#endif
