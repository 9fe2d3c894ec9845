/* SPDX-License-Identifier: MIT
 *
 * What stops who moves in a scene: a ray, a box, a walker. The scene's polygons in flash are asked as they are, through
 * its tree; nothing else is stored. DESIGN.md, "What stops a walker", says why it is so.
 *
 *     static lim_index stack[HALL_SCENE_DEPTH];
 *     struct lim_solid solid;
 *     struct lim_walker walker = {.at_q8 = HALL_POINT_Q8(2, 0, 3), .radius_q8 = HALL_M_Q8(0.3), ...};
 *     err = lim_solid_init(&solid, &hall_scene, stack, sizeof stack);
 *     err = lim_walker_move(&solid, &walker, x_q8, z_q8);
 *
 * Units are the scene's, with 8 fraction bits. Nothing is allocated, and nothing is kept from one call to the next but
 * what the caller's structs say. All processors get the same. What moves in the scene (struct lim_instance) stops
 * nobody. */
#ifndef LIM_COLLIDE_H
#define LIM_COLLIDE_H

#include "agree.h"
#include "scene.h"
#include "target.h"

LIM_C_BEGIN

/* A scene, and the memory that a way down its tree takes. */
struct lim_solid {
    const struct lim_scene *scene;
    lim_index *stack; /* scene->limits.depth of them, the caller's; used while a function here runs */
};

/* mem: aligned as lim_index is; it and the scene must outlive *solid. LIM_ERR_MEMORY: it is less than limits.depth
 * times sizeof(lim_index). LIM_ERR_SCENE: the scene is a mesh, which has no tree and no planes (compile it with --tree
 * bsp), or one of many scales (long.h). */
LIM_MUST_CHECK int lim_solid_init(struct lim_solid *solid, const struct lim_scene *scene, void *mem, size_t mem_b)
    LIM_AGREES(lim_solid_init);

/* Polygons stop who comes from the side that they face: as they are seen, so one passes from behind. With this they
 * stop who comes from behind, too. */
enum { LIM_STOP_BACKS = 1 };

/* What was met first. */
struct lim_hit {
    int32_t at_q8[3];  /* where: see the functions */
    uint32_t part_q30; /* how far along that is, of the way: 0..1, rounded down */
    lim_index record;  /* word offset of the polygon in scene->polygons */
    int16_t normal[3]; /* towards where one came from, not 0, of any length; rounded where the plane's has more bits */
};

/* Whether a segment meets a polygon: 1 and *hit, 0 and nothing is set, or LIM_ERR_CAMERA if a coordinate of an end is
 * not below LIM_EYE_MAX_Q8 (eye.h).
 *
 * It meets a polygon where it crosses its plane, on the plane included, coming from the side that the polygon faces; a
 * segment that begins on the plane comes from there, one that lies in it crosses nothing, nor does one without length.
 * The point where it crosses, seen along the longest component of the plane's normal (the first of them), must lie
 * within the polygon, by even and odd, or such that the square of one unit's side around it touches an edge: a corner
 * is off by half a unit, as it was rounded, and so neighbours leave no gap. All of that is exact, and so is which
 * polygon is the first; of those equally far away it is any. It is exact for scenes compiled with a tolerance of up to
 * half a unit, as they are by default: what lies further on the wrong side of a plane is not looked for there.
 *
 * hit->at_q8 is no further along than the crossing, never behind the plane, and at most 4/256 of a unit from the
 * crossing along each axis, or, where the way is so slant that this would be behind the plane, so much nearer that it
 * is not. */
LIM_MUST_CHECK int lim_trace(const struct lim_solid *solid, const int32_t from_q8[3], const int32_t to_q8[3],
                             uint8_t flags, struct lim_hit *hit);

#define LIM_BODY_MAX_Q8 (INT32_C(1) << 24) /* |x| of a box's middle stays below: twice the scene's cube */
#define LIM_HALF_MAX_Q8 (INT32_C(1) << 22) /* and half of its sides: a quarter of the cube's */
enum { LIM_SKIN_Q8 = 512 };                /* 2 units: how far from a wall who was stopped by it stays */

/* Moves an upright box, the middle of which is at from_q8, as far as it goes: 1 if it was stopped, 0 if it is at to_q8,
 * or LIM_ERR_CAMERA if a coordinate of an end is not below LIM_BODY_MAX_Q8, or a half not within 1..LIM_HALF_MAX_Q8.
 * *hit: at_q8 is where its middle is now, in any case, and part_q30 how far along; `record` and `normal` are of what
 * stopped it.
 *
 * A polygon is the convex hull of its corners here, which are exact. The box is stopped by polygons that its middle is
 * in front of as it begins, or on whose plane it is; with LIM_STOP_BACKS by all. It never enters one: where it ends,
 * and all along the way from from_q8 to at_q8, it has no inner point in common with any of these that it had none in
 * common with at from_q8. Around a closed solid, which its middle is not in, that goes for all polygons. It stops
 * LIM_SKIN_Q8 before what is in its way, along `normal`, or up to 1.8 times as far where that is slant; or where it is,
 * if it is nearer than that already. What it is in at the beginning it may leave: it is stopped if it goes towards the
 * polygon's back. Corners of a polygon that do not lie in one plane, by rounding, may stop it a unit early. */
LIM_MUST_CHECK int lim_sweep(const struct lim_solid *solid, const int32_t half_q8[3], const int32_t from_q8[3],
                             const int32_t to_q8[3], uint8_t flags, struct lim_hit *hit);

/* The same box slides: what stops it takes away the part of its way that leads into it, up to LIM_SLIDES times. at_q8:
 * its middle, before and after; ways are below LIM_BODY_MAX_Q8. Returns how often it was stopped, or LIM_ERR_CAMERA,
 * and nothing has moved. It flies: floors and ceilings are walls. */
enum { LIM_SLIDES = 4 };
LIM_MUST_CHECK int lim_slide(const struct lim_solid *solid, const int32_t half_q8[3], int32_t at_q8[3],
                             const int32_t way_q8[3], uint8_t flags);

#define LIM_WALKER_WAY_MAX_Q8 (INT32_C(1) << 20) /* of a move, along x and z: below */
#define LIM_GRAVITY_MAX_Q8 (INT32_C(1) << 16)

/* Who walks: an upright box with a square base. */
struct lim_walker {
    int32_t at_q8[3];   /* the middle of its base: where its feet are */
    int32_t radius_q8;  /* half of the base's side, 1..LIM_HALF_MAX_Q8 */
    int32_t height_q8;  /* 1..2 LIM_HALF_MAX_Q8; an eye belongs below it, by the distance of the near plane and more */
    int32_t step_q8;    /* how high a step it climbs, below height_q8; 0: none */
    int32_t gravity_q8; /* by which its fall gets longer with each move, 0..LIM_GRAVITY_MAX_Q8 */
    int32_t fall_q8;    /* how far it fell in the last move; 0 to begin with, or below to jump */
    bool stands;        /* on something that is no steeper than 45 degrees; false to begin with */
};
#define LIM_FALL_MAX_Q8 (INT32_C(1) << 20)

/* A move of a walker, once a frame: a way on the level, |x|, |z| < LIM_WALKER_WAY_MAX_Q8, along which it slides along
 * walls and climbs steps; then it falls, or stays on the ground where that goes down by a step and no more. Its box
 * moves as lim_sweep() moves one, so it is never in a wall that it did not begin in. It climbs what is step_q8 high, or
 * less, and nothing that is more than 4 units higher. LIM_ERR_CAMERA: it is, or would get, out of range, or its sizes
 * are; nothing has moved then. */
LIM_MUST_CHECK int lim_walker_move(const struct lim_solid *solid, struct lim_walker *walker, int32_t x_q8,
                                   int32_t z_q8);

LIM_C_END

#endif
