/* SPDX-License-Identifier: MIT
 *
 * The firmware's own walk on the worked examples of the literature: which child is entered, what is
 * drawn, in which order; and what an eye exactly on a plane sees. */
#include "eye.h"
#include "rigs/cmocka_ready.h"
#include "view/walk.h"

#include <string.h>

enum { MAX_NODES = 8, MAX_DEPTH = 8 };

/* A tree whose nodes carry one-letter names; a run's "word offset" is the name. */
struct tree {
    struct lim_node nodes[MAX_NODES];
    struct lim_plane planes[MAX_NODES];
    uint16_t count;
    bool two_sided; /* polygons that can be seen from both sides */
};

/* An axis plane at an offset, or another plane, whose offset is 0. */
static lim_index add(struct tree *tree, char name, lim_index plane, lim_offset offset)
{
    const lim_index run = (lim_index)name;

    tree->nodes[tree->count] = (struct lim_node){
        {plane, offset}, LIM_NO_INDEX, LIM_NO_INDEX, run, tree->two_sided ? run : (lim_index)LIM_NO_INDEX,
        LIM_NO_INDEX};
    return tree->count++;
}

/* The names of the runs in the order of the walk. */
static void walk_all(const struct tree *tree, const int32_t eye_units[3], bool back_to_front, char *order)
{
    const struct lim_scene scene = {
        .nodes = tree->nodes, .planes = tree->planes, .node_count = tree->count, .limits = {.depth = MAX_DEPTH}};
    const int32_t eye_q8[3] = {eye_units[0] * 256, eye_units[1] * 256, eye_units[2] * 256};
    struct lim_cull cull = {0};
    struct lim_stats stats = {0};
    struct lim_walk_pending stack[MAX_DEPTH];
    struct lim_walk walk = {.stack = stack};
    lim_index run;

    lim_eye_set(&walk.eye, &scene, eye_q8);
    lim_walk_begin(&walk, back_to_front);
    while ((run = lim_walk_next(&walk, &cull, &stats)) != LIM_NO_INDEX)
        *order++ = (char)run;
    *order = 0;
}

static void reverse(const char *text, char *out)
{
    const size_t n = strlen(text);

    for (size_t i = 0; i < n; i++)
        out[i] = text[n - 1 - i];
    out[n] = 0;
}

/* Far to near as given, and nearest first its exact reverse. */
static void assert_order(const struct tree *tree, const int32_t eye_units[3], const char *far_to_near)
{
    char got[16], near_to_far[16];

    walk_all(tree, eye_units, true, got);
    assert_string_equal(got, far_to_near);
    reverse(far_to_near, near_to_far);
    walk_all(tree, eye_units, false, got);
    assert_string_equal(got, near_to_far);
}

/* A with front B2 and back B1; B1 front D1, back C1; B2 front D2, back C2; C2 front D3. Names here:
 * A, b = B1, B = B2, c = C1, C = C2, 1 2 3 = D1 D2 D3. Planes are x = offset; the eye is at 0, so a
 * negative offset puts it in front. Eye in front of A, behind B1, behind B2, in front of C2. */
static void make_lettered_tree(struct tree *tree)
{
    *tree = (struct tree){.two_sided = true};
    const lim_index a = add(tree, 'A', LIM_PLANE_X, -1);
    const lim_index b2 = add(tree, 'B', LIM_PLANE_X, 5);
    const lim_index d2 = add(tree, '2', LIM_PLANE_X, 7);
    const lim_index c2 = add(tree, 'C', LIM_PLANE_X, -2);
    const lim_index d3 = add(tree, '3', LIM_PLANE_X, 9);
    const lim_index b1 = add(tree, 'b', LIM_PLANE_X, 6);
    const lim_index d1 = add(tree, '1', LIM_PLANE_X, 8);
    const lim_index c1 = add(tree, 'c', LIM_PLANE_X, 3);

    tree->nodes[a].front = b2;
    tree->nodes[a].back = b1;
    tree->nodes[b2].front = d2;
    tree->nodes[b2].back = c2;
    tree->nodes[c2].front = d3;
    tree->nodes[b1].front = d1;
    tree->nodes[b1].back = c1;
}

static const int32_t origin[3] = {0, 0, 0};

static void lettered_tree_is_drawn_D1_B1_C1_A_D2_B2_C2_D3(void **state)
{
    struct tree tree;

    (void)state;
    make_lettered_tree(&tree);
    assert_order(&tree, origin, "1bcA2BC3");
}

static void lettered_tree_with_swapped_children_is_drawn_otherwise(void **state)
{
    struct tree tree;
    char got[16];

    (void)state;
    make_lettered_tree(&tree);
    for (uint16_t i = 0; i < tree.count; i++) {
        const lim_index front = tree.nodes[i].front;
        tree.nodes[i].front = tree.nodes[i].back;
        tree.nodes[i].back = front;
    }
    walk_all(&tree, origin, true, got);
    assert_string_not_equal(got, "1bcA2BC3");
}

/* A segment (ax, az) -> (bx, bz) in plan, front on the left of its direction. */
static struct lim_plane plan_plane(int16_t ax, int16_t az, int16_t bx, int16_t bz)
{
    const int16_t n0 = (int16_t)(az - bz), n2 = (int16_t)(bx - ax);

    return (struct lim_plane)LIM_PLANE(n0, 0, n2, LIM_NO_INDEX, (int32_t)n0 * ax + (int32_t)n2 * az);
}

/* 3( front 2( front 5a, back 1 ), back 4( back 5b ) ); names: 3 2 1 4, a = 5a, b = 5b. */
static void make_plan(struct tree *tree, bool two_sided)
{
    static const int16_t segments[6][4] = {{-5, 0, 5, 0}, {2, 3, 0, 4},   {-3, 3, -6, 6}, /* 5a: above 3's line */
                                           {4, 5, 1, 5},  {3, -5, 1, -3}, {6, -5, 1, 0}};
    static const char names[6] = {'3', '2', 'a', '1', '4', 'b'};

    *tree = (struct tree){.two_sided = two_sided};
    for (uint16_t i = 0; i < 6; i++) {
        const int16_t *s = segments[i];
        tree->planes[i] = plan_plane(s[0], s[1], s[2], s[3]);
        add(tree, names[i], (uint16_t)(i * LIM_PLANE_WORDS), 0);
    }
    tree->nodes[0].front = 1;
    tree->nodes[0].back = 4;
    tree->nodes[1].front = 2;
    tree->nodes[1].back = 3;
    tree->nodes[4].back = 5;
}

static const int32_t plan_eye[3] = {-5, 0, 7};

static void plan_view_is_drawn_4_5b_3_5a_2_1(void **state)
{
    struct tree tree;

    (void)state;
    make_plan(&tree, true);
    assert_order(&tree, plan_eye, "4b3a21");
}

static void plan_view_shows_only_segment_3_its_front(void **state)
{
    struct tree tree;

    (void)state;
    make_plan(&tree, false);
    assert_order(&tree, plan_eye, "3");
}

static void an_eye_on_the_plane_sees_front_then_back_and_not_the_polygon(void **state)
{
    struct tree tree = {.two_sided = true};
    const lim_index f = add(&tree, 'F', LIM_PLANE_Y, 0);
    const lim_index front = add(&tree, 'f', LIM_PLANE_X, 5), back = add(&tree, 'b', LIM_PLANE_X, 5);

    (void)state;
    tree.nodes[f].front = front;
    tree.nodes[f].back = back;
    assert_order(&tree, origin, "fb");
}

static void an_empty_scene_has_nothing_to_draw(void **state)
{
    const struct tree tree = {0};

    (void)state;
    assert_order(&tree, origin, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lettered_tree_is_drawn_D1_B1_C1_A_D2_B2_C2_D3),
        cmocka_unit_test(lettered_tree_with_swapped_children_is_drawn_otherwise),
        cmocka_unit_test(plan_view_is_drawn_4_5b_3_5a_2_1),
        cmocka_unit_test(plan_view_shows_only_segment_3_its_front),
        cmocka_unit_test(an_eye_on_the_plane_sees_front_then_back_and_not_the_polygon),
        cmocka_unit_test(an_empty_scene_has_nothing_to_draw),
    };

    return cmocka_run_group_tests_name("walk", tests, NULL, NULL);
}
