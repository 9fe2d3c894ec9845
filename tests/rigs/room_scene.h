/* SPDX-License-Identifier: MIT
 *
 * Buildings to look through: rooms in a grid, walls with matter between, doors in them, boxes that stand and float in
 * the rooms, screens with one side or two. By hand, or at random and turned every way. */
#ifndef TESTS_ROOM_SCENE_H
#define TESTS_ROOM_SCENE_H

#include "cameras/camera_path.h"
#include "compiler/compile.h"
#include "model/model.h"
#include "random.h"
#include "scene/compiled.h"

struct room_scene {
    struct model model;
    double turn[3][3];  /* of all that is added */
    double extent_m[3]; /* of a random one, before it is turned */
};

/* Empty, and not turned. */
void room_scene_begin(struct room_scene *scene);
void room_scene_free(struct room_scene *scene);

/* A rectangle of the plane axis = at that faces up the axis (sign 1) or down (-1). a and b are its ends along the axes
 * that follow in the order x, y, z, x. */
void room_scene_quad(struct room_scene *scene, int axis, double at, int sign, const double a[2], const double b[2],
                     uint32_t colour);

/* The outsides of a box. */
void room_scene_box(struct room_scene *scene, const double low[3], const double high[3], uint32_t colour);

/* A wall of a room at x or z = at, 2.5 m high, from t[0] to t[1] along the other axis; with a door in it, 2 m high,
 * from door[0] to door[1], unless door is NULL. */
void room_scene_wall(struct room_scene *scene, int axis, double at, int sign, const double t[2], const double *door,
                     uint32_t colour);

/* Floor and ceiling of a room or a doorway. */
void room_scene_floor(struct room_scene *scene, const double x[2], const double z[2], double height_m, uint32_t colour);

void room_scene_random(struct room_scene *scene, struct random *random);

/* An eye anywhere in the building, walls and boxes included, often on a whole decimetre: on some plane. */
struct viewpoint room_scene_view(const struct room_scene *scene, struct random *random);

/* Compiles it, every face for itself. A failure ends the test, except with `err`, where it is returned. */
bool room_scene_compile(const struct room_scene *scene, enum portals_wanted portals, const struct core *core,
                        struct compiled *out, struct error *err);

/* The same with coordinates of 32 bits. */
bool room_scene_compile_long(const struct room_scene *scene, enum portals_wanted portals, const struct core *core,
                             struct compiled *out, struct error *err);

#endif
