/* SPDX-License-Identifier: MIT
 *
 * Rigid motions in double precision: matrices, quaternions, and what lies between two keys. */
#ifndef SIM_POSE_H
#define SIM_POSE_H

#include "model/model.h"

/* The columns of a rotation: where the pose turns the axes. */
void pose_axes(const struct model_pose *pose, double axes[3][3]);

/* The quaternion of a rotation given by its columns. */
void pose_turn_from_axes(double turn[4], double axes[3][3]);

/* Into the pose's own coordinates, and out of them. */
void pose_enter(const struct model_pose *pose, const double at_m[3], double own_m[3]);
void pose_leave(const struct model_pose *pose, const double own_m[3], double at_m[3]);

/* The shorter way round, evenly; t from 0 to 1. */
void pose_turn_between(const double a[4], const double b[4], double t, double out[4]);

/* Where a mover is. After the last key of all movers, which is that of each, comes the first one again: in the
 * millisecond that is nearest. */
struct model_pose pose_at(const struct model *model, const struct model_mover *mover, double time_s);

#endif
