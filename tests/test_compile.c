/* SPDX-License-Identifier: MIT
 *
 * Compiled scenes: closed solids stay closed on the grid, boxes hold what they should, the numbers
 * that the project promises, and what is refused. */
#include "cmocka_ready.h"
#include "encode.h"
#include "lim_check.h"
#include "mesh_rig.h"

#include <stdlib.h>
#include <string.h>

static const double TOLERANCES[] = {0.0, 0.5, 6.0};

/* Edges -------------------------------------------------------------------------------------- */

/* An edge of a record; `way` is 1 or -1, so that an edge and its reverse add up to 0. */
struct directed {
    struct lim_vertex low, high;
    int way;
};

struct directed_list {
    struct directed *items;
    size_t count;
};

static int vertex_order(struct lim_vertex a, struct lim_vertex b)
{
    if (a.x != b.x) return a.x < b.x ? -1 : 1;
    if (a.y != b.y) return a.y < b.y ? -1 : 1;
    return (a.z > b.z) - (a.z < b.z);
}

static int directed_order(const void *left, const void *right)
{
    const struct directed *a = left, *b = right;
    int order = vertex_order(a->low, b->low);
    return order ? order : vertex_order(a->high, b->high);
}

static struct directed directed_edge(struct lim_vertex from, struct lim_vertex to)
{
    bool forward = vertex_order(from, to) < 0;
    return forward ? (struct directed){from, to, 1} : (struct directed){to, from, -1};
}

/* Leaves of the sorted edges those that their reverses do not cancel. */
static void cancel(struct directed_list *edges)
{
    size_t kept = 0;
    if (edges->count) qsort(edges->items, edges->count, sizeof *edges->items, directed_order);
    for (size_t i = 0, end; i < edges->count; i = end) {
        struct directed sum = edges->items[i];
        for (end = i + 1; end < edges->count && directed_order(&edges->items[i], &edges->items[end]) == 0; end++)
            sum.way += edges->items[end].way;
        if (sum.way) edges->items[kept++] = sum;
    }
    edges->count = kept;
}

/* The edges of all records that no other record meets. The caller frees the items. */
static struct directed_list open_edges(const struct lim_scene *scene)
{
    struct directed_list edges = {.items = malloc((scene->polygon_words + 1u) * sizeof *edges.items)};
    assert_non_null(edges.items);
    for (size_t at = 0; at < scene->polygon_words;) {
        const uint16_t count = scene->polygons[at] & LIM_POLYGON_COUNT, *corners = &scene->polygons[at + 2];
        for (size_t i = 0; i < count; i++)
            edges.items[edges.count++] =
                directed_edge(scene->vertices[corners[i]], scene->vertices[corners[(i + 1) % count]]);
        at += LIM_POLYGON_HEAD_WORDS + (size_t)count;
    }
    cancel(&edges);
    return edges;
}

static void assert_closed(const struct compiled *scene)
{
    struct directed_list edges = open_edges(&scene->scene);
    assert_int_equal(edges.count, 0);
    free(edges.items);
}

/* Needles thinner than a unit, boxes through one another: many splits, many collapses. */
static void closed_solids_stay_closed_on_the_grid(void **state)
{
    (void)state;
    size_t collapsed = 0;
    for (uint64_t seed = 1; seed <= 6; seed++)
        for (size_t i = 0; i < splitter_count; i++)
            for (size_t t = 0; t < sizeof TOLERANCES / sizeof *TOLERANCES; t++) {
                struct random random = {seed};
                struct mesh mesh = mesh_rig(seed % 2 ? 3000.0 : 300.0);
                mesh_rig_solids(&mesh, &random, 12);
                struct compiled scene = mesh_rig_compile(&mesh, splitters[i].name, TOLERANCES[t]);
                assert_closed(&scene);
                collapsed += scene.report.collapsed;
                compiled_free(&scene);
                mesh_rig_free(&mesh);
            }
    assert_true(collapsed > 100);
}

/* Records ------------------------------------------------------------------------------------ */

static void check_nothing(const struct lim_scene *scene, uint16_t node, const uint16_t *record, bool back)
{
    (void)scene, (void)node, (void)record, (void)back;
}

static void for_run(const struct lim_scene *scene, uint16_t node, bool back,
                    void (*check)(const struct lim_scene *, uint16_t, const uint16_t *, bool))
{
    uint16_t run = back ? scene->nodes[node].back_run : scene->nodes[node].front_run;
    if (run == LIM_NONE) return;
    for (const uint16_t *record = &scene->polygons[run];;
         record += LIM_POLYGON_HEAD_WORDS + (*record & LIM_POLYGON_COUNT)) {
        check(scene, node, record, back);
        if (*record & LIM_POLYGON_LAST) return;
    }
}

static void for_records(const struct lim_scene *scene,
                        void (*check)(const struct lim_scene *, uint16_t, const uint16_t *, bool))
{
    for (uint16_t node = 0; node < scene->node_count; node++) {
        for_run(scene, node, false, check);
        for_run(scene, node, true, check);
    }
}

/* Newell's sum of a record's corners along the node's normal; slivers may have any sign. */
static void check_facing(const struct lim_scene *scene, uint16_t node, const uint16_t *record, bool back)
{
    const uint16_t count = record[0] & LIM_POLYGON_COUNT, *corners = record + LIM_POLYGON_HEAD_WORDS;
    int64_t n[3], d;
    double along = 0.0, square = 0.0;
    plane_exact(scene, node, n, &d);
    for (int k = 0; k < 3; k++) {
        double sum = 0.0;
        for (size_t i = 0; i < count; i++) {
            const struct lim_vertex *p = &scene->vertices[corners[i]], *q = &scene->vertices[corners[(i + 1) % count]];
            const double a[3] = {p->x, p->y, p->z}, b[3] = {q->x, q->y, q->z};
            sum += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        }
        along += sum * (double)n[k];
        square += sum * sum;
    }
    if (square > 1e12) assert_true(back ? along < 0.0 : along > 0.0);
}

static struct compiled compile_solids(uint64_t seed, const char *splitter)
{
    struct random random = {seed};
    struct mesh mesh = mesh_rig(3000.0);
    mesh_rig_solids(&mesh, &random, 12);
    struct compiled scene = mesh_rig_compile(&mesh, splitter, 0.5);
    mesh_rig_free(&mesh);
    return scene;
}

static void records_face_the_side_of_their_run(void **state)
{
    (void)state;
    struct compiled scene = compile_solids(7, "auto");
    for_records(&scene.scene, check_facing);
    compiled_free(&scene);
}

static size_t box_contents(const struct lim_scene *scene, uint16_t node, const struct lim_box *box, bool back)
{
    size_t records = 0;
    uint16_t run = back ? scene->nodes[node].back_run : scene->nodes[node].front_run;
    for (const uint16_t *record = run == LIM_NONE ? NULL : &scene->polygons[run]; record;) {
        const uint16_t count = record[0] & LIM_POLYGON_COUNT;
        for (size_t i = 0; i < count && box; i++) {
            const struct lim_vertex *vertex = &scene->vertices[record[LIM_POLYGON_HEAD_WORDS + i]];
            assert_true(abs(vertex->x - box->centre[0]) <= box->half[0]);
            assert_true(abs(vertex->y - box->centre[1]) <= box->half[1]);
            assert_true(abs(vertex->z - box->centre[2]) <= box->half[2]);
        }
        records++;
        record = *record & LIM_POLYGON_LAST ? NULL : record + LIM_POLYGON_HEAD_WORDS + count;
    }
    return records;
}

/* Polygons of a subtree, all of them inside the box if there is one. */
static size_t subtree_contents(const struct lim_scene *scene, uint16_t node, const struct lim_box *box)
{
    if (node == LIM_NONE) return 0;
    return box_contents(scene, node, box, false) + box_contents(scene, node, box, true) +
           subtree_contents(scene, scene->nodes[node].front, box) +
           subtree_contents(scene, scene->nodes[node].back, box);
}

static void boxes_hold_their_subtrees(void **state)
{
    (void)state;
    struct compiled compiled = compile_solids(8, "auto");
    const struct lim_scene *scene = &compiled.scene;
    assert_true(scene->box_count > 20);
    for (uint16_t node = 0; node < scene->node_count; node++) {
        uint16_t box = scene->nodes[node].box;
        size_t polygons = subtree_contents(scene, node, box == LIM_NONE ? NULL : &scene->boxes[box]);
        assert_int_equal(box != LIM_NONE, polygons >= SUBTREE_BOX_POLYGONS);
    }
    assert_int_equal(subtree_contents(scene, 0, NULL), scene->polygon_count);
    compiled_free(&compiled);
}
