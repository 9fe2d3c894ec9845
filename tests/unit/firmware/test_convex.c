/* SPDX-License-Identifier: MIT
 *
 * Convex solids: recognised, and drawn by their own method exactly as nearest first draws them. */
#include "compiler/compile_mesh.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/set_rig.h"
#include "rigs/unpainted.h"
#include "scene/convexity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SOLIDS = 32, FRAMES = 16, FRAMES_LEAST = 4, W_PX = 120, H_PX = 96 };

/* A target that counts how often each pixel is done. */
struct canvas {
    uint16_t line[W_PX + 1], pixels[H_PX][W_PX];
    uint8_t done[H_PX][W_PX];
    uint16_t unpainted; /* of this colour nothing is */
};

static uint16_t *line_of(struct canvas *canvas)
{
    return (uint16_t *)(((uintptr_t)canvas->line + 3) & ~(uintptr_t)3);
}

static void *canvas_lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;
    (void)y_px;
    wipe_pixels(line_of(canvas), W_PX, canvas->unpainted);
    return line_of(canvas);
}

static int canvas_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;
    const uint16_t *line = line_of(canvas);
    for (unsigned x = x_px; x < (unsigned)x_px + n_px; x++) {
        canvas->pixels[y_px][x] = line[x];
        canvas->done[y_px][x]++;
    }
    return 0;
}

/* What one frame took; its pixels are in the canvas. */
static struct lim_stats draw(struct canvas *canvas, const struct core *core, const struct lim_scene *scene,
                             const struct lim_camera *camera, enum lim_method method)
{
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = method,
                                      .ctx = canvas,
                                      .lend = canvas_lend,
                                      .done = canvas_done};
    const size_t mem_b = core->mem_b(scene, &target);
    void *lim = calloc(1, core->lim_b), *mem = malloc(mem_b);
    memset(canvas, 0, sizeof *canvas);
    canvas->unpainted = unused_colour(scene);
    assert_int_equal(core->init(lim, scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(core->frame(lim, camera), LIM_OK);
    const struct lim_stats stats = *core->stats(lim);
    free(lim);
    free(mem);
    for (int y = 0; y < H_PX; y++)
        for (int x = 0; x < W_PX; x++)
            assert_int_equal(canvas->done[y][x], 1);
    const uint16_t *pixels = &canvas->pixels[0][0];
    assert_int_equal(count_pixels(pixels, W_PX * H_PX, canvas->unpainted), 0);
    if (method == LIM_NEAREST_FIRST)
        assert_int_equal(count_pixels(pixels, W_PX * H_PX, scene->background), stats.pixels_background);
    return stats;
}

static struct compiled compile_with(const struct mesh *mesh, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .core = core};
    struct compiled scene;
    struct error err;
    if (!compile_mesh(mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    scene.scene.background = unused_colour(&scene.scene); /* its pixels are counted */
    return scene;
}

/* On the finest grid that holds it, as a model would be, or on a coarse one. */
enum { FINEST = 32000, COARSE = 200 };

static struct compiled compile_solid(struct random *random, unsigned kind, double units_per_m, const struct core *core)
{
    struct mesh mesh = mesh_rig(units_per_m);
    convex_rig_add(&mesh, random, kind);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        mesh.polygons[i].colour = (uint32_t)(random_u64(random) & 0xFFFFFF);
    struct compiled scene = compile_with(&mesh, core);
    mesh_rig_free(&mesh);
    return scene;
}

/* One in three with a near plane that may cut the solid. */
static bool random_camera(struct random *random, const struct compiled *scene, struct lim_camera *camera)
{
    struct viewpoint viewpoint = convex_rig_viewpoint(random);
    const struct camera_path path = {"random", &viewpoint, 1};
    const double near_m = random_in(random, 0, 2) ? 0.02 : 0.5 + random_unit(random);
    struct lens lens;
    struct error err;
    assert_true(lens_init(&lens, 20 + 100 * random_unit(random), near_m, W_PX, H_PX, &err));
    if (!camera_path_to_camera(&path, 0, &lens, &scene->grid, camera, &err)) return false;
    camera->roll = random_in(random, 0, 1) ? (uint32_t)random_u64(random) : 0;
    return true;
}

/* Moves every vertex, farther than any rounding would: edges of several corners bend, and faces overlap their
 * neighbours. The tree's order stands, whatever the vertices do. */
static void bend(struct compiled *scene, struct random *random)
{
    enum { BENT_UNITS = 6 };
    struct lim_vertex *vertices = (struct lim_vertex *)(uintptr_t)scene->scene.vertices;
    struct lim_box *root = (struct lim_box *)(uintptr_t)scene->scene.boxes;
    for (int i = 0; i < 3; i++)
        root->half[i] = (uint16_t)(root->half[i] + BENT_UNITS);
    for (size_t i = 0; i < scene->scene.vertex_count; i++) {
        vertices[i].x = (int16_t)(vertices[i].x + random_in(random, -BENT_UNITS, BENT_UNITS));
        vertices[i].y = (int16_t)(vertices[i].y + random_in(random, -BENT_UNITS, BENT_UNITS));
        vertices[i].z = (int16_t)(vertices[i].z + random_in(random, -BENT_UNITS, BENT_UNITS));
    }
}

/* What the random frames were worth. */
struct totals {
    uint32_t pixels, twice, clipped, non_monotone, full, empty, crowded;
};

/* Pixels that show a polygon: what nearest first leaves is the background. */
static uint32_t shown(const struct lim_stats *nearest)
{
    return W_PX * H_PX - nearest->pixels_background;
}

/* What the convex method counts, beside what nearest first does: it paints some pixels twice, and a face that is
 * non-monotone or shows nothing but such pixels counts once. */
static void assert_counts(const struct lim_stats *stats, const struct lim_stats *nearest)
{
    assert_true(nearest->pixels_painted >= shown(nearest));
    assert_true(stats->pixels_painted >= shown(nearest));
    assert_true(stats->pixels_background <= nearest->pixels_background);
    assert_true(stats->pixels_painted + stats->pixels_background >= W_PX * H_PX);
    assert_true(stats->polygons_seen <= stats->polygons);
    if (nearest->non_monotone || nearest->bands) return;
    assert_true(stats->polygons_seen >= nearest->polygons_seen);
    if (stats->pixels_painted > shown(nearest)) return;
    assert_int_equal(stats->pixels_background, nearest->pixels_background);
    assert_int_equal(stats->polygons_seen, nearest->polygons_seen);
}

static int frames_a_solid(void)
{
    return effort(FRAMES) < FRAMES_LEAST ? FRAMES_LEAST : effort(FRAMES);
}

/* `room`: for so many faces on a line there is memory. */
static void assert_same_frames(const struct compiled *scene, const struct core *core, struct random *random,
                               unsigned room, struct totals *totals)
{
    struct lim_scene solid = scene->scene;
    static struct canvas nearest, convex;
    solid.limits.active = (uint16_t)room;
    for (int f = 0; f < frames_a_solid(); f++) {
        struct lim_camera camera;
        if (!random_camera(random, scene, &camera)) continue;
        const struct lim_stats expected = draw(&nearest, core, &scene->scene, &camera, LIM_NEAREST_FIRST);
        const struct lim_stats stats = draw(&convex, core, &solid, &camera, LIM_CONVEX);
        assert_memory_equal(nearest.pixels, convex.pixels, sizeof nearest.pixels);
        if (!stats.bands) assert_counts(&stats, &expected);
        totals->pixels += shown(&expected);
        totals->twice += stats.pixels_painted - shown(&expected);
        totals->clipped += stats.clipped;
        totals->non_monotone += stats.non_monotone;
        totals->full += expected.pixels_background == 0;
        totals->empty += stats.polygons == 0;
        totals->crowded += stats.bands;
    }
}

/* On a coarse grid a sliver may lie within the tolerance of its neighbour's plane, on either side of it:
 * then the solid is none that could be proved convex, and there is nothing to compare. */
static void compare_solids(const struct core *core, uint64_t seed, bool crowded, struct totals *totals)
{
    struct random random = {seed};
    unsigned compared = 0;
    for (unsigned s = 0; s < SOLIDS; s++) {
        const bool coarse = s / CONVEX_RIG_KINDS % 2;
        struct compiled scene = compile_solid(&random, s % CONVEX_RIG_KINDS, coarse ? COARSE : FINEST, core);
        compared += scene.report.convex;
        if (coarse) bend(&scene, &random);
        const unsigned room = crowded ? s % 5 : scene.scene.limits.active;
        if (scene.report.convex) assert_same_frames(&scene, core, &random, room, totals);
        compiled_free(&scene);
    }
    assert_true(compared >= SOLIDS - 2);
}

static void every_solid_is_recognised(void **state)
{
    struct random random = {51};
    (void)state;
    for (unsigned s = 0; s < SOLIDS; s++) {
        struct compiled scene = compile_solid(&random, s % CONVEX_RIG_KINDS, FINEST, NULL);
        assert_true(scene.report.convex && scene_is_convex(&scene.scene));
        assert_int_equal(scene.scene.box_count, 1);
        assert_int_equal(scene.report.splits, 0);
        compiled_free(&scene);
    }
}

static void convex_draws_what_nearest_first_draws_in_every_profile(void **state)
{
    const struct core *found[PROFILES_MAX];
    const size_t count = profiles_or_sub_bits(found);
    uint32_t non_monotone = 0;
    (void)state;
    for (size_t i = 0; i < count; i++) {
        struct totals totals = {0};
        compare_solids(found[i], 52, false, &totals);
        printf("# %s: %u pixels, %u more painted twice, %u polygons clipped, %u non-monotone, %u frames full, %u "
               "empty, %u "
               "pieces without room\n",
               found[i]->name, totals.pixels, totals.twice, totals.clipped, totals.non_monotone, totals.full,
               totals.empty, totals.crowded);
        assert_true(totals.clipped > 0 && totals.full > 0 && totals.empty > 0);
        if (frames_a_solid() == FRAMES) assert_true(totals.clipped > 100 && totals.empty > 10 && totals.twice > 0);
        assert_true(totals.twice < totals.pixels / 100);
        non_monotone += totals.non_monotone;
    }
    assert_true(non_monotone > (frames_a_solid() == FRAMES ? 10u : 0u));
}

static void little_room_or_none_gives_the_same_picture(void **state)
{
    struct totals totals = {0};
    (void)state;
    compare_solids(&core_fast, 53, true, &totals);
    assert_true(totals.crowded > 60 * (uint32_t)frames_a_solid());
}

/* A room seen from inside, a notched block, two boxes, a box whose faces are seen from both sides. */
static void other_scenes_are_not_taken_for_convex(void **state)
{
    const double here_m[3] = {0, 0, 0}, there_m[3] = {3, 0, 0}, into_m[3] = {0.9, 0, 0};
    const double half_m[3] = {1, 1, 1}, mirrored_m[3] = {-1, 1, 1}, small_m[3] = {0.5, 0.5, 0.5};
    struct mesh meshes[4];
    (void)state;
    for (int i = 0; i < 4; i++)
        meshes[i] = mesh_rig(3000.0);
    mesh_rig_box(&meshes[0], here_m, mirrored_m, 0, 0);
    mesh_rig_box(&meshes[1], here_m, half_m, 0, 0);
    mesh_rig_box(&meshes[1], into_m, small_m, 0.3, 0);
    mesh_rig_box(&meshes[2], here_m, half_m, 0, 0);
    mesh_rig_box(&meshes[2], there_m, half_m, 0, 0);
    mesh_rig_box(&meshes[3], here_m, half_m, 0, 0);
    meshes[3].polygons[2].two_sided = true;
    for (int i = 0; i < 4; i++) {
        struct compiled scene = compile_with(&meshes[i], NULL);
        assert_false(scene.report.convex);
        compiled_free(&scene);
        mesh_rig_free(&meshes[i]);
    }
}

/* A box with a plane or a vertex moved by hand, past what rounding explains. */
static void a_vertex_in_front_of_a_plane_is_found(void **state)
{
    const double here_m[3] = {0, 0, 0}, half_m[3] = {1, 1, 1};
    struct mesh mesh = mesh_rig(3000.0);
    (void)state;
    mesh_rig_box(&mesh, here_m, half_m, 0, 0);
    struct compiled scene = compile_with(&mesh, NULL);
    struct lim_vertex *vertices = (struct lim_vertex *)(uintptr_t)scene.scene.vertices;
    assert_true(scene_is_convex(&scene.scene));
    vertices[3].x = (int16_t)(vertices[3].x + (vertices[3].x > 0 ? 1 : -1));
    assert_true(scene_is_convex(&scene.scene)); /* a unit may be rounding and tolerance */
    vertices[3].x = (int16_t)(vertices[3].x + (vertices[3].x > 0 ? 1 : -1));
    assert_false(scene_is_convex(&scene.scene));
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* A leaf has no plane that the eye could be in front of. */
static void a_leaf_is_refused(void **state)
{
    static struct set set;
    struct canvas canvas;
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = LIM_CONVEX,
                                      .ctx = &canvas,
                                      .lend = canvas_lend,
                                      .done = canvas_done};
    (void)state;
    set_init(&set);
    set_add(&set, 1, 3, (const int16_t[][3]){{0, 0, -100}, {50, 0, -100}, {0, 50, -100}});
    assert_int_equal(set.scene.limits.depth, set.scene.node_count);
    const size_t mem_b = core_fast.mem_b(&set.scene, &target);
    void *lim = calloc(1, core_fast.lim_b), *mem = malloc(mem_b);
    assert_int_equal(core_fast.init(lim, &set.scene, &target, mem, mem_b), LIM_ERR_SCENE);
    free(lim);
    free(mem);
}

/* The renderer itself refuses a tree with forks; the simulator any scene that is not convex. */
static void a_forked_tree_is_refused(void **state)
{
    struct random random = {54};
    struct mesh mesh = mesh_rig(3000.0);
    struct canvas canvas;
    (void)state;
    mesh_rig_solids(&mesh, &random, 5);
    struct compiled scene = compile_with(&mesh, NULL);
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = LIM_CONVEX,
                                      .ctx = &canvas,
                                      .lend = canvas_lend,
                                      .done = canvas_done};
    const size_t mem_b = core_fast.mem_b(&scene.scene, &target);
    void *lim = calloc(1, core_fast.lim_b), *mem = malloc(mem_b);
    assert_int_equal(core_fast.init(lim, &scene.scene, &target, mem, mem_b), LIM_ERR_SCENE);
    free(lim);
    free(mem);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_solid_is_recognised),
        cmocka_unit_test(convex_draws_what_nearest_first_draws_in_every_profile),
        cmocka_unit_test(little_room_or_none_gives_the_same_picture),
        cmocka_unit_test(other_scenes_are_not_taken_for_convex),
        cmocka_unit_test(a_vertex_in_front_of_a_plane_is_found),
        cmocka_unit_test(a_leaf_is_refused),
        cmocka_unit_test(a_forked_tree_is_refused),
    };
    return cmocka_run_group_tests_name("convex", tests, NULL, NULL);
}
