/* SPDX-License-Identifier: MIT
 *
 * Textures with holes: what each pixel shows, against rays in double precision; all orders paint the same, also behind
 * glass and with too little memory; antialiased, no pixel shows more of them than its samples do; smaller sizes keep
 * their share of holes. */
#include "core/core.h"
#include "model/coverage.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/random_camera.h"
#include "rigs/texture_rig.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 80, CAMERAS = 40, SCENES = 6, PANELS = 6, SIDE = 4, QUADS = PANELS + 1 };

static const double PI = 3.14159265358979323846;

/* Rectangles: place(s, t) = corner + s across + t down. Those with a mask show a picture of 4x4 texels, once. */
struct quad {
    double corner[3], across[3], down[3];
    uint32_t texels[SIDE * SIDE]; /* 0xRRGGBB or PICTURE_CLEAR */
    bool is_masked;
};

struct rig {
    struct model model;
    struct mesh mesh;
    struct compiled scene;
    const struct core *core;
    struct random random;
    struct quad quads[QUADS];
};

/* One that RGB565 has. */
static uint32_t random_colour(struct random *random)
{
    const uint32_t r = (uint32_t)random_u64(random) & 31, g = (uint32_t)random_u64(random) & 63,
                   b = (uint32_t)random_u64(random) & 31;
    return (r << 3 | r >> 2) << 16 | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2);
}

static void add_quad(struct rig *rig, struct quad *quad, uint8_t transparency)
{
    double places[4][3], uvs[4][2];
    uint32_t picture = 0;
    if (quad->is_masked) {
        picture = texture_rig_picture(&rig->model, SIDE, SIDE, &rig->random);
        struct picture *made = &rig->model.pictures[picture - 1];
        memcpy(made->pixels, quad->texels, sizeof quad->texels);
        made->is_masked = true;
        transparency = picture_transparency(made);
    }
    for (int k = 0; k < 4; k++) {
        const double s = k == 1 || k == 2, t = k < 2;
        for (int i = 0; i < 3; i++)
            places[k][i] = quad->corner[i] + s * quad->across[i] + t * quad->down[i];
        uvs[k][0] = s;
        uvs[k][1] = t;
    }
    texture_rig_face(&rig->model, picture, 4, (const double(*)[3])places, (const double(*)[2])uvs);
    struct model_face *face = &rig->model.faces[rig->model.face_count - 1];
    face->two_sided = true;
    face->unlit = true;
    face->transparency = transparency;
    if (!picture) face->colour = quad->texels[0];
}

/* Panels upright and level, in front of each other and through one another, and a wall behind. */
static struct rig rig_make(const struct core *core, uint64_t seed, bool with_glass)
{
    struct rig rig = {.core = core, .random = {seed}};
    for (int i = 0; i < QUADS; i++) {
        struct quad *quad = &rig.quads[i];
        const int across = i % 3, down = (i + 1) % 3;
        for (int axis = 0; axis < 3; axis++)
            quad->corner[axis] = random_unit(&rig.random) * 2 - 1.5;
        quad->across[across] = 0.5 + random_unit(&rig.random);
        quad->across[3 - across - down] = i % 2 ? random_unit(&rig.random) - 0.5 : 0;
        quad->down[down] = 0.5 + random_unit(&rig.random);
        for (int k = 0; k < SIDE * SIDE; k++)
            quad->texels[k] = random_u64(&rig.random) % 2 && k ? PICTURE_CLEAR : random_colour(&rig.random);
        quad->is_masked = i > 0 && i % 4 != 3;
        quad->texels[1] = PICTURE_CLEAR;
        add_quad(&rig, quad, with_glass && i == 3 ? 100 : 0);
    }
    rig.scene = texture_rig_compile(&rig.model, &rig.mesh, core);
    return rig;
}

static void rig_free(struct rig *rig)
{
    compiled_free(&rig->scene);
    mesh_free(&rig->mesh);
    model_free(&rig->model);
}

static struct lim_camera camera_near(struct rig *rig)
{
    struct lim_camera camera = {.near_q8 = 256};
    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = (int32_t)(((random_unit(&rig->random) * 4 - 2) - rig->scene.grid.origin_m[i]) *
                                     rig->scene.grid.units_per_m * 256);
    /* Towards the middle, more or less. */
    const double to_middle = atan2(camera.eye_q8[0], camera.eye_q8[2]) / (2 * PI);
    camera.yaw = (uint32_t)(int64_t)ldexp(to_middle + (random_unit(&rig->random) - 0.5) / 4, 32);
    camera.pitch = (uint32_t)random_in(&rig->random, -(INT64_C(1) << 28), INT64_C(1) << 28);
    camera.roll = (uint32_t)random_u64(&rig->random);
    camera.tan_x_q28 = (uint32_t)((0.3 + random_unit(&rig->random)) * (1 << 28));
    camera.tan_y_q28 = camera.tan_x_q28 / W_PX * H_PX;
    return camera;
}

struct drawing {
    enum lim_method method;
    bool is_tight; /* in a tenth of the memory beyond the least */
    bool antialias, delta;
};

static void start(struct simulator *simulator, const struct rig *rig, struct drawing drawing)
{
    const struct simulator_setup setup = {
        .w_px = W_PX, .h_px = H_PX, .method = drawing.method, .panel = SIMULATOR_MEMORY, .core = rig->core};
    struct error err;
    bool ok = simulator_init(simulator, &rig->scene.scene, &setup, &err);
    if (drawing.is_tight) ok = ok && simulator_set_ram(simulator, &(struct simulator_ram){.percent = 10}, &err);
    if (drawing.antialias) ok = ok && simulator_set_antialias(simulator, true, &err);
    if (drawing.delta) ok = ok && simulator_set_delta(simulator, 2000, &err);
    if (!ok) fail_msg("%s", err.text);
}

/* Rays ----------------------------------------------------------------------------------------- */

static double det(const double a[3], const double b[3], const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

struct hit {
    double depth, s, t;
};

/* corner + s across + t down = eye + depth ray. */
static bool hits(const struct quad *quad, const double eye[3], const double ray[3], struct hit *hit)
{
    double to[3], back[3];
    for (int i = 0; i < 3; i++)
        to[i] = eye[i] - quad->corner[i], back[i] = -ray[i];
    const double whole = det(quad->across, quad->down, back);
    if (fabs(whole) < 1e-9) return false;
    *hit = (struct hit){det(quad->across, quad->down, to) / whole, det(to, quad->down, back) / whole,
                        det(quad->across, to, back) / whole};
    return true;
}

enum { UNSURE = 1 << 30 };
static const double OFF = 0.3; /* texels: a quarter is what profile fast promises */

/* How far from an edge, or from a texel's, a ray must be that is to count: a pixel's width and what texels may be off.
 */
static uint32_t shown_along(const struct rig *rig, const double eye[3], const double ray[3], double near, double px)
{
    double behind = near;
    for (int tries = 0; tries < QUADS + 1; tries++) {
        int nearest = -1;
        struct hit first = {INFINITY, 0, 0}, hit;
        double next = INFINITY;
        for (int i = 0; i < QUADS; i++) {
            const struct quad *quad = &rig->quads[i];
            if (!hits(quad, eye, ray, &hit) || hit.depth <= behind) continue;
            const double ways[3] = {hit.s, hit.t, 0};
            for (int c = 0; c < 2; c++) {
                const double *side = c ? quad->down : quad->across;
                const double off = 3 * px * hit.depth / sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
                if (fabs(ways[c]) < off || fabs(ways[c] - 1) < off) return UNSURE;
            }
            if (hit.s < 0 || hit.s > 1 || hit.t < 0 || hit.t > 1) continue;
            if (hit.depth < first.depth)
                next = first.depth, first = hit, nearest = i;
            else
                next = fmin(next, hit.depth);
        }
        if (nearest < 0) return 0;
        if (next - first.depth < 0.02 || first.depth - near < 0.02) return UNSURE;
        const struct quad *quad = &rig->quads[nearest];
        if (!quad->is_masked) return quad->texels[0];
        const double u = first.s * SIDE, v = first.t * SIDE;
        if (fabs(u - floor(u + 0.5)) < OFF || fabs(v - floor(v + 0.5)) < OFF) return UNSURE;
        const uint32_t texel = quad->texels[(int)v * SIDE + (int)u];
        if (!(texel & PICTURE_CLEAR)) return texel;
        behind = first.depth;
    }
    return UNSURE;
}

static uint16_t rgb565_of(uint32_t rgb)
{
    return (uint16_t)((rgb >> 19 & 31) << 11 | (rgb >> 10 & 63) << 5 | (rgb >> 3 & 31));
}

static uint32_t shown_at(const struct rig *rig, const struct lim_camera *camera, int x_px, int y_px)
{
    double right[3], down[3], ahead[3], eye[3], ray[3];
    texture_rig_axes(camera, right, down, ahead);
    const double tan_x = ldexp(camera->tan_x_q28, -28), tan_y = ldexp(camera->tan_y_q28, -28);
    for (int i = 0; i < 3; i++) {
        eye[i] = camera->eye_q8[i] / 256.0 / rig->scene.grid.units_per_m + rig->scene.grid.origin_m[i];
        ray[i] = ahead[i] + tan_x * ((2.0 * x_px + 1) / W_PX - 1) * right[i] +
                 tan_y * ((2.0 * y_px + 1) / H_PX - 1) * down[i];
    }
    return shown_along(rig, eye, ray, camera->near_q8 / 256.0 / rig->scene.grid.units_per_m, 2 * tan_x / W_PX);
}

static void holes_show_what_rays_meet_behind_them(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++) {
        size_t sure = 0, wrong = 0, coloured = 0;
        if (profiles[i]->profile == LIM_PROFILE_DRAFT) continue; /* texels are off by one there */
        for (uint64_t seed = 1; seed <= SCENES; seed++) {
            struct rig rig = rig_make(profiles[i], seed, false);
            struct simulator simulator;
            start(&simulator, &rig, (struct drawing){LIM_NEAREST_FIRST, false, false, false});
            for (unsigned k = 0; k < CAMERAS; k++) {
                const struct lim_camera camera = camera_near(&rig);
                texture_rig_draw(&simulator, &camera);
                for (int y = 0; y < H_PX; y++)
                    for (int x = 0; x < W_PX; x++) {
                        const uint32_t rgb = shown_at(&rig, &camera, x, y);
                        if (rgb == UNSURE) continue;
                        sure++;
                        coloured += rgb != 0;
                        wrong += simulator.pixels[y * W_PX + x] != rgb565_of(rgb);
                    }
            }
            simulator_free(&simulator);
            rig_free(&rig);
        }
        print_message("# %s: %zu of %zu pixels wrong, %zu show something\n", profiles[i]->name, wrong, sure, coloured);
        assert_true(coloured > SCENES * CAMERAS * 100);
        assert_int_equal(wrong, 0);
    }
}

/* Orders ------------------------------------------------------------------------------------------ */

static void all_orders_paint_the_same(void **state)
{
    (void)state;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    for (size_t i = 0; i < count; i++)
        for (uint64_t seed = 1; seed <= 2 * SCENES; seed++) {
            struct rig rig = rig_make(profiles[i], seed, seed % 2);
            struct simulator nearest, painter, scanline, tight, delta;
            assert_int_equal(records_blended(&rig.scene.scene), seed % 2);
            start(&nearest, &rig, (struct drawing){LIM_NEAREST_FIRST, false, false, false});
            start(&painter, &rig, (struct drawing){LIM_PAINTER, false, false, false});
            start(&scanline, &rig, (struct drawing){LIM_SCANLINE, false, false, false});
            start(&tight, &rig, (struct drawing){LIM_NEAREST_FIRST, true, false, false});
            start(&delta, &rig, (struct drawing){LIM_NEAREST_FIRST, false, false, true});
            for (unsigned k = 0; k < CAMERAS; k++) {
                const struct lim_camera camera = camera_near(&rig);
                texture_rig_draw(&nearest, &camera);
                texture_rig_draw(&painter, &camera);
                texture_rig_draw(&scanline, &camera);
                texture_rig_draw(&tight, &camera);
                texture_rig_draw(&delta, &camera);
                assert_memory_equal(nearest.pixels, delta.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
                assert_memory_equal(nearest.pixels, painter.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
                assert_memory_equal(nearest.pixels, scanline.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
                assert_memory_equal(nearest.pixels, tight.pixels, W_PX * H_PX * sizeof nearest.pixels[0]);
            }
            simulator_free(&nearest);
            simulator_free(&painter);
            simulator_free(&scanline);
            simulator_free(&tight);
            simulator_free(&delta);
            rig_free(&rig);
        }
}

/* A pixel that no edge crosses is the same: most are. */
static void antialiased_insides_are_what_they_were(void **state)
{
    (void)state;
    size_t same = 0, all = 0;
    for (uint64_t seed = 1; seed <= SCENES; seed++) {
        struct rig rig = rig_make(&core_fast, seed, false);
        struct simulator plain, smooth, scanline;
        start(&plain, &rig, (struct drawing){LIM_NEAREST_FIRST, false, false, false});
        start(&smooth, &rig, (struct drawing){LIM_NEAREST_FIRST, false, true, false});
        start(&scanline, &rig, (struct drawing){LIM_SCANLINE, false, true, false});
        for (unsigned k = 0; k < CAMERAS; k++) {
            const struct lim_camera camera = camera_near(&rig);
            texture_rig_draw(&plain, &camera);
            texture_rig_draw(&smooth, &camera);
            texture_rig_draw(&scanline, &camera);
            assert_memory_equal(smooth.pixels, scanline.pixels, W_PX * H_PX * sizeof plain.pixels[0]);
            for (int p = 0; p < W_PX * H_PX; p++)
                same += plain.pixels[p] == smooth.pixels[p], all++;
        }
        simulator_free(&plain);
        simulator_free(&smooth);
        simulator_free(&scanline);
        rig_free(&rig);
    }
    print_message("# %.1f %% of the pixels are the same\n", 100.0 * (double)same / (double)all);
    assert_true((double)same > 0.9 * (double)all && same < all);
}

/* Levels ------------------------------------------------------------------------------------------ */

static struct texture bars_made(uint32_t w_px, uint32_t h_px, unsigned every, unsigned thick, uint32_t clear)
{
    struct random random = {3};
    struct model model = {0};
    struct texture texture;
    struct picture *picture = &model.pictures[0];
    texture_rig_picture(&model, w_px, h_px, &random);
    picture = &model.pictures[0];
    picture->is_masked = true;
    for (uint32_t y = 0; y < h_px; y++)
        for (uint32_t x = 0; x < w_px; x++)
            picture->pixels[y * w_px + x] = x % every < thick ? 0xF80000 : PICTURE_CLEAR | clear;
    assert_true(texture_make(picture, 10, &texture));
    model_free(&model);
    return texture;
}

/* As libgd's palettes have it. */
static bool is_nearly_red(uint32_t rgb)
{
    return rgb >> 16 >= 0xF0 && (rgb >> 8 & 0xFF) < 0x08 && (rgb & 0xFF) < 0x08;
}

static void every_level_keeps_the_share_of_holes_and_no_colour_of_theirs(void **state)
{
    (void)state;
    static const unsigned bars[][2] = {{8, 1}, {8, 2}, {8, 7}, {3, 1}, {64, 5}};
    for (size_t i = 0; i < sizeof bars / sizeof *bars; i++) {
        struct texture texture = bars_made(64, 128, bars[i][0], bars[i][1], 0x00FF00);
        const uint8_t *level = texture.texels;
        double opaque = 0;
        assert_true(texture.is_masked && texture.levels == 5 && texture.w_bits == 7 && texture.transposed);
        for (unsigned x = 0; x < 64; x++)
            opaque += (x % bars[i][0] < bars[i][1]) / 64.0;
        for (unsigned k = 0; k < texture.levels; k++) {
            const size_t count = (size_t)8192 >> 2 * k;
            size_t painted = 0;
            for (size_t t = 0; t < count; t++)
                painted += level[t] != 0;
            assert_true(fabs((double)painted - opaque * (double)count) <= 0.5);
            level += count;
        }
        for (uint32_t c = 0; c < texture.colours; c++)
            assert_true(is_nearly_red(texture.palette[c]));
        assert_true(is_nearly_red(texture.mean));
        texture_free(&texture);
    }
}

static void what_is_resized_keeps_it_too(void **state)
{
    (void)state;
    struct texture texture = bars_made(60, 50, 6, 2, 0xFFFFFF); /* to 64x64 */
    size_t painted = 0;
    for (size_t t = 0; t < 4096; t++)
        painted += texture.texels[t] != 0;
    assert_int_equal(painted, 1365);
    for (uint32_t c = 0; c < texture.colours; c++)
        assert_true(is_nearly_red(texture.palette[c])); /* white shines through nowhere */
    texture_free(&texture);
}

/* Half of what is alike all over, as evenly as can be: each 2x2 square has two. */
static void ties_are_dithered(void **state)
{
    (void)state;
    double opacity[16 * 16];
    for (int i = 0; i < 256; i++)
        opacity[i] = 0.5;
    assert_true(coverage_keep(&(struct coverage){opacity, 16, 16, 16}, 0.5));
    for (int y = 0; y < 16; y += 2)
        for (int x = 0; x < 16; x += 2)
            assert_true(opacity[y * 16 + x] + opacity[y * 16 + x + 1] + opacity[y * 16 + x + 16] +
                            opacity[y * 16 + x + 17] ==
                        2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(holes_show_what_rays_meet_behind_them),
        cmocka_unit_test(all_orders_paint_the_same),
        cmocka_unit_test(antialiased_insides_are_what_they_were),
        cmocka_unit_test(every_level_keeps_the_share_of_holes_and_no_colour_of_theirs),
        cmocka_unit_test(what_is_resized_keeps_it_too),
        cmocka_unit_test(ties_are_dithered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
