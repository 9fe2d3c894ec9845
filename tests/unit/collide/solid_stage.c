/* SPDX-License-Identifier: MIT
 *
 * Seeds tell stages apart: of trees, of random buildings, of closed scenes. */
#include "unit/collide/solid_stage.h"

#include "rigs/cmocka_ready.h"
#include "rigs/room_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void solid_stage_begin(struct solid_stage *stage, uint64_t seed)
{
    const size_t mem_b = stage->scene.scene.limits.depth * sizeof *stage->stack;

    stage->random = (struct random){seed};
    stage->stack = malloc(mem_b + 1);
    solid_list_init(&stage->list, &stage->scene.scene);
    assert_int_equal(lim_solid_init(&stage->solid, &stage->scene.scene, stage->stack, mem_b), LIM_OK);
}

void solid_stage_end(struct solid_stage *stage)
{
    solid_list_free(&stage->list);
    compiled_free(&stage->scene);
    free(stage->stack);
}

void solid_stage_model(struct solid_stage *stage, const char *path, enum tree_kind tree, enum mesh_leaves leaves)
{
    const struct compile_options options = {
        .tolerance_units = 0.5, .splitter = "fewest", .tree = tree, .mesh_leaves = leaves, .unlit = true};
    struct error err;

    if (!compile_model(path, &options, &stage->scene, &err)) fail_msg("%s", err.text);
    snprintf(stage->name, sizeof stage->name, "%s, %s", path, tree_names[tree]);
    solid_stage_begin(stage, 77 + (uint64_t)tree);
}

void solid_stage_building(struct solid_stage *stage, struct random *random, uint64_t number)
{
    struct room_scene rooms;
    struct error err;

    room_scene_random(&rooms, random);
    if (!room_scene_compile(&rooms, PORTALS_OFF, NULL, &stage->scene, &err)) fail_msg("%s", err.text);
    room_scene_free(&rooms);
    snprintf(stage->name, sizeof stage->name, "a random building");
    solid_stage_begin(stage, 500 + number);
}

void solid_stage_closed(struct solid_stage *stage, struct closed_scene *closed, struct random *random, uint64_t number)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "fewest"};
    struct error err;

    closed_scene_make(closed, random);
    if (!compile_part(&closed->model, NULL, &options, &stage->scene, &err)) fail_msg("%s", err.text);
    snprintf(stage->name, sizeof stage->name, "a closed scene");
    solid_stage_begin(stage, 7000 + number);
}

void solid_stage_in_bounds(struct solid_stage *stage, int64_t part_q8, int32_t at_q8[3])
{
    const struct lim_box *box = &stage->scene.scene.boxes[0];

    for (int i = 0; i < 3; i++) {
        const int64_t half_q8 = box->half[i] * part_q8;
        at_q8[i] = (int32_t)(box->centre[i] * INT64_C(256) + random_in(&stage->random, -half_q8, half_q8));
    }
}

void solid_place_q8(const struct compiled *scene, const double at_m[3], int32_t at_q8[3])
{
    for (int i = 0; i < 3; i++)
        at_q8[i] = (int32_t)lround((at_m[i] - scene->grid.origin_m[i]) * scene->grid.units_per_m * 256);
}
