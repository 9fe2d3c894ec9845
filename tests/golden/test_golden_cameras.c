/* SPDX-License-Identifier: MIT
 *
 * Small frames from hostile cameras: eyes at vertices, beside them and far out, angles on the axes and a hair off,
 * every lens, near planes from the nearest to the farthest. Codes, pixels, all statistics and what frames leave in
 * memory are as in tests/golden/golden_cameras.expected; a frame in parts is the same as a frame at once.
 * tests/extremes/test_extreme_*.c say what is right; this tells that a change which was to change nothing did.
 * GOLDEN_FRAMES=write writes the file anew. */
#include "core/core.h"
#include "golden_state.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"
#include "scene/moving.h"

#include <string.h>

enum { CAMERAS = 12, CAMERAS_WITH_MOVERS = 36, MOVERS_MAX = 16 };

static const struct {
    unsigned w_px, h_px;
} sizes[] = {{41, 19}, {16, 37}, {64, 8}};

/* Of movers: off, and from two sides. */
static const struct lim_light lights[] = {
    {.on = false}, {true, {9459, -9459, 9459}, 130, 126}, {true, {-3277, 15000, 5716}, 60, 196}};

static const struct lim_newell_options orders[] = {
    {.most = 0}, {.planes_first = true}, {.split_one = true}, {.planes_first = true, .split_one = true, .most = 150}};

static int32_t near_of(struct random *random)
{
    switch (random_u64(random) % 4) {
    case 0:
        return 1;
    case 1:
        return INT32_C(1) << random_in(random, 0, 24);
    default:
        return (int32_t)random_in(random, 256, 16 * 256);
    }
}

/* At a vertex or off it, by some units of 1/256 to some hundred units. */
static struct lim_camera camera_near(const struct lim_scene *scene, struct random *random)
{
    const struct lim_vertex at = scene->vertices[random_u64(random) % scene->vertex_count];
    const int64_t off_q8 = INT64_C(1) << random_in(random, 0, random_u64(random) % 8 ? 18 : 27);
    struct lim_camera camera = {.near_q8 = near_of(random)};
    const int32_t vertex[3] = {at.x, at.y, at.z};

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = vertex[i] * 256 + (int32_t)(random_u64(random) % 4 ? random_in(random, -off_q8, off_q8) : 0);
    camera.yaw = random_angle(random);
    camera.pitch = random_angle(random);
    camera.roll = random_angle(random);
    camera.tan_x_q28 = random_tan_q28(random);
    camera.tan_y_q28 = random_u64(random) % 2 ? camera.tan_x_q28 : random_tan_q28(random);
    return camera;
}

/* Movers as they are posed, but one: turned anyhow, of a finer unit, or far off; or all of them deforming. */
static void pose(struct moving *moving, int i, struct random *random)
{
    struct lim_instance *one = &moving->instances[random_u64(random) % moving->count];

    moving_pose(moving, moving_time_s(moving, (size_t)i, CAMERAS));
    for (size_t k = 0; k < moving->count; k++)
        moving->instances[k].deforms = i % 4 == 2;
    if (i % 3 == 1) {
        const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);
        lim_instance_turn(one, yaw, pitch, roll);
    }
    if (i % 5 == 3) one->finer_bits = (uint8_t)random_in(random, 0, 3);
    if (i % 6 == 4) {
        const size_t axis = random_u64(random) % 3;
        one->at_q8[axis] += (int32_t)random_in(random, -(1 << 23), 1 << 23);
    }
}

/* Of the cameras behind the first ones: all of them anyhow, close together, so that they meet. */
static void pose_anyhow(struct moving *moving, struct random *random)
{
    int32_t at_q8[3];

    memcpy(at_q8, moving->instances[random_u64(random) % moving->count].at_q8, sizeof at_q8);
    for (size_t k = 0; k < moving->count; k++) {
        struct lim_instance *one = &moving->instances[k];
        const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);
        lim_instance_turn(one, yaw, pitch, roll);
        one->finer_bits = (uint8_t)random_in(random, 0, 3);
        one->deforms = random_u64(random) % 4 == 0;
        for (int i = 0; i < 3 && random_u64(random) % 4; i++)
            one->at_q8[i] = at_q8[i] + (int32_t)random_in(random, -40 * 256, 40 * 256);
    }
}

static uint32_t texel_hash;

static void take_texel(void *ctx, const struct core_texel_at *at)
{
    const int32_t place[] = {at->x_px,       at->y_px,   (int32_t)(at->uv[0] * 65536), (int32_t)(at->uv[1] * 65536),
                             (int)at->level, at->divided};

    (void)ctx;
    texel_hash = golden_hash(texel_hash, place, sizeof place);
}

/* Of every record the texel at each pixel, whatever hides it. */
static uint32_t hash_of_texels(const struct simulator *simulator, uint32_t hash)
{
    const struct lim_scene *scene = simulator->scene;

    texel_hash = hash;
    for (lim_index at = 0; scene->texture_count && at < scene->polygon_words;
         at += lim_record_words(scene->polygons[at]))
        simulator->core->texels(simulator->lim, at, take_texel, NULL);
    return texel_hash;
}

static int draw_in_parts(struct simulator *simulator, const struct lim_camera *camera)
{
    const struct core *core = simulator->core;
    const int code = core->begin(simulator->lim, camera, simulator->instances, simulator->instance_count);

    if (code) return code;
    while (core->work(simulator->lim))
        continue;
    return core->paint(simulator->lim);
}

static uint32_t hash_of(const struct simulator *simulator, int code)
{
    const struct lim_stats *stats = simulator_stats(simulator);
    const uint32_t hash = golden_hash(GOLDEN_HASH, &code, sizeof code);

    return code ? hash : golden_hash(golden_hash_frame(hash, simulator), stats, sizeof *stats);
}

static void put_way(struct simulator *simulator, struct golden_stage *stage, const struct golden_way *way)
{
    const size_t movers = stage->moving.count;
    struct lim_instance kept[MOVERS_MAX];
    uint32_t all = GOLDEN_HASH, memory = GOLDEN_HASH;
    struct random random = {77};

    assert_true(movers <= MOVERS_MAX);
    if (movers) memcpy(kept, stage->moving.instances, movers * sizeof *kept);
    golden_put("%s %s %s:", stage->name, simulator->core->name, way->name);
    for (int i = 0; i < (movers ? CAMERAS_WITH_MOVERS : CAMERAS); i++) {
        const struct lim_camera camera = camera_near(&stage->scene.scene, &random);
        if (movers) {
            memcpy(stage->moving.instances, kept, movers * sizeof *kept);
            pose(&stage->moving, i, &random);
            if (i >= CAMERAS) pose_anyhow(&stage->moving, &random);
            simulator->core->light(simulator->lim, &lights[i % 3]);
        }
        if (way->method == LIM_NEWELL) simulator->core->newell(simulator->lim, &orders[i % 4]);
        const int code = simulator_draw(simulator, &camera);
        const uint32_t hash = hash_of(simulator, code), left = code ? 0 : golden_state(simulator);
        memory = golden_hash(memory, &left, sizeof left);
        if (!code && golden_ways[0].name == way->name) memory = hash_of_texels(simulator, memory);
        if (way->special != GOLDEN_DELTA) assert_int_equal(hash_of(simulator, draw_in_parts(simulator, &camera)), hash);
        if (way->special == GOLDEN_DELTA && i % 2) { /* nothing changes */
            const uint32_t again = hash_of(simulator, simulator_draw(simulator, &camera));
            all = golden_hash(all, &again, sizeof again);
        }
        all = golden_hash(all, &hash, sizeof hash);
        if (i % 6 == 5) golden_put(" %08x", all);
    }
    golden_put(", memory %08x\n", memory);
    if (movers) memcpy(stage->moving.instances, kept, movers * sizeof *kept);
}

static void put_scene(struct golden_stage *stage)
{
    for (size_t k = 0; cores[k]; k++)
        for (size_t i = 0; golden_ways[i].name; i++) {
            const size_t size = (i + k) % (sizeof sizes / sizeof *sizes);
            struct simulator simulator;
            if (golden_begin(&simulator, stage, cores[k], &golden_ways[i], sizes[size].w_px, sizes[size].h_px)) {
                golden_state_clear(&simulator, stage);
                put_way(&simulator, stage, &golden_ways[i]);
            }
            simulator_free(&simulator);
        }
}

static void from_anywhere_frames_are_what_they_were(void **state)
{
    struct golden_stage stage;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        put_scene(&stage);
        golden_close(&stage);
    }
    golden_compare("tests/golden/golden_cameras.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(from_anywhere_frames_are_what_they_were)};

    return cmocka_run_group_tests_name("golden_cameras", tests, NULL, NULL);
}
