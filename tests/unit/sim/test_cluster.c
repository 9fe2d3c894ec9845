/* SPDX-License-Identifier: MIT
 *
 * Orders that are right from everywhere: small examples, and rays through random sets. */
#include "compiler/compile.h"
#include "rigs/bsp_rig.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "trees/cluster.h"
#include "trees/rings.h"
#include "trees/sides.h"

#include <math.h>
#include <string.h>

enum { PIECES_MAX = 200, SETS = 60, RAYS = 300 };

/* The faces' numbers in order, or NULL: none was found. */
static const char *order_of(const struct mesh *mesh)
{
    static char names[PIECES_MAX];
    uint32_t order[PIECES_MAX];
    struct bsp_rig rig;

    bsp_rig_make(&rig, mesh, TREE_NONE);
    assert_in_range(rig.bsp.placed_count, 1, PIECES_MAX - 1);
    const bool sorted = cluster_order(&rig.bsp, NULL, rig.all, rig.bsp.placed_count, order);
    for (size_t i = 0; i < rig.bsp.placed_count && sorted; i++)
        names[i] = (char)mesh->polygons[rig.bsp.pieces[order[i]].polygon].face;
    names[rig.bsp.placed_count] = '\0';
    bsp_rig_free(&rig);
    return sorted ? names : NULL;
}

/* Fronts are on the left: walls from left to right in plan look up. */
static void walls_in_a_row_come_nearest_first(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);

    (void)state;
    mesh_rig_wall(&mesh, 'b', -2, 2, 2, 2);
    mesh_rig_wall(&mesh, 'c', -2, 1, 2, 1);
    mesh_rig_wall(&mesh, 'a', -2, 3, 2, 3);
    assert_string_equal(order_of(&mesh), "abc");
    mesh_rig_free(&mesh);
}

static void walls_back_to_back_stay_as_they_are(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);

    (void)state;
    mesh_rig_wall(&mesh, 'b', 2, 1, -2, 1);
    mesh_rig_wall(&mesh, 'a', -2, 2, 2, 2);
    assert_string_equal(order_of(&mesh), "ba");
    mesh_rig_free(&mesh);
}

/* Each can hide the other: now from here, now from there. */
static void two_walls_seen_from_both_sides_have_no_order(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);

    (void)state;
    mesh_rig_wall(&mesh, 'a', -2, 1, 2, 1);
    mesh_rig_wall(&mesh, 'b', -2, 2, 2, 2);
    mesh.polygons[0].two_sided = mesh.polygons[1].two_sided = true;
    assert_null(order_of(&mesh));
    mesh_rig_free(&mesh);
}

static void walls_through_one_another_have_no_order(void **state)
{
    struct mesh mesh = mesh_rig(1000.0);

    (void)state;
    mesh_rig_wall(&mesh, 'a', -2, -2, 2, 2);
    mesh_rig_wall(&mesh, 'b', -2, 2, 2, -2);
    assert_null(order_of(&mesh));
    mesh_rig_free(&mesh);
}

/* In plan: a hides b, b hides c, c hides a; of any two one comes first. */
static void a_ring_of_three_has_no_order(void **state)
{
    static const double walls[3][4] = {{1, 6, 0, 3}, {-6, 2, -2, 4}, {2, -3, 1, 4}};
    static const char *const orders[4] = {"bc", "ca", "ab", NULL};

    (void)state;
    for (int missing = 0; missing <= 3; missing++) {
        struct mesh mesh = mesh_rig(1000.0);
        for (int i = 0; i < 3; i++)
            if (i != missing)
                mesh_rig_wall(&mesh, (uint32_t)('a' + i), walls[i][0], walls[i][1], walls[i][2], walls[i][3]);
        const char *order = order_of(&mesh);
        if (orders[missing])
            assert_string_equal(order, orders[missing]);
        else
            assert_null(order);
        mesh_rig_free(&mesh);
    }
}

/* A row of the polygons named in a text. */
static size_t left_of(struct rings *rings, const char *names)
{
    uint64_t set[1] = {0};
    assert_int_equal(rings->hiding.words, 1);
    for (; *names; names++)
        hiding_add(&rings->hiding, set, (uint32_t)(*names - 'a'));
    return rings_left(rings, set);
}

/* The three of the ring, and a stack of two apart from them. */
static void what_is_in_rings_is_found(void **state)
{
    static const double walls[5][4] = {{1, 6, 0, 3}, {-6, 2, -2, 4}, {2, -3, 1, 4}, {40, 50, 41, 50}, {50, 50, 51, 50}};
    struct mesh mesh = mesh_rig(400.0);
    struct bsp_rig rig;
    struct rings rings;

    (void)state;
    for (int i = 0; i < 5; i++)
        mesh_rig_wall(&mesh, (uint32_t)('a' + i), walls[i][0], walls[i][1], walls[i][2], walls[i][3]);
    bsp_rig_make(&rig, &mesh, TREE_NONE);
    rings_find(&rings, &rig.bsp, rig.all, rig.bsp.placed_count);
    assert_int_equal(left_of(&rings, "abc"), 3);
    assert_in_range(left_of(&rings, "abcde"), 3, 5);
    assert_int_equal(left_of(&rings, "ab"), 0);
    assert_int_equal(left_of(&rings, "bc"), 0);
    assert_int_equal(left_of(&rings, "ca"), 0);
    assert_int_equal(left_of(&rings, ""), 0);
    rings_free(&rings);
    bsp_rig_free(&rig);
    mesh_rig_free(&mesh);
}

/* Some boxes and walls in a heap, each turned another way. */
static void heap_make(struct mesh *mesh, struct random *random, int boxes)
{
    *mesh = mesh_rig(2000.0);
    for (int i = 0; i < boxes; i++) {
        double centre_m[3], half_m[3];
        for (int k = 0; k < 3; k++) {
            centre_m[k] = 8 * random_unit(random) - 4;
            half_m[k] = 0.1 + 0.4 * random_unit(random);
        }
        mesh_rig_box(mesh, centre_m, half_m, 6 * random_unit(random), 6 * random_unit(random));
    }
    for (size_t i = 0; i < mesh->polygon_count; i++)
        mesh->polygons[i].two_sided = random_in(random, 0, 9) == 0;
}

/* What plane by plane gives, bit for bit, of blocks that are full and of some that are not. */
static void hiding_is_what_each_pair_says(void **state)
{
    static const int heaps[] = {2, 11, 31, 32, 33};
    struct random random = {5};

    (void)state;
    for (size_t heap = 0; heap < sizeof heaps / sizeof *heaps; heap++) {
        struct mesh mesh;
        struct bsp_rig rig;
        struct hiding hiding;
        heap_make(&mesh, &random, heaps[heap]);
        bsp_rig_make(&rig, &mesh, TREE_NONE);
        hiding_find(&hiding, &rig.bsp, rig.all, rig.bsp.placed_count);
        assert_int_equal(hiding.count, mesh.polygon_count);
        for (uint32_t p = 0; p < mesh.polygon_count; p++)
            for (uint32_t q = 0; q < mesh.polygon_count; q++) {
                const struct cluster_pair pair = cluster_pair(&rig.bsp, p, q);
                const uint32_t bit = hiding.bit_of[p];
                assert_int_equal(hiding_holds(&hiding, p, q), pair.p_hides_q);
                assert_int_equal(hiding.hidden_by[hiding.bit_of[q] * hiding.words + bit / 64] >> bit % 64 & 1,
                                 pair.p_hides_q);
            }
        hiding_free(&hiding);
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
}

/* What can go goes, one after the other, until nothing can. */
static size_t left_one_by_one(const struct bsp *bsp, bool *in, size_t count)
{
    size_t left = 0;
    for (bool went = true; went;) {
        went = false;
        left = 0;
        for (uint32_t p = 0; p < count; p++) {
            bool hides = false, hidden = false;
            if (!in[p]) continue;
            for (uint32_t q = 0; q < count; q++) {
                const struct cluster_pair pair = cluster_pair(bsp, p, q);
                hides = hides || (in[q] && pair.p_hides_q);
                hidden = hidden || (in[q] && pair.q_hides_p);
            }
            in[p] = hides && hidden;
            went = went || !in[p];
            left += in[p];
        }
    }
    return left;
}

/* Also after a larger set was prepared for, whose witnesses are asked first. */
static void rings_of_parts_are_those_found_one_by_one(void **state)
{
    struct random random = {17};
    size_t left = 0, taken = 0;

    (void)state;
    for (int heap = 0; heap < 8; heap++) {
        struct mesh mesh;
        struct bsp_rig rig;
        struct rings rings;
        heap_make(&mesh, &random, (int)random_in(&random, 4, 24));
        bsp_rig_make(&rig, &mesh, TREE_NONE);
        rings_find(&rings, &rig.bsp, rig.all, rig.bsp.placed_count);
        for (int part = 0; part < 6; part++) {
            bool in[PIECES_MAX] = {false};
            uint64_t set[PIECES_MAX / 64 + 1] = {0};
            for (uint32_t p = 0; p < mesh.polygon_count; p++) {
                in[p] = part == 0 || random_in(&random, 0, part) > 0;
                if (in[p]) hiding_add(&rings.hiding, set, p);
                taken += in[p];
            }
            const size_t found = part == 0 ? rings_prepare(&rings, set) : rings_left(&rings, set);
            assert_int_equal(found, left_one_by_one(&rig.bsp, in, mesh.polygon_count));
            for (uint32_t p = 0; p < mesh.polygon_count; p++)
                assert_int_equal(hiding_has(&rings.hiding, set, p), in[p]);
            left += found;
        }
        rings_free(&rings);
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
    assert_in_range(left, taken / 10, taken * 9 / 10);
}

/* Also what lies on a plane all over, and the pieces of a tree. */
static void sides_are_those_by_which_pieces_are_filed(void **state)
{
    struct random random = {29};
    size_t with[4] = {0};

    (void)state;
    for (int heap = 0; heap < 6; heap++) {
        struct mesh mesh;
        struct bsp_rig rig;
        struct sides sides;
        uint32_t all[4096];
        uint8_t found[4096];
        heap_make(&mesh, &random, 20);
        bsp_rig_make(&rig, &mesh, TREE_AXIS);
        assert_in_range(rig.bsp.piece_count, mesh.polygon_count, 4096);
        for (uint32_t i = 0; i < rig.bsp.piece_count; i++)
            all[i] = i;
        sides_begin(&sides, &rig.bsp, all, rig.bsp.piece_count);
        const uint32_t groups = (uint32_t)(rig.bsp.coplanar->count + rig.bsp.cut_count);
        for (uint32_t group = 0; group < groups; group++) {
            sides_find(&sides, group, found);
            for (uint32_t i = 0; i < rig.bsp.piece_count; i++) {
                const struct bsp_piece *piece = &rig.bsp.pieces[i];
                const int filed =
                    rig.bsp.coplanar->group[piece->polygon] == group ? BSP_ON : bsp_piece_filed(&rig.bsp, piece, group);
                assert_int_equal(found[i], filed);
                with[filed]++;
            }
        }
        sides_end(&sides);
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
    for (int side = 0; side < 4; side++)
        assert_true(with[side] > 100);
}

static void a_box_keeps_its_order(void **state)
{
    const double centre_m[3] = {0, 0, 0}, half_m[3] = {1, 2, 3};
    struct mesh mesh = mesh_rig(1000.0);

    (void)state;
    mesh_rig_box(&mesh, centre_m, half_m, 0.3, 0.2);
    for (size_t i = 0; i < mesh.polygon_count; i++)
        mesh.polygons[i].face = (uint32_t)('a' + i);
    assert_string_equal(order_of(&mesh), "abcdef");
    mesh_rig_free(&mesh);
}

/* Rays --------------------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void from_to(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = b[i] - a[i];
}

/* Where a ray meets the front of a polygon, well inside of it; infinity: nowhere. */
static double meets_at(const struct mesh *mesh, uint32_t index, const double eye[3], const double way[3])
{
    const struct mesh_polygon *polygon = &mesh->polygons[index];
    const double(*points)[3] = (const double(*)[3])mesh->points;
    const uint32_t *corners = &mesh->corners[polygon->first];
    double u[3], v[3], n[3], away[3];

    from_to(points[corners[0]], points[corners[1]], u);
    from_to(points[corners[0]], points[corners[2]], v);
    cross(u, v, n);
    from_to(eye, points[corners[0]], away);
    if (dot(n, way) >= 0) return INFINITY;
    const double t = dot(n, away) / dot(n, way);
    for (uint32_t k = 0; k < polygon->count; k++) {
        double inward[3], to[3], edge[3];
        from_to(points[corners[k]], points[corners[(k + 1) % polygon->count]], edge);
        cross(n, edge, inward);
        for (int i = 0; i < 3; i++)
            to[i] = eye[i] + t * way[i] - points[corners[k]][i];
        if (dot(inward, to) <= 0.002 * sqrt(dot(inward, inward))) return INFINITY;
    }
    return t > 0.001 ? t : INFINITY;
}

/* The first in order that a ray meets is the nearest that it meets. */
static void assert_right_along_rays(const struct mesh *mesh, const struct bsp *bsp, const uint32_t *order,
                                    struct random *random, int *hits)
{
    for (int ray = 0; ray < RAYS; ray++) {
        const double *towards = mesh->points[random_in(random, 0, (int64_t)mesh->point_count - 1)];
        double eye[3], way[3], first = INFINITY, nearest = INFINITY;
        for (int i = 0; i < 3; i++) {
            eye[i] = 12 * random_unit(random) - 6;
            way[i] = towards[i] + 0.4 * random_unit(random) - 0.2 - eye[i];
        }
        for (size_t i = 0; i < bsp->placed_count; i++) {
            const double t = meets_at(mesh, bsp->pieces[order[i]].polygon, eye, way);
            if (isinf(first)) first = t;
            nearest = fmin(nearest, t);
        }
        *hits += !isinf(first);
        assert_true(isinf(first) || first <= nearest + 0.002);
    }
}

/* Boxes apart from one another, some of which hide others: some sets have an order and some have none. */
static void an_order_is_right_along_every_ray(void **state)
{
    struct random random = {11};
    int sorted = 0, hits = 0;

    (void)state;
    for (int set = 0; set < SETS; set++) {
        struct mesh mesh = mesh_rig(2000.0);
        struct bsp_rig rig;
        uint32_t order[PIECES_MAX];
        const int boxes = (int)random_in(&random, 2, 4);
        for (int i = 0; i < boxes; i++) {
            const double centre_m[3] = {i * 1.2 - 2, random_unit(&random) * 3, random_unit(&random) * 3};
            const double half_m[3] = {0.05 + 0.3 * random_unit(&random), 0.3 * random_unit(&random) + 0.05, 0.4};
            mesh_rig_box(&mesh, centre_m, half_m, random_unit(&random), random_unit(&random));
        }
        bsp_rig_make(&rig, &mesh, TREE_NONE);
        if (cluster_order(&rig.bsp, NULL, rig.all, rig.bsp.placed_count, order)) {
            assert_right_along_rays(&mesh, &rig.bsp, order, &random, &hits);
            sorted++;
        }
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
    assert_in_range(sorted, SETS / 10, SETS - 1);
    assert_true(hits > 1000);
}

/* In trees, whose leaves hold pieces as well. */
static void leaves_of_trees_are_sorted(void **state)
{
    struct random random = {3};

    (void)state;
    for (enum tree_kind kind = TREE_CLUSTERS; kind <= TREE_OCTREE; kind++) {
        struct mesh mesh = mesh_rig(3000.0);
        struct bsp_rig rig;
        size_t leaves = 0;
        mesh_rig_solids(&mesh, &random, 6);
        bsp_rig_make(&rig, &mesh, kind);
        struct hiding hiding;
        hiding_find(&hiding, &rig.bsp, rig.bsp.placed, rig.bsp.placed_count);
        for (size_t i = 0; i < rig.bsp.node_count; i++) {
            const struct bsp_node *node = &rig.bsp.nodes[i];
            uint32_t order[4096];
            if (node->group != BSP_NONE) continue;
            leaves++;
            assert_true(cluster_order(&rig.bsp, NULL, &rig.bsp.placed[node->first], node->count, order));
            assert_memory_equal(order, &rig.bsp.placed[node->first], node->count * sizeof *order);
            assert_true(cluster_order(&rig.bsp, &hiding, &rig.bsp.placed[node->first], node->count, order));
            assert_memory_equal(order, &rig.bsp.placed[node->first], node->count * sizeof *order);
        }
        assert_true(leaves > 1);
        hiding_free(&hiding);
        bsp_rig_free(&rig);
        mesh_rig_free(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_in_a_row_come_nearest_first),
        cmocka_unit_test(walls_back_to_back_stay_as_they_are),
        cmocka_unit_test(two_walls_seen_from_both_sides_have_no_order),
        cmocka_unit_test(walls_through_one_another_have_no_order),
        cmocka_unit_test(a_ring_of_three_has_no_order),
        cmocka_unit_test(what_is_in_rings_is_found),
        cmocka_unit_test(hiding_is_what_each_pair_says),
        cmocka_unit_test(rings_of_parts_are_those_found_one_by_one),
        cmocka_unit_test(sides_are_those_by_which_pieces_are_filed),
        cmocka_unit_test(a_box_keeps_its_order),
        cmocka_unit_test(an_order_is_right_along_every_ray),
        cmocka_unit_test(leaves_of_trees_are_sorted),
    };

    return cmocka_run_group_tests_name("cluster", tests, NULL, NULL);
}
