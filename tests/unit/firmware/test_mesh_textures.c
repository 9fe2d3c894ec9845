/* SPDX-License-Identifier: MIT
 *
 * Meshes with textures: which texel each pixel shows, and of which level, against rays in doubles; the same picture
 * with any memory, with depth or without; triangles of one texel as those of a colour. */
#include "colour.h"
#include "math/orientation.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "unit/firmware/soup_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 90, H_PX = 70, PIXELS_MAX = 2 * W_PX * H_PX, SIDE_BITS = 4, SIDE = 1 << SIDE_BITS, DEEP_LEVELS = 7 };

static struct soup soup;
static struct lim_uv uvs[SOUP_VERTICES];
static struct lim_texture textures[3];
static uint16_t palettes[512];
static uint8_t texels[SIDE * SIDE + 5472]; /* 64 x 64 and all that is smaller */
static uint16_t before[PIXELS_MAX];

static const enum lim_method orders[] = {LIM_MESH, LIM_MESH_DEPTH};

/* Texture 0 has a colour for each texel, 1 one for each level, 2 is a single texel. */
static void make_textures(void)
{
    size_t at = SIDE * SIDE;

    for (int i = 0; i < 256; i++)
        palettes[i] = lim_memory_colour((uint16_t)(i + 1));
    for (int i = 0; i < SIDE * SIDE; i++)
        texels[i] = (uint8_t)i;
    for (int level = 0; level < DEEP_LEVELS; level++)
        for (int i = 0; i < 1 << (12 - 2 * level); i++)
            texels[at++] = (uint8_t)level;
    textures[0] = (struct lim_texture){.w_bits = SIDE_BITS, .h_bits = SIDE_BITS, .levels = 1, .place_bits = 13};
    textures[1] = (struct lim_texture){
        .texels = SIDE * SIDE / LIM_TEXEL_BLOCK, .w_bits = 6, .h_bits = 6, .levels = DEEP_LEVELS, .place_bits = 13};
    textures[2] = (struct lim_texture){.palette = 77, .levels = 1};
}

/* The least distance of those that a triangle's words can tell from which on a side's texels are off by a quarter of
 * one at most: its length times what it gains, and twice its length as the nearest corner is nearer than the mean; five
 * times its length in any case. */
static lim_index far_code(size_t triangle, uint8_t w_bits)
{
    const lim_index *words = &soup.words[triangle * LIM_TRIANGLE_WORDS];
    double least = 1;

    for (int k = 0; k < 3; k++) {
        const size_t a = words[k], b = words[(k + 1) % 3];
        const struct lim_vertex *from = &soup.vertices[a], *to = &soup.vertices[b];
        const double x = to->x - from->x, y = to->y - from->y, z = to->z - from->z, side = sqrt(x * x + y * y + z * z);
        const double gain = fmax(abs(uvs[a].u - uvs[b].u), abs(uvs[a].v - uvs[b].v)) / 8192 * (1 << w_bits);
        least = fmax(least, (side + 1) * fmax(gain + 2, 5));
    }
    for (int code = 127; code > 0; code--)
        if ((7 - code % 4) * pow(2, 29 - code / 4) >= least) return (lim_index)(code << LIM_TRIANGLE_TEXTURE_BITS);
    return 0;
}

/* Places that differ by `most` at most, in 2^-13 of the width. */
static struct lim_camera make(struct random *random, unsigned kind, lim_index texture, int most)
{
    const int u = (int)random_in(random, -16000, 16000 - most), v = (int)random_in(random, -16000, 16000 - most);
    const bool knows = random_u64(random) & 1;

    soup_random(&soup, random, kind, 3000);
    make_textures();
    for (size_t i = 0; i < soup.scene.vertex_count; i++)
        uvs[i] = (struct lim_uv){(int16_t)(u + random_in(random, 0, most)), (int16_t)(v + random_in(random, 0, most))};
    for (size_t i = 0; i < soup.scene.polygon_count; i++)
        soup.words[i * LIM_TRIANGLE_WORDS + 3] = texture;
    for (size_t i = 0; knows && i < soup.scene.polygon_count; i++)
        soup.words[i * LIM_TRIANGLE_WORDS + 3] |= far_code(i, textures[texture].w_bits);
    *soup.scene.uvs = uvs;
    soup.scene.textures = textures;
    soup.scene.palettes = palettes;
    soup.scene.texels = texels;
    soup.scene.texture_count = 3;
    *soup.scene.deep_from = (lim_index)random_in(random, 0, (int)soup.scene.polygon_count);
    *soup.scene.near_deep_from = (lim_index)random_in(random, 0, (int)*soup.scene.deep_from);
    return soup_camera(random, random_u64(random) & 1 ? 9000 : 2000);
}

static void draw(struct soup_view *view, const struct core *core, enum lim_method method,
                 const struct lim_camera *camera, size_t mem_b)
{
    assert_int_equal(soup_view_init(view, core, &soup, method, W_PX, H_PX, mem_b, 0x5A), LIM_OK);
    assert_int_equal(soup_view_draw(view, camera), LIM_OK);
}

/* Which triangle each pixel shows: the same scene in colours, which are their numbers. */
static void draw_numbers(struct soup_view *view, const struct core *core, enum lim_method method,
                         const struct lim_camera *camera)
{
    lim_index kept[SOUP_TRIANGLES];
    const uint16_t count = soup.scene.texture_count;

    for (size_t i = 0; i < soup.scene.polygon_count; i++) {
        kept[i] = soup.words[i * LIM_TRIANGLE_WORDS + 3];
        soup.words[i * LIM_TRIANGLE_WORDS + 3] = (lim_index)(i + 1);
    }
    soup.scene.texture_count = 0;
    draw(view, core, method, camera, 0);
    soup.scene.texture_count = count;
    for (size_t i = 0; i < soup.scene.polygon_count; i++)
        soup.words[i * LIM_TRIANGLE_WORDS + 3] = kept[i];
}

/* Rays ------------------------------------------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* The place that a triangle has where the ray through a point of the screen, in pixels, meets its plane, in widths. */
static void place_at(const struct lim_camera *camera, size_t triangle, double x_px, double y_px, double uv[2])
{
    const lim_index *words = &soup.words[triangle * LIM_TRIANGLE_WORDS];
    int32_t axes_q30[9];
    double ray[3], p[3][3], n[3], whole[3], way[3];

    lim_orientation_set(axes_q30, camera);
    for (int i = 0; i < 3; i++)
        ray[i] = ldexp(axes_q30[6 + i], -30) +
                 ldexp(axes_q30[i], -30) * ldexp(camera->tan_x_q28, -28) * (2 * x_px / W_PX - 1) +
                 ldexp(axes_q30[3 + i], -30) * ldexp(camera->tan_y_q28, -28) * (2 * y_px / H_PX - 1);
    for (int k = 0; k < 3; k++) {
        const struct lim_vertex *v = &soup.vertices[words[k]];
        const double at[3] = {v->x, v->y, v->z};
        for (int i = 0; i < 3; i++)
            p[k][i] = at[i] - camera->eye_q8[i] / 256.0;
    }
    uv[0] = uv[1] = 0;
    for (int i = 0; i < 3; i++)
        whole[i] = p[1][i] - p[0][i], way[i] = p[2][i] - p[0][i];
    cross(whole, way, n);
    const double z = dot(n, p[0]) / dot(n, ray), size = dot(n, n);
    for (int k = 0; k < 3; k++) {
        double a[3], b[3], part[3];
        for (int i = 0; i < 3; i++)
            a[i] = p[(k + 1) % 3][i] - z * ray[i], b[i] = p[(k + 2) % 3][i] - z * ray[i];
        cross(a, b, part);
        uv[0] += dot(part, n) / size * uvs[words[k]].u / 8192;
        uv[1] += dot(part, n) / size * uvs[words[k]].v / 8192;
    }
}

struct pixel {
    double uv[2], wide[2][2]; /* widths; what a pixel to the right, and one down, adds to u and v */
};

static struct pixel pixel_at(const struct lim_camera *camera, size_t triangle, int x, int y)
{
    struct pixel pixel;
    double right[2], down[2];

    place_at(camera, triangle, x + 0.5, y + 0.5, pixel.uv);
    place_at(camera, triangle, x + 1.0, y + 0.5, right);
    place_at(camera, triangle, x + 0.5, y + 1.0, down);
    for (int c = 0; c < 2; c++) {
        pixel.wide[0][c] = 2 * (right[c] - pixel.uv[c]);
        pixel.wide[1][c] = 2 * (down[c] - pixel.uv[c]);
    }
    return pixel;
}

/* Texels that a pixel is wide, at most. */
static double texels_of(const struct pixel *pixel)
{
    double most = 0;
    for (int c = 0; c < 2; c++)
        most = fmax(most, SIDE * (fabs(pixel->wide[0][c]) + fabs(pixel->wide[1][c])));
    return most;
}

/* By how much the place lies outside of a texel, in texels. */
static double beyond(double place, int texel)
{
    const double apart = place * SIDE - texel - 0.5;
    return fmax(fabs(apart - SIDE * floor(apart / SIDE + 0.5)) - 0.5, 0);
}

struct tally {
    double pixels, wrong, far; /* far: by far more */
};

static double off_texels(const struct core *core)
{
    static const double off[] = {[LIM_PROFILE_DRAFT] = 1,
                                 [LIM_PROFILE_FAST] = 1.0 / 4,
                                 [LIM_PROFILE_FINE] = 1.0 / 16,
                                 [LIM_PROFILE_EXACT] = 1.0 / 64};
    return off[core->profile];
}

/* Where corners are rounded texels move as edges do: a part of a pixel. */
static void compare_texels(const struct core *core, const struct lim_camera *camera, const struct soup_view *shown,
                           const struct soup_view *numbers, struct tally *tally)
{
    const double part_px = core->profile == LIM_PROFILE_DRAFT ? 1.5 : 0.05;

    for (uint16_t y = 0; y < H_PX; y++)
        for (uint16_t x = 0; x < W_PX; x++) {
            const int triangle = soup_view_at(numbers, x, y), texel = soup_view_at(shown, x, y);
            if (triangle < 0) continue;
            assert_in_range(texel, 0, SIDE * SIDE - 1);
            const struct pixel pixel = pixel_at(camera, (size_t)triangle, x, y);
            const double wide = texels_of(&pixel);
            if (!(wide < 1)) continue; /* finer than pixels: any texel does */
            const double off = fmax(beyond(pixel.uv[0], texel % SIDE), beyond(pixel.uv[1], texel / SIDE));
            tally->pixels++;
            tally->wrong += off > off_texels(core) + part_px * wide + 0.01;
            tally->far += off > 2 * off_texels(core) + 4 * part_px * wide + 0.1;
        }
}

enum { FEWEST = 16 }; /* frames: shares of fewer say little, and of some kinds nothing */

static int some_frames(void)
{
    const int frames = effort(16);
    return frames < FEWEST ? FEWEST : frames;
}

/* Frame i of a soup: what it shows, and which triangle that is at each pixel. The caller frees both views. */
static struct lim_camera draw_both(const struct core *core, struct random *random, unsigned kind, lim_index texture,
                                   int i, struct soup_view *shown, struct soup_view *numbers)
{
    const struct lim_camera camera = make(random, kind, texture, i % 2 ? 600 : 16000);
    const enum lim_method method = orders[i / 2 % 2];

    draw(shown, core, method, &camera, 0);
    draw_numbers(numbers, core, method, &camera);
    return camera;
}

static void texels_are_those_that_rays_meet(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    const int frames = some_frames();

    (void)state;
    for (size_t k = 0; k < count; k++)
        for (unsigned kind = 0; kind < SOUP_KINDS; kind++) {
            struct random random = {301 + k};
            struct tally tally = {0};
            for (int i = 0; i < frames; i++) {
                struct soup_view shown, numbers;
                const struct lim_camera camera = draw_both(found[k], &random, kind, 0, i, &shown, &numbers);
                compare_texels(found[k], &camera, &shown, &numbers, &tally);
                /* Two entries' room for gradients, beside its own, is given back with each. */
                assert_true(found[k]->stats(shown.lim)->active_max <= 3 * found[k]->stats(numbers.lim)->active_max);
                soup_view_free(&shown);
                soup_view_free(&numbers);
            }
            assert_true(tally.pixels > 0);
            assert_true(tally.wrong <= (found[k]->profile == LIM_PROFILE_DRAFT ? 1e-3 : 5e-5) * tally.pixels);
            assert_true(tally.far <= 5e-4 * tally.pixels);
        }
}

/* One triangle round the origin, and a camera that looks there from hardly farther than its words say, or from nearer.
 * They say it for profile fast: farther where texels may be off by less. */
static struct lim_camera make_far(struct random *random, const struct core *core)
{
    const double size = 200 + random_unit(random) * 3000, gain = random_unit(random) * 8000;
    int32_t eye_q8[3], origin_q8[3] = {0, 0, 0};
    double eye[3], length = 0;

    soup_init(&soup);
    make_textures();
    for (int k = 0; k < 3; k++) {
        double at[3];
        for (int i = 0; i < 3; i++)
            at[i] = (2 * random_unit(random) - 1) * size;
        soup_vertex(&soup, at[0], at[1], at[2]);
        uvs[k] = (struct lim_uv){(int16_t)(random_unit(random) * gain), (int16_t)(random_unit(random) * gain)};
    }
    soup_triangle(&soup, 0, 1, 2);
    soup_done(&soup, (lim_index)(random_u64(random) & 1));
    const lim_index code = far_code(0, SIDE_BITS);
    assert_true(code > 0);
    soup.words[3] = code;
    *soup.scene.uvs = uvs;
    soup.scene.textures = textures;
    soup.scene.palettes = palettes;
    soup.scene.texels = texels;
    soup.scene.texture_count = 3;
    const unsigned from = code >> LIM_TRIANGLE_TEXTURE_BITS;
    const double whole = (7 - from % 4) * ldexp(1, 29 - (int)(from / 4)) / (4 * off_texels(core)),
                 distance = fmin(fmax(whole * (0.2 + 0.9 * random_unit(random)), 2 * size), 500000);
    for (int i = 0; i < 3; i++) {
        eye[i] = 2 * random_unit(random) - 1;
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++)
        eye_q8[i] = (int32_t)lrint(eye[i] / sqrt(length) * distance * 256);
    const uint32_t tan_q28 = (uint32_t)ldexp(fmax(size / distance, 0.15), 28);
    struct lim_camera camera = {.tan_x_q28 = tan_q28, .tan_y_q28 = tan_q28, .near_q8 = 256};
    lim_look_at(&camera, eye_q8, origin_q8);
    return camera;
}

static void from_as_far_away_as_words_say_texels_are_even(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {351 + k};
        struct tally tally = {0};
        for (int i = 0; i < FEWEST + effort(600); i++) {
            const struct lim_camera camera = make_far(&random, found[k]);
            struct soup_view shown, numbers;
            draw(&shown, found[k], orders[i % 2], &camera, 0);
            draw_numbers(&numbers, found[k], orders[i % 2], &camera);
            compare_texels(found[k], &camera, &shown, &numbers, &tally);
            soup_view_free(&shown);
            soup_view_free(&numbers);
        }
        assert_true(tally.pixels > 0);
        assert_true(tally.wrong <= 5e-5 * tally.pixels);
    }
}

/* Levels ----------------------------------------------------------------------------------------------------------- */

static void compare_levels(const struct lim_camera *camera, const struct soup_view *shown,
                           const struct soup_view *numbers, struct tally *tally)
{
    for (uint16_t y = 0; y < H_PX; y++)
        for (uint16_t x = 0; x < W_PX; x++) {
            const int triangle = soup_view_at(numbers, x, y), level = soup_view_at(shown, x, y);
            if (triangle < 0) continue;
            assert_in_range(level, 0, DEEP_LEVELS - 1);
            const struct pixel p = pixel_at(camera, (size_t)triangle, x, y);
            const double area = 64 * 64 * fabs(p.wide[0][0] * p.wide[1][1] - p.wide[0][1] * p.wide[1][0]);
            const double wanted = fmax(fmin(log2(area) / 2, DEEP_LEVELS - 1), 0);
            if (!(area > 0)) continue;
            tally->pixels++;
            tally->wrong += fabs(wanted - level) > 0.5 + 0.4;
            tally->far += fabs(wanted - level) > 1.5;
        }
}

static void levels_are_as_fine_as_pixels(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    const int frames = some_frames();

    (void)state;
    for (size_t k = 0; k < count; k++)
        for (unsigned kind = 0; kind < SOUP_KINDS; kind++) {
            struct random random = {401 + k};
            struct tally tally = {0};
            if (found[k]->profile == LIM_PROFILE_DRAFT && kind == 5) continue; /* triangles of a pixel have any area */
            for (int i = 0; i < frames; i++) {
                struct soup_view shown, numbers;
                const struct lim_camera camera = draw_both(found[k], &random, kind, 1, i, &shown, &numbers);
                compare_levels(&camera, &shown, &numbers, &tally);
                soup_view_free(&shown);
                soup_view_free(&numbers);
            }
            assert_true(tally.pixels > 0);
            assert_true(tally.wrong <= 0.01 * tally.pixels);
            assert_true(tally.far <= 0.005 * tally.pixels);
        }
}

/* Memory, colours -------------------------------------------------------------------------------------------------- */

static uint64_t parts;

static void try_memory(const struct core *core, struct random *random, enum lim_method method, unsigned kind)
{
    const struct lim_camera camera = make(random, kind, 0, 16000);
    const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = method};
    const size_t least_b = core->mem_min_b(&soup.scene, &target), most_b = core->mem_b(&soup.scene, &target);
    struct soup_view view;

    for (size_t i = 0; i < soup.scene.polygon_count; i++)
        soup.words[i * LIM_TRIANGLE_WORDS + 3] = (lim_index)random_in(random, 0, 2);
    draw(&view, core, method, &camera, 0);
    const size_t picture_b = H_PX * view.stride_px * 2;
    assert_true(picture_b <= sizeof before);
    memcpy(before, view.pixels, picture_b);
    soup_view_free(&view);
    for (size_t mem_b = least_b; mem_b <= most_b; mem_b += 1 + (most_b - least_b) / 11) {
        draw(&view, core, method, &camera, mem_b);
        assert_memory_equal(view.pixels, before, picture_b);
        parts += core->stats(view.lim)->bands;
        assert_int_equal(soup_view_draw(&view, &camera), LIM_OK);
        assert_memory_equal(view.pixels, before, picture_b);
        soup_view_free(&view);
    }
}

static void any_memory_gives_the_same_picture(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);

    (void)state;
    for (size_t k = 0; k < count; k++) {
        struct random random = {501 + k};
        for (int i = 0; i < effort(21); i++)
            try_memory(found[k], &random, orders[i % 2], (unsigned)i % SOUP_KINDS);
    }
    assert_true(parts > 0);
}

static void a_single_texel_is_a_colour(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);

    (void)state;
    for (size_t k = 0; k < count; k++)
        for (unsigned kind = 0; kind < SOUP_KINDS; kind++) {
            struct random random = {601 + k};
            const struct lim_camera camera = make(&random, kind, 2, 16000);
            struct soup_view shown, numbers;
            draw(&shown, found[k], orders[kind % 2], &camera, 0);
            draw_numbers(&numbers, found[k], orders[kind % 2], &camera);
            for (uint16_t y = 0; y < H_PX; y++)
                for (uint16_t x = 0; x < W_PX; x++)
                    assert_int_equal(soup_view_at(&shown, x, y), soup_view_at(&numbers, x, y) < 0 ? -1 : 77);
            soup_view_free(&shown);
            soup_view_free(&numbers);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels_are_those_that_rays_meet),
        cmocka_unit_test(from_as_far_away_as_words_say_texels_are_even),
        cmocka_unit_test(levels_are_as_fine_as_pixels),
        cmocka_unit_test(any_memory_gives_the_same_picture),
        cmocka_unit_test(a_single_texel_is_a_colour),
    };

    return cmocka_run_group_tests_name("mesh_textures", tests, NULL, NULL);
}
