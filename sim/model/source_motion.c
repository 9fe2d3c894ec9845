/* SPDX-License-Identifier: MIT */
#include "model/source_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double JUMP_S = 1e-5;

void source_motion_free(struct source_motion *motion)
{
    for (size_t i = 0; i < motion->count; i++)
        for (int part = 0; part < SOURCE_PARTS; part++) {
            free(motion->nodes[i].keys[part].times_s);
            free(motion->nodes[i].keys[part].numbers);
        }
    free(motion->nodes);
    *motion = (struct source_motion){0};
}

static size_t row_of(const struct source_keys *keys)
{
    return keys->joined == JOINED_BY_SPLINES ? 3 * keys->width : keys->width;
}

/* Their values lie in the middle of a spline's rows. */
static const double *value_of(const struct source_keys *keys, size_t key)
{
    const size_t row = row_of(keys);
    return &keys->numbers[key * row + (row - keys->width) / 2];
}

bool source_keys_vary(const struct source_keys *keys)
{
    const size_t row = row_of(keys);
    for (size_t i = 0; i < keys->count * row; i++) {
        const bool is_tangent = row != keys->width && i % row / keys->width != 1;
        const bool is_outside = i < keys->width || i >= keys->count * row - keys->width;
        if (is_tangent && !is_outside && keys->numbers[i] != 0) return true;
        if (!is_tangent && keys->numbers[i] != value_of(keys, 0)[i % keys->width]) return true;
    }
    return false;
}

/* Along the great circle from a to the nearer of b and -b: by the sine of its parts. */
static void slerp(const double a[4], const double b[4], double t, double out[4])
{
    double cosine = 0;
    for (int i = 0; i < 4; i++)
        cosine += a[i] * b[i];
    const double nearer = cosine < 0 ? -1 : 1;
    const double angle = acos(fmin(nearer * cosine, 1));
    for (int i = 0; i < 4; i++)
        out[i] = sin(angle) < 1e-8 ? a[i] + t * (nearer * b[i] - a[i])
                                   : (a[i] * sin(angle * (1 - t)) + nearer * b[i] * sin(angle * t)) / sin(angle);
}

/* p(t) of the specification's appendix C. */
static void spline(const struct source_keys *keys, size_t key, double t, double out[4])
{
    const double span_s = keys->times_s[key + 1] - keys->times_s[key];
    const double *from = value_of(keys, key), *to = value_of(keys, key + 1);
    for (size_t i = 0; i < keys->width; i++) {
        const double leaves = from[keys->width + i] * span_s, comes = *(to - keys->width + i) * span_s;
        const double c2 = 3 * (to[i] - from[i]) - 2 * leaves - comes, c3 = 2 * (from[i] - to[i]) + leaves + comes;
        out[i] = ((c3 * t + c2) * t + leaves) * t + from[i];
    }
}

static void make_unit(size_t width, double v[4])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
    for (int i = 0; i < 4 && width == 4; i++)
        v[i] = length > 0 ? v[i] / length : i == 3;
}

static void unit_value(const struct source_keys *keys, size_t key, double out[4])
{
    memcpy(out, value_of(keys, key), keys->width * sizeof *out);
    make_unit(keys->width, out);
}

void source_keys_at(const struct source_keys *keys, double time_s, double out[4])
{
    const double slack_s = keys->joined == JOINED_BY_STEPS ? JUMP_S : 0;
    size_t key = keys->count - 1;
    double from[4] = {0}, to[4] = {0};
    while (key > 0 && keys->times_s[key] > time_s + slack_s)
        key--;
    unit_value(keys, key, out);
    if (key + 1 == keys->count || keys->joined == JOINED_BY_STEPS || time_s <= keys->times_s[key]) return;
    const double t = (time_s - keys->times_s[key]) / (keys->times_s[key + 1] - keys->times_s[key]);
    unit_value(keys, key, from);
    unit_value(keys, key + 1, to);
    if (keys->joined == JOINED_BY_SPLINES)
        spline(keys, key, t, out);
    else if (keys->width == 4)
        slerp(from, to, t, out);
    else
        for (size_t i = 0; i < keys->width; i++)
            out[i] = (1 - t) * from[i] + t * to[i];
    make_unit(keys->width, out);
}

/* Twice the cross product of the quaternion's vector, and that once more (Rodrigues). */
static void turn(const double q[4], double v[3])
{
    double once[3];
    for (int i = 0; i < 3; i++)
        once[i] = 2 * (q[(i + 1) % 3] * v[(i + 2) % 3] - q[(i + 2) % 3] * v[(i + 1) % 3]);
    for (int i = 0; i < 3; i++)
        v[i] += q[3] * once[i] + q[(i + 1) % 3] * once[(i + 2) % 3] - q[(i + 2) % 3] * once[(i + 1) % 3];
}

static void leave_matrix(const double m[16], bool is_point, double v[3])
{
    const double from[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++)
        v[i] = m[i] * from[0] + m[4 + i] * from[1] + m[8 + i] * from[2] + (is_point ? m[12 + i] : 0);
}

static bool has_keys(const struct source_node *node)
{
    return node->keys[SOURCE_AT].count || node->keys[SOURCE_TURN].count || node->keys[SOURCE_SCALE].count;
}

void source_motion_leave(const struct source_motion *motion, size_t node, double time_s, bool is_point, double v[3])
{
    for (size_t i = node + 1; i; i = motion->nodes[i - 1].above) {
        const struct source_node *own = &motion->nodes[i - 1];
        double parts[SOURCE_PARTS][4];
        if (own->has_matrix && !has_keys(own)) {
            leave_matrix(own->matrix, is_point, v);
            continue;
        }
        memcpy(parts, own->parts, sizeof parts);
        for (int part = 0; part < SOURCE_PARTS && !isnan(time_s); part++)
            if (own->keys[part].count) source_keys_at(&own->keys[part], time_s, parts[part]);
        for (int k = 0; k < 3; k++)
            v[k] *= parts[SOURCE_SCALE][k];
        turn(parts[SOURCE_TURN], v);
        for (int k = 0; k < 3 && is_point; k++)
            v[k] += parts[SOURCE_AT][k];
    }
}
