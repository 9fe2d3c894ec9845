/* SPDX-License-Identifier: MIT
 *
 * Stages of which a frame shows little, alone, on many small inputs: their results are as in
 * tests/golden_stages.expected. The stages' own tests say what is right; where several answers are (which triangles
 * cover a folded polygon, how far before a wall visibility is looked up anew), this tells that the answer is another.
 * GOLDEN_FRAMES=write writes the file anew. */
#include "cmocka_ready.h"
#include "edge.h"
#include "eye.h"
#include "golden_stage.h"
#include "portals.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

static uint32_t add(uint32_t hash, int64_t value)
{
    return golden_hash(hash, &value, sizeof value);
}

/* EDGE --------------------------------------------------------------------------------------- */

/* On a grid of half pixels, so that corners share lines and columns; many of them folded. */
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
        uint32_t hash = GOLDEN_HASH, folded = 0;
        for (int i = 0; i < 8000; i++) {
            struct lim_edge_shape shape = {0};
            struct lim_point at[8];
            const uint8_t n = few_corners(&random, at, grids[grid]);
            lim_edge_measure(&shape, at, n);
            lim_edge_measure_sides(&shape, at, n);
            hash = add(add(hash, shape.top), shape.bottom);
            if (shape.top >= shape.bottom) continue;
            hash = add(add(add(add(hash, shape.left), shape.right), shape.first), shape.folded ? shape.apex : -1);
            folded += shape.folded;
        }
        golden_put("shapes on a grid of %d: %08x, folded %u\n", grids[grid], hash, folded);
    }
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
    const int64_t reach = reaches[random_u64(random) % 3] * (random_u64(random) & 1 ? 1 : -1);

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
    golden_compare("tests/golden_stages.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_of_small_polygons),
        cmocka_unit_test(what_portals_show),
        cmocka_unit_test(balls_of_cameras),
        cmocka_unit_test(all_is_what_it_was),
    };

    return cmocka_run_group_tests_name("golden_stages", tests, NULL, NULL);
}
