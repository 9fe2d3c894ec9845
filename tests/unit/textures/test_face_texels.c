/* SPDX-License-Identifier: MIT
 *
 * What a face shows of its picture: the mean against samples in doubles, faces of one colour, and pictures that are
 * cropped to what is shown, in which each face finds the pixels that it had. */
#include "core/core.h"
#include "model/face_mean.h"
#include "readers/flat_texture.h"
#include "readers/picture_crop.h"
#include "rigs/cmocka_ready.h"
#include "rigs/texture_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 64, SAMPLES = 500 };

static uint32_t looked_up(const struct picture *picture, double u, double v)
{
    const double x = floor((u - floor(u)) * picture->w_px), y = floor((v - floor(v)) * picture->h_px);
    return picture->pixels[(size_t)y * picture->w_px + (size_t)x];
}

/* Rays to the right cross the outline an odd number of times. */
static bool is_inside(const double (*uvs)[2], size_t count, double u, double v)
{
    bool inside = false;
    for (size_t i = 0; i < count; i++) {
        const double *a = uvs[i], *b = uvs[(i + 1) % count];
        if ((a[1] > v) != (b[1] > v) && u < a[0] + (b[0] - a[0]) * (v - a[1]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
}

struct sampled {
    double rgb[3], clear, count;
};

/* Of the box round the corners, at places as close as may be. */
static struct sampled sampled_of(const struct picture *picture, const double (*uvs)[2], size_t count)
{
    struct sampled out = {0};
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            least[k] = fmin(least[k], uvs[i][k]), most[k] = fmax(most[k], uvs[i][k]);
    for (int y = 0; y < SAMPLES; y++)
        for (int x = 0; x < SAMPLES; x++) {
            const double u = least[0] + (most[0] - least[0]) * (x + 0.5) / SAMPLES;
            const double v = least[1] + (most[1] - least[1]) * (y + 0.5) / SAMPLES;
            if (!is_inside(uvs, count, u, v)) continue;
            const uint32_t texel = looked_up(picture, u, v);
            out.count++;
            out.clear += (texel & PICTURE_CLEAR) != 0;
            for (int c = 0; c < 3 && !(texel & PICTURE_CLEAR); c++)
                out.rgb[c] += texel >> 8 * c & 0xFF;
        }
    return out;
}

/* Its places in space do not matter to what it shows. */
static void add_face(struct model *model, uint32_t picture, const double (*uvs)[2], size_t count)
{
    double places[8][3] = {{0}};
    for (size_t i = 0; i < count; i++)
        places[i][0] = uvs[i][0], places[i][1] = -uvs[i][1];
    texture_rig_face(model, picture, count, (const double(*)[3])places, uvs);
}

static void punch(struct picture *picture, struct random *random)
{
    picture->is_masked = true;
    for (size_t i = 0; i < (size_t)picture->w_px * picture->h_px; i++)
        if (random_in(random, 0, 2) == 0) picture->pixels[i] |= PICTURE_CLEAR;
}

static void assert_mean(struct model *model, const double (*uvs)[2], size_t count, double bound)
{
    const struct sampled expected = sampled_of(&model->pictures[0], uvs, count);
    struct face_mean mean;
    if (expected.count < 0.05 * SAMPLES * SAMPLES) return; /* a sliver, of which samples tell little */
    add_face(model, 1, uvs, count);
    assert_true(face_mean_of(model, &model->faces[model->face_count - 1], &model->pictures[0], &mean));
    assert_true(fabs(mean.clear_share - expected.clear / expected.count) < 0.01 * bound);
    for (int c = 0; c < 3; c++) {
        const double value = expected.rgb[c] / (expected.count - expected.clear);
        if (fabs((mean.colour >> 8 * c & 0xFF) - value) > bound)
            fail_msg("face %zu: channel %d is %u, not %.2f", model->face_count, c, mean.colour >> 8 * c & 0xFF, value);
    }
}

static void means_are_those_of_samples(void **state)
{
    (void)state;
    static const double concave[6][2] = {{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.6, 0.9}, {0.6, 0.3}, {0.1, 0.3}};
    static const double far[3][2] = {{-3.2, 1.7}, {2.4, -0.3}, {0.9, 4.1}};
    for (int masked = 0; masked < 2; masked++) {
        struct random random = {77};
        struct model model = {0};
        texture_rig_picture(&model, 16, 32, &random);
        if (masked) punch(&model.pictures[0], &random);
        assert_mean(&model, concave, 6, 1.5);
        assert_mean(&model, far, 3, 1.5);
        for (int i = 0; i < 40; i++) {
            double uvs[3][2];
            for (int k = 0; k < 6; k++)
                uvs[k / 2][k % 2] = 3 * random_unit(&random) - 1;
            assert_mean(&model, (const double(*)[2])uvs, 3, 3);
        }
        model_free(&model);
    }
}

/* 65,536 pictures: more texels than anybody counts one by one. Half of them are 0, in stripes of one column. */
static void what_repeats_without_end_has_the_mean_of_all(void **state)
{
    (void)state;
    static const double uvs[4][2] = {{0, 0}, {256, 0}, {256, 256}, {0, 256}};
    struct random random = {5};
    struct model model = {0};
    struct face_mean mean;
    texture_rig_picture(&model, SIDE_PX, SIDE_PX, &random);
    for (size_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        model.pictures[0].pixels[i] = i % 2 ? 200 : 0;
    add_face(&model, 1, uvs, 4);
    assert_true(face_mean_of(&model, &model.faces[0], &model.pictures[0], &mean));
    assert_true(mean.colour >= 99 && mean.colour <= 101);
    assert_true(fabs(mean.error - 100 * 100) < 10);
    model_free(&model);
}

/* The picture is red above its diagonal and blue below; these triangles end at it, their boxes do not. */
static void faces_of_one_colour_are_found_by_what_they_cover(void **state)
{
    (void)state;
    static const double cases[][3][2] = {{{0.125, 0}, {1, 0}, {1, 0.875}},
                                         {{0, 0.125}, {0.875, 1}, {0, 1}},
                                         {{0.2, 0.1}, {0.2, 0.3}, {0.4, 0.1}}, /* across it */
                                         {{0.5, 0.1}, {0.9, 0.1}, {0.7, 0.1}}, /* a line */
                                         {{0.1, 0.5}, {0.9, 0.5}, {0.5, 0.5}}};
    static const uint32_t colours[] = {0xFF0000, 0x0000FF, 0, 0xFF0000, 0};
    struct random random = {5};
    struct model model = {0};
    texture_rig_picture(&model, SIDE_PX, SIDE_PX, &random);
    for (size_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        model.pictures[0].pixels[i] = i % SIDE_PX > i / SIDE_PX ? 0xFF0000 : 0x0000FF;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        add_face(&model, 1, cases[i], 3);
    assert_int_equal(flat_texture_find(&model), 3);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(model.faces[i].picture, !colours[i]);
        if (colours[i]) assert_int_equal(model.faces[i].colour, colours[i]);
    }
    assert_int_equal(model.pictures[0].faces, 2);
    model_free(&model);
}

/* Three quarters of the face are clear. Glass of its own stays what it is. */
static void masked_faces_become_panes(void **state)
{
    (void)state;
    static const double uvs[4][2] = {{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}};
    struct random random = {5};
    struct model model = {0};
    texture_rig_picture(&model, SIDE_PX, SIDE_PX, &random);
    model.pictures[0].is_masked = true;
    for (size_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        model.pictures[0].pixels[i] =
            i % SIDE_PX >= SIDE_PX / 4 && i / SIDE_PX < SIDE_PX / 2 ? PICTURE_CLEAR : 0x406080;
    add_face(&model, 1, uvs, 4);
    add_face(&model, 1, uvs, 4);
    model.faces[0].transparency = picture_transparency(&model.pictures[0]);
    model.faces[1].transparency = 20;
    assert_int_equal(flat_texture_take_means(&model), 2);
    assert_int_equal(model.faces[0].transparency, 191); /* 255 * 3 / 4 */
    assert_int_equal(model.faces[1].transparency, 20);
    assert_int_equal(model.faces[0].colour, 0x406080);
    model_free(&model);
}

static void faces_without_coordinates_keep_their_picture(void **state)
{
    (void)state;
    static const double uvs[3][2] = {{0, 0}, {1, (double)NAN}, {1, 1}};
    struct random random = {5};
    struct model model = {0};
    texture_rig_picture(&model, SIDE_PX, SIDE_PX, &random);
    add_face(&model, 1, uvs, 3);
    assert_int_equal(flat_texture_take_means(&model), 0);
    assert_int_equal(model.faces[0].picture, 1);
    assert_int_equal(picture_crop(&model), 0);
    model_free(&model);
}

/* Crops ---------------------------------------------------------------------------------------- */

static void assert_same_pixels(const struct model *before, const struct model *after, size_t face)
{
    const struct model_face *shown = &before->faces[face];
    struct random random = {face + 1};
    for (int i = 0; i < 2000; i++) {
        double a = random_unit(&random), b = random_unit(&random), was[2], is[2];
        if (a + b > 1) a = 1 - a, b = 1 - b;
        const uint32_t *corners = &before->corners[shown->first];
        for (int k = 0; k < 2; k++) {
            was[k] = (1 - a - b) * before->uvs[corners[0]][k] + a * before->uvs[corners[1]][k] +
                     b * before->uvs[corners[2]][k];
            is[k] =
                (1 - a - b) * after->uvs[corners[0]][k] + a * after->uvs[corners[1]][k] + b * after->uvs[corners[2]][k];
        }
        assert_int_equal(looked_up(&before->pictures[0], was[0], was[1]), looked_up(&after->pictures[0], is[0], is[1]));
    }
}

struct pair {
    struct model before, after;
};

/* The second one is to be cropped. */
static struct pair two_of(const double (*uvs)[3][2], size_t count, uint32_t w_px, uint32_t h_px)
{
    struct pair pair = {0};
    for (int k = 0; k < 2; k++) {
        struct model *model = k ? &pair.after : &pair.before;
        struct random random = {9};
        texture_rig_picture(model, w_px, h_px, &random);
        for (size_t i = 0; i < count; i++)
            add_face(model, 1, uvs[i], 3);
    }
    return pair;
}

static void pair_free(struct pair *pair)
{
    model_free(&pair->before);
    model_free(&pair->after);
}

static void pictures_are_cropped_to_what_is_shown(void **state)
{
    (void)state;
    /* Of 64 pixels: 38.4 to 44.8, and the same five pictures away; with two around it 36 to 47: in 32 to 48. */
    static const double uvs[2][3][2] = {{{0.6, 0.6}, {0.7, 0.6}, {0.6, 0.7}}, {{5.7, -4.4}, {5.7, -4.3}, {5.6, -4.3}}};
    struct pair pair = two_of(uvs, 2, SIDE_PX, SIDE_PX);
    assert_int_equal(picture_crop(&pair.after), 1);
    const struct picture *kept = &pair.after.pictures[0];
    assert_int_equal(kept->w_px, 16);
    assert_int_equal(kept->h_px, 16);
    assert_int_equal(kept->whole_w_px, SIDE_PX);
    for (int y = 0; y < 16; y++)
        assert_memory_equal(&kept->pixels[y * 16], &pair.before.pictures[0].pixels[(32 + y) * SIDE_PX + 32],
                            16 * sizeof *kept->pixels);
    for (size_t i = 0; i < 2; i++)
        assert_same_pixels(&pair.before, &pair.after, i);
    pair_free(&pair);
}

/* A picture of 100x60 becomes a texture of 128x64; a strip along all of its width is kept, and as high as a quarter. */
static void sides_that_are_shown_whole_or_repeat_stay(void **state)
{
    (void)state;
    static const double strip[1][3][2] = {{{0, 0.8}, {1, 0.8}, {0.5, 0.9}}},
                        wide[1][3][2] = {{{0, 0.8}, {1.5, 0.8}, {0.5, 0.9}}};
    for (int k = 0; k < 2; k++) {
        struct pair pair = two_of(k ? wide : strip, 1, 100, 60);
        assert_int_equal(picture_crop(&pair.after), 1);
        assert_int_equal(pair.after.pictures[0].w_px, 100);
        assert_int_equal(pair.after.pictures[0].h_px, 16);
        assert_same_pixels(&pair.before, &pair.after, 0);
        pair_free(&pair);
    }
    struct pair pair = two_of(strip, 1, 100, 60);
    pair.after.pictures[0].sky.times = 1;
    assert_int_equal(picture_crop(&pair.after), 0);
    pair_free(&pair);
}

static void random_faces_find_their_pixels(void **state)
{
    (void)state;
    struct random random = {3};
    size_t cropped = 0;
    for (int i = 0; i < 200; i++) {
        double uvs[2][3][2];
        const double reach = random_unit(&random) * random_unit(&random);
        const uint32_t w_px = (uint32_t)random_in(&random, 1, 150), h_px = (uint32_t)random_in(&random, 1, 150);
        for (int k = 0; k < 12; k++)
            uvs[k / 6][k / 2 % 3][k % 2] =
                0.4 + reach * random_unit(&random) + (double)random_in(&random, 0, 3) * (k < 6 && i % 9 == 0);
        struct pair pair = two_of((const double(*)[3][2])uvs, 2, w_px, h_px);
        cropped += picture_crop(&pair.after);
        for (size_t k = 0; k < 2; k++)
            assert_same_pixels(&pair.before, &pair.after, k);
        pair_free(&pair);
    }
    assert_in_range(cropped, 80, 199);
}

enum { FRAME_PX = 96, FRAMES = 40 };

/* Of blocks of 8 pixels in 16 colours, so that no palette has to leave anything out; seen from 19.2 pixels to 32. */
static struct model room_of_blocks(void)
{
    struct random random = {13};
    struct model model = {0};
    texture_rig_picture(&model, SIDE_PX, SIDE_PX, &random);
    uint32_t *pixels = model.pictures[0].pixels;
    for (size_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        pixels[i] = (uint32_t)((i % SIDE_PX / 8 * 5 + i / SIDE_PX / 8 * 3) % 16) * 0x0F0B07;
    texture_rig_room(&model, 1, 0.2);
    for (size_t i = 0; i < model.point_count; i++)
        model.uvs[i][0] += 0.3 + (double)(i / 4), model.uvs[i][1] += 0.3;
    return model;
}

static void draw(struct simulator *simulator, const struct compiled *scene)
{
    struct error err;
    const struct simulator_setup setup = {.w_px = FRAME_PX, .h_px = FRAME_PX, .core = &core_fast};
    if (!simulator_init(simulator, &scene->scene, &setup, &err)) fail_msg("%s", err.text);
}

/* Where a place lies between two texels, roundings of coordinates decide: a pixel of a thousand. */
static void frames_are_the_same(void **state)
{
    (void)state;
    static const double tans[2] = {0.5, 1.2};
    struct model models[2] = {room_of_blocks(), room_of_blocks()};
    struct mesh meshes[2];
    struct compiled scenes[2];
    struct simulator simulators[2];
    struct random random = {21};
    size_t other = 0;
    assert_int_equal(picture_crop(&models[1]), 1);
    assert_int_equal(models[1].pictures[0].w_px, 32);
    for (int k = 0; k < 2; k++) {
        scenes[k] = texture_rig_compile(&models[k], &meshes[k], &core_fast);
        draw(&simulators[k], &scenes[k]);
    }
    for (int i = 0; i < FRAMES; i++) {
        const struct lim_camera camera = texture_rig_camera(&random, &meshes[0].grid, 0.9, tans, FRAME_PX, FRAME_PX);
        for (int k = 0; k < 2; k++)
            texture_rig_draw(&simulators[k], &camera);
        for (size_t p = 0; p < FRAME_PX * FRAME_PX; p++)
            other += simulators[0].pixels[p] != simulators[1].pixels[p];
    }
    print_message("# %zu of %d pixels differ\n", other, FRAMES * FRAME_PX * FRAME_PX);
    assert_in_range(other, 0, FRAMES * FRAME_PX * FRAME_PX / 1000);
    for (int k = 0; k < 2; k++) {
        simulator_free(&simulators[k]);
        compiled_free(&scenes[k]);
        mesh_free(&meshes[k]);
        model_free(&models[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(means_are_those_of_samples),
        cmocka_unit_test(what_repeats_without_end_has_the_mean_of_all),
        cmocka_unit_test(faces_of_one_colour_are_found_by_what_they_cover),
        cmocka_unit_test(masked_faces_become_panes),
        cmocka_unit_test(faces_without_coordinates_keep_their_picture),
        cmocka_unit_test(pictures_are_cropped_to_what_is_shown),
        cmocka_unit_test(sides_that_are_shown_whole_or_repeat_stay),
        cmocka_unit_test(random_faces_find_their_pixels),
        cmocka_unit_test(frames_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
