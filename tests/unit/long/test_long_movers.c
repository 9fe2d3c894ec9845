/* SPDX-License-Identifier: MIT
 *
 * What moves in scenes of many scales: a closed room, in it heaps of solids, each heap some powers of two smaller than
 * the room, and in each heap solids that stand beside such that move, turned and through one another. Which face each
 * pixel shows is held against rays in double precision that meet the model's own faces where their poses take them. */
#include "cameras/camera_path.h"
#include "compiler/moving_compile.h"
#include "render/ids.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PX = 72, WORLDS = 6, FRAMES = 30, HEAPS = 5, HEAP_SOLIDS = 6, FACES_MOST = 256, CORNERS_MOST = 4 };
static const double ROOM_M = 1;        /* from the middle to each wall */
static const double FAR_SIZE_M = 1e-6; /* what is smaller is left out where it is less than a 50th of a pixel */

/* A face of the model, where it is in the frame. */
struct plate {
    double at_m[CORNERS_MOST][3], normal[3];
    int corners;
    size_t mover; /* from 1; 0: it stands still */
};

struct world {
    struct model model;
    struct plate plates[FACES_MOST]; /* by the model's numbers of faces, from 1 */
    double middles_m[HEAPS][3], sizes_m[HEAPS];
};

/* Models ---------------------------------------------------------------------------------------------------------- */

static double any(struct random *random)
{
    return 2 * random_unit(random) - 1;
}

/* By the quaternion's own formula: v + 2 w (q x v) + 2 q x (q x v). */
static void turned(const double q[4], const double v[3], double out[3])
{
    double once[3], twice[3];

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        once[i] = 2 * (q[j] * v[k] - q[k] * v[j]);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        twice[i] = q[j] * once[k] - q[k] * once[j];
    }
    for (int i = 0; i < 3; i++)
        out[i] = v[i] + q[3] * once[i] + twice[i];
}

static void set_normal(struct plate *plate)
{
    double length = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double *a = plate->at_m[0], *b = plate->at_m[1], *c = plate->at_m[2];
        plate->normal[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        length += plate->normal[i] * plate->normal[i];
    }
    for (int i = 0; i < 3; i++)
        plate->normal[i] /= sqrt(length);
}

/* The faces from `first` on, as a mover in the pose, or NULL: as they are. */
static void take_plates(struct world *world, size_t first, const struct model_pose *pose)
{
    const struct model *model = &world->model;

    for (size_t f = first; f < model->face_count; f++) {
        struct plate *plate = &world->plates[f + 1];
        const struct model_face *face = &model->faces[f];
        assert_true(f + 1 < FACES_MOST && face->count <= CORNERS_MOST);
        plate->corners = (int)face->count;
        plate->mover = face->mover;
        for (int c = 0; c < plate->corners; c++) {
            const double *point = model->points[model->corners[face->first + (uint32_t)c]];
            memcpy(plate->at_m[c], point, sizeof plate->at_m[c]);
            if (pose) turned(pose->turn, point, plate->at_m[c]);
            for (int i = 0; pose && i < 3; i++)
                plate->at_m[c][i] += pose->at_m[i];
        }
        set_normal(plate);
    }
}

/* They move, and are in that pose at all times. */
static void move_faces(struct world *world, size_t first, const struct model_pose *pose)
{
    struct model *model = &world->model;
    const size_t number = ++model->mover_count;

    model->movers = realloc(model->movers, number * sizeof *model->movers);
    model->keys = realloc(model->keys, (model->key_count + 1) * sizeof *model->keys);
    model->movers[number - 1] =
        (struct model_mover){.rest = {.turn = {0, 0, 0, 1}}, .first_key = (uint32_t)model->key_count, .key_count = 1};
    snprintf(model->movers[number - 1].name, MODEL_NAME_B, "solid %zu", number);
    model->keys[model->key_count++] = (struct model_key){0, *pose};
    for (size_t f = first; f < model->face_count; f++)
        model->faces[f].mover = (uint16_t)number;
    take_plates(world, first, pose);
}

/* A box or a tetrahedron about a point. */
static void add_solid(struct world *world, struct random *random, const double about_m[3], double size_m, bool pointed)
{
    static const double corners[4][3] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    double low_m[3], high_m[3], corners_m[4][3];

    for (int i = 0; i < 3; i++) {
        low_m[i] = about_m[i] - size_m * (0.15 + 0.5 * random_unit(random));
        high_m[i] = about_m[i] + size_m * (0.15 + 0.5 * random_unit(random));
        for (int k = 0; k < 4; k++)
            corners_m[k][i] = about_m[i] + size_m * (corners[k][i] + 0.4 * any(random));
    }
    if (pointed)
        boxes_add_tetrahedron(&world->model, (const double(*)[3])corners_m, false);
    else
        boxes_add_solid(&world->model, low_m, high_m);
}

static struct model_pose any_pose(struct random *random, const double at_m[3])
{
    struct model_pose pose;
    double length = 0;

    memcpy(pose.at_m, at_m, sizeof pose.at_m);
    for (int i = 0; i < 4; i++) {
        pose.turn[i] = any(random);
        length += pose.turn[i] * pose.turn[i];
    }
    for (int i = 0; i < 4; i++)
        pose.turn[i] /= sqrt(length);
    return pose;
}

/* Every second solid moves, and the largest heap has more of these. */
static void add_heap(struct world *world, struct random *random, const double middle_m[3], double size_m)
{
    static const double here_m[3];

    for (int s = 0; s < HEAP_SOLIDS; s++) {
        const size_t first = world->model.face_count;
        double at_m[3];
        for (int i = 0; i < 3; i++)
            at_m[i] = middle_m[i] + size_m * any(random);
        if (s % 2) {
            const struct model_pose pose = any_pose(random, at_m);
            add_solid(world, random, here_m, size_m, s % 4 == 1);
            move_faces(world, first, &pose);
        } else {
            add_solid(world, random, at_m, size_m, s % 4 == 2);
            take_plates(world, first, NULL);
        }
    }
}

/* A thick plank that moves, a quarter as large as the room, one of whose faces or edges passes by a place. */
static void add_plank(struct world *world, struct random *random, const double by_m[3], double off_m)
{
    const double half_m[3] = {0.25, 0.2, 0.05}, low_m[3] = {-0.25, -0.2, -0.05};
    const size_t first = world->model.face_count;
    struct model_pose pose = any_pose(random, by_m);
    double point_m[3], there_m[3];

    for (int i = 0; i < 3; i++)
        point_m[i] = i == 2 || random_u64(random) % 2 ? half_m[i] + off_m * any(random) : half_m[i] * any(random);
    turned(pose.turn, point_m, there_m);
    for (int i = 0; i < 3; i++)
        pose.at_m[i] -= there_m[i];
    boxes_add_solid(&world->model, low_m, half_m);
    move_faces(world, first, &pose);
}

/* `planks`: how many pass by the smaller heaps. */
static void make_world(struct world *world, struct random *random, int most_bits, int planks)
{
    const double low_m[3] = {-ROOM_M, -ROOM_M, -ROOM_M}, high_m[3] = {ROOM_M, ROOM_M, ROOM_M};

    memset(world, 0, sizeof *world);
    boxes_add_room(&world->model, low_m, high_m);
    take_plates(world, 0, NULL);
    for (int h = 0; h < HEAPS; h++) {
        world->sizes_m[h] = ldexp(ROOM_M, -(3 + (most_bits - 3) * h / (HEAPS - 1)));
        for (int i = 0; i < 3; i++)
            world->middles_m[h][i] = (ROOM_M - 4 * world->sizes_m[h]) * any(random);
        add_heap(world, random, world->middles_m[h], world->sizes_m[h]);
        if (h >= HEAPS - planks) add_plank(world, random, world->middles_m[h], 3 * world->sizes_m[h]);
    }
}

/* Rays ------------------------------------------------------------------------------------------------------------ */

struct look {
    struct viewpoint viewpoint;
    struct lens lens;
    double right[3], down[3], ahead[3];
};

static double dot_of(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_axes(struct look *look)
{
    double length = 0;

    for (int i = 0; i < 3; i++)
        look->ahead[i] = look->viewpoint.target_m[i] - look->viewpoint.eye_m[i];
    length = sqrt(dot_of(look->ahead, look->ahead));
    for (int i = 0; i < 3; i++)
        look->ahead[i] /= length;
    const double level = hypot(look->ahead[0], look->ahead[2]);
    const double right[3] = {-look->ahead[2] / level, 0, look->ahead[0] / level};
    memcpy(look->right, right, sizeof right);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        look->down[i] = look->ahead[j] * right[k] - look->ahead[k] * right[j];
    }
}

/* How far along a ray a plate is met, by its front, beyond the near plane; infinite: nowhere. */
static double met_at(const struct plate *plate, const struct look *look, const double ray[3])
{
    double away[3];

    for (int i = 0; i < 3; i++)
        away[i] = plate->at_m[0][i] - look->viewpoint.eye_m[i];
    const double height = dot_of(plate->normal, away), along = dot_of(plate->normal, ray);
    if (height >= 0 || along >= 0) return INFINITY;
    const double depth = height / along;
    if (depth < look->lens.near_m) return INFINITY;
    for (int c = 0; c < plate->corners; c++) {
        const double *from = plate->at_m[c], *to = plate->at_m[(c + 1) % plate->corners];
        double side = 0;
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            const double edge_j = to[j] - from[j], edge_k = to[k] - from[k];
            const double at_j = look->viewpoint.eye_m[j] + depth * ray[j] - from[j];
            const double at_k = look->viewpoint.eye_m[k] + depth * ray[k] - from[k];
            side += plate->normal[i] * (edge_j * at_k - edge_k * at_j);
        }
        if (side < 0) return INFINITY;
    }
    return depth;
}

/* Which face is seen at a place of the screen, in pixels; 0: none. */
static size_t face_at(const struct world *world, const struct look *look, double x_px, double y_px, double *nearest,
                      double ray[3])
{
    const double x = look->lens.tan_x * (2 * x_px / PX - 1), y = look->lens.tan_y * (2 * y_px / PX - 1);
    size_t face = 0;

    *nearest = INFINITY;

    for (int i = 0; i < 3; i++)
        ray[i] = look->ahead[i] + x * look->right[i] + y * look->down[i];
    for (size_t f = 1; f <= world->model.face_count; f++) {
        const double depth = met_at(&world->plates[f], look, ray);
        if (depth >= *nearest) continue;
        *nearest = depth;
        face = f;
    }
    return face;
}

/* Whether one sees through what should be seen: a face is nowhere within a pixel of a place, and its plane lies behind
 * all that is. */
static bool is_hole(const struct world *world, const struct look *look, double x_px, double y_px, size_t face)
{
    const struct plate *plate = &world->plates[face];
    double away[3], farthest = 0;

    for (int step = 0; step < 49; step++) {
        double depth, ray[3];
        const size_t seen = face_at(world, look, x_px + (step % 7 - 3) / 3.0, y_px + (step / 7 - 3) / 3.0, &depth, ray);
        if (seen == face) return false;
        farthest = fmax(farthest, depth);
    }
    double depth, ray[3];
    face_at(world, look, x_px, y_px, &depth, ray);
    for (int i = 0; i < 3; i++)
        away[i] = plate->at_m[0][i] - look->viewpoint.eye_m[i];
    return dot_of(plate->normal, away) / dot_of(plate->normal, ray) > 1.001 * farthest;
}

struct verdict {
    size_t pixels, wrong, holes, moving; /* moving: that show something that moves */
};

static void judge(struct verdict *sum, const struct world *world, const struct look *look, const uint32_t *faces)
{
    for (size_t k = 0; k < PX * PX; k++) {
        const double x_px = (double)(k % PX) + 0.5, y_px = (double)(k / PX) + 0.5;
        double depth, ray[3];
        const size_t face = faces[k], truth = face_at(world, look, x_px, y_px, &depth, ray);
        sum->pixels++;
        sum->moving += world->plates[face].mover > 0;
        if (face == truth) continue;
        sum->wrong++;
        sum->holes += !face || is_hole(world, look, x_px, y_px, face);
    }
}

/* Stages ---------------------------------------------------------------------------------------------------------- */

struct stage {
    struct compiled scene;
    struct moving moving;
    struct ids ids;
};

/* As finely as instances have it: keys have 15 bits. */
static void turn_instance(struct lim_instance *instance, const double turn[4])
{
    for (int j = 0; j < 3; j++) {
        double axis[3] = {j == 0, j == 1, j == 2}, there[3];
        turned(turn, axis, there);
        for (int i = 0; i < 3; i++)
            instance->axes_q30[3 * j + i] = (int32_t)lround(ldexp(there[i], 30));
    }
}

static void compile_stage(struct stage *stage, const struct model *model, const struct core *core)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .keep_faces = true,
                                            .core = core,
                                            .coordinates = COORDINATES_32,
                                            .near_m = 1e-9,
                                            .w_px = PX,
                                            .h_px = PX,
                                            .unlit = true};
    const struct moving_options movers = {.mode = MOVING_ON};
    struct error err;

    if (!moving_compile_model(model, &options, &movers, &stage->scene, &stage->moving, &err)) fail_msg("%s", err.text);
    assert_true(stage->scene.grid.is_long);
    moving_pose(&stage->moving, 0);
    for (size_t i = 0; i < stage->moving.count; i++)
        turn_instance(&stage->moving.instances[i], stage->moving.model.keys[i].pose.turn);
}

static void start(struct ids *ids, const struct stage *stage, const struct core *core, enum lim_method method)
{
    const struct simulator_setup setup = {PX, PX, method, SIMULATOR_MEMORY, core};
    struct error err;

    if (!ids_init(ids, &stage->scene, &setup, &err) || !ids_set_movers(ids, &stage->moving, &err))
        fail_msg("%s", err.text);
}

/* The model is the stage's from now on. */
static void open_stage(struct stage *stage, const struct model *model, const struct core *core)
{
    compile_stage(stage, model, core);
    start(&stage->ids, stage, core, LIM_NEAREST_FIRST);
}

static void close_stage(struct stage *stage)
{
    ids_free(&stage->ids);
    moving_free(&stage->moving);
    compiled_free(&stage->scene);
}

static struct lim_camera camera_of(const struct stage *stage, const struct look *look)
{
    struct viewpoint viewpoint = look->viewpoint;
    const struct camera_path path = {"test", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    viewpoint.line = 1;
    if (!camera_path_to_camera(&path, 0, &look->lens, &stage->scene.grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

static void draw(struct ids *ids, const struct lim_camera *camera)
{
    struct error err;

    if (!ids_frame(ids, camera, &err)) fail_msg("%s", err.text);
}

/* Whether a place is outside of all that is solid by a margin: each is the faces between two places in the list. */
static bool is_free(const struct world *world, const double at_m[3], double margin_m)
{
    size_t f = 7; /* behind the room's */

    for (int i = 0; i < 3; i++)
        if (fabs(at_m[i]) > ROOM_M - margin_m) return false;
    while (f <= world->model.face_count) {
        const size_t faces = world->plates[f].corners == 4 ? 6 : 4;
        bool outside = false;
        for (size_t k = f; k < f + faces; k++) {
            double away[3];
            for (int i = 0; i < 3; i++)
                away[i] = at_m[i] - world->plates[k].at_m[0][i];
            outside |= dot_of(world->plates[k].normal, away) > margin_m;
        }
        if (!outside) return false;
        f += faces;
    }
    return true;
}

/* From near one of the heaps, at something in it or anywhere. */
static struct look any_look(const struct world *world, struct random *random, double unit_m)
{
    const size_t heap = random_u64(random) % HEAPS;
    const double size_m = world->sizes_m[heap], *middle_m = world->middles_m[heap];
    const bool at_heap = random_u64(random) % 4;
    struct look look = {.lens = {.tan_x = 0.7, .tan_y = 0.7}};

    look.lens.near_m = fmin(fmax(0.02 * size_m, 2.1 * unit_m), 10000 * unit_m);
    do
        for (int i = 0; i < 3; i++) {
            look.viewpoint.eye_m[i] = middle_m[i] + 5 * size_m * any(random);
            look.viewpoint.target_m[i] = at_heap ? middle_m[i] + size_m * any(random) : ROOM_M * any(random);
        }
    while (!is_free(world, look.viewpoint.eye_m, 2 * look.lens.near_m));
    set_axes(&look);
    return look;
}

static double most_wrong_percent(const struct core *core)
{
    return core->profile == LIM_PROFILE_FAST ? 0.1 : core->profile == LIM_PROFILE_FINE ? 0.05 : 0.01;
}

static void look_around(struct stage *stage, const struct world *world, uint64_t seed, struct verdict *sum)
{
    const struct lim_mover_stats *stats = &simulator_stats(&stage->ids.simulator)->movers;
    struct random random = {seed};

    for (int f = 0; f < effort(FRAMES); f++) {
        const struct look look = any_look(world, &random, 1 / stage->scene.grid.units_per_m);
        const struct lim_camera camera = camera_of(stage, &look);
        draw(&stage->ids, &camera);
        judge(sum, world, &look, stage->ids.faces);
        if (world->sizes_m[HEAPS - 1] > FAR_SIZE_M) assert_int_equal(stats->left_out, 0);
    }
}

/* The smallest heap is 2^-most_bits as large as half of the room. */
static void worlds_are_closed_and_in_order(int most_bits, int planks)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct verdict sums[PROFILES_MAX] = {{0}};
    struct random random = {409};
    size_t failed = 0;

    for (int w = 0; w < WORLDS; w++) {
        const uint64_t seed = random_u64(&random) | 1, looks = random_u64(&random) | 1;
        for (size_t k = 0; k < count; k++) {
            static struct world world;
            struct random again = {seed};
            struct stage stage = {.scene = {.moving = NULL}};
            make_world(&world, &again, most_bits, planks);
            open_stage(&stage, &world.model, profiles[k]);
            look_around(&stage, &world, looks, &sums[k]);
            close_stage(&stage);
        }
    }
    for (size_t k = 0; k < count; k++) {
        const struct verdict *sum = &sums[k];
        const double percent = 100.0 * (double)sum->wrong / (double)sum->pixels;
        printf("# long-movers 2^-%d, %d planks, %s: %zu pixels, %zu of what moves, %zu holes, %.4f %% wrong\n",
               most_bits, planks, profiles[k]->name, sum->pixels, sum->moving, sum->holes, percent);
        failed += sum->moving < sum->pixels / 50;
        if (profiles[k]->sub_bits > 0) failed += sum->holes > 0 || percent > most_wrong_percent(profiles[k]);
    }
    assert_int_equal(failed, 0);
}

static void worlds_of_2_6(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(6, 0);
}

static void worlds_of_2_12(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(12, 0);
}

static void worlds_of_2_22(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(22, 0);
}

/* What is as large as the room passes by things of a 2^10th of that. */
static void worlds_with_planks(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(11, 3);
}

/* Other ways to the same picture
 * --------------------------------------------------------------------------------------- */

static uint64_t sum_of_faces(const struct ids *ids)
{
    uint64_t sum = 1469598103934665603u;

    for (size_t k = 0; k < PX * PX; k++)
        sum = (sum ^ ids->faces[k]) * 1099511628211u;
    return sum;
}

/* With so little memory that most frames take several bands. */
static void starve(struct ids *ids, const struct stage *stage)
{
    struct error err;

    if (!simulator_set_ram(&ids->simulator, &(struct simulator_ram){.percent = 4}, &err)) fail_msg("%s", err.text);
    free(ids->simulator.mover_mem);
    if (!simulator_set_movers(&ids->simulator, ids->instances, stage->moving.count, &stage->moving.limits, &err))
        fail_msg("%s", err.text);
}

static void orders_and_memories_show_the_same(void **state)
{
    enum { WAYS = 3 };
    static struct world world;
    struct random random = {77};
    size_t bands = 0;
    (void)state;

    for (int w = 0; w < 4; w++) {
        struct stage stage = {.scene = {.moving = NULL}};
        struct ids others[WAYS - 1];
        make_world(&world, &random, 10, w % 2 ? 3 : 0);
        open_stage(&stage, &world.model, &core_fast);
        start(&others[0], &stage, &core_fast, LIM_SCANLINE);
        start(&others[1], &stage, &core_fast, LIM_NEAREST_FIRST);
        starve(&others[1], &stage);
        for (int f = 0; f < effort(FRAMES); f++) {
            const struct look look = any_look(&world, &random, 1 / stage.scene.grid.units_per_m);
            const struct lim_camera camera = camera_of(&stage, &look);
            draw(&stage.ids, &camera);
            for (int k = 0; k < WAYS - 1; k++) {
                draw(&others[k], &camera);
                assert_int_equal(sum_of_faces(&others[k]), sum_of_faces(&stage.ids));
            }
            bands += simulator_stats(&others[1].simulator)->bands;
        }
        for (int k = 0; k < WAYS - 1; k++)
            ids_free(&others[k]);
        close_stage(&stage);
    }
    assert_true(bands > (size_t)effort(FRAMES));
}

/* Where in the scene it is -------------------------------------------------------------------------------------------
 */

/* A corner of the room, a post in it and two turned boxes through each other and the floor, all below 4 m, moved by
 * some metres; and crumbs in two corners of 2^30 mm, so that a unit is a millimetre or so wherever that is. */
static void make_corner(struct world *world, const double shift_m[3])
{
    static const double end_m = 536870.9, half_m[3] = {0.4, 0.3, 0.6}, other_m[3] = {0.2, 0.9, 0.2};
    struct model *model = &world->model;

    memset(world, 0, sizeof *world);
    for (int k = 0; k < 2; k++) {
        double low_m[3], high_m[3];
        for (int i = 0; i < 3; i++)
            low_m[i] = k ? end_m - 4 : -end_m, high_m[i] = low_m[i] + 4;
        boxes_add_solid(model, low_m, high_m);
    }
    static const double walls_m[4][2][3] = {{{-4, -1, -4}, {4, 0, 4}},
                                            {{-4, 0, -5}, {4, 4, -4}},
                                            {{-5, 0, -4}, {-4, 4, 4}},
                                            {{-1, 0, -1}, {-0.5, 3, -0.5}}};
    for (int k = 0; k < 4; k++) {
        double low_m[3], high_m[3];
        for (int i = 0; i < 3; i++)
            low_m[i] = walls_m[k][0][i] + shift_m[i], high_m[i] = walls_m[k][1][i] + shift_m[i];
        boxes_add_solid(model, low_m, high_m);
    }
    take_plates(world, 0, NULL);
    for (int k = 0; k < 2; k++) {
        const double *half = k ? other_m : half_m, low_m[3] = {-half[0], -half[1], -half[2]};
        const struct model_pose pose = {{shift_m[0] + 0.2 * k, shift_m[1] + 0.25, shift_m[2] + 0.1},
                                        {0.5, k ? 0.5 : -0.5, 0.1, 0.7}};
        struct model_pose unit = pose;
        double length = 0;
        for (int i = 0; i < 4; i++)
            length += pose.turn[i] * pose.turn[i];
        for (int i = 0; i < 4; i++)
            unit.turn[i] /= sqrt(length);
        const size_t first = model->face_count;
        boxes_add_solid(model, low_m, half);
        move_faces(world, first, &unit);
    }
}

/* Pictures of it from around, into `sums`; none may be wrong where it is. */
static void view_corner(const double shift_m[3], const struct core *core, struct verdict *sum)
{
    static struct world world;
    struct stage stage = {.scene = {.moving = NULL}};

    make_corner(&world, shift_m);
    open_stage(&stage, &world.model, core);
    for (int f = 0; f < 24; f++) {
        const double turn = 0.26 * f;
        struct look look = {.lens = {.tan_x = 0.6, .tan_y = 0.6, .near_m = 0.05}};
        for (int i = 0; i < 3; i++)
            look.viewpoint.target_m[i] = shift_m[i] + (i == 1 ? 0.4 : 0.1);
        look.viewpoint.eye_m[0] = shift_m[0] + 3 * cos(turn);
        look.viewpoint.eye_m[1] = shift_m[1] + 1.7 + sin(5 * turn);
        look.viewpoint.eye_m[2] = shift_m[2] + 3 * sin(turn);
        set_axes(&look);
        const struct lim_camera camera = camera_of(&stage, &look);
        draw(&stage.ids, &camera);
        judge(sum, &world, &look, stage.ids.faces);
        assert_int_equal(simulator_stats(&stage.ids.simulator)->movers.left_out, 0);
    }
    close_stage(&stage);
}

/* Half a million metres from the origin all is as near it. */
static void far_from_the_origin_it_is_as_near_it(void **state)
{
    static const double shifts_m[4][3] = {
        {0, 0, 0}, {536000, 536000, -536000}, {-536000, 0, 3}, {1000, -536000, 536000}};
    struct verdict here = {0};
    (void)state;

    for (int k = 0; k < 4; k++) {
        struct verdict there = {0};
        view_corner(shifts_m[k], &core_exact, &there);
        print_message("corner %d: %zu wrong, %zu holes, %zu of what moves\n", k, there.wrong, there.holes,
                      there.moving);
        assert_int_equal(there.holes, 0);
        assert_true(there.moving > there.pixels / 20);
        if (!k) here = there;
        assert_true(there.wrong <= there.pixels / 1000 && there.wrong <= 2 * here.wrong + 8);
    }
}

/* Motion ---------------------------------------------------------------------------------------------------------- */

/* Keys anywhere in the scene: places on the way are where a straight line in double precision has them, as far as the
 * 31 bits of its part tell. */
static void keys_lead_through_the_whole_scene(void **state)
{
    struct random random = {5};
    (void)state;

    for (int round = 0; round < 2000; round++) {
        struct lim_motion_key keys[2] = {{.turn_q15 = {0, 0, 0, 32767}},
                                         {.time_ms = 1000, .turn_q15 = {0, 0, 0, 32767}}};
        struct lim_long_vertex origins[2];
        struct lim_instance instance;
        const uint32_t time_ms = (uint32_t)random_in(&random, 0, 1000);
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 3; i++) {
                origins[k].at[i] =
                    (int32_t)random_in(&random, -(1 << 30) + 1, (1 << 30) - 1) >> random_in(&random, 0, 29);
                keys[k].at_q8[i] = (int32_t)random_in(&random, 0, 255);
            }
        const struct lim_motion motion = {.keys = keys, .count = 2, .repeats = false, .origins = {origins}};
        lim_motion_at(&motion, time_ms, &instance);
        for (int i = 0; i < 3; i++) {
            const double from = origins[0].at[i] + keys[0].at_q8[i] / 256.0,
                         to = origins[1].at[i] + keys[1].at_q8[i] / 256.0;
            const double at = from + (to - from) * time_ms / 1000;
            const double off = instance.origin[i] + instance.at_q8[i] / 256.0 - at;
            if (!(fabs(off) <= 2.0 / 256 + fabs(to - from) * ldexp(1, -28))) fail_msg("%g units off", off);
        }
    }
}

/* What moves farther than the scene may reach is refused, by its name. */
static void beyond_the_span_is_refused(void **state)
{
    static const double end_m = 536870.9, low_m[3] = {-1, -1, -1}, high_m[3] = {1, 1, 1};
    static struct world world;
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .core = &core_fast,
                                            .coordinates = COORDINATES_32,
                                            .near_m = 1,
                                            .unlit = true};
    const struct moving_options movers = {.mode = MOVING_ON};
    const struct model_pose pose = {{1e12, 0, 0}, {0, 0, 0, 1}};
    struct compiled scene = {.moving = NULL};
    struct moving moving;
    struct error err = {""};
    (void)state;

    memset(&world, 0, sizeof world);
    boxes_add_room(&world.model, (double[3]){-end_m, -end_m, -end_m}, (double[3]){end_m, end_m, end_m});
    const size_t first = world.model.face_count;
    boxes_add_solid(&world.model, low_m, high_m);
    move_faces(&world, first, &pose);
    assert_false(moving_compile_model(&world.model, &options, &movers, &scene, &moving, &err));
    assert_string_equal(err.text, "node 'solid 1': it moves too far for coordinates of 32 bits; --movers off helps");
    moving_free(&moving);
    compiled_free(&scene);
}

/* Instances that the renderer cannot place are left out, and counted. */
static void what_has_no_place_is_left_out(void **state)
{
    static const double here_m[3];
    static struct world world;
    struct stage stage = {.scene = {.moving = NULL}};
    struct look look = {.lens = {.tan_x = 0.6, .tan_y = 0.6, .near_m = 0.05}};
    (void)state;

    make_corner(&world, here_m);
    open_stage(&stage, &world.model, &core_fast);
    look.viewpoint = (struct viewpoint){.eye_m = {2, 2, 2}};
    set_axes(&look);
    const struct lim_camera camera = camera_of(&stage, &look);
    struct lim_instance *instance = &stage.moving.instances[0];
    const struct lim_instance right = *instance;
    for (int k = 0; k < 5; k++) {
        *instance = right;
        if (k == 0) instance->origin[1] = 1 << 30;
        if (k == 1) instance->origin[2] = -(1 << 30) + 1, instance->at_q8[2] = -512;
        if (k == 2) *instance->coarser_bits = 15;
        if (k == 3) instance->finer_bits = 9;
        if (k == 4) instance->origin[0] = INT32_MIN;
        draw(&stage.ids, &camera);
        assert_int_equal(simulator_stats(&stage.ids.simulator)->movers.left_out, 1);
    }
    *instance = right;
    draw(&stage.ids, &camera);
    assert_int_equal(simulator_stats(&stage.ids.simulator)->movers.left_out, 0);
    close_stage(&stage);
}

/* The same objects as ones that deform: their planes are those of their corners. */
static void what_deforms_is_seen_where_it_is(void **state)
{
    static struct world world;
    struct random random = {31};
    struct verdict sum = {0};
    (void)state;

    for (int w = 0; w < 3; w++) {
        struct stage stage = {.scene = {.moving = NULL}};
        make_world(&world, &random, 8, 2);
        open_stage(&stage, &world.model, &core_fine);
        for (size_t i = 0; i < stage.moving.count; i += 2)
            stage.moving.instances[i].deforms = true;
        look_around(&stage, &world, 7u + (uint64_t)w, &sum);
        close_stage(&stage);
    }
    print_message("deforming: %zu of %zu wrong, %zu holes\n", sum.wrong, sum.pixels, sum.holes);
    assert_int_equal(sum.holes, 0);
    assert_true(sum.wrong * 2000 <= sum.pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worlds_of_2_6),
        cmocka_unit_test(worlds_of_2_12),
        cmocka_unit_test(worlds_of_2_22),
        cmocka_unit_test(worlds_with_planks),
        cmocka_unit_test(orders_and_memories_show_the_same),
        cmocka_unit_test(far_from_the_origin_it_is_as_near_it),
        cmocka_unit_test(keys_lead_through_the_whole_scene),
        cmocka_unit_test(beyond_the_span_is_refused),
        cmocka_unit_test(what_has_no_place_is_left_out),
        cmocka_unit_test(what_deforms_is_seen_where_it_is),
    };

    return cmocka_run_group_tests_name("what moves in scenes of many scales", tests, NULL, NULL);
}
