/* SPDX-License-Identifier: MIT
 *
 * Meshes without a tree: outlines are cut into triangles that use every corner, closed solids stay closed, and what a
 * file says of such a scene is not believed. */
#include "compiler/encode_mesh.h"

#include "base/map.h"
#include "base/vec3.h"
#include "compiler/outline_triangles.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mesh_rig.h"
#include "scene/lim_check.h"
#include "scene/lim_image.h"

#include <stdlib.h>
#include <string.h>

enum { CORNERS_MAX = 300, OUTLINES = 400 };

/* Outlines ----------------------------------------------------------------------------------- */

static struct grid_point grid_at(const double at[3])
{
    struct grid_point point;
    for (int k = 0; k < 3; k++)
        point.q8[k] = (int32_t)floor(at[k] * 256.0 + 0.5);
    return point;
}

static void area_add(const struct outline *outline, uint32_t a, uint32_t b, uint32_t c, double sum[3])
{
    double at[3][3];
    const uint32_t corners[3] = {a, b, c};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            at[i][k] = (double)outline->corners[corners[i]].q8[k];
    vec3_sub(at[1], at[1], at[0]);
    vec3_sub(at[2], at[2], at[0]);
    for (int k = 0; k < 3; k++)
        sum[k] += at[1][(k + 1) % 3] * at[2][(k + 2) % 3] - at[1][(k + 2) % 3] * at[2][(k + 1) % 3];
}

/* Twice the area, by the triangles from the first corner: another cut than the one under test. */
static double area_of(const struct outline *outline, double normal[3])
{
    double sum[3] = {0, 0, 0};
    for (uint32_t i = 1; i + 1 < outline->count; i++)
        area_add(outline, 0, i, i + 1, sum);
    const double length = sqrt(vec3_dot(sum, sum));
    for (int k = 0; k < 3; k++)
        normal[k] = sum[k] / length;
    return length;
}

/* Edges from a to b; `ways` counts a < b up and a > b down: 0 if each is gone there and back. */
static void edge_add(struct map *ways, uint32_t a, uint32_t b)
{
    uint32_t *way = map_at(ways, (uint64_t)(a < b ? a : b) << 32 | (a < b ? b : a), 1000);
    *way += a < b ? 1 : (uint32_t)-1;
}

static size_t edges_left(const struct map *ways)
{
    size_t left = 0;
    for (size_t i = 0; i < ways->capacity; i++)
        left += ways->entries[i].used && ways->entries[i].value != 1000;
    return left;
}

/* All edges of the outline, once each, and inner ones there and back. Returns the least area of a triangle, twice. */
static double assert_cut_well(const struct outline *outline)
{
    uint32_t(*triangles)[3] = calloc(outline->count, sizeof *triangles);
    struct map ways = {0};
    double normal[3], sum = 0, least = INFINITY;
    const double whole = area_of(outline, normal);
    assert_non_null(triangles);
    outline_triangulate(outline, triangles);
    for (size_t i = 0; i + 2 < outline->count; i++) {
        double area[3] = {0, 0, 0};
        area_add(outline, triangles[i][0], triangles[i][1], triangles[i][2], area);
        least = fmin(least, vec3_dot(area, normal));
        sum += vec3_dot(area, normal);
        for (int k = 0; k < 3; k++)
            edge_add(&ways, triangles[i][k], triangles[i][(k + 1) % 3]);
    }
    for (uint32_t i = 0; i < outline->count; i++)
        edge_add(&ways, (i + 1) % (uint32_t)outline->count, i);
    assert_int_equal(edges_left(&ways), 0);
    assert_true(fabs(sum - whole) <= 1e-6 * whole);
    map_free(&ways);
    free(triangles);
    return least;
}

/* A point of a plane that is turned to x, y or z, so that corners in the middle of straight sides lie exactly there. */
static void add_corner(struct outline *outline, int axis, double x, double y)
{
    double at[3] = {0, 0, 0};
    at[axis] = x, at[(axis + 1) % 3] = y;
    outline_add(outline, grid_at(at), false);
}

/* Some corners of a circle, with others in the middle of the sides between them. */
static struct outline random_outline(struct random *random, size_t sides, size_t most_between)
{
    struct outline outline = {0};
    const int axis = (int)random_in(random, 0, 2);
    double x = 0, y = 0, first[2] = {0, 0};
    for (size_t i = 0; i <= sides; i++) {
        const double angle = 6.28318530717958 * ((double)i + 0.8 * random_unit(random)) / (double)sides;
        const double to[2] = {i == sides ? first[0] : floor(1024 * cos(angle)) * 16,
                              i == sides ? first[1] : floor(1024 * sin(angle)) * 16};
        const int64_t between = i ? random_in(random, 0, (int64_t)most_between) : 0;
        for (int64_t k = 1; k <= between; k++)
            add_corner(&outline, axis, x + (to[0] - x) * (double)k / 64, y + (to[1] - y) * (double)k / 64);
        x = to[0], y = to[1];
        if (i == 0) first[0] = x, first[1] = y;
        if (i < sides) add_corner(&outline, axis, x, y);
    }
    outline_close(&outline);
    return outline;
}

static void convex_outlines_are_cut_into_triangles_none_of_which_is_flat(void **state)
{
    (void)state;
    struct random random = {11};
    for (int i = 0; i < OUTLINES; i++) {
        struct outline outline = random_outline(&random, (size_t)random_in(&random, 3, 9), i % 2 ? 4 : 0);
        assert_true(outline.count >= 3);
        assert_true(assert_cut_well(&outline) > 0);
        outline_free(&outline);
    }
}

/* All corners but one on a straight line: a fan from any other corner would have flat triangles. */
static void corners_on_one_side_are_all_joined_to_the_one_across(void **state)
{
    (void)state;
    for (size_t between = 1; between < 200; between += between < 20 ? 1 : 37)
        for (size_t first = 0; first < between + 3; first += 1 + between / 7) {
            struct outline outline = {0};
            for (size_t i = 0; i < between + 3; i++) {
                const size_t k = (i + first) % (between + 3);
                if (k == between + 2)
                    add_corner(&outline, 0, 3, 500);
                else
                    add_corner(&outline, 0, (double)k * 8, 0);
            }
            outline_close(&outline);
            assert_int_equal(outline.count, between + 3);
            assert_true(assert_cut_well(&outline) > 0);
            outline_free(&outline);
        }
}

static void large_outlines_are_cut_as_well(void **state)
{
    (void)state;
    struct random random = {12};
    for (int i = 0; i < 12; i++) {
        struct outline outline = random_outline(&random, (size_t)random_in(&random, 20, 60), 5);
        assert_in_range(outline.count, 20, CORNERS_MAX * 2);
        assert_true(assert_cut_well(&outline) > 0);
        outline_free(&outline);
    }
}

/* Rounding bends outlines: then some triangle may be turned, but edges still cancel and areas add up. */
static void outlines_that_rounding_bent_are_cut_all_the_same(void **state)
{
    (void)state;
    struct random random = {13};
    for (int i = 0; i < OUTLINES; i++) {
        struct outline outline = random_outline(&random, 5, 3);
        for (size_t k = 0; k < outline.count; k++)
            for (int axis = 0; axis < 3; axis++)
                outline.corners[k].q8[axis] += (int32_t)random_in(&random, -128, 128);
        (void)assert_cut_well(&outline);
        outline_free(&outline);
    }
}

/* Solids ------------------------------------------------------------------------------------- */

static struct compiled encoded(const struct mesh *mesh, bool with_fractions)
{
    struct exact_points points = {0};
    struct encoding encoding;
    struct compiled out = {0};
    struct error err;
    for (size_t i = 0; i < mesh->point_count; i++)
        exact_add_m(&points, mesh->points[i], &mesh->grid);
    if (!encode_mesh(mesh, &points, with_fractions, &encoding, &err)) fail_msg("%s", err.text);
    lim_image_make(&encoding, &mesh->grid, &out);
    assert_int_equal(encoding.word_count, encoding.record_count * LIM_TRIANGLE_WORDS);
    encoding_free(&encoding);
    exact_free(&points);
    return out;
}

static size_t open_edges(const struct lim_scene *scene)
{
    struct map ways = {0};
    for (size_t i = 0; i < scene->polygon_words; i += LIM_TRIANGLE_WORDS)
        for (size_t k = 0; k < 3; k++)
            edge_add(&ways, scene->polygons[i + k], scene->polygons[i + (k + 1) % 3]);
    const size_t left = edges_left(&ways);
    map_free(&ways);
    return left;
}

static struct mesh solids(uint64_t seed, double units_per_m)
{
    struct random random = {seed};
    struct mesh mesh = mesh_rig(1e6); /* on which no two points are one */
    struct error err;
    mesh_rig_solids(&mesh, &random, 12);
    if (!mesh_insert_t_vertices(&mesh, &err)) fail_msg("%s", err.text);
    mesh.grid.units_per_m = units_per_m;
    return mesh;
}

/* Each edge of a closed solid lies between two triangles that go along it in opposite directions; on a coarse grid,
 * where much of it collapses, too. */
static void closed_solids_are_closed_on_any_grid(void **state)
{
    (void)state;
    static const double grids[] = {3000.0, 100.0, 7.0, 1.5};
    for (uint64_t seed = 1; seed <= 20; seed++)
        for (size_t i = 0; i < sizeof grids / sizeof *grids; i++)
            for (int fractions = 0; fractions < 2; fractions++) {
                struct mesh mesh = solids(seed, grids[i]);
                struct compiled scene = encoded(&mesh, fractions);
                struct error err;
                assert_int_equal(open_edges(&scene.scene), 0);
                assert_int_equal(scene.scene.fractions != NULL, fractions);
                scene.scene.limits.active = 8;
                if (!lim_check(&scene.scene, &err)) fail_msg("%s", err.text);
                compiled_free(&scene);
                mesh_rig_free(&mesh);
            }
}

/* A box has 12 triangles; a sheet seen from both sides twice as many as from one. */
static void a_box_is_twelve_triangles_and_a_two_sided_one_twice_that(void **state)
{
    (void)state;
    const double centre_m[3] = {1, 2, 3}, half_m[3] = {1, 1, 1};
    for (int two_sided = 0; two_sided < 2; two_sided++) {
        struct mesh mesh = mesh_rig(100.0);
        mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
        for (size_t i = 0; i < mesh.polygon_count; i++)
            mesh.polygons[i].two_sided = two_sided;
        struct compiled scene = encoded(&mesh, false);
        assert_int_equal(scene.scene.polygon_count, two_sided ? 24 : 12);
        assert_int_equal(scene.scene.vertex_count, 8);
        assert_int_equal(scene.scene.node_count, 0);
        assert_int_equal(scene.scene.boxes[0].centre[2], 300);
        assert_int_equal(scene.scene.boxes[0].half[2], 100);
        compiled_free(&scene);
        mesh_rig_free(&mesh);
    }
}

static void assert_mesh_refused(const struct mesh *mesh, const char *reason)
{
    struct exact_points points = {0};
    struct encoding encoding;
    struct error err;
    for (size_t i = 0; i < mesh->point_count; i++)
        exact_add_m(&points, mesh->points[i], &mesh->grid);
    assert_false(encode_mesh(mesh, &points, false, &encoding, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
    encoding_free(&encoding);
    exact_free(&points);
}

static void what_meshes_do_not_draw_is_refused_by_its_face(void **state)
{
    (void)state;
    const double centre_m[3] = {0, 0, 0}, half_m[3] = {1, 1, 1};
    struct mesh mesh = mesh_rig(100.0);
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    mesh.polygons[3].transparency = 9;
    assert_mesh_refused(&mesh, "face 4: as a mesh, transparent faces are not drawn");
    mesh.polygons[3].transparency = 0;
    mesh.grid.units_per_m = 1e-3;
    assert_mesh_refused(&mesh, "nothing is left");
    mesh_rig_free(&mesh);
}

/* Files that lie ------------------------------------------------------------------------------ */

/* Arrays of a scene that is right, to be changed one by one. */
struct victim {
    struct compiled compiled;
    struct lim_scene scene;
    lim_index words[12 * LIM_TRIANGLE_WORDS];
    struct lim_box box;
};

static struct victim *victim_new(void)
{
    const double centre_m[3] = {0, 0, 0}, half_m[3] = {1, 2, 3};
    struct victim *victim = calloc(1, sizeof *victim);
    struct mesh mesh = mesh_rig(100.0);
    assert_non_null(victim);
    mesh_rig_box(&mesh, centre_m, half_m, 0.0, 0.0);
    victim->compiled = encoded(&mesh, false);
    mesh_rig_free(&mesh);
    victim->scene = victim->compiled.scene;
    assert_int_equal(victim->scene.polygon_words, sizeof victim->words / sizeof *victim->words);
    memcpy(victim->words, victim->scene.polygons, sizeof victim->words);
    victim->box = victim->scene.boxes[0];
    victim->scene.polygons = victim->words;
    victim->scene.boxes = &victim->box;
    return victim;
}

static void assert_refused_and_free(struct victim *victim, const char *reason)
{
    struct error err = {""};
    assert_false(lim_check(&victim->scene, &err));
    if (!strstr(err.text, reason)) fail_msg("'%s' lacks '%s'", err.text, reason);
    compiled_free(&victim->compiled);
    free(victim);
}

static void triangles_that_lie_are_refused(void **state)
{
    (void)state;
    struct victim *victim = victim_new();
    victim->words[5] = victim->scene.vertex_count;
    assert_refused_and_free(victim, "triangle 1: vertex 8 of 8");
    victim = victim_new();
    victim->words[46] = LIM_NO_INDEX;
    assert_refused_and_free(victim, "triangle 11: vertex 4294967295 of 8");
    for (int k = 0; k < 3; k++) {
        victim = victim_new();
        victim->words[8 + k] = victim->words[8 + (k + 1) % 3];
        assert_refused_and_free(victim, "is two of its corners");
    }
    victim = victim_new();
    victim->words[7] = 0x10000;
    assert_refused_and_free(victim, "triangle 1: its colour is 0x10000");
    victim = victim_new();
    *victim->scene.deep_from = 13;
    assert_refused_and_free(victim, "depth from triangle 13 on, of 12");
    victim = victim_new();
    *victim->scene.deep_from = 3;
    *victim->scene.near_deep_from = 4;
    assert_refused_and_free(victim, "depth from triangle 4 on near the eye, and from 3 on elsewhere");
}

static void counts_of_a_mesh_that_lie_are_refused(void **state)
{
    (void)state;
    struct victim *victim = victim_new();
    victim->scene.polygon_words -= 1;
    assert_refused_and_free(victim, "12 triangles in 47 words");
    victim = victim_new();
    victim->scene.polygon_count = 0x40000000 + 12; /* times four, it is 12 in 32 bits */
    assert_refused_and_free(victim, "triangles in 48 words");
    victim = victim_new();
    victim->scene.polygon_count = 0;
    assert_refused_and_free(victim, "no nodes, and no triangles");
    victim = victim_new();
    victim->scene.box_count = 0;
    assert_refused_and_free(victim, "0 boxes of a mesh");
    victim = victim_new();
    victim->box.half[2]--;
    assert_refused_and_free(victim, "the box does not hold all of the mesh");
    victim = victim_new();
    victim->box.centre[0]++;
    assert_refused_and_free(victim, "the box does not hold all of the mesh");
    victim = victim_new();
    victim->scene.limits.vertices = 4;
    assert_refused_and_free(victim, "limit of 4 vertices");
    victim = victim_new();
    victim->scene.limits.depth = 1;
    assert_refused_and_free(victim, "1 levels of a tree beside it");
    victim = victim_new();
    victim->scene.limits.layers = 2;
    assert_refused_and_free(victim, "2 layers beside it");
}

static void what_is_beside_a_mesh_is_refused(void **state)
{
    (void)state;
    const struct lim_place place = {.pvs = LIM_NONE};
    const uint8_t byte = 1;
    struct victim *victim = victim_new();
    victim->scene.places = &place;
    victim->scene.place_count = 1;
    assert_refused_and_free(victim, "1 places beside it");
    victim = victim_new();
    victim->scene.pvs = &byte;
    victim->scene.pvs_bytes = 1;
    assert_refused_and_free(victim, "bytes of visible sets beside it");
    const struct lim_plane plane = LIM_PLANE(0, 1, 0, LIM_NO_INDEX, 0);
    victim = victim_new();
    victim->scene.planes = &plane;
    victim->scene.plane_count = 1;
    assert_refused_and_free(victim, "1 planes beside it");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(convex_outlines_are_cut_into_triangles_none_of_which_is_flat),
        cmocka_unit_test(corners_on_one_side_are_all_joined_to_the_one_across),
        cmocka_unit_test(large_outlines_are_cut_as_well),
        cmocka_unit_test(outlines_that_rounding_bent_are_cut_all_the_same),
        cmocka_unit_test(closed_solids_are_closed_on_any_grid),
        cmocka_unit_test(a_box_is_twelve_triangles_and_a_two_sided_one_twice_that),
        cmocka_unit_test(what_meshes_do_not_draw_is_refused_by_its_face),
        cmocka_unit_test(triangles_that_lie_are_refused),
        cmocka_unit_test(counts_of_a_mesh_that_lie_are_refused),
        cmocka_unit_test(what_is_beside_a_mesh_is_refused),
    };
    return cmocka_run_group_tests_name("meshes without a tree", tests, NULL, NULL);
}
