/* SPDX-License-Identifier: MIT
 *
 * The renderer at the ends of its ranges: any camera that is legal, eyes far outside of the scene,
 * lenses from 1/64 to 4 and screens from a pixel up. */
#include "colour.h"
#include "compiler/compile_mesh.h"
#include "eye.h"
#include "limner.h"
#include "rigs/closed_scene.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random_camera.h"
#include "rigs/unpainted.h"
#include "scene/compiled.h"
#include "view/cull.h"
#include "view/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_W_PX = 84, MAX_H_PX = 48, SCENES = 10, FRAMES = 800, BOX_FRAMES = 20000, VIEWS = 200000 };
enum { CULL_VIEWS = 40000, CULL_POINTS = 30, CULL_WALKS = 4000, ROLLED_FRAMES = 60, ROLLED_PX = 64 };

/* No box: the whole grid may be full. */
static const struct lim_scene grid_scene = {0};

/* In the 16-bit cube, around it, or as far off as it may be. */
static int32_t any_eye_q8(struct random *random)
{
    const int32_t end = LIM_EYE_MAX_Q8 - 1;

    switch (random_u64(random) % 5) {
    case 0:
        return random_u64(random) % 2 ? end : -end;
    case 1:
        return (int32_t)random_in(random, -end, end);
    case 2:
        return (int32_t)random_in(random, -(INT32_C(1) << 25), INT32_C(1) << 25);
    default:
        return (int32_t)random_in(random, -(INT32_C(1) << 23), INT32_C(1) << 23);
    }
}

static struct lim_camera any_camera(struct random *random)
{
    struct lim_camera camera;

    for (int i = 0; i < 3; i++)
        camera.eye_q8[i] = any_eye_q8(random);
    camera.yaw = random_angle(random);
    camera.pitch = random_angle(random);
    camera.roll = random_angle(random);
    camera.tan_x_q28 = random_tan_q28(random);
    camera.tan_y_q28 = random_u64(random) % 2 ? camera.tan_x_q28 : random_tan_q28(random);
    camera.near_q8 = random_u64(random) % 2 ? 1 : (int32_t)(INT32_C(1) << random_in(random, 0, 24));
    return camera;
}

static uint32_t turn(double radians)
{
    return (uint32_t)(int64_t)llround(radians / 6.283185307179586 * 4294967296.0);
}

static void aim(struct lim_camera *camera, const int16_t target[3])
{
    double d[3];

    for (int i = 0; i < 3; i++)
        d[i] = target[i] - camera->eye_q8[i] / 256.0;
    camera->yaw = turn(atan2(-d[0], -d[2]));
    camera->pitch = turn(atan2(d[1], hypot(d[0], d[2])));
}

static void any_vertex(struct random *random, int16_t v[3])
{
    for (int i = 0; i < 3; i++) {
        switch (random_u64(random) % 4) {
        case 0:
            v[i] = INT16_MIN;
            break;
        case 1:
            v[i] = INT16_MAX;
            break;
        default:
            v[i] = (int16_t)random_in(random, INT16_MIN, INT16_MAX);
        }
    }
}

/* Frames ------------------------------------------------------------------------------------- */

struct canvas {
    uint16_t pixels[MAX_H_PX][MAX_W_PX];
    uint8_t done[MAX_H_PX][MAX_W_PX]; /* how often each pixel was final */
};

static void *lend(void *ctx, uint16_t y_px)
{
    struct canvas *canvas = ctx;

    assert_true(y_px < MAX_H_PX);
    return canvas->pixels[y_px];
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct canvas *canvas = ctx;

    assert_true(n_px > 0 && x_px + n_px <= MAX_W_PX);
    for (uint16_t x = x_px; x < x_px + n_px; x++)
        canvas->done[y_px][x]++;
    return 0;
}

/* Every pixel painted and final once, and none beside the picture touched. */
static void assert_done_once(const struct canvas *canvas, uint16_t w_px, uint16_t h_px, uint16_t unpainted)
{
    for (int y = 0; y < MAX_H_PX; y++) {
        for (int x = 0; x < MAX_W_PX; x++) {
            const bool inside = x < w_px && y < h_px;
            assert_int_equal(canvas->done[y][x], inside);
            assert_true((canvas->pixels[y][x] != lim_memory_colour(unpainted)) == inside);
        }
    }
}

/* Nearest first, pixels of the background are those that are left; by scan lines it is under all polygons. */
static void assert_counts(const struct canvas *canvas, const struct lim_scene *scene, size_t px, enum lim_method method,
                          const struct lim_stats *stats)
{
    const size_t background = count_pixels(&canvas->pixels[0][0], MAX_W_PX * MAX_H_PX, scene->background);

    if (method == LIM_PAINTER) return;
    assert_true(stats->pixels_painted >= px - background);
    if (method == LIM_NEAREST_FIRST) assert_int_equal(stats->pixels_background, background);
    if (method == LIM_SCANLINE) assert_in_range(stats->pixels_background, background, px);
}

static void draw(struct canvas *canvas, const struct lim_scene *scene, const struct lim_camera *camera, uint16_t w_px,
                 uint16_t h_px, enum lim_method method, bool least_memory, struct lim_stats *stats)
{
    const struct lim_target target = {
        .w_px = w_px, .h_px = h_px, .format = LIM_RGB565, .method = method, .ctx = canvas, .lend = lend, .done = done};
    const size_t mem_b = least_memory ? lim_mem_min_b(scene, &target) : lim_mem_b(scene, &target);
    const uint16_t unpainted = unused_colour(scene);
    void *mem = malloc(mem_b);
    struct lim lim;

    memset(canvas, 0, sizeof *canvas);
    wipe_pixels(&canvas->pixels[0][0], MAX_W_PX * MAX_H_PX, unpainted);
    assert_int_equal(lim_init(&lim, scene, &target, mem, mem_b), LIM_OK);
    assert_int_equal(lim_frame(&lim, camera), LIM_OK);
    assert_done_once(canvas, w_px, h_px, unpainted);
    *stats = *lim_stats(&lim);
    assert_counts(canvas, scene, (size_t)w_px * h_px, method, stats);
    free(mem);
}

struct stage {
    struct closed_scene closed;
    struct mesh mesh;
    struct compiled scene;
};

static void stage_init(struct stage *stage, struct random *random)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest", .keep_faces = true};
    struct error err;

    closed_scene_make(&stage->closed, random);
    if (!mesh_clean(&stage->closed.model, &stage->mesh, &err) || !mesh_insert_t_vertices(&stage->mesh, &err) ||
        !compile_mesh(&stage->mesh, &options, &stage->scene, &err))
        fail_msg("%s", err.text);
    stage->scene.scene.background = unused_colour(&stage->scene.scene); /* its pixels are counted */
}

static void stage_free(struct stage *stage)
{
    compiled_free(&stage->scene);
    mesh_free(&stage->mesh);
    closed_scene_free(&stage->closed);
}

/* Often at one of the scene's vertices or a hair off, often looking at one. */
static void involve(struct lim_camera *camera, const struct lim_scene *scene, struct random *random)
{
    const struct lim_vertex *at = &scene->vertices[random_u64(random) % scene->vertex_count];
    const int16_t v[3] = {at->x, at->y, at->z};

    if (random_u64(random) % 4 == 0) {
        for (int i = 0; i < 3; i++)
            camera->eye_q8[i] = v[i] * 256 + (int32_t)random_in(random, -1, 1);
    } else if (random_u64(random) % 3) {
        aim(camera, v);
    }
}

static void any_camera_paints_the_same_pixels_once_in_any_memory_and_order(void **state)
{
    static const uint16_t sizes[][2] = {{1, 1}, {1, MAX_H_PX}, {8, 8}, {17, 31}, {MAX_W_PX, MAX_H_PX}};
    struct random random = {51};
    uint32_t clipped = 0, bands = 0, seen = 0;

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        stage_init(&stage, &random);
        for (int f = 0; f < effort(FRAMES); f++) {
            const uint16_t *size = sizes[random_u64(&random) % 5];
            struct lim_camera camera = any_camera(&random);
            struct canvas comfortable, least, painter;
            struct lim_stats stats;
            involve(&camera, &stage.scene.scene, &random);
            draw(&comfortable, &stage.scene.scene, &camera, size[0], size[1], LIM_NEAREST_FIRST, false, &stats);
            clipped += stats.clipped;
            seen += stats.polygons_seen;
            draw(&least, &stage.scene.scene, &camera, size[0], size[1], LIM_NEAREST_FIRST, true, &stats);
            bands += stats.bands;
            assert_memory_equal(comfortable.pixels, least.pixels, sizeof least.pixels);
            draw(&painter, &stage.scene.scene, &camera, size[0], size[1], LIM_PAINTER, false, &stats);
            assert_memory_equal(comfortable.pixels, painter.pixels, sizeof painter.pixels);
            draw(&painter, &stage.scene.scene, &camera, size[0], size[1], LIM_SCANLINE, f % 2, &stats);
            assert_memory_equal(comfortable.pixels, painter.pixels, sizeof painter.pixels);
        }
        stage_free(&stage);
    }
    const uint32_t frames = (uint32_t)(SCENES * effort(FRAMES));
    assert_true(clipped > frames && bands > frames && seen > frames);
}

static void rolled_and_long_views_of_closed_scenes_show_no_background(void **state)
{
    struct random random = {52};

    (void)state;
    for (int s = 0; s < SCENES; s++) {
        struct stage stage;
        stage_init(&stage, &random);
        for (int f = 0; f < effort(ROLLED_FRAMES); f++) {
            struct viewpoint viewpoint = closed_scene_viewpoint(&stage.closed, &random);
            const struct camera_path path = {"random", &viewpoint, 1};
            const struct lens lens = {1.0 / 60, 1.0 / 60, 0.01, 240};
            struct lim_camera camera;
            struct canvas canvas;
            struct lim_stats stats;
            struct error err;
            assert_true(camera_path_to_camera(&path, 0, &lens, &stage.scene.grid, &camera, &err));
            camera.roll = random_angle(&random);
            if (f % 2) camera.tan_x_q28 = camera.tan_y_q28 = random_tan_q28(&random) / 4 + LIM_TAN_MIN_Q28;
            draw(&canvas, &stage.scene.scene, &camera, ROLLED_PX, MAX_H_PX, LIM_NEAREST_FIRST, false, &stats);
            assert_int_equal(stats.pixels_background, 0);
        }
        stage_free(&stage);
    }
}

/* The near plane ------------------------------------------------------------------------------ */

/* A box seen from inside, low[i]..high[i]: a chain of six nodes, each with one side and all others
 * in front of or behind it. */
struct box {
    struct lim_vertex vertices[8]; /* bit i of the index: the high end of axis i */
    struct lim_node nodes[6];
    lim_index polygons[6 * 6];
    struct lim_scene scene;
};

static void box_make(struct box *box, const int16_t low[3], const int16_t high[3])
{
    for (int k = 0; k < 8; k++)
        box->vertices[k] =
            (struct lim_vertex){k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]};
    for (uint16_t side = 0; side < 6; side++) {
        const int axis = side / 2, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        const bool far = side % 2;
        const int base = far ? 1 << axis : 0;
        const lim_index run = (lim_index)(side * 6), next = side == 5 ? LIM_NO_INDEX : (lim_index)(side + 1);
        const lim_index record[6] = {LIM_POLYGON_LAST | 4,     (lim_index)(side + 1),
                                     (uint16_t)base,           (uint16_t)(base + (far ? v : u)),
                                     (uint16_t)(base + u + v), (uint16_t)(base + (far ? u : v))};
        memcpy(&box->polygons[run], record, sizeof record);
        box->nodes[side] = (struct lim_node){.split = {LIM_PLANE_X + (lim_index)axis, far ? high[axis] : low[axis]},
                                             .box = LIM_NO_INDEX};
        box->nodes[side].front = box->nodes[side].back = LIM_NO_INDEX;
        box->nodes[side].front_run = box->nodes[side].back_run = LIM_NO_INDEX;
        *(far ? &box->nodes[side].back : &box->nodes[side].front) = next;
        *(far ? &box->nodes[side].back_run : &box->nodes[side].front_run) = run;
    }
    box->scene = (struct lim_scene){.vertices = box->vertices,
                                    .nodes = box->nodes,
                                    .polygons = box->polygons,
                                    .vertex_count = 8,
                                    .node_count = 6,
                                    .polygon_words = 36,
                                    .polygon_count = 6,
                                    .limits = {6, 4, 200, 200, 20, 0}};
}

/* Polygons that pass the eye at a hair, vertices behind it, walls in line with the near plane: the
 * side faced is all there is to see, however near, as long as the near plane does not reach it. */
static void a_box_seen_from_inside_fills_the_screen_up_to_the_near_plane(void **state)
{
    struct random random = {53};
    uint32_t clipped = 0;

    (void)state;
    for (int f = 0; f < effort(BOX_FRAMES); f++) {
        struct lim_camera camera = any_camera(&random);
        int16_t low[3], high[3];
        struct box box;
        struct canvas canvas;
        struct lim_stats stats;
        camera.near_q8 = (int32_t)random_in(&random, 1, 1024);
        const int32_t margin = (int32_t)ceil(near_reach_units(&camera)) + 2;
        for (int i = 0; i < 3; i++) {
            low[i] = (int16_t)random_in(&random, -32768, random_u64(&random) % 2 ? -32000 : 0);
            high[i] = (int16_t)random_in(&random, low[i] + 2 * margin + 2, low[i] + 2 * margin + 31000);
            const int32_t near_side = random_u64(&random) % 2 ? low[i] + margin : high[i] - margin;
            camera.eye_q8[i] =
                256 *
                (int32_t)(random_u64(&random) % 2 ? near_side : random_in(&random, low[i] + margin, high[i] - margin));
        }
        box_make(&box, low, high);
        draw(&canvas, &box.scene, &camera, 16, 12, LIM_NEAREST_FIRST, false, &stats);
        assert_int_equal(stats.pixels_background, 0);
        clipped += stats.clipped;
    }
    assert_true(clipped > (uint32_t)effort(BOX_FRAMES));
}

/* Numbers ------------------------------------------------------------------------------------ */

static void view_space_fits_32_bits_for_every_camera_and_vertex(void **state)
{
    struct random random = {54};
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view;
    int64_t most = 0;

    (void)state;
    lim_view_init(&view, 240, 240, cache);
    for (int k = 0; k < effort(VIEWS); k++) {
        struct lim_camera camera = any_camera(&random);
        int16_t v[3];
        any_vertex(&random, v);
        if (k % 2) aim(&camera, v);
        assert_true(lim_view_begin(&view, &grid_scene, &camera));
        assert_in_range(view.rows.near_qv, 1 << 15, 1 << 30);
        const struct lim_vertex vertex = {v[0], v[1], v[2]};
        struct lim_view_point point;
        lim_view_transform(&view, &grid_scene, &vertex, &point);
        const int32_t got_qv[3] = {point.x_qv, point.y_qv, point.z_qv};
        for (int row = 0; row < 3; row++) {
            int64_t exact_qv = view.rows.row[row].shift_qv;
            for (int i = 0; i < 3; i++)
                exact_qv += (int64_t)view.rows.row[row].n_qv[i] * v[i];
            if (llabs(exact_qv) > most) most = llabs(exact_qv);
            if (row == 2) exact_qv >>= view.rows.tele_bits;
            if (row < 2)
                exact_qv += (int64_t)ldexp((double)got_qv[2] * view.rows.turn_q32[row], -32); /* of a long lens */
            assert_true(llabs(got_qv[row] - exact_qv) < 1 << 18); /* no wrap; profile fine adds a low limb */
        }
    }
    assert_true(most > INT64_C(1) << 30); /* the last bit is in use */
}

/* Not on its edge, where rounding decides. */
static bool is_inside_pixel(struct lim_point at, int x_px, int y_px)
{
    return abs((int)at.x - x_px * (int)LIM_SUB) < LIM_SUB / 2 && abs((int)at.y - y_px * (int)LIM_SUB) < LIM_SUB / 2;
}

static struct lim_box box_with(struct random *random, const int16_t v[3])
{
    struct lim_box box;

    for (int i = 0; i < 3; i++) {
        const int half = (int)random_in(random, 0, 1 << random_in(random, 0, 14));
        const int centre = random_u64(random) % 2 ? v[i] + half : v[i] - half;
        const bool fits = centre >= INT16_MIN && centre <= INT16_MAX;
        box.centre[i] = (int16_t)(fits ? centre : v[i]);
        box.half[i] = (uint16_t)(fits ? half : 0);
    }
    return box;
}

/* A point of the cube near the line of visible set, whatever the lens. */
static void point_in_view(struct random *random, const struct lim_camera *camera, const int16_t target[3], int16_t v[3])
{
    const double far = random_unit(random) * 1.5, spread = ldexp(camera->tan_x_q28, -28);

    for (int i = 0; i < 3; i++) {
        const double eye = camera->eye_q8[i] / 256.0, ahead = far * (target[i] - eye);
        const double x = eye + ahead + spread * (2 * random_unit(random) - 1) * fabs(ahead);
        v[i] = (int16_t)fmax(INT16_MIN, fmin(INT16_MAX, x));
    }
}

static void no_box_with_a_vertex_on_an_open_pixel_is_culled(void **state)
{
    static const uint16_t sides_px[] = {1, 8, 84, 240};
    struct random random = {55};
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    uint32_t tested = 0;

    (void)state;
    for (int k = 0; k < effort(CULL_VIEWS); k++) {
        const uint16_t w_px = sides_px[random_u64(&random) % 4], h_px = sides_px[random_u64(&random) % 4];
        struct lim_camera camera = any_camera(&random);
        struct lim_view view;
        int16_t target[3], v[3];
        any_vertex(&random, target);
        aim(&camera, target);
        lim_view_init(&view, w_px, h_px, cache);
        assert_true(lim_view_begin(&view, &grid_scene, &camera));
        for (int p = 0; p < CULL_POINTS; p++) {
            struct lim_view_point point;
            point_in_view(&random, &camera, target, v);
            lim_view_transform(&view, &grid_scene, &(struct lim_vertex){v[0], v[1], v[2]}, &point);
            if (point.z_qv < view.rows.near_qv || llabs(point.x_qv) > lim_zoomed(&view.rows, point.z_qv, 0) ||
                llabs(point.y_qv) > lim_zoomed(&view.rows, point.z_qv, 1))
                continue;
            struct lim_point at;
            lim_view_project(&view, &point, &at);
            const int x_px = (at.x + LIM_SUB / 2) >> LIM_SUB_BITS, y_px = (at.y + LIM_SUB / 2) >> LIM_SUB_BITS;
            if (x_px < 0 || x_px >= w_px || y_px < 0 || y_px >= h_px || !is_inside_pixel(at, x_px, y_px)) continue;
            const struct lim_rect open = {(uint16_t)random_in(&random, 0, x_px), (uint16_t)y_px, (uint16_t)(x_px + 1),
                                          (uint16_t)random_in(&random, y_px + 1, h_px)};
            const struct lim_box box = box_with(&random, v);
            struct lim_cull cull;
            lim_cull_set(&cull, &view, camera.eye_q8, &open);
            assert_true(lim_cull_sees(&cull, &box));
            tested++;
        }
    }
    assert_true(tested > (uint32_t)effort(CULL_VIEWS));
}

/* A walk through boxes in boxes: `skipped` counts the subtrees that needed no test. */
struct descent {
    struct lim_cull cull;
    struct random random;
    uint32_t skipped, outside;
};

static struct lim_box part_of(const struct lim_box *whole, struct random *random)
{
    struct lim_box part;

    for (int i = 0; i < 3; i++) {
        const int64_t low = whole->centre[i] - whole->half[i], high = whole->centre[i] + whole->half[i];
        const int64_t from = random_in(random, low, high), to = random_in(random, from, high);
        part.centre[i] = (int16_t)floor((double)(from + to) / 2);
        part.half[i] = (uint16_t)(to - part.centre[i]);
    }
    return part;
}

/* The near half one deeper on the stack, the far half as deep: like WALK. */
static void descend(struct descent *descent, const struct lim_box *box, uint16_t depth, int levels)
{
    const bool inside = descent->cull.inside_depth <= depth;
    const bool enters = inside || lim_cull_enters(&descent->cull, box, depth);

    assert_true(enters == lim_cull_sees(&descent->cull, box));
    descent->skipped += inside;
    descent->outside += !enters;
    if (!enters || !levels) return;
    const struct lim_box near = part_of(box, &descent->random), far = part_of(box, &descent->random);
    descend(descent, &near, (uint16_t)(depth + 1), levels - 1);
    descend(descent, &far, depth, levels - 1);
}

static void a_walk_that_remembers_what_it_is_inside_of_skips_what_all_planes_would(void **state)
{
    static const struct lim_box grid = {{0, 0, 0}, {32767, 32767, 32767}};
    struct descent descent = {.random = {56}};
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];

    (void)state;
    for (int k = 0; k < effort(CULL_WALKS); k++) {
        struct lim_camera camera = any_camera(&descent.random);
        struct lim_view view;
        int16_t target[3];
        any_vertex(&descent.random, target);
        aim(&camera, target);
        lim_view_init(&view, 240, 240, cache);
        assert_true(lim_view_begin(&view, &grid_scene, &camera));
        const struct lim_rect open = {(uint16_t)random_in(&descent.random, 0, 119), 0, 240,
                                      (uint16_t)random_in(&descent.random, 120, 240)};
        lim_cull_set(&descent.cull, &view, camera.eye_q8, &open);
        descend(&descent, &grid, 0, 6);
    }
    const uint32_t walks = (uint32_t)effort(CULL_WALKS);
    assert_true(descent.skipped > walks && descent.outside > walks);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_camera_paints_the_same_pixels_once_in_any_memory_and_order),
        cmocka_unit_test(rolled_and_long_views_of_closed_scenes_show_no_background),
        cmocka_unit_test(a_box_seen_from_inside_fills_the_screen_up_to_the_near_plane),
        cmocka_unit_test(view_space_fits_32_bits_for_every_camera_and_vertex),
        cmocka_unit_test(no_box_with_a_vertex_on_an_open_pixel_is_culled),
        cmocka_unit_test(a_walk_that_remembers_what_it_is_inside_of_skips_what_all_planes_would),
    };

    return cmocka_run_group_tests_name("extremes", tests, NULL, NULL);
}
