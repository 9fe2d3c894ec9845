/* SPDX-License-Identifier: MIT
 *
 * Numbers are taken from the bytes in the order of the scene and brought into range: so a mutation of a
 * byte is a small change of the scene. Planes go through vertices, where decisions are hard. */
#include "fuzz_scene.h"

#include "scene/bounds.h"
#include "scene/plane.h"

#include <stdlib.h>
#include <string.h>

static int16_t coordinate(struct fuzz_bytes *bytes)
{
    const int16_t value = (int16_t)fuzz_u16(bytes);

    return value == INT16_MIN ? INT16_MAX : value;
}

static int8_t fraction_q8(struct fuzz_bytes *bytes)
{
    return (int8_t)(fuzz_u8(bytes) - 128);
}

static void make_vertices(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    made->scene.vertex_count = (uint16_t)(3 + fuzz_below(bytes, FUZZ_VERTICES_MAX - 2));
    if (fuzz_below(bytes, 2)) made->scene.fractions = made->fractions;
    for (lim_index i = 0; i < made->scene.vertex_count; i++) {
        made->vertices[i] = (struct lim_vertex){coordinate(bytes), coordinate(bytes), coordinate(bytes)};
        if (made->scene.fractions)
            made->fractions[i] = (struct lim_fraction){fraction_q8(bytes), fraction_q8(bytes), fraction_q8(bytes)};
    }
}

/* Runs --------------------------------------------------------------------------------------- */

static lim_index make_run(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct lim_scene *scene = &made->scene;
    const lim_index run = scene->polygon_words;
    const uint8_t records = fuzz_below(bytes, FUZZ_RUN_MAX + 1);

    for (uint8_t k = 1; k <= records; k++) {
        const uint8_t corners = (uint8_t)(3 + fuzz_below(bytes, FUZZ_CORNERS_MAX - 2));
        lim_index *word = &made->polygons[scene->polygon_words];
        *word++ = (lim_index)(corners | (k == records ? LIM_POLYGON_LAST : 0));
        *word++ = fuzz_u8(bytes);
        for (uint8_t i = 0; i < corners; i++)
            *word++ = fuzz_below(bytes, scene->vertex_count);
        scene->polygon_words = (lim_index)(scene->polygon_words + LIM_POLYGON_HEAD_WORDS + corners);
        scene->polygon_count++;
        if (corners > scene->limits.vertices) scene->limits.vertices = corners;
    }
    return records ? run : LIM_NO_INDEX;
}

/* Planes ------------------------------------------------------------------------------------- */

static int64_t offset_through(const int64_t n[3], const struct lim_vertex *v)
{
    return n[0] * v->x + n[1] * v->y + n[2] * v->z;
}

static struct lim_plane large_plane(struct fuzz_scene *made, struct fuzz_bytes *bytes, const struct lim_vertex *through)
{
    struct lim_plane_exact *exact = &made->exact[made->scene.exact_count];
    int64_t n[3];

    for (int i = 0; i < 3; i++) {
        n[i] = (int32_t)fuzz_u32(bytes);
        if (n[i] == INT32_MIN) n[i] = INT32_MAX;
    }
    if (!n[0] && !n[1] && !n[2]) n[1] = 1;
    const int64_t d = offset_through(n, through);
    for (int i = 0; i < 3; i++)
        exact->n[i] = (int32_t)n[i];
    exact->d_lo = (uint32_t)d;
    exact->d_hi = (int32_t)((d - exact->d_lo) / (INT64_C(1) << 32));
    return plane_filter(n, d, made->scene.exact_count++);
}

static struct lim_plane small_plane(struct fuzz_bytes *bytes, const struct lim_vertex *through, bool is_upright)
{
    int64_t n[3];

    for (int i = 0; i < 3; i++)
        n[i] = is_upright && i == 1 ? 0 : (int16_t)fuzz_u16(bytes);
    while (llabs(n[0]) + llabs(n[1]) + llabs(n[2]) > 32767)
        for (int i = 0; i < 3; i++)
            n[i] /= 2;
    if (!n[0] && !n[1] && !n[2]) n[2] = 1;
    return plane_record(n, offset_through(n, through));
}

static void make_plane(struct fuzz_scene *made, struct lim_node *node, struct fuzz_bytes *bytes)
{
    const struct lim_vertex *through = &made->vertices[fuzz_below(bytes, made->scene.vertex_count)];

    const uint8_t kind = fuzz_below(bytes, PLANE_KINDS);
    if (kind <= PLANE_Z) {
        const int16_t at[3] = {through->x, through->y, through->z};
        node->split.plane = (lim_index)(LIM_PLANE_X + kind);
        node->split.offset = at[kind];
        return;
    }
    node->split.plane = (lim_index)(made->scene.plane_count * LIM_PLANE_WORDS);
    made->planes[made->scene.plane_count++] =
        kind == PLANE_LARGE ? large_plane(made, bytes, through) : small_plane(bytes, through, kind == PLANE_XZ);
}

/* The tree ----------------------------------------------------------------------------------- */

/* Hangs a node under an earlier one that has a place free; there always is one. */
static lim_index hang(struct lim_node *nodes, lim_index index, struct fuzz_bytes *bytes)
{
    lim_index parent = fuzz_below(bytes, index);

    while (nodes[parent].front != LIM_NO_INDEX && nodes[parent].back != LIM_NO_INDEX)
        parent = (lim_index)((parent + 1) % index);
    const bool in_front =
        nodes[parent].front == LIM_NO_INDEX && (nodes[parent].back != LIM_NO_INDEX || fuzz_below(bytes, 2));
    *(in_front ? &nodes[parent].front : &nodes[parent].back) = index;
    return parent;
}

/* Hangs a node behind the one before it. */
static lim_index chain(struct lim_node *nodes, lim_index index)
{
    nodes[index - 1].back = index;
    return (lim_index)(index - 1);
}

static void make_nodes(struct fuzz_scene *made, struct fuzz_bytes *bytes, bool is_chain)
{
    uint16_t depths[FUZZ_NODES_MAX] = {1};

    made->scene.node_count = (uint16_t)(1 + fuzz_below(bytes, FUZZ_NODES_MAX));
    for (uint16_t i = 0; i < made->scene.node_count; i++) {
        struct lim_node *node = &made->nodes[i];
        if (i) depths[i] = (uint16_t)(depths[is_chain ? chain(made->nodes, i) : hang(made->nodes, i, bytes)] + 1);
        if (depths[i] > made->scene.limits.depth) made->scene.limits.depth = depths[i];
        node->front = node->back = node->box = LIM_NO_INDEX;
        make_plane(made, node, bytes);
        node->front_run = make_run(made, bytes);
        node->back_run = make_run(made, bytes);
    }
}

/* Leaves ------------------------------------------------------------------------------------- */

/* A copy of a run to the end of made->polygons, its records with a plane of their own, if `plane` is not NULL. */
static lim_index copy_run(struct fuzz_scene *made, const lim_index *from, const struct lim_plane_ref *plane,
                          lim_index flags)
{
    const lim_index run = made->scene.polygon_words;

    for (bool last = false; !last; from += LIM_POLYGON_HEAD_WORDS + (from[0] & LIM_POLYGON_COUNT)) {
        const size_t words = LIM_POLYGON_HEAD_WORDS + (from[0] & LIM_POLYGON_COUNT);
        lim_index *to = &made->polygons[made->scene.polygon_words];
        last = from[0] & LIM_POLYGON_LAST;
        memcpy(to, from, words * sizeof *to);
        made->scene.polygon_words = (lim_index)(made->scene.polygon_words + words);
        if (!plane) continue;
        to[0] |= flags;
        to[words] = plane->plane;
        to[words + 1] = (lim_index)plane->offset;
        made->scene.polygon_words = (lim_index)(made->scene.polygon_words + FUZZ_PLANE_WORDS);
    }
    return run;
}

/* Both runs in one, which faces both ways. */
static void make_leaf(struct fuzz_scene *made, struct lim_node *node, const lim_index *polygons)
{
    const struct lim_plane_ref plane = node->split;
    const lim_index front = node->front_run, back = node->back_run;

    node->split = (struct lim_plane_ref){LIM_NO_INDEX, 0};
    node->back_run = LIM_NO_INDEX;
    if (front != LIM_NO_INDEX) {
        node->front_run = copy_run(made, polygons + front, &plane, LIM_POLYGON_PLANE);
        if (back == LIM_NO_INDEX) return;
        lim_index *last = &made->polygons[node->front_run];
        while (!(*last & LIM_POLYGON_LAST))
            last += lim_record_words(*last);
        *last &= (lim_index)~LIM_POLYGON_LAST;
    }
    const lim_index second = copy_run(made, polygons + back, &plane, LIM_POLYGON_PLANE | LIM_POLYGON_BACK);
    if (front == LIM_NO_INDEX) node->front_run = second;
}

/* Childless nodes with polygons become leaves as the bits say. These come last of all, so older inputs still mean what
 * they meant. */
static void make_leaves(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    const uint16_t wanted = fuzz_u16(bytes);
    lim_index polygons[FUZZ_WORDS_MAX];

    if (!wanted) return;
    memcpy(polygons, made->polygons, sizeof polygons);
    made->scene.polygon_words = 0;
    for (uint16_t i = 0; i < made->scene.node_count; i++) {
        struct lim_node *node = &made->nodes[i];
        const bool childless = node->front == LIM_NO_INDEX && node->back == LIM_NO_INDEX;
        if (childless && (wanted >> i & 1) && (node->front_run != LIM_NO_INDEX || node->back_run != LIM_NO_INDEX)) {
            make_leaf(made, node, polygons);
            continue;
        }
        if (node->front_run != LIM_NO_INDEX) node->front_run = copy_run(made, polygons + node->front_run, NULL, 0);
        if (node->back_run != LIM_NO_INDEX) node->back_run = copy_run(made, polygons + node->back_run, NULL, 0);
    }
}

/* Many scales -------------------------------------------------------------------------------- */

/* Boxes have room for fractions. */
#define FUZZ_LONG_END (LIM_LONG_END - 2)

/* Most of any size about as likely, and the ends of the grid. */
static int32_t long_coordinate(struct fuzz_bytes *bytes)
{
    const int32_t value = (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);

    return value < -FUZZ_LONG_END ? -FUZZ_LONG_END : value > FUZZ_LONG_END ? FUZZ_LONG_END : value;
}

/* A coordinate of another vertex, or nearly, or any: so faces lie on axis planes, and through one another. */
static void make_long_vertices(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    for (lim_index i = 0; i < made->scene.vertex_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            const uint8_t kind = fuzz_below(bytes, 3);
            int32_t at = i && kind ? made->long_vertices[fuzz_below(bytes, i)].at[axis] : long_coordinate(bytes);
            if (kind == 2) at += (int8_t)fuzz_u8(bytes);
            if (at < -FUZZ_LONG_END || at > FUZZ_LONG_END) at = 0;
            made->long_vertices[i].at[axis] = at;
        }
}

static void make_long_plane(struct fuzz_scene *made, struct lim_node *node, struct fuzz_bytes *bytes)
{
    const lim_index vertex = fuzz_below(bytes, made->scene.vertex_count);
    struct lim_long_plane *plane = &made->long_planes[made->scene.plane_count];

    if (node->split.plane >= LIM_PLANE_X) {
        node->split.offset = (int32_t)vertex;
        return;
    }
    node->split = (struct lim_plane_ref){made->scene.plane_count++, 0};
    for (int i = 0; i < 3; i++)
        plane->n[i] = (int32_t)fuzz_u32(bytes) / 2;
    if (!plane->n[0] && !plane->n[1] && !plane->n[2]) plane->n[2] = 1;
    plane->rest = (int32_t)fuzz_u32(bytes);
    plane->vertex = vertex;
}

/* In place of vertices and planes that are made already. */
static void make_wide(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    made->all = (struct lim_long){.vertices = made->long_vertices,
                                  .planes = made->long_planes,
                                  .boxes = made->long_boxes,
                                  .fractions = made->scene.fractions};
    *made->scene.of_32_bits = &made->all;
    made->scene.plane_count = made->scene.exact_count = 0;
    make_long_vertices(made, bytes);
    for (lim_index i = 0; i < made->scene.node_count; i++)
        make_long_plane(made, &made->nodes[i], bytes);
}

/* Boxes -------------------------------------------------------------------------------------- */

/* As the compiler makes them; some nodes have none. */
static void make_boxes(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    struct bounds bounds[FUZZ_NODES_MAX];

    bounds_of_subtrees(&made->scene, bounds);
    for (lim_index i = made->scene.node_count; i-- > 0;) {
        if (!bounds[i].polygons || fuzz_below(bytes, 2)) continue;
        made->nodes[i].box = made->scene.box_count;
        if (lim_scene_long(&made->scene))
            made->long_boxes[made->scene.box_count++] = bounds_long_box(&bounds[i]);
        else
            made->boxes[made->scene.box_count++] = bounds_box(&bounds[i]);
    }
}

static void make_bare(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    memset(made, 0, sizeof *made);
    made->scene.vertices = made->vertices;
    made->scene.nodes = made->nodes;
    made->scene.planes = made->planes;
    made->scene.exact = made->exact;
    made->scene.boxes = made->boxes;
    made->scene.polygons = made->polygons;
    made->scene.limits.vertices = 3;
    made->scene.background = fuzz_u8(bytes);
    make_vertices(made, bytes);
}

static void make(struct fuzz_scene *made, struct fuzz_bytes *bytes, bool is_chain, bool is_long)
{
    make_bare(made, bytes);
    make_nodes(made, bytes, is_chain);
    if (is_long) make_wide(made, bytes);
    make_boxes(made, bytes);
    made->scene.limits.retained_cells = fuzz_u8(bytes);
    made->scene.limits.gaps = fuzz_u8(bytes);
    made->scene.limits.active = fuzz_u8(bytes);
    if (!is_chain) make_leaves(made, bytes);
}

void fuzz_scene_make(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    make(made, bytes, false, false);
}

void fuzz_scene_make_chain(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    make(made, bytes, true, false);
}

void fuzz_scene_make_long(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    make(made, bytes, false, true);
}

/* Three vertices of which no two are the same. */
static void make_triangle(lim_index *words, lim_index vertex_count, struct fuzz_bytes *bytes)
{
    words[0] = fuzz_below(bytes, vertex_count);
    words[1] = (lim_index)((words[0] + 1 + fuzz_below(bytes, vertex_count - 1u)) % vertex_count);
    words[2] = fuzz_below(bytes, vertex_count);
    while (words[2] == words[0] || words[2] == words[1])
        words[2] = (lim_index)((words[2] + 1) % vertex_count);
    words[3] = fuzz_u8(bytes);
}

void fuzz_scene_make_mesh(struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    make_bare(made, bytes);
    made->scene.polygon_count = 1 + fuzz_below(bytes, FUZZ_TRIANGLES_MAX);
    made->scene.polygon_words = (lim_index)(made->scene.polygon_count * LIM_TRIANGLE_WORDS);
    for (lim_index i = 0; i < made->scene.polygon_count; i++)
        make_triangle(&made->polygons[i * LIM_TRIANGLE_WORDS], made->scene.vertex_count, bytes);
    const struct bounds bounds = bounds_of_mesh(&made->scene);
    made->boxes[made->scene.box_count++] = bounds_box(&bounds);
    made->scene.limits.active = fuzz_u8(bytes);
    *made->scene.deep_from = fuzz_below(bytes, made->scene.polygon_count + 1u);
    *made->scene.near_deep_from = fuzz_below(bytes, *made->scene.deep_from + 1u);
}
