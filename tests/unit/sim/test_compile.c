/* SPDX-License-Identifier: MIT
 *
 * Compiled scenes: closed solids stay closed on the grid, boxes hold what they should, the numbers
 * that the project promises, and what is refused. */
#include "base/rgb565.h"
#include "compiler/compile.h"
#include "compiler/compile_mesh.h"
#include "readers/model_import.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/mesh_rig.h"
#include "scene/encoding.h"
#include "scene/lim_check.h"
#include "scene/needs.h"
#include "scene/width.h"
#include "trees/splitter.h"

#include <math.h>
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
        const lim_index count = scene->polygons[at] & LIM_POLYGON_COUNT, *corners = &scene->polygons[at + 2];
        for (size_t i = 0; i < count; i++)
            edges.items[edges.count++] =
                directed_edge(scene->vertices[corners[i]], scene->vertices[corners[(i + 1) % count]]);
        at += lim_record_words(scene->polygons[at]);
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
    const uint64_t seeds = (uint64_t)(effort(6) < 2 ? 2 : effort(6)); /* both grids at least */
    for (uint64_t seed = 1; seed <= seeds; seed++)
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

/* The records of a run, one after the other; NULL at the end. */
static const lim_index *run_first(const struct lim_scene *scene, lim_index node, bool back)
{
    lim_index run = back ? scene->nodes[node].back_run : scene->nodes[node].front_run;
    return run == LIM_NO_INDEX ? NULL : &scene->polygons[run];
}

static const lim_index *run_next(const lim_index *record)
{
    return *record & LIM_POLYGON_LAST ? NULL : record + lim_record_words(*record);
}

/* Newell's sum of a record's corners along the node's normal; slivers may have any sign. */
static void check_facing(const struct lim_scene *scene, lim_index node, const lim_index *record, bool back)
{
    const lim_index count = record[0] & LIM_POLYGON_COUNT, *corners = record + LIM_POLYGON_HEAD_WORDS;
    int64_t n[3], d;
    double along = 0.0, square = 0.0;
    plane_exact(scene, &scene->nodes[node].split, n, &d);
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

/* Twice a plane that is exact in its record would break one bound or the other. */
static void planes_are_as_long_as_their_bounds_allow(void **state)
{
    (void)state;
    struct compiled scene = compile_solids(7, "fewest");
    size_t small = 0;
    for (uint16_t i = 0; i < scene.scene.node_count; i++) {
        const enum plane_kind kind = plane_kind_of(&scene.scene, &scene.scene.nodes[i].split);
        if (kind != PLANE_XZ && kind != PLANE_SMALL) continue;
        int64_t n[3], d;
        plane_exact(&scene.scene, &scene.scene.nodes[i].split, n, &d);
        assert_true(2 * (llabs(n[0]) + llabs(n[1]) + llabs(n[2])) > PLANE_SUM_MAX || 2 * llabs(d) > LIM_PLANE_D_MAX);
        small++;
    }
    assert_true(small > 10);
    compiled_free(&scene);
}

static void records_face_the_side_of_their_run(void **state)
{
    (void)state;
    struct compiled scene = compile_solids(7, "auto");
    for (lim_index node = 0; node < scene.scene.node_count; node++)
        for (int back = 0; back < 2; back++)
            for (const lim_index *at = run_first(&scene.scene, node, back); at; at = run_next(at))
                check_facing(&scene.scene, node, at, back);
    compiled_free(&scene);
}

static void assert_inside(const struct lim_scene *scene, const lim_index *record, const struct lim_box *box)
{
    for (size_t i = 0; i < (*record & LIM_POLYGON_COUNT); i++) {
        const struct lim_vertex *vertex = &scene->vertices[record[LIM_POLYGON_HEAD_WORDS + i]];
        assert_true(abs(vertex->x - box->centre[0]) <= box->half[0]);
        assert_true(abs(vertex->y - box->centre[1]) <= box->half[1]);
        assert_true(abs(vertex->z - box->centre[2]) <= box->half[2]);
    }
}

/* Polygons of a subtree, all of them inside the box if there is one. */
static size_t subtree_contents(const struct lim_scene *scene, lim_index node, const struct lim_box *box)
{
    if (node == LIM_NO_INDEX) return 0;
    size_t polygons = 0;
    for (int back = 0; back < 2; back++)
        for (const lim_index *at = run_first(scene, node, back); at; at = run_next(at), polygons++)
            if (box) assert_inside(scene, at, box);
    return polygons + subtree_contents(scene, scene->nodes[node].front, box) +
           subtree_contents(scene, scene->nodes[node].back, box);
}

static void boxes_hold_their_subtrees(void **state)
{
    (void)state;
    struct compiled compiled = compile_solids(8, "auto");
    const struct lim_scene *scene = &compiled.scene;
    assert_true(scene->box_count > 20);
    for (lim_index node = 0; node < scene->node_count; node++) {
        lim_index box = scene->nodes[node].box;
        size_t polygons = subtree_contents(scene, node, box == LIM_NO_INDEX ? NULL : &scene->boxes[box]);
        assert_int_equal(box != LIM_NO_INDEX, polygons >= SUBTREE_BOX_POLYGONS);
    }
    assert_int_equal(subtree_contents(scene, 0, NULL), scene->polygon_count);
    compiled_free(&compiled);
}

static void colours_are_rounded_to_565(void **state)
{
    (void)state;
    assert_int_equal(rgb565_nearest(0x000000), 0x0000);
    assert_int_equal(rgb565_nearest(0xFFFFFF), 0xFFFF);
    assert_int_equal(rgb565_nearest(0xFF0000), 0xF800);
    assert_int_equal(rgb565_nearest(0x00FF00), 0x07E0);
    assert_int_equal(rgb565_nearest(0x0000FF), 0x001F);
    assert_int_equal(rgb565_nearest(0x040204), 0x0000); /* 0.49 of a step each */
    assert_int_equal(rgb565_nearest(0x050305), 0x0821); /* 0.61, 0.74 */
    assert_int_equal(rgb565_nearest(0xFBFDFB), 0xFFFF);
    assert_int_equal(rgb565_nearest(0xFAFCFA), 0xF7DE);
}

static void two_sided_polygons_get_a_record_for_either_side(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    mesh_rig_wall(&mesh, 5, 0, 0, 1, 1);
    mesh.polygons[0].two_sided = true;
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    assert_int_equal(scene.scene.polygon_count, 2);
    assert_int_equal(scene.faces[0], 5);
    assert_int_equal(scene.faces[1], 5);
    check_facing(&scene.scene, 0, run_first(&scene.scene, 0, false), false);
    check_facing(&scene.scene, 0, run_first(&scene.scene, 0, true), true);
    assert_closed(&scene);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* A disc of 200 corners, both sides: records have LIM_MAX_VERTICES at most, and fit together. */
static void polygons_with_many_corners_are_divided(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    double corners_m[200][3];
    for (int i = 0; i < 200; i++) {
        int side = i / 50, step = i % 50; /* along a square's four sides: most corners lie in a line */
        corners_m[i][0] = side == 0 ? step : side == 1 ? 50 : side == 2 ? 50 - step : 0;
        corners_m[i][1] = 1.0;
        corners_m[i][2] = side == 1 ? step : side == 2 ? 50 : side == 3 ? 50 - step : 0;
    }
    mesh_rig_add(&mesh, (const double(*)[3])corners_m, 200)->two_sided = true;
    for (int i = 0; i < 200; i++)
        mesh.points[i][0] -= 25.0;
    mesh.grid.units_per_m = 600.0;
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    assert_int_equal(scene.scene.polygon_count, 8);
    assert_true(scene.scene.limits.vertices <= LIM_MAX_VERTICES);
    for (int back = 0; back < 2; back++)
        for (const lim_index *at = run_first(&scene.scene, 0, back); at; at = run_next(at))
            check_facing(&scene.scene, 0, at, back);
    assert_closed(&scene);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void what_the_grid_rounds_away_is_counted(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    mesh_rig_wall(&mesh, 1, 0, 0, 1, 1);
    mesh_rig_wall(&mesh, 2, 2, 0, 2.0001, 0.0001);
    struct compiled scene = mesh_rig_compile(&mesh, "auto", 0.5);
    assert_int_equal(scene.report.collapsed, 1);
    assert_int_equal(scene.scene.polygon_count, 1);
    assert_int_equal(scene.scene.node_count, 1);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

static void compiling_twice_gives_the_same_bytes(void **state)
{
    (void)state;
    struct compiled first = compile_solids(9, "auto"), second = compile_solids(9, "auto");
    assert_int_equal(first.image_b, second.image_b);
    assert_memory_equal(first.image, second.image, first.image_b);
    compiled_free(&first);
    compiled_free(&second);
}

static void whatever_is_compiled_passes_the_check_of_files(void **state)
{
    (void)state;
    for (size_t i = 0; i < splitter_count; i++) {
        struct compiled scene = compile_solids(20 + i, splitters[i].name);
        struct error err = {""};
        if (!lim_check(&scene.scene, &err)) fail_msg("%s", err.text);
        assert_string_equal(scene.report.splitter, splitters[i].name);
        compiled_free(&scene);
    }
}

/* Refusals ----------------------------------------------------------------------------------- */

static void assert_refused(const struct mesh *mesh, const char *splitter, const char *reason)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = splitter};
    struct compiled scene;
    struct error err;
    assert_false(compile_mesh(mesh, &options, &scene, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
    assert_null(scene.image);
}

static void unusable_meshes_are_refused_with_a_reason(void **state)
{
    (void)state;
    struct mesh mesh = mesh_rig(1000.0);
    assert_refused(&mesh, "auto", "no polygons");
    mesh_rig_wall(&mesh, 1, 0, 0, 0.0001, 0.0002);
    assert_refused(&mesh, "auto", "nothing is left");
    assert_refused(&mesh, "best", "--splitter best: no such heuristic");
    mesh_rig_wall(&mesh, 2, 0, 0, 32.768, 1);
    assert_refused(&mesh, "auto", "beyond the 16-bit grid");
    mesh_rig_free(&mesh);
}

/* 105 x 105 tiles of 6 words each, in one plane: 615 words more than 16 bits count. */
static struct mesh tiles(void)
{
    struct mesh mesh = mesh_rig(100.0);
    for (int i = 0; i < 105; i++)
        for (int k = 0; k < 105; k++) {
            const double corners_m[4][3] = {{i, 0, k}, {i, 0, k + 1}, {i + 1, 0, k + 1}, {i + 1, 0, k}};
            mesh_rig_add(&mesh, corners_m, 4);
        }
    return mesh;
}

static void scenes_beyond_16_bits_are_wide(void **state)
{
    (void)state;
    struct mesh mesh = tiles();
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "first"};
    struct compiled scene;
    struct error err;
    if (!compile_mesh(&mesh, &options, &scene, &err)) fail_msg("%s", err.text);
    assert_int_equal(scene.scene.polygon_words, 66150);
    assert_true(width_is_wide(&scene.scene));
    assert_true(needs_of(&scene, NULL).wide);
    compiled_free(&scene);
    mesh_rig_free(&mesh);
}

/* The benchmark scenes ----------------------------------------------------------------------- */

static struct mesh load_mesh(const char *path)
{
    struct model model;
    struct mesh mesh = {0};
    struct error err;
    if (!model_import(path, &model, &err) || !mesh_clean(&model, &mesh, &err) || !mesh_insert_t_vertices(&mesh, &err))
        fail_msg("%s", err.text);
    model_free(&model);
    return mesh;
}

static double distance_to_segment(struct lim_vertex at, const double from[3], const double to[3])
{
    const double p[3] = {at.x - from[0], at.y - from[1], at.z - from[2]};
    double along = 0.0, square = 0.0, off = 0.0;
    for (int k = 0; k < 3; k++) {
        along += p[k] * (to[k] - from[k]);
        square += (to[k] - from[k]) * (to[k] - from[k]);
    }
    double t = along < 0.0 ? 0.0 : along > square ? 1.0 : along / square;
    for (int k = 0; k < 3; k++)
        off += (p[k] - t * (to[k] - from[k])) * (p[k] - t * (to[k] - from[k]));
    return sqrt(off);
}

/* The edges that only one polygon of the mesh has, in units, as pairs of ends. */
static size_t mesh_open_edges(const struct mesh *mesh, double (*ends)[2][3])
{
    size_t count = 0;
    int *ways = calloc(mesh->point_count * mesh->point_count, sizeof *ways);
    assert_non_null(ways);
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < mesh->polygon_count; i++)
            for (uint32_t k = 0; k < mesh->polygons[i].count; k++) {
                const uint32_t *corners = &mesh->corners[mesh->polygons[i].first];
                size_t a = corners[k], b = corners[(k + 1) % mesh->polygons[i].count];
                if (pass == 0) {
                    ways[a * mesh->point_count + b]++;
                    ways[b * mesh->point_count + a]--;
                } else if (ways[a * mesh->point_count + b] > 0) {
                    for (int c = 0; c < 3; c++) {
                        ends[count][0][c] = (mesh->points[a][c] - mesh->grid.origin_m[c]) * mesh->grid.units_per_m;
                        ends[count][1][c] = (mesh->points[b][c] - mesh->grid.origin_m[c]) * mesh->grid.units_per_m;
                    }
                    count++;
                }
            }
    free(ways);
    return count;
}

/* Where the scene is open, the mesh was: within what rounding to the grid moves a point. */
static void assert_open_only_where_the_mesh_is(const struct mesh *mesh, const struct compiled *scene)
{
    double(*ends)[2][3] = malloc(mesh->corner_count * sizeof *ends);
    assert_non_null(ends);
    size_t count = mesh_open_edges(mesh, ends);
    struct directed_list edges = open_edges(&scene->scene);
    for (size_t i = 0; i < edges.count; i++) {
        bool found = false;
        for (size_t k = 0; k < count && !found; k++)
            found = distance_to_segment(edges.items[i].low, ends[k][0], ends[k][1]) < 0.9 &&
                    distance_to_segment(edges.items[i].high, ends[k][0], ends[k][1]) < 0.9;
        assert_true(found);
    }
    free(edges.items);
    free(ends);
}

static void benchmark_scenes_get_no_new_cracks(void **state)
{
    (void)state;
    static const char *const paths[] = {"sim/scenes/rooms.obj", "sim/scenes/rooms-tilted.obj", "sim/scenes/teapot.obj"};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++)
        for (size_t t = 0; t < sizeof TOLERANCES / sizeof *TOLERANCES; t++) {
            struct mesh mesh = load_mesh(paths[i]);
            struct compiled scene = mesh_rig_compile(&mesh, "weighted-12", TOLERANCES[t]);
            assert_open_only_where_the_mesh_is(&mesh, &scene);
            compiled_free(&scene);
            mesh_free(&mesh);
        }
}

static struct compile_report compile_file(const char *path, bool keep_faces)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .keep_faces = keep_faces};
    struct compiled scene;
    struct error err;
    if (!compile_model(path, &options, &scene, &err)) fail_msg("%s", err.text);
    struct compile_report report = scene.report;
    compiled_free(&scene);
    return report;
}

/* The numbers that README promises, with every face kept and with faces merged. */
static void rooms_need_few_splits_and_little_flash(void **state)
{
    (void)state;
    for (int keep = 0; keep < 2; keep++) {
        struct compile_report rooms = compile_file("sim/scenes/rooms.obj", keep);
        assert_in_range(rooms.splits, 0, 20);
        assert_in_range(rooms.flash_b, 10000, 62 * 1024);
        struct compile_report tilted = compile_file("sim/scenes/rooms-tilted.obj", keep);
        assert_in_range(tilted.splits, 0, 20);
        assert_in_range(tilted.flash_b, 10000, 62 * 1024);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_solids_stay_closed_on_the_grid),
        cmocka_unit_test(planes_are_as_long_as_their_bounds_allow),
        cmocka_unit_test(records_face_the_side_of_their_run),
        cmocka_unit_test(boxes_hold_their_subtrees),
        cmocka_unit_test(colours_are_rounded_to_565),
        cmocka_unit_test(two_sided_polygons_get_a_record_for_either_side),
        cmocka_unit_test(polygons_with_many_corners_are_divided),
        cmocka_unit_test(what_the_grid_rounds_away_is_counted),
        cmocka_unit_test(compiling_twice_gives_the_same_bytes),
        cmocka_unit_test(whatever_is_compiled_passes_the_check_of_files),
        cmocka_unit_test(unusable_meshes_are_refused_with_a_reason),
        cmocka_unit_test(scenes_beyond_16_bits_are_wide),
        cmocka_unit_test(benchmark_scenes_get_no_new_cracks),
        cmocka_unit_test(rooms_need_few_splits_and_little_flash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
