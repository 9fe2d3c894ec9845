/* SPDX-License-Identifier: MIT
 *
 * The mover's axes at rest are put into its node's coordinates, and out of them again at the time. */
#include "accuracy/source_pose.h"

#include "model/model_orientation.h"
#include "model/pose.h"

#include <math.h>

/* Where the node's axes go, as columns. */
static void columns_at(const struct model *model, size_t node, double time_s, double columns[3][3])
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            columns[i][k] = i == k;
        source_motion_leave(model->source_motion, node, time_s, false, columns[i]);
        orientation_point(model, columns[i]);
    }
}

static double triple(const double a[3], const double b[3], const double c[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]);
    return sum;
}

bool source_pose(const struct model *model, size_t mover, double time_s, struct model_pose *out)
{
    const struct source_motion *motion = model->source_motion;
    const struct model_mover *of = &model->movers[mover];
    if (!motion || !of->node || of->node > motion->count) return false;
    const size_t node = of->node - 1;
    const double length_s = round(motion->end_s * 1000) / 1000; /* firmware begins again in whole milliseconds */
    const double now_s = length_s > 0 ? fmod(time_s, length_s) : time_s;
    double rest[3][3], now[3][3], axes[3][3], turned[3][3];
    columns_at(model, node, NAN, rest);
    columns_at(model, node, now_s, now);
    pose_axes(&of->rest, axes);
    const double whole = triple(rest[0], rest[1], rest[2]);
    for (int i = 0; i < 3; i++) { /* Cramer's rule */
        const double part[3] = {triple(axes[i], rest[1], rest[2]) / whole, triple(rest[0], axes[i], rest[2]) / whole,
                                triple(rest[0], rest[1], axes[i]) / whole};
        for (int k = 0; k < 3; k++)
            turned[i][k] = now[0][k] * part[0] + now[1][k] * part[1] + now[2][k] * part[2];
    }
    for (int k = 0; k < 3; k++)
        out->at_m[k] = 0;
    source_motion_leave(motion, node, now_s, true, out->at_m);
    orientation_point(model, out->at_m);
    pose_turn_from_axes(out->turn, turned);
    return true;
}
