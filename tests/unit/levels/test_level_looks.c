/* SPDX-License-Identifier: MIT
 *
 * What walls and flats of small WADs show, and how light they are. The numbers are worked out by hand from the format's
 * description. */
#include "rigs/cmocka_ready.h"
#include "unit/levels/level_rig.h"

#include <math.h>
#include <string.h>

/* Textures ------------------------------------------------------------------------------------ */

/* Rows of WALL, which has 128 of them, at a wall's upper and lower end. */
static void assert_rows(const struct model *model, const struct model_face *face, double lower, double upper)
{
    assert_string_equal(level_picture_of(model, face), "WALL");
    for (uint32_t k = 0; k < face->count; k++) {
        const double height = level_corner_at(model, face, k)[1], v = level_uv(model, face, k)[1] * 128;
        const bool is_low = height == fmin(level_corner_at(model, face, 0)[1], level_corner_at(model, face, 2)[1]);
        if (v != (is_low ? lower : upper)) fail_msg("row %g at %g m", v, height);
    }
}

enum { UPPER_UNPEGGED = 8, LOWER_UNPEGGED = 16 };

static void assert_step_rows(unsigned flags, int y_offset, double lower_low, double lower_high, double upper_low,
                             double upper_high)
{
    level_begin(NULL);
    const unsigned line = level_step(24, 200);
    level_map.lines[line][2] = (uint16_t)flags;
    level_map.sides[level_map.lines[line][5]].offsets[1] = (int16_t)y_offset;
    struct model model = level_saved();
    assert_rows(&model, level_need_wall(&model, -1, 0, 0, 24), lower_low, lower_high);
    assert_rows(&model, level_need_wall(&model, -1, 0, 200, 256), upper_low, upper_high);
    model_free(&model);
}

static void steps_hang_from_the_edges_that_their_flags_say(void **state)
{
    (void)state;
    /* pegged: the lower one hangs from the step's edge, the upper one stands on the opening */
    assert_step_rows(0, 0, 24, 0, 128, 128 - 56);
    /* unpegged: both hang from the ceiling in front */
    assert_step_rows(LOWER_UNPEGGED, 0, 256, 256 - 24, 128, 128 - 56);
    assert_step_rows(UPPER_UNPEGGED, 0, 24, 0, 56, 0);
    assert_step_rows(0, 10, 34, 10, 138, 138 - 56);
}

static void assert_whole_rows(unsigned flags, double low, double high)
{
    level_begin(NULL);
    wad_room(&level_map, 0, 0, 256, wad_sector(&level_map, 0, 96, 255, "FLOOR", "CEIL"));
    for (size_t i = 0; i < level_map.line_count; i++)
        level_map.lines[i][2] = (uint16_t)flags;
    struct model model = level_saved();
    assert_rows(&model, level_need_wall(&model, 1, 0, 0, 96), low, high);
    model_free(&model);
}

static void whole_walls_hang_from_the_ceiling_or_stand_on_the_floor(void **state)
{
    (void)state;
    assert_whole_rows(0, 96, 0);
    assert_whole_rows(LOWER_UNPEGGED, 128, 32);
}

static void columns_run_along_the_line_from_its_offset(void **state)
{
    (void)state;
    wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 96, 255, "FLOOR", "CEIL"));
    level_map.sides[0].offsets[0] = 16;
    struct model model = level_saved();
    const struct model_face *face = level_need_wall(&model, 1, 0, 0, 96); /* line 0, northwards */
    for (uint32_t k = 0; k < face->count; k++)
        assert_true(level_uv(&model, face, k)[0] * 64 == 16 - level_corner_at(&model, face, k)[2] * 32);
    model_free(&model);
}

static void flats_lie_on_the_world(void **state)
{
    (void)state;
    wad_room(&level_map, 40, -8, 96, wad_sector(&level_map, 0, 96, 255, "FLOOR", "FLOOR"));
    struct model model = level_saved();
    for (size_t i = 0; i < 2; i++)
        for (uint32_t k = 0; k < 4; k++) {
            const double *p = level_corner_at(&model, &model.faces[i], k), *at = level_uv(&model, &model.faces[i], k);
            assert_string_equal(level_picture_of(&model, &model.faces[i]), "FLOOR");
            assert_true(at[0] == p[0] / 2 && at[1] == p[2] / 2);
        }
    model_free(&model);
}

static void pictures_have_the_patches_texels_in_the_palettes_colours(void **state)
{
    (void)state;
    wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 96, 255, "FLOOR", "CEIL"));
    struct model model = level_saved();
    const struct model_face *face = level_need_wall(&model, 1, 0, 0, 96);
    const struct picture *picture = &model.pictures[face->picture - 1];
    assert_int_equal(picture->w_px, 64);
    assert_int_equal(picture->h_px, 128);
    assert_int_equal(picture->faces, 4);
    for (uint32_t y = 0; y < 128; y++)
        for (uint32_t x = 0; x < 64; x++) {
            const uint32_t i = x + y / 2;
            assert_int_equal(picture->pixels[y * 64 + x], i << 16 | i << 8 | i / 2);
        }
    model_free(&model);
}

static void what_is_of_one_colour_and_all_without_textures_is_a_colour(void **state)
{
    (void)state;
    wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 96, 255, "FLOOR", "CEIL"));
    memcpy(level_map.sides[0].names[2], "ONE\0\0\0\0\0", 8);
    struct model model = level_saved();
    const struct model_face *one = level_need_wall(&model, 1, 0, 0, 96);
    assert_int_equal(one->picture, 0);
    assert_int_equal(one->colour, 0x070703);
    model_free(&model);
    model = level_imported("a.wad:MAP01", false);
    assert_int_equal(model.picture_count, 0);
    assert_null(model.uvs);
    /* the mean of x + y / 2 over 64 x 128, and of its half, each rounded down: 31.5 + 31.5; (x + y / 2) / 2 - 1 / 4 */
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 96)->colour, 0x3F3F1F);
    model_free(&model);
}

/* Light --------------------------------------------------------------------------------------- */

/* Rows of the colour map are (32 - row) / 32 of the palette's brightness, or a little less, as colours are whole. */
static void assert_light(int sector_light, int contrast, uint32_t colour)
{
    int level = sector_light / 16 + contrast, row;
    level = level < 0 ? 0 : level > 15 ? 15 : level;
    row = (15 - level) * 4 - 16;
    row = row < 0 ? 0 : row > 31 ? 31 : row;
    const double expected = 255.0 * (32 - row) / 32;
    assert_true(fabs((double)(colour & 0xFF) - expected) <= 3);
    assert_int_equal(colour >> 8 & 0xFF, colour & 0xFF);
    assert_int_equal(colour >> 16, colour & 0xFF);
}

static void walls_along_the_axes_are_a_level_lighter_or_darker_than_the_sector(void **state)
{
    (void)state;
    for (int light = 0; light < 256; light += 5) {
        level_begin(NULL);
        wad_room(&level_map, 0, 0, 96, wad_sector(&level_map, 0, 96, light, "FLOOR", "FLOOR"));
        level_map.vertices[3][0] = 200; /* its last two lines: one along x still, the other across */
        level_map.vertices[2][0] = 150;
        struct model model = level_saved();
        assert_light(light, 0, model.faces[0].colour);
        assert_light(light, 1, level_need_wall(&model, 1, 0, 0, 96)->colour);
        assert_light(light, -1, level_need_wall(&model, 0, 1, 0, 96)->colour);
        assert_light(light, 0, level_need_wall(&model, -96, 50, 0, 96)->colour);
        model_free(&model);
    }
}

/* What hangs in openings, and the sky ---------------------------------------------------------- */

static void a_masked_texture_is_one_texture_high_and_has_holes(void **state)
{
    (void)state;
    const unsigned line = level_step(24, 200);
    memcpy(level_map.sides[level_map.lines[line][5]].names[2], "GRATE\0\0\0", 8);
    level_map.sides[level_map.lines[line][5]].offsets[1] = -16;
    struct model model = level_saved();
    const struct model_face *pane = level_need_wall(&model, -1, 0, 200 - 16 - 8, 200 - 16);
    assert_int_equal(pane->transparency, 128); /* every other column is clear */
    const struct picture *picture = &model.pictures[pane->picture - 1];
    assert_true(pane->picture && picture->is_masked);
    assert_int_equal(pane->colour, 0xFFFFFF);
    for (uint32_t i = 0; i < picture->w_px * picture->h_px; i++)
        assert_int_equal((picture->pixels[i] & PICTURE_CLEAR) != 0, i % 2 == 1);
    model_free(&model);
    model = level_imported("a.wad:MAP01", false);
    pane = level_need_wall(&model, -1, 0, 200 - 16 - 8, 200 - 16);
    assert_int_equal(pane->transparency, 128); /* without textures it is a pane */
    assert_int_equal(pane->picture, 0);
    assert_int_equal(pane->colour, 0x18180C); /* colours 20 to 27 */
    model_free(&model);
    level_map.lines[line][2] = LOWER_UNPEGGED;
    level_map.sides[level_map.lines[line][5]].offsets[1] = -4; /* half of it is in the floor */
    model = level_saved();
    level_need_wall(&model, -1, 0, 24, 24 + 8 - 4);
    model_free(&model);
}

static void the_sky_is_in_its_own_colour_above_walls_and_between_skies(void **state)
{
    (void)state;
    level_step(0, 100);
    memcpy(level_map.sectors[0].names[1], "F_SKY1\0\0", 8);
    memcpy(level_map.sectors[1].names[1], "F_SKY1\0\0", 8);
    level_map.sectors[0].light = level_map.sectors[1].light = 0;
    struct model model = level_saved();
    const uint32_t sky = 0xC8C864; /* SKY1: colour 200, however dark the sector */
    assert_int_equal(level_need_wall(&model, -1, 0, 100, 256)->colour, sky);
    for (size_t i = 0; i < model.face_count; i++) {
        double normal[3];
        level_normal(&model, &model.faces[i], normal);
        if (normal[1] < 0) assert_int_equal(model.faces[i].colour, sky);
    }
    model_free(&model);
}

static void where_a_texture_is_left_out_the_floor_behind_lends_its_colour(void **state)
{
    (void)state;
    const unsigned line = level_step(24, 200);
    memcpy(level_map.sides[level_map.lines[line][5]].names[1], "-\0\0\0\0\0\0\0", 8);
    memcpy(level_map.sectors[1].names[0], "CEIL\0\0\0\0", 8);
    struct model model = level_saved();
    assert_int_equal(level_need_wall(&model, -1, 0, 0, 24)->colour, 0x090904);
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(steps_hang_from_the_edges_that_their_flags_say, level_begin),
        cmocka_unit_test_setup(whole_walls_hang_from_the_ceiling_or_stand_on_the_floor, level_begin),
        cmocka_unit_test_setup(columns_run_along_the_line_from_its_offset, level_begin),
        cmocka_unit_test_setup(flats_lie_on_the_world, level_begin),
        cmocka_unit_test_setup(pictures_have_the_patches_texels_in_the_palettes_colours, level_begin),
        cmocka_unit_test_setup(what_is_of_one_colour_and_all_without_textures_is_a_colour, level_begin),
        cmocka_unit_test_setup(walls_along_the_axes_are_a_level_lighter_or_darker_than_the_sector, level_begin),
        cmocka_unit_test_setup(a_masked_texture_is_one_texture_high_and_has_holes, level_begin),
        cmocka_unit_test_setup(the_sky_is_in_its_own_colour_above_walls_and_between_skies, level_begin),
        cmocka_unit_test_setup(where_a_texture_is_left_out_the_floor_behind_lends_its_colour, level_begin),
    };
    return cmocka_run_group_tests(tests, level_enter, level_leave);
}
