/* SPDX-License-Identifier: MIT
 *
 * Small frames of the scenes in sim/scenes, in every profile and by every method, and with what firmware can do beside:
 * their pixels and what they took are as in tests/golden_frames.expected. Other tests say which frames are right; this
 * one tells that a change which was to change none did. GOLDEN_FRAMES=write writes the file anew: what changes in it
 * is explained where it is committed. */
#include "camera_path.h"
#include "cmocka_ready.h"
#include "moving.h"
#include "simulator.h"
#include "texture_rig.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPECTED "tests/golden_frames.expected"

enum { W_PX = 88, H_PX = 64, FRAMES = 3, TEXT_B = 1 << 18 };

static const struct {
    const char *model, *cameras; /* no cameras: an orbit */
} scenes[] = {{"rooms.obj", "rooms.cam"},   {"rooms-tilted.obj", "rooms-tilted.cam"},
              {"teapot.obj", "teapot.cam"}, {"icosahedron.obj", NULL},
              {"glass.obj", "glass.cam"},   {"movers.gltf", "movers.cam"}};

enum special { PLAIN, ANTIALIAS, DELTA, WIREFRAME, FRAMEBUFFER };
static const struct {
    const char *name;
    enum lim_method method;
    enum special special;
} ways[] = {{"nearest", LIM_NEAREST_FIRST, PLAIN},
            {"painter", LIM_PAINTER, PLAIN},
            {"convex", LIM_CONVEX, PLAIN},
            {"scanline", LIM_SCANLINE, PLAIN},
            {"depth", LIM_DEPTH, PLAIN},
            {"newell", LIM_NEWELL, PLAIN},
            {"antialias", LIM_NEAREST_FIRST, ANTIALIAS},
            {"scanline-antialias", LIM_SCANLINE, ANTIALIAS},
            {"delta", LIM_NEAREST_FIRST, DELTA},
            {"scanline-delta", LIM_SCANLINE, DELTA},
            {"wireframe", LIM_NEAREST_FIRST, WIREFRAME},
            {"painter-wireframe", LIM_PAINTER, WIREFRAME},
            {"framebuffer", LIM_NEAREST_FIRST, FRAMEBUFFER}};

struct stage {
    struct model model; /* of a scene that is made here, with its mesh */
    struct mesh mesh;
    struct compiled scene;
    struct moving moving;
    struct camera_path path;
    struct lens lens;
};

static char *text;
static size_t used;

static void put(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(text + used, TEXT_B - used, format, arguments);
    va_end(arguments);
    assert_true(n > 0 && (size_t)n < TEXT_B - used);
    used += (size_t)n;
}

static void open_stage(struct stage *stage, const char *model, const char *cameras)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .tree = TREE_BSP,
                                            .core = &core_exact,
                                            .wireframe = true,
                                            .w_px = W_PX,
                                            .h_px = H_PX};
    const struct moving_options movers = {.mode = MOVING_CLIPPED};
    struct camera_path whole;
    char path[256];
    struct error err;

    memset(stage, 0, sizeof *stage);
    snprintf(path, sizeof path, "sim/scenes/%s", model);
    bool ok = moving_compile(path, &options, &movers, &stage->scene, &stage->moving, &err);
    if (ok) ok = lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), W_PX, H_PX, &err);
    snprintf(path, sizeof path, "sim/scenes/%s", cameras ? cameras : "");
    if (ok)
        ok = cameras ? camera_path_read(path, &whole, &err)
                     : camera_path_orbit(&stage->scene, &stage->lens, 16, &whole, &err);
    if (ok) ok = camera_path_few(&whole, FRAMES, &stage->path, &err);
    if (!ok) fail_msg("%s", err.text);
    camera_path_free(&whole);
}

/* A room with pictures on its walls, seen from inside. */
static void open_textured(struct stage *stage)
{
    static const struct viewpoint views[FRAMES] = {{{0.3, 0.2, 0.1}, {1, -0.4, -0.6}, 1},
                                                   {{-0.9, 0.1, 0.8}, {0.7, -0.8, -1}, 2},
                                                   {{0, 0.95, 0}, {0.1, -1, 0.2}, 3}};
    struct random random = {5};
    struct error err;

    memset(stage, 0, sizeof *stage);
    texture_rig_room(&stage->model, texture_rig_picture(&stage->model, 32, 16, &random), 2.5);
    stage->scene = texture_rig_compile(&stage->model, &stage->mesh, &core_exact);
    stage->path = (struct camera_path){.frames = malloc(sizeof views), .count = FRAMES};
    assert_non_null(stage->path.frames);
    memcpy(stage->path.frames, views, sizeof views);
    assert_true(lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), W_PX, H_PX, &err));
}

static void close_stage(struct stage *stage)
{
    camera_path_free(&stage->path);
    moving_free(&stage->moving);
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
    model_free(&stage->model);
}

/* Fowler, Noll and Vo's, of 32 bits. */
static uint32_t hash_of(uint32_t hash, const uint16_t *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ pixels[i]) * 16777619u;
    return hash;
}

/* Turns on what the way asks for. false: there is none of it with this method or scene. */
static bool begin(struct simulator *simulator, struct stage *stage, const struct core *core, size_t way)
{
    static const struct lim_wireframe wireframe = {.on = true};
    const enum special special = ways[way].special;
    const struct simulator_setup setup = {W_PX, H_PX, ways[way].method,
                                          special == FRAMEBUFFER ? SIMULATOR_FRAMEBUFFER : SIMULATOR_MEMORY, core};
    const bool walks = setup.method == LIM_NEAREST_FIRST || setup.method == LIM_PAINTER;
    struct error err;

    memset(simulator, 0, sizeof *simulator);
    if (stage->moving.count && !walks) return false;
    if (!simulator_init(simulator, &stage->scene.scene, &setup, &err)) return false;
    if (stage->moving.count &&
        !simulator_set_movers(simulator, stage->moving.instances, stage->moving.count, &stage->moving.limits, &err))
        return false;
    if (special == ANTIALIAS) return simulator_set_antialias(simulator, true, &err);
    if (special == DELTA) return simulator_set_delta(simulator, 4000, &err);
    if (special == WIREFRAME) simulator_set_wireframe(simulator, &wireframe);
    return true;
}

static void put_frames(struct simulator *simulator, struct stage *stage, const char *scene, size_t way)
{
    uint32_t hash = 2166136261u, sums[8] = {0};

    for (size_t frame = 0; frame < stage->path.count; frame++) {
        struct lim_camera camera;
        struct error err;
        if (stage->moving.count) moving_pose(&stage->moving, moving_time_s(&stage->moving, frame, FRAMES));
        if (!camera_path_to_camera(&stage->path, frame, &stage->lens, &stage->scene.grid, &camera, &err) ||
            !simulator_frame(simulator, &camera, &err))
            fail_msg("%s", err.text);
        const struct lim_stats *stats = simulator_stats(simulator);
        const uint32_t taken[] = {
            stats->polygons, stats->polygons_seen, stats->vertices,       stats->clipped,
            stats->lines,    stats->boxes_out,     stats->pixels_painted, stats->retained_cells_max};
        for (size_t i = 0; i < sizeof taken / sizeof *taken; i++)
            sums[i] += taken[i];
        hash = hash_of(hash, simulator->pixels, simulator_pixel_count(simulator));
    }
    put("%s %s %s: %08x", scene, simulator->core->name, ways[way].name, hash);
    if (ways[way].method != LIM_NEWELL) /* whose counts are for test_newell.c to bound */
        put(", polygons %u, seen %u, vertices %u, clipped %u, lines %u, boxes out %u, pixels %u, cells %u", sums[0],
            sums[1], sums[2], sums[3], sums[4], sums[5], sums[6], sums[7]);
    put("\n");
}

static void put_scene(const char *name, struct stage *stage)
{
    for (size_t k = 0; cores[k]; k++)
        for (size_t way = 0; cores[k]->is_profile && way < sizeof ways / sizeof *ways; way++) {
            struct simulator simulator;
            if (begin(&simulator, stage, cores[k], way)) put_frames(&simulator, stage, name, way);
            simulator_free(&simulator);
        }
    close_stage(stage);
}

static void write_expected(void)
{
    FILE *file = fopen(EXPECTED, "w");

    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, used, file), used);
    assert_int_equal(fclose(file), 0);
}

static void frames_are_what_they_were(void **state)
{
    const char *asked = getenv("GOLDEN_FRAMES"), *at;
    char line[512];

    (void)state;
    text = malloc(TEXT_B);
    assert_non_null(text);
    text[0] = '\0';
    struct stage stage;
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        open_stage(&stage, scenes[i].model, scenes[i].cameras);
        put_scene(scenes[i].model, &stage);
    }
    open_textured(&stage);
    put_scene("textured", &stage);
    if (asked && strcmp(asked, "write") == 0) write_expected();
    FILE *file = fopen(EXPECTED, "r");
    assert_non_null(file);
    for (at = text; fgets(line, sizeof line, file); at += strlen(line))
        if (strncmp(at, line, strlen(line)) != 0)
            fail_msg("expected: %sbut it is: %.*s", line, (int)strcspn(at, "\n"), at);
    assert_int_equal(*at, 0);
    fclose(file);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(frames_are_what_they_were)};

    return cmocka_run_group_tests_name("golden_frames", tests, NULL, NULL);
}
