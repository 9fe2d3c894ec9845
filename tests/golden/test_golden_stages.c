/* SPDX-License-Identifier: MIT
 *
 * Stages of which a frame shows little, alone, on many small inputs: their results are as in
 * tests/golden/golden_stages.expected. The stages' own tests say what is right; where several answers are (which
 * triangles cover a non-monotone polygon, how far before a wall visibility is looked up anew), this tells that the
 * answer is another. GOLDEN_FRAMES=write writes the file anew. */
#include "eye.h"
#include "golden_stage.h"
#include "math/orientation.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"
#include "scene.h"
#include "screen/edge.h"
#include "screen/project.h"
#include "screen/samples.h"
#include "view/clip.h"
#include "view/cull.h"
#include "view/portals.h"

#include <stdlib.h>
#include <string.h>

static uint32_t add(uint32_t hash, int64_t value)
{
    return golden_hash(hash, &value, sizeof value);
}

/* EDGE --------------------------------------------------------------------------------------- */

/* On a grid of half pixels, so that corners share lines and columns; many of them non-monotone. */
static uint8_t few_corners(struct random *random, struct lim_point at[8], int grid)
{
    const uint8_t n = (uint8_t)random_in(random, 3, 8);

    for (int k = 0; k < n; k++) {
        at[k].x = (lim_sub)(random_in(random, -grid, grid) * LIM_SUB / 2);
        at[k].y = (lim_sub)(random_in(random, -grid, grid) * LIM_SUB / 2);
    }
    return n;
}

static void shapes_of_small_polygons(void **state)
{
    static const int grids[] = {2, 4, 9, 40};
    struct random random = {91};

    (void)state;
    for (size_t grid = 0; grid < sizeof grids / sizeof *grids; grid++) {
        uint32_t hash = GOLDEN_HASH, non_monotone = 0;
        for (int i = 0; i < 8000; i++) {
            struct lim_edge_shape shape = {0};
            struct lim_point at[8];
            const uint8_t n = few_corners(&random, at, grids[grid]);
            lim_edge_bounds(&shape, at, n);
            lim_edge_bounds_sides(&shape, at, n);
            hash = add(add(hash, shape.top), shape.bottom);
            if (shape.top >= shape.bottom) continue;
            hash = add(add(add(add(hash, shape.left), shape.right), shape.first), shape.non_monotone ? shape.apex : -1);
            non_monotone += shape.non_monotone;
        }
        golden_put("shapes on a grid of %d: %08x, non-monotone %u\n", grids[grid], hash, non_monotone);
    }
}

static void samples_of_small_polygons(void **state)
{
    static const int grids[] = {1, 2, 5, 40};
    struct random random = {92};

    (void)state;
    for (size_t grid = 0; grid < sizeof grids / sizeof *grids; grid++) {
        uint32_t hash = GOLDEN_HASH, non_monotone = 0;
        for (int i = 0; i < 8000; i++) {
            struct lim_edge_shape shape = {0};
            struct lim_point at[8];
            const uint8_t n = few_corners(&random, at, grids[grid]);
            for (int k = 0; k < n; k++) /* on rows of samples and between them */
                at[k].y = (lim_sub)(at[k].y + random_in(&random, -LIM_SUB / 4, LIM_SUB / 4));
            lim_samples_bounds(&shape, at, n);
            lim_samples_sides(&shape, at, n);
            hash = add(add(add(add(hash, shape.top), shape.bottom), shape.left), shape.right);
            hash = add(add(add(hash, shape.first), *shape.end_row), shape.non_monotone ? shape.apex : -1);
            non_monotone += shape.non_monotone;
        }
        golden_put("samples on a grid of %d: %08x, non-monotone %u\n", grids[grid], hash, non_monotone);
    }
}

/* VIEW, CLIP, PROJECT ------------------------------------------------------------------------ */

static uint32_t add_rows(uint32_t hash, const struct lim_rows *rows)
{
    hash = add(add(add(hash, rows->tele_bits), rows->near_qv), rows->far_units);
    for (int i = 0; i < 3; i++) {
        hash = add(hash, rows->row[i].shift_qv);
        for (int k = 0; k < 3; k++)
            hash = add(hash, rows->row[i].n_qv[k]);
    }
    return hash;
}

static struct lim_camera any_camera(struct random *random)
{
    struct lim_camera camera = {.near_q8 = (int32_t)(INT64_C(1) << random_in(random, 0, 24))};

    for (int i = 0; i < 3; i++) { /* one number a statement: compilers would choose the order */
        const int64_t bits = random_in(random, 0, 20);
        camera.eye_q8[i] = (int32_t)random_in(random, -(INT64_C(1) << 27), INT64_C(1) << 27) >> bits;
    }
    camera.yaw = random_angle(random);
    camera.pitch = random_angle(random);
    camera.roll = random_angle(random);
    camera.tan_x_q28 = random_tan_q28(random);
    camera.tan_y_q28 = random_tan_q28(random);
    return camera;
}

static void rows_of_cameras(void **state)
{
    static struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    static const struct lim_scene nothing;
    struct random random = {93};
    uint32_t hash = GOLDEN_HASH, culls = GOLDEN_HASH, axes = GOLDEN_HASH;

    (void)state;
    for (int i = 0; i < 3000; i++) {
        const struct lim_camera camera = any_camera(&random);
        const uint16_t w_px = (uint16_t)random_in(&random, 1, 240), h_px = (uint16_t)random_in(&random, 1, 240);
        const struct lim_rect open = {0, 0, w_px, h_px};
        struct lim_view view = {0};
        int32_t axes_q30[9];
        struct lim_cull cull;
        lim_view_init(&view, 240, 240, cache);
        assert_true(lim_view_begin(&view, &nothing, &camera));
        hash = add_rows(hash, &view.rows);
        lim_cull_set(&cull, &view, camera.eye_q8, &open);
        for (int side = 0; side < 4; side++)
            culls = add(golden_hash(culls, cull.sides[side].n, sizeof cull.sides[side].n), cull.sides[side].offset);
        lim_orientation_set(axes_q30, &camera);
        axes = golden_hash(axes, axes_q30, sizeof axes_q30);
    }
    golden_put("rows of cameras: %08x, sides %08x, axes %08x\n", hash, culls, axes);
}

/* About the planes, half of its edges hidden. */
static void any_view_polygon(struct random *random, struct lim_clip_polygon *polygon, uint8_t n, int32_t near_qv)
{
    polygon->n = n;
    for (uint8_t k = 0; k < n; k++) {
        struct lim_view_point *at = &polygon->at[k];
        const int64_t reach_qv = INT64_C(1) << random_in(random, 16, 30);
        at->z_qv = (int32_t)random_in(random, -reach_qv, reach_qv);
        at->x_qv = (int32_t)random_in(random, -reach_qv, reach_qv);
        at->y_qv = (int32_t)random_in(random, -reach_qv, reach_qv);
        if (random_u64(random) % 4 == 0) at->z_qv = near_qv + (int32_t)random_in(random, -2, 2);
        if (random_u64(random) % 4 == 0) at->x_qv = at->z_qv / 2 * 4 + (int32_t)random_in(random, -5, 5);
        if (random_u64(random) % 4 == 0) at->y_qv = at->z_qv / 2 * -4 + (int32_t)random_in(random, -5, 5);
        *at->hidden = random_u64(random) & 1;
    }
}

static void clipped_polygons(void **state)
{
    struct random random = {94};

    (void)state;
    for (int32_t near_qv = 1 << 15; near_qv < 1 << 18; near_qv = near_qv * 2 + 1) {
        uint32_t hash = GOLDEN_HASH, corners = 0;
        for (int i = 0; i < 10000; i++) {
            struct lim_clip_polygon polygons[2] = {{0}};
            any_view_polygon(&random, &polygons[0], (uint8_t)random_in(&random, 3, 9), near_qv);
            const struct lim_clip_polygon *clipped = lim_clip(polygons, near_qv);
            hash = add(hash, clipped->n);
            corners += clipped->n;
            for (uint8_t k = 0; k < clipped->n; k++)
                hash = add(golden_hash(hash, clipped->at[k].qv, sizeof clipped->at[k].qv), *clipped->at[k].hidden);
        }
        golden_put("clipped at %ld: %08x, corners %u\n", (long)near_qv, hash, corners);
    }
}

/* MOVERS ------------------------------------------------------------------------------------- */

static void places_of_motions(void **state)
{
    enum { KEYS = 4 };
    struct random random = {95};
    uint32_t hash = GOLDEN_HASH;

    (void)state;
    for (int i = 0; i < 3000; i++) {
        struct lim_motion_key keys[KEYS];
        const uint16_t count = (uint16_t)random_in(&random, 1, KEYS);
        const bool repeats = random_u64(&random) & 1;
        const struct lim_motion motion = {.keys = keys, .count = count, .repeats = repeats};
        uint32_t time_ms = 0;
        for (int k = 0; k < KEYS; k++) {
            time_ms += (uint32_t)random_in(&random, 0, 5);
            keys[k] = (struct lim_motion_key){.time_ms = time_ms, .arc = (uint16_t)random_in(&random, 0, 1 << 14)};
            for (int j = 0; j < 3; j++)
                keys[k].at_q8[j] = (int32_t)random_in(&random, -(1 << 24), 1 << 24);
            for (int j = 0; j < 4; j++)
                keys[k].turn_q15[j] = (int16_t)random_in(&random, -32767, 32767);
        }
        for (uint32_t at_ms = 0; at_ms < 24; at_ms++) {
            struct lim_instance instance;
            lim_motion_at(&motion, at_ms, &instance);
            hash = golden_hash(hash, instance.at_q8, sizeof instance.at_q8);
            hash = golden_hash(hash, instance.axes_q30, sizeof instance.axes_q30);
        }
    }
    golden_put("places of motions: %08x\n", hash);
}

static void shades_of_faces(void **state)
{
    struct random random = {96};
    uint32_t hash = GOLDEN_HASH;

    (void)state;
    for (int i = 0; i < 20000; i++) {
        const uint8_t middle_q8 = (uint8_t)random_in(&random, 0, 255);
        const struct lim_light light = {true, {0}, middle_q8, (uint8_t)random_in(&random, 0, 255 - middle_q8)};
        const int64_t reach = INT64_C(1) << random_in(&random, 0, 30);
        int32_t normal[3];
        int16_t to_q14[3];
        for (int k = 0; k < 3; k++) {
            normal[k] = (int32_t)random_in(&random, -reach, reach);
            to_q14[k] = (int16_t)random_in(&random, -9459, 9459);
        }
        if (!normal[0] && !normal[1]) normal[2] = 1;
        hash = add(hash, lim_light_shade(&light, to_q14, normal, (uint16_t)random_in(&random, 0, 65535)));
    }
    golden_put("shades of faces: %08x\n", hash);
}

/* PORTALS ------------------------------------------------------------------------------------ */

/* A unit about where a wall begins to matter, or anywhere near a vertex. */
static void eye_about_walls(const struct lim_scene *scene, uint32_t ball_units, struct random *random,
                            int32_t eye_q8[3])
{
    const struct lim_plane_ref split = scene->nodes[random_u64(random) % scene->node_count].split;
    const struct lim_vertex at = scene->vertices[random_u64(random) % scene->vertex_count];
    const int32_t vertex[3] = {at.x, at.y, at.z};
    const int64_t reaches[] = {ball_units + 1, 4, 60};
    const int64_t length = reaches[random_u64(random) % 3];
    const int64_t reach = random_u64(random) & 1 ? length : -length;

    for (int i = 0; i < 3; i++)
        eye_q8[i] = (vertex[i] + (int32_t)random_in(random, -400, 400)) * 256;
    if (split.plane >= LIM_PLANE_X && split.plane != LIM_NO_INDEX)
        eye_q8[split.plane & 3] = (int32_t)(split.offset + reach + random_in(random, -2, 2)) * 256;
}

static void put_portals(const struct golden_stage *stage)
{
    const struct lim_scene *scene = &stage->scene.scene;
    const size_t mem_b = lim_portals_mem_b(scene), bits_b = LIM_PORTALS_BITS_B(scene->box_count);
    uint8_t *mem = calloc(1, mem_b);
    const struct lim_portals portals = {mem, (uint16_t *)(void *)(mem + bits_b)};
    struct random random = {17};
    uint32_t hash = GOLDEN_HASH, known = 0;

    assert_non_null(mem);
    for (int i = 0; i < 6000; i++) {
        const uint32_t ball_units = (uint32_t)random_in(&random, 1, 60);
        int32_t eye_q8[3];
        struct lim_eye eye;
        eye_about_walls(scene, ball_units, &random, eye_q8);
        lim_eye_set(&eye, scene, eye_q8);
        const bool is_known = lim_portals_unpack(&portals, &eye, ball_units);
        hash = add(hash, is_known);
        if (is_known) hash = golden_hash(hash, mem, bits_b);
        known += is_known;
    }
    golden_put("portals of %s: %08x, known %u\n", stage->name, hash, known);
    free(mem);
}

static void what_portals_show(void **state)
{
    struct golden_stage stage;

    (void)state;
    for (size_t scene = 0; golden_open(&stage, scene); scene++) {
        if (lim_portals_mem_b(&stage.scene.scene)) put_portals(&stage);
        golden_close(&stage);
    }
}

static void balls_of_cameras(void **state)
{
    struct random random = {19};
    uint32_t hash = GOLDEN_HASH;

    (void)state;
    for (int i = 0; i < 20000; i++) {
        const uint32_t far_units = (uint32_t)random_in(&random, 0, INT64_C(1) << random_in(&random, 1, 18));
        const struct lim_camera camera = {
            .tan_x_q28 = (uint32_t)random_in(&random, LIM_TAN_MIN_Q28, INT64_C(1) << random_in(&random, 23, 30)),
            .tan_y_q28 = (uint32_t)random_in(&random, LIM_TAN_MIN_Q28, INT64_C(1) << random_in(&random, 23, 30)),
            .near_q8 = (int32_t)random_in(&random, 1, INT64_C(1) << random_in(&random, 0, 24))};
        hash = add(hash, lim_portals_ball_units(&camera, far_units));
    }
    golden_put("balls of cameras: %08x\n", hash);
}

static void all_is_what_it_was(void **state)
{
    (void)state;
    golden_compare("tests/golden/golden_stages.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_of_small_polygons), cmocka_unit_test(samples_of_small_polygons),
        cmocka_unit_test(rows_of_cameras),          cmocka_unit_test(clipped_polygons),
        cmocka_unit_test(places_of_motions),        cmocka_unit_test(shades_of_faces),
        cmocka_unit_test(what_portals_show),        cmocka_unit_test(balls_of_cameras),
        cmocka_unit_test(all_is_what_it_was),
    };

    return cmocka_run_group_tests_name("golden_stages", tests, NULL, NULL);
}
