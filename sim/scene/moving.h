/* SPDX-License-Identifier: MIT
 *
 * A model with moving objects: what stands still is one compiled scene, each object another, on the same grid or one
 * that is finer by a power of two; and the table of each object's motion. */
#ifndef SIM_MOVING_H
#define SIM_MOVING_H

#include "limner.h"
#include "long.h"
#include "scene/compiled.h"

struct moving_object {
    char name[MODEL_NAME_B];
    struct compiled scene; /* its faces have the model's numbers */
    lim_index *words;      /* scene.scene.polygons, if they name textures of the scene that it moves in; else NULL */
    struct lim_motion motion;
    struct lim_motion_key *keys;
    struct lim_long_vertex *origins; /* of a scene of many scales: motion's; else NULL */
};

struct moving {
    struct model model;             /* as it was read: movers and keys */
    struct moving_object *objects;  /* one a mover of the model */
    struct lim_instance *instances; /* likewise */
    size_t count;                   /* 0: nothing moves */
    size_t stopped;                 /* not 0: MOVING_OFF made a part of the scene of what is animated */
    struct lim_light light;         /* on: objects have none baked in */
    struct lim_movers_limits limits;
    struct grid grid; /* of what stands still */
};

/* What stands still, made fit for its tree (mesh_clean()): on the grid that it has, if coordinates have 32 bits. */
bool moving_clean_still(const struct moving *moving, const struct model *still, struct mesh *mesh, struct error *err);

/* The time of the last keys. */
double moving_length_s(const struct moving *moving);

/* When frame i of count is drawn that are spread over the whole animation; firmware counts milliseconds. */
double moving_time_s(const struct moving *moving, size_t frame, size_t count);

/* Places all instances as firmware would. */
void moving_pose(struct moving *moving, double time_s);

void moving_free(struct moving *moving);

#endif
