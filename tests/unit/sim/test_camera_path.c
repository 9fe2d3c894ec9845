/* SPDX-License-Identifier: MIT
 *
 * Camera files, the default orbit, and the step from metres to the renderer's fixed point. */
#include "cameras/camera_path.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const uint32_t QUARTER = UINT32_C(1) << 30, HALF = UINT32_C(1) << 31;
static const struct grid METRE_GRID = {.origin_m = {0.0, 0.0, 0.0}, .units_per_m = 1000.0};
static const struct lens LENS = {.tan_x = 1.0, .tan_y = 0.5, .near_m = 0.1};

/* Reads text as a camera file; *name is the file's until the next call. */
static bool read_text(const char *text, size_t length, struct camera_path *path, char name[32], struct error *err)
{
    strcpy(name, "/tmp/limner-camera-XXXXXX");
    int descriptor = mkstemp(name);
    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, text, length), length);
    close(descriptor);
    bool ok = camera_path_read(name, path, err);
    unlink(name);
    return ok;
}

static struct lim_camera camera_looking(const double eye_m[3], const double target_m[3])
{
    struct viewpoint viewpoint = {.line = 1};
    memcpy(viewpoint.eye_m, eye_m, sizeof viewpoint.eye_m);
    memcpy(viewpoint.target_m, target_m, sizeof viewpoint.target_m);
    struct camera_path path = {.name = "test.cam", .frames = &viewpoint, .count = 1};
    struct lim_camera camera;
    struct error err;
    assert_true(camera_path_to_camera(&path, 0, &LENS, &METRE_GRID, &camera, &err));
    return camera;
}

static void assert_direction(double x, double y, double z, uint32_t yaw, uint32_t pitch)
{
    struct lim_camera camera = camera_looking((double[]){1.0, 2.0, 3.0}, (double[]){1.0 + x, 2.0 + y, 3.0 + z});
    assert_int_equal(camera.yaw, yaw);
    assert_int_equal(camera.pitch, pitch);
    assert_int_equal(camera.roll, 0);
}

/* Files -------------------------------------------------------------------------------------- */

static void file_with_comments_and_blank_lines_is_read(void **state)
{
    (void)state;
    const char text[] = "# a walk\n\n1 2 3 4 5 6\r\n   \n-1e-2 .5 +3 0 0 0 # at home\n7 8 9 10 11 12";
    struct camera_path path;
    struct error err;
    char name[32];
    assert_true(read_text(text, strlen(text), &path, name, &err));
    assert_string_equal(path.name, name);
    assert_int_equal(path.count, 3);
    assert_true(path.frames[0].eye_m[0] == 1.0 && path.frames[0].target_m[2] == 6.0);
    assert_true(path.frames[1].eye_m[0] == -0.01 && path.frames[1].eye_m[2] == 3.0);
    assert_true(path.frames[2].target_m[0] == 10.0);
    assert_int_equal(path.frames[1].line, 5);
    camera_path_free(&path);
}

static void a_camera_may_have_a_time(void **state)
{
    (void)state;
    static const char text[] = "1 2 3 4 5 6 @1.25\n1 2 3 4 5 6 # @3\n1 2 3 4 5 6\t@0 # the beginning\n";
    struct camera_path path;
    struct error err;
    char name[32];
    assert_true(read_text(text, strlen(text), &path, name, &err));
    assert_int_equal(path.count, 3);
    assert_true(path.frames[0].has_time && path.frames[0].time_s == 1.25);
    assert_false(path.frames[1].has_time);
    assert_true(path.frames[2].has_time && path.frames[2].time_s == 0.0);
    assert_false(camera_path_is_timeless(&path, &err));
    assert_non_null(strstr(err.text, ":1: "));
    path.frames[0] = path.frames[2] = path.frames[1];
    assert_true(camera_path_is_timeless(&path, &err));
    camera_path_free(&path);
}

static void bad_line_is_named_with_its_number_and_reason(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reason;
    } cases[] = {
        {"1 2 3 4 5 6\n1 2 3 4 5\n", ":2: fewer than six numbers"},
        {"1 2 3 4 5 6\n# x\n\n1 2 3 4 5 6 7\n", ":4: more than six numbers"},
        {"1 2 three 4 5 6\n", ":1: not a number"},
        {"1 2 3 4 5 6x\n", ":1: not a number"},
        {"1,2,3,4,5,6\n", ":1: not a number"},
        {"\n1 2 nan 4 5 6\n", ":2: a coordinate is not finite"},
        {"1 2 3 4 5 inf\n", ":1: a coordinate is not finite"},
        {"1 2 3 4 5 -1e999\n", ":1: a coordinate is not finite"},
        {"1 2 3 4 5 2e9\n", ":1: a coordinate is not finite or beyond"},
        {"1 2 3 4 5 6\n1 2 3 1 2 3\n", ":2: eye and target are the same point"},
        {"0 0 0 0 0 1e-310\n", ":1: eye and target are the same point"},
        {"1 2 3 4 5 6@1\n", ":1: not a time"},
        {"1 2 3 4 5 6 @\n", ":1: not a time"},
        {"1 2 3 4 5 6 @-1\n", ":1: not a time"},
        {"1 2 3 4 5 6 @nan\n", ":1: not a time"},
        {"1 2 3 4 5 6 @1 2\n", ":1: not a time"},
        {"1 2 3 4 5 6 @1 @2\n", ":1: not a time"},
        {"1 2 3 @1 4 5 6\n", ":1: not a time"},
        {"1 2 3 4 5 @6\n", ":1: fewer than six numbers"},
        {"1 2 3 4 5 6\n  @6\n", ":2: fewer than six numbers"},
        {"@6\n", ":1: not a time"},
        {"", ": no camera in it"},
        {"# only a comment\n\n", ": no camera in it"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct camera_path path;
        struct error err;
        char name[32], expected[128];
        assert_false(read_text(cases[i].text, strlen(cases[i].text), &path, name, &err));
        snprintf(expected, sizeof expected, "%s%s", name, cases[i].reason);
        assert_memory_equal(err.text, expected, strlen(expected));
        assert_null(strchr(err.text, '\n'));
        assert_null(path.frames);
    }
}

static void nul_byte_in_a_line_is_refused(void **state)
{
    (void)state;
    struct camera_path path;
    struct error err;
    char name[32];
    assert_false(read_text("1 2 3 4 5 6\0 7\n", 15, &path, name, &err));
    assert_non_null(strstr(err.text, ":1: a NUL byte"));
}

static void missing_file_and_folder_are_refused_by_name(void **state)
{
    (void)state;
    struct camera_path path;
    struct error err;
    assert_false(camera_path_read("/nowhere/at-all.cam", &path, &err));
    assert_string_equal(err.text, "/nowhere/at-all.cam: No such file or directory");
    assert_false(camera_path_read("/tmp", &path, &err));
    assert_string_equal(err.text, "/tmp: is a folder, not a file");
}

/* Angles ------------------------------------------------------------------------------------- */

static void yaw_counts_counter_clockwise_from_minus_z(void **state)
{
    (void)state;
    assert_direction(0.0, 0.0, -2.0, 0, 0);
    assert_direction(-2.0, 0.0, 0.0, QUARTER, 0);
    assert_direction(0.0, 0.0, 2.0, HALF, 0);
    assert_direction(2.0, 0.0, 0.0, HALF + QUARTER, 0);
    assert_direction(-1.0, 0.0, -1.0, QUARTER / 2, 0);
}

static void pitch_raises_the_view(void **state)
{
    (void)state;
    assert_direction(0.0, 1.0, -1.0, 0, QUARTER / 2);
    assert_direction(0.0, -1.0, -1.0, 0, 0u - QUARTER / 2);
}

static void straight_up_and_down_are_half_a_turn_of_yaw(void **state)
{
    (void)state;
    assert_direction(0.0, 5.0, 0.0, HALF, QUARTER);
    assert_direction(0.0, -5.0, 0.0, HALF, 0u - QUARTER);
}

static void assert_near(const double a[3], double x, double y, double z)
{
    assert_true(fabs(a[0] - x) < 1e-12 && fabs(a[1] - y) < 1e-12 && fabs(a[2] - z) < 1e-12);
}

static void straight_up_takes_minus_z_as_up_and_straight_down_plus_z(void **state)
{
    (void)state;
    struct view_axes axes;
    viewpoint_axes(&(struct viewpoint){.eye_m = {1, 1, 1}, .target_m = {1, 9, 1}}, &axes);
    assert_near(axes.up, 0.0, 0.0, -1.0);
    assert_near(axes.right, -1.0, 0.0, 0.0);
    viewpoint_axes(&(struct viewpoint){.eye_m = {1, 1, 1}, .target_m = {1, -9, 1}}, &axes);
    assert_near(axes.up, 0.0, 0.0, 1.0);
    assert_near(axes.right, -1.0, 0.0, 0.0);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void axes_agree_with_the_angles_of_the_camera(void **state)
{
    (void)state;
    srand(1);
    for (int i = 0; i < 1000; i++) {
        struct viewpoint viewpoint = {.line = 1};
        for (int axis = 0; axis < 3; axis++)
            viewpoint.target_m[axis] = rand() / (double)RAND_MAX - 0.5;
        struct lim_camera camera = camera_looking(viewpoint.eye_m, viewpoint.target_m);
        double turn = 8.0 * atan(1.0) / 4294967296.0;
        double yaw = camera.yaw * turn, pitch = (int32_t)camera.pitch * turn;
        struct view_axes axes;
        viewpoint_axes(&viewpoint, &axes);
        const double forward[3] = {-sin(yaw) * cos(pitch), sin(pitch), -cos(yaw) * cos(pitch)};
        const double up[3] = {sin(yaw) * sin(pitch), cos(pitch), cos(yaw) * sin(pitch)};
        const double right[3] = {cos(yaw), 0.0, -sin(yaw)};
        assert_true(fabs(dot(axes.forward, forward) - 1.0) < 1e-9);
        assert_true(fabs(dot(axes.up, up) - 1.0) < 1e-9);
        assert_true(fabs(dot(axes.right, right) - 1.0) < 1e-9);
    }
}

/* Units -------------------------------------------------------------------------------------- */

static void eye_is_rounded_to_nearest_relative_to_the_origin(void **state)
{
    (void)state;
    struct viewpoint viewpoint = {.eye_m = {10.0, -20.0 - 0.6 / 256.0, 30.0 + 0.4 / 256.0}, .line = 1};
    struct camera_path path = {.name = "test.cam", .frames = &viewpoint, .count = 1};
    const struct grid grid = {.origin_m = {8.0, -20.0, 30.0}, .units_per_m = 1.0};
    struct lim_camera camera;
    struct error err;
    assert_true(camera_path_to_camera(&path, 0, &LENS, &grid, &camera, &err));
    assert_int_equal(camera.eye_q8[0], 512);
    assert_int_equal(camera.eye_q8[1], -1);
    assert_int_equal(camera.eye_q8[2], 0);
    assert_int_equal(camera.near_q8, 26); /* 25.6 */
    assert_int_equal(camera.tan_x_q28, UINT32_C(1) << 28);
    assert_int_equal(camera.tan_y_q28, UINT32_C(1) << 27);
}

static void eye_beyond_the_renderers_range_is_refused_by_line(void **state)
{
    (void)state;
    struct viewpoint viewpoint = {.eye_m = {0.0, 0.0, 1048575.9}, .line = 7};
    struct camera_path path = {.name = "far.cam", .frames = &viewpoint, .count = 1};
    const struct grid grid = {.units_per_m = 1.0};
    struct lim_camera camera;
    struct error err;
    assert_true(camera_path_to_camera(&path, 0, &LENS, &grid, &camera, &err));
    viewpoint.eye_m[2] = -1048576.0;
    assert_false(camera_path_to_camera(&path, 0, &LENS, &grid, &camera, &err));
    assert_memory_equal(err.text, "far.cam:7: the eye is too far", strlen("far.cam:7: the eye is too far"));
}

static void near_plane_beyond_the_renderers_range_is_refused(void **state)
{
    (void)state;
    struct viewpoint viewpoint = {.target_m = {1.0, 0.0, 0.0}, .line = 1};
    struct camera_path path = {.name = "test.cam", .frames = &viewpoint, .count = 1};
    static const double refused_m[] = {0.49 / 256.0, 65537.0}, taken_m[] = {0.51 / 256.0, 65536.0};
    const struct grid grid = {.units_per_m = 1.0};
    struct lim_camera camera;
    struct error err;
    for (int i = 0; i < 2; i++) {
        struct lens lens = {.tan_x = 1.0, .tan_y = 1.0, .near_m = refused_m[i]};
        assert_false(camera_path_to_camera(&path, 0, &lens, &grid, &camera, &err));
        lens.near_m = taken_m[i];
        assert_true(camera_path_to_camera(&path, 0, &lens, &grid, &camera, &err));
    }
}

static void default_near_plane_fits_every_scale(void **state)
{
    (void)state;
    for (double units_per_m = 1e-9; units_per_m < 1e12; units_per_m *= 1.7) {
        struct viewpoint viewpoint = {.target_m = {1.0, 0.0, 0.0}, .line = 1};
        struct camera_path path = {.name = "test.cam", .frames = &viewpoint, .count = 1};
        const struct grid grid = {.units_per_m = units_per_m};
        struct lens lens = {.tan_x = 1.0, .tan_y = 1.0, .near_m = lens_default_near_m(&grid)};
        struct lim_camera camera;
        struct error err;
        assert_true(camera_path_to_camera(&path, 0, &lens, &grid, &camera, &err));
    }
    assert_true(lens_default_near_m(&(struct grid){.units_per_m = 1700.0}) == 0.1);
}

/* Lens --------------------------------------------------------------------------------------- */

static void lens_has_square_pixels(void **state)
{
    (void)state;
    struct lens lens;
    struct error err;
    assert_true(lens_init(&lens, 90.0, 0.1, 320, 240, &err));
    assert_true(fabs(lens.tan_y - 1.0) < 1e-15 && fabs(lens.tan_x - 4.0 / 3.0) < 1e-15);
}

static void a_lens_that_nobody_chose_fits_every_picture(void **state)
{
    (void)state;
    static const unsigned sides_px[] = {1, 2, 8, 100, 240, 320, 1024};
    enum { SIDES = sizeof sides_px / sizeof *sides_px };
    for (size_t i = 0; i < (size_t)SIDES * SIDES; i++) {
        const unsigned w_px = sides_px[i / SIDES], h_px = sides_px[i % SIDES];
        struct lens lens;
        struct error err;
        assert_true(lens_init(&lens, lens_usual_fov_deg(w_px, h_px), 0.1, w_px, h_px, &err));
        const double degrees = 2.0 * atan(w_px > 6 * h_px ? lens.tan_x : lens.tan_y) / acos(-1.0) * 180.0;
        assert_true(fabs(degrees - 60.0) < 1e-9);
    }
}

/* What an error names is a lens, and a little more or less is none. */
static void the_lens_that_is_named_fits(void **state)
{
    (void)state;
    static const unsigned sides_px[][2] = {{240, 240}, {200, 1}, {1, 200}, {1024, 600}, {84, 48}};
    for (size_t i = 0; i < sizeof sides_px / sizeof *sides_px; i++) {
        const unsigned w_px = sides_px[i][0], h_px = sides_px[i][1];
        struct lens lens;
        struct error err;
        double named_deg;
        assert_false(lens_init(&lens, 179.0, 0.1, w_px, h_px, &err));
        assert_int_equal(sscanf(strstr(err.text, "where ") + 6, "%lf", &named_deg), 1);
        assert_true(lens_init(&lens, named_deg, 0.1, w_px, h_px, &err));
        assert_false(lens_init(&lens, named_deg + 0.0011, 0.1, w_px, h_px, &err));
        assert_false(lens_init(&lens, 0.00001, 0.1, w_px, h_px, &err));
        assert_int_equal(sscanf(strstr(err.text, "where ") + 6, "%lf", &named_deg), 1);
        assert_true(lens_init(&lens, named_deg, 0.1, w_px, h_px, &err));
        assert_false(lens_init(&lens, named_deg - 0.0011, 0.1, w_px, h_px, &err));
    }
}

static void lens_out_of_range_is_refused(void **state)
{
    (void)state;
    static const struct {
        double fov_deg, near_m;
        unsigned w_px, h_px;
    } cases[] = {{0.0, 0.1, 240, 240},   {180.0, 0.1, 240, 240}, {NAN, 0.1, 240, 240},  {-60.0, 0.1, 240, 240},
                 {60.0, 0.0, 240, 240},  {60.0, -1.0, 240, 240}, {60.0, NAN, 240, 240}, {60.0, INFINITY, 240, 240},
                 {152.0, 0.1, 240, 240}, {60.0, 0.1, 1000, 100}, {0.5, 0.1, 10, 1000},  {0.05, 0.1, 240, 240}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct lens lens;
        struct error err;
        assert_false(lens_init(&lens, cases[i].fov_deg, cases[i].near_m, cases[i].w_px, cases[i].h_px, &err));
        assert_null(strchr(err.text, '\n'));
    }
}

/* Orbit -------------------------------------------------------------------------------------- */

/* The greatest part of the picture's half-sizes that any vertex is from the middle, over all frames. */
static double orbit_extent(const struct compiled *scene, const struct lens *lens)
{
    struct camera_path path;
    struct error err;
    assert_true(camera_path_orbit(scene, lens, 16, &path, &err));
    assert_int_equal(path.count, 16);
    double extent = 0.0;
    for (size_t frame = 0; frame < path.count; frame++) {
        struct view_axes axes;
        viewpoint_axes(&path.frames[frame], &axes);
        for (lim_index v = 0; v < scene->scene.vertex_count; v++) {
            const struct lim_vertex *vertex = &scene->scene.vertices[v];
            const double units[3] = {vertex->x, vertex->y, vertex->z};
            double p[3];
            for (int i = 0; i < 3; i++)
                p[i] = scene->grid.origin_m[i] + units[i] / scene->grid.units_per_m - path.frames[frame].eye_m[i];
            double depth_m = dot(p, axes.forward);
            assert_true(depth_m > lens->near_m);
            extent = fmax(extent, fabs(dot(p, axes.right)) / (lens->tan_x * depth_m));
            extent = fmax(extent, fabs(dot(p, axes.up)) / (lens->tan_y * depth_m));
        }
    }
    camera_path_free(&path);
    return extent;
}

static void orbit_fills_the_view_with_the_whole_scene(void **state)
{
    (void)state;
    static const struct lim_vertex corners[] = {{-100, 0, -3000}, {100, 0, -3000}, {100, 900, 20}, {-100, 7, 3000}};
    const struct compiled scene = {.scene = {.vertices = corners, .vertex_count = 4},
                                   .grid = {.origin_m = {5.0, 6.0, 7.0}, .units_per_m = 100.0}};
    static const struct lens lenses[] = {{1.0, 0.5, 0.1, 240}, {0.3, 1.0, 0.1, 240}, {4.0, 0.02, 0.1, 240}};
    for (int i = 0; i < 3; i++) {
        double extent = orbit_extent(&scene, &lenses[i]);
        assert_true(extent > 0.9 && extent < 1.0);
    }
}

/* How much of the picture's height the scene's corners take, over all frames; all of them are in view. */
static double height_taken(const struct compiled *scene, const struct lens *lens)
{
    struct camera_path path;
    struct error err;
    double least = 1.0, most = -1.0;
    assert_true(camera_path_orbit(scene, lens, 16, &path, &err));
    for (size_t frame = 0; frame < path.count; frame++) {
        struct view_axes axes;
        viewpoint_axes(&path.frames[frame], &axes);
        for (lim_index v = 0; v < scene->scene.vertex_count; v++) {
            const struct lim_vertex *vertex = &scene->scene.vertices[v];
            const double units[3] = {vertex->x, vertex->y, vertex->z};
            double p[3];
            for (int i = 0; i < 3; i++)
                p[i] = scene->grid.origin_m[i] + units[i] / scene->grid.units_per_m - path.frames[frame].eye_m[i];
            const double depth_m = dot(p, axes.forward), at = dot(p, axes.up) / (lens->tan_y * depth_m);
            assert_true(fabs(at) < 1.0 && fabs(dot(p, axes.right)) < lens->tan_x * depth_m);
            least = fmin(least, at);
            most = fmax(most, at);
        }
    }
    camera_path_free(&path);
    return (most - least) / 2.0;
}

/* A box, twice as wide as high, in a picture that is twice as wide as high. */
static void small_pictures_are_filled_from_top_to_bottom(void **state)
{
    (void)state;
    static const struct lim_vertex corners[] = {{-900, 0, -900},   {900, 0, -900},   {900, 0, 900},   {-900, 0, 900},
                                                {-900, 900, -900}, {900, 900, -900}, {900, 900, 900}, {-900, 900, 900}};
    const struct compiled scene = {.scene = {.vertices = corners, .vertex_count = 8}, .grid = {.units_per_m = 100.0}};
    const struct lens large = {1.0, 0.5, 0.1, 120}, small = {1.0, 0.5, 0.1, 64};
    assert_true(height_taken(&scene, &small) > 0.95);
    assert_true(height_taken(&scene, &large) < 0.9);
}

/* It looks at a frame each ten degrees: the work grows no faster than without a search, and so do the results. */
static void the_height_of_a_long_orbit_is_that_of_a_short_one(void **state)
{
    (void)state;
    static const struct lim_vertex corners[] = {{-900, 0, -310}, {170, 40, -900}, {600, 900, 250}, {-130, 300, 770}};
    const struct compiled scene = {.scene = {.vertices = corners, .vertex_count = 4}, .grid = {.units_per_m = 100.0}};
    const struct lens small = {1.0, 0.5, 0.1, 64};
    struct camera_path shorter, longer;
    struct error err;
    assert_true(camera_path_orbit(&scene, &small, 36, &shorter, &err));
    assert_true(camera_path_orbit(&scene, &small, 3600, &longer, &err));
    assert_true(longer.frames[0].target_m[1] == shorter.frames[0].target_m[1]);
    camera_path_free(&shorter);
    camera_path_free(&longer);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_pictures_are_filled_from_top_to_bottom),
        cmocka_unit_test(the_height_of_a_long_orbit_is_that_of_a_short_one),
        cmocka_unit_test(file_with_comments_and_blank_lines_is_read),
        cmocka_unit_test(a_camera_may_have_a_time),
        cmocka_unit_test(bad_line_is_named_with_its_number_and_reason),
        cmocka_unit_test(nul_byte_in_a_line_is_refused),
        cmocka_unit_test(missing_file_and_folder_are_refused_by_name),
        cmocka_unit_test(yaw_counts_counter_clockwise_from_minus_z),
        cmocka_unit_test(pitch_raises_the_view),
        cmocka_unit_test(straight_up_and_down_are_half_a_turn_of_yaw),
        cmocka_unit_test(straight_up_takes_minus_z_as_up_and_straight_down_plus_z),
        cmocka_unit_test(axes_agree_with_the_angles_of_the_camera),
        cmocka_unit_test(eye_is_rounded_to_nearest_relative_to_the_origin),
        cmocka_unit_test(eye_beyond_the_renderers_range_is_refused_by_line),
        cmocka_unit_test(near_plane_beyond_the_renderers_range_is_refused),
        cmocka_unit_test(default_near_plane_fits_every_scale),
        cmocka_unit_test(lens_has_square_pixels),
        cmocka_unit_test(a_lens_that_nobody_chose_fits_every_picture),
        cmocka_unit_test(the_lens_that_is_named_fits),
        cmocka_unit_test(lens_out_of_range_is_refused),
        cmocka_unit_test(orbit_fills_the_view_with_the_whole_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
