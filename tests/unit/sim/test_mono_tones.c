/* SPDX-License-Identifier: MIT
 *
 * Light and tones for black and white pixels: what is said of them is computed here from pictures and faces in plain
 * sight. */
#include "model/mono_tones.h"

#include "model/baked_light.h"
#include "rigs/cmocka_ready.h"
#include "rigs/tiny_model.h"

enum { THIRD = 85, WHITE = 255 };

static void free_model(struct model *model)
{
    for (size_t i = 0; i < model->picture_count; i++)
        free(model->pictures[i].pixels);
    free(model->pictures);
    free(model->points);
    free(model->uvs);
    free(model->corners);
    free(model->faces);
}

/* A square of the colour, of such a side. */
static void add_square(struct model *model, double side_m, uint32_t colour)
{
    TINY(model, {0, 0, 0}, {side_m, 0, 0}, {side_m, side_m, 0}, {0, side_m, 0});
    model->faces[model->face_count - 1].colour = colour;
}

static uint32_t grey(uint32_t level)
{
    return level << 16 | level << 8 | level;
}

static void brightest_becomes_white_and_black_a_third(void **state)
{
    struct model model = {0};
    (void)state;
    add_square(&model, 1, 0x000000);
    add_square(&model, 1, 0x404040);
    add_square(&model, 1, 0x808080);
    mono_tones(&model);
    assert_int_equal(model.faces[0].colour, grey(THIRD));
    assert_int_equal(model.faces[1].colour, grey((THIRD + WHITE) / 2));
    assert_int_equal(model.faces[2].colour, grey(WHITE));
    free_model(&model);
}

/* Green is brighter than red, and that than blue. */
static void colours_become_greys_by_their_brightness(void **state)
{
    struct model model = {0};
    (void)state;
    add_square(&model, 1, 0x00FF00);
    add_square(&model, 1, 0xFF0000);
    add_square(&model, 1, 0x0000FF);
    mono_tones(&model);
    for (int i = 0; i < 3; i++)
        assert_int_equal(model.faces[i].colour, grey(model.faces[i].colour & 0xFF));
    assert_int_equal(model.faces[0].colour, grey(WHITE));
    assert_true(model.faces[0].colour > model.faces[1].colour && model.faces[1].colour > model.faces[2].colour);
    free_model(&model);
}

/* A hundredth of the area is white: what is large and grey takes its place. */
static void small_highlight_does_not_darken_the_rest(void **state)
{
    struct model model = {0};
    (void)state;
    add_square(&model, 10, 0x606060);
    add_square(&model, 1, 0xFFFFFF);
    mono_tones(&model);
    assert_int_equal(model.faces[0].colour, grey(WHITE));
    assert_int_equal(model.faces[1].colour, grey(WHITE));
    free_model(&model);
}

static void black_model_stays_in_sight_and_even(void **state)
{
    struct model model = {0};
    (void)state;
    add_square(&model, 1, 0x000000);
    add_square(&model, 1, 0x010101);
    mono_tones(&model);
    assert_int_equal(model.faces[0].colour, grey(THIRD));
    assert_in_range(model.faces[1].colour & 0xFF, THIRD, THIRD + 6);
    free_model(&model);
}

/* Its texels get the tones, and the face that shows it keeps a tint. */
static void dark_picture_becomes_bright(void **state)
{
    struct model model = {0};
    (void)state;
    add_square(&model, 1, 0xFFFFFF);
    model.uvs = calloc(model.point_count, sizeof *model.uvs);
    model.pictures = calloc(1, sizeof *model.pictures);
    model.picture_count = 1;
    model.pictures[0].w_px = 2;
    model.pictures[0].h_px = 1;
    model.pictures[0].pixels = calloc(2, sizeof *model.pictures[0].pixels);
    model.pictures[0].pixels[0] = 0x303030;
    model.faces[0].picture = 1;
    mono_tones(&model);
    assert_int_equal(model.pictures[0].pixels[0], grey(WHITE));
    assert_int_equal(model.pictures[0].pixels[1], grey(THIRD));
    assert_int_equal(model.faces[0].colour, grey(WHITE));
    free_model(&model);
}

static void empty_model_is_left_alone(void **state)
{
    struct model model = {0};
    (void)state;
    mono_tones(&model);
    light_bake_mono(&model);
    free_model(&model);
}

/* Sides of a box that meet are as far from one another as 9 of the 64 shares of white pixels, at least. */
static void sides_of_a_box_can_be_told_apart(void **state)
{
    int level[6];
    (void)state;
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
        double corner[3][3] = {{0}};
        struct model model = {0};
        corner[1][side % 2 ? last : next] = 1;
        corner[2][side % 2 ? next : last] = 1;
        tiny_add(&model, 3, (const double(*)[3])corner);
        light_bake_mono(&model);
        level[side] = (int)(model.faces[0].colour & 0xFF) * 64 / 255;
        free_model(&model);
    }
    for (int a = 0; a < 6; a++)
        for (int b = 0; b < 6; b++)
            if (a / 2 != b / 2) assert_true(abs(level[a] - level[b]) >= 9);
    assert_true(level[2] > level[3]); /* light comes from above */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(brightest_becomes_white_and_black_a_third),
        cmocka_unit_test(colours_become_greys_by_their_brightness),
        cmocka_unit_test(small_highlight_does_not_darken_the_rest),
        cmocka_unit_test(black_model_stays_in_sight_and_even),
        cmocka_unit_test(dark_picture_becomes_bright),
        cmocka_unit_test(empty_model_is_left_alone),
        cmocka_unit_test(sides_of_a_box_can_be_told_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
