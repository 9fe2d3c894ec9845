/* SPDX-License-Identifier: MIT
 *
 * Hidden-line wireframe: which pixels of a polygon are stroked, exactly; that no edge is drawn which only the compiler
 * or clipping made; that every order of drawing, and any memory, paints the same. */
#include "compiler/compile_mesh.h"
#include "limner.h"
#include "render/simulator.h"
#include "rigs/closed_scene.h"
#include "rigs/cmocka_ready.h"
#include "rigs/convex_rig.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/tiny_model.h"
#include "scene/compiled.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 100, H_PX = 80, PIXELS = W_PX * H_PX, LINE = 0xFFFF, BACKGROUND = 0x0000 };
static const double NEAR_M = 0.1;
static const struct lim_wireframe WHITE = {.on = true, .one_colour = true, .colour = LINE, .background = BACKGROUND};
static const struct lim_wireframe OFF = {.on = false};

/* Pictures ----------------------------------------------------------------------------------- */

struct stage {
    struct mesh mesh;
    struct compiled scene;
    struct lens lens;
};

static void compile(struct stage *stage, const char *splitter, bool wireframe, const struct core *core)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = splitter, .wireframe = wireframe, .core = core};
    struct error err;

    if (!mesh_insert_t_vertices(&stage->mesh, &err) || !compile_mesh(&stage->mesh, &options, &stage->scene, &err) ||
        !lens_init(&stage->lens, 60, NEAR_M, W_PX, H_PX, &err))
        fail_msg("%s", err.text);
}

static void stage_close(struct stage *stage)
{
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
}

static struct lim_camera camera_at(const struct stage *stage, struct viewpoint viewpoint)
{
    const struct camera_path path = {"wireframe", &viewpoint, 1};
    struct lim_camera camera;
    struct error err;

    if (!camera_path_to_camera(&path, 0, &stage->lens, &stage->scene.grid, &camera, &err)) fail_msg("%s", err.text);
    return camera;
}

struct drawing {
    uint16_t pixels[PIXELS];
    struct lim_stats stats;
};

static void draw(const struct stage *stage, const struct core *core, enum lim_method method,
                 const struct lim_wireframe *wireframe, const struct lim_camera *camera, struct drawing *out)
{
    const struct simulator_setup setup = {W_PX, H_PX, method, SIMULATOR_MEMORY, core};
    struct simulator simulator;
    struct error err;

    if (!simulator_init(&simulator, &stage->scene.scene, &setup, &err)) fail_msg("%s", err.text);
    simulator_set_wireframe(&simulator, wireframe);
    assert_true(simulator_frame(&simulator, camera, &err));
    memcpy(out->pixels, simulator.pixels, sizeof out->pixels);
    out->stats = *simulator_stats(&simulator);
    simulator_free(&simulator);
}

/* One polygon ------------------------------------------------------------------------------------ */

/* Corners of a polygon in the plane z = 0, around the origin; some of them on level or upright lines. */
static void random_polygon(struct mesh *mesh, struct random *random)
{
    const size_t count = (size_t)random_in(random, 3, 8);
    const double flat = random_in(random, 0, 2) ? 0.2 + random_unit(random) : 0.01;
    const double turn = random_in(random, 0, 1) ? 6.2832 * random_unit(random) : 0.7853981633974483;
    double corners[8][3];

    for (size_t i = 0; i < count; i++) {
        const double angle = turn + 6.283185307179586 * ((double)i + 0.6 * random_unit(random)) / (double)count;
        corners[i][0] = cos(angle);
        corners[i][1] = flat * sin(angle);
        corners[i][2] = 0;
    }
    mesh_rig_add(mesh, (const double(*)[3])corners, count)->colour = 0x808080;
}

static bool is_covered(const struct drawing *filled, int x, int y)
{
    return filled->pixels[y * W_PX + x] != BACKGROUND;
}

/* Pixels whose neighbours are all on the screen. Returns how many are stroked. */
static size_t assert_outline(const struct drawing *filled, const struct drawing *wire)
{
    size_t stroked = 0;

    for (int y = 1; y + 1 < H_PX; y++)
        for (int x = 1; x + 1 < W_PX; x++) {
            const bool is_edge =
                is_covered(filled, x, y) && !(is_covered(filled, x - 1, y) && is_covered(filled, x + 1, y) &&
                                              is_covered(filled, x, y - 1) && is_covered(filled, x, y + 1));
            assert_int_equal(wire->pixels[y * W_PX + x], is_edge ? LINE : BACKGROUND);
            stroked += is_edge;
        }
    return stroked;
}

static void a_pixel_is_stroked_where_a_neighbour_is_not_the_polygons(void **state)
{
    const int polygons = effort(30) < 6 ? 6 : effort(30);
    struct random random = {1963};
    size_t stroked = 0;

    (void)state;
    for (int p = 0; p < polygons; p++) {
        struct stage stage = {.mesh = mesh_rig(3000.0)};
        random_polygon(&stage.mesh, &random);
        compile(&stage, "auto", true, NULL);
        for (int f = 0; f < 30; f++) {
            static struct drawing filled, wire;
            struct viewpoint viewpoint = {{0}, {0}, 1, false, 0};
            for (int k = 0; k < 3; k++) {
                viewpoint.eye_m[k] = 2 * random_unit(&random) - 1 + (k == 2 ? 2.5 : 0);
                viewpoint.target_m[k] = 0.4 * random_unit(&random) - 0.2;
            }
            struct lim_camera camera = camera_at(&stage, viewpoint);
            if (f % 2) camera.roll = (uint32_t)random_u64(&random);
            draw(&stage, NULL, LIM_NEAREST_FIRST, &OFF, &camera, &filled);
            draw(&stage, NULL, LIM_NEAREST_FIRST, &WHITE, &camera, &wire);
            if (filled.stats.clipped || filled.stats.non_monotone) continue;
            stroked += assert_outline(&filled, &wire);
        }
        stage_close(&stage);
    }
    assert_true(stroked > 50000u * (unsigned)polygons / 30);
}

/* Edges of the model and others -------------------------------------------------------------- */

/* Where the lines of a picture may be: edges, and how far from them lines are. */
struct segments {
    double ends[64][2][2]; /* pixels */
    size_t count;
};

static void project(const struct stage *stage, const struct viewpoint *viewpoint, const double at_m[3], double px[2])
{
    struct view_axes axes;
    double d[3], u = 0, v = 0, w = 0;

    viewpoint_axes(viewpoint, &axes);
    for (int k = 0; k < 3; k++)
        d[k] = at_m[k] - viewpoint->eye_m[k];
    for (int k = 0; k < 3; k++)
        u += d[k] * axes.right[k], v += d[k] * axes.up[k], w += d[k] * axes.forward[k];
    assert_true(w > NEAR_M);
    px[0] = (u / w / stage->lens.tan_x + 1) / 2 * W_PX - 0.5;
    px[1] = (1 - v / w / stage->lens.tan_y) / 2 * H_PX - 0.5;
}

static double distance_px(const double a[2], const double b[2], double x, double y)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const double t = square > 0 ? fmin(1, fmax(0, ((x - a[0]) * dx + (y - a[1]) * dy) / square)) : 0;

    return hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

/* Line pixels farther than this from all segments, and lines of segments that are not there. */
struct astray {
    size_t lines, far, missing;
};

static struct astray compare(const struct drawing *picture, const struct segments *segments)
{
    static const double NEAR_PX = 1.5;
    struct astray astray = {0};

    for (int i = 0; i < PIXELS; i++) {
        if (picture->pixels[i] != LINE) continue;
        double least = INFINITY;
        for (size_t k = 0; k < segments->count; k++)
            least = fmin(least, distance_px(segments->ends[k][0], segments->ends[k][1], i % W_PX, i / W_PX));
        astray.lines++;
        astray.far += least > NEAR_PX;
    }
    for (size_t k = 0; k < segments->count; k++) {
        const double *a = segments->ends[k][0], *b = segments->ends[k][1];
        for (double t = 0.06; t < 0.95; t += 0.02) /* a sharp corner may hold no pixel's centre */ {
            const double x = a[0] + t * (b[0] - a[0]), y = a[1] + t * (b[1] - a[1]);
            bool found = false;
            for (int i = 0; i < PIXELS && !found; i++)
                found = picture->pixels[i] == LINE && hypot(i % W_PX - x, i / W_PX - y) <= NEAR_PX;
            astray.missing += !found;
        }
    }
    return astray;
}

static void add_segment(struct segments *segments, const struct stage *stage, const struct viewpoint *viewpoint,
                        const double a_m[3], const double b_m[3])
{
    project(stage, viewpoint, a_m, segments->ends[segments->count][0]);
    project(stage, viewpoint, b_m, segments->ends[segments->count++][1]);
}

static struct astray astray_in(const struct stage *stage, const struct viewpoint *viewpoint,
                               const double (*edges)[2][3], size_t count)
{
    static struct drawing picture;
    struct segments segments = {.count = 0};
    const struct lim_camera camera = camera_at(stage, *viewpoint);

    for (size_t i = 0; i < count; i++)
        add_segment(&segments, stage, viewpoint, edges[i][0], edges[i][1]);
    draw(stage, NULL, LIM_NEAREST_FIRST, &WHITE, &camera, &picture);
    return compare(&picture, &segments);
}

/* Of the 12 edges of a cube 9 are seen from before a corner, here (1, 1, 1): all but those at (-1, -1, -1). */
static void a_cube_has_nine_edges(void **state)
{
    const struct viewpoint viewpoint = {{3.1, 2.6, 3.9}, {0, 0, 0}, 1, false, 0};
    const double centre[3] = {0, 0, 0}, half[3] = {1, 1, 1};
    struct stage stage = {.mesh = mesh_rig(3000.0)};
    double edges[12][2][3];
    size_t count = 0;

    (void)state;
    mesh_rig_box(&stage.mesh, centre, half, 0, 0);
    compile(&stage, "auto", true, NULL);
    for (int axis = 0; axis < 3; axis++)
        for (int side = 1; side < 4; side++) { /* not the side of (-1, -1) */
            for (int end = 0; end < 2; end++) {
                edges[count][end][axis] = end ? 1 : -1;
                edges[count][end][(axis + 1) % 3] = side & 1 ? 1 : -1;
                edges[count][end][(axis + 2) % 3] = side & 2 ? 1 : -1;
            }
            count++;
        }
    assert_int_equal(count, 9);
    const struct astray astray = astray_in(&stage, &viewpoint, (const double(*)[2][3])edges, count);
    assert_true(astray.lines > 100);
    assert_int_equal(astray.far, 0);
    assert_int_equal(astray.missing, 0);
    assert_int_equal(records_with(&stage.scene.scene, LIM_POLYGON_EDGES), 0);
    stage_close(&stage);
}

/* An upright wall in the middle, whose plane cuts the floor on both sides of it. Without flags the cut would show. */
static void splits_are_not_drawn(void **state)
{
    const double floor[4][3] = {{-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}};
    const double wall[4][3] = {{-0.4, 0.1, 0.3}, {0.5, 0.1, -0.2}, {0.5, 0.6, -0.2}, {-0.4, 0.6, 0.3}};
    const struct viewpoint viewpoint = {{-0.9, 5.5, 2.2}, {0, 0, 0}, 1, false, 0};
    double edges[8][2][3];

    (void)state;
    for (size_t k = 0; k < 4; k++) {
        memcpy(edges[k][0], floor[k], sizeof floor[k]);
        memcpy(edges[k][1], floor[(k + 1) % 4], sizeof floor[k]);
        memcpy(edges[4 + k][0], wall[k], sizeof wall[k]);
        memcpy(edges[4 + k][1], wall[(k + 1) % 4], sizeof wall[k]);
    }
    for (int known = 0; known < 2; known++) {
        struct stage stage = {.mesh = mesh_rig(3000.0)};
        mesh_rig_add(&stage.mesh, wall, 4);
        mesh_rig_add(&stage.mesh, floor, 4);
        compile(&stage, "first", known, NULL);
        assert_int_equal(stage.scene.report.splits, 1);
        assert_int_equal(records_with(&stage.scene.scene, LIM_POLYGON_EDGES), known ? 2 : 0);
        const struct astray astray = astray_in(&stage, &viewpoint, (const double(*)[2][3])edges, 8);
        assert_int_equal(astray.missing, 0);
        assert_int_equal(astray.far > 0, !known);
        stage_close(&stage);
    }
}

/* A notched sheet, which is triangulated, and a fin whose corner touches one of its diagonals. */
static void diagonals_are_not_drawn(void **state)
{
    static const double sheet[6][3] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    static const double fin[3][3] = {{0.5, 0.5, 0}, {0.9, 0.4, 0.3}, {0.4, 0.9, 0.3}};
    const struct viewpoint viewpoint = {{0.9, 0.1, 3.4}, {0.9, 0.9, 0}, 1, false, 0};
    struct model model = {0};
    struct error err;
    double edges[9][2][3];

    (void)state;
    for (size_t k = 0; k < 9; k++) {
        const bool is_fin = k >= 6;
        memcpy(edges[k][0], is_fin ? fin[k - 6] : sheet[k], sizeof *fin);
        memcpy(edges[k][1], is_fin ? fin[(k - 5) % 3] : sheet[(k + 1) % 6], sizeof *fin);
    }
    tiny_add(&model, 6, sheet);
    tiny_add(&model, 3, fin);
    model.faces[1].two_sided = true;
    for (int merged = 0; merged < 2; merged++) {
        struct stage stage = {0};
        assert_true(mesh_clean(&model, &stage.mesh, &err));
        assert_int_equal(stage.mesh.counts.concave, 1);
        assert_true(!merged || mesh_merge(&stage.mesh, &err));
        compile(&stage, "auto", true, NULL);
        assert_true(records_with(&stage.scene.scene, LIM_POLYGON_EDGES) >= 2);
        const struct astray astray = astray_in(&stage, &viewpoint, (const double(*)[2][3])edges, 9);
        assert_int_equal(astray.far, 0);
        assert_int_equal(astray.missing, 0);
        stage_close(&stage);
    }
    model_free(&model);
}

/* A floor that goes on below the eye: its far edge is a line across the middle of the picture, its cut is none. */
static void the_near_plane_makes_no_line(void **state)
{
    const double floor[4][3] = {{-3, -0.05, 1}, {3, -0.05, 1}, {3, -0.05, -5}, {-3, -0.05, -5}};
    const struct viewpoint viewpoint = {{0, 0, 0}, {0, 0, -1}, 1, false, 0};
    struct stage stage = {.mesh = mesh_rig(3000.0)};
    static struct drawing filled, wire;
    struct error err;

    (void)state;
    mesh_rig_add(&stage.mesh, floor, 4);
    compile(&stage, "auto", true, NULL);
    assert_true(lens_init(&stage.lens, 60, 0.4, W_PX, H_PX, &err));
    const struct lim_camera camera = camera_at(&stage, viewpoint);
    draw(&stage, NULL, LIM_NEAREST_FIRST, &OFF, &camera, &filled);
    draw(&stage, NULL, LIM_NEAREST_FIRST, &WHITE, &camera, &wire);
    assert_int_equal(wire.stats.clipped, 1);
    for (int x = W_PX / 4; x < W_PX / 4 * 3; x++) {
        int covered = 0, lines = 0;
        for (int y = 0; y < H_PX; y++) {
            covered += is_covered(&filled, x, y);
            lines += wire.pixels[y * W_PX + x] == LINE;
        }
        assert_true(covered > 5 && covered < H_PX / 3);
        assert_int_equal(lines, 1);
    }
    stage_close(&stage);
}

/* Orders and memory -------------------------------------------------------------------------- */

static void random_scene(struct stage *stage, struct random *random, const struct core *core,
                         struct closed_scene *closed)
{
    struct error err;

    closed_scene_make(closed, random);
    for (size_t i = 0; i < closed->model.face_count; i += 3)
        closed->model.faces[i].transparency = 120; /* nothing shines through a wireframe */
    *stage = (struct stage){0};
    if (!mesh_clean(&closed->model, &stage->mesh, &err)) fail_msg("%s", err.text);
    compile(stage, "fewest", true, core);
}

static void both_orders_paint_the_same_in_every_profile(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct random random = {12};
    size_t lines = 0;

    (void)state;
    for (int s = 0; s < 8; s++)
        for (size_t p = 0; p < count; p++) {
            struct closed_scene closed;
            struct stage stage;
            random_scene(&stage, &random, profiles[p], &closed);
            for (int f = 0; f < 5; f++) {
                static struct drawing nearest, painter;
                struct lim_camera camera = camera_at(&stage, closed_scene_viewpoint(&closed, &random));
                camera.roll = (uint32_t)random_u64(&random);
                const struct lim_wireframe own = {.on = true};
                const struct lim_wireframe *style = f % 2 ? &own : &WHITE;
                draw(&stage, profiles[p], LIM_NEAREST_FIRST, style, &camera, &nearest);
                draw(&stage, profiles[p], LIM_PAINTER, style, &camera, &painter);
                assert_memory_equal(nearest.pixels, painter.pixels, sizeof nearest.pixels);
                for (int i = 0; i < PIXELS; i++)
                    lines += nearest.pixels[i] != BACKGROUND;
            }
            stage_close(&stage);
            closed_scene_free(&closed);
        }
    assert_true(lines > 20000);
}

static void convex_solids_are_painted_the_same_by_their_own_method(void **state)
{
    struct random random = {6};

    (void)state;
    for (unsigned s = 0; s < 2 * CONVEX_RIG_KINDS; s++) {
        struct stage stage = {.mesh = mesh_rig(3000.0)};
        convex_rig_add(&stage.mesh, &random, s % CONVEX_RIG_KINDS);
        compile(&stage, "auto", true, NULL);
        for (int f = 0; stage.scene.report.convex && f < 10; f++) {
            static struct drawing nearest, convex;
            const struct lim_camera camera = camera_at(&stage, convex_rig_viewpoint(&random));
            draw(&stage, NULL, LIM_NEAREST_FIRST, &WHITE, &camera, &nearest);
            draw(&stage, NULL, LIM_CONVEX, &WHITE, &camera, &convex);
            assert_memory_equal(nearest.pixels, convex.pixels, sizeof nearest.pixels);
        }
        stage_close(&stage);
    }
}

struct canvas {
    uint16_t pixels[H_PX][W_PX + W_PX % 2];
};

static void *lend(void *ctx, uint16_t y_px)
{
    return ((struct canvas *)ctx)->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px, (void)x_px, (void)n_px;
    return 0;
}

static uint32_t draw_with(const struct stage *stage, size_t mem_b, const struct lim_camera *camera,
                          struct canvas *canvas)
{
    const struct lim_target target = {.w_px = W_PX,
                                      .h_px = H_PX,
                                      .format = LIM_RGB565,
                                      .method = LIM_NEAREST_FIRST,
                                      .ctx = canvas,
                                      .lend = lend,
                                      .done = done};
    void *mem = malloc(mem_b);
    struct lim lim;

    assert_int_equal(lim_init(&lim, &stage->scene.scene, &target, mem, mem_b), LIM_OK);
    lim_set_wireframe(&lim, &WHITE);
    assert_int_equal(lim_frame(&lim, camera), LIM_OK);
    free(mem);
    return lim_stats(&lim)->bands;
}

static void any_memory_paints_the_same(void **state)
{
    const struct lim_target target = {.w_px = W_PX, .h_px = H_PX, .method = LIM_NEAREST_FIRST};
    struct random random = {99};
    unsigned banded = 0;

    (void)state;
    for (int s = 0; s < 8; s++) {
        static struct canvas whole, part;
        struct closed_scene closed;
        struct stage stage;
        random_scene(&stage, &random, NULL, &closed);
        const size_t least_b = lim_mem_min_b(&stage.scene.scene, &target);
        const size_t most_b = lim_mem_b(&stage.scene.scene, &target);
        for (int f = 0; f < 4; f++) {
            const struct lim_camera camera = camera_at(&stage, closed_scene_viewpoint(&closed, &random));
            const size_t mem_b = f > 1 ? (size_t)random_in(&random, (int64_t)least_b, (int64_t)most_b) : least_b;
            (void)draw_with(&stage, 2 * most_b, &camera, &whole);
            banded += draw_with(&stage, mem_b, &camera, &part) > 0;
            assert_memory_equal(whole.pixels, part.pixels, sizeof whole.pixels);
        }
        stage_close(&stage);
        closed_scene_free(&closed);
    }
    assert_true(banded >= 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_is_stroked_where_a_neighbour_is_not_the_polygons),
        cmocka_unit_test(a_cube_has_nine_edges),
        cmocka_unit_test(splits_are_not_drawn),
        cmocka_unit_test(diagonals_are_not_drawn),
        cmocka_unit_test(the_near_plane_makes_no_line),
        cmocka_unit_test(both_orders_paint_the_same_in_every_profile),
        cmocka_unit_test(convex_solids_are_painted_the_same_by_their_own_method),
        cmocka_unit_test(any_memory_paints_the_same),
    };
    return cmocka_run_group_tests_name("wireframe", tests, NULL, NULL);
}
