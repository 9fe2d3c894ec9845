/* SPDX-License-Identifier: MIT
 *
 * Textured polygons: which texel the renderer shows, against rays in double precision; all orders paint the same;
 * levels of detail, wrapping, extremes. */
#include "core/core.h"
#include "model/baked_light.h"
#include "model/mapping.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/random_camera.h"
#include "rigs/texture_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 80, CAMERAS = 60 };

/* A room compiled for a profile, and what draws it. */
struct rig {
    struct model model;
    struct mesh mesh;
    struct compiled scene;
    const struct core *core;
    struct random random;
    uint16_t w_px, h_px; /* of what is drawn */
};

static struct rig rig_make(const struct core *core, uint32_t side_px, double repeat)
{
    struct rig rig = {.core = core, .random = {1 + side_px}, .w_px = W_PX, .h_px = H_PX};
    texture_rig_room(&rig.model, texture_rig_picture(&rig.model, side_px, side_px, &rig.random), repeat);
    rig.scene = texture_rig_compile(&rig.model, &rig.mesh, core);
    return rig;
}

static void rig_free(struct rig *rig)
{
    compiled_free(&rig->scene);
    mesh_free(&rig->mesh);
    model_free(&rig->model);
}

/* Anywhere inside, 2 cm from a wall at least, with a lens from 10 to 100 degrees. */
static struct lim_camera camera_inside(struct rig *rig)
{
    return texture_rig_camera(&rig->random, &rig->scene.grid, 0.98, (double[]){0.09, 1.19}, W_PX, H_PX);
}

static void simulator_start(struct simulator *simulator, const struct rig *rig, enum lim_method method)
{
    const struct simulator_setup setup = {
        .w_px = rig->w_px, .h_px = rig->h_px, .method = method, .panel = SIMULATOR_MEMORY, .core = rig->core};
    struct error err;
    if (!simulator_init(simulator, &rig->scene.scene, &setup, &err)) fail_msg("%s", err.text);
}

struct checking {
    const struct rig *rig;
    const struct lim_camera *camera;
    const struct mapping *mapping;
    double right[3], down[3], ahead[3];
    double sum;         /* texels of the level shown */
    double far;         /* pixels that are farther off than a profile allows */
    double worst_level; /* by how much a level is off the one that fits best */
    size_t pixels;
};

/* A profile promises 2^-bits texels. */
static int off_bits_of(int profile)
{
    const int bits[] = {
        [LIM_PROFILE_DRAFT] = 0, [LIM_PROFILE_FAST] = 2, [LIM_PROFILE_FINE] = 4, [LIM_PROFILE_EXACT] = 6};
    return bits[profile];
}

static void check_texel(void *ctx, const struct core_texel_at *at)
{
    struct checking *checking = ctx;
    const struct grid *grid = &checking->rig->scene.grid;
    const struct mapping *mapping = checking->mapping;
    const struct texture *texture = &checking->rig->mesh.textures[mapping->texture];
    const double x = ldexp(checking->camera->tan_x_q28, -28) * ((2.0 * at->x_px + 1) / checking->rig->w_px - 1);
    const double y = ldexp(checking->camera->tan_y_q28, -28) * ((2.0 * at->y_px + 1) / checking->rig->h_px - 1);
    double ray[3], eye_m[3], along = 0, height = 0, place[3], uv[2], error2 = 0;
    for (int i = 0; i < 3; i++) {
        ray[i] = checking->ahead[i] + x * checking->right[i] + y * checking->down[i];
        eye_m[i] = checking->camera->eye_q8[i] / 256.0 / grid->units_per_m + grid->origin_m[i];
        along += mapping->normal[i] * ray[i];
        height += mapping->normal[i] * (mapping->centre_m[i] - eye_m[i]);
    }
    const double depth = height / along;
    for (int i = 0; i < 3; i++)
        place[i] = eye_m[i] + depth * ray[i];
    mapping_at(mapping, place, uv);
    const double side = 1 << texture->w_bits;
    for (int i = 0; i < 2; i++) {
        const double off = at->uv[i] - uv[i];
        error2 += pow(side * (off - floor(off + 0.5)), 2);
    }
    checking->pixels++;
    error2 = ldexp(error2, -2 * (int)at->level);
    checking->sum += sqrt(error2);
    checking->far += sqrt(error2) > ldexp(1, -off_bits_of(checking->rig->core->profile));
    if (!at->divided) return;
    /* Area of a pixel in texels, by the same projection. */
    const double px2 = ldexp(checking->camera->tan_x_q28, -27) / checking->rig->w_px *
                       ldexp(checking->camera->tan_y_q28, -27) / checking->rig->h_px;
    double density = 0;
    for (int i = 0; i < 3; i++)
        density += mapping->gradient[0][i] * mapping->gradient[0][i];
    const double texels = side * side * density * px2 * pow(depth, 3) / fabs(height);
    const double level = fmin(fmax(log2(texels) / 2, 0), texture->levels - 1);
    checking->worst_level = fmax(checking->worst_level, fabs(level - at->level));
}

/* All records with all cameras; a record's face is the room's side, and its mapping follows from that. */
static struct checking check_all(struct rig *rig, unsigned cameras)
{
    struct simulator simulator;
    simulator_start(&simulator, rig, LIM_NEAREST_FIRST);
    struct checking checking = {.rig = rig};
    const struct lim_scene *scene = &rig->scene.scene;
    for (unsigned i = 0; i < cameras; i++) {
        const struct lim_camera camera = camera_inside(rig);
        texture_rig_draw(&simulator, &camera);
        checking.camera = &camera;
        texture_rig_axes(&camera, checking.right, checking.down, checking.ahead);
        for (size_t word = 0, record = 0; word < scene->polygon_words;
             word += lim_record_words(scene->polygons[word]), record++) {
            checking.mapping = &rig->mesh.mappings[rig->mesh.polygons[rig->scene.faces[record] - 1].mapping];
            rig->core->texels(simulator.lim, (uint16_t)word, check_texel, &checking);
        }
    }
    simulator_free(&simulator);
    return checking;
}

/* Straight lines leave the curve of texels by as much as the profile allows, formats round beside. */
static void set_up_agrees_with_rays_in_double_precision(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++) {
        struct rig rig = rig_make(profiles[i], 64, 1);
        const struct checking checking = check_all(&rig, CAMERAS);
        const double mean = checking.sum / (double)checking.pixels;
        const double far = checking.far / (double)checking.pixels;
        print_message("# %s: mean %.4f texels, off by more than is allowed: %.2f %% of %zu pixels\n", profiles[i]->name,
                      mean, 100 * far, checking.pixels);
        assert_true(checking.pixels > CAMERAS * W_PX * H_PX / 2);
        assert_true(mean < ldexp(0.4, -off_bits_of(profiles[i]->profile)));
        assert_true(far < 0.01);
        rig_free(&rig);
    }
}

/* A polygon's surroundings end beyond a picture that has but a line or a column. */
static void lines_and_columns_agree_with_rays_in_double_precision(void **state)
{
    (void)state;
    static const uint16_t sides_px[][2] = {{96, 1}, {96, 2}, {96, 3}, {1, 80}, {2, 80}, {1, 1}, {2, 2}};
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count * (sizeof sides_px / sizeof *sides_px); i++) {
        const uint16_t *sides = sides_px[i / count];
        struct rig rig = rig_make(profiles[i % count], 64, 1);
        rig.w_px = sides[0];
        rig.h_px = sides[1];
        const struct checking checking = check_all(&rig, CAMERAS * W_PX * H_PX / 16u / (sides[0] * sides[1]));
        const double mean = checking.sum / (double)checking.pixels;
        const double far = (double)checking.far / (double)checking.pixels;
        print_message("# %s, %ux%u: mean %.4f texels, off by more than is allowed: %.2f %% of %zu pixels\n",
                      rig.core->name, sides[0], sides[1], mean, 100 * far, checking.pixels);
        assert_true(mean < ldexp(0.4, -off_bits_of(rig.core->profile)));
        assert_true(far < 0.03);
        rig_free(&rig);
    }
}

static void levels_of_detail_are_those_that_fit(void **state)
{
    (void)state;
    for (double repeat = 1; repeat <= 64; repeat *= 4) {
        struct rig rig = rig_make(&core_exact, 64, repeat);
        const struct checking checking = check_all(&rig, CAMERAS / 4);
        print_message("# %g pictures a wall: level at most %.2f off\n", repeat, checking.worst_level);
        /* Half a level is rounding; what a logarithm of straight lines and a stretch of 4 pixels add is less than that.
         */
        assert_true(checking.worst_level < 0.8);
        rig_free(&rig);
    }
}

/* Orders ------------------------------------------------------------------------------------------ */

static void both_orders_paint_the_same(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++) {
        struct rig rig = rig_make(profiles[i], 32, 3);
        struct simulator nearest, painter, scanline;
        simulator_start(&nearest, &rig, LIM_NEAREST_FIRST);
        simulator_start(&painter, &rig, LIM_PAINTER);
        simulator_start(&scanline, &rig, LIM_SCANLINE);
        for (unsigned k = 0; k < CAMERAS; k++) {
            const struct lim_camera camera = camera_inside(&rig);
            texture_rig_draw(&nearest, &camera);
            texture_rig_draw(&painter, &camera);
            texture_rig_draw(&scanline, &camera);
            assert_memory_equal(nearest.pixels, painter.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
            assert_memory_equal(nearest.pixels, scanline.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
        }
        simulator_free(&nearest);
        simulator_free(&painter);
        simulator_free(&scanline);
        rig_free(&rig);
    }
}

/* Hostile mappings and cameras: nothing to compare, but sanitizers watch, and orders must still agree. */
static void extremes_are_painted_alike(void **state)
{
    (void)state;
    static const double repeats[] = {1e-6, 1e-3, 1000, 16000};
    static const uint16_t sides_px[][2] = {{W_PX, H_PX}, {W_PX, 2}, {2, H_PX}};
    for (size_t r = 0; r < 6 * sizeof repeats / sizeof *repeats; r++) {
        struct rig rig = rig_make(r % 2 ? &core_fast : &core_exact, r & 4 ? 1 : 128, repeats[r / 6]);
        rig.w_px = sides_px[r % 3][0];
        rig.h_px = sides_px[r % 3][1];
        const size_t picture_b = (size_t)rig.w_px * rig.h_px * sizeof(uint16_t);
        struct simulator nearest, painter, scanline;
        simulator_start(&nearest, &rig, LIM_NEAREST_FIRST);
        simulator_start(&painter, &rig, LIM_PAINTER);
        simulator_start(&scanline, &rig, LIM_SCANLINE);
        for (unsigned k = 0; k < CAMERAS * 4; k++) {
            struct lim_camera camera = camera_inside(&rig);
            camera.tan_x_q28 = random_tan_q28(&rig.random);
            camera.tan_y_q28 = random_tan_q28(&rig.random);
            camera.yaw = random_angle(&rig.random);
            camera.pitch = random_angle(&rig.random);
            if (k % 3 == 0) camera.eye_q8[k % 9 / 3] = (int32_t)random_in(&rig.random, -(1 << 28) + 1, (1 << 28) - 1);
            if (k % 3 == 1) camera.eye_q8[k % 9 / 3] = rig.scene.scene.vertices[0].x * 256 + (int32_t)(k % 5) - 2;
            texture_rig_draw(&nearest, &camera);
            texture_rig_draw(&painter, &camera);
            texture_rig_draw(&scanline, &camera);
            assert_memory_equal(nearest.pixels, painter.pixels, picture_b);
            assert_memory_equal(nearest.pixels, scanline.pixels, picture_b);
        }
        simulator_free(&nearest);
        simulator_free(&painter);
        simulator_free(&scanline);
        rig_free(&rig);
    }
}

/* Compiling ---------------------------------------------------------------------------------------- */

static const double SQUARE[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
static const double NEXT[4][3] = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
static const double UNIT[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};

/* Polygons that are left of two squares side by side. */
static size_t merged_count(const double next_uvs[4][2], uint32_t next_picture)
{
    struct random random = {5};
    struct model model = {0};
    struct mesh mesh;
    struct error err;
    texture_rig_picture(&model, 16, 16, &random);
    texture_rig_picture(&model, 16, 16, &random);
    texture_rig_face(&model, 1, 4, SQUARE, UNIT);
    texture_rig_face(&model, next_picture, 4, NEXT, next_uvs);
    assert_true(mesh_clean(&model, &mesh, &err) && mesh_merge(&mesh, &err));
    const size_t count = mesh.polygon_count;
    mesh_free(&mesh);
    model_free(&model);
    return count;
}

static void neighbours_merge_where_their_texture_goes_on(void **state)
{
    (void)state;
    static const double further[4][2] = {{1, 1}, {2, 1}, {2, 0}, {1, 0}},
                        mirrored[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}},
                        shifted[4][2] = {{0.1, 1}, {1.1, 1}, {1.1, 0}, {0.1, 0}};
    assert_int_equal(merged_count(further, 1), 1);
    assert_int_equal(merged_count(UNIT, 1), 1); /* it repeats */
    assert_int_equal(merged_count(mirrored, 1), 2);
    assert_int_equal(merged_count(shifted, 1), 2);
    assert_int_equal(merged_count(further, 2), 2);
    assert_int_equal(merged_count(further, 0), 2);
}

static struct mesh cleaned(const double uvs[4][2])
{
    struct random random = {5};
    struct model model = {0};
    struct mesh mesh;
    struct error err;
    texture_rig_face(&model, texture_rig_picture(&model, 16, 16, &random), 4, SQUARE, uvs);
    if (!mesh_clean(&model, &mesh, &err)) fail_msg("%s", err.text);
    model_free(&model);
    return mesh;
}

static void a_bent_texture_is_triangulated(void **state)
{
    (void)state;
    static const double bent[4][2] = {{0, 1}, {1, 1}, {0.7, 0}, {0, 0}};
    struct mesh mesh = cleaned(bent);
    assert_int_equal(mesh.counts.bent, 1);
    assert_int_equal(mesh.polygon_count, 2);
    for (size_t i = 0; i < 2; i++)
        for (uint32_t k = 0; k < 3; k++) {
            const double *at = mesh.points[mesh.corners[mesh.polygons[i].first + k]];
            double uv[2];
            mapping_at(&mesh.mappings[mesh.polygons[i].mapping], at, uv);
            assert_true(fabs(uv[0] - at[0] * (at[1] > 0.5 ? 0.7 : 1)) < 1e-9 && fabs(uv[1] - (1 - at[1])) < 1e-9);
        }
    mesh_free(&mesh);
}

static void senseless_coordinates_leave_a_flat_face(void **state)
{
    (void)state;
    const double not_a_number[4][2] = {{0, 1}, {1, NAN}, {1, 0}, {0, 0}};
    const double endless[4][2] = {{0, 1}, {INFINITY, 1}, {1, 0}, {0, 0}};
    const double huge[4][2] = {{0, 1}, {1e9, 1}, {1e9, 0}, {0, 0}};
    const double(*all[])[2] = {not_a_number, endless, huge};
    const enum unmapped why[] = {UNMAPPED_MISSING, UNMAPPED_INFINITE, UNMAPPED_FAR};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct mesh mesh = cleaned(all[i]);
        for (enum unmapped kind = 0; kind < UNMAPPED_KINDS; kind++)
            assert_int_equal(mesh.counts.unmapped[kind], kind == why[i]);
        assert_int_equal(mesh.polygon_count, 1);
        assert_int_equal(mesh.polygons[0].mapping, 0);
        mesh_free(&mesh);
    }
}

static void textures_too_large_together_are_made_smaller(void **state)
{
    (void)state;
    struct random random = {9};
    struct model model = {0};
    struct mesh mesh;
    struct error err;
    texture_rig_face(&model, texture_rig_picture(&model, 1024, 1024, &random), 4, SQUARE, UNIT);
    texture_rig_face(&model, texture_rig_picture(&model, 16, 16, &random), 4, NEXT, UNIT);
    if (!mesh_clean(&model, &mesh, &err)) fail_msg("%s", err.text);
    assert_int_equal(mesh.textures[0].w_bits, 9);
    assert_int_equal(mesh.textures[1].w_bits, 4);
    assert_int_equal(mesh.note_count, 1);
    assert_non_null(strstr(mesh.notes[0].text, "picture 1: 1024x1024 pixels, resized to 512x512"));
    mesh_free(&mesh);
    model_free(&model);
}

static void sides_go_to_the_nearest_power_of_two(void **state)
{
    (void)state;
    static const unsigned sides[][2] = {{1, 0},   {2, 1},   {3, 2},   {90, 6},   {91, 7},
                                        {128, 7}, {181, 7}, {182, 8}, {1024, 10}};
    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++)
        assert_int_equal(texture_side_bits(sides[i][0], 10), sides[i][1]);
    assert_int_equal(texture_side_bits(1024, 8), 8);
}

/* Lit faces of one picture share its texels and have palettes of their own. */
static void light_takes_palettes_not_texels(void **state)
{
    (void)state;
    struct rig rig = {.core = &core_fast, .random = {3}};
    texture_rig_room(&rig.model, texture_rig_picture(&rig.model, 32, 32, &rig.random), 1);
    light_bake(&rig.model);
    rig.scene = texture_rig_compile(&rig.model, &rig.mesh, rig.core);
    const struct lim_scene *scene = &rig.scene.scene;
    assert_true(scene->texture_count >= 4);
    assert_int_equal(scene->texel_blocks * LIM_TEXEL_BLOCK, texture_texels(5, 5));
    for (size_t i = 1; i < scene->texture_count; i++) {
        assert_int_equal(scene->textures[i].texels, scene->textures[0].texels);
        assert_true(scene->textures[i].palette > scene->textures[i - 1].palette);
    }
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(set_up_agrees_with_rays_in_double_precision),
        cmocka_unit_test(lines_and_columns_agree_with_rays_in_double_precision),
        cmocka_unit_test(levels_of_detail_are_those_that_fit),
        cmocka_unit_test(both_orders_paint_the_same),
        cmocka_unit_test(extremes_are_painted_alike),
        cmocka_unit_test(neighbours_merge_where_their_texture_goes_on),
        cmocka_unit_test(a_bent_texture_is_triangulated),
        cmocka_unit_test(senseless_coordinates_leave_a_flat_face),
        cmocka_unit_test(textures_too_large_together_are_made_smaller),
        cmocka_unit_test(sides_go_to_the_nearest_power_of_two),
        cmocka_unit_test(light_takes_palettes_not_texels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
