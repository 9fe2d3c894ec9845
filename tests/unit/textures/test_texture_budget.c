/* SPDX-License-Identifier: MIT
 *
 * --texture-budget: textures without their finest levels, what is lost by that, which step is taken first, how much of
 * a texture is seen, and that a model keeps to its budget. */
#include "accuracy/texels_seen.h"
#include "compiler/texture_budget.h"
#include "compiler/texture_plan.h"
#include "core/core.h"
#include "model/texture_cut.h"
#include "rigs/cmocka_ready.h"
#include "rigs/texture_rig.h"
#include "scene/mem_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SQUARE[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
static const double UNIT[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};

/* Squares beside each other, each with a picture of its own. */
static uint32_t add_square(struct model *model, uint32_t side_px, struct random *random)
{
    double places[4][3];
    const uint32_t picture = texture_rig_picture(model, side_px, side_px, random);
    memcpy(places, SQUARE, sizeof places);
    for (int i = 0; i < 4; i++)
        places[i][0] += 2.0 * picture;
    texture_rig_face(model, picture, 4, places, UNIT);
    return picture;
}

static struct mesh cleaned(const struct model *model)
{
    struct mesh mesh;
    struct error err;
    if (!mesh_clean(model, &mesh, &err)) fail_msg("%s", err.text);
    return mesh;
}

/* Cutting -------------------------------------------------------------------------------------- */

static uint32_t colour_at(const struct texture *texture, unsigned level, unsigned x, unsigned y)
{
    size_t first = 0;
    for (unsigned k = 0; k < level; k++)
        first += (size_t)1 << (texture->w_bits - k) << (texture->h_bits - k);
    return texture->palette[texture->texels[first + ((size_t)y << (texture->w_bits - level)) + x]];
}

static struct texture texture_of(uint32_t w_px, uint32_t h_px, struct random *random)
{
    struct model model = {0};
    struct texture out;
    texture_rig_picture(&model, w_px, h_px, random);
    assert_true(texture_make(&model.pictures[0], 10, &out));
    model_free(&model);
    return out;
}

static void what_is_cut_shows_the_coarser_levels(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = {{32, 32}, {64, 16}, {16, 64}};
    struct random random = {11};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct texture whole = texture_of(sizes[i][0], sizes[i][1], &random), cut = whole;
        cut.texels = malloc(whole.texel_count);
        assert_non_null(cut.texels);
        memcpy(cut.texels, whole.texels, whole.texel_count);
        const size_t texels = texture_cut_texels(&whole, 2), colours = texture_cut_colours(&whole, 2);
        texture_cut(&cut, 2);
        assert_int_equal(cut.w_bits, whole.w_bits - 2);
        assert_int_equal(cut.levels, whole.levels - 2);
        assert_int_equal(cut.texel_count, texels);
        assert_int_equal(cut.texel_count, texture_texels(cut.w_bits, cut.h_bits));
        assert_int_equal(cut.colours, colours);
        assert_true(cut.colours < whole.colours);
        for (unsigned level = 0; level < cut.levels; level++)
            for (unsigned y = 0; y < 1u << (cut.h_bits - level); y++)
                for (unsigned x = 0; x < 1u << (cut.w_bits - level); x++)
                    assert_int_equal(colour_at(&cut, level, x, y), colour_at(&whole, level + 2, x, y));
        texture_free(&cut);
        texture_free(&whole);
    }
}

static double apart2(uint32_t a, uint32_t b)
{
    const int red = (int)(a >> 16 & 255) - (int)(b >> 16 & 255), green = (int)(a >> 8 & 255) - (int)(b >> 8 & 255),
              blue = (int)(a & 255) - (int)(b & 255);
    return red * red + green * green + blue * blue;
}

static void errors_are_means_of_squares(void **state)
{
    (void)state;
    struct random random = {5};
    struct texture a = texture_of(32, 16, &random), b = texture_of(32, 16, &random);
    double sum = 0, flat = 0;
    assert_true(texture_is_alike(&a, &b));
    for (unsigned y = 0; y < 8; y++)
        for (unsigned x = 0; x < 16; x++) {
            sum += apart2(colour_at(&a, 1, x, y), colour_at(&b, 3, x / 4, y / 4));
            flat += apart2(colour_at(&a, 1, x, y), a.mean);
        }
    assert_true(fabs(texture_error(&a, 1, &b, 3) - sum / 128) < 1e-9);
    assert_true(fabs(texture_error_flat(&a, 1) - flat / 128) < 1e-9);
    assert_true(texture_error(&a, 2, &a, 2) == 0);
    texture_free(&a);
    texture_free(&b);
}

/* Seeing --------------------------------------------------------------------------------------- */

/* A wall of 20 x 20 pictures of 64 texels, a metre each, from in front of it: texels to a pixel are 64 * 2 tan z / 240.
 */
static void a_wall_is_seen_at_the_level_of_its_distance(void **state)
{
    (void)state;
    for (int level = 0; level < 5; level++) {
        struct random random = {3};
        struct model model = {0};
        struct error err;
        static const double wall[4][3] = {{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}};
        static const double uvs[4][2] = {{0, 80}, {80, 80}, {80, 0}, {0, 0}};
        texture_rig_face(&model, texture_rig_picture(&model, 64, 64, &random), 4, wall, uvs);
        struct mesh mesh = cleaned(&model);
        const double z_m = ldexp(240.0 / 64 / 2 / tan(3.14159265358979 / 6), level);
        struct viewpoint eye = {.eye_m = {0.1, 0.2, z_m}, .target_m = {0.1, 0.2, 0}};
        const struct camera_path path = {"the wall", &eye, 1};
        struct texels_seen seen = {{0}};
        struct lens lens;
        assert_true(lens_init(&lens, 60, 0.1, 1, 1, &err));
        assert_true(texels_seen_add(&mesh, &model, &path, &lens, 240, &seen, &err));
        double all = 0;
        for (int i = 0; i < TEXELS_SEEN_LEVELS; i++)
            all += seen.pixels[i];
        assert_true(all > 0 && seen.pixels[level] > 0.9 * all); /* the corners are farther, and slanted */
        mesh_free(&mesh);
        model_free(&model);
    }
}

/* Planning ------------------------------------------------------------------------------------- */

static void what_is_least_seen_is_cut_first(void **state)
{
    (void)state;
    struct random random = {21};
    struct model model = {0};
    for (int i = 0; i < 3; i++)
        add_square(&model, 64, &random);
    struct mesh mesh = cleaned(&model);
    const struct texels_seen seen[3] = {{{100}}, {{1}}, {{50}}};
    struct texture_plan plan;
    const size_t all_b = texture_plan_bytes(&mesh);
    assert_true(texture_plan_make(&mesh, seen, NULL, 0, all_b - 3000, &plan));
    assert_int_equal(plan.before_b, all_b);
    assert_int_equal(plan.steps[0].cut, 0);
    assert_int_equal(plan.steps[1].cut, 1);
    assert_int_equal(plan.steps[2].cut, 0);
    assert_true(plan.steps[1].rms > 10 && plan.steps[0].rms == 0);
    assert_true(plan.rms < plan.steps[1].rms / 8);
    texture_plan_free(&plan);
    mesh_free(&mesh);
    model_free(&model);
}

/* What is seen at its coarsest levels alone loses nothing by its finest. */
static void levels_that_nobody_sees_go_for_nothing(void **state)
{
    (void)state;
    struct random random = {22};
    struct model model = {0};
    for (int i = 0; i < 2; i++)
        add_square(&model, 64, &random);
    struct mesh mesh = cleaned(&model);
    const struct texels_seen seen[2] = {{{0, 0, 1000}}, {{1}}};
    struct texture_plan plan;
    assert_true(texture_plan_make(&mesh, seen, NULL, 0, texture_plan_bytes(&mesh) - 4500, &plan));
    assert_int_equal(plan.steps[0].cut, 2);
    assert_int_equal(plan.steps[1].cut, 0);
    assert_true(plan.rms == 0);
    texture_plan_free(&plan);
    mesh_free(&mesh);
    model_free(&model);
}

static void copy_pixels(struct model *model, uint32_t from, uint32_t to, int change)
{
    const struct picture *source = &model->pictures[from - 1];
    for (size_t i = 0; i < (size_t)source->w_px * source->h_px; i++)
        model->pictures[to - 1].pixels[i] = source->pixels[i] ^ (uint32_t)(i % 7 == 0 ? change : 0);
}

static void pictures_that_are_nearly_the_same_are_one(void **state)
{
    (void)state;
    struct random random = {23};
    struct model model = {0};
    const uint32_t first = add_square(&model, 32, &random), other = add_square(&model, 32, &random),
                   same = add_square(&model, 32, &random);
    copy_pixels(&model, first, same, 0x000003);
    struct mesh mesh = cleaned(&model);
    const struct texels_seen seen[3] = {{{100}}, {{100}}, {{100}}};
    struct texture_plan plan;
    assert_true(texture_plan_make(&mesh, seen, NULL, 0, texture_plan_bytes(&mesh) - 500, &plan));
    const uint32_t shown = plan.steps[first - 1].shows;
    assert_int_equal(plan.steps[same - 1].shows, shown);
    assert_true(shown == first - 1 || shown == same - 1);
    assert_int_equal(plan.steps[other - 1].shows, other - 1);
    assert_int_equal(plan.steps[other - 1].cut, 0);
    assert_true(plan.rms < 3);
    texture_plan_free(&plan);
    mesh_free(&mesh);
    model_free(&model);
}

static void a_picture_of_nearly_one_colour_becomes_it(void **state)
{
    (void)state;
    struct random random = {24};
    struct model model = {0};
    add_square(&model, 32, &random);
    const uint32_t flat = add_square(&model, 32, &random);
    for (size_t i = 0; i < 32 * 32; i++)
        model.pictures[flat - 1].pixels[i] = 0x406080 + (uint32_t)(random_u64(&random) & 0x030303);
    struct mesh mesh = cleaned(&model);
    const struct texels_seen seen[2] = {{{100}}, {{100}}};
    struct texture_plan plan;
    assert_true(texture_plan_make(&mesh, seen, NULL, 0, texture_plan_bytes(&mesh) - 1450, &plan));
    assert_true(plan.steps[flat - 1].is_flat);
    assert_true(plan.steps[flat - 1].rms > 0 && plan.steps[flat - 1].rms < 3);
    assert_false(plan.steps[0].is_flat);
    texture_plan_free(&plan);
    mesh_free(&mesh);
    model_free(&model);
}

/* At the least each has 8 texels along its shorter side: 64 + 16 + 4 + 1, in blocks of 16, and colours and a struct. */
static void the_least_is_told(void **state)
{
    (void)state;
    struct random random = {25};
    struct model model = {0};
    for (int i = 0; i < 2; i++)
        add_square(&model, 128, &random);
    struct mesh mesh = cleaned(&model);
    const struct texels_seen seen[2] = {{{1}}, {{1}}};
    struct texture_plan plan;
    size_t least_b = 2 * (96 + sizeof(struct lim_texture)) + TEXTURE_COLOURS * 2;
    for (int i = 0; i < 2; i++)
        least_b += 2 * texture_cut_colours(&mesh.textures[i], 4);
    assert_false(texture_plan_make(&mesh, seen, NULL, 0, least_b - 1, &plan));
    assert_int_equal(plan.after_b, least_b);
    texture_plan_free(&plan);
    assert_true(texture_plan_make(&mesh, seen, NULL, 0, least_b, &plan));
    texture_plan_free(&plan);
    mesh_free(&mesh);
    model_free(&model);
}

/* A model with a budget ------------------------------------------------------------------------- */

/* A room whose sides show two pictures in two lights, beside what is one colour. */
static struct model room(void)
{
    struct random random = {31};
    struct model model = {0};
    texture_rig_room(&model, texture_rig_picture(&model, 128, 128, &random), 2);
    const uint32_t second = texture_rig_picture(&model, 64, 128, &random);
    for (size_t i = 0; i < model.face_count; i += 2) {
        model.faces[i].picture = second;
        model.pictures[0].faces--, model.pictures[1].faces++;
    }
    model.faces[4].colour = model.faces[5].colour = 0x505050;
    return model;
}

static void what_is_compiled_keeps_to_the_budget(void **state)
{
    (void)state;
    static const char *const budgets[] = {"30", "17", "10.5", "4", "1.5"};
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = &core_fast};
    size_t before_b = SIZE_MAX;
    for (size_t i = 0; i < sizeof budgets / sizeof *budgets; i++) {
        struct model model = room();
        struct mesh mesh;
        struct error err;
        assert_true(texture_budget_parse(budgets[i], &err));
        if (!texture_budget_apply(&model, &options, &err)) fail_msg("%s", err.text);
        struct compiled scene = texture_rig_compile(&model, &mesh, &core_fast);
        const size_t size_b = texture_memory_b(&scene.scene);
        print_message("# %s KB: %zu bytes; %s\n", budgets[i], size_b, model.textures_became);
        assert_true((double)size_b <= strtod(budgets[i], NULL) * 1000);
        assert_true(size_b < before_b);
        assert_int_equal(model.pictures[0].faces + model.pictures[1].faces, 6);
        before_b = size_b;
        compiled_free(&scene);
        mesh_free(&mesh);
        model_free(&model);
    }
}

static void a_budget_that_is_kept_anyhow_changes_nothing(void **state)
{
    (void)state;
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = &core_fast};
    struct model model = room();
    struct error err;
    assert_true(texture_budget_parse("50", &err));
    assert_true(texture_budget_apply(&model, &options, &err));
    assert_int_equal(model.pictures[0].w_bits_end, 0);
    assert_string_equal(model.textures_became, "");
    model_free(&model);
}

/* Without a budget for any texture a face has the mean of its picture, of all of it here, in its light. */
static void what_no_size_keeps_becomes_colours(void **state)
{
    (void)state;
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = &core_fast};
    struct model model = room();
    struct error err;
    double sums[2][3] = {{0}};
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < (size_t)model.pictures[k].w_px * model.pictures[k].h_px; i++)
            for (int c = 0; c < 3; c++)
                sums[k][c] += (double)(model.pictures[k].pixels[i] >> 8 * c & 0xFF) / model.pictures[k].w_px /
                              model.pictures[k].h_px;
    assert_true(texture_budget_parse("0", &err));
    assert_true(texture_budget_apply(&model, &options, &err));
    assert_non_null(strstr(model.textures_became, "as a colour a face 2;"));
    for (size_t i = 0; i < model.face_count; i++) {
        const double light = i == 4 || i == 5 ? 0x50 / 255.0 : 1;
        assert_int_equal(model.faces[i].picture, 0);
        for (int c = 0; c < 3; c++)
            assert_true(fabs((model.faces[i].colour >> 8 * c & 0xFF) - light * sums[i % 2 == 0][c]) <= 1);
    }
    model_free(&model);
}

/* One texture is given up before two are: the one whose faces lose less by it. */
static void no_more_become_colours_than_must(void **state)
{
    (void)state;
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = &core_fast};
    struct model model = room();
    struct error err;
    assert_true(texture_budget_parse("0.8", &err));
    assert_true(texture_budget_apply(&model, &options, &err));
    assert_non_null(strstr(model.textures_became, "as a colour a face 1;"));
    assert_int_equal(!model.pictures[0].faces + !model.pictures[1].faces, 1);
    struct mesh mesh;
    struct compiled scene = texture_rig_compile(&model, &mesh, &core_fast);
    assert_true(scene.scene.texture_count > 0 && texture_memory_b(&scene.scene) <= 800);
    compiled_free(&scene);
    mesh_free(&mesh);
    model_free(&model);
}

static void bad_budgets_are_refused(void **state)
{
    (void)state;
    static const char *const bad[] = {"", "much", "-1", "70000", "nan", "10KB", "1e99"};
    struct error err;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(texture_budget_parse(bad[i], &err));
        assert_non_null(strstr(err.text, "--texture-budget"));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_cut_shows_the_coarser_levels),
        cmocka_unit_test(errors_are_means_of_squares),
        cmocka_unit_test(a_wall_is_seen_at_the_level_of_its_distance),
        cmocka_unit_test(what_is_least_seen_is_cut_first),
        cmocka_unit_test(levels_that_nobody_sees_go_for_nothing),
        cmocka_unit_test(pictures_that_are_nearly_the_same_are_one),
        cmocka_unit_test(a_picture_of_nearly_one_colour_becomes_it),
        cmocka_unit_test(the_least_is_told),
        cmocka_unit_test(what_is_compiled_keeps_to_the_budget),
        cmocka_unit_test(a_budget_that_is_kept_anyhow_changes_nothing),
        cmocka_unit_test(what_no_size_keeps_becomes_colours),
        cmocka_unit_test(no_more_become_colours_than_must),
        cmocka_unit_test(bad_budgets_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
