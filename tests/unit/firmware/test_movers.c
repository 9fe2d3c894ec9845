/* SPDX-License-Identifier: MIT
 *
 * Objects in a scene: before, behind and astride a wall, in a doorway, through one another; many at random against the
 * reference; and what becomes of those that cannot be drawn. */
#include "compiler/moving_compile.h"
#include "core/core.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mover_rig.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double UPRIGHT[3] = {0, 1, 0}, SLANTED[3] = {0.3, 1, 0.2};

/* A cube of 60 cm at z, in a closed half of the room, seen from z = 3. */
static size_t cube_pixels(double z_m, struct lim_mover_stats *stats)
{
    struct mover_rig rig = {0};
    const struct model_pose pose = mover_rig_pose(0.3, 1.2, z_m, UPRIGHT, 0);

    mover_rig_add_rooms(&rig, false);
    mover_rig_add_box(&rig, 0.3, 0.3, 0.3, &pose);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    mover_rig_view(&rig, (double[3]){-0.6, 1.9, 3}, (double[3]){0, 1.2, 0});
    const size_t pixels = mover_rig_pixels(&rig, 1);
    *stats = mover_rig_stats(&rig)->movers;
    mover_rig_assert_right(&rig, 500);
    mover_rig_free(&rig);
    return pixels;
}

static void in_front_of_a_wall_it_is_seen(void **state)
{
    struct lim_mover_stats stats;
    (void)state;
    assert_true(cube_pixels(1, &stats) > 500);
    assert_int_equal(stats.crowded, 0);
    assert_int_equal(stats.comparisons, 0);
}

static void behind_a_wall_it_is_not(void **state)
{
    struct lim_mover_stats stats;
    (void)state;
    assert_int_equal(cube_pixels(-1, &stats), 0);
}

static void astride_a_wall_its_front_is_seen(void **state)
{
    struct lim_mover_stats stats;
    (void)state;
    const size_t astride = cube_pixels(0, &stats);
    assert_int_equal(stats.crowded, 1);
    assert_true(stats.cuts > 0);
    assert_true(astride > 100 && astride < cube_pixels(0.5, &stats));
}

/* What lies in a plane counts as on the eye's side of it. */
static void a_face_in_the_plane_of_a_wall_is_seen(void **state)
{
    struct mover_rig rig = {0};
    const struct model_pose pose = mover_rig_pose(0, 1.2, -0.2, UPRIGHT, 0);
    (void)state;

    mover_rig_add_rooms(&rig, false);
    mover_rig_add_box(&rig, 0.3, 0.3, 0.3, &pose);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    mover_rig_view(&rig, (double[3]){0, 1.5, 3}, (double[3]){0, 1.2, 0});
    assert_in_range(mover_rig_pixels(&rig, 1), 300, 450);
    mover_rig_free(&rig);
}

static void in_a_doorway_it_is_seen_from_both_sides(void **state)
{
    struct mover_rig rig = {0};
    const struct model_pose pose = mover_rig_pose(0.3, 1, 0.05, SLANTED, 0.7);
    (void)state;

    mover_rig_add_rooms(&rig, true);
    mover_rig_add_box(&rig, 0.4, 0.5, 0.4, &pose); /* reaches into the door's post */
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    for (int i = 0; i < 12; i++) {
        const double angle = i * 0.5236 + 0.1;
        mover_rig_view(&rig, (double[3]){3 * sin(angle), 1.6, 3 * cos(angle)}, (double[3]){0, 1, 0});
        if (fabs(cos(angle)) > 0.9) assert_true(mover_rig_pixels(&rig, 1) > 400);
    }
    mover_rig_assert_right(&rig, 500);
    mover_rig_free(&rig);
}

/* Two bars that cross like an X, and a third through both: no order of whole polygons is right. */
static void add_crossing(struct mover_rig *rig)
{
    const struct model_pose one = mover_rig_pose(0, 1.4, 1.5, SLANTED, 0.9);
    const struct model_pose two = mover_rig_pose(0.05, 1.4, 1.5, SLANTED, 2.5);
    const struct model_pose three = mover_rig_pose(0, 1.45, 1.55, (double[3]){1, 0.2, 0}, 0.4);

    mover_rig_add_rooms(rig, true);
    mover_rig_add_box(rig, 0.9, 0.15, 0.15, &one);
    mover_rig_add_box(rig, 0.9, 0.12, 0.2, &two);
    mover_rig_add_box(rig, 0.2, 0.8, 0.1, &three);
}

static void view_crossing(struct mover_rig *rig)
{
    for (int i = 0; i < 12; i++) {
        const double angle = i * 0.5236 + 0.1;
        mover_rig_view(rig, (double[3]){2 * sin(angle), 1.6 + 0.1 * i, 1.5 + 2 * cos(angle)}, (double[3]){0, 1.4, 1.5});
    }
}

static void through_one_another_they_are_cut(void **state)
{
    struct mover_rig rig = {0};
    (void)state;

    add_crossing(&rig);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    view_crossing(&rig);
    const struct lim_mover_stats *stats = &mover_rig_stats(&rig)->movers;
    assert_int_equal(stats->crowded, 3);
    assert_true(stats->cuts > 0 && stats->comparisons >= stats->cuts);
    mover_rig_assert_right(&rig, 600);
    mover_rig_free(&rig);
}

/* Trees with leaves, whose orders know nothing of what moves. */
static void in_any_tree_they_are_right(void **state)
{
    const enum tree_kind kinds[] = {TREE_CLUSTERS, TREE_AXIS, TREE_OCTREE};
    (void)state;

    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct mover_rig rig = {.tree = kinds[i]};
        add_crossing(&rig);
        mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
        view_crossing(&rig);
        mover_rig_assert_right(&rig, 600);
        mover_rig_free(&rig);
    }
}

/* Random ------------------------------------------------------------------------------------- */

static struct model_pose random_pose(struct random *random)
{
    const double axis[3] = {random_unit(random) + 0.01, random_unit(random) - 0.5, random_unit(random) - 0.5};

    return mover_rig_pose(random_unit(random) * 6 - 3, 0.2 + random_unit(random) * 2.6, random_unit(random) * 6 - 3,
                          axis, random_unit(random) * 6.28);
}

static void add_random_mover(struct mover_rig *rig, struct random *random)
{
    const struct model_pose pose = random_pose(random);
    double corners_m[4][3];

    if (random_in(random, 0, 1)) {
        mover_rig_add_box(rig, 0.1 + random_unit(random), 0.1 + random_unit(random), 0.1 + random_unit(random), &pose);
        return;
    }
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners_m[k][i] = (k == i ? 1.2 : -0.2) + 0.4 * random_unit(random);
    boxes_add_tetrahedron(&rig->model, (const double(*)[3])corners_m, false);
    mover_rig_moves(rig, &pose);
}

static void add_random_things(struct mover_rig *rig, struct random *random)
{
    for (int i = 0; i < 3; i++) {
        double low_m[3], high_m[3];
        for (int k = 0; k < 3; k++) {
            low_m[k] = k == 1 ? 0 : floor(random_unit(random) * 60 - 30) / 10 + 0.05 * k;
            high_m[k] = low_m[k] + 0.3 + floor(random_unit(random) * 10) / 10;
        }
        boxes_add_solid(&rig->model, low_m, high_m);
    }
    mover_rig_stands(rig);
}

static void draw_random(struct random *random, const struct core *core, struct compare_counts *sum)
{
    struct mover_rig rig = {0};
    const int count = (int)random_in(random, 1, 5);

    mover_rig_add_rooms(&rig, true);
    add_random_things(&rig, random);
    for (int i = 0; i < count; i++)
        add_random_mover(&rig, random);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, core);
    for (int i = 0; i < 8; i++) {
        const double eye_m[3] = {random_unit(random) * 7 - 3.5, 0.3 + random_unit(random) * 2.4,
                                 random_unit(random) * 7 - 3.5};
        mover_rig_view(&rig, eye_m, (double[3]){random_unit(random) - 0.5, 1.2, random_unit(random) - 0.5});
    }
    sum->pixels += rig.counts.pixels;
    sum->wrong += rig.counts.wrong;
    sum->beyond += rig.counts.beyond;
    sum->holes += rig.counts.holes;
    mover_rig_free(&rig);
}

static void assert_random_right(uint64_t seed, int scenes, const struct core *core, double ppm, double beyond_ppm)
{
    struct random random = {seed};
    struct compare_counts sum = {0};

    for (int i = 0; i < scenes; i++)
        draw_random(&random, core, &sum);
    print_message("%zu pixels: %.1f ppm wrong, %.2f beyond a pixel, %zu holes\n", sum.pixels,
                  1e6 * (double)sum.wrong / (double)sum.pixels, 1e6 * (double)sum.beyond / (double)sum.pixels,
                  sum.holes);
    assert_true(1e6 * (double)sum.wrong <= ppm * (double)sum.pixels);
    assert_true(1e6 * (double)sum.beyond <= beyond_ppm * (double)sum.pixels);
    assert_int_equal(sum.holes, 0);
}

static void at_random_they_are_where_the_reference_has_them(void **state)
{
    (void)state;
    assert_random_right(0x5eed, 12, NULL, 100, 2);
}

static void the_more_exact_the_profile_the_fewer_are_wrong(void **state)
{
    (void)state;
    assert_random_right(0xf1e, 6, &core_fine, 80, 1);
    assert_random_right(0xe8ac7, 6, &core_exact, 60, 1);
}

/* Bending ------------------------------------------------------------------------------------ */

enum { FLAG_COLUMNS = 6, FLAG_ROWS = 4 };

/* A flag of two-sided triangles in its own plane. */
static void add_flag(struct mover_rig *rig, const struct model_pose *pose)
{
    const size_t first = rig->model.face_count;

    for (int i = 0; i < FLAG_COLUMNS * FLAG_ROWS; i++) {
        const double x = i % FLAG_COLUMNS * 0.2 - 0.6, y = i / FLAG_COLUMNS * 0.2 - 0.4;
        const double at[4][3] = {{x, y, 0}, {x + 0.2, y, 0}, {x + 0.2, y + 0.2, 0}, {x, y + 0.2, 0}};
        const double halves[2][3][3] = {{{at[0][0], at[0][1], 0}, {at[1][0], at[1][1], 0}, {at[2][0], at[2][1], 0}},
                                        {{at[0][0], at[0][1], 0}, {at[2][0], at[2][1], 0}, {at[3][0], at[3][1], 0}}};
        for (int k = 0; k < 2; k++)
            tiny_add(&rig->model, 3, (const double(*)[3])halves[k]);
    }
    for (size_t i = first; i < rig->model.face_count; i++)
        rig->model.faces[i].two_sided = true;
    mover_rig_moves(rig, pose);
}

static void wave(double at_m[3], double phase)
{
    at_m[2] += 0.25 * sin(5 * at_m[0] + phase) + 0.1 * sin(7 * at_m[1] + 2 * phase);
}

/* Bends the flag, the first mover, in the firmware's hands and in the reference. */
static void bend_flag(struct mover_rig *rig, struct lim_scene *copy, struct lim_vertex *vertices, double phase)
{
    const struct compiled *scene = &rig->moving.objects[0].scene;

    *copy = rig->ids.objects[0];
    for (size_t i = 0; i < copy->vertex_count; i++) {
        const struct lim_vertex *from = &scene->scene.vertices[i];
        double at_m[3] = {from->x / scene->grid.units_per_m, from->y / scene->grid.units_per_m,
                          from->z / scene->grid.units_per_m};
        wave(at_m, phase);
        vertices[i] = (struct lim_vertex){(int16_t)lround(at_m[0] * scene->grid.units_per_m),
                                          (int16_t)lround(at_m[1] * scene->grid.units_per_m),
                                          (int16_t)lround(at_m[2] * scene->grid.units_per_m)};
    }
    copy->vertices = vertices;
    copy->fractions = NULL;
    rig->ids.objects[0] = *copy;
    mover_rig_bend(rig, 1, wave, phase);
}

static void a_flag_bends_in_the_wind(void **state)
{
    struct mover_rig rig = {0};
    struct lim_vertex vertices[4 * FLAG_COLUMNS * FLAG_ROWS];
    struct lim_scene copy;
    const struct model_pose pose = mover_rig_pose(0.1, 1.4, 1.5, SLANTED, 0.6);
    const struct model_pose pole = mover_rig_pose(0.1, 1.4, 1.5, SLANTED, 0.2);
    (void)state;

    mover_rig_add_rooms(&rig, true);
    add_flag(&rig, &pose);
    mover_rig_add_box(&rig, 0.05, 0.9, 0.05, &pole); /* right through it */
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    rig.moving.instances[0].deforms = true;
    assert_true(rig.moving.objects[0].scene.scene.vertex_count <= sizeof vertices / sizeof *vertices);
    for (int i = 0; i < 8; i++) {
        const double angle = i * 0.8 + 0.1;
        bend_flag(&rig, &copy, vertices, i * 0.7);
        mover_rig_view(&rig, (double[3]){2 * sin(angle), 1.6, 1.5 + 2 * cos(angle)}, (double[3]){0, 1.4, 1.5});
        assert_true(mover_rig_pixels(&rig, 1) > 300);
    }
    print_message("a flag: %zu of %zu wrong, %zu holes, %u cuts\n", rig.counts.wrong, rig.counts.pixels,
                  rig.counts.holes, (unsigned)mover_rig_stats(&rig)->movers.cuts);
    mover_rig_assert_right(&rig, 400);
    mover_rig_free(&rig);
}

/* Too much, too little ----------------------------------------------------------------------- */

static void too_little_memory_is_refused(void **state)
{
    struct mover_rig rig = {0};
    (void)state;

    add_crossing(&rig);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    const struct simulator *simulator = &rig.ids.simulator;
    const size_t mem_b = simulator->core->movers_mem_b(&rig.ids.scene, &rig.moving.limits);
    assert_int_equal(simulator->core->movers_init(simulator->lim, simulator->mover_mem, mem_b - 1, &rig.moving.limits),
                     LIM_ERR_MEMORY);
    mover_rig_free(&rig);
}

/* Draws with instances that are changed; how many are left out. */
static uint32_t left_out(struct mover_rig *rig, const struct lim_instance *instances, uint16_t count)
{
    const struct simulator *simulator = &rig->ids.simulator;
    const struct lim_camera camera = {.near_q8 = 256, .tan_x_q28 = 1u << 28, .tan_y_q28 = 1u << 28};

    assert_int_equal(simulator->core->movers_frame(simulator->lim, &camera, instances, count), LIM_OK);
    return mover_rig_stats(rig)->movers.left_out;
}

static void what_cannot_be_drawn_is_left_out_and_counted(void **state)
{
    struct mover_rig rig = {0};
    struct lim_instance instances[5];
    const struct lim_scene nothing = {0};
    (void)state;

    add_crossing(&rig);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    for (int i = 0; i < 5; i++)
        instances[i] = rig.moving.instances[i % 3];
    assert_int_equal(left_out(&rig, instances, 3), 0);
    assert_int_equal(left_out(&rig, instances, 5), 2); /* three are declared */
    assert_int_equal(left_out(&rig, NULL, 0), 0);
    instances[0].object = NULL;
    assert_int_equal(left_out(&rig, instances, 3), 1);
    instances[0].object = &nothing;
    assert_int_equal(left_out(&rig, instances, 3), 1);
    instances[1].at_q8[2] = INT32_MIN;
    assert_int_equal(left_out(&rig, instances, 3), 2);
    instances[1].at_q8[2] = 0xFFFFFF;
    assert_int_equal(left_out(&rig, instances, 3), 2);
    instances[2].finer_bits = 4;
    assert_int_equal(left_out(&rig, instances, 3), 3);
    mover_rig_free(&rig);
}

static void a_distant_eye_leaves_them_out(void **state)
{
    struct mover_rig rig = {0};
    (void)state;

    add_crossing(&rig);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    const double far_m = 1000000 / rig.scene.grid.units_per_m;
    mover_rig_view(&rig, (double[3]){far_m, 1, far_m / 3}, (double[3]){0, 1, 0});
    assert_int_equal(mover_rig_stats(&rig)->movers.left_out, 3);
    mover_rig_free(&rig);
}

/* The simulator refuses them; the renderer draws what stands still. */
static void assert_others_draw_none(const struct mover_rig *rig, enum lim_method method)
{
    const struct simulator_setup setup = {64, 64, method, SIMULATOR_MEMORY, NULL};
    const struct lim_camera camera = {
        .eye_q8 = {0, 0, 2 << 16}, .near_q8 = 256, .tan_x_q28 = 1u << 28, .tan_y_q28 = 1u << 28};
    struct simulator simulator;
    struct error err;
    uint16_t still[64 * 64];

    assert_true(simulator_init(&simulator, &rig->scene.scene, &setup, &err));
    assert_false(simulator_set_movers(&simulator, rig->moving.instances, 3, &rig->moving.limits, &err));
    assert_non_null(strstr(err.text, "it moves no objects"));
    const struct core *core = simulator.core;
    const size_t mem_b = core->movers_mem_b(&rig->scene.scene, &rig->moving.limits);
    void *mem = malloc(mem_b);
    assert_int_equal(core->frame(simulator.lim, &camera), LIM_OK);
    memcpy(still, simulator.pixels, sizeof still);
    memset(simulator.pixels, 0xA5, sizeof still);
    assert_int_equal(core->movers_init(simulator.lim, mem, mem_b, &rig->moving.limits), LIM_OK);
    assert_int_equal(core->movers_frame(simulator.lim, &camera, rig->moving.instances, 3), LIM_OK);
    assert_int_equal(core->stats(simulator.lim)->movers.left_out, 3);
    assert_memory_equal(simulator.pixels, still, sizeof still);
    free(mem);
    simulator_free(&simulator);
}

static void methods_that_draw_none_leave_them_out(void **state)
{
    static const enum lim_method others[] = {LIM_PAINTER, LIM_DEPTH, LIM_NEWELL};
    struct mover_rig rig = {0};
    (void)state;

    add_crossing(&rig);
    mover_rig_compile(&rig, LIM_NEAREST_FIRST, NULL);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_others_draw_none(&rig, others[i]);
    mover_rig_free(&rig);
}

/* Pools of the least size: the frame takes many walks, in each of which movers meet anew. */
static void in_bands_the_picture_is_the_same(void **state)
{
    struct mover_rig rigs[2];
    (void)state;

    memset(rigs, 0, sizeof rigs);
    for (int i = 0; i < 2; i++) {
        add_crossing(&rigs[i]);
        mover_rig_compile(&rigs[i], LIM_NEAREST_FIRST, NULL);
        struct simulator *simulator = &rigs[i].ids.simulator;
        const size_t least_b = simulator->core->mem_min_b(&rigs[i].ids.scene, &simulator->target);
        if (i) {
            assert_true(least_b < simulator->mem_b);
            assert_int_equal(
                simulator->core->init(simulator->lim, &rigs[i].ids.scene, &simulator->target, simulator->mem, least_b),
                0);
            assert_int_equal(
                simulator->core->movers_init(simulator->lim, simulator->mover_mem,
                                             simulator->core->movers_mem_b(&rigs[i].ids.scene, &rigs[i].moving.limits),
                                             &rigs[i].moving.limits),
                0);
        }
        mover_rig_view(&rigs[i], (double[3]){1, 1.8, 3.4}, (double[3]){0, 1.3, 1.4});
    }
    assert_int_equal(mover_rig_stats(&rigs[0])->bands, 0);
    assert_true(mover_rig_stats(&rigs[1])->bands > 0);
    assert_memory_equal(rigs[0].ids.faces, rigs[1].ids.faces,
                        sizeof *rigs[0].ids.faces * MOVER_RIG_W_PX * MOVER_RIG_H_PX);
    for (int i = 0; i < 2; i++)
        mover_rig_free(&rigs[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_front_of_a_wall_it_is_seen),
        cmocka_unit_test(behind_a_wall_it_is_not),
        cmocka_unit_test(astride_a_wall_its_front_is_seen),
        cmocka_unit_test(a_face_in_the_plane_of_a_wall_is_seen),
        cmocka_unit_test(in_a_doorway_it_is_seen_from_both_sides),
        cmocka_unit_test(through_one_another_they_are_cut),
        cmocka_unit_test(in_any_tree_they_are_right),
        cmocka_unit_test(a_flag_bends_in_the_wind),
        cmocka_unit_test(too_little_memory_is_refused),
        cmocka_unit_test(what_cannot_be_drawn_is_left_out_and_counted),
        cmocka_unit_test(a_distant_eye_leaves_them_out),
        cmocka_unit_test(methods_that_draw_none_leave_them_out),
        cmocka_unit_test(in_bands_the_picture_is_the_same),
        cmocka_unit_test(at_random_they_are_where_the_reference_has_them),
        cmocka_unit_test(the_more_exact_the_profile_the_fewer_are_wrong),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
