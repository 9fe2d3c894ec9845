/* SPDX-License-Identifier: MIT
 *
 * Where a camera sees the vertices of a long scene, from one unit to 2^30 away, against long doubles: on the screen, in
 * every profile, and beside the planes of the view. */
#include "core/core.h"
#include "long.h"
#include "rigs/camera_axes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/random.h"
#include "view/view.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 256, LONG_FRAMES = 6000, W_PX = 240, H_PX = 180 };

/* A scene of one triangle, whose points are what a test puts there. */
struct world {
    struct lim_long_vertex vertices[POINTS];
    struct lim_fraction fractions[POINTS];
    struct lim_node node;
    lim_index words[8];
    struct lim_long all;
    struct lim_scene scene;
};

static void world_make(struct world *world, bool has_fractions)
{
    const lim_index words[] = {LIM_POLYGON_LAST | 3, 1, 0, 1, 2};

    memset(world, 0, sizeof *world);
    memcpy(world->words, words, sizeof words);
    world->node = (struct lim_node){.split = {LIM_PLANE_X, 0}, .front_run = 0, .back_run = LIM_NO_INDEX};
    world->node.front = world->node.back = world->node.box = LIM_NO_INDEX;
    world->all = (struct lim_long){.vertices = world->vertices, .fractions = has_fractions ? world->fractions : NULL};
    world->scene =
        (struct lim_scene){.of_32_bits = {&world->all},
                           .nodes = &world->node,
                           .polygons = world->words,
                           .fractions = has_fractions ? world->fractions : NULL,
                           .vertex_count = POINTS,
                           .node_count = 1,
                           .polygon_words = 5,
                           .polygon_count = 1,
                           .limits = {.depth = 1, .vertices = 3, .retained_cells = 20, .gaps = 20, .active = 20}};
}

/* The camera's axes, and what of a point along each, in the terms of camera.h. */
struct truth {
    long double axes[3][3]; /* right, up, ahead */
    long double tan_x, tan_y;
    int64_t eye_q8[3];
};

static struct truth truth_of(const struct lim_camera *camera)
{
    struct truth truth;

    camera_axes_set(camera, truth.axes);
    truth.tan_x = ldexpl(camera->tan_x_q28, -28);
    truth.tan_y = ldexpl(camera->tan_y_q28, -28);
    for (int i = 0; i < 3; i++)
        truth.eye_q8[i] = (int64_t)camera->origin[i] * 256 + camera->eye_q8[i];
    return truth;
}

/* A point as the view has it: out[2] units ahead, where |out[0]|, |out[1]| <= out[2] is what can be seen. */
static void see(const struct truth *truth, const struct world *world, lim_index vertex, long double out[3])
{
    const struct lim_fraction *rest = &world->fractions[vertex];
    const int64_t rest_q8[3] = {rest->x_q8, rest->y_q8, rest->z_q8};

    for (int axis = 0; axis < 3; axis++) {
        out[axis] = 0;
        for (int i = 0; i < 3; i++) {
            const int64_t at_q8 = (int64_t)world->vertices[vertex].at[i] * 256 + rest_q8[i];
            out[axis] += truth->axes[axis][i] * (long double)(at_q8 - truth->eye_q8[i]) / 256;
        }
    }
    out[0] /= truth->tan_x;
    out[1] /= -truth->tan_y;
}

static struct lim_camera camera_in(struct random *random, double narrowest)
{
    struct lim_camera camera = {.near_q8 = INT32_C(1)
                                           << random_in(random, 0, 22)}; /* up to 2^14 units: 2^29 in view space */
    const int64_t reach = INT64_C(1) << random_in(random, 0, 29);

    for (int i = 0; i < 3; i++) {
        camera.origin[i] = (int32_t)random_in(random, -reach, reach);
        camera.eye_q8[i] = (int32_t)random_in(random, -2000, 2000);
    }
    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_u64(random);
    camera.roll = random_u64(random) % 2 ? (uint32_t)random_u64(random) : 0;
    camera.tan_x_q28 = (uint32_t)(exp2(random_unit(random) * -log2(narrowest)) * narrowest * (1 << 28));
    camera.tan_y_q28 = camera.tan_x_q28 / 4 * 3;
    return camera;
}

/* Puts a vertex some way ahead, within `wide` times what can be seen. false: there the grid has ended. */
static bool put_ahead(struct random *random, const struct truth *truth, struct world *world, lim_index vertex,
                      double wide)
{
    const double away = exp2(30 * random_unit(random));
    const double of_axis[3] = {wide * (2 * random_unit(random) - 1) * (double)truth->tan_x * away,
                               wide * (2 * random_unit(random) - 1) * (double)truth->tan_y * away, away};
    int8_t rest_q8[3] = {0};

    for (int i = 0; i < 3; i++) {
        double at = (double)truth->eye_q8[i] / 256;
        for (int axis = 0; axis < 3; axis++)
            at += of_axis[axis] * (double)truth->axes[axis][i];
        if (fabs(at) > LIM_LONG_END) return false;
        const double whole = floor(at + 0.5);
        world->vertices[vertex].at[i] = (int32_t)whole;
        if (world->all.fractions) rest_q8[i] = (int8_t)floor((at - whole) * 255);
    }
    world->fractions[vertex] = (struct lim_fraction){rest_q8[0], rest_q8[1], rest_q8[2]};
    return true;
}

static void put_all(struct random *random, const struct truth *truth, struct world *world, double wide)
{
    for (lim_index k = 0; k < POINTS; k++) {
        int tries = 0;
        while (tries < 100 && !put_ahead(random, truth, world, k, wide))
            tries++;
        if (tries == 100) world->vertices[k].at[0] = world->vertices[k].at[1] = world->vertices[k].at[2] = 0;
    }
}

/* The screen ---------------------------------------------------------------------------------- */

static void *lend(void *ctx, uint16_t y_px)
{
    (void)y_px;
    return ctx;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

struct off {
    double most_px;
    size_t points, decades[31]; /* of distances */
};

/* All that lies clearly within the guard band and beyond the near plane. */
static void measure_frame(const struct core *core, void *lim, const struct world *world, const struct truth *truth,
                          const struct lim_camera *camera, struct off *off)
{
    const double near = fmax(2 / fmin(1, (double)truth->tan_y), camera->near_q8 / 256.0) * 1.01;

    for (lim_index k = 0; k < POINTS; k++) {
        long double seen[3];
        double at_px[2];
        see(truth, world, k, seen);
        if (seen[2] < near || fabsl(seen[0]) > seen[2] || fabsl(seen[1]) > seen[2]) continue;
        assert_true(core->project(lim, k, at_px));
        off->most_px = fmax(off->most_px, fabs(at_px[0] - (double)((seen[0] / seen[2] + 1) * W_PX / 2 - 0.5L)));
        off->most_px = fmax(off->most_px, fabs(at_px[1] - (double)((seen[1] / seen[2] + 1) * H_PX / 2 - 0.5L)));
        off->points++;
        off->decades[(int)log2((double)seen[2])]++;
    }
}

static struct off measure_profile(const struct core *core, bool has_fractions, double narrowest)
{
    static uint16_t line[W_PX];
    static struct world world;
    const struct lim_target target = {
        .w_px = W_PX, .h_px = H_PX, .format = LIM_RGB565, .ctx = line, .lend = lend, .done = done};
    struct random random = {151};
    struct off off = {0};

    world_make(&world, has_fractions);
    const size_t mem_b = core->mem_b(&world.scene, &target);
    void *lim = malloc(core->lim_b), *mem = malloc(mem_b);
    assert_true(lim && mem);
    assert_int_equal(core->init(lim, &world.scene, &target, mem, mem_b), LIM_OK);
    for (int f = 0; f < effort(LONG_FRAMES) / 8; f++) {
        const struct lim_camera camera = camera_in(&random, narrowest);
        const struct truth truth = truth_of(&camera);
        put_all(&random, &truth, &world, 1);
        assert_int_equal(core->frame(lim, &camera), LIM_OK);
        measure_frame(core, lim, &world, &truth, &camera, &off);
    }
    free(mem);
    free(lim);
    return off;
}

/* Half a sub-pixel of rounding, and what arithmetic adds: 1/64 pixel in all in profile fast, by a lens of 90 degrees;
 * and a unit at 2^22 of them, from where on fractions do not count. */
static double most_off_px(const struct core *core, double narrowest)
{
    const double rounding_px = ldexp(0.5, -core->sub_bits), unit_px = W_PX / narrowest / (1 << 22);

    switch (core->profile) {
    case LIM_PROFILE_FINE:
        return rounding_px + unit_px + 1.0 / 2048;
    case LIM_PROFILE_EXACT:
        return rounding_px + unit_px + 1.0 / 8192;
    default:
        return rounding_px + unit_px + (narrowest < 1 ? 4.0 : 3.0) / 256;
    }
}

static void vertices_of_all_distances_are_where_they_should_be(void **state)
{
    static const double lenses[] = {1, 0.25, 1.0 / 64, 1.0 / 1024};
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    (void)state;
    for (size_t k = 0; k < count; k++)
        for (int round = 0; round < 8; round++) {
            const double narrowest = lenses[round / 2];
            const struct off off = measure_profile(profiles[k], round % 2, narrowest);
            printf("# %s, tangents from %g, fractions: %d: %zu points, at most %.5f px off, %.5f more than rounding\n",
                   profiles[k]->name, narrowest, round % 2, off.points, off.most_px,
                   off.most_px - ldexp(0.5, -profiles[k]->sub_bits));
            assert_true(off.most_px <= most_off_px(profiles[k], narrowest));
            for (int decade = 4; decade < 29; decade++)
                assert_true(off.decades[decade] > (size_t)effort(LONG_FRAMES) / 8);
        }
}

/* The planes of the view ---------------------------------------------------------------------- */

/* What the codes should be: 1 yes, 0 no, -1: too near to tell. */
static int is_beyond(long double a, long double b)
{
    const long double margin = 0.001L * (fabsl(a) + fabsl(b)) + 0.01L;

    return a > b + margin ? 1 : a < b - margin ? 0 : -1;
}

static void assert_code(uint16_t codes, uint16_t code, int expected)
{
    if (expected >= 0) assert_int_equal((codes & code) != 0, expected);
}

static void assert_codes(uint16_t codes, const long double seen[3], long double near)
{
    const int before_near = is_beyond(near, seen[2]);
    const int wide_x = is_beyond(fabsl(seen[0]), 2 * seen[2]), wide_y = is_beyond(fabsl(seen[1]), 2 * seen[2]);

    assert_code(codes, LIM_VIEW_NEAR, before_near);
    assert_code(codes, LIM_VIEW_LEFT, is_beyond(-seen[0], seen[2]));
    assert_code(codes, LIM_VIEW_RIGHT, is_beyond(seen[0], seen[2]));
    assert_code(codes, LIM_VIEW_TOP, is_beyond(-seen[1], seen[2]));
    assert_code(codes, LIM_VIEW_BOTTOM, is_beyond(seen[1], seen[2]));
    if (before_near == 1 || wide_x == 1 || wide_y == 1) assert_true(codes & LIM_VIEW_GUARD);
    if (!before_near && !wide_x && !wide_y) assert_false(codes & LIM_VIEW_GUARD);
}

/* As a frame does. */
static void begin_view(struct lim_view *view, const struct world *world, const struct lim_camera *camera,
                       const struct truth *truth)
{
    assert_true(lim_view_begin(view, &world->scene, camera));
    *view->rows.eye = (struct lim_long_eye){.all = &world->all};
    for (int i = 0; i < 3; i++) {
        view->rows.eye->at[i] = (int32_t)(truth->eye_q8[i] >> 8);
        view->rows.eye->fraction_q8[i] = (uint8_t)truth->eye_q8[i];
    }
}

/* The near plane in use is the one asked for, or one unit away of a lens of 90 degrees: 2^-16 of what rows reach. */
static long double near_in_use(const struct lim_camera *camera)
{
    const long double least = 1.0L / fminl(1, ldexpl(camera->tan_y_q28, -28));

    return fmaxl(camera->near_q8 / 256.0L, least);
}

static void codes_say_on_which_side_of_the_planes_vertices_are(void **state)
{
    static struct world world;
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct random random = {152};
    size_t near = 0, guard = 0, all = 0;
    struct lim_view view;

    (void)state;
    world_make(&world, true);
    lim_view_init(&view, W_PX, H_PX, cache);
    for (int f = 0; f < effort(LONG_FRAMES); f++) {
        const struct lim_camera camera = camera_in(&random, 0.25);
        const struct truth truth = truth_of(&camera);
        put_all(&random, &truth, &world, 3);
        begin_view(&view, &world, &camera, &truth);
        for (lim_index k = 0; k < POINTS; k++) {
            long double seen[3];
            see(&truth, &world, k, seen);
            const uint16_t codes = lim_view_codes(lim_view_vertex(&view, &world.scene, k));
            assert_codes(codes, seen, near_in_use(&camera));
            near += codes & LIM_VIEW_NEAR;
            guard += (codes & LIM_VIEW_GUARD) != 0;
            all++;
        }
    }
    printf("# codes: %zu points, %zu before the near plane, %zu in need of clipping\n", all, near, guard);
    assert_true(near > all / 100 && guard > all / 5);
}

/* View space ---------------------------------------------------------------------------------- */

/* A camera at an end of where an eye may be, or of the grid, or at 0, along each axis. */
static struct lim_camera camera_at_ends(struct random *random, int frame)
{
    struct lim_camera camera = camera_in(random, 1.0 / 40);

    for (int i = 0; i < 3; i++)
        camera.origin[i] = (int32_t)random_in(random, -1, 1) * (frame % 2 ? LIM_LONG_END : LIM_LONG_EYE_END - 16);
    if (frame % 3 == 0) camera.yaw = camera.pitch = 1u << 29;
    return camera;
}

static void put_at_ends(struct random *random, struct world *world)
{
    for (lim_index k = 0; k < POINTS; k++) {
        for (int i = 0; i < 3; i++)
            world->vertices[k].at[i] = (int32_t)random_in(random, -1, 1) * LIM_LONG_END;
        world->fractions[k] = (struct lim_fraction){127, -128, (int8_t)random_in(random, -128, 127)};
    }
}

/* How many of a point's units are one of the scene's: the longest of the rows of x and y has that length. */
static long double scale_of(const struct lim_view *view)
{
    long double most = 0;

    for (int row = 0; row < 2; row++) {
        const lim_row_entry *n_qv = view->rows.row[row].n_qv;
        most = fmaxl(most, sqrtl((long double)n_qv[0] * n_qv[0] + (long double)n_qv[1] * n_qv[1] +
                                 (long double)n_qv[2] * n_qv[2]));
    }
    return most;
}

/* By how many bits less x and y are than z is, of what can be seen. */
static int zoom_bits_of(const struct lim_view *view, int axis)
{
    return LIM_HAS_TELE && axis < 2 ? view->rows.zoom_bits[axis] : 0;
}

/* As a part of the vertex's distance; 0: it is where the eye is. */
static long double view_point_off(const struct lim_view *view, const struct world *world, const struct truth *truth,
                                  lim_index vertex)
{
    const long double zoom_x = ldexpl(truth->tan_x, zoom_bits_of(view, 0));
    const long double zoom = fminl(fminl(1, zoom_x), ldexpl(truth->tan_y, zoom_bits_of(view, 1)));
    const long double scale = scale_of(view), least = fminl(1, truth->tan_y);
    struct lim_view_point point;
    long double seen[3], square = 0, off = 0;

    lim_view_transform_long(view, vertex, &point);
    see(truth, world, vertex, seen);
    for (int i = 0; i < 3; i++) {
        const long double way = world->vertices[vertex].at[i] - (long double)truth->eye_q8[i] / 256;
        square += way * way;
        const long double got = ldexpl(point.qv[i], *point.exponent + zoom_bits_of(view, i)) / scale / zoom;
        off = fmaxl(off, fabsl(got - seen[i]) * least);
    }
    return square > 1000 * 1000 ? off / sqrtl(square) : 0;
}

/* Nothing leaves 32 bits, as the sanitizer would say, and each coordinate is what it should be, by its exponent. */
static void view_space_holds_the_ends_of_the_grid(void **state)
{
    static struct world world;
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct random random = {153};
    struct lim_view view;
    long double most = 0;

    (void)state;
    world_make(&world, true);
    lim_view_init(&view, W_PX, H_PX, cache);
    for (int f = 0; f < effort(LONG_FRAMES); f++) {
        const struct lim_camera camera = camera_at_ends(&random, f);
        const struct truth truth = truth_of(&camera);
        begin_view(&view, &world, &camera, &truth);
        put_at_ends(&random, &world);
        for (lim_index k = 0; k < POINTS; k++)
            most = fmaxl(most, view_point_off(&view, &world, &truth, k));
    }
    printf("# view space: off by at most 2^%.1f of the distance\n", log2((double)most));
    assert_true(most > 0 && most < 1.0L / 16384);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_of_all_distances_are_where_they_should_be),
        cmocka_unit_test(codes_say_on_which_side_of_the_planes_vertices_are),
        cmocka_unit_test(view_space_holds_the_ends_of_the_grid),
    };

    return cmocka_run_group_tests_name("views of long scenes", tests, NULL, NULL);
}
