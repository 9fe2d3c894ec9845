/* SPDX-License-Identifier: MIT
 *
 * Baked light: one lamp above the left shoulder, brightness by the angle alone. */
#include "model/baked_light.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"

#include <math.h>

/* Brightness of white on an 8-bit channel: lamp in front, lamp behind, no direction at all. */
enum { WHITE = 0xFFFFFF, BRIGHTEST = 255, DARKEST = 61, NEITHER = 158 };

static const double TO_LAMP[3] = {-0.4, 0.8, 0.45};

static void free_model(struct model *model)
{
    free(model->points);
    free(model->corners);
    free(model->faces);
}

/* Bakes and tells the colour of the last face. */
static uint32_t baked_last(struct model *model)
{
    light_bake(model);
    return model->faces[model->face_count - 1].colour;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* A white triangle whose normal has the direction n, somewhere in space. */
static void add_facing(struct model *model, const double n[3])
{
    const double across[3] = {fabs(n[0]) < fabs(n[1]), fabs(n[0]) >= fabs(n[1]), 0}; /* not along n */
    double u[3], v[3], places[3][3];

    cross(across, n, u);
    cross(n, u, v); /* u x v = n (u . u) */
    for (int i = 0; i < 3; i++) {
        places[0][i] = 5.0 * i - 3.0;
        places[1][i] = places[0][i] + u[i];
        places[2][i] = places[0][i] + v[i];
    }
    tiny_add(model, 3, (const double(*)[3])places);
    model->faces[model->face_count - 1].colour = WHITE;
}

/* The channel of a white face that looks along n; all three are alike. */
static int brightness(const double n[3])
{
    struct model model = {0};
    add_facing(&model, n);
    const uint32_t colour = baked_last(&model);
    free_model(&model);
    assert_int_equal(colour >> 16, colour & 0xFF);
    assert_int_equal(colour >> 8 & 0xFF, colour & 0xFF);
    return (int)(colour & 0xFF);
}

static void random_direction(struct random *random, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = random_unit(random) - 0.5;
}

static double cosine_to_lamp(const double n[3])
{
    double dot = 0, square = 0, lamp = 0;
    for (int i = 0; i < 3; i++) {
        dot += n[i] * TO_LAMP[i];
        square += n[i] * n[i];
        lamp += TO_LAMP[i] * TO_LAMP[i];
    }
    return dot / sqrt(square * lamp);
}

static void a_face_that_looks_at_the_lamp_is_brightest(void **state)
{
    const double away[3] = {-TO_LAMP[0], -TO_LAMP[1], -TO_LAMP[2]};

    (void)state;
    assert_int_equal(brightness(TO_LAMP), BRIGHTEST);
    assert_int_equal(brightness(away), DARKEST);
}

static void every_direction_is_between_the_bounds(void **state)
{
    struct random random = {7};

    (void)state;
    for (int i = 0; i < 2000; i++) {
        double n[3];
        random_direction(&random, n);
        const int value = brightness(n);
        assert_in_range(value, DARKEST, BRIGHTEST);
    }
}

/* No tie but by rounding, not even among those that look away from the lamp. */
static void the_nearer_to_the_lamp_the_brighter(void **state)
{
    struct random random = {8};

    (void)state;
    for (int i = 0; i < 2000; i++) {
        double a[3], b[3];
        random_direction(&random, a);
        random_direction(&random, b);
        const double nearer = cosine_to_lamp(a) - cosine_to_lamp(b);
        if (nearer > 0.02) assert_true(brightness(a) > brightness(b));
        if (nearer < -0.02) assert_true(brightness(a) < brightness(b));
    }
}

static void winding_decides_the_side(void **state)
{
    struct model model = {0};

    (void)state;
    TINY(&model, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}); /* up */
    TINY(&model, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}); /* the same, down */
    model.faces[0].colour = model.faces[1].colour = WHITE;
    light_bake(&model);
    assert_in_range(model.faces[0].colour & 0xFF, NEITHER + 50, BRIGHTEST);
    assert_in_range(model.faces[1].colour & 0xFF, DARKEST, NEITHER - 50);
    free_model(&model);
}

static void size_and_place_do_not_matter(void **state)
{
    struct model model = {0};

    (void)state;
    TINY(&model, {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    TINY(&model, {900, -70, 5}, {900, -70, 5000}, {6000, -70, 5});
    TINY(&model, {1, 2, 3}, {1, 2, 3.001}, {1.001, 2, 3});
    light_bake(&model);
    assert_int_equal(model.faces[1].colour, model.faces[0].colour);
    assert_int_equal(model.faces[2].colour, model.faces[0].colour);
    free_model(&model);
}

/* The first three corners turn the other way. */
static void a_concave_face_is_lit_by_its_whole(void **state)
{
    struct model model = {0};

    (void)state;
    TINY(&model, {0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0});
    TINY(&model, {1, 0, 3}, {1, 0, 1}, {4, 0, 1}, {4, 0, 0}, {0, 0, 0}, {0, 0, 3});
    light_bake(&model);
    assert_int_equal(model.faces[1].colour, model.faces[0].colour);
    free_model(&model);
}

static void an_unlit_face_keeps_its_colour(void **state)
{
    struct model model = {0};

    (void)state;
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}); /* down, in the shade */
    TINY(&model, {0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    model.faces[0].colour = model.faces[1].colour = 0x12C8FF;
    model.faces[1].unlit = true;
    light_bake(&model);
    assert_int_not_equal(model.faces[0].colour, 0x12C8FF);
    assert_int_equal(model.faces[1].colour, 0x12C8FF);
    free_model(&model);
}

static void a_face_of_no_area_gets_the_middle(void **state)
{
    struct model model = {0};

    (void)state;
    TINY(&model, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    TINY(&model, {3, 3, 3}, {3, 3, 3}, {3, 3, 3});
    model.faces[0].colour = model.faces[1].colour = WHITE;
    light_bake(&model);
    assert_int_equal(model.faces[0].colour, NEITHER * 0x010101);
    assert_int_equal(model.faces[1].colour, NEITHER * 0x010101);
    free_model(&model);
}

static void channels_keep_their_places(void **state)
{
    struct model model = {0};

    (void)state;
    add_facing(&model, TO_LAMP);
    model.faces[0].colour = 0xFE7F01;
    assert_int_equal(baked_last(&model), 0xFE7F01);
    for (int i = 0; i < 3; i++)
        memcpy(model.points[i], (double[3]){0, 0, 0}, sizeof model.points[i]);
    assert_int_equal(baked_last(&model), 0x9D4F01); /* 0.62 of each, rounded */
    free_model(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_face_that_looks_at_the_lamp_is_brightest),
        cmocka_unit_test(every_direction_is_between_the_bounds),
        cmocka_unit_test(the_nearer_to_the_lamp_the_brighter),
        cmocka_unit_test(winding_decides_the_side),
        cmocka_unit_test(size_and_place_do_not_matter),
        cmocka_unit_test(a_concave_face_is_lit_by_its_whole),
        cmocka_unit_test(an_unlit_face_keeps_its_colour),
        cmocka_unit_test(a_face_of_no_area_gets_the_middle),
        cmocka_unit_test(channels_keep_their_places),
    };

    return cmocka_run_group_tests_name("light", tests, NULL, NULL);
}
