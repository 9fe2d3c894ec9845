/* SPDX-License-Identifier: MIT
 *
 * Scenes are compiled once for all golden tests' sizes: limits are for the golden frames'. */
#include "golden_stage.h"

#include "compiler/compile_mesh.h"
#include "compiler/moving_compile.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "rigs/texture_rig.h"
#include "scene/method.h"
#include "scene/moving.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_B = 1 << 18, SIDES = 26, FEWER_SIDES = 18 };

static const struct {
    const char *name, *model, *cameras; /* no cameras: an orbit */
    enum portals_wanted portals;
} scenes[] = {{"rooms.obj", "rooms.obj", "rooms.cam", PORTALS_OFF},
              {"rooms-tilted.obj", "rooms-tilted.obj", "rooms-tilted.cam", PORTALS_OFF},
              {"teapot.obj", "teapot.obj", "teapot.cam", PORTALS_OFF},
              {"icosahedron.obj", "icosahedron.obj", NULL, PORTALS_OFF},
              {"glass.obj", "glass.obj", "glass.cam", PORTALS_OFF},
              {"movers.gltf", "movers.gltf", "movers.cam", PORTALS_OFF},
              {"rooms-places", "rooms.obj", "rooms.cam", PORTALS_ON}};
enum { SCENES = sizeof scenes / sizeof *scenes };

const struct golden_way golden_ways[] = {{"nearest", LIM_NEAREST_FIRST, GOLDEN_PLAIN},
                                         {"painter", LIM_PAINTER, GOLDEN_PLAIN},
                                         {"convex", LIM_CONVEX, GOLDEN_PLAIN},
                                         {"scanline", LIM_SCANLINE, GOLDEN_PLAIN},
                                         {"depth", LIM_DEPTH, GOLDEN_PLAIN},
                                         {"newell", LIM_NEWELL, GOLDEN_PLAIN},
                                         {"antialias", LIM_NEAREST_FIRST, GOLDEN_ANTIALIAS},
                                         {"scanline-antialias", LIM_SCANLINE, GOLDEN_ANTIALIAS},
                                         {"delta", LIM_NEAREST_FIRST, GOLDEN_DELTA},
                                         {"scanline-delta", LIM_SCANLINE, GOLDEN_DELTA},
                                         {"wireframe", LIM_NEAREST_FIRST, GOLDEN_WIREFRAME},
                                         {"painter-wireframe", LIM_PAINTER, GOLDEN_WIREFRAME},
                                         {"framebuffer", LIM_NEAREST_FIRST, GOLDEN_FRAMEBUFFER},
                                         {"painter-framebuffer", LIM_PAINTER, GOLDEN_FRAMEBUFFER},
                                         {"depth-antialias", LIM_DEPTH, GOLDEN_ANTIALIAS},
                                         {"newell-antialias", LIM_NEWELL, GOLDEN_ANTIALIAS},
                                         {"newell-wireframe", LIM_NEWELL, GOLDEN_WIREFRAME},
                                         {"convex-wireframe", LIM_CONVEX, GOLDEN_WIREFRAME},
                                         {"convex-delta", LIM_CONVEX, GOLDEN_DELTA},
                                         {"newell-delta", LIM_NEWELL, GOLDEN_DELTA},
                                         {NULL, LIM_NEAREST_FIRST, GOLDEN_PLAIN}};

/* Scenes ------------------------------------------------------------------------------------- */

static void open_file(struct golden_stage *stage, const char *model, const char *cameras, enum portals_wanted portals)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .tree = TREE_BSP,
                                            .core = &core_exact,
                                            .wireframe = true,
                                            .portals = portals,
                                            .w_px = GOLDEN_W_PX,
                                            .h_px = GOLDEN_H_PX};
    const struct moving_options movers = {.mode = MOVING_ON};
    struct camera_path whole;
    char path[256];
    struct error err;

    snprintf(path, sizeof path, "sim/scenes/%s", model);
    bool ok = moving_compile(path, &options, &movers, &stage->scene, &stage->moving, &err);
    if (ok) ok = lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), GOLDEN_W_PX, GOLDEN_H_PX, &err);
    stage->lens.least_side_px = SMALL_SIDE_PX + 1; /* the orbit of larger pictures */
    snprintf(path, sizeof path, "sim/scenes/%s", cameras ? cameras : "");
    if (ok)
        ok = cameras ? camera_path_read(path, &whole, &err)
                     : camera_path_orbit(&stage->scene, &stage->lens, 16, &whole, &err);
    if (ok) ok = camera_path_few(&whole, GOLDEN_FRAMES, &stage->path, &err);
    if (!ok) fail_msg("%s", err.text);
    camera_path_free(&whole);
}

/* A room with pictures on its walls, seen from inside. */
static void open_textured(struct golden_stage *stage)
{
    static const struct viewpoint views[GOLDEN_FRAMES] = {{{0.3, 0.2, 0.1}, {1, -0.4, -0.6}, 1, false, 0},
                                                          {{-0.9, 0.1, 0.8}, {0.7, -0.8, -1}, 2, false, 0},
                                                          {{0, 0.95, 0}, {0.1, -1, 0.2}, 3, false, 0}};
    struct random random = {5};
    struct error err;

    texture_rig_room(&stage->model, texture_rig_picture(&stage->model, 32, 16, &random), 2.5);
    stage->scene = texture_rig_compile(&stage->model, &stage->mesh, &core_exact);
    stage->path = (struct camera_path){.frames = malloc(sizeof views), .count = GOLDEN_FRAMES};
    assert_non_null(stage->path.frames);
    memcpy(stage->path.frames, views, sizeof views);
    assert_true(lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), GOLDEN_W_PX, GOLDEN_H_PX, &err));
}

/* A solid with pictures on its faces, seen from outside. */
static void open_crate(struct golden_stage *stage)
{
    static const struct viewpoint views[GOLDEN_FRAMES] = {{{2.1, 1.7, 3.4}, {0, 0, 0}, 1, false, 0},
                                                          {{-1.4, 0.3, 1.2}, {0.1, 0, -0.2}, 2, false, 0},
                                                          {{0, -3.2, -2.2}, {0.3, 0.1, 0}, 3, false, 0}};
    static const double uvs[4][2] = {{0, 0}, {1.5, 0}, {1.5, 1}, {0, 1}};
    struct random random = {6};
    struct error err;

    const uint32_t picture = texture_rig_picture(&stage->model, 32, 32, &random);
    for (int axis = 0; axis < 3; axis++)
        for (int side = -1; side <= 1; side += 2) {
            double places[4][3];
            for (int k = 0; k < 4; k++) {
                places[k][axis] = side;
                places[k][(axis + 1) % 3] = (k == 1 || k == 2) ? side : -side;
                places[k][(axis + 2) % 3] = k >= 2 ? 1 : -1;
            }
            texture_rig_face(&stage->model, picture, 4, (const double(*)[3])places, uvs);
        }
    stage->scene = texture_rig_compile(&stage->model, &stage->mesh, &core_exact);
    stage->path = (struct camera_path){.frames = malloc(sizeof views), .count = GOLDEN_FRAMES};
    assert_non_null(stage->path.frames);
    memcpy(stage->path.frames, views, sizeof views);
    assert_true(lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), GOLDEN_W_PX, GOLDEN_H_PX, &err));
}

/* A prism around the z axis, turned about y. */
static void add_prism(struct mesh *mesh, int sides, double turn, double half_m)
{
    double rim_m[2][SIDES][3];

    for (int i = 0; i < sides; i++)
        for (int end = 0; end < 2; end++) {
            const double angle = 6.283185307179586 * i / sides * (end ? 1 : -1);
            const double x = cos(angle), y = sin(angle), z = end ? half_m : -half_m;
            rim_m[end][i][0] = x * cos(turn) + z * sin(turn);
            rim_m[end][i][1] = y;
            rim_m[end][i][2] = z * cos(turn) - x * sin(turn);
        }
    mesh_rig_add(mesh, rim_m[0], (size_t)sides);
    mesh_rig_add(mesh, rim_m[1], (size_t)sides);
    for (int i = 0; i < sides; i++) {
        const int k = (i + 1) % sides;
        double side_m[4][3];
        memcpy(side_m[0], rim_m[1][i], sizeof side_m[0]);
        memcpy(side_m[1], rim_m[0][(sides - i) % sides], sizeof side_m[0]);
        memcpy(side_m[2], rim_m[0][(sides - k) % sides], sizeof side_m[0]);
        memcpy(side_m[3], rim_m[1][k], sizeof side_m[0]);
        mesh_rig_add(mesh, (const double(*)[3])side_m, 4);
    }
}

/* Polygons of many corners, some of whose edges are cuts, which wireframe does not draw. */
static void open_prisms(struct golden_stage *stage, int count)
{
    static const struct viewpoint views[GOLDEN_FRAMES] = {{{2.1, 1.2, 3.4}, {0, 0, 0}, 1, false, 0},
                                                          {{-0.4, 0.3, 1.3}, {0.1, 0, -0.2}, 2, false, 0},
                                                          {{0, -0.2, -2.2}, {0.3, 0.1, 0}, 3, false, 0}};
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .tree = TREE_BSP,
                                            .core = &core_exact,
                                            .wireframe = true,
                                            .w_px = GOLDEN_W_PX,
                                            .h_px = GOLDEN_H_PX};
    struct error err;

    stage->mesh = mesh_rig(3000.0);
    add_prism(&stage->mesh, SIDES, 0.2, 0.4);
    if (count > 1) add_prism(&stage->mesh, FEWER_SIDES, 1.1, 0.3);
    if (!compile_mesh(&stage->mesh, &options, &stage->scene, &err)) fail_msg("%s", err.text);
    stage->path = (struct camera_path){.frames = malloc(sizeof views), .count = GOLDEN_FRAMES};
    assert_non_null(stage->path.frames);
    memcpy(stage->path.frames, views, sizeof views);
    assert_true(lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), GOLDEN_W_PX, GOLDEN_H_PX, &err));
}

/* A square that many triangles go through, along the tangents of a circle. */
static void add_disc(struct mesh *mesh)
{
    static const double square_m[4][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    enum { CUTS = 28 };

    mesh_rig_add(mesh, square_m, 4);
    for (int i = 0; i < CUTS; i++) {
        const double angle = 6.283185307179586 * (i * 11 % CUTS + 0.5) / CUTS, x = cos(angle), y = sin(angle);
        const double corners_m[3][3] = {{x + 0.3 * y, y - 0.3 * x, 0.3}, {x - 0.3 * y, y + 0.3 * x, 0.3}, {x, y, -0.4}};
        mesh_rig_add(mesh, corners_m, 3);
    }
}

/* Polygons in leaves: in one, in no order, or in some. */
static void open_leaves(struct golden_stage *stage, bool is_disc, enum tree_kind tree)
{
    static const struct viewpoint views[GOLDEN_FRAMES] = {{{2.1, 1.2, 3.4}, {0, 0, 0}, 1, false, 0},
                                                          {{-0.4, 0.3, 2.3}, {0.1, 0, -0.2}, 2, false, 0},
                                                          {{6, -9.2, -7.2}, {0.3, 0.1, 0}, 3, false, 0}};
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .method = method_parse("newell", NULL),
                                            .splitter = "fewest",
                                            .tree = tree,
                                            .core = &core_exact,
                                            .w_px = GOLDEN_W_PX,
                                            .h_px = GOLDEN_H_PX};
    struct random random = {8};
    struct error err;

    stage->is_set = tree == TREE_NONE;
    stage->mesh = mesh_rig(is_disc ? 3000.0 : 900.0);
    if (is_disc)
        add_disc(&stage->mesh);
    else
        mesh_rig_solids(&stage->mesh, &random, 7);
    for (size_t i = 0; i < stage->mesh.polygon_count; i++) {
        stage->mesh.polygons[i].colour = (uint32_t)(i * 0x3A5F17) & 0xFFFFFF;
        if (i % 3 == 2) stage->mesh.polygons[i].transparency = (uint8_t)(40 + i % 5 * 40);
    }
    if (!compile_mesh(&stage->mesh, &options, &stage->scene, &err)) fail_msg("%s", err.text);
    stage->path = (struct camera_path){.frames = malloc(sizeof views), .count = GOLDEN_FRAMES};
    assert_non_null(stage->path.frames);
    memcpy(stage->path.frames, views, sizeof views);
    assert_true(lens_init(&stage->lens, 70, lens_default_near_m(&stage->scene.grid), GOLDEN_W_PX, GOLDEN_H_PX, &err));
}

bool golden_open(struct golden_stage *stage, size_t scene)
{
    static const char *const made[] = {"textured", "prism", "prisms", "crate", "disc", "solids", "solids in clusters"};

    if (scene > SCENES + 6) return false;
    memset(stage, 0, sizeof *stage);
    stage->name = scene < SCENES ? scenes[scene].name : made[scene - SCENES];
    if (scene < SCENES)
        open_file(stage, scenes[scene].model, scenes[scene].cameras, scenes[scene].portals);
    else if (scene == SCENES)
        open_textured(stage);
    else if (scene == SCENES + 3)
        open_crate(stage);
    else if (scene > SCENES + 3)
        open_leaves(stage, scene == SCENES + 4, scene == SCENES + 6 ? TREE_CLUSTERS : TREE_NONE);
    else
        open_prisms(stage, (int)(scene - SCENES));
    return true;
}

void golden_close(struct golden_stage *stage)
{
    camera_path_free(&stage->path);
    moving_free(&stage->moving);
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
    model_free(&stage->model);
}

/* Ways --------------------------------------------------------------------------------------- */

bool golden_turn_on(struct simulator *simulator, struct golden_stage *stage, const struct golden_way *way)
{
    static const struct lim_wireframe wireframe = {.on = true};
    struct error err;

    if (stage->moving.count &&
        !simulator_set_movers(simulator, stage->moving.instances, stage->moving.count, &stage->moving.limits, &err))
        return false;
    if (way->special == GOLDEN_ANTIALIAS) return simulator_set_antialias(simulator, true, &err);
    if (way->special == GOLDEN_DELTA) return simulator_set_delta(simulator, 4000, &err);
    if (way->special == GOLDEN_WIREFRAME) simulator_set_wireframe(simulator, &wireframe);
    return true;
}

bool golden_begin(struct simulator *simulator, struct golden_stage *stage, const struct core *core,
                  const struct golden_way *way, unsigned w_px, unsigned h_px)
{
    const struct simulator_setup setup = {
        w_px, h_px, way->method, way->special == GOLDEN_FRAMEBUFFER ? SIMULATOR_FRAMEBUFFER : SIMULATOR_MEMORY, core};
    const bool moves = setup.method == LIM_NEAREST_FIRST || setup.method == LIM_SCANLINE;
    const bool sorts = setup.method == LIM_DEPTH || setup.method == LIM_NEWELL;
    struct error err;

    memset(simulator, 0, sizeof *simulator);
    if (stage->moving.count && !moves) return false;
    if (stage->is_set && !sorts) return false;
    return simulator_init(simulator, &stage->scene.scene, &setup, &err) && golden_turn_on(simulator, stage, way);
}

/* What came of it ---------------------------------------------------------------------------- */

uint32_t golden_hash(uint32_t hash, const void *bytes, size_t count)
{
    const uint8_t *at = bytes;

    for (size_t i = 0; i < count; i++)
        hash = (hash ^ at[i]) * 16777619u;
    return hash;
}

uint32_t golden_hash_frame(uint32_t hash, const struct simulator *simulator)
{
    const size_t count = simulator_pixel_count(simulator);

    for (size_t i = 0; i < count; i++)
        hash = (hash ^ simulator->pixels[i]) * 16777619u;
    return hash;
}

static char text[TEXT_B];
static size_t used;

void golden_put(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(text + used, sizeof text - used, format, arguments);
    va_end(arguments);
    assert_true(n > 0 && (size_t)n < sizeof text - used);
    used += (size_t)n;
}

static void write_expected(const char *path)
{
    FILE *file = fopen(path, "w");

    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, used, file), used);
    assert_int_equal(fclose(file), 0);
}

void golden_compare(const char *path)
{
    const char *asked = getenv("GOLDEN_FRAMES"), *at;
    char line[512];

    if (asked && strcmp(asked, "write") == 0) write_expected(path);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    for (at = text; fgets(line, sizeof line, file); at += strlen(line))
        if (strncmp(at, line, strlen(line)) != 0)
            fail_msg("expected: %sbut it is: %.*s", line, (int)strcspn(at, "\n"), at);
    assert_int_equal(*at, 0);
    fclose(file);
}
