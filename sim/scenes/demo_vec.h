/* SPDX-License-Identifier: MIT
 *
 * Vectors, planes and frames of the demo scene's generator, in double precision. Metres, y up,
 * right-handed; parts of furniture are given in whole millimetres within their frame. */
#ifndef DEMO_VEC_H
#define DEMO_VEC_H

#include <math.h>

#define DEMO_PI 3.14159265358979323846

struct vec3 {
    double x, y, z;
};

/* A point is inside where dot(normal, point) >= offset. */
struct plane {
    struct vec3 normal;
    double offset;
};

/* A placed coordinate system: right, up and front are its unit x, y and z axes. */
struct frame {
    struct vec3 origin, right, up, front;
};

static inline struct vec3 vec_add(struct vec3 a, struct vec3 b)
{
    return (struct vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct vec3 vec_sub(struct vec3 a, struct vec3 b)
{
    return (struct vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct vec3 vec_scale(struct vec3 a, double s)
{
    return (struct vec3){a.x * s, a.y * s, a.z * s};
}

static inline struct vec3 vec_mul(struct vec3 a, struct vec3 b)
{
    return (struct vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

static inline double vec_dot(struct vec3 a, struct vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vec3 vec_cross(struct vec3 a, struct vec3 b)
{
    return (struct vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vec_length(struct vec3 a)
{
    return sqrt(vec_dot(a, a));
}

static inline struct vec3 vec_unit(struct vec3 a)
{
    return vec_scale(a, 1 / vec_length(a));
}

static inline struct vec3 vec_lerp(struct vec3 a, struct vec3 b, double t)
{
    return vec_add(a, vec_scale(vec_sub(b, a), t));
}

static inline double plane_distance(struct plane plane, struct vec3 point)
{
    return vec_dot(plane.normal, point) - plane.offset;
}

/* At a place in millimetres, turned about y: yaw 0 faces +z, yaw 90 faces +x. */
static inline struct frame frame_at(double x_mm, double y_mm, double z_mm, double yaw_deg)
{
    double s = sin(yaw_deg * DEMO_PI / 180), c = cos(yaw_deg * DEMO_PI / 180);
    return (struct frame){{x_mm / 1000, y_mm / 1000, z_mm / 1000}, {c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

static inline struct vec3 frame_point(const struct frame *frame, double x_mm, double y_mm, double z_mm)
{
    struct vec3 p = vec_add(frame->origin, vec_scale(frame->right, x_mm / 1000));
    p = vec_add(p, vec_scale(frame->up, y_mm / 1000));
    return vec_add(p, vec_scale(frame->front, z_mm / 1000));
}

/* The frame moved within itself. */
static inline struct frame frame_move(struct frame frame, double x_mm, double y_mm, double z_mm)
{
    frame.origin = frame_point(&frame, x_mm, y_mm, z_mm);
    return frame;
}

/* The frame leaning back, away from its front. */
static inline struct frame frame_lean(struct frame frame, double lean_deg)
{
    double s = sin(lean_deg * DEMO_PI / 180), c = cos(lean_deg * DEMO_PI / 180);
    struct vec3 up = frame.up, front = frame.front;
    frame.up = vec_sub(vec_scale(up, c), vec_scale(front, s));
    frame.front = vec_add(vec_scale(front, c), vec_scale(up, s));
    return frame;
}

/* The frame tipped sideways, clockwise as its front's viewer sees it. */
static inline struct frame frame_tip(struct frame frame, double tip_deg)
{
    double s = sin(tip_deg * DEMO_PI / 180), c = cos(tip_deg * DEMO_PI / 180);
    struct vec3 right = frame.right, up = frame.up;
    frame.right = vec_sub(vec_scale(right, c), vec_scale(up, s));
    frame.up = vec_add(vec_scale(up, c), vec_scale(right, s));
    return frame;
}

/* The frame turned about its own up axis. */
static inline struct frame frame_turn(struct frame frame, double yaw_deg)
{
    double s = sin(yaw_deg * DEMO_PI / 180), c = cos(yaw_deg * DEMO_PI / 180);
    struct vec3 right = frame.right, front = frame.front;
    frame.right = vec_sub(vec_scale(right, c), vec_scale(front, s));
    frame.front = vec_add(vec_scale(front, c), vec_scale(right, s));
    return frame;
}

#endif
