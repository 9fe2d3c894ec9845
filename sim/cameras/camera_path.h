/* SPDX-License-Identifier: MIT
 *
 * Where the camera is in each frame, in metres and double precision: read from a camera file (a
 * line a frame, `ex ey ez tx ty tz`, perhaps with `@SECONDS` of the animation behind, '#' starts a comment) or an orbit
 * around a scene; and its conversion to the renderer's fixed-point camera. */
#ifndef SIM_CAMERA_PATH_H
#define SIM_CAMERA_PATH_H

#include "base/error.h"
#include "limner.h"
#include "scene/compiled.h"

#include <stddef.h>
#include <stdio.h>

struct viewpoint {
    double eye_m[3], target_m[3];
    size_t line; /* in the file, from 1; an orbit counts its frames */
    bool has_time;
    double time_s; /* where in the animation that is; only if has_time */
};

struct camera_path {
    char *name; /* the file's, for error messages */
    struct viewpoint *frames;
    size_t count; /* at least 1 */
};

/* The picture's half-sizes at distance 1, and where the view begins. */
struct lens {
    double tan_x, tan_y;
    double near_m;
    unsigned least_side_px; /* of the picture */
};

/* Orthonormal axes of the view; right = forward x up. */
struct view_axes {
    double right[3], up[3], forward[3];
};

/* Refuses, by FILE:LINE: reason, what is not six finite numbers, and an eye on its target. */
bool camera_path_read(const char *path, struct camera_path *out, struct error *err);

/* Refuses a path in which a camera has a time of its own: for whoever draws all of an animation. */
bool camera_path_is_timeless(const struct camera_path *path, struct error *err);

/* A line of such a file, as camera_path_read() reads it back. */
void viewpoint_write(const struct viewpoint *viewpoint, FILE *out);

/* frame_count frames once around the scene's bounds, from where all of it is in view; if no eye can be so far away,
 * from where it is along the picture's longer side, or from as far away as one can be. Small pictures, of SMALL_SIDE_PX
 * at most, it fills from top to bottom; in others the middle of its bounds is the picture's. */
enum { SMALL_SIDE_PX = 64 };
bool camera_path_orbit(const struct compiled *scene, const struct lens *lens, size_t frame_count,
                       struct camera_path *out, struct error *err);

/* A copy with at most `count` of the frames, the first of them and others as evenly as can be. */
bool camera_path_few(const struct camera_path *path, size_t count, struct camera_path *out, struct error *err);

void camera_path_free(struct camera_path *path);

/* When a camera looks, in whole milliseconds: its own time, or its part of all length_s of the animation. */
double camera_path_time_s(const struct camera_path *path, size_t frame, double length_s);

/* Whether any camera has a time of its own. */
bool camera_path_has_times(const struct camera_path *path);

/* An angle of view that nobody chose. */
#define LENS_USUAL 0.0

/* From top to bottom: 60 degrees; on displays that are so wide that such a lens would be too wide, what makes 60
 * degrees from side to side. */
double lens_usual_fov_deg(unsigned w_px, unsigned h_px);

/* fov_deg is vertical; pixels are square. Refuses what struct lim_camera cannot hold. */
bool lens_init(struct lens *lens, double fov_deg, double near_m, unsigned w_px, unsigned h_px, struct error *err);

/* Whether it takes LIM_HAS_TELE to draw as exactly through it as through others (camera.h). */
bool lens_is_long(const struct lens *lens);

/* The same from an angle, or LENS_USUAL. */
bool lens_fov_is_long(double fov_deg, unsigned w_px, unsigned h_px);

/* How near the near plane may be for the renderer to have it there, for any eye within the grid (camera.h): some units
 * of the grid, more for a narrow lens that is not a long one. */
double lens_least_near_m(const struct lens *lens, const struct grid *grid);

/* 0.1 m; a tenth of the longest side of a scene smaller than a metre. */
double lens_usual_near_m(const struct grid *grid);

/* The same, but in wide scenes more: lens_least_near_m() of a lens of 60 degrees. */
double lens_default_near_m(const struct grid *grid);

/* The distance that the grid forces on a near plane that nobody chose, or 0 if it is the default. */
double lens_forced_near_m(const struct grid *grid);

/* lens_init() for a scene; fov_deg may be LENS_USUAL; near_m 0 is the default, or what such a lens needs. Refuses a
 * near plane that the renderer would not have where it is asked for. */
bool lens_for_grid(struct lens *lens, double fov_deg, double near_m, const struct grid *grid, unsigned w_px,
                   unsigned h_px, struct error *err);

/* Of a number times that, three digits are not less than the number. */
#define LENS_PRINTED_UP 1.006

/* A line on standard error, if the default near plane is farther than usual: what is nearer is not drawn. */
void lens_note_near(const char *model_path, const struct grid *grid);

/* Looking straight up the picture's up is -z, straight down it is +z. */
void viewpoint_axes(const struct viewpoint *viewpoint, struct view_axes *axes);

/* Puts the eye somewhere along an axis, in the scene's units; it must be in range. */
void camera_put(struct lim_camera *camera, int axis, double eye_units, const struct grid *grid);

/* Eyes are nearer than that to the grid's origin, along each axis. */
double camera_eye_end_m(const struct grid *grid);

/* Rounds to nearest; refuses, naming the line, an eye or near plane out of the renderer's range. */
bool camera_path_to_camera(const struct camera_path *path, size_t frame, const struct lens *lens,
                           const struct grid *grid, struct lim_camera *camera, struct error *err);

#endif
