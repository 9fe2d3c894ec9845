/* SPDX-License-Identifier: MIT
 *
 * The comparison with the reference picture counts what it says: wrong pixels, those that no shifted edge explains,
 * order errors and holes. */
#include "accuracy/compare.h"
#include "rigs/cmocka_ready.h"
#include "rigs/reference_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Comparison --------------------------------------------------------------------------------- */

struct pictures {
    struct reference reference;
    uint32_t rendered[W_PX * H_PX];
};

/* The reference shows face 1, a square, before face 2, which fills the view behind it. */
static void pictures_init(struct pictures *pictures)
{
    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 1, 1.0, 2.0);
    scene_add_square(&scene, 2, 9.0, 4.0);
    pictures->reference = draw(&scene, &ALONG_MINUS_Z);
    memcpy(pictures->rendered, pictures->reference.faces, sizeof pictures->rendered);
}

static void assert_counts(const struct pictures *pictures, const uint32_t *groups, size_t wrong, size_t beyond,
                          size_t holes)
{
    struct compare_counts counts = compare_picture(pictures->rendered, &pictures->reference, groups, 0.001);
    assert_int_equal(counts.pixels, W_PX * H_PX);
    assert_int_equal(counts.wrong, wrong);
    assert_int_equal(counts.beyond, beyond);
    assert_int_equal(counts.holes, holes);
    counts = compare_wrong(pictures->rendered, &pictures->reference, groups);
    assert_int_equal(counts.pixels, W_PX * H_PX);
    assert_int_equal(counts.wrong, wrong);
}

static size_t order_errors(const struct pictures *pictures)
{
    return compare_picture(pictures->rendered, &pictures->reference, NULL, 0.001).order;
}

static void equal_pictures_have_nothing_wrong(void **state)
{
    (void)state;
    struct pictures pictures;
    pictures_init(&pictures);
    assert_counts(&pictures, NULL, 0, 0, 0);
    reference_free(&pictures.reference);
}

static void edge_shifted_by_a_pixel_is_wrong_but_not_beyond(void **state)
{
    (void)state;
    for (int side = 0; side < 4; side++) { /* right, left, bottom, top of the square */
        static const unsigned first_px[4][2] = {{30, 31}, {9, 8}, {25, 26}, {4, 3}};
        struct pictures pictures;
        pictures_init(&pictures);
        for (unsigned shift = 0; shift < 2; shift++) {
            for (unsigned along = 10; along < 20; along++) {
                unsigned x = side < 2 ? first_px[side][shift] : along, y = side < 2 ? along : first_px[side][shift];
                pictures.rendered[y * W_PX + x] = 1;
            }
            assert_counts(&pictures, NULL, shift ? 20 : 10, shift ? 10 : 0, 0);
        }
        reference_free(&pictures.reference);
    }
}

static void farther_face_or_background_through_a_surface_is_a_hole(void **state)
{
    (void)state;
    struct pictures pictures;
    pictures_init(&pictures);
    pictures.rendered[15 * W_PX + 20] = 2;
    assert_counts(&pictures, NULL, 1, 1, 1);
    assert_int_equal(order_errors(&pictures), 1);
    pictures.rendered[15 * W_PX + 20] = 0;
    assert_counts(&pictures, NULL, 1, 1, 1);
    assert_int_equal(order_errors(&pictures), 0);
    pictures.rendered[0] = 1; /* nearer than what is there: wrong, no hole */
    assert_counts(&pictures, NULL, 2, 2, 1);
    reference_free(&pictures.reference);
}

static void face_within_tolerance_behind_is_no_hole(void **state)
{
    (void)state;
    for (int beyond_tolerance = 0; beyond_tolerance < 2; beyond_tolerance++) {
        struct scene scene;
        scene_clear(&scene);
        scene_add_square(&scene, 1, 9.0, 2.0);
        scene_add_square(&scene, 2, 9.0, beyond_tolerance ? 2.011 : 2.009); /* 8 units and 0.1 %: 10 mm */
        struct pictures pictures = {.reference = draw(&scene, &ALONG_MINUS_Z)};
        memcpy(pictures.rendered, pictures.reference.faces, sizeof pictures.rendered);
        pictures.rendered[15 * W_PX + 20] = 2;
        assert_counts(&pictures, NULL, 1, 1, (size_t)beyond_tolerance);
        reference_free(&pictures.reference);
    }
}

static void background_beside_background_is_no_hole(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 1, 1.0, 2.0);
    struct pictures pictures = {.reference = draw(&scene, &ALONG_MINUS_Z)};
    memcpy(pictures.rendered, pictures.reference.faces, sizeof pictures.rendered);
    pictures.rendered[5 * W_PX + 10] = 0; /* the square's corner */
    assert_counts(&pictures, NULL, 1, 0, 0);
    pictures.rendered[6 * W_PX + 11] = 0; /* one further in */
    assert_counts(&pictures, NULL, 2, 1, 1);
    reference_free(&pictures.reference);
}

static void merged_faces_count_as_one(void **state)
{
    (void)state;
    static const uint32_t groups[] = {0, 1, 1}, others[] = {0, 3, 3, 3};
    struct pictures pictures;
    pictures_init(&pictures);
    pictures.rendered[15 * W_PX + 20] = 2;
    assert_counts(&pictures, groups, 0, 0, 0);
    pictures.rendered[15 * W_PX + 20] = 0;
    assert_counts(&pictures, groups, 1, 1, 1);
    reference_free(&pictures.reference);

    struct scene scene;
    scene_clear(&scene);
    scene_add_square(&scene, 1, 1.0, 2.0);
    pictures.reference = draw(&scene, &ALONG_MINUS_Z);
    memcpy(pictures.rendered, pictures.reference.faces, sizeof pictures.rendered);
    pictures.rendered[15 * W_PX + 30] = 2; /* beside the square's edge */
    assert_counts(&pictures, NULL, 1, 1, 0);
    assert_counts(&pictures, others, 1, 0, 0);
    reference_free(&pictures.reference);
}

static void depth_of_an_edge_on_face_stays_within_its_corners(void **state)
{
    (void)state;
    struct scene scene;
    scene_clear(&scene);
    double upright[4][3] = {{0.0, -1.0, -5.0}, {0.0, -1.0, -3.0}, {0.0, 1.0, -3.0}, {0.0, 1.0, -5.0}};
    scene_add(&scene, 1, 4, upright);
    struct viewpoint viewpoint = ALONG_MINUS_Z;
    viewpoint.eye_m[0] = viewpoint.target_m[0] = 0.01;
    struct reference reference = draw(&scene, &viewpoint);
    for (size_t x = 0; x < W_PX; x++) {
        double depth_m = reference_depth_of(&reference, NULL, 1, 15 * W_PX + x);
        assert_true(depth_m >= 3.0 && depth_m <= 5.0);
    }
    assert_true(isinf(reference_depth_of(&reference, NULL, 2, 0)));
    reference_free(&reference);
}

/* Whatever is behind, nobody sees it within a pixel where one face fills that; and beside that face's edge, or
 * before it, it is seen as ever. */
static void what_one_face_hides_is_not_seen_nearby(void **state)
{
    (void)state;
    struct pictures pictures;
    pictures_init(&pictures);
    for (unsigned x = 8; x <= 31; x++) /* the square's columns are 10 to 29 */
        assert_int_equal(reference_sees_nearby(&pictures.reference, NULL, 2, 15 * W_PX + x), x <= 10 || x >= 29);
    assert_false(reference_sees_nearby(&pictures.reference, NULL, 0, 15 * W_PX + 20));
    assert_true(reference_sees_nearby(&pictures.reference, NULL, 1, 15 * W_PX + 20));
    assert_false(reference_sees_nearby(&pictures.reference, NULL, 1, 0));
    reference_free(&pictures.reference);
}

/* A merged polygon has the number of one of its faces, and may reach farther than that one does. */
static void depth_of_a_group_is_held_within_all_of_it(void **state)
{
    (void)state;
    static const uint32_t groups[] = {0, 1, 1};
    struct scene scene;
    scene_clear(&scene);
    double near_floor[4][3] = {{-1.0, -1.0, -2.0}, {1.0, -1.0, -2.0}, {1.0, -1.0, -4.0}, {-1.0, -1.0, -4.0}};
    double far_floor[4][3] = {{-1.0, -1.0, -4.0}, {1.0, -1.0, -4.0}, {1.0, -1.0, -8.0}, {-1.0, -1.0, -8.0}};
    scene_add(&scene, 1, 4, near_floor);
    scene_add(&scene, 2, 4, far_floor);
    struct reference reference = draw(&scene, &ALONG_MINUS_Z);
    const size_t pixel = 18 * W_PX + 20; /* the floor lies 5 to 6 m away there */
    assert_true(reference.faces[pixel] == 2);
    assert_true(reference_depth_of(&reference, NULL, 1, pixel) <= 4.0);
    assert_true(reference_depth_of(&reference, groups, 1, pixel) > 4.0);
    assert_true(reference_depth_of(&reference, groups, 1, pixel) <= reference.depths_m[pixel]);
    reference_free(&reference);
}

static void sum_remembers_the_worst_frame(void **state)
{
    (void)state;
    struct comparison sum = {0};
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 1});
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 5, .beyond = 2, .holes = 1});
    comparison_add(&sum, &(struct compare_counts){.pixels = 1000, .wrong = 3});
    assert_int_equal(sum.frames, 3);
    assert_int_equal(sum.worst_frame, 1);
    assert_int_equal(sum.total.holes, 1);
    assert_true(fabs(compare_wrong_percent(&sum.total) - 0.3) < 1e-12);
    assert_true(fabs(compare_wrong_percent(&sum.worst) - 0.5) < 1e-12);
    assert_true(fabs(compare_beyond_ppm(&sum.total) - 2e6 / 3000.0) < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_pictures_have_nothing_wrong),
        cmocka_unit_test(edge_shifted_by_a_pixel_is_wrong_but_not_beyond),
        cmocka_unit_test(farther_face_or_background_through_a_surface_is_a_hole),
        cmocka_unit_test(face_within_tolerance_behind_is_no_hole),
        cmocka_unit_test(background_beside_background_is_no_hole),
        cmocka_unit_test(merged_faces_count_as_one),
        cmocka_unit_test(depth_of_an_edge_on_face_stays_within_its_corners),
        cmocka_unit_test(what_one_face_hides_is_not_seen_nearby),
        cmocka_unit_test(depth_of_a_group_is_held_within_all_of_it),
        cmocka_unit_test(sum_remembers_the_worst_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
