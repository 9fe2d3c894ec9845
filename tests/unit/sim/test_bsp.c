/* SPDX-License-Identifier: MIT
 *
 * The tree: the worked examples of the literature, and what must hold for every tree, checked in
 * rationals on closed solids, needles and polygons through one another. */
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "trees/bsp_build.h"

#include <stdlib.h>
#include <string.h>

/* Worked examples ---------------------------------------------------------------------------- */

enum { ORDER_MAX = 64 };

struct order {
    const struct compiled *scene;
    int32_t eye[3]; /* units */
    bool cull;      /* only what faces the eye */
    char names[ORDER_MAX];
    size_t count;
};

static bool is_in_front(const struct order *order, lim_index node)
{
    int64_t n[3], d;
    plane_exact(&order->scene->scene, &order->scene->scene.nodes[node].split, n, &d);
    int64_t value = n[0] * order->eye[0] + n[1] * order->eye[1] + n[2] * order->eye[2] - d;
    assert_true(value != 0);
    return value > 0;
}

static size_t record_at(const struct lim_scene *scene, lim_index run)
{
    size_t record = 0, at = 0;
    for (; at < run; record++)
        at += lim_record_words(scene->polygons[at]);
    return record;
}

/* Faces of these scenes are numbered by letters; a run holds one. */
static void name_run(struct order *order, lim_index run)
{
    assert_true(order->count + 1 < ORDER_MAX);
    if (run != LIM_NO_INDEX)
        order->names[order->count++] = (char)order->scene->faces[record_at(&order->scene->scene, run)];
}

static void walk(struct order *order, lim_index index, bool far_to_near)
{
    if (index == LIM_NO_INDEX) return;
    const struct lim_node *node = &order->scene->scene.nodes[index];
    bool front = is_in_front(order, index), front_first = front != far_to_near;
    walk(order, front_first ? node->front : node->back, far_to_near);
    if (!order->cull || front) name_run(order, node->front_run);
    if (!order->cull || !front) name_run(order, node->back_run);
    walk(order, front_first ? node->back : node->front, far_to_near);
}

/* The eye is given in plan. */
static void assert_order(const struct compiled *scene, double x, double y, bool cull, const char *far_to_near)
{
    const double units = scene->grid.units_per_m;
    struct order order = {.scene = scene, .eye = {(int32_t)(y * units), 0, (int32_t)(x * units)}, .cull = cull};
    walk(&order, 0, true);
    assert_string_equal(order.names, far_to_near);
    struct order nearest = {.scene = scene, .eye = {order.eye[0], 0, order.eye[2]}, .cull = cull};
    walk(&nearest, 0, false);
    assert_int_equal(nearest.count, order.count);
    for (size_t i = 0; i < order.count; i++)
        assert_int_equal(nearest.names[i], order.names[order.count - 1 - i]);
}

/* The tree as text: NAME(front,back), '-' for no child. */
static void describe(const struct compiled *scene, lim_index index, char *out)
{
    struct order name = {.scene = scene};
    if (index == LIM_NO_INDEX) {
        strcat(out, "-");
        return;
    }
    const struct lim_node *node = &scene->scene.nodes[index];
    name_run(&name, node->front_run);
    name_run(&name, node->back_run);
    strcat(out, name.names);
    if (node->front == LIM_NO_INDEX && node->back == LIM_NO_INDEX) return;
    strcat(out, "(");
    describe(scene, node->front, out);
    strcat(out, ",");
    describe(scene, node->back, out);
    strcat(out, ")");
}

static void assert_tree(const struct compiled *scene, const char *tree)
{
    char text[256] = "";
    describe(scene, 0, text);
    assert_string_equal(text, tree);
}

/* A with front B2 and back B1; B1: D1, C1; B2: D2, C2; C2: D3. In capitals A, B = B1, b = B2,
 * C = C1, c = C2, D = D1, d = D2, e = D3. */
static void worked_example_of_eight_polygons(void **state)
{
    (void)state;
    static const struct {
        char name;
        double x0, y0, x1, y1;
    } walls[] = {
        {'A', 0, 2, 0, -2},                           /* front: x > 0 */
        {'B', -8, 5, -2, 5},                          /* front: y > 5 */
        {'b', 2, 10, 8, 10},                          /* front: y > 10 */
        {'C', -8, -3, -2, -3}, {'c', 2, -10, 8, -10}, /* front: y > -10 */
        {'D', -8, 12, -2, 12}, {'d', 2, 15, 8, 15},   {'e', 3, -4, 7, -5},
    };
    struct mesh mesh = mesh_rig(1000.0);
    for (size_t i = 0; i < sizeof walls / sizeof *walls; i++)
        mesh_rig_wall(&mesh, (uint32_t)walls[i].name, walls[i].x0, walls[i].y0, walls[i].x1, walls[i].y1);
    struct compiled scene = mesh_rig_compile(&mesh, "first", 0.5);
    assert_tree(&scene, "A(b(d,c(e,-)),B(D,C))");
    assert_int_equal(scene.report.splits, 0);
    assert_order(&scene, 8.5, 1.0, false, "DBCAdbce"); /* in front of A and c, behind B and b */
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void worked_example_of_the_plan_view(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    mesh_rig_wall(&mesh, '3', -5, 0, 5, 0);
    mesh_rig_wall(&mesh, '2', 2, 3, 0, 4);
    mesh_rig_wall(&mesh, '4', 3, -5, 1, -3);
    mesh_rig_wall(&mesh, '1', 4, 5, 1, 5);
    mesh_rig_wall(&mesh, '5', 6, -5, -6, 6);
    struct compiled scene = mesh_rig_compile(&mesh, "first", 0.5);
    assert_int_equal(scene.report.splits, 1);
    assert_tree(&scene, "3(2(5,1),4(-,5))");
    assert_order(&scene, -5, 7, false, "453521");
    assert_order(&scene, -5, 7, true, "3");
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void the_cut_of_the_plan_view_lies_where_the_lines_meet(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    mesh_rig_wall(&mesh, '3', -5, 0, 5, 0);
    mesh_rig_wall(&mesh, '5', 6, -5, -6, 6);
    struct compiled scene = mesh_rig_compile(&mesh, "first", 0.5);
    int found = 0;
    for (size_t i = 0; i < scene.scene.vertex_count; i++) /* 6 m - 12 m * 5/11 = 0.5454.. m */
        found += scene.scene.vertices[i].z == 545 && scene.scene.vertices[i].x == 0;
    assert_int_equal(found, 2);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* What holds for every tree ------------------------------------------------------------------ */

struct grove {
    struct mesh mesh;
    struct exact_points points;
    struct coplanar coplanar;
    struct bsp bsp;
    double tolerance;
};

static void grove_plant(struct grove *grove, uint64_t seed, const struct splitter *splitter, double tolerance)
{
    struct random random = {seed};
    *grove = (struct grove){.mesh = mesh_rig(4000.0), .tolerance = tolerance};
    mesh_rig_solids(&grove->mesh, &random, 14);
    for (size_t i = 0; i < grove->mesh.point_count; i++)
        exact_add_m(&grove->points, grove->mesh.points[i], &grove->mesh.grid);
    coplanar_find(&grove->mesh, grove->points.approx, tolerance, &grove->coplanar);
    const struct tree_plan plan = {TREE_BSP, splitter, tolerance, NULL};
    assert_true(bsp_build(&grove->bsp, &grove->mesh, &grove->coplanar, &plan, &grove->points));
}

static void grove_fell(struct grove *grove)
{
    bsp_free(&grove->bsp);
    coplanar_free(&grove->coplanar);
    exact_free(&grove->points);
    mesh_rig_free(&grove->mesh);
}

/* Runs a check on a grove for every heuristic, with and without tolerance. */
static void for_all_groves(void (*check)(struct grove *))
{
    for (size_t i = 0; i < splitter_count; i++)
        for (int exact = 0; exact < 2; exact++) {
            struct grove grove;
            grove_plant(&grove, 11 + i, &splitters[i], exact ? 0.0 : 0.5);
            assert_true(grove.bsp.splits > 10);
            check(&grove);
            grove_fell(&grove);
        }
}

/* Is n . p - d of the given sign (0: nothing but 0), or at most `most` times |n|? */
static bool is_on_side(const mpq_t point[3], const struct plane *plane, int side, double most)
{
    mpq_t value, term;
    mpq_inits(value, term, NULL);
    mpq_set_d(value, -(double)plane->d);
    for (int k = 0; k < 3; k++) {
        mpq_set_d(term, (double)plane->n[k]);
        mpq_mul(term, term, point[k]);
        mpq_add(value, value, term);
    }
    bool ok = mpq_sgn(value) == side || mpq_sgn(value) == 0;
    if (!ok) {
        mpq_mul(value, value, value);
        mpq_set_d(term, most);
        mpq_mul(term, term, term);
        mpq_div(value, value, term);
        mpz_t square, n;
        mpz_inits(square, n, NULL);
        for (int k = 0; k < 3; k++) {
            mpz_set_d(n, (double)plane->n[k]);
            mpz_addmul(square, n, n);
        }
        mpq_set_z(term, square);
        ok = mpq_cmp(value, term) <= 0;
        mpz_clears(square, n, NULL);
    }
    mpq_clears(value, term, NULL);
    return ok;
}

static void assert_piece_filed_right(const struct grove *grove, const struct bsp_piece *piece, uint32_t own,
                                     double most)
{
    int side = 0;
    for (uint32_t node = own; node != BSP_NONE; node = grove->bsp.nodes[node].parent) {
        const struct plane *plane = &grove->coplanar.planes[grove->bsp.nodes[node].group];
        for (uint32_t i = 0; i < piece->count; i++) {
            uint32_t point = grove->bsp.corners[piece->first + i].point;
            assert_true(is_on_side((const mpq_t *)grove->points.at[point], plane, side, most));
        }
        side = grove->bsp.nodes[node].in_front ? 1 : -1;
    }
}

static void check_sides(struct grove *grove)
{
    double worst = bsp_worst_violation(&grove->bsp);
    assert_true(worst <= grove->tolerance + 0.01); /* 0.01: faces turned in doubles are not quite flat */
    for (uint32_t node = 0; node < grove->bsp.node_count; node++)
        for (size_t i = 0; i < grove->bsp.nodes[node].count; i++) {
            uint32_t piece = grove->bsp.placed[grove->bsp.nodes[node].first + i];
            assert_piece_filed_right(grove, &grove->bsp.pieces[piece], node, worst);
        }
}

static void no_piece_is_farther_on_a_wrong_side_than_certified(void **state)
{
    (void)state;
    for_all_groves(check_sides);
}

/* Adds twice the vector area of a loop of points to sum[3]. */
static void add_area(mpq_t sum[3], const struct exact_points *points, const uint32_t *loop, size_t count, int sign)
{
    mpq_t left, right;
    mpq_inits(left, right, NULL);
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            mpq_t *p = points->at[loop[i]], *q = points->at[loop[(i + 1) % count]];
            mpq_mul(left, p[(k + 1) % 3], q[(k + 2) % 3]);
            mpq_mul(right, p[(k + 2) % 3], q[(k + 1) % 3]);
            mpq_sub(left, left, right);
            if (sign > 0)
                mpq_add(sum[k], sum[k], left);
            else
                mpq_sub(sum[k], sum[k], left);
        }
    mpq_clears(left, right, NULL);
}

/* Pieces of a polygon in the tree have its vector area in all: nothing is lost, nothing doubled. */
static void check_areas(struct grove *grove)
{
    const struct bsp *bsp = &grove->bsp;
    size_t count = grove->mesh.polygon_count;
    mpq_t(*sums)[3] = malloc(count * sizeof *sums);
    assert_non_null(sums);
    for (size_t i = 0; i < count; i++) {
        const struct mesh_polygon *polygon = &grove->mesh.polygons[i];
        for (int k = 0; k < 3; k++)
            mpq_init(sums[i][k]);
        add_area(sums[i], &grove->points, &grove->mesh.corners[polygon->first], polygon->count, 1);
    }
    for (size_t i = 0; i < bsp->placed_count; i++) {
        const struct bsp_piece *piece = &bsp->pieces[bsp->placed[i]];
        uint32_t loop[64];
        assert_in_range(piece->count, 3, 64);
        for (uint32_t k = 0; k < piece->count; k++)
            loop[k] = bsp->corners[piece->first + k].point;
        add_area(sums[piece->polygon], &grove->points, loop, piece->count, -1);
    }
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            assert_int_equal(mpq_sgn(sums[i][k]), 0);
            mpq_clear(sums[i][k]);
        }
    free(sums);
}

static void pieces_have_exactly_the_area_of_their_polygon(void **state)
{
    (void)state;
    for_all_groves(check_areas);
}

/* Every point that a plane cuts into an edge lies exactly between the edge's ends. */
static void check_cuts(struct grove *grove)
{
    const struct edges *edges = &grove->bsp.edges;
    assert_true(edges->cut_count > 0);
    for (size_t i = 0; i < edges->cut_count; i++) {
        const struct mesh_edge *edge = &edges->items[edges->cuts[i].edge];
        for (int k = 0; k < 3; k++) {
            int from = exact_compare(&grove->points, edges->cuts[i].point, edge->ends[0], k);
            int to = exact_compare(&grove->points, edge->ends[1], edges->cuts[i].point, k);
            assert_int_equal((from > 0) - (from < 0), (to > 0) - (to < 0));
        }
    }
}

static void cut_points_lie_between_the_ends_of_their_edge(void **state)
{
    (void)state;
    for_all_groves(check_cuts);
}

/* A wall across another's plane whose top corner lies on it, exactly or nearly: the cut goes
 * through that corner, and only the opposite edge gets a new one. */
static void a_corner_on_a_plane_is_no_reason_for_a_new_one(void **state)
{
    (void)state;
    for (int off = -1; off <= 1; off++) {
        struct mesh mesh = mesh_rig(1000.0);
        const double corners_m[3][3] = {{-3.0, -1.0, 0.0}, {3.0, -1.0, 0.0}, {off * 0.004, 1.0, 0.0}};
        mesh_rig_wall(&mesh, 'a', -5, 0, 5, 0);
        mesh_rig_add(&mesh, corners_m, 3);
        struct compiled scene = mesh_rig_compile(&mesh, "first", 5.0);
        assert_int_equal(scene.report.splits, 1);
        assert_int_equal(scene.scene.vertex_count, 4 + 3 + 1);
        assert_int_equal(scene.scene.limits.vertices, 4); /* the first wall's */
        assert_int_equal(scene.scene.polygon_words, 6 + 5 + 5);
        compiled_free(&scene);
        mesh_rig_free(&mesh);
    }
}

static void polygons_of_one_plane_share_a_node(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    for (int i = 0; i < 10; i++)
        mesh_rig_wall(&mesh, 'a', i, i * 0.5, i + 0.8, i * 0.5 + 0.4);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    assert_int_equal(scene.scene.node_count, 1);
    assert_int_equal(scene.scene.polygon_count, 10);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void opposite_faces_of_one_plane_get_a_run_each(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    mesh_rig_wall(&mesh, 'a', 0, 0, 1, 0);
    mesh_rig_wall(&mesh, 'b', 3, 0, 2, 0);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    assert_int_equal(scene.scene.node_count, 1);
    assert_order(&scene, 1, 5, true, "a");
    assert_order(&scene, 1, -5, true, "b");
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* Each face of a ball lies behind all others: the tree is a list. */
static void a_tree_may_be_as_deep_as_the_scene_has_planes(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    const double centre_m[3] = {0.0, 0.0, 0.0};
    mesh_rig_ball(&mesh, centre_m, 30.0, 24);
    struct compiled scene = mesh_rig_compile(&mesh, "first", 0.5);
    assert_int_equal(scene.report.splits, 0);
    assert_true(scene.report.depth > 1000);
    assert_int_equal(scene.scene.limits.depth, scene.report.depth);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_example_of_eight_polygons),
        cmocka_unit_test(worked_example_of_the_plan_view),
        cmocka_unit_test(the_cut_of_the_plan_view_lies_where_the_lines_meet),
        cmocka_unit_test(no_piece_is_farther_on_a_wrong_side_than_certified),
        cmocka_unit_test(pieces_have_exactly_the_area_of_their_polygon),
        cmocka_unit_test(cut_points_lie_between_the_ends_of_their_edge),
        cmocka_unit_test(a_corner_on_a_plane_is_no_reason_for_a_new_one),
        cmocka_unit_test(polygons_of_one_plane_share_a_node),
        cmocka_unit_test(opposite_faces_of_one_plane_get_a_run_each),
        cmocka_unit_test(a_tree_may_be_as_deep_as_the_scene_has_planes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
