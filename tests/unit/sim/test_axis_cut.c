/* SPDX-License-Identifier: MIT
 *
 * Axis planes that divide lists: which are tried, which is taken, and when none is. */
#include "rigs/bsp_rig.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "trees/axis_cut.h"

#include <stdlib.h>
#include <string.h>

static const double UNITS_PER_M = 1000.0;
static const struct bsp_place ROOT = {BSP_NONE, false};
enum { CANDIDATES = 10 };

static struct mesh boxes(int count, double apart_m, double half_z_m)
{
    struct mesh mesh = mesh_rig(UNITS_PER_M);

    for (int i = 0; i < count; i++) {
        const double centre_m[3] = {i * apart_m, 0, 0}, half_m[3] = {0.5, 0.5, half_z_m};
        mesh_rig_box(&mesh, centre_m, half_m, 0, 0);
    }
    return mesh;
}

static const struct splitter *weighted(void)
{
    for (size_t i = 0; i < splitter_count; i++)
        if (strcmp(splitters[i].name, "weighted-12") == 0) return &splitters[i];
    fail();
    return NULL;
}

static void candidates_are_ends_of_pieces_in_order(void **state)
{
    struct mesh mesh = boxes(4, 2, 0.5);
    struct bsp_rig rig;
    int32_t at[CANDIDATES];

    (void)state;
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    const size_t count = axis_cut_candidates(&rig.bsp, rig.all, rig.bsp.placed_count, 0, CANDIDATES, at);
    assert_int_equal(count, CANDIDATES);
    for (size_t i = 0; i < count; i++) {
        const int32_t in_box = (at[i] + 500) % 2000;
        assert_true(in_box == 0 || in_box == 1000);
        assert_true(i == 0 || at[i] >= at[i - 1]);
    }
    assert_int_equal(at[0], -500);
    assert_true(at[count - 1] >= 3 * 2000 - 500);
    assert_int_equal(axis_cut_candidates(&rig.bsp, rig.all, 1, 0, CANDIDATES, at), 2);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* Four boxes in a row: in the middle, where nothing is split and both sides have the same. */
static void the_best_cut_splits_nothing_and_halves(void **state)
{
    struct mesh mesh = boxes(4, 2, 0.5);
    struct bsp_rig rig;
    double cost;

    (void)state;
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    const uint32_t cut = axis_cut_best(&rig.bsp, weighted(), rig.all, rig.bsp.placed_count, &cost);
    assert_true(cut != BSP_NONE && cut >= rig.coplanar.count);
    assert_int_equal(bsp_plane(&rig.bsp, cut)->kind, PLANE_X);
    assert_in_range(bsp_plane(&rig.bsp, cut)->d, 2500, 3500);
    assert_true(cost >= 0 && cost <= 2); /* a piece that lies in the cut counts as in front of it */
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* Tall plates one behind the other, aslant: any cut that parts them goes through most of them. */
static void there_is_none_where_all_would_be_split(void **state)
{
    struct mesh mesh = mesh_rig(UNITS_PER_M);
    struct bsp_rig rig;
    double cost;

    (void)state;
    for (int i = 0; i < 8; i++) {
        const double z = 0.1 * i, corners_m[4][3] = {{-3, -3, z}, {3, -3, z}, {3, 3, z + 5}, {-3, 3, z + 5}};
        mesh_rig_add(&mesh, corners_m, 4);
    }
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    assert_int_equal(axis_cut_best(&rig.bsp, weighted(), rig.all, rig.bsp.placed_count, &cost), BSP_NONE);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* x = 0 goes through four of the first box's six faces, of twelve in all. */
static void halving_gives_up_where_too_much_lies_across(void **state)
{
    struct mesh mesh = boxes(2, 8, 0.5);
    struct bsp_rig rig;

    (void)state;
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    assert_int_equal(axis_cut_halving(&rig.bsp, ROOT, rig.all, rig.bsp.placed_count), BSP_NONE);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* x = 0, y = 0 and z = 0 have both on one side; the next is x = -16384. */
static void halving_takes_the_first_half_that_divides(void **state)
{
    static const double corner_m[2][3] = {{-20, 5, 5}, {-4, 5, 6}};
    struct mesh mesh = mesh_rig(UNITS_PER_M);
    struct bsp_rig rig;

    (void)state;
    for (int i = 0; i < 2; i++) {
        const double *c = corner_m[i],
                     corners_m[3][3] = {{c[0], c[1], c[2]}, {c[0] + 0.1, c[1], c[2]}, {c[0], c[1] + 0.1, c[2] + 0.1}};
        mesh_rig_add(&mesh, corners_m, 3);
    }
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    const uint32_t cut = axis_cut_halving(&rig.bsp, ROOT, rig.all, 2);
    assert_true(cut != BSP_NONE);
    assert_int_equal(bsp_plane(&rig.bsp, cut)->kind, PLANE_X);
    assert_int_equal(bsp_plane(&rig.bsp, cut)->d, -16384);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* One place: no cube of 16 units or more divides it. */
static void halving_ends(void **state)
{
    struct mesh mesh = mesh_rig(UNITS_PER_M);
    struct bsp_rig rig;

    (void)state;
    for (int i = 0; i < 3; i++) {
        const double z = 0.001 * i, corners_m[3][3] = {{5.001, 5.001, z + 5.001},
                                                       {5.002, 5.001, z + 5.001},
                                                       {5.001, 5.002, z + 5.002}};
        mesh_rig_add(&mesh, corners_m, 3);
    }
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    assert_int_equal(axis_cut_halving(&rig.bsp, ROOT, rig.all, rig.bsp.placed_count), BSP_NONE);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* Every piece lies in the cell that the cuts above it leave; but for the tolerance. */
static void pieces_lie_in_their_cells(void **state)
{
    struct random random = {5};

    (void)state;
    for (enum tree_kind kind = TREE_AXIS; kind <= TREE_OCTREE; kind++) {
        struct mesh mesh = mesh_rig(3000.0);
        struct bsp_rig rig;
        size_t cuts = 0;
        mesh_rig_solids(&mesh, &random, 10);
        bsp_rig_make(&rig, &mesh, kind);
        for (size_t i = 0; i < rig.bsp.node_count; i++)
            cuts += rig.bsp.nodes[i].group != BSP_NONE && rig.bsp.nodes[i].group >= rig.coplanar.count;
        assert_true(cuts > 3);
        assert_true(bsp_worst_violation(&rig.bsp) <= 0.51);
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
}

/* Three faces are a little behind x = 5000, the only coordinate that seems to part them from three others; within the
 * tolerance they lie on it. A cut there would leave all six together, and be taken again and again. */
static void a_cut_counts_pieces_where_they_are_filed(void **state)
{
    struct mesh mesh = mesh_rig(UNITS_PER_M);
    struct bsp_rig rig;
    double cost;

    (void)state;
    for (int i = 0; i < 6; i++) {
        const double x = i < 3 ? 4.9997 : 3, y = i % 3 * 0.0002;
        const double corners_m[4][3] = {{x, y, 0}, {x, y + 1, 0}, {x, y + 1, 3}, {x, y, 3}};
        mesh_rig_add(&mesh, corners_m, 4);
    }
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    uint32_t *list = rig.all;
    const uint32_t cut = axis_cut_best(&rig.bsp, weighted(), list, rig.bsp.placed_count, &cost);
    size_t front = 0;
    for (size_t i = 0; i < rig.bsp.placed_count && cut != BSP_NONE; i++)
        front += bsp_piece_filed(&rig.bsp, &rig.bsp.pieces[list[i]], cut) == BSP_FRONT;
    assert_true(cut == BSP_NONE || front == 3);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(candidates_are_ends_of_pieces_in_order),
        cmocka_unit_test(the_best_cut_splits_nothing_and_halves),
        cmocka_unit_test(there_is_none_where_all_would_be_split),
        cmocka_unit_test(halving_gives_up_where_too_much_lies_across),
        cmocka_unit_test(halving_takes_the_first_half_that_divides),
        cmocka_unit_test(halving_ends),
        cmocka_unit_test(pieces_lie_in_their_cells),
        cmocka_unit_test(a_cut_counts_pieces_where_they_are_filed),
    };

    return cmocka_run_group_tests_name("axis cuts", tests, NULL, NULL);
}
