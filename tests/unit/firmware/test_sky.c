/* SPDX-License-Identifier: MIT
 *
 * Skies: which column and which row of the picture a pixel shows, against angles in double precision, for any turn of
 * the head; what is above and below the picture; all orders paint the same. */
#include "core/core.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/random_camera.h"
#include "rigs/texture_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 80, CAMERAS = 60, COLOURS = 0x10000 };
static const double PI = 3.14159265358979323846;

/* A room all of whose walls are sky; a column of its picture is of one colour, or a row is. */
struct rig {
    struct model model;
    struct mesh mesh;
    struct compiled scene;
    const struct core *core;
    struct random random;
    struct sky_look sky;
    unsigned w_px, h_px;
    bool by_rows;
    int shown[COLOURS]; /* by each colour: which column or row; -1: above the picture, or none; -2: below it */
};

enum { ABOVE = -1, BELOW = -2 };

static uint16_t number_of(uint16_t in_memory)
{
    return (uint16_t)(in_memory << 8 | in_memory >> 8);
}

/* Of 128 strips: no two look alike, and no two neighbours are nearly so. */
static uint32_t strip_colour(unsigned strip)
{
    return (strip * 37 % 128 & 15) << 20 | (strip * 37 % 128 >> 4) << 13 | 0x30;
}

static void find_colours(struct rig *rig)
{
    const struct lim_texture *texture = &rig->scene.scene.textures[0];
    const uint8_t *texels = rig->scene.scene.texels + (size_t)texture->texels * LIM_TEXEL_BLOCK;
    const uint16_t *palette = rig->scene.scene.palettes + texture->palette;
    assert_int_equal(1u << texture->w_bits, rig->w_px);
    assert_int_equal(1u << texture->h_bits, rig->h_px);
    assert_int_equal(texture->place_bits, LIM_TEXTURE_SKY);
    for (size_t i = 0; i < COLOURS; i++)
        rig->shown[i] = ABOVE;
    for (unsigned i = 0; i < (rig->by_rows ? rig->h_px : rig->w_px); i++) {
        int *shown = &rig->shown[number_of(palette[texels[rig->by_rows ? i * rig->w_px : i]])];
        assert_int_equal(*shown, ABOVE);
        *shown = (int)i;
    }
    if (rig->by_rows) {
        rig->shown[number_of(palette[1])] = BELOW;
        rig->shown[number_of(palette[0])] = ABOVE;
    }
}

static struct rig rig_make(const struct core *core, unsigned w_px, unsigned h_px, struct sky_look sky, bool by_rows)
{
    struct rig rig = {
        .core = core, .random = {w_px + h_px}, .sky = sky, .w_px = w_px, .h_px = h_px, .by_rows = by_rows};
    texture_rig_room(&rig.model, texture_rig_picture(&rig.model, w_px, h_px, &rig.random), 1);
    struct picture *picture = &rig.model.pictures[0];
    for (unsigned i = 0; i < w_px * h_px; i++)
        picture->pixels[i] = strip_colour(by_rows ? i / w_px : i % w_px);
    picture->sky = sky;
    rig.scene = texture_rig_compile(&rig.model, &rig.mesh, core);
    find_colours(&rig);
    return rig;
}

static void rig_free(struct rig *rig)
{
    compiled_free(&rig->scene);
    mesh_free(&rig->mesh);
    model_free(&rig->model);
}

static struct lim_camera camera_inside(struct rig *rig, double least_tan, double most_tan)
{
    return texture_rig_camera(&rig->random, &rig->scene.grid, 0.5, (double[]){least_tan, most_tan}, W_PX, H_PX);
}

static void start(struct simulator *simulator, const struct rig *rig, enum lim_method method)
{
    const struct simulator_setup setup = {
        .w_px = W_PX, .h_px = H_PX, .method = method, .panel = SIMULATOR_MEMORY, .core = rig->core};
    struct error err;
    if (!simulator_init(simulator, &rig->scene.scene, &setup, &err)) fail_msg("%s", err.text);
}

/* Angles ---------------------------------------------------------------------------------------- */

static void ray_of(const struct lim_camera *camera, int x_px, int y_px, double ray[3])
{
    double right[3], down[3], ahead[3];
    const double x = ldexp(camera->tan_x_q28, -28) * ((2.0 * x_px + 1) / W_PX - 1);
    const double y = ldexp(camera->tan_y_q28, -28) * ((2.0 * y_px + 1) / H_PX - 1);
    texture_rig_axes(camera, right, down, ahead);
    for (int i = 0; i < 3; i++)
        ray[i] = ahead[i] + x * right[i] + y * down[i];
}

struct checking {
    double sum, worst; /* texels */
    size_t pixels, beyond;
};

/* How far a place is from the texel that is shown. */
static double apart(double at, int shown, double round)
{
    double off = at - (shown + 0.5);
    if (round > 0) off -= round * floor(off / round + 0.5);
    return fmax(fabs(off) - 0.5, 0);
}

static void note(struct checking *checking, double off)
{
    checking->pixels++;
    checking->sum += off;
    checking->worst = fmax(checking->worst, off);
}

static void check_pixel(const struct rig *rig, const double ray[3], int shown, struct checking *checking)
{
    const double level = hypot(ray[0], ray[2]), round_px = (double)rig->w_px * rig->sky.times;
    const double row = rig->sky.horizon * rig->h_px - round_px / (2 * PI) * ray[1] / level;
    const double column = atan2(ray[2], ray[0]) / (2 * PI) * round_px;
    if (fabs(ray[1]) > level) return; /* steeper than 45 degrees lines are less straight, and nothing is promised */
    if (!rig->by_rows) {
        if (row > 1 && row < rig->h_px - 1) note(checking, apart(column, shown, rig->w_px));
        return;
    }
    if (shown == ABOVE || shown == BELOW) {
        checking->beyond++;
        note(checking, fmax(shown == ABOVE ? row : rig->h_px - row, 0));
    } else {
        note(checking, apart(row, shown, 0));
    }
}

static struct checking check_frames(struct rig *rig, double least_tan, double most_tan)
{
    struct simulator simulator;
    struct checking checking = {0};
    start(&simulator, rig, LIM_NEAREST_FIRST);
    for (unsigned k = 0; k < CAMERAS; k++) {
        const struct lim_camera camera = camera_inside(rig, least_tan, most_tan);
        texture_rig_draw(&simulator, &camera);
        for (int y = 0; y < H_PX; y++)
            for (int x = 0; x < W_PX; x++) {
                double ray[3];
                ray_of(&camera, x, y, ray);
                check_pixel(rig, ray, rig->shown[simulator.pixels[y * W_PX + x]], &checking);
            }
    }
    simulator_free(&simulator);
    return checking;
}

/* 1024 columns round: as in Doom, and once. */
static const struct shape {
    unsigned w_px, h_px;
    struct sky_look sky;
} SHAPES[] = {{128, 128, {8, 100.0 / 128}}, {128, 64, {8, 0.5}}, {128, 128, {4, 1}}, {128, 128, {1, 0.9}}};

static void pixels_show_what_is_in_their_direction(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < sizeof SHAPES / sizeof *SHAPES; k++)
            for (int by_rows = 0; by_rows < 2; by_rows++) {
                struct rig rig = rig_make(profiles[i], SHAPES[k].w_px, SHAPES[k].h_px, SHAPES[k].sky, by_rows);
                const struct checking checking = check_frames(&rig, 0.1, 0.35); /* of no level but the first */
                print_message("# %s, %ux%u, %u times, %s: mean %.4f texels off, worst %.3f of %zu pixels, %zu beyond\n",
                              profiles[i]->name, rig.w_px, rig.h_px, rig.sky.times, by_rows ? "rows" : "columns",
                              checking.sum / (double)checking.pixels, checking.worst, checking.pixels, checking.beyond);
                assert_true(checking.pixels > CAMERAS * W_PX * H_PX / 20);
                assert_true(checking.sum < 0.05 * (double)checking.pixels);
                assert_true(checking.worst < 1);
                assert_true(!by_rows || checking.beyond > 0);
                rig_free(&rig);
            }
}

/* A line may be shorter than the way from node to node, and a texel wider than the screen. */
static void lenses_may_be_narrow(void **state)
{
    (void)state;
    for (int by_rows = 0; by_rows < 2; by_rows++) {
        struct rig rig = rig_make(&core_fast, 128, 128, (struct sky_look){1, 0.5}, by_rows);
        const struct checking checking = check_frames(&rig, 0.02, 0.06);
        print_message("# narrow lenses, %s: mean %.4f texels off, worst %.3f of %zu pixels\n",
                      by_rows ? "rows" : "columns", checking.sum / (double)checking.pixels, checking.worst,
                      checking.pixels);
        assert_true(checking.pixels > CAMERAS * W_PX * H_PX / 20);
        assert_true(checking.sum < 0.01 * (double)checking.pixels);
        assert_true(checking.worst < (by_rows ? 0.15 : 0.1));
        rig_free(&rig);
    }
}

/* Orders ------------------------------------------------------------------------------------------ */

static void all_orders_paint_the_same(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++) {
        struct rig rig = rig_make(profiles[i], 128, 64, SHAPES[1].sky, i % 2);
        struct simulator nearest, painter, scanline, smooth, tight;
        struct error err;
        start(&nearest, &rig, LIM_NEAREST_FIRST);
        start(&painter, &rig, LIM_PAINTER);
        start(&scanline, &rig, LIM_SCANLINE);
        start(&smooth, &rig, LIM_NEAREST_FIRST);
        start(&tight, &rig, LIM_NEAREST_FIRST);
        assert_true(simulator_set_antialias(&smooth, true, &err)); /* the same sky on either side of each edge */
        assert_true(simulator_set_ram(&tight, &(struct simulator_ram){.percent = 5}, &err));
        for (unsigned k = 0; k < CAMERAS; k++) {
            struct lim_camera camera = camera_inside(&rig, 0.05, 1.5);
            if (k % 4 == 3) {
                camera.tan_x_q28 = random_tan_q28(&rig.random);
                camera.tan_y_q28 = random_tan_q28(&rig.random);
                camera.pitch = k % 8 == 3 ? 0x40000000u : 0xC0000000u; /* straight up, or down */
            }
            texture_rig_draw(&nearest, &camera);
            texture_rig_draw(&painter, &camera);
            texture_rig_draw(&scanline, &camera);
            texture_rig_draw(&tight, &camera);
            assert_memory_equal(nearest.pixels, painter.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
            assert_memory_equal(nearest.pixels, scanline.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
            assert_memory_equal(nearest.pixels, tight.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
            if (k % 4 == 3) continue;
            texture_rig_draw(&smooth, &camera);
            size_t other = 0;
            for (int p = 0; p < W_PX * H_PX; p++)
                other += nearest.pixels[p] != smooth.pixels[p];
            assert_true(other <= 64); /* of sums of samples that are rounded */
        }
        simulator_free(&nearest);
        simulator_free(&painter);
        simulator_free(&scanline);
        simulator_free(&smooth);
        simulator_free(&tight);
        rig_free(&rig);
    }
}

/* Compiling ---------------------------------------------------------------------------------------- */

static void a_sky_is_one_mapping_and_its_ends_are_its_first_and_last_rows(void **state)
{
    (void)state;
    struct random random = {7};
    struct model model = {0};
    struct texture texture;
    texture_rig_picture(&model, 64, 32, &random);
    struct picture *picture = &model.pictures[0];
    picture->sky = (struct sky_look){4, 0.5};
    for (unsigned i = 0; i < 64 * 32; i++)
        picture->pixels[i] = i < 64 ? 0x0000F8 : i < 128 ? 0x0000E8 : i < 64 * 30 ? 0x808080 : 0xF80000;
    assert_true(texture_make(picture, 10, &texture));
    assert_int_equal(texture.palette[0], 0x0000F0);
    assert_int_equal(texture.palette[1], 0xF80000);
    for (size_t i = 0; i < 64 * 32; i++)
        assert_true(texture.texels[i] >= 2 && texture.texels[i] < texture.colours);
    texture_free(&texture);
    picture->h_px = 16;
    picture->w_px = 128;
    assert_true(texture_make(picture, 6, &texture)); /* not made smaller for others' sake */
    assert_int_equal(texture.w_bits, 7);
    texture_free(&texture);
    picture->h_px = 128;
    picture->w_px = 16;
    assert_true(texture_make(picture, 10, &texture)); /* nor laid on its side */
    assert_false(texture.transposed);
    assert_int_equal(texture.h_bits, 4);
    texture_free(&texture);
    model_free(&model);
    struct rig rig = rig_make(&core_fast, 128, 64, SHAPES[1].sky, true);
    assert_int_equal(rig.scene.scene.mapping_count, 1);
    assert_int_equal(rig.scene.scene.texture_count, 1);
    rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_show_what_is_in_their_direction),
        cmocka_unit_test(lenses_may_be_narrow),
        cmocka_unit_test(all_orders_paint_the_same),
        cmocka_unit_test(a_sky_is_one_mapping_and_its_ends_are_its_first_and_last_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
