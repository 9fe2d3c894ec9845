/* SPDX-License-Identifier: MIT
 *
 * Small scenes with movers, built in a test, compiled, drawn by the simulator and compared with the reference. */
#ifndef TESTS_MOVER_RIG_H
#define TESTS_MOVER_RIG_H

#include "accuracy/compare.h"
#include "boxes.h"
#include "compiler/moving_compile.h"
#include "render/ids.h"

enum { MOVER_RIG_W_PX = 160, MOVER_RIG_H_PX = 120 };

/* What stands still, and what moves, before it is compiled; zeroed at first. */
struct mover_rig {
    struct model model;
    struct compiled scene;
    struct moving moving;
    struct ids ids;
    struct reference reference;
    struct compare_counts counts; /* of all views so far */
    enum tree_kind tree;          /* of what stands still */
    enum mesh_leaves mesh_leaves;
    enum coordinates coordinates;
    size_t still; /* faces that belong to something already */
};

/* The faces that were added to the model since the last call of either stand still. */
void mover_rig_stands(struct mover_rig *rig);

/* They move together: at rest where they are, and in the frame
 * where `pose` takes them. */
void mover_rig_moves(struct mover_rig *rig, const struct model_pose *pose);

/* What stands still: a room of 8 x 3 x 8 m, cut in two by a wall from z = -0.1 to 0.1 with a doorway of a metre in its
 * middle, or with none. */
void mover_rig_add_rooms(struct mover_rig *rig, bool doorway);

/* What moves: a box around the origin, of these half sizes. */
void mover_rig_add_box(struct mover_rig *rig, double x_m, double y_m, double z_m, const struct model_pose *pose);

/* No more is added. `core` may be NULL: fast. */
void mover_rig_compile(struct mover_rig *rig, enum lim_method method, const struct core *core);

/* Draws the movers where their poses take them, and compares. */
void mover_rig_view(struct mover_rig *rig, const double eye_m[3], const double target_m[3]);

/* Room for other movers than what was measured. */
void mover_rig_limit(struct mover_rig *rig, const struct lim_movers_limits *limits);

/* Changes where the reference has a mover's corners, in its own coordinates. */
void mover_rig_bend(struct mover_rig *rig, size_t mover, void (*bend)(double at_m[3], double how), double how);

/* How many pixels of the last view show a face of a mover (from 1), or of what stands still (0). */
size_t mover_rig_pixels(const struct mover_rig *rig, size_t mover);

/* Of all views at most so many pixels of a million are wrong, none is a hole; in the last nothing that moves was left
 * out. */
void mover_rig_assert_right(const struct mover_rig *rig, double ppm);

const struct lim_stats *mover_rig_stats(const struct mover_rig *rig);

void mover_rig_free(struct mover_rig *rig);

/* A turn by an angle in radians about an axis of any length, and a place. */
struct model_pose mover_rig_pose(double x_m, double y_m, double z_m, const double axis[3], double angle);

#endif
