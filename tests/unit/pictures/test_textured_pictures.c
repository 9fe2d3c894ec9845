/* SPDX-License-Identifier: MIT
 *
 * A textured model as a mesh and in a tree: by other data, a mapping for each plane or a place for each corner, and by
 * other code, so that one picture tells whether the other is right. Each texel has a colour of its own. */
#include "cameras/camera_path.h"
#include "compiler/compile_mesh.h"
#include "compiler/compile_options.h"
#include "model/mesh.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/profiles.h"
#include "rigs/texture_rig.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE_PX = 160, SIDE = 16, RINGS = 16, REPEATED = 4, VIEWS = 10, NO_TEXEL = -1 };

/* A ball with bumps, round which the picture goes four times, and twice from pole to pole. */
static void corner_at(int i, int j, double at[3], double uv[2])
{
    const double pi = acos(-1), a = pi * i / RINGS, b = 2 * pi * j / RINGS, r = 1 + 0.1 * sin(5 * a) * cos(4 * b);
    at[0] = r * sin(a) * cos(b);
    at[1] = r * cos(a);
    at[2] = r * sin(a) * sin(b);
    uv[0] = (double)REPEATED * j / RINGS;
    uv[1] = REPEATED / 2.0 * i / RINGS;
}

static void add_triangle(struct model *model, uint32_t picture, const int corners[3][2])
{
    double at[3][3], uvs[3][2];
    for (int k = 0; k < 3; k++)
        corner_at(corners[k][0], corners[k][1], at[k], uvs[k]);
    texture_rig_face(model, picture, 3, at, uvs);
}

static void make_ball(struct model *model)
{
    struct random random = {1};
    const uint32_t picture = texture_rig_picture(model, SIDE, SIDE, &random);
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        model->pictures[0].pixels[i] = i % SIDE << 20 | i / SIDE << 12;
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < RINGS; j++) {
            if (i < RINGS - 1) add_triangle(model, picture, (const int[3][2]){{i, j}, {i + 1, j + 1}, {i + 1, j}});
            if (i > 0) add_triangle(model, picture, (const int[3][2]){{i, j}, {i, j + 1}, {i + 1, j + 1}});
        }
}

static struct compiled compile(const struct mesh *mesh, const char *method, const struct core *core)
{
    struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .core = core, .w_px = 32, .h_px = 32, .unlit = true};
    struct compiled scene;
    struct error err;
    if (!compile_method_parse(method, &options, &err) || !compile_options_settle(&options, &err) ||
        !compile_mesh(mesh, &options, &scene, &err))
        fail_msg("%s", err.text);
    return scene;
}

static void draw(struct simulator *simulator, const struct compiled *scene, const struct core *core,
                 const struct viewpoint *viewpoint)
{
    const struct simulator_setup setup = {SIDE_PX, SIDE_PX, scene->report.draws, SIMULATOR_MEMORY, core};
    const struct camera_path path = {.name = "view", .frames = (struct viewpoint *)(uintptr_t)viewpoint, .count = 1};
    struct lim_camera camera;
    struct lens lens;
    struct error err;
    if (!lens_for_grid(&lens, 60, 0, &scene->grid, SIDE_PX, SIDE_PX, &err) ||
        !camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err) ||
        !simulator_init(simulator, &scene->scene, &setup, &err) || !simulator_frame(simulator, &camera, &err))
        fail_msg("%s", err.text);
}

/* Of red u and green v. */
static int texel_of(uint16_t rgb565)
{
    const int u = rgb565 >> 11, v = rgb565 >> 5 & 63;
    if (rgb565 & 31 || u % 2 || v % 4 > 1) return NO_TEXEL;
    return v / 4 * SIDE + u / 2;
}

static int around(int a, int b)
{
    const int apart = abs(a - b);
    return apart < SIDE - apart ? apart : SIDE - apart;
}

struct agreement {
    double pixels, levels; /* levels: of pixels that show a coarser level in one picture alone */
    double finest, same, near;
};

static void compare(const struct simulator *mesh, const struct simulator *tree, uint16_t background,
                    struct agreement *agreement)
{
    for (size_t i = 0; i < simulator_pixel_count(mesh); i++) {
        if (mesh->pixels[i] == background || tree->pixels[i] == background) continue;
        const int a = texel_of(mesh->pixels[i]), b = texel_of(tree->pixels[i]);
        agreement->pixels++;
        agreement->levels += (a == NO_TEXEL) != (b == NO_TEXEL);
        if (a == NO_TEXEL || b == NO_TEXEL) continue;
        agreement->finest++;
        agreement->same += a == b;
        agreement->near += around(a % SIDE, b % SIDE) <= 1 && around(a / SIDE, b / SIDE) <= 1;
    }
}

static void compare_views(const struct compiled *as_mesh, const struct compiled *tree, const struct core *core,
                          struct agreement *agreement)
{
    struct random random = {7};
    for (int i = 0; i < VIEWS; i++) {
        const double far_m = 1.5 + random_unit(&random) * 2;
        struct viewpoint viewpoint = {.line = 1};
        struct simulator drawn, right;
        double length = 0;
        for (int k = 0; k < 3; k++) {
            viewpoint.eye_m[k] = random_unit(&random) * 2 - 1;
            length += viewpoint.eye_m[k] * viewpoint.eye_m[k];
        }
        for (int k = 0; k < 3; k++)
            viewpoint.eye_m[k] *= far_m / sqrt(length);
        draw(&right, tree, core, &viewpoint);
        draw(&drawn, as_mesh, core, &viewpoint);
        compare(&drawn, &right, tree->scene.background, agreement);
        simulator_free(&drawn);
        simulator_free(&right);
    }
}

/* Of all pixels that show the finest level, so many show the same texel, by as much as texels may be off; the others
 * lie at the boundaries of texels, but for some where the model hides itself. */
static double least_same(const struct core *core)
{
    return core->profile == LIM_PROFILE_FAST ? 0.92 : 0.98;
}

static void as_a_mesh_a_model_shows_the_texels_that_it_shows_in_a_tree(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_find(found);
    struct model model = {0};
    struct mesh mesh = {0};
    struct error err;
    int compared = 0;

    (void)state;
    make_ball(&model);
    if (!mesh_clean(&model, &mesh, &err)) fail_msg("%s", err.text);
    for (size_t k = 0; k < count; k++) {
        if (found[k]->profile != LIM_PROFILE_FAST && found[k]->profile != LIM_PROFILE_EXACT) continue;
        struct compiled tree = compile(&mesh, "nearest", found[k]),
                        as_mesh = compile(&mesh, compared ? "mesh-depth" : "mesh", found[k]);
        struct agreement agreement = {0};
        compare_views(&as_mesh, &tree, found[k], &agreement);
        assert_true(agreement.finest > 0.5 * agreement.pixels);
        assert_true(agreement.same >= least_same(found[k]) * agreement.finest);
        assert_true(agreement.near >= 0.999 * agreement.finest);
        assert_true(agreement.levels <= 0.04 * agreement.pixels);
        compared++;
        compiled_free(&tree);
        compiled_free(&as_mesh);
    }
    assert_int_equal(compared, 2);
    mesh_free(&mesh);
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_a_mesh_a_model_shows_the_texels_that_it_shows_in_a_tree),
    };

    return cmocka_run_group_tests_name("textured_pictures", tests, NULL, NULL);
}
