/* SPDX-License-Identifier: MIT
 *
 * What moves in a scene, and how it is told where it is. */
#ifndef LIM_INSTANCE_H
#define LIM_INSTANCE_H

#include "scene.h"

struct lim_long_vertex;

/* Moving objects: meshes with compiled scenes of their own, placed anew in each frame.
 *
 *     struct lim_instance instances[2] = {{.object = &ball_scene}, {.object = &door_scene}};
 *     err = lim_movers_init(&lim, mover_mem, sizeof mover_mem, &(struct lim_movers_limits){2, 12, 300, 0, 0});
 *     lim_instance_turn(&instances[1], yaw, 0, 0);
 *     err = lim_movers_frame(&lim, &camera, instances, 2);
 *
 * They are drawn by the methods that walk a tree, LIM_NEAREST_FIRST and LIM_PAINTER. The array is the caller's and is
 * read while a frame is drawn; nothing of it is kept. */

LIM_C_BEGIN
LIM_OPTIONAL_BEGIN

/* An object in its place. */
struct lim_instance {
    const struct lim_scene *object; /* NULL, or without polygons: it is left out, and counted */
    int32_t at_q8[3];               /* its origin, units of the scene that it moves in, |at_q8| < 2^24 */
    /* Its x, y and z axis in that scene's axes, one after the other: of length 1, at right angles. */
    int32_t axes_q30[9];
    uint8_t finer_bits; /* a unit of its own is 2^-finer_bits of that scene's, 0..3; 0..8 in one of many scales */
    /* The corners of the object are its owner's, who changes them: *object is a copy whose `vertices` are in RAM (not
     * on AVR, whose flash is elsewhere). Tree, planes and boxes mean nothing then: each polygon's plane is that of its
     * first three corners, so triangles are best, and all are sorted anew. */
    bool deforms;
    bool by_centre; /* it enters the walk whole, at its centre: fast, and wrong where it reaches through a plane */
    /* In a scene of many scales (long.h): a unit of its own is 2^coarser_bits of the scene's, 0..14, if finer_bits is
     * 0; and whole units where at_q8 counts from. Both together are below 2^30. */
    LIM_OPTIONAL(uint8_t, coarser_bits, LIM_HAS_LONG);
    LIM_OPTIONAL(int32_t, origin, 3 * LIM_HAS_LONG);
};

/* What the movers of a frame may take. All of an object has to lie within 2^16 units of the scene's origin, and the
 * eye within 2^20 of the object's own units of it; in a scene of many scales its origin within 2^30 units, and the eye
 * within 2^29 of its own. Instances that do not, and those beyond the declared number, are left out. Where entries
 * run out, objects enter by their centres. All of it is counted in struct lim_mover_stats. */
struct lim_movers_limits {
    uint16_t instances; /* the most, 0..LIM_INSTANCES_MAX */
    uint16_t depth;     /* the greatest limits.depth of any object */
    uint16_t entries;   /* polygons of objects that reach through planes, pieces, planes that cut them; >= instances */
    uint16_t leaf_vertices; /* the greatest of any object's limits; 0: no object has a mesh leaf */
    uint16_t leaf_polygons; /* likewise */
};
#define LIM_INSTANCES_MAX 1024

/* Sets the axes from angles, as a camera takes them: at 0, 0, 0 they are the scene's. */
void lim_instance_turn(struct lim_instance *instance, uint32_t yaw, uint32_t pitch, uint32_t roll);

/* Keyframed rigid motion: a table in flash, written by `limner compile` from a model's animations. Between two keys a
 * position moves along a straight line, an orientation turns about one axis, both evenly. */
struct lim_motion_key {
    uint32_t time_ms;    /* ascending */
    int32_t at_q8[3];    /* units of the static scene */
    int16_t turn_q15[4]; /* a quaternion x, y, z, w of length 1, within rounding */
    uint16_t arc;        /* half the angle to the next key's orientation; a full turn is 2^16, this below 2^14 */
};

struct lim_motion {
    const LIM_FLASH struct lim_motion_key *keys;
    uint16_t count; /* at least 1 */
    bool repeats;   /* after the last key comes the first; else the last one stays */
    /* In a scene of many scales: of each key whole units, from where its at_q8 counts; or NULL. */
    LIM_OPTIONAL(const LIM_FLASH struct lim_long_vertex *, origins, LIM_HAS_LONG);
};

/* An object of a compiled model, and how its animation moves it. */
struct lim_moved {
    const struct lim_scene *object;
    struct lim_motion motion;
    uint8_t finer_bits;                                /* lim_instance.finer_bits */
    bool by_centre;                                    /* lim_instance.by_centre: `limner compile --movers centre` */
    LIM_OPTIONAL(uint8_t, coarser_bits, LIM_HAS_LONG); /* lim_instance.coarser_bits */
};

LIM_OPTIONAL_END

/* Sets an instance for each of `count` objects as they are at a time. */
void lim_moved_at(const struct lim_moved *moved, uint16_t count, uint32_t time_ms, struct lim_instance *instances);

/* Sets where the instance is, and its axes: within 2^-14 of a unit vector, no component beyond -1..1. Before its first
 * key a motion is there already. Keys that break the bounds above give other places and axes that are no rotation, and
 * still nothing overflows. */
/*@ requires \valid_read(motion) && motion->count >= 1 && \valid_read(motion->keys + (0 .. motion->count - 1));
    requires \valid(instance) && \separated(instance, motion);
    requires \separated(instance, motion->keys + (0 .. motion->count - 1));
    assigns instance->at_q8[0 .. 2], instance->axes_q30[0 .. 8];
    ensures \forall integer i; 0 <= i < 9 ==> -1073741824 <= instance->axes_q30[i] <= 1073741824; */
void lim_motion_at(const struct lim_motion *motion, uint32_t time_ms, struct lim_instance *instance);

LIM_C_END

#endif
