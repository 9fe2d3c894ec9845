/* SPDX-License-Identifier: MIT
 *
 * Camera files, the default orbit, and the step from metres to the renderer's units: the eye is
 * rounded to 1/256 unit, angles to 2^-32 of a turn, tangents to 2^-28. */
#include "cameras/camera_path.h"

#include "base/input_file.h"
#include "base/notice.h"
#include "scene/vertex_units.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { NUMBERS_A_LINE = 6, LINE_MOST_B = 4096, FILE_MOST_B = 64 << 20, CAMERAS_MOST = 100000 };
static const double COORDINATE_MAX_M = 1e9;   /* keeps differences and their squares far from overflow */
static const double TIME_MAX_S = 4e6;         /* in milliseconds 32 bits hold it */
static const double EYE_END_Q8 = 268435456.0; /* 2^28, exclusive */
static const double GRID_END_UNITS = 32768.0;
static const double NEAR_MAX_Q8 = 16777216.0; /* 2^24 */
static const double DEFAULT_FOV_DEG = 60.0;
static const double LONG_NEAR_UNITS = 16.0; /* eyes come as near to the smallest things as others do to large ones */
static const double TANGENT_MIN = 1.0 / 2048.0, TANGENT_LONG = 1.0 / 8.0, TANGENT_MAX = 4.0; /* camera.h */

static void viewpoint_direction(const struct viewpoint *viewpoint, double direction[3])
{
    double length = 0.0;
    for (int i = 0; i < 3; i++) {
        direction[i] = viewpoint->target_m[i] - viewpoint->eye_m[i];
        length = hypot(length, direction[i]);
    }
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

/* Straight up and straight down have no yaw of their own: half a turn gives the picture's up. */
static double direction_yaw(const double direction[3])
{
    if (direction[0] == 0.0 && direction[2] == 0.0) return PI;
    return atan2(-direction[0], -direction[2]);
}

static double direction_pitch(const double direction[3])
{
    return atan2(direction[1], hypot(direction[0], direction[2]));
}

void viewpoint_axes(const struct viewpoint *viewpoint, struct view_axes *axes)
{
    viewpoint_direction(viewpoint, axes->forward);
    double yaw = direction_yaw(axes->forward);
    double sin_yaw = sin(yaw), cos_yaw = cos(yaw);
    double rise = axes->forward[1], run = hypot(axes->forward[0], axes->forward[2]);
    memcpy(axes->right, (double[3]){cos_yaw, 0.0, -sin_yaw}, sizeof axes->right);
    memcpy(axes->up, (double[3]){sin_yaw * rise, run, cos_yaw * rise}, sizeof axes->up);
}

/* Files -------------------------------------------------------------------------------------- */

/* Takes `@SECONDS` from the end of a line; false: it is no time. */
static bool take_time(char *line, struct viewpoint *out)
{
    char *at = strchr(line, '@'), *end;
    if (!at) return true;
    if (at == line || !isspace((unsigned char)at[-1])) return false;
    out->time_s = strtod(at + 1, &end);
    if (end == at + 1 || end[strspn(end, " \t\r\n")]) return false;
    *at = '\0';
    out->has_time = true;
    return out->time_s >= 0.0 && out->time_s <= TIME_MAX_S;
}

/* Parses a line of numbers; how many there are, or -1 for anything else. */
static int line_numbers(char *line, double numbers[NUMBERS_A_LINE])
{
    int count = 0;
    for (char *at = line;; count++) {
        while (isspace((unsigned char)*at))
            at++;
        if (!*at) return count;
        char *end;
        double number = strtod(at, &end);
        if (end == at || (*end && !isspace((unsigned char)*end))) return -1;
        if (count < NUMBERS_A_LINE) numbers[count] = number;
        at = end;
    }
}

static bool line_viewpoint(char *line, struct viewpoint *out, bool *is_blank, const char **reason)
{
    double numbers[NUMBERS_A_LINE];
    line[strcspn(line, "#")] = '\0';
    *reason = "not a time; one is @SECONDS at the end of a line";
    if (!take_time(line, out)) return false;
    int count = line_numbers(line, numbers);
    *is_blank = count == 0 && !out->has_time;
    if (*is_blank) return true;
    *reason = "not a number; a line is ex ey ez tx ty tz";
    if (count < 0) return false;
    *reason = count < NUMBERS_A_LINE ? "fewer than six numbers; a line is ex ey ez tx ty tz"
                                     : "more than six numbers; a line is ex ey ez tx ty tz";
    if (count != NUMBERS_A_LINE) return false;
    *reason = "a coordinate is not finite or beyond 1e9 m";
    for (int i = 0; i < NUMBERS_A_LINE; i++)
        if (!(fabs(numbers[i]) <= COORDINATE_MAX_M)) return false;
    memcpy(out->eye_m, numbers, sizeof out->eye_m);
    memcpy(out->target_m, numbers + 3, sizeof out->target_m);
    double length_m = hypot(hypot(numbers[3] - numbers[0], numbers[4] - numbers[1]), numbers[5] - numbers[2]);
    *reason = "eye and target are the same point";
    return isnormal(length_m);
}

static bool path_append(struct camera_path *path, const struct viewpoint *viewpoint)
{
    bool is_full = (path->count & (path->count - 1)) == 0; /* the array doubles at powers of two */
    if (is_full) {
        size_t capacity = path->count ? 2 * path->count : 1;
        struct viewpoint *frames = realloc(path->frames, capacity * sizeof *frames);
        if (!frames) return false;
        path->frames = frames;
    }
    path->frames[path->count++] = *viewpoint;
    return true;
}

static bool read_lines(struct input_lines *lines, struct camera_path *path, struct error *err)
{
    const char *reason = NULL;
    while (!reason && input_line(lines, err)) {
        struct viewpoint viewpoint = {.line = lines->number};
        bool is_blank;
        const char *wrong = NULL;
        if (!line_viewpoint(lines->line, &viewpoint, &is_blank, &wrong))
            reason = wrong;
        else if (!is_blank && path->count == CAMERAS_MOST)
            return error_set(err, "%s:%zu: more than %d cameras", path->name, lines->number, CAMERAS_MOST);
        else if (!is_blank && !path_append(path, &viewpoint))
            reason = "out of memory";
    }
    if (reason) return error_set(err, "%s:%zu: %s", path->name, lines->number, reason);
    if (err->text[0]) return false;
    if (path->count == 0) return error_set(err, "%s: no camera in it; a line is ex ey ez tx ty tz", path->name);
    return true;
}

bool camera_path_read(const char *name, struct camera_path *out, struct error *err)
{
    struct input_lines lines = {.path = name, .line_most_b = LINE_MOST_B};
    memset(out, 0, sizeof *out);
    err->text[0] = '\0';
    lines.file = input_open(name, FILE_MOST_B, NULL, err);
    if (!lines.file) return false;
    out->name = strdup(name);
    bool ok = out->name ? read_lines(&lines, out, err) : error_set(err, "%s: out of memory", name);
    input_lines_free(&lines);
    fclose(lines.file);
    if (!ok) camera_path_free(out);
    return ok;
}

bool camera_path_is_timeless(const struct camera_path *path, struct error *err)
{
    for (size_t i = 0; i < path->count; i++)
        if (path->frames[i].has_time)
            return error_set(err, "%s:%zu: a camera with a time, which this command does not draw", path->name,
                             path->frames[i].line);
    return true;
}

double camera_path_time_s(const struct camera_path *path, size_t frame, double length_s)
{
    const struct viewpoint *viewpoint = &path->frames[frame];
    if (viewpoint->has_time) return round(1000 * viewpoint->time_s) / 1000;
    return floor(1000 * length_s * (double)frame / (double)path->count) / 1000;
}

bool camera_path_has_times(const struct camera_path *path)
{
    bool has = false;
    for (size_t i = 0; i < path->count; i++)
        has |= path->frames[i].has_time;
    return has;
}

void viewpoint_write(const struct viewpoint *viewpoint, FILE *out)
{
    const double *eye_m = viewpoint->eye_m, *target_m = viewpoint->target_m;
    fprintf(out, "%.15g %.15g %.15g %.15g %.15g %.15g", eye_m[0], eye_m[1], eye_m[2], target_m[0], target_m[1],
            target_m[2]);
    if (viewpoint->has_time) fprintf(out, " @%.15g", viewpoint->time_s);
    fputc('\n', out);
}

bool camera_path_few(const struct camera_path *path, size_t count, struct camera_path *out, struct error *err)
{
    out->count = count < path->count ? count : path->count;
    out->name = strdup(path->name);
    out->frames = calloc(out->count, sizeof *out->frames);
    if (!out->name || !out->frames) {
        camera_path_free(out);
        return error_set(err, "%s: out of memory", path->name);
    }
    for (size_t i = 0; i < out->count; i++)
        out->frames[i] = path->frames[i * path->count / out->count];
    return true;
}

void camera_path_free(struct camera_path *path)
{
    free(path->name);
    free(path->frames);
    memset(path, 0, sizeof *path);
}

/* Orbit -------------------------------------------------------------------------------------- */

enum { HEIGHT_STEPS = 16, HEIGHT_FRAMES = 36 };
static const double ORBIT_ELEVATION = 25.0 / 180.0 * PI;
static const double STEEP_ELEVATION = 36.0 / 180.0 * PI; /* from so near a box shows its top, too */

static void vertex_m(const struct compiled *compiled, size_t index, double out_m[3])
{
    double units[3];
    vertex_units(&compiled->scene, (lim_index)index, units);
    for (int i = 0; i < 3; i++)
        out_m[i] = compiled->grid.origin_m[i] + units[i] / compiled->grid.units_per_m;
}

/* Returns half of its height. */
static double scene_centre(const struct compiled *compiled, double centre_m[3])
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t v = 0; v < compiled->scene.vertex_count; v++) {
        double corner_m[3];
        vertex_m(compiled, v, corner_m);
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], corner_m[i]);
            high[i] = fmax(high[i], corner_m[i]);
        }
    }
    for (int i = 0; i < 3; i++)
        centre_m[i] = (low[i] + high[i]) / 2.0;
    return (high[1] - low[1]) / 2.0;
}

struct orbit {
    double centre_m[3], elevation;
    size_t frame_count;
};

/* The eye in one frame of an orbit, distance_m from the centre. */
static struct viewpoint orbit_viewpoint(const struct orbit *orbit, double distance_m, size_t frame)
{
    const double *centre_m = orbit->centre_m, turn = 2.0 * PI * (double)frame / (double)orbit->frame_count;
    const double out_m = distance_m * cos(orbit->elevation), up_m = distance_m * sin(orbit->elevation);
    return (struct viewpoint){
        .eye_m = {centre_m[0] + out_m * sin(turn), centre_m[1] + up_m, centre_m[2] + out_m * cos(turn)},
        .target_m = {centre_m[0], centre_m[1], centre_m[2]},
        .line = frame + 1};
}

/* How far from the centre the eye must be to see all vertices: with q the way from the centre to a
 * vertex, |q . right| <= tan_x (distance + q . forward), and the same for up. */
static double distance_to_see_all(const struct compiled *compiled, const struct lens *lens, const double centre_m[3],
                                  const struct view_axes *axes)
{
    double distance_m = 0.0;
    for (size_t v = 0; v < compiled->scene.vertex_count; v++) {
        double corner_m[3], right_m = 0.0, up_m = 0.0, forward_m = 0.0;
        vertex_m(compiled, v, corner_m);
        for (int i = 0; i < 3; i++) {
            right_m += (corner_m[i] - centre_m[i]) * axes->right[i];
            up_m += (corner_m[i] - centre_m[i]) * axes->up[i];
            forward_m += (corner_m[i] - centre_m[i]) * axes->forward[i];
        }
        double depth_m = fmax(fabs(right_m) / lens->tan_x, fabs(up_m) / lens->tan_y);
        distance_m = fmax(distance_m, depth_m - forward_m);
    }
    return distance_m;
}

/* From where all of it is in view in each frame. */
static double orbit_distance_m(const struct compiled *scene, const struct lens *lens, const struct orbit *orbit)
{
    double distance_m = 0.0;
    for (size_t frame = 0; frame < orbit->frame_count; frame++) {
        const struct viewpoint viewpoint = orbit_viewpoint(orbit, 1.0, frame);
        struct view_axes axes;
        viewpoint_axes(&viewpoint, &axes);
        distance_m = fmax(distance_m, distance_to_see_all(scene, lens, orbit->centre_m, &axes));
    }
    return distance_m;
}

static double distance_at_m(const struct compiled *scene, const struct lens *lens, struct orbit orbit, double height_m)
{
    orbit.centre_m[1] = height_m;
    return orbit_distance_m(scene, lens, &orbit);
}

/* Moves the centre up or down to where the eye may be nearest: what is near and low takes more room than what is far
 * and high. The distance is the greatest of functions that are linear in the height: the golden section finds the
 * least. Of long orbits it looks at a frame each ten degrees, between which a scene's outline hardly differs: the
 * distance itself is that for all frames. */
static void settle_height(const struct compiled *scene, const struct lens *lens, double half_m, struct orbit *orbit)
{
    const double golden = (sqrt(5.0) - 1.0) / 2.0;
    struct orbit few = *orbit;
    if (few.frame_count > HEIGHT_FRAMES) few.frame_count = HEIGHT_FRAMES;
    double low_m = orbit->centre_m[1] - half_m, high_m = orbit->centre_m[1] + half_m;
    for (int step = 0; step < HEIGHT_STEPS; step++) {
        const double part_m = golden * (high_m - low_m), lower_m = high_m - part_m, upper_m = low_m + part_m;
        if (distance_at_m(scene, lens, few, lower_m) < distance_at_m(scene, lens, few, upper_m))
            high_m = upper_m;
        else
            low_m = lower_m;
    }
    orbit->centre_m[1] = (low_m + high_m) / 2.0;
}

static double eye_end_units(const struct grid *grid)
{
    return grid->is_long ? LIM_LONG_EYE_END - 1 : EYE_END_Q8 / 256.0;
}

/* How far from an orbit's centre an eye can be in each direction. */
static double orbit_most_m(const struct grid *grid, const double centre_m[3])
{
    double aside_units = 0.0;
    for (int i = 0; i < 3; i++)
        aside_units = fmax(aside_units, fabs(centre_m[i] - grid->origin_m[i]) * grid->units_per_m);
    return (eye_end_units(grid) - (grid->is_long ? aside_units + 1.0 : GRID_END_UNITS)) / grid->units_per_m;
}

/* Where no eye can be so far away that all of it is in view, from where it is along the picture's longer side alone: a
 * picture of one line shows a slice. Or from as far away as an eye can be. */
static double orbit_seen_from_m(const struct compiled *scene, const struct lens *lens, const struct orbit *orbit,
                                double margin)
{
    const double most_m = orbit_most_m(&scene->grid, orbit->centre_m);
    const double all_m = margin * orbit_distance_m(scene, lens, orbit);
    struct lens slice = *lens;
    if (all_m <= most_m) return all_m;
    *(lens->tan_x < lens->tan_y ? &slice.tan_x : &slice.tan_y) = INFINITY;
    return fmin(most_m, margin * orbit_distance_m(scene, &slice, orbit));
}

bool camera_path_orbit(const struct compiled *scene, const struct lens *lens, size_t frame_count,
                       struct camera_path *out, struct error *err)
{
    const bool is_small = lens->least_side_px <= SMALL_SIDE_PX;
    const double margin = is_small ? 1.02 : 1.05;
    struct orbit orbit = {.elevation = is_small ? STEEP_ELEVATION : ORBIT_ELEVATION, .frame_count = frame_count};
    const double half_m = scene_centre(scene, orbit.centre_m);
    if (is_small) settle_height(scene, lens, half_m, &orbit);
    const double distance_m = orbit_seen_from_m(scene, lens, &orbit, margin);
    *out = (struct camera_path){.name = strdup("orbit around the scene")};
    bool ok = out->name != NULL;
    for (size_t frame = 0; ok && frame < frame_count; frame++) {
        const struct viewpoint viewpoint = orbit_viewpoint(&orbit, distance_m, frame);
        ok = path_append(out, &viewpoint);
    }
    if (ok) return true;
    camera_path_free(out);
    return error_set(err, "orbit around the scene: out of memory");
}

/* Fixed point -------------------------------------------------------------------------------- */

static double degrees_of_tangent(double tangent)
{
    return 2.0 * atan(tangent) / PI * 180.0;
}

static double tangent_of_degrees(double fov_deg)
{
    return tan(fov_deg / 360.0 * PI);
}

double lens_usual_fov_deg(unsigned w_px, unsigned h_px)
{
    const double tangent = tangent_of_degrees(DEFAULT_FOV_DEG);
    if (tangent * w_px / h_px <= TANGENT_MAX) return DEFAULT_FOV_DEG;
    return degrees_of_tangent(tangent * h_px / w_px);
}

/* The nearest angle that a lens of such a picture can have, rounded towards those that are within. */
static double widest_deg(unsigned w_px, unsigned h_px)
{
    return floor(degrees_of_tangent(TANGENT_MAX * fmin(1.0, (double)h_px / w_px)) * 1e3) / 1e3;
}

static double narrowest_deg(unsigned w_px, unsigned h_px)
{
    return ceil(degrees_of_tangent(TANGENT_MIN * fmax(1.0, (double)h_px / w_px)) * 1e3) / 1e3;
}

bool lens_init(struct lens *lens, double fov_deg, double near_m, unsigned w_px, unsigned h_px, struct error *err)
{
    if (!(fov_deg > 0.0 && fov_deg < 180.0))
        return error_set(err, "--fov %g: the vertical field of view must lie between 0 and 180 degrees", fov_deg);
    if (!(near_m > 0.0 && near_m <= COORDINATE_MAX_M))
        return error_set(err, "--near %g: the near plane must lie in front of the eye", near_m);
    lens->near_m = near_m;
    lens->least_side_px = w_px < h_px ? w_px : h_px;
    lens->tan_y = tangent_of_degrees(fov_deg);
    lens->tan_x = lens->tan_y * w_px / h_px;
    if (fmax(lens->tan_x, lens->tan_y) > TANGENT_MAX)
        return error_set(err,
                         "--fov %g: too wide at %ux%u, where %.3f degrees are most; the tangent of a half-angle may be "
                         "4 at most",
                         fov_deg, w_px, h_px, widest_deg(w_px, h_px));
    if (fmin(lens->tan_x, lens->tan_y) < TANGENT_MIN)
        return error_set(
            err,
            "--fov %g: too narrow at %ux%u, where %.3f degrees are least; the tangent of a half-angle must "
            "be 1/2048 at least",
            fov_deg, w_px, h_px, narrowest_deg(w_px, h_px));
    return true;
}

bool lens_is_long(const struct lens *lens)
{
    return fmin(lens->tan_x, lens->tan_y) < TANGENT_LONG;
}

bool lens_fov_is_long(double fov_deg, unsigned w_px, unsigned h_px)
{
    const double tangent = tangent_of_degrees(fov_deg > 0.0 ? fov_deg : lens_usual_fov_deg(w_px, h_px));
    const struct lens lens = {.tan_x = tangent * w_px / h_px, .tan_y = tangent};
    return lens_is_long(&lens);
}

/* camera.h: 2^-16 of the far end's distance, which is 65534 units times what rows.c takes for the root of three at
 * most; and a little more for the choice among scales. */
double lens_least_near_m(const struct lens *lens, const struct grid *grid)
{
    const double diagonals = 1.75, narrow = fmin(1.0, fmin(lens->tan_x, lens->tan_y));
    return diagonals / (lens_is_long(lens) ? 0.5 : narrow) / grid->units_per_m;
}

double lens_usual_near_m(const struct grid *grid)
{
    const double longest_side_units = 65534.0, near_units = grid->is_long ? LONG_NEAR_UNITS : longest_side_units / 10.0;
    return fmin(0.1, near_units / grid->units_per_m);
}

double lens_default_near_m(const struct grid *grid)
{
    const double tangent = tangent_of_degrees(DEFAULT_FOV_DEG);
    const struct lens lens = {.tan_x = tangent, .tan_y = tangent};
    return fmax(lens_usual_near_m(grid), lens_least_near_m(&lens, grid));
}

double lens_forced_near_m(const struct grid *grid)
{
    const double near_m = lens_default_near_m(grid);
    return near_m > lens_usual_near_m(grid) ? near_m : 0.0;
}

/* What brings the near plane nearer, to so small a share of its distance. Of 2^30 units one is 2^14 times smaller. */
static const char *nearer_by(const struct grid *grid, double share)
{
    return grid->is_long || share < 0x1p-13 ? "split the model into several scenes" : "take --coordinates 32";
}

bool lens_for_grid(struct lens *lens, double fov_deg, double near_m, const struct grid *grid, unsigned w_px,
                   unsigned h_px, struct error *err)
{
    const double angle_deg = fov_deg > 0.0 ? fov_deg : lens_usual_fov_deg(w_px, h_px);
    if (!lens_init(lens, angle_deg, near_m > 0.0 ? near_m : lens_default_near_m(grid), w_px, h_px, err)) return false;
    const double least_m = lens_least_near_m(lens, grid);
    if (near_m > 0.0 && near_m < least_m)
        return error_set(err,
                         "--near %g: nothing nearer than %.3g m can be drawn on a grid with units of %.3g m, by this "
                         "lens; %s",
                         near_m, least_m * LENS_PRINTED_UP, 1.0 / grid->units_per_m, nearer_by(grid, near_m / least_m));
    lens->near_m = fmax(lens->near_m, least_m);
    return true;
}

void lens_note_near(const char *model_path, const struct grid *grid)
{
    const double near_m = lens_forced_near_m(grid);
    if (near_m > 0.0)
        notice("%s: nothing nearer to the eye than %.3g m is drawn, because its grid has units of %.3g m; for eyes "
               "that come nearer, %s",
               model_path, near_m * LENS_PRINTED_UP, 1.0 / grid->units_per_m,
               nearer_by(grid, lens_usual_near_m(grid) / near_m));
}

static uint32_t turn_from_radians(double radians)
{
    return (uint32_t)(int64_t)llround(radians / (2.0 * PI) * 4294967296.0);
}

void camera_put(struct lim_camera *camera, int axis, double eye_units, const struct grid *grid)
{
    const double eye_q8 = round(eye_units * 256.0);
    camera->origin[axis] = grid->is_long ? (int32_t)floor(eye_q8 / 256.0) : 0;
    camera->eye_q8[axis] = (int32_t)(eye_q8 - 256.0 * camera->origin[axis]);
}

double camera_eye_end_m(const struct grid *grid)
{
    return (eye_end_units(grid) - 1) / grid->units_per_m;
}

bool camera_path_to_camera(const struct camera_path *path, size_t frame, const struct lens *lens,
                           const struct grid *grid, struct lim_camera *camera, struct error *err)
{
    const struct viewpoint *viewpoint = &path->frames[frame];
    const double end_units = eye_end_units(grid);
    const double near_max_q8 = grid->is_long ? LIM_LONG_NEAR_MAX_Q8 : NEAR_MAX_Q8;
    for (int i = 0; i < 3; i++) {
        const double eye_units = (viewpoint->eye_m[i] - grid->origin_m[i]) * grid->units_per_m;
        if (!(fabs(round(eye_units * 256.0)) < end_units * 256.0))
            return error_set(err, "%s:%zu: the eye is too far from the scene; %.6g m from its middle is the limit%s",
                             path->name, viewpoint->line, end_units / grid->units_per_m,
                             grid->is_long ? "" : ", farther with --coordinates 32");
        camera_put(camera, i, eye_units, grid);
    }
    double near_q8 = round(lens->near_m * grid->units_per_m * 256.0);
    if (!(near_q8 >= 1.0 && near_q8 <= near_max_q8))
        return error_set(err, "--near %g: out of range; this scene allows %.3g to %.3g m", lens->near_m,
                         lens_least_near_m(lens, grid) * LENS_PRINTED_UP, near_max_q8 / 256.0 / grid->units_per_m);
    camera->near_q8 = (int32_t)near_q8;

    double direction[3];
    viewpoint_direction(viewpoint, direction);
    camera->yaw = turn_from_radians(direction_yaw(direction));
    camera->pitch = turn_from_radians(direction_pitch(direction));
    camera->roll = 0;
    camera->tan_x_q28 = (uint32_t)llround(lens->tan_x * 268435456.0);
    camera->tan_y_q28 = (uint32_t)llround(lens->tan_y * 268435456.0);
    return true;
}
