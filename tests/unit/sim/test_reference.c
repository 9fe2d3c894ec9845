/* SPDX-License-Identifier: MIT
 *
 * The reference picture is right: by hand-made scenes, against a ray caster of another method,
 * and without gaps. */
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/reference_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t face_at(const struct reference *reference, unsigned x_px, unsigned y_px)
{
    return reference->faces[y_px * W_PX + x_px];
}

/* Hand-made scenes --------------------------------------------------------------------------- */

static void square_covers_the_pixels_whose_centres_it_holds(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    /* At depth 2 m a pixel is 0.1 m wide and high: 10 pixels each way from the middle. */
    scene_add_square(&scene, 7, 1.0, 2.0);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    for (unsigned y = 0; y < H_PX; y++) {
        for (unsigned x = 0; x < W_PX; x++) {
            bool inside = x >= 10 && x < 30 && y >= 5 && y < 25;
            assert_int_equal(face_at(&reference, x, y), inside ? 7 : 0);
            double depth_m = reference.depths_m[y * W_PX + x];
            assert_true(inside ? fabs(depth_m - 2.0) < 1e-12 : isinf(depth_m));
        }
    }
    reference_free(&reference);
}

static void picture_is_upright_and_not_mirrored(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    double right_top[3][3] = {{0.5, 0.4, -1.0}, {0.9, 0.4, -1.0}, {0.9, 0.7, -1.0}};
    scene_add(&scene, 1, 3, right_top);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    assert_int_equal(face_at(&reference, 36, 4), 1); /* x = 0.825, y = 0.525 */
    size_t covered = 0;
    for (unsigned pixel = 0; pixel < W_PX * H_PX; pixel++) {
        if (!reference.faces[pixel]) continue;
        covered++;
        assert_true(pixel % W_PX >= 30 && pixel / W_PX < 7);
    }
    assert_in_range(covered, 20, 28); /* half of 8 x 6 pixels */
    reference_free(&reference);
}

static void nearest_wins_in_either_order(void **state)
{
    (void)state;
    for (int order = 0; order < 2; order++) {
        struct scene scene;
        scene_clear(&scene);
        scene_add_square(&scene, 1, 1.0, order ? 2.0 : 3.0);
        scene_add_square(&scene, 2, 1.0, order ? 3.0 : 2.0);
        struct reference reference = draw(&scene, &ALONG_MINUS_Z);
        assert_int_equal(face_at(&reference, 20, 15), order ? 1 : 2);
        reference_free(&reference);
    }
}

static void equal_depths_go_to_the_later_face(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 5, 1.0, 2.0);
    scene_add_square(&scene, 3, 1.5, 2.0);
    scene_add_square(&scene, 4, 1.5, 2.0);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    for (unsigned x = 5; x < 35; x++)
        assert_int_equal(face_at(&reference, x, 15), x >= 10 && x < 30 ? 5 : 4);
    reference_free(&reference);
}

static void back_face_is_seen_only_if_two_sided(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 1, 1.0, 2.0);
    const struct viewpoint from_behind = {.eye_m = {0.0, 0.0, -4.0}, .target_m = {0.0, 0.0, 0.0}};
    struct reference reference = draw(&scene, &from_behind);
    assert_int_equal(face_at(&reference, 20, 15), 0);
    reference_free(&reference);
    scene.polygons[0].two_sided = true;
    reference = draw(&scene, &from_behind);
    assert_int_equal(face_at(&reference, 20, 15), 1);
    assert_int_equal(face_at(&reference, 9, 15), 0);
    assert_int_equal(face_at(&reference, 29, 24), 1);
    reference_free(&reference);
}

static void nothing_before_the_near_plane_is_seen(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 1, 1.0, 0.0999);
    scene_add_square(&scene, 2, 5.0, 0.1001);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    for (size_t i = 0; i < W_PX * H_PX; i++)
        assert_int_equal(reference.faces[i], 2);
    reference_free(&reference);
}

static void floor_that_reaches_behind_the_eye_ends_at_the_horizon(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    double corners[4][3] = {{-1e6, -1.0, 1e6}, {1e6, -1.0, 1e6}, {1e6, -1.0, -1e6}, {-1e6, -1.0, -1e6}};
    scene_add(&scene, 1, 4, corners);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    for (unsigned y = 0; y < H_PX; y++)
        for (unsigned x = 0; x < W_PX; x++)
            assert_int_equal(face_at(&reference, x, y), y >= H_PX / 2 ? 1 : 0);
    assert_true(fabs(reference.depths_m[29 * W_PX] - 1.0 / (0.75 * (1.0 - 1.0 / H_PX))) < 1e-9);
    reference_free(&reference);
}

/* Random scenes ------------------------------------------------------------------------------ */

static double random_between(double low, double high)
{
    return low + (high - low) * rand() / (double)RAND_MAX;
}

static void subtract(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Moller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997): depth in units of
 * the direction, negative for a miss; *margin is how far inside the triangle's borders, 0..1. */
static double hit_depth(const double eye[3], const double direction[3], double (*corners)[3], double *margin)
{
    double e1[3], e2[3], p[3], q[3], t[3];
    subtract(corners[1], corners[0], e1);
    subtract(corners[2], corners[0], e2);
    cross(direction, e2, p);
    double determinant = dot(e1, p);
    subtract(eye, corners[0], t);
    cross(t, e1, q);
    double u = dot(t, p) / determinant, v = dot(direction, q) / determinant;
    *margin = fmin(fmin(u, v), 1.0 - u - v);
    return determinant > 0.0 && *margin >= 0.0 ? dot(e2, q) / determinant : -1.0;
}

/* The face on a pixel's ray by trying all; *is_certain: no border and no rival within rounding. */
static uint32_t cast_ray(const struct scene *scene, const struct viewpoint *viewpoint, const struct view_axes *axes,
                         unsigned x_px, unsigned y_px, bool *is_certain)
{
    double direction[3], best = INFINITY;
    uint32_t face = 0;
    for (int i = 0; i < 3; i++)
        direction[i] = axes->forward[i] + axes->right[i] * LENS.tan_x * ((2 * x_px + 1.0) / W_PX - 1.0) +
                       axes->up[i] * LENS.tan_y * (1.0 - (2 * y_px + 1.0) / H_PX);
    *is_certain = true;
    for (size_t p = 0; p < scene->mesh.polygon_count; p++) {
        double margin;
        double depth_m =
            hit_depth(viewpoint->eye_m, direction, (double(*)[3])scene->points[scene->polygons[p].first], &margin);
        if (fabs(margin) < 1e-7 || fabs(depth_m - LENS.near_m) < 1e-7 || fabs(depth_m - best) < 1e-7)
            *is_certain = false;
        if (depth_m < LENS.near_m || depth_m >= best) continue;
        best = depth_m;
        face = scene->polygons[p].face;
    }
    return face;
}

static void agrees_with_another_ray_caster_on_random_triangles(void **state)
{
    (void)state;
    srand(2);
    size_t certain = 0, covered = 0;
    static struct scene scene;
    for (int round = 0; round < 60; round++) {
        scene_clear(&scene);
        for (uint32_t face = 1; face <= 60; face++) {
            double corners[3][3], size_m = random_between(0.1, 4.0);
            for (int axis = 0; axis < 3; axis++) {
                double centre_m = random_between(-3.0, 3.0);
                for (int i = 0; i < 3; i++)
                    corners[i][axis] = centre_m + random_between(-size_m, size_m);
            }
            scene_add(&scene, face, 3, corners);
        }
        struct viewpoint viewpoint = {.target_m = {0}};
        for (int i = 0; i < 3; i++)
            viewpoint.eye_m[i] = random_between(-3.0, 3.0);
        struct view_axes axes;
        viewpoint_axes(&viewpoint, &axes);
        struct reference reference = draw(&scene, &viewpoint);
        for (unsigned pixel = 0; pixel < W_PX * H_PX; pixel++) {
            bool is_certain;
            uint32_t face = cast_ray(&scene, &viewpoint, &axes, pixel % W_PX, pixel / W_PX, &is_certain);
            if (is_certain) assert_int_equal(reference.faces[pixel], face);
            certain += is_certain;
            covered += face != 0;
        }
        reference_free(&reference);
    }
    assert_true(certain > 71900); /* of 72000 */
    assert_true(covered > 36000);
}

/* A cube seen from within: 6 faces of n x n squares with common corners. */
static void scene_add_cube(struct scene *scene, int n)
{
    uint32_t face = 1;
    for (int axis = 0; axis < 3; axis++) {
        for (int side = -1; side <= 1; side += 2) {
            for (int cell = 0; cell < n * n; cell++) {
                static const int ring[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                double corners[4][3];
                for (int i = 0; i < 4; i++) {
                    const int *at = ring[side > 0 ? 3 - i : i];
                    corners[i][axis] = side * 1.5;
                    corners[i][(axis + 1) % 3] = 3.0 * (cell % n + at[0]) / n - 1.5;
                    corners[i][(axis + 2) % 3] = 3.0 * (cell / n + at[1]) / n - 1.5;
                }
                scene_add(scene, face++, 4, corners);
            }
        }
    }
}

static void closed_surface_has_no_gap(void **state)
{
    (void)state;
    static struct scene scene;
    scene_clear(&scene);
    scene_add_cube(&scene, 6);
    srand(3);
    for (int round = 0; round < 200; round++) {
        struct viewpoint viewpoint;
        for (int i = 0; i < 3; i++) {
            /* Every fourth eye and target lie on the lattice, so that rays meet edges and corners exactly. */
            viewpoint.eye_m[i] = round % 4 ? random_between(-0.9, 0.9) : 0.0;
            viewpoint.target_m[i] = round % 4 ? random_between(-1.0, 1.0) : rand() % 3 - 1;
        }
        if (round % 4 == 0) viewpoint.target_m[rand() % 3] = 2.0;
        struct reference reference = draw(&scene, &viewpoint);
        for (size_t i = 0; i < W_PX * H_PX; i++)
            assert_int_not_equal(reference.faces[i], 0);
        reference_free(&reference);
    }
}

/* Tiles of the screen ------------------------------------------------------------------------ */

static bool is_listed(const struct near_list lists[NEAR_LISTS], uint32_t number)
{
    size_t count = 0;
    for (int k = 0; k < NEAR_LISTS; k++)
        for (size_t i = 0; i < lists[k].count; i++)
            count += lists[k].numbers[i] == number;
    assert_true(count <= 1);
    return count;
}

/* What reaches into a pixel's neighbourhood is in its lists, once, and lists are short where things are small. */
static void tiles_know_what_is_near(void **state)
{
    enum { COUNT = 300, SCREENS = 12, PIXELS = 200 };
    struct random random = {31};
    struct near_tiles tiles = {0};
    size_t listed = 0;
    (void)state;
    for (int screen = 0; screen < SCREENS; screen++) {
        const int w_px = (int)random_in(&random, 1, 500), h_px = (int)random_in(&random, 1, 500);
        struct pixel_rect bounds[COUNT];
        for (int i = 0; i < COUNT; i++) {
            const int x0 = (int)random_in(&random, 0, w_px - 1), y0 = (int)random_in(&random, 0, h_px - 1);
            const int most = i % 10 ? 20 : 500;
            const int x1 = x0 + (int)random_in(&random, -1, most), y1 = y0 + (int)random_in(&random, -1, most);
            bounds[i] = (struct pixel_rect){x0, y0, x1 < w_px ? x1 : w_px - 1, y1 < h_px ? y1 : h_px - 1};
        }
        near_tiles_set(&tiles, (unsigned)w_px, (unsigned)h_px, bounds, COUNT);
        for (int p = 0; p < PIXELS; p++) {
            const int x = (int)random_in(&random, 0, w_px - 1), y = (int)random_in(&random, 0, h_px - 1);
            struct near_list lists[NEAR_LISTS];
            near_tiles_at(&tiles, (unsigned)x, (unsigned)y, lists);
            listed += lists[0].count + lists[1].count;
            for (int i = 0; i < COUNT; i++) {
                const bool is_near = x >= bounds[i].x0 - NEAR_TILES_PX && x <= bounds[i].x1 + NEAR_TILES_PX &&
                                     y >= bounds[i].y0 - NEAR_TILES_PX && y <= bounds[i].y1 + NEAR_TILES_PX;
                if (is_near) assert_true(is_listed(lists, (uint32_t)i));
            }
        }
    }
    near_tiles_free(&tiles);
    assert_true(listed < (size_t)SCREENS * PIXELS * COUNT / 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(square_covers_the_pixels_whose_centres_it_holds),
        cmocka_unit_test(picture_is_upright_and_not_mirrored),
        cmocka_unit_test(nearest_wins_in_either_order),
        cmocka_unit_test(equal_depths_go_to_the_later_face),
        cmocka_unit_test(back_face_is_seen_only_if_two_sided),
        cmocka_unit_test(nothing_before_the_near_plane_is_seen),
        cmocka_unit_test(floor_that_reaches_behind_the_eye_ends_at_the_horizon),
        cmocka_unit_test(agrees_with_another_ray_caster_on_random_triangles),
        cmocka_unit_test(closed_surface_has_no_gap),
        cmocka_unit_test(tiles_know_what_is_near),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
