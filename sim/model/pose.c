/* SPDX-License-Identifier: MIT
 *
 * Shoemake's quaternions. */
#include "model/pose.h"

#include "base/vec3.h"

#include <string.h>

void pose_axes(const struct model_pose *pose, double axes[3][3])
{
    const double *q = pose->turn;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        axes[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
        axes[i][j] = 2 * (q[i] * q[j] + q[k] * q[3]);
        axes[i][k] = 2 * (q[i] * q[k] - q[j] * q[3]);
    }
}

/* By the largest component, so that nothing small divides. */
void pose_turn_from_axes(double turn[4], double axes[3][3])
{
    const double trace = axes[0][0] + axes[1][1] + axes[2][2];
    int largest = 3;
    double most = trace;
    for (int i = 0; i < 3; i++)
        if (axes[i][i] > most) most = axes[i][i], largest = i;
    double length = 0;
    if (largest == 3) {
        turn[3] = 1 + trace;
        for (int i = 0; i < 3; i++)
            turn[i] = axes[(i + 1) % 3][(i + 2) % 3] - axes[(i + 2) % 3][(i + 1) % 3];
    } else {
        const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
        turn[i] = 1 + axes[i][i] - axes[j][j] - axes[k][k];
        turn[j] = axes[i][j] + axes[j][i];
        turn[k] = axes[i][k] + axes[k][i];
        turn[3] = axes[j][k] - axes[k][j];
    }
    for (int i = 0; i < 4; i++)
        length = hypot(length, turn[i]);
    for (int i = 0; i < 4; i++)
        turn[i] /= length;
}

void pose_enter(const struct model_pose *pose, const double at_m[3], double own_m[3])
{
    double axes[3][3], from[3];
    pose_axes(pose, axes);
    vec3_sub(from, at_m, pose->at_m);
    for (int i = 0; i < 3; i++)
        own_m[i] = vec3_dot(axes[i], from);
}

void pose_leave(const struct model_pose *pose, const double own_m[3], double at_m[3])
{
    double axes[3][3];
    pose_axes(pose, axes);
    for (int i = 0; i < 3; i++)
        at_m[i] = pose->at_m[i] + axes[0][i] * own_m[0] + axes[1][i] * own_m[1] + axes[2][i] * own_m[2];
}

void pose_turn_between(const double a[4], const double b[4], double t, double out[4])
{
    double dot = 0, length = 0;
    for (int i = 0; i < 4; i++)
        dot += a[i] * b[i];
    const double sign = dot < 0 ? -1 : 1, arc = acos(fmin(fabs(dot), 1));
    const double w0 = arc > 1e-9 ? sin((1 - t) * arc) : 1 - t, w1 = arc > 1e-9 ? sin(t * arc) : t;
    for (int i = 0; i < 4; i++) {
        out[i] = w0 * a[i] + sign * w1 * b[i];
        length = hypot(length, out[i]);
    }
    for (int i = 0; i < 4; i++)
        out[i] /= length;
}

struct model_pose pose_at(const struct model *model, const struct model_mover *mover, double time_s)
{
    const struct model_key *key = &model->keys[mover->first_key], *last = key + mover->key_count - 1;
    const double length_s = round(last->time_s * 1000) / 1000; /* as firmware counts */
    if (length_s > 0) time_s = fmod(time_s, length_s);
    while (key < last && key[1].time_s <= time_s)
        key++;
    if (key == last || time_s <= key->time_s) return key->pose;
    const double t = (time_s - key->time_s) / (key[1].time_s - key->time_s);
    struct model_pose pose;
    for (int i = 0; i < 3; i++)
        pose.at_m[i] = key->pose.at_m[i] + t * (key[1].pose.at_m[i] - key->pose.at_m[i]);
    pose_turn_between(key->pose.turn, key[1].pose.turn, t, pose.turn);
    return pose;
}
