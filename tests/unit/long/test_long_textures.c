/* SPDX-License-Identifier: MIT
 *
 * Textures in scenes of many scales: which texel each pixel shows, against rays in double precision that meet the
 * model's own faces; in worlds with things of all sizes, on a ground of 240 km, from near and from far away; and that
 * all orders paint the same. */
#include "compiler/compile_mesh.h"
#include "compiler/coordinates.h"
#include "compiler/faithful.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/random_camera.h"
#include "rigs/texture_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 80, FRAMES = 60, FACES_MOST = 512, HEAPS = 6, HEAP_SOLIDS = 4, PLACES = 8 };

/* What a face shows, as the test has made it: pictures across and down at p are gradient . (p - at_m) + uv. */
struct truth {
    double gradient[2][3], at_m[3], uv[2];
    double corner_m[3], normal[3]; /* of the face's own plane */
};

struct world {
    struct model model;
    struct truth truths[FACES_MOST];
    double side_px; /* of the picture */
    double middles_m[PLACES][3], sizes_m[PLACES];
    int places; /* from near which it is looked at */
};

/* Models ------------------------------------------------------------------------------------------ */

static double any(struct random *random)
{
    return 2 * random_unit(random) - 1;
}

static void add_face(struct world *world, size_t count, const double (*places)[3], const struct truth *shows)
{
    struct truth *truth = &world->truths[world->model.face_count];
    double uvs[4][2], a[3], b[3], length = 0;

    assert_true(world->model.face_count < FACES_MOST);
    *truth = *shows;
    for (size_t k = 0; k < count; k++)
        for (int c = 0; c < 2; c++) {
            uvs[k][c] = truth->uv[c];
            for (int i = 0; i < 3; i++)
                uvs[k][c] += truth->gradient[c][i] * (places[k][i] - truth->at_m[i]);
        }
    for (int i = 0; i < 3; i++)
        a[i] = places[1][i] - places[0][i], b[i] = places[2][i] - places[0][i];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        truth->corner_m[i] = places[0][i];
        truth->normal[i] = a[j] * b[k] - a[k] * b[j];
        length += truth->normal[i] * truth->normal[i];
    }
    for (int i = 0; i < 3; i++)
        truth->normal[i] /= sqrt(length);
    texture_rig_face(&world->model, 1, count, places, (const double(*)[2])uvs);
}

/* Some turn of the picture, sheared, a few of them over `size_m`. */
static struct truth any_truth(struct random *random, const double at_m[3], double size_m)
{
    struct truth out = {.uv = {any(random) * 10, any(random) * 10}};

    for (int c = 0; c < 2; c++)
        for (int i = 0; i < 3; i++)
            out.gradient[c][i] = any(random) / size_m;
    memcpy(out.at_m, at_m, sizeof out.at_m);
    return out;
}

static void add_box(struct world *world, struct random *random, const double low_m[3], const double high_m[3],
                    bool inside)
{
    for (int side = 0; side < 6; side++) {
        const int x = side / 2, y = (x + 1) % 3, z = (x + 2) % 3;
        double places[4][3];
        for (int k = 0; k < 4; k++) {
            const int corner = (side % 2 == 1) != inside ? k : 3 - k;
            const bool right = corner == 1 || corner == 2, up = corner >= 2;
            places[k][x] = side % 2 ? high_m[x] : low_m[x];
            places[k][y] = right ? high_m[y] : low_m[y];
            places[k][z] = up ? high_m[z] : low_m[z];
        }
        const struct truth truth = any_truth(random, low_m, high_m[y] - low_m[y]);
        add_face(world, 4, (const double(*)[3])places, &truth);
    }
}

static void add_tetrahedron(struct world *world, struct random *random, const double middle_m[3], double size_m)
{
    static const double about[4][3] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    static const int sides[4][3] = {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
    double corners[4][3], places[3][3];

    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners[k][i] = middle_m[i] + size_m * (about[k][i] + 0.4 * any(random));
    for (int side = 0; side < 4; side++) {
        for (int k = 0; k < 3; k++)
            memcpy(places[k], corners[sides[side][k]], sizeof places[k]);
        const struct truth truth = any_truth(random, middle_m, size_m);
        add_face(world, 3, (const double(*)[3])places, &truth);
    }
}

static void begin_world(struct world *world, struct random *random, uint32_t side_px)
{
    memset(world, 0, sizeof *world);
    world->side_px = side_px;
    texture_rig_picture(&world->model, side_px, side_px, random);
}

/* A room with three boxes in it. */
static void make_room(struct world *world, struct random *random)
{
    static const double low_m[3] = {-1, -1, -1}, high_m[3] = {1, 1, 1};

    begin_world(world, random, 64);
    add_box(world, random, low_m, high_m, true);
    world->places = 3;
    for (int b = 0; b < world->places; b++) {
        double low[3], high[3];
        for (int i = 0; i < 3; i++) {
            low[i] = world->middles_m[b][i] = 0.6 * any(random);
            high[i] = low[i] + 0.1 + 0.2 * random_unit(random);
        }
        world->sizes_m[b] = 0.15;
        add_box(world, random, low, high, false);
    }
}

/* A room and heaps in it, from 2^-2 of its size down to 2^-most_bits. */
static void make_heaps(struct world *world, struct random *random, int most_bits)
{
    static const double low_m[3] = {-1, -1, -1}, high_m[3] = {1, 1, 1};

    begin_world(world, random, 64);
    add_box(world, random, low_m, high_m, true);
    world->places = HEAPS;
    for (int h = 0; h < HEAPS; h++) {
        double *const middle_m = world->middles_m[h];
        const double size_m = world->sizes_m[h] = ldexp(1, -(3 + (most_bits - 3) * h / (HEAPS - 1)));
        for (int i = 0; i < 3; i++)
            middle_m[i] = (1 - 4 * size_m) * any(random);
        for (int s = 0; s < HEAP_SOLIDS; s++) {
            double low[3], high[3];
            for (int i = 0; i < 3; i++) {
                low[i] = middle_m[i] + size_m * any(random);
                high[i] = low[i] + size_m * (0.3 + random_unit(random));
            }
            if (s % 2)
                add_tetrahedron(world, random, low, size_m);
            else
                add_box(world, random, low, high, false);
        }
    }
}

/* 240 km, 120,000 pictures along each side, boxes of 0.6 m and rocks of a kilometre. The last boxes are far from the
 * middle of the grid. */
static void make_ground(struct world *world, struct random *random)
{
    static const double boxes_m[PLACES][3] = {{0, 0, 0},         {3, 0, -2},           {1, 0, 4},
                                              {-9000, 0, 20000}, {110000, 0, -117000}, {110003, 0, -117001},
                                              {20000, 0, 9000},  {-119990, 0, 119990}};
    static const double ground_m[4][3] = {
        {-120e3, 0, 120e3}, {120e3, 0, 120e3}, {120e3, 0, -120e3}, {-120e3, 0, -120e3}};
    const struct truth repeated = {.gradient = {{0.5, 0, 0}, {0, 0, 0.5}}, .uv = {0.3, 0.1}};

    begin_world(world, random, 32);
    add_face(world, 4, ground_m, &repeated);
    world->places = PLACES;
    for (int b = 0; b < PLACES; b++) {
        const double size_m = b == 3 || b == 6 ? 1000 : 0.6;
        double low_m[3], high_m[3];
        for (int i = 0; i < 3; i++) {
            low_m[i] = boxes_m[b][i] + (i == 1 ? 0 : size_m * 0.2 * any(random));
            high_m[i] = low_m[i] + size_m;
        }
        memcpy(world->middles_m[b], low_m, sizeof low_m);
        world->middles_m[b][1] += size_m;
        world->sizes_m[b] = size_m;
        add_box(world, random, low_m, high_m, false);
    }
}

/* A stamp of 5 cm in a plane whose other face, of 100 km, is in the other corner of the grid. */
static void make_stamp(struct world *world, struct random *random)
{
    static const double large_m[4][3] = {{-120e3, 0, 120e3}, {-20e3, 0, 120e3}, {-20e3, 0, 20e3}, {-120e3, 0, 20e3}};
    static const double corner_m[3] = {119999.5, 0, -119999.5};
    const struct truth coarse = {.gradient = {{1e-3, 0, 0}, {0, 0, 1e-3}}};
    double stamp_m[4][3];

    begin_world(world, random, 64);
    add_face(world, 4, large_m, &coarse);
    for (int k = 0; k < 4; k++) {
        memcpy(stamp_m[k], corner_m, sizeof corner_m);
        if (k == 1 || k == 2) stamp_m[k][0] += 0.05;
        if (k >= 2) stamp_m[k][2] -= 0.05;
    }
    struct truth fine = any_truth(random, corner_m, 0.05);
    add_face(world, 4, (const double(*)[3])stamp_m, &fine);
    world->places = 1;
    world->sizes_m[0] = 0.005;
    for (int i = 0; i < 3; i++)
        world->middles_m[0][i] = (stamp_m[0][i] + stamp_m[2][i]) / 2 + (i == 1 ? 0.03 : 0);
}

/* Stages ------------------------------------------------------------------------------------------ */

struct stage {
    const struct world *world;
    const struct core *core;
    struct mesh mesh;
    struct compiled scene;
};

static void open_stage(struct stage *stage, const struct world *world, const struct core *core,
                       enum coordinates coordinates)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .core = core, .coordinates = coordinates};
    struct error err;

    *stage = (struct stage){.world = world, .core = core};
    if (!coordinates_clean(&world->model, &options, &stage->mesh, &err) ||
        !mesh_insert_t_vertices(&stage->mesh, &err) || !compile_mesh(&stage->mesh, &options, &stage->scene, &err))
        fail_msg("%s", err.text);
    assert_int_equal(stage->scene.grid.is_long, coordinates == COORDINATES_32);
}

static void close_stage(struct stage *stage)
{
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
}

static void start(struct simulator *simulator, const struct stage *stage, enum lim_method method)
{
    const struct simulator_setup setup = {
        .w_px = W_PX, .h_px = H_PX, .method = method, .panel = SIMULATOR_MEMORY, .core = stage->core};
    struct error err;

    if (!simulator_init(simulator, &stage->scene.scene, &setup, &err)) fail_msg("%s", err.text);
}

/* From there into any direction, with any turn of the head. */
static struct lim_camera camera_at(const struct stage *stage, struct random *random, const double eye_m[3])
{
    const struct grid *grid = &stage->scene.grid;
    struct lim_camera camera = {.near_q8 = 4 * 256};

    for (int i = 0; i < 3; i++) {
        const double units = (eye_m[i] - grid->origin_m[i]) * grid->units_per_m, whole = floor(units);
        if (grid->is_long)
            camera.origin[i] = (int32_t)whole, camera.eye_q8[i] = (int32_t)((units - whole) * 256);
        else
            camera.eye_q8[i] = (int32_t)(units * 256);
    }
    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_in(random, -(INT64_C(1) << 30), INT64_C(1) << 30);
    camera.roll = (uint32_t)random_u64(random);
    camera.tan_x_q28 = (uint32_t)((0.09 + 1.1 * random_unit(random)) * (1 << 28));
    camera.tan_y_q28 = camera.tan_x_q28 / W_PX * H_PX;
    return camera;
}

/* Near one of the world's places, most often, looking at it; or anywhere. */
static struct lim_camera any_camera(const struct stage *stage, struct random *random)
{
    const struct world *world = stage->world;
    const size_t place = random_u64(random) % (uint64_t)world->places;
    double eye_m[3], way_m[3];

    for (int i = 0; i < 3; i++) {
        way_m[i] = 5 * world->sizes_m[place] * any(random);
        eye_m[i] = world->middles_m[place][i] + way_m[i];
    }
    struct lim_camera camera = camera_at(stage, random, eye_m);
    if (random_u64(random) % 4) {
        const double turn = ldexp(1, 31) / 3.14159265358979323846;
        camera.yaw = (uint32_t)(int64_t)(atan2(way_m[0], way_m[2]) * turn);
        camera.pitch = (uint32_t)(int64_t)(-atan2(way_m[1], hypot(way_m[0], way_m[2])) * turn);
    }
    return camera;
}

/* Texels ------------------------------------------------------------------------------------------ */

struct checking {
    const struct stage *stage;
    const struct lim_camera *camera;
    const struct truth *truth;
    double right[3], down[3], ahead[3], eye_m[3];
    double worst_level;                   /* by how much one is off that fits best */
    double sum, sum2, far, beyond, worst; /* texels of the level shown; pixels that are farther off than promised */
    size_t pixels;
};

static int off_bits_of(int profile)
{
    const int bits[] = {
        [LIM_PROFILE_DRAFT] = 0, [LIM_PROFILE_FAST] = 2, [LIM_PROFILE_FINE] = 4, [LIM_PROFILE_EXACT] = 6};
    return bits[profile];
}

/* log2 of texels to a pixel, of the whole picture, the mean of both directions. false: one is so much finer that nobody
 * promises a level. */
static bool level_of(const struct checking *checking, double depth, double along, double *level)
{
    const struct truth *truth = checking->truth;
    const double(*const g)[3] = truth->gradient;
    const double side_px = checking->stage->world->side_px;
    const double px2 = ldexp(checking->camera->tan_x_q28, -27) / W_PX * ldexp(checking->camera->tan_y_q28, -27) / H_PX;
    double density = 0, longest2[2] = {0, 0}, beside[2] = {0, 0};

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        density += truth->normal[i] * (g[0][j] * g[1][k] - g[0][k] * g[1][j]);
        for (int c = 0; c < 2; c++)
            longest2[c] += g[c][i] * g[c][i], beside[c] += g[c][i] * truth->normal[i];
    }
    for (int c = 0; c < 2; c++)
        longest2[c] -= beside[c] * beside[c]; /* of what lies in the plane */
    *level = log2(side_px * side_px * fabs(density) * px2 * depth * depth / fabs(along)) / 2;
    return fabs(density) > fmax(longest2[0], longest2[1]) / 32;
}

static void check_texel(void *ctx, const struct core_texel_at *at)
{
    struct checking *checking = ctx;
    const struct truth *truth = checking->truth;
    const double x = ldexp(checking->camera->tan_x_q28, -28) * ((2.0 * at->x_px + 1) / W_PX - 1);
    const double y = ldexp(checking->camera->tan_y_q28, -28) * ((2.0 * at->y_px + 1) / H_PX - 1);
    const double side = ldexp(checking->stage->world->side_px, -(int)at->level);
    double ray[3], along = 0, height = 0, error2 = 0;

    for (int i = 0; i < 3; i++) {
        ray[i] = checking->ahead[i] + x * checking->right[i] + y * checking->down[i];
        along += truth->normal[i] * ray[i];
        height += truth->normal[i] * (truth->corner_m[i] - checking->eye_m[i]);
    }
    if (side <= 1) return;           /* there is but one texel */
    if (along * height <= 0) return; /* it never meets that plane: rounding put the pixel beyond the horizon */
    for (int c = 0; c < 2; c++) {
        double uv = truth->uv[c];
        for (int i = 0; i < 3; i++)
            uv += truth->gradient[c][i] * (checking->eye_m[i] - truth->at_m[i] + height / along * ray[i]);
        const double off = at->uv[c] - uv;
        error2 += pow(side * (off - floor(off + 0.5)), 2);
    }
    checking->pixels++;
    checking->sum += sqrt(error2);
    checking->sum2 += error2;
    checking->far += sqrt(error2) > ldexp(1, -off_bits_of(checking->stage->core->profile));
    checking->beyond += error2 > 1;
    checking->worst = fmax(checking->worst, sqrt(error2));
    double level;
    if (!at->divided || !level_of(checking, height / along, along, &level)) return;
    const double levels = log2(checking->stage->world->side_px);
    checking->worst_level = fmax(checking->worst_level, fabs(fmin(fmax(level, 0), levels) - at->level));
}

static void set_eye(struct checking *checking)
{
    const struct grid *grid = &checking->stage->scene.grid;

    texture_rig_axes(checking->camera, checking->right, checking->down, checking->ahead);
    for (int i = 0; i < 3; i++) {
        const double units = checking->camera->eye_q8[i] / 256.0 + (grid->is_long ? checking->camera->origin[i] : 0);
        checking->eye_m[i] = units / grid->units_per_m + grid->origin_m[i];
    }
}

static struct checking check_all(const struct stage *stage, struct random *random, int frames)
{
    const struct lim_scene *scene = &stage->scene.scene;
    struct checking checking = {.stage = stage};
    struct simulator simulator;

    for (int kind = 0; kind < UNMAPPED_KINDS; kind++)
        assert_int_equal(stage->mesh.counts.unmapped[kind], 0);
    start(&simulator, stage, LIM_NEAREST_FIRST);
    for (int f = 0; f < effort(frames); f++) {
        const struct lim_camera camera = any_camera(stage, random);
        texture_rig_draw(&simulator, &camera);
        checking.camera = &camera;
        set_eye(&checking);
        for (size_t word = 0, record = 0; word < scene->polygon_words; record++) {
            checking.truth = &stage->world->truths[stage->scene.faces[record] - 1];
            stage->core->texels(simulator.lim, (lim_index)word, check_texel, &checking);
            word += lim_record_words(scene->polygons[word]);
        }
    }
    simulator_free(&simulator);
    return checking;
}

static void say(const char *name, const struct checking *checking)
{
    const double n = (double)checking->pixels;

    print_message(
        "# %s %s: mean %.4f texels, rms %.4f, worst %.3f; more than promised %.3f %%, than one %.4f %% of %zu "
        "pixels; a level %.2f off\n",
        name, checking->stage->core->name, checking->sum / n, sqrt(checking->sum2 / n), checking->worst,
        100 * checking->far / n, 100 * checking->beyond / n, checking->pixels, checking->worst_level);
}

/* As of scenes of 16 bits: test_texture.c. */
static void judge(const char *name, const struct checking *checking)
{
    const int off_bits = off_bits_of(checking->stage->core->profile);
    const double n = (double)checking->pixels;

    say(name, checking);
    assert_true(checking->pixels > (size_t)(effort(FRAMES) * W_PX * H_PX / 64));
    assert_true(checking->sum / n < ldexp(0.4, -off_bits));
    assert_true(checking->far / n < 0.01);
    assert_true(checking->beyond / n < (off_bits ? 1e-5 : 0.01));
    assert_true(checking->worst_level < 0.8); /* half a level is rounding */
}

static void judge_in_all_profiles(const char *name, const struct world *world)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    for (size_t i = 0; i < count; i++) {
        struct random random = {77};
        struct stage stage;
        open_stage(&stage, world, profiles[i], COORDINATES_32);
        const struct checking checking = check_all(&stage, &random, FRAMES);
        judge(name, &checking);
        close_stage(&stage);
    }
}

static void heaps_show_their_texels(const char *name, int most_bits)
{
    static struct world world;
    struct random random = {191};

    make_heaps(&world, &random, most_bits);
    judge_in_all_profiles(name, &world);
    model_free(&world.model);
}

static void worlds_of_2_10_show_their_texels(void **state)
{
    (void)state;
    heaps_show_their_texels("heaps 2^-10", 10);
}

/* What 16 bits hold as well shows texels as near to the model's. */
static void a_room_is_the_same_on_16_and_on_32_bits(void **state)
{
    static struct world world;
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct random random = {7};

    (void)state;
    make_room(&world, &random);
    for (size_t i = 0; i < count; i++) {
        double means[2];
        for (int is_long = 0; is_long < 2; is_long++) {
            struct random looking = {77};
            struct stage stage;
            open_stage(&stage, &world, profiles[i], is_long ? COORDINATES_32 : COORDINATES_16);
            const struct checking checking = check_all(&stage, &looking, FRAMES);
            judge(is_long ? "room, 32 bits" : "room, 16 bits", &checking);
            means[is_long] = checking.sum / (double)checking.pixels;
            close_stage(&stage);
        }
        assert_true(means[1] < 1.05 * means[0]);
    }
    model_free(&world.model);
}

static void worlds_of_2_16_show_their_texels(void **state)
{
    (void)state;
    heaps_show_their_texels("heaps 2^-16", 16);
}

static void worlds_of_2_22_show_their_texels(void **state)
{
    (void)state;
    heaps_show_their_texels("heaps 2^-22", 22);
}

static void worlds_of_2_28_show_their_texels(void **state)
{
    (void)state;
    heaps_show_their_texels("heaps 2^-28", 28);
}

static void a_ground_of_240_km_shows_its_texels(void **state)
{
    static struct world world;
    struct random random = {5};

    (void)state;
    make_ground(&world, &random);
    judge_in_all_profiles("ground", &world);
    model_free(&world.model);
}

static void a_fine_texture_is_exact_in_a_plane_of_far_away(void **state)
{
    static struct world world;
    struct random random = {6};

    (void)state;
    make_stamp(&world, &random);
    judge_in_all_profiles("stamp", &world);
    model_free(&world.model);
}

/* Orders ------------------------------------------------------------------------------------------ */

enum { ORDERS = 3 };

static void draw_in_all_orders(struct simulator simulators[ORDERS], const struct lim_camera *camera)
{
    for (int k = 0; k < ORDERS; k++) {
        texture_rig_draw(&simulators[k], camera);
        assert_memory_equal(simulators[k].pixels, simulators[0].pixels, W_PX * H_PX * sizeof simulators[0].pixels[0]);
    }
}

static void start_orders(struct simulator simulators[ORDERS], const struct stage *stage)
{
    static const enum lim_method orders[ORDERS] = {LIM_NEAREST_FIRST, LIM_PAINTER, LIM_SCANLINE};

    for (int k = 0; k < ORDERS; k++)
        start(&simulators[k], stage, orders[k]);
}

static void stop_orders(struct simulator simulators[ORDERS])
{
    for (int k = 0; k < ORDERS; k++)
        simulator_free(&simulators[k]);
}

typedef struct lim_camera camera_maker(const struct stage *stage, struct random *random);

static void paint_alike(const struct world *world, struct random *random, camera_maker *make_camera, int frames)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    for (size_t i = 0; i < count; i++) {
        struct simulator simulators[ORDERS];
        struct stage stage;
        open_stage(&stage, world, profiles[i], COORDINATES_32);
        start_orders(simulators, &stage);
        for (int f = 0; f < effort(frames); f++) {
            const struct lim_camera camera = make_camera(&stage, random);
            draw_in_all_orders(simulators, &camera);
        }
        stop_orders(simulators);
        close_stage(&stage);
    }
}

static void all_orders_paint_the_same(void **state)
{
    static struct world world;
    struct random random = {9};

    (void)state;
    make_heaps(&world, &random, 20);
    paint_alike(&world, &random, any_camera, FRAMES);
    model_free(&world.model);
}

/* Pictures of a unit, and such as none of the grid is as large as; eyes anywhere, or at a vertex; any lens. */
static struct lim_camera hostile_camera(const struct stage *stage, struct random *random)
{
    struct lim_camera camera = any_camera(stage, random);
    const struct lim_scene *scene = &stage->scene.scene;
    const size_t vertex = random_u64(random) % scene->vertex_count;
    const int64_t kind = random_in(random, 0, 3), reach = (INT64_C(1) << random_in(random, 0, 30)) - 1;

    camera.tan_x_q28 = random_tan_q28(random);
    camera.tan_y_q28 = random_tan_q28(random);
    for (int i = 0; i < 3 && kind; i++) {
        camera.eye_q8[i] = kind == 1 ? 0 : (int32_t)random_in(random, 0, 255);
        camera.origin[i] =
            kind == 3 ? (int32_t)random_in(random, -reach, reach) : (*scene->of_32_bits)->vertices[vertex].at[i];
    }
    return camera;
}

static void extremes_are_painted_alike(void **state)
{
    static const double times[] = {1e-9, 1e-4, 1, 1e4, 1e6};
    static struct world world;
    struct random random = {10};

    (void)state;
    for (size_t t = 0; t < sizeof times / sizeof *times; t++) {
        make_heaps(&world, &random, 24);
        for (size_t k = 0; k < world.model.point_count; k++)
            for (int c = 0; c < 2; c++)
                world.model.uvs[k][c] *= times[t];
        paint_alike(&world, &random, hostile_camera, 2 * FRAMES);
        model_free(&world.model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worlds_of_2_10_show_their_texels),
        cmocka_unit_test(worlds_of_2_16_show_their_texels),
        cmocka_unit_test(worlds_of_2_22_show_their_texels),
        cmocka_unit_test(worlds_of_2_28_show_their_texels),
        cmocka_unit_test(a_ground_of_240_km_shows_its_texels),
        cmocka_unit_test(a_fine_texture_is_exact_in_a_plane_of_far_away),
        cmocka_unit_test(a_room_is_the_same_on_16_and_on_32_bits),
        cmocka_unit_test(all_orders_paint_the_same),
        cmocka_unit_test(extremes_are_painted_alike),
    };

    return cmocka_run_group_tests_name("textures in scenes of many scales", tests, NULL, NULL);
}
